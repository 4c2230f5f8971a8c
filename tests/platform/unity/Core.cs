// Tests the package's part without UnityEngine against a real library.
// usage: Core.exe poses NEWT.mrw        the hash that poses.c prints
//        Core.exe hand CORNER.mrw       numbers by hand, of corner.py
//        Core.exe tests NEWT.mrw CORNER.mrw PACK.mrw FOLDER
//        Core.exe says NEWT.mrw         what a library makes of it that is missing or another
using System;
using System.IO;
using MarrowAnimation;

public static unsafe class Core {
    static uint hash = 2166136261;
    static void Add(float value) { hash = unchecked((hash ^ *(uint*)&value) * 16777619); }

    static void Expect(bool condition, string what) {
        if (!condition) throw new Exception("does not hold: " + what);
    }

    static string Refused(string[] words, Action what) {
        try {
            what();
        } catch (MarrowException problem) {
            foreach (string word in words) Expect(problem.Message.Contains(word), problem.Message + " names " + word);
            return problem.Message;
        }
        throw new Exception("is not refused: " + string.Join(" ", words));
    }

    static void Poses(string name) {
        MarrowCharacter character;
        MarrowClip walk, idle;
        using (MarrowFile file = MarrowFile.Load(name)) {
            character = new MarrowCharacter(file);
            walk = file.Clips["walk"];
            idle = file.Clips["idle"];
            MarrowPlayback playback = MarrowPlayback.Start(walk);
            MarrowLayer[] layers = new MarrowLayer[2];
            float[] rows = new float[12];
            float[][] positions = new float[character.MeshCount][], normals = new float[character.MeshCount][];
            for (int m = 0; m < positions.Length; ++m) {
                positions[m] = new float[3 * character.Mesh(m).SlotCount];
                normals[m] = new float[positions[m].Length];
            }
            long allocated = 0;
            for (int i = 0; i < 30; ++i) {
                if (i == 20) allocated = GC.GetAllocatedBytesForCurrentThread();
                playback.Advance(walk, 1.0f / 60);
                layers[0].Clip = walk;
                layers[1].Clip = idle;
                layers[0].Time = layers[1].Time = playback.Time;
                layers[0].Weight = 1;
                layers[1].Weight = 0.25f;
                if (i < 10) character.Pose(walk, playback.Time);
                else character.Pose(layers, 2);
                character.Finish();
                for (int j = 0; j < character.JointCount(0); ++j) {
                    MarrowTransform t = character.GetLocal(0, j);
                    character.GetScene(0, j, rows);
                    Add(t.Px); Add(t.Py); Add(t.Pz);
                    Add(t.Rx); Add(t.Ry); Add(t.Rz); Add(t.Rw);
                    Add(t.Sx); Add(t.Sy); Add(t.Sz);
                    foreach (float value in rows) Add(value);
                }
                for (int m = 0; m < positions.Length; ++m) {
                    character.Skin(m, positions[m], normals[m], null);
                    foreach (float value in positions[m]) Add(value);
                    foreach (float value in normals[m]) Add(value);
                }
            }
            allocated = GC.GetAllocatedBytesForCurrentThread() - allocated;
            Expect(allocated == 0, "ten frames allocate " + allocated + " bytes");
        }
        character.Dispose();
        Console.WriteLine(hash.ToString("x8"));
    }

    static void Near(float got, double wanted, string what) {
        Expect(Math.Abs(got - wanted) < 2e-6, what + " is " + got + ", not " + wanted);
    }

    static void Near(float[] got, int first, string what, params double[] wanted) {
        for (int i = 0; i < wanted.Length; ++i) Near(got[first + i], wanted[i], what + "[" + i + "]");
    }

