using System;
using MarrowRuntime;

namespace MarrowAnimation {

/// <summary>What a character is made with.</summary>
public struct MarrowCharacterOptions {
    /// <summary>
    /// Clips that are blended at once, at most; 0 counts as 2. A graph needs MarrowGraph.Poses of them.
    /// </summary>
    public int Layers;
    /// <summary>Level of detail; 0 is the finest.</summary>
    public int Level;
    /// <summary>No vertices by the CPU: poses alone, or for a skinner on the GPU.</summary>
    public bool PosesAlone;
    /// <summary>Skin(…) by animation space, if the file was cooked with it.</summary>
    public bool AnimationSpace;
    /// <summary>Of all that the character takes and gives.</summary>
    public MarrowSpace Space;
}

/// <summary>A clip at a time, and how much of it.</summary>
public struct MarrowLayer {
    public MarrowClip Clip;
    public float Time;
    public float Weight;
}

/// <summary>
/// A character of a file. A frame is Pose(), then what changes joints, Finish(), Skin(). Nothing of that allocates.
/// One thread at a time; different characters on different threads.
/// </summary>
public sealed unsafe partial class MarrowCharacter : IDisposable {
    readonly MarrowFile file;
    NativeBlock memory;
    readonly MarrowCharacterOptions options;
    readonly int most;  // layers
    readonly string name;
    readonly MarrowMesh[] meshes;
    readonly string[][] joints;

    public MarrowCharacter(MarrowFile file, MarrowCharacterOptions options = default(MarrowCharacterOptions)) {
        if (file == null) throw new ArgumentNullException("file");
        this.options = options;
        name = file.Name;
        most = options.Layers == 0 ? 2 : options.Layers;
        if (most < 1 || options.Level < 0)
            throw new MarrowException(name + ": give at least one layer, and a level of detail from 0 on");
        CharacterOptions wanted = CharacterOptions.New();
        wanted.layers = (uint)most;
        wanted.level = (uint)options.Level;
        wanted.skin = (byte)(options.PosesAlone ? 0 : 1);
        wanted.animation_space = (byte)(options.AnimationSpace ? 1 : 0);
        ulong bytes = (ulong)Marrow.CharacterBytes(file.Native, &wanted);
        ulong head = NativeBlock.Rounded(sizeof(Character));
        ulong tail = NativeBlock.Rounded(most * sizeof(AnimationLayer));
        if (bytes == 0) throw new MarrowException(name + ": is too large for a character");
        memory = new NativeBlock(head + tail + bytes);
        this.file = file.Keep();
        Status status = Marrow.MakeCharacter(file.Native, &wanted, memory.First + head + tail, new UIntPtr(bytes),
                                             (Character*)memory.First);
        if (status != Status.Ok) Dispose();
        MarrowException.Must(status, name);
        MirrorPalettes();
        meshes = new MarrowMesh[(int)Native->mesh_count];
        for (int i = 0; i < meshes.Length; ++i) meshes[i] = new MarrowMesh(this, i, options.Space);
        joints = new string[(int)Native->skeleton_count][];
        for (int s = 0; s < joints.Length; ++s) {
            Skeleton* skeleton = &Native->skeletons[s].pose.skeleton;
            joints[s] = new string[skeleton->joint_count];
            for (uint j = 0; j < skeleton->joint_count; ++j)
                joints[s][j] = Marrow.Text(Marrow.FileText(file.Native, skeleton->names[j]));
        }
    }

    /// <summary>For calls of MarrowRuntime.Marrow. Its palettes are for `Space`; the rest is as cooked.</summary>
    public Character* Native {
        get {
            if (memory == null) throw new ObjectDisposedException(name);
            return (Character*)memory.First;
        }
    }

    AnimationLayer* Layers { get { return (AnimationLayer*)(memory.First + NativeBlock.Rounded(sizeof(Character))); } }

    public MarrowSpace Space { get { return options.Space; } }

    /// <summary>Clips that are blended at once, at most.</summary>
    public int LayerCount { get { return most; } }
    public int SkeletonCount { get { return joints.Length; } }
    public int MeshCount { get { return meshes.Length; } }
    public MarrowMesh Mesh(int index) { return meshes[index]; }

    /// <summary>One clip at a time. seconds: of the clip, as MarrowPlayback has it.</summary>
    public void Pose(MarrowClip clip, float seconds) {
        Character* character = Native;
        SetLayer(0, clip, seconds, 1);
        MustPose(Marrow.PoseCharacter(character, Layers, new UIntPtr(1)), clip);
    }

