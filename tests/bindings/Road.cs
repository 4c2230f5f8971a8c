// What tests/c/road.c does, in C#: the same lines must come of it.
using System;
using System.Runtime.InteropServices;
using System.Text;
using MarrowRuntime;
using M = MarrowRuntime.Marrow;

public static unsafe class Road {
    static uint hash = 2166136261;
    static int told;
    static readonly CallErrorHandler onCallError = (function, condition) => ++told;

    static void Add(void* words, ulong count) {
        for (ulong i = 0; i < count; ++i) hash = unchecked((hash ^ ((uint*)words)[i]) * 16777619);
    }

    static void Must(Status status) {
        if (status != Status.Ok) throw new Exception(M.Text(M.StatusText(status)));
    }

    static void Expect(Status status, Status wanted, string what) {
        if (status != wanted) throw new Exception(what + ": " + M.Text(M.StatusText(status)));
    }

    static byte* Text(string text) {
        byte[] bytes = Encoding.UTF8.GetBytes(text + "\0");
        byte* block = (byte*)M.Block((ulong)bytes.Length);
        Marshal.Copy(bytes, 0, (IntPtr)block, bytes.Length);
        return block;
    }

    static UIntPtr Size(ulong size) { return new UIntPtr(size); }

    // Structs on boundaries of 16 bytes, which C#'s stack does not promise, stay in blocks.
    static readonly Aim* look = (Aim*)M.Block((ulong)sizeof(Aim));
    static readonly TwoBone* step = (TwoBone*)M.Block((ulong)sizeof(TwoBone));
    static readonly SpringFrame* frame = (SpringFrame*)M.Block((ulong)sizeof(SpringFrame));

    static void Refuse(byte* bytes, int size, File* file) {
        byte* copy = (byte*)M.Block((ulong)size + 4);
        SoaTransform* pose = (SoaTransform*)M.Block(64 * 160);
        Skeleton skeleton;
        Pose zeros = default(Pose);
        Clip clip;
        Mesh mesh;
        File other;
        TwoBoneLimb limb = TwoBoneLimb.New();
        SkinOutput output = SkinOutput.New();
        *step = TwoBone.New();
        Must(M.FileSkeleton(file, 0, &skeleton));
        Must(M.FileClip(file, 0, &clip));
        Must(M.FileMesh(file, 0, 0, &mesh));
        M.SetCallErrorHandler(Marshal.GetFunctionPointerForDelegate(onCallError));
        Expect(M.Load(null, Size(0), &other, null), Status.BadArgument, "no file");
        Expect(M.Load(null, Size(64), &other, null), Status.BadArgument, "null with a size");
        Expect(M.Load(bytes, Size((ulong)size), null, null), Status.BadArgument, "nowhere to load to");
        ulong groups = (ulong)M.SkeletonSoaSize(&skeleton);
        Expect(M.Sample(&skeleton, &clip, 0, pose, Size(groups - 1), null), Status.BadArgument, "short");
        Expect(M.SolveTwoBone(&zeros, &limb, step, null), Status.BadArgument, "zeros");
        Expect(M.SkinSsd(&mesh, null, Size(3), &output), Status.BadArgument, "a null palette");
        Buffer.MemoryCopy(bytes, copy + 4, size, size);
        Expect(M.Load(copy + 4, Size((ulong)size), &other, null), Status.BadArgument, "off its boundary");
        Buffer.MemoryCopy(bytes, copy, size, size);
        Expect(M.Load(copy, Size((ulong)size - 16), &other, null), Status.Truncated, "cut");
        ++copy[4];
        Expect(M.Load(copy, Size((ulong)size), &other, null), Status.BadVersion, "another version");
        M.SetCallErrorHandler(IntPtr.Zero);
        Console.WriteLine("9 refused, " + told + " told");
        M.FreeBlock(copy);
        M.FreeBlock(pose);
    }

    static void Reach(File* file, Pose* pose, Springs* springs, float dt) {
        Skeleton* skeleton = &pose->skeleton;
        uint* neck = stackalloc uint[2];
        neck[0] = M.FileFindJoint(file, skeleton, Text("neck"));
        neck[1] = M.FileFindJoint(file, skeleton, Text("head"));
        *look = Aim.New();
        look->target[0] = 0.5f;
        look->target[1] = 1.25f;
        look->target[2] = 2;
        look->weight = 0.5f;
        Must(M.SolveLookAt(pose, neck, Size(2), look, 0.5f, null));
        TwoBoneLimb leg = new TwoBoneLimb {
            start = M.FileFindJoint(file, skeleton, Text("thigh.L")), mid = M.FileFindJoint(file, skeleton, Text("shin.L")),
            end = M.FileFindJoint(file, skeleton, Text("foot.L"))
        };
        *step = TwoBone.New();
        for (int i = 0; i < 3; ++i) step->target[i] = pose->model_from_joint[leg.end].rows[4 * i + 3] + 0.0625f;
        Must(M.SolveTwoBone(pose, &leg, step, null));
        *frame = SpringFrame.New();
        frame->dt_s = dt;
        Must(M.SimulateSprings(pose, frame, springs));
    }

