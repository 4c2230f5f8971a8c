// Of UnityEditor what an inspector uses, written by hand from Unity's manual. A test says what a person does to a
// control; what was shown is kept.
using System;
using System.Collections.Generic;

namespace UnityEngine {

public static class GUILayout {
    public static bool Button(string text) { return UnityEditor.Hand.On(text, "button", false); }
}

}

namespace UnityEditor {

public static class Hand {
    // By a control's label: what it is set to.
    public static readonly Dictionary<string, object> Sets = new Dictionary<string, object>();
    public static readonly List<string> Shown = new List<string>();
    internal static T On<T>(string label, string kind, T value) {
        object set;
        Shown.Add(kind + " " + label + " " + value);
        return Sets.TryGetValue(label, out set) ? (T)set : value;
    }
}

public sealed class CustomEditor : Attribute { public CustomEditor(Type of) {} }

public class Editor : UnityEngine.Object {
    public UnityEngine.Object target { get; set; }
    public bool DrawDefaultInspector() { return false; }
    public virtual void OnInspectorGUI() {}
    public virtual bool RequiresConstantRepaint() { return false; }
}

public static class EditorGUILayout {
    public static void LabelField(string label, string text) { Hand.On(label, "label", text); }
    public static bool Toggle(string label, bool value) { return Hand.On(label, "toggle", value); }
    public static float FloatField(string label, float value) { return Hand.On(label, "field", value); }
    public static float Slider(string label, float value, float least, float most) {
        return Hand.On(label, "slider " + least + " " + most, value);
    }
}

}