    /// <summary>The mean of the first `count` layers by their weights; of none, the rest pose.</summary>
    public void Pose(MarrowLayer[] layers, int count) {
        Character* character = Native;
        if (count < 0 || count > most || (count > 0 && count > layers.Length)) {
            throw new MarrowException(name + ": " + count + " layers, and there is room for " + most +
                ": see MarrowCharacterOptions.Layers");
        }
        for (int i = 0; i < count; ++i) SetLayer(i, layers[i].Clip, layers[i].Time, layers[i].Weight);
        MustPose(Marrow.PoseCharacter(character, Layers, new UIntPtr((uint)count)), count > 0 ? layers[0].Clip : null);
    }

    /// <summary>By what an animator is in, from its first Update() on.</summary>
    public void Pose(MarrowAnimator animator) {
        if (animator == null) throw new ArgumentNullException("animator");
        MarrowGraph graph = animator.Graph;
        Status status = Marrow.PoseAnimated(Native, animator.Native, null, UIntPtr.Zero);
        if (status == Status.Ok) return;
        string what = graph.File != file ? ": it is for the characters of another file, or the same opened twice"
            : graph.Poses > most ? ": it holds " + graph.Poses + " poses, and there is room for " + most +
                ": see MarrowCharacterOptions.Layers"
            : status == Status.BadArgument ? ": its animator was never updated: Update() comes before"
            : ": " + Marrow.Text(Marrow.StatusText(status));
        throw new MarrowException(name + ": cannot be posed by the graph \"" + graph.Name + "\"" + what, status);
    }

    void SetLayer(int index, MarrowClip clip, float seconds, float weight) {
        AnimationLayer* layer = Layers + index;
        *layer = AnimationLayer.New();
        if (clip == null) throw new ArgumentNullException("clip");
        layer->animation = clip.Native;
        layer->time_s = seconds;
        layer->weight = weight;
        if (!clip.IsFor(file)) {
            throw new MarrowException(name + ": \"" + clip.Name + "\" was opened for the characters of another file, " +
                "or the same opened twice: take clips from MarrowFile.Clips or ClipsOf() of the character's own file");
        }
    }

    void MustPose(Status status, MarrowClip clip) {
        if (status == Status.Ok) return;
        throw new MarrowException(name + ": cannot play \"" + (clip == null ? "" : clip.Name) + "\": times must be " +
            "numbers, weights too and not below 0", status);
    }

    /// <summary>What Skin() and skinners on the GPU need of the pose.</summary>
    public void Finish() {
        MarrowException.Must(Marrow.FinishCharacter(Native), name);
        MirrorPalettes();
    }

    void MirrorPalettes() {
        if (options.Space != MarrowSpace.Unity) return;
        Character* character = Native;
        for (ulong m = 0; m < (ulong)character->mesh_count; ++m) {
            CharacterMesh* mesh = &character->meshes[m];
            for (ulong i = 0; i < (ulong)mesh->palette_count; ++i) MarrowMirror.MirrorResult(&mesh->palette[i]);
        }
    }

    /// <summary>
    /// Skinned vertices: 3 floats a slot of the mesh, of tangents 4. Normals and tangents may be null, and must be
    /// where the mesh has none. Normals are exact, of length 1.
    /// </summary>
    public void Skin(int mesh, float* positions, float* normals, float* tangents) {
        CharacterMesh* m = &Native->meshes[meshes[mesh].Index];
        SkinOutput output = default(SkinOutput);
        output.positions = positions;
        output.position_count = new UIntPtr(3 * m->mesh.geometry.slot_count);
        output.normals = normals;
        if (normals != null) output.normal_count = output.position_count;
        output.tangents = tangents;
        if (tangents != null) output.tangent_count = new UIntPtr(4 * m->mesh.geometry.slot_count);
        Status status = options.AnimationSpace
            ? Marrow.SkinAs(&m->mesh, m->coordinates, m->coordinate_count, m->palette, m->palette_count, &output, null,
                            UIntPtr.Zero)
            : Marrow.SkinSsd(&m->mesh, m->palette, m->palette_count, &output);
        if (status == Status.Ok) return;
        throw new MarrowException(name + ": mesh \"" + meshes[mesh].Name + "\" cannot be skinned: it has no " +
            "normals or tangents that are asked for, or the character was made with PosesAlone", status);
    }

    /// <summary>The same into arrays, whose lengths are checked.</summary>
    public void Skin(int mesh, float[] positions, float[] normals, float[] tangents) {
        int slots = meshes[mesh].SlotCount;
        MustHold(positions, 3 * slots, "positions");
        if (normals != null) MustHold(normals, 3 * slots, "normals");
        if (tangents != null) MustHold(tangents, 4 * slots, "tangents");
        fixed (float* p = positions, n = normals, t = tangents) Skin(mesh, p, n, t);
    }

    void MustHold(float[] array, int floats, string what) {
        if (array == null || array.Length < floats)
            throw new MarrowException(name + ": " + what + " have no room for " + floats + " floats");
    }

    public void Dispose() {
        if (memory == null) return;
        memory.Dispose();
        memory = null;
        file.LetGo();
    }
}

}
