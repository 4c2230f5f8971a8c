using System;
using System.Collections;
using System.Collections.Generic;
using MarrowRuntime;

namespace MarrowAnimation {

/// <summary>A clip that characters of one file can play.</summary>
public sealed unsafe class MarrowClip {
    readonly MarrowClips owner;
    readonly MarrowRuntime.Animation* animation;

    public string Name { get; private set; }
    public float Duration { get; private set; }

    internal MarrowClip(MarrowClips owner, MarrowRuntime.Animation* animation, string name) {
        this.owner = owner;
        this.animation = animation;
        Name = name;
        Duration = animation->duration_s;
    }

    /// <summary>For calls of MarrowRuntime.Marrow; as long as its list is not disposed of.</summary>
    public MarrowRuntime.Animation* Native {
        get {
            owner.MustBeOpen();
            return animation;
        }
    }

    internal bool IsFor(MarrowFile file) { return owner.IsFor(file); }
}

/// <summary>The clips of a file, or of a pack for the characters of a file. Serves any number of characters.</summary>
public sealed unsafe class MarrowClips : IDisposable, IReadOnlyList<MarrowClip> {
    readonly MarrowClip[] all;
    readonly string source;
    readonly MarrowFile file, pack;  // the same, of a file's own clips
    readonly Animations animations;
    NativeBlock memory;

    internal MarrowClips(MarrowFile file, MarrowFile pack) {
        source = pack.Name;
        UIntPtr bytes = Marrow.AnimationsBytes(file.Native, pack.Native);
        memory = new NativeBlock((ulong)bytes);
        this.file = file;
        this.pack = pack;
        if (file != pack) {
            file.Keep();
            pack.Keep();
        }
        Animations made;
        Status status = Marrow.MakeAnimations(file.Native, pack.Native, memory.First, bytes, &made);
        if (status == Status.Mismatch) {
            Dispose();
            throw new MarrowException(pack.Name + ": its clips are for another skeleton than those of " + file.Name +
                ": cook them with --clips-only --skeleton and that character", status);
        }
        MarrowException.Must(status, pack.Name);
        animations = made;
        all = new MarrowClip[(int)animations.all_count];
        for (uint i = 0; i < all.Length; ++i) {
            Clip clip;
            MarrowException.Must(Marrow.FileClip(pack.Native, i, &clip), pack.Name);
            all[i] = new MarrowClip(this, animations.all + i, Marrow.Text(clip.name));
        }
    }

    public int Count { get { return all.Length; } }
    public MarrowClip this[int index] { get { return all[index]; } }

    /// <summary>
    /// The clip of a name, or an exception that lists those that there are. Look clips up once, not a frame.
    /// </summary>
    public MarrowClip this[string name] {
        get {
            MarrowClip found;
            if (TryFind(name, out found)) return found;
            string[] names = Array.ConvertAll(all, clip => clip.Name);
            throw new MarrowException(source + ": there is no clip \"" + name + "\": " +
                (names.Length == 0 ? "it has none" : "it has " + string.Join(", ", names)));
        }
    }

    public bool TryFind(string name, out MarrowClip clip) {
        clip = Array.Find(all, c => c.Name == name);
        return clip != null;
    }

    public IEnumerator<MarrowClip> GetEnumerator() { return ((IEnumerable<MarrowClip>)all).GetEnumerator(); }
    IEnumerator IEnumerable.GetEnumerator() { return all.GetEnumerator(); }

    internal bool IsFor(MarrowFile file) { return file == this.file; }

    internal Animations NativeFor(MarrowFile file) {
        MustBeOpen();
        if (IsFor(file)) return animations;
        throw new MarrowException(source + ": its clips were opened for other characters than those of " + file.Name);
    }

    internal void MustBeOpen() {
        if (memory == null) throw new ObjectDisposedException(source);
    }

    /// <summary>After this its clips cannot be played. Those of MarrowFile.Clips go with their file.</summary>
    public void Dispose() {
        if (memory == null) return;
        memory.Dispose();
        memory = null;
        if (file == pack) return;
        file.LetGo();
        pack.LetGo();
    }
}

}
