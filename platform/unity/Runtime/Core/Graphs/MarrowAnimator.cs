using System;
using MarrowRuntime;

namespace MarrowAnimation {

/// <summary>What an animator is made with. What is left at its default is the runtime's.</summary>
public struct MarrowAnimatorOptions {
    /// <summary>For a server, which does not pose: less memory. What is posed yet has no inertial fades.</summary>
    public bool UpdatesAlone;
    /// <summary>Of one update, at most; 0 counts as 32.</summary>
    public int Events;
    /// <summary>Of what happens by chance; 0 counts as 1.</summary>
    public uint Seed;
    /// <summary>Of clips that are shown less than that, 0 … 1, events are left out; null counts as 0.1.</summary>
    public float? LeastLoudness;
    /// <summary>Of Step.</summary>
    public MarrowSpace Space;
}

/// <summary>An event of a clip that an update met.</summary>
public struct MarrowMotionEvent {
    public string Name;
    /// <summary>Of the name, as MarrowAnimator.EventId() has it.</summary>
    public uint Id;
    /// <summary>Whose event it is.</summary>
    public string Clip;
    /// <summary>What the event was given.</summary>
    public float Number;
    /// <summary>From when until when in the clip, seconds.</summary>
    public float Time, Until;
    /// <summary>How often the update met it.</summary>
    public int Count;
}

/// <summary>
/// A character's behaviour: plays a graph. A frame is SetNumber() and the like, Update(), MarrowCharacter.Pose().
/// Nothing of that allocates. One thread at a time; different animators on different threads.
/// </summary>
public sealed unsafe class MarrowAnimator : IDisposable {
    readonly MarrowGraph graph;
    readonly MarrowSpace space;
    NativeBlock memory;  // the animator, its step, what it points into

    public MarrowAnimator(MarrowGraph graph, MarrowAnimatorOptions options = default(MarrowAnimatorOptions)) {
        if (graph == null) throw new ArgumentNullException("graph");
        this.graph = graph;
        space = options.Space;
        AnimatorOptions wanted = AnimatorOptions.New();
        wanted.poses = (byte)(options.UpdatesAlone ? 0 : 1);
        if (options.Events > 0) wanted.events = (uint)options.Events;
        if (options.Seed != 0) wanted.seed = options.Seed;
        if (options.LeastLoudness.HasValue) wanted.least_loudness = options.LeastLoudness.Value;
        ulong bytes = (ulong)Marrow.AnimatorBytes(graph.Native, &wanted);
        ulong head = NativeBlock.Rounded(sizeof(Animator)) + NativeBlock.Rounded(sizeof(AnimatorStep));
        memory = new NativeBlock(head + bytes);
        graph.File.Keep();
        *Last = AnimatorStep.New();
        Status status = Marrow.MakeAnimator(graph.Native, &wanted, memory.First + head, new UIntPtr(bytes),
                                            (Animator*)memory.First);
        if (status != Status.Ok) Dispose();
        MarrowException.Must(status, graph.Source);
    }

    /// <summary>For calls of MarrowRuntime.Marrow. Its numbers are as cooked, in glTF's axes.</summary>
    public Animator* Native {
        get {
            if (memory == null) throw new ObjectDisposedException(graph.Name);
            graph.MustBeOpen();
            return (Animator*)memory.First;
        }
    }

    AnimatorStep* Last { get { return (AnimatorStep*)((byte*)Native + NativeBlock.Rounded(sizeof(Animator))); } }

    public MarrowGraph Graph { get { return graph; } }

    /// <summary>parameter: as MarrowGraph.Parameter() says. The value is clamped to the number's range.</summary>
    public void SetNumber(int parameter, float value) {
        MustSet(Marrow.SetNumber(Native, (uint)parameter, value), parameter, "number, and takes what is one");
    }

    public void SetFlag(int parameter, bool value) {
        MustSet(Marrow.SetFlag(Native, (uint)parameter, (byte)(value ? 1 : 0)), parameter, "flag");
    }

    /// <summary>Sets a trigger, until a transition takes it or its time is over.</summary>
    public void Fire(int parameter) { MustSet(Marrow.FireTrigger(Native, (uint)parameter), parameter, "trigger"); }

    public void SetNumber(string parameter, float value) { SetNumber(graph.Parameter(parameter), value); }
    public void SetFlag(string parameter, bool value) { SetFlag(graph.Parameter(parameter), value); }
    public void Fire(string parameter) { Fire(graph.Parameter(parameter)); }

    /// <summary>What a parameter is set to: a flag to 0 or 1, a trigger to 1 while it waits.</summary>
    public float Value(int parameter) { return Marrow.ValueOf(Native, (uint)parameter); }

