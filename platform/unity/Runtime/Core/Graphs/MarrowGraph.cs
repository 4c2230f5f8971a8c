using System;
using System.Collections.Generic;
using MarrowRuntime;

namespace MarrowAnimation {

/// <summary>What a parameter of a graph is.</summary>
public enum MarrowParameterKind {
    Number = (int)ParameterKind.Number,
    Flag = (int)ParameterKind.Flag,
    /// <summary>Set until a transition takes it, or its time is over.</summary>
    Trigger = (int)ParameterKind.Trigger,
}

/// <summary>What a game sets.</summary>
public struct MarrowParameter {
    public string Name;
    public MarrowParameterKind Kind;
    /// <summary>Of a flag 0 or 1.</summary>
    public float Initial;
    /// <summary>Of a number, which is clamped to them.</summary>
    public float Least, Most;
}

/// <summary>
/// A graph of behaviour, which `marrow cook --graph` put into a file, for the characters of a file: its clips are
/// found. Any number of animators play it. MarrowFile.Graph() has those of a file.
/// </summary>
public sealed unsafe class MarrowGraph : IDisposable {
    readonly MarrowFile file, source;
    readonly MarrowClips[] clips;
    readonly bool isOwn;  // goes with its file
    readonly string[] clipNames, machines;
    readonly int[] machineNodes;
    readonly string[][] states;
    readonly MarrowParameter[] parameters;
    readonly Dictionary<uint, string> events = new Dictionary<uint, string>();
    NativeBlock memory;  // the binding, and what it points into

    public string Name { get; private set; }

    internal MarrowGraph(MarrowFile file, MarrowFile source, uint index, MarrowClips[] clips, bool isOwn) {
        this.file = file;
        this.source = source;
        this.clips = clips;
        this.isOwn = isOwn;
        MarrowRuntime.Graph graph;
        DataError error = DataError.New();
        error.status = Marrow.FileGraph(source.Native, index, &graph, &error);
        if (error.status != Status.Ok) throw MarrowException.Of(source.Name, error);
        Name = Marrow.Text(graph.name);
        Bind(&graph);
        parameters = new MarrowParameter[(int)graph.parameter_count];
        for (int i = 0; i < parameters.Length; ++i) parameters[i] = ParameterOf(graph.parameters[i]);
        clipNames = new string[(int)Native->clip_count];
        for (int i = 0; i < clipNames.Length; ++i) NameClip(i);
        machineNodes = new int[(int)graph.machine_count];
        machines = new string[machineNodes.Length];
        states = new string[machineNodes.Length][];
        for (int n = 0; n < (int)graph.node_count; ++n)
            if (graph.nodes[n].kind == GraphNodeKind.Machine) NameMachine(&graph, n);
        if (isOwn) return;
        file.Keep();
        source.Keep();
    }

    void Bind(MarrowRuntime.Graph* graph) {
        ulong bytes = (ulong)Marrow.GraphBindingBytes(graph, file.Native);
        ulong head = NativeBlock.Rounded(sizeof(GraphBinding));
        Animations* animations = stackalloc Animations[clips.Length];
        for (int i = 0; i < clips.Length; ++i) animations[i] = clips[i].NativeFor(file);
        GraphMisfit misfit = default(GraphMisfit);
        memory = new NativeBlock(head + bytes);
        Status status = Marrow.BindGraph(source.Native, graph, file.Native, animations, new UIntPtr((uint)clips.Length),
                                         memory.First + head, new UIntPtr(bytes), (GraphBinding*)memory.First, &misfit);
        if (status == Status.Ok) return;
        string wanted = Marrow.Text(Marrow.StatusText(status));
        if (misfit.rule != null) wanted = Marrow.Text(misfit.rule) + ", \"" + Marrow.Text(misfit.name) + "\"";
        memory.Dispose();
        throw new MarrowException(source.Name + ": the graph \"" + Name + "\" does not fit " + file.Name +
            ": it wants " + wanted + ": give it the clips that it was cooked for; MarrowFile.GraphOf() takes a pack's",
                                  status);
    }

