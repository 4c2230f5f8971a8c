using System;
using System.IO;
using System.Threading;
using MarrowRuntime;

namespace MarrowAnimation {

/// <summary>
/// A cooked file, checked and unpacked. Any number of characters share one. It may be disposed of before them: it
/// closes, and its memory goes, when the last of them has gone, too.
/// </summary>
public sealed unsafe class MarrowFile : IDisposable {
    NativeBlock block;  // the file's bytes
    NativeBlock handle;  // what the runtime knows of them
    MarrowClips clips;
    MarrowGraph[] graphs;
    int users = 1;
    bool disposed;

    /// <summary>What errors call it.</summary>
    public string Name { get; private set; }

    MarrowFile(string name) { Name = name; }

    /// <summary>Reads a file of the disk. On Android StreamingAssets lie in an archive: see FromBytes().</summary>
    public static MarrowFile Load(string path) {
        byte[] bytes;
        try {
            bytes = System.IO.File.ReadAllBytes(path);
        } catch (Exception problem) when (problem is IOException || problem is UnauthorizedAccessException) {
            throw new MarrowException(path + ": cannot be read: " + problem.Message, Status.Ok, problem);
        }
        return FromBytes(bytes, path);
    }

    /// <summary>Of bytes, which are copied. name: what errors call it.</summary>
    public static MarrowFile FromBytes(byte[] bytes, string name) {
        if (bytes == null) throw new ArgumentNullException("bytes");
        MarrowLibrary.Check();
        MarrowFile made = new MarrowFile(name);
        fixed (byte* first = bytes) {
            try {
                made.Open(first, bytes.Length);
            } catch {
                made.Dispose();
                throw;
            }
        }
        return made;
    }

    void Open(byte* bytes, int size) {
        DataError error = DataError.New();
        MarrowRuntime.Bytes whole;
        if (Marrow.IsPacked(bytes, new UIntPtr((uint)size)) != 0) {
            whole = Unpack(bytes, new UIntPtr((uint)size));
        } else {
            block = new NativeBlock((ulong)size);
            Buffer.MemoryCopy(bytes, block.First, size, size);
            whole.data = block.First;
            whole.size = new UIntPtr((uint)size);
        }
        handle = new NativeBlock((ulong)sizeof(MarrowRuntime.File));
        *Native = MarrowRuntime.File.New();
        error.status = Marrow.Load(whole.data, whole.size, Native, &error);
        if (error.status != Status.Ok) throw MarrowException.Of(Name, error);
    }

    MarrowRuntime.Bytes Unpack(byte* packed, UIntPtr size) {
        DataError error = DataError.New();
        UnpackSizes sizes;
        MarrowRuntime.Bytes whole;
        MeshDecoder* decoders = stackalloc MeshDecoder[2];
        uint count = 0;
        // A library that was built without a codec does not have its function.
        try {
            if (Marrow.DracoDecoder(&decoders[count]) == Status.Ok) ++count;
        } catch (EntryPointNotFoundException) {}
        try {
            if (Marrow.MeshoptDecoder(&decoders[count]) == Status.Ok) ++count;
        } catch (EntryPointNotFoundException) {}
        error.status = Marrow.FindUnpackSizes(packed, size, &sizes, &error);
        if (error.status != Status.Ok) throw MarrowException.Of(Name, error);
        block = new NativeBlock(sizes.memory_bytes);
        error.status = Marrow.Unpack(packed, size, decoders, new UIntPtr(count), block.First,
                                     new UIntPtr(sizes.memory_bytes), &whole, &error);
        if (error.status != Status.Ok) throw MarrowException.Of(Name, error);
        return whole;
    }

    /// <summary>For calls of MarrowRuntime.Marrow; as long as the file is open.</summary>
    public MarrowRuntime.File* Native {
        get {
            if (handle == null) throw new ObjectDisposedException(Name);
            return (MarrowRuntime.File*)handle.First;
        }
    }

    public int SkeletonCount { get { return (int)Marrow.FileSkeletonCount(Native); } }
    public int MeshCount { get { return (int)Marrow.FileMeshCount(Native); } }

    /// <summary>The clips of this file; made when first asked for.</summary>
    public MarrowClips Clips { get { return clips ?? (clips = new MarrowClips(this, this)); } }