    // corner.py's triangle, which the clip's end puts at (10, 20, 30), turned by 90 degrees about z: (x, y, z) comes to
    // (10 - y, 20 + x, 30 + z). In Unity x has the other sign.
    static void Hand(string name, MarrowSpace space) {
        MarrowCharacterOptions options = new MarrowCharacterOptions {Space = space};
        using (MarrowFile file = MarrowFile.Load(name))
        using (MarrowCharacter character = new MarrowCharacter(file, options)) {
            float mirror = space == MarrowSpace.Unity ? -1 : 1;
            MarrowMesh mesh = character.Mesh(0);
            Expect(mesh.HasNormals && mesh.HasTangents && mesh.HasUvs && mesh.HasColours, "attributes");
            byte[] surface = new byte[12 * mesh.SlotCount];
            fixed (byte* to = surface) mesh.CopySurface(to);
            int[] at = new int[3];  // which slot a corner has: they are red, green and blue
            for (int slot = mesh.SlotCount - 1; slot >= 0; --slot)
                for (int k = 0; k < 3; ++k)
                    if (surface[12 * slot + k] == 255) at[k] = slot;
            Near(BitConverter.ToSingle(surface, 12 * at[1] + 4), 0.25, "u");
            Near(BitConverter.ToSingle(surface, 12 * at[1] + 8), space == MarrowSpace.Unity ? 0.875 : 0.125, "v");
            HandVertices(file, character, at, mirror);
            HandJoints(file, character, at, mirror);
            HandFront(character, mirror);

            float[] least = new float[3], most = new float[3];
            Expect(file.TryGetBox(0, space, least, most), "a box");
            Expect(most[1] >= 21 && least[1] <= 0 && most[2] >= 33, "the box holds the clip");
            Expect(space == MarrowSpace.Unity ? least[0] <= -10 && most[0] < 1 : most[0] >= 10 && least[0] > -1,
                   "the box is mirrored");
        }
    }

    static void HandVertices(MarrowFile file, MarrowCharacter character, int[] at, float mirror) {
        double h = Math.Sqrt(0.5), third = 1 / Math.Sqrt(3);
        int slots = character.Mesh(0).SlotCount;
        float[] p = new float[3 * slots], n = new float[3 * slots], t = new float[4 * slots];
        character.Pose(file.Clips["turn"], 1);
        character.Finish();
        character.Skin(0, p, n, t);
        Near(p, 3 * at[0], "corner 0", mirror * 10, 21, 30);
        Near(p, 3 * at[1], "corner 1", mirror * 8, 20, 30);
        Near(p, 3 * at[2], "corner 2", mirror * 10, 20, 33);
        Near(n, 3 * at[0], "normal 0", 0, 1, 0);
        Near(n, 3 * at[1], "normal 1", mirror * -1, 0, 0);
        Near(n, 3 * at[2], "normal 2", mirror * -third, third, third);
        // The bitangent w · n × t is to be mirrored, too; a cross product is not, so w has to change.
        Near(t, 4 * at[0], "tangent 0", mirror * -1, 0, 0, mirror);
        Near(t, 4 * at[1], "tangent 1", 0, 1, 0, -mirror);
        Near(t, 4 * at[2], "tangent 2", mirror * h, h, 0, mirror);
    }

    static void HandJoints(MarrowFile file, MarrowCharacter character, int[] at, float mirror) {
        double h = Math.Sqrt(0.5);
        float[] p = new float[3 * character.Mesh(0).SlotCount], rows = new float[12];
        character.Pose(file.Clips["turn"], 1);
        MarrowTransform joint = character.GetLocal(0, 0);
        Near(joint.Px, mirror * 10, "x");
        Near(joint.Py, 20, "y");
        Near(joint.Pz, 30, "z");
        Near(joint.Rz, mirror * h, "rotation z");  // (x, -y, -z, w)
        Near(joint.Rw, h, "rotation w");
        character.GetScene(0, 0, rows);
        Near(rows, 0, "scene", 0, -mirror, 0, mirror * 10, mirror, 0, 0, 20, 0, 0, 1, 30);
        character.Pose(file.Clips["turn"], 0.5f);
        joint = character.GetLocal(0, 0);
        Near(joint.Ry, mirror * h, "rotation y");
        // What is put in comes out, and moves the vertices.
        joint.Px = 7;
        joint.Rx = 1;
        joint.Ry = joint.Rz = joint.Rw = 0;  // half a turn about x
        character.SetLocal(0, 0, joint);
        character.UpdateJoints();
        character.Finish();
        character.Skin(0, p, null, null);
        Near(p, 3 * at[0], "moved corner 0", 7 + mirror, 0, 0);
        Near(p, 3 * at[2], "moved corner 2", 7, 0, -3);
    }

    // In the bind pose (b - a) × (c - a) is (6, 3, 2) in glTF's numbers, (-6, 3, 2) in Unity's: never inwards.
    static void HandFront(MarrowCharacter character, float mirror) {
        int[] indices = character.Mesh(0).MakeIndices();
        float[] p = new float[3 * character.Mesh(0).SlotCount];
        double[] a = new double[3], b = new double[3];
        Expect(indices.Length == 3, "one triangle");
        character.Pose(new MarrowLayer[0], 0);
        character.Finish();
        character.Skin(0, p, null, null);
        for (int k = 0; k < 3; ++k) {
            a[k] = p[3 * indices[1] + k] - p[3 * indices[0] + k];
            b[k] = p[3 * indices[2] + k] - p[3 * indices[0] + k];
        }
        Near((float)(a[1] * b[2] - a[2] * b[1]), mirror * 6, "front x");
        Near((float)(a[2] * b[0] - a[0] * b[2]), 3, "front y");
        Near((float)(a[0] * b[1] - a[1] * b[0]), 2, "front z");
    }

