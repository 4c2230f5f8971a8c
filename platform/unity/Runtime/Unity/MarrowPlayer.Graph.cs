using System;
using UnityEngine;
using UnityEngine.Events;

namespace MarrowAnimation {

public sealed partial class MarrowPlayer {
    [SerializeField, Tooltip("Move this object as the clips of its graph do")] bool applyRootMotion = false;
    [SerializeField, Tooltip("Events of the graph's clips: name, number, seconds in the clip")]
    UnityEvent<string, float, float> onMotionEvent = new UnityEvent<string, float, float>();

    MarrowAnimator animator;
    bool hasBegun;  // it was updated

    /// <summary>Events of the graph's clips, once each, when the object is moved and posed.</summary>
    public event Action<MarrowPlayer, MarrowMotionEvent> MotionEvent;

    /// <summary>Whether the object is moved as the clips of its graph do.</summary>
    public bool ApplyRootMotion {
        get { return applyRootMotion; }
        set { applyRootMotion = value; }
    }

    /// <summary>What plays the graph; null while a clip plays, or nothing. Snapshots and states are its own.</summary>
    public MarrowAnimator Animator { get { return animator; } }

    /// <summary>The graph that is played, or null.</summary>
    public MarrowGraph Graph { get { return animator == null ? null : animator.Graph; } }

    /// <summary>How far the graph's clips moved the object in the last frame, in its own axes.</summary>
    public Vector3 DeltaPosition { get; private set; }

    /// <summary>Likewise how they turned it.</summary>
    public Quaternion DeltaRotation { get; private set; } = new Quaternion(0, 0, 0, 1);

    /// <summary>Plays a graph of the file from its beginning, by its name, or of none the first.</summary>
    public void PlayGraph(string graph = "") {
        if (file == null) throw new InvalidOperationException(name + ": nothing is open to play a graph with");
        PlayGraph(file.Graph(graph));
    }

    /// <summary>Plays a graph from its beginning, one of the file's Graph() or GraphOf().</summary>
    public void PlayGraph(MarrowGraph graph) {
        if (file == null) throw new InvalidOperationException(name + ": nothing is open to play a graph with");
        if (graph == null) throw new ArgumentNullException("graph");
        if (graph.Poses > character.LayerCount) Open(file, graph);
        else Begin(graph);
    }

    void Begin(MarrowGraph graph) {
        MarrowAnimatorOptions options = new MarrowAnimatorOptions();
        options.Space = MarrowSpace.Unity;
        MarrowAnimator next = new MarrowAnimator(graph, options);
        LeaveGraph();
        animator = next;
        now = before = null;
        hasBegun = !Application.isPlaying;
        if (hasBegun) animator.Update(0);  // what it begins with is seen in the Editor
        if (graph.IsOwn) return;
        foreach (MarrowSkin skin in skins)
            if (skin != null) skin.NeverCull();  // the file's boxes know nothing of a pack's clips
    }

    void LeaveGraph() {
        if (animator != null) animator.Dispose();
        animator = null;
        hasBegun = false;
        DeltaPosition = new Vector3();
        DeltaRotation = new Quaternion(0, 0, 0, 1);
    }

    MarrowAnimator Playing(string what) {
        if (animator != null) return animator;
        throw new InvalidOperationException(name + ": no graph is played, in which to " + what +
                                            ": cook the file with --graph, or call PlayGraph()");
    }

    /// <summary>A parameter of the graph by its name: look it up once, not a frame.</summary>
    public int Parameter(string parameter) {
        return Playing("find \"" + parameter + "\"").Graph.Parameter(parameter);
    }

    public void SetNumber(int parameter, float value) { Playing("set a number").SetNumber(parameter, value); }
    public void SetFlag(int parameter, bool value) { Playing("set a flag").SetFlag(parameter, value); }
    public void Fire(int parameter) { Playing("fire").Fire(parameter); }
    public void SetNumber(string parameter, float value) { Playing("set a number").SetNumber(parameter, value); }
    public void SetFlag(string parameter, bool value) { Playing("set a flag").SetFlag(parameter, value); }
    public void Fire(string parameter) { Playing("fire").Fire(parameter); }

    /// <summary>The name of the state that a machine of the graph is in; null if nothing of it is shown.</summary>
    public string StateOf(string machine) { return Playing("ask for a state").StateOf(machine); }

    void Behave(float seconds) {
        MarrowAnimator playing = animator;
        playing.Update(Math.Max(seconds * speed, 0));
        hasBegun = true;
        MarrowTransform step = playing.Step;
        DeltaPosition = new Vector3(step.Px, step.Py, step.Pz);
        DeltaRotation = new Quaternion(step.Rx, step.Ry, step.Rz, step.Rw);
        if (applyRootMotion) {
            transform.localPosition += transform.localRotation * Vector3.Scale(transform.localScale, DeltaPosition);
            transform.localRotation = (transform.localRotation * DeltaRotation).normalized;
        }
        Show();
        for (int i = 0; animator == playing && i < playing.EventCount; ++i) {  // who hears one may end the graph
            MarrowMotionEvent met = playing.Event(i);
            if (MotionEvent != null) MotionEvent(this, met);
            onMotionEvent.Invoke(met.Name, met.Number, met.Time);
        }
    }
}

}