    static void Skin(CharacterMesh* m, float* positions, float* normals) {
        ulong floats = 3ul * m->mesh.geometry.slot_count;
        SkinOutput output = SkinOutput.New();
        output.positions = positions;
        output.normals = normals;
        output.position_count = output.normal_count = Size(floats);
        Must(M.SkinSsd(&m->mesh, m->palette, m->palette_count, &output));
        Add(m->palette, 12 * (ulong)m->palette_count);
        Add(positions, floats);
        Add(normals, floats);
        output.normal_count = Size(0);
        Must(M.SkinAs(&m->mesh, m->coordinates, m->coordinate_count, m->palette, m->palette_count, &output, null, Size(0)));
        Add(positions, floats);
    }

    public static void Main(string[] arguments) {
        if (M.Abi() != M.AbiNumber) throw new Exception("the library is of another ABI");
        if (IntPtr.Size == 8 && !M.IsLaidOut()) throw new Exception("C# lays structs out as C does not");
        byte[] read = System.IO.File.ReadAllBytes(arguments[0]);
        byte* bytes = (byte*)M.Block((ulong)read.Length);
        int size = read.Length;
        Marshal.Copy(read, 0, (IntPtr)bytes, size);
        if (M.IsPacked(bytes, Size((ulong)size)) != 0) {
            MeshDecoder* decoders = stackalloc MeshDecoder[2];
            UnpackSizes sizes;
            Bytes unpacked;
            Must(M.DracoDecoder(&decoders[0]));
            Must(M.MeshoptDecoder(&decoders[1]));
            Must(M.FindUnpackSizes(bytes, Size((ulong)size), &sizes, null));
            Must(M.Unpack(bytes, Size((ulong)size), decoders, Size(2), M.Block(sizes.memory_bytes),
                Size(sizes.memory_bytes), &unpacked, null));
            bytes = (byte*)unpacked.data;
            size = (int)unpacked.size;
        }
        File file;
        Must(M.Load(bytes, Size((ulong)size), &file, null));
        Refuse(bytes, size, &file);

        Animations animations;
        Character character;
        CharacterOptions options = CharacterOptions.New();
        options.animation_space = 1;
        UIntPtr needed = M.AnimationsBytes(&file, &file);
        Must(M.MakeAnimations(&file, &file, M.Block((ulong)needed), needed, &animations));
        needed = M.CharacterBytes(&file, &options);
        Must(M.MakeCharacter(&file, &options, M.Block((ulong)needed), needed, &character));
        Animation* walk = M.FindAnimation(&animations, Text("walk"));
        Animation* idle = M.FindAnimation(&animations, Text("idle"));
        Pose* pose = &character.skeletons->pose;

        SpringJoint* joints = stackalloc SpringJoint[4];
        for (int i = 0; i < 4; ++i) {
            joints[i] = SpringJoint.New();
            joints[i].joint = (ushort)M.FileFindJoint(&file, &pose->skeleton, Text("tail_" + (3 + i)));
        }
        SpringChain chain = SpringChain.New();
        chain.joints = joints;
        chain.joint_count = Size(4);
        Springs tail;
        needed = M.SpringsBytes(&pose->skeleton, &chain, Size(1));
        Must(M.MakeSprings(&pose->skeleton, &chain, Size(1), M.Block((ulong)needed), needed, &tail));

        ulong most = 0;
        for (ulong i = 0; i < (ulong)character.mesh_count; ++i)
            most = Math.Max(most, character.meshes[i].mesh.geometry.slot_count);
        float* positions = (float*)M.Block(12 * most), normals = (float*)M.Block(12 * most);
        Playback playback = Playback.New();
        AnimationLayer* layers = stackalloc AnimationLayer[2];
        for (int i = 0; i < 30; ++i) {
            Must(M.Advance(&playback, walk->duration_s, 1.0f / 60));
            layers[0] = layers[1] = AnimationLayer.New();
            layers[0].animation = walk;
            layers[1].animation = idle;
            layers[0].time_s = layers[1].time_s = M.ClipTime(&playback);
            layers[1].weight = 0.25f;
            Must(M.PoseCharacter(&character, layers, Size(2)));
            Reach(&file, pose, &tail, 1.0f / 60);
            Must(M.FinishCharacter(&character));
            Add(pose->local, 40 * (ulong)pose->local_count);
            Add(pose->model_from_joint, 12 * (ulong)pose->model_from_joint_count);
            for (ulong m = 0; m < (ulong)character.mesh_count; ++m) Skin(&character.meshes[m], positions, normals);
        }
        Console.WriteLine(hash.ToString("x8"));
    }
}