    /// <summary>Clips of a pack, which `marrow cook --clips-only` made, for the characters of this file.</summary>
    public MarrowClips ClipsOf(MarrowFile pack) {
        if (pack == null) throw new ArgumentNullException("pack");
        return new MarrowClips(this, pack);
    }

    /// <summary>Graphs of behaviour, which `marrow cook --graph` put into it.</summary>
    public int GraphCount { get { return (int)Marrow.FileGraphCount(Native); } }

    public string GraphName(int index) {
        MarrowRuntime.Graph graph;
        DataError error = DataError.New();
        if (index < 0 || index >= GraphCount) throw new ArgumentOutOfRangeException("index");
        error.status = Marrow.FileGraph(Native, (uint)index, &graph, &error);
        if (error.status != Status.Ok) throw MarrowException.Of(Name, error);
        return Marrow.Text(graph.name);
    }

    /// <summary>
    /// The graph of a name, or of none the first, with this file's clips; made when first asked for. The exception of
    /// one that there is not lists those that there are.
    /// </summary>
    public MarrowGraph Graph(string name = "") {
        int index = FindGraph(name);
        if (graphs == null) graphs = new MarrowGraph[GraphCount];
        return graphs[index] ??
            (graphs[index] = new MarrowGraph(this, this, (uint)index, new[] {Clips}, true));
    }

    /// <summary>
    /// A graph of this file or of a graph pack, for the characters of this file. Its clips are looked for among this
    /// file's own, then in packs, as ClipsOf() gave them, which outlive it.
    /// </summary>
    public MarrowGraph GraphOf(MarrowFile source, string name, params MarrowClips[] packs) {
        if (source == null) throw new ArgumentNullException("source");
        MarrowClips[] all = new MarrowClips[1 + packs.Length];
        all[0] = Clips;
        packs.CopyTo(all, 1);
        return new MarrowGraph(this, source, (uint)source.FindGraph(name), all, false);
    }

    int FindGraph(string name) {
        string[] names = new string[GraphCount];
        for (int i = 0; i < names.Length; ++i) {
            names[i] = GraphName(i);
            if (name.Length == 0 || names[i] == name) return i;
        }
        throw new MarrowException(Name + ": there is no graph" + (name.Length == 0 ? "" : " \"" + name + "\"") + ": " +
            (names.Length == 0 ? "cook it with --graph" : "it has " + string.Join(", ", names)));
    }

    /// <summary>
    /// A box, in metres, that a mesh stays in while any clip of the file plays: x, y, z of its least and largest
    /// corner, of space `space`. False if the file has none.
    /// </summary>
    public bool TryGetBox(int mesh, MarrowSpace space, float[] least, float[] largest) {
        bool any = false;
        for (uint clip = 0; clip < Marrow.FileClipCount(Native); ++clip) {
            MarrowRuntime.Bounds bounds = default(MarrowRuntime.Bounds);
            if (Marrow.FileBounds(Native, clip, (uint)mesh, &bounds) != Status.Ok) continue;
            if (Marrow.BoundsIsEmpty(&bounds) != 0) continue;
            for (int i = 0; i < 3; ++i) {
                least[i] = any ? Math.Min(least[i], bounds.box_min[i]) : bounds.box_min[i];
                largest[i] = any ? Math.Max(largest[i], bounds.box_max[i]) : bounds.box_max[i];
            }
            any = true;
        }
        if (any && space == MarrowSpace.Unity) {
            float first = least[0];
            least[0] = -largest[0];
            largest[0] = -first;
        }
        return any;
    }

    public void Dispose() {
        if (disposed) return;
        disposed = true;
        LetGo();
    }

    // Of what has pointers into the file.
    internal MarrowFile Keep() {
        if (handle == null) throw new ObjectDisposedException(Name);
        Interlocked.Increment(ref users);
        return this;
    }

    internal void LetGo() {
        if (Interlocked.Decrement(ref users) > 0) return;
        foreach (MarrowGraph graph in graphs ?? new MarrowGraph[0])
            if (graph != null) graph.Dispose();
        if (clips != null) clips.Dispose();
        if (block != null) block.Dispose();
        if (handle != null) handle.Dispose();
        graphs = null;
        clips = null;
        block = handle = null;
    }
}

}
