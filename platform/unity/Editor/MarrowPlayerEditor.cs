using UnityEditor;
using UnityEngine;

namespace MarrowAnimation.Editor {

/// <summary>
/// A player's inspector: its fields, and while it plays a graph the graph's parameters to be set by hand, and what its
/// machines are in.
/// </summary>
[CustomEditor(typeof(MarrowPlayer))]
public sealed class MarrowPlayerEditor : UnityEditor.Editor {
    const float WidestSlider = 1000;

    public override bool RequiresConstantRepaint() { return Application.isPlaying; }

    public override void OnInspectorGUI() {
        DrawDefaultInspector();
        MarrowPlayer player = (MarrowPlayer)target;
        if (!Application.isPlaying || player.Animator == null) return;
        EditorGUILayout.LabelField("Graph", player.Graph.Name);
        for (int i = 0; i < player.Graph.ParameterCount; ++i) Set(player.Animator, i, player.Graph.ParameterAt(i));
        for (int i = 0; i < player.Graph.MachineCount; ++i) {
            float seconds;
            string state = player.Animator.StateOf(i, out seconds);
            string shown = state == null ? "not shown" : state + ", " + seconds.ToString("0.0") + " s";
            EditorGUILayout.LabelField(player.Graph.MachineName(i), shown);
        }
    }

    // What is not touched is left to the game.
    static void Set(MarrowAnimator animator, int index, MarrowParameter parameter) {
        if (parameter.Kind == MarrowParameterKind.Trigger) {
            if (GUILayout.Button(parameter.Name)) animator.Fire(index);
            return;
        }
        float last = animator.Value(index);
        if (parameter.Kind == MarrowParameterKind.Flag) {
            bool flag = EditorGUILayout.Toggle(parameter.Name, last != 0);
            if (flag != (last != 0)) animator.SetFlag(index, flag);
            return;
        }
        bool fits = parameter.Most - parameter.Least <= WidestSlider;
        float number = fits ? EditorGUILayout.Slider(parameter.Name, last, parameter.Least, parameter.Most)
                            : EditorGUILayout.FloatField(parameter.Name, last);
        if (number != last) animator.SetNumber(index, number);
    }
}

}