    string TextOf(uint name) { return Marrow.Text(Marrow.FileText(source.Native, name)); }

    MarrowParameter ParameterOf(GraphParameter from) {
        return new MarrowParameter {
            Name = TextOf(from.name), Kind = (MarrowParameterKind)from.kind, Initial = from.initial, Least = from.least,
            Most = from.most
        };
    }

    void NameClip(int index) {
        MarrowRuntime.Animation* clip = Native->clips + index;
        clipNames[index] = Marrow.Text(clip->name);
        for (int i = 0; i < (int)clip->motion.event_count; ++i) {
            byte* name = Marrow.FileText(&clip->clips, clip->motion.events[i].name);
            events[Marrow.EventId(name)] = Marrow.Text(name);
        }
    }

    void NameMachine(MarrowRuntime.Graph* graph, int node) {
        uint index = graph->nodes[node].record;
        GraphMachine machine = graph->machines[index];
        machines[index] = TextOf(graph->nodes[node].name);
        machineNodes[index] = node;
        states[index] = new string[machine.state_count];
        for (uint s = 0; s < machine.state_count; ++s)
            states[index][s] = TextOf(graph->states[machine.first_state + s].name);
    }

    /// <summary>For calls of MarrowRuntime.Marrow; as long as neither it nor its clips are disposed of.</summary>
    public GraphBinding* Native {
        get {
            MustBeOpen();
            return (GraphBinding*)memory.First;
        }
    }

    internal void MustBeOpen() {
        if (memory == null) throw new ObjectDisposedException(Name);
        foreach (MarrowClips each in clips) each.MustBeOpen();
    }

    /// <summary>Whether it is of MarrowFile.Graph(): with the file's clips alone, and as long as the file.</summary>
    public bool IsOwn { get { return isOwn; } }

    /// <summary>Poses that a character holds to be posed by it: MarrowCharacterOptions.Layers, at least.</summary>
    public int Poses { get { return Native->graph.nodes[0].poses; } }

    public int ParameterCount { get { return parameters.Length; } }
    public MarrowParameter ParameterAt(int index) { return parameters[index]; }

    /// <summary>
    /// The parameter of a name, for MarrowAnimator.SetNumber() and the like, or an exception that lists those that
    /// there are. Look parameters up once, not a frame.
    /// </summary>
    public int Parameter(string name) {
        int found = Array.FindIndex(parameters, p => p.Name == name);
        if (found >= 0) return found;
        throw Missing("parameter", name, Array.ConvertAll(parameters, p => p.Name));
    }

    public int MachineCount { get { return machines.Length; } }
    public string MachineName(int machine) { return machines[machine]; }

    /// <summary>
    /// The machine of a name, for MarrowAnimator.StateOf(), or an exception that lists those that there are.
    /// </summary>
    public int Machine(string name) {
        int found = Array.IndexOf(machines, name);
        if (found >= 0) return found;
        throw Missing("machine", name, machines);
    }

    internal uint NodeOf(int machine) { return (uint)machineNodes[machine]; }
    internal string StateName(int machine, uint state) { return states[machine][state]; }

    MarrowException Missing(string what, string name, string[] there) {
        return new MarrowException(source.Name + ": the graph \"" + Name + "\" has no " + what + " \"" + name + "\": " +
            (there.Length == 0 ? "it has none" : "it has " + string.Join(", ", there)));
    }

    internal MarrowMotionEvent EventOf(AnimatorEvent* from) {
        MarrowMotionEvent made;
        made.Id = from->id;
        made.Name = events[from->id];
        made.Clip = clipNames[from->animation - Native->clips];
        made.Number = from->number;
        made.Time = from->time_s;
        made.Until = from->until_s;
        made.Count = (int)from->count;
        return made;
    }

    internal string Source { get { return source.Name; } }
    internal MarrowFile File { get { return file; } }

    /// <summary>After this it cannot be played. Those of MarrowFile.Graph() go with their file.</summary>
    public void Dispose() {
        if (memory == null) return;
        memory.Dispose();
        memory = null;
        if (isOwn) return;
        file.LetGo();
        source.LetGo();
    }
}

}