    // A quarter turn about each axis, moved, scaled by 2, 3, 4; and what is none.
    static void Transforms() {
        MarrowTransform t;
        Expect(MarrowTransform.TryMake(new float[] {2, 0, 0, 5, 0, 0, -4, 6, 0, 3, 0, 7}, out t), "about x");
        Near(t.Px, 5, "x"); Near(t.Py, 6, "y"); Near(t.Pz, 7, "z");
        Near(t.Sx, 2, "sx"); Near(t.Sy, 3, "sy"); Near(t.Sz, 4, "sz");
        Near(t.Rx, Math.Sqrt(0.5), "rx"); Near(t.Rw, Math.Sqrt(0.5), "rw");
        Expect(MarrowTransform.TryMake(new float[] {-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0}, out t), "half about z");
        Near(Math.Abs(t.Rz), 1, "rz");
        Expect(MarrowTransform.TryMake(new float[] {-2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, out t), "a mirror");
        Near(t.Sx, -2, "mirrored sx"); Near(t.Rw, 1, "mirrored rw");
        Expect(!MarrowTransform.TryMake(new float[] {1, 0.5f, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, out t), "shear is told");
        Expect(!MarrowTransform.TryMake(new float[12], out t), "nothing is told");
    }

    // Turns by 106°, of the quaternion (0.8 axis, 0.6): cos = 0.36 - 0.64, sin = 2 · 0.8 · 0.6. A half turn shows no sign.
    static void FarTurns() {
        MarrowTransform t;
        const float c = -0.28f, s = 0.96f;
        Expect(MarrowTransform.TryMake(new float[] {1, 0, 0, 0, 0, c, -s, 0, 0, s, c, 0}, out t), "far about x");
        Near(t.Rx * t.Rw, 0.48, "far rx"); Near(Math.Abs(t.Rw), 0.6, "far rw");
        Expect(MarrowTransform.TryMake(new float[] {c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0}, out t), "far about y");
        Near(t.Ry * t.Rw, 0.48, "far ry"); Near(Math.Abs(t.Rw), 0.6, "far rw");
        Expect(MarrowTransform.TryMake(new float[] {c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0}, out t), "far about z");
        Near(t.Rz * t.Rw, 0.48, "far rz"); Near(Math.Abs(t.Rw), 0.6, "far rw");
    }

    static void Damage(byte[] good, string folder) {
        string name = Path.Combine(folder, "damaged.mrw");
        Action load = () => MarrowFile.Load(name).Dispose();
        for (int i = 0; i < 40; ++i) {  // somewhere in it
            byte[] bytes = (byte[])good.Clone();
            bytes[8 + i * (bytes.Length - 9) / 39] ^= 0x10;
            System.IO.File.WriteAllBytes(name, bytes);
            Refused(new[] {"damaged.mrw", "again"}, load);
        }
        for (int size = 0; size < good.Length; size += good.Length / 20) {  // cut
            byte[] bytes = new byte[size];
            Array.Copy(good, bytes, size);
            System.IO.File.WriteAllBytes(name, bytes);
            Refused(new[] {"damaged.mrw"}, load);
        }
        System.IO.File.WriteAllText(name, "version https://git-lfs.github.com/spec/v1 and so on, as git leaves it");
        Console.WriteLine(Refused(new[] {"damaged.mrw", "marrow cook", "LFS"}, load));
        Console.WriteLine(Refused(new[] {"not-there.mrw", "cannot be read"},
                                  () => MarrowFile.Load(Path.Combine(folder, "not-there.mrw"))));
    }

    static void Misuse(string newt, string corner) {
        MarrowFile file = MarrowFile.Load(newt), other = MarrowFile.Load(corner);
        MarrowCharacter character = new MarrowCharacter(file);
        Console.WriteLine(Refused(new[] {"newt.mrw", "\"wlak\"", "idle, walk"},
                                  () => { MarrowClip c = file.Clips["wlak"]; }));
        Refused(new[] {"newt.mrw", "\"turn\""}, () => character.Pose(other.Clips["turn"], 0));
        Refused(new[] {"corner.mrw", "another skeleton"}, () => file.ClipsOf(other));
        Refused(new[] {"newt.mrw", "walk"}, () => character.Pose(file.Clips["walk"], float.NaN));
        MarrowLayer[] layers = new MarrowLayer[3];
        for (int i = 0; i < 3; ++i) layers[i] = new MarrowLayer {Clip = file.Clips[i], Weight = 1};
        Refused(new[] {"newt.mrw", "3 layers", "room for 2"}, () => character.Pose(layers, 3));
        layers[0].Weight = -1;
        Refused(new[] {"newt.mrw", "below 0"}, () => character.Pose(layers, 1));
        Refused(new[] {"newt.mrw", "no room for"}, () => character.Skin(0, new float[5], null, null));
        Refused(new[] {"newt.mrw", "body", "tangents"}, () => {
            int slots = character.Mesh(0).SlotCount;
            character.Skin(0, new float[3 * slots], new float[3 * slots], new float[4 * slots]);
        });
        Refused(new[] {"newt.mrw", "PosesAlone"}, () => {
            using (MarrowCharacter poses = new MarrowCharacter(file, new MarrowCharacterOptions {PosesAlone = true}))
                poses.Skin(0, new float[3 * poses.Mesh(0).SlotCount], null, null);
        });
        Refused(new[] {"newt.mrw", "layer"}, () => new MarrowCharacter(file, new MarrowCharacterOptions {Layers = -1}));
        Expect(character.FindJoint(0, "head") > 0 && character.FindJoint(0, "tentacle") == -1, "joints by name");
        // A file stays open for its characters; what is disposed of says so.
        MarrowClip walk = file.Clips["walk"];
        file.Dispose();
        file.Dispose();
        character.Pose(walk, 0.1f);
        character.Finish();
        character.Pose(new MarrowLayer[0], 0);
        MarrowCharacter last = new MarrowCharacter(file);
        character.Dispose();
        character.Dispose();
        Disposed(() => character.Finish());
        last.Pose(walk, 0.1f);
        last.Dispose();
        Disposed(() => Console.Write(walk.Native->duration_s));
        Disposed(() => Console.Write(file.MeshCount));
        Disposed(() => new MarrowCharacter(file));
        other.Dispose();
        for (int i = 0; i < 200; ++i) MarrowFile.Load(corner);  // forgotten ones are freed by the collector
        GC.Collect();
        GC.WaitForPendingFinalizers();
    }

    // The clips of a pack that was cooked of the same file play the same; and animation space without a fit is SSD.
    static void PackAndAnimationSpace(string newt, string pack) {
        MarrowFile file = MarrowFile.Load(newt), more = MarrowFile.Load(pack);
        MarrowClips clips = file.ClipsOf(more);
        more.Dispose();
        MarrowCharacterOptions fitted = new MarrowCharacterOptions {AnimationSpace = true};
        using (MarrowCharacter one = new MarrowCharacter(file), other = new MarrowCharacter(file, fitted)) {
            float[] a = new float[3 * one.Mesh(0).SlotCount], b = new float[a.Length];
            one.Pose(file.Clips["walk"], 0.4f);
            other.Pose(clips["walk"], 0.4f);
            one.Finish();
            other.Finish();
            one.Skin(0, a, null, null);
            other.Skin(0, b, null, null);
            for (int i = 0; i < a.Length; ++i)
                Expect(Math.Abs(a[i] - b[i]) < 1e-3, "float " + i + " is " + b[i] + ", and of the own clip " + a[i]);
            Expect(clips.Count == file.Clips.Count, "as many clips");
            clips.Dispose();
            Disposed(() => other.Pose(clips["walk"], 0.4f));
        }
        file.Dispose();
        Disposed(() => Console.Write(more.MeshCount));
        Disposed(() => Console.Write(file.MeshCount));
    }

    static void Disposed(Action what) {
        try {
            what();
        } catch (ObjectDisposedException) {
            return;
        }
        throw new Exception("what is disposed of can be used");
    }

    public static int Main(string[] args) {
        if (args[0] == "poses") Poses(args[1]);
        if (args[0] == "hand") {
            Hand(args[1], MarrowSpace.Gltf);
            Hand(args[1], MarrowSpace.Unity);
            Transforms();
            FarTurns();
            Console.WriteLine("numbers by hand: right, in both spaces");
        }
        if (args[0] == "tests") {
            Damage(System.IO.File.ReadAllBytes(args[1]), args[4]);
            Misuse(args[1], args[2]);
            PackAndAnimationSpace(args[1], args[3]);
        }
        if (args[0] == "says") {
            try {
                MarrowFile.Load(args[1]);
            } catch (MarrowException problem) {
                Console.WriteLine(problem.Message);
                return 2;
            }
        }
        return 0;
    }
}