    void MustSet(Status status, int parameter, string kind) {
        if (status == Status.Ok) return;
        bool isThere = parameter >= 0 && parameter < graph.ParameterCount;
        throw new MarrowException(graph.Source + ": in the graph \"" + graph.Name + "\" " +
            (isThere ? "\"" + graph.ParameterAt(parameter).Name + "\" is set as what it is not: this is for a " + kind
                     : "there is no parameter " + parameter + ": ask MarrowGraph.Parameter() for it"), status);
    }

    /// <summary>Moves on by seconds ≥ 0.</summary>
    public void Update(float seconds) {
        Status status = Marrow.UpdateAnimator(Native, seconds, Last);
        if (status == Status.Ok) return;
        *Last = AnimatorStep.New();
        throw new MarrowException(graph.Source + ": the graph \"" + graph.Name + "\" cannot go on by " + seconds +
            " s: give a number that is not below 0", status);
    }

    /// <summary>
    /// How the last update moved the character, in the axes that the character had before it: its root motion. Scale
    /// is 1.
    /// </summary>
    public MarrowTransform Step {
        get {
            RigidStep root = Last->root;
            MarrowTransform made = default(MarrowTransform);
            made.Px = root.translation[0];
            made.Py = root.translation[1];
            made.Pz = root.translation[2];
            made.Rx = root.rotation[0];
            made.Ry = root.rotation[1];
            made.Rz = root.rotation[2];
            made.Rw = root.rotation[3];
            made.Sx = made.Sy = made.Sz = 1;
            return space == MarrowSpace.Unity ? MarrowMirror.Mirrored(made) : made;
        }
    }

    /// <summary>Events that the last update met.</summary>
    public int EventCount { get { return (int)Last->event_count; } }

    /// <summary>Those for which there was no room: see MarrowAnimatorOptions.Events.</summary>
    public int EventsLeftOut { get { return (int)Last->events_left_out; } }

    public MarrowMotionEvent Event(int index) {
        if (index < 0 || index >= EventCount) throw new ArgumentOutOfRangeException("index");
        return graph.EventOf(Last->events + index);
    }

    /// <summary>The number of an event's name: compare it, not the name, where there are many.</summary>
    public static uint EventId(string name) {
        uint id = 2166136261;
        foreach (byte each in System.Text.Encoding.UTF8.GetBytes(name)) id = unchecked((id ^ each) * 16777619);
        return id;
    }

    /// <summary>The name of the state that a machine is in, or null if nothing of the machine is shown.</summary>
    public string StateOf(int machine) {
        float seconds;
        return StateOf(machine, out seconds);
    }

    public string StateOf(string machine) { return StateOf(graph.Machine(machine)); }

    /// <summary>seconds: for how long.</summary>
    public string StateOf(int machine, out float seconds) {
        float lasted = 0;
        uint state = Marrow.StateOf(Native, graph.NodeOf(machine), &lasted);
        seconds = state == Marrow.NoIndex ? 0 : lasted;
        return state == Marrow.NoIndex ? null : graph.StateName(machine, state);
    }

    /// <summary>Bytes of a snapshot; the same for all animators of the graph.</summary>
    public int StateBytes { get { return (int)Native->state_bytes; } }

    /// <summary>
    /// What it is in: plain bytes, the same on every machine. Where the character stands is not among them.
    /// </summary>
    public byte[] Save() {
        byte[] made = new byte[StateBytes];
        Save(made);
        return made;
    }

    /// <summary>The same into an array of StateBytes or more.</summary>
    public void Save(byte[] to) {
        int bytes = StateBytes;
        if (to == null || to.Length < bytes)
            throw new MarrowException(graph.Source + ": there is no room for the " + bytes + " bytes of a snapshot");
        fixed (byte* first = to) Buffer.MemoryCopy(Native->state, first, to.Length, bytes);
    }

    /// <summary>
    /// Takes back what Save() gave, of this animator or of another of the graph. Bytes of another graph and damaged
    /// ones throw a MarrowException, and nothing changes. What is shown follows with the next pose.
    /// </summary>
    public void Restore(byte[] snapshot) {
        if (snapshot == null) throw new ArgumentNullException("snapshot");
        Status status;
        fixed (byte* first = snapshot)
            status = Marrow.RestoreAnimator(Native, first, new UIntPtr((uint)snapshot.Length));
        if (status == Status.Ok) return;
        throw new MarrowException(graph.Source + ": these bytes are no snapshot of the graph \"" + graph.Name +
            "\", or are damaged: give what Save() gave", status);
    }

    public void Dispose() {
        if (memory == null) return;
        memory.Dispose();
        memory = null;
        graph.File.LetGo();
    }
}

}
