// Runs the package's UnityEngine part over stand-ins of its types, and a real library.
// usage: Player.exe NEWT.mrw CORNER.mrw PACK.mrw FOLDER BEHAVING.mrw CORNER_GRAPH.mrw GRAPH_PACK.mrw
using System;
using System.IO;
using System.Reflection;
using System.Runtime.InteropServices;
using MarrowAnimation;
using MarrowAnimation.Editor;
using Unity.Collections;
using UnityEditor.AssetImporters;
using UnityEngine;
using UnityEngine.Rendering;

public static partial class Player {
    static void Expect(bool condition, string what) {
        if (!condition) throw new Exception("does not hold: " + what);
    }

    static void Near(Vector3 got, double x, double y, double z, string what) {
        Expect(Math.Abs(got.x - x) + Math.Abs(got.y - y) + Math.Abs(got.z - z) < 1e-5, what + " is at " + got);
    }

    static void Set(object of, string field, object value) {
        of.GetType().GetField(field, BindingFlags.Instance | BindingFlags.NonPublic).SetValue(of, value);
    }

    static AssetImportContext Import(string path) {
        AssetImportContext context = new AssetImportContext {assetPath = path};
        new MarrowImporter().OnImportAsset(context);
        return context;
    }

    // What dragging into a scene makes: a new object with the fields of the imported one.
    static MarrowPlayer Instance(AssetImportContext of, Action<MarrowPlayer> change = null) {
        MarrowPlayer source = ((GameObject)of.Main).GetComponent<MarrowPlayer>();
        GameObject made = new GameObject("in the scene");
        MarrowPlayer player = made.AddComponent<MarrowPlayer>();
        foreach (FieldInfo field in typeof(MarrowPlayer).GetFields(BindingFlags.Instance | BindingFlags.NonPublic))
            if (field.GetCustomAttribute<SerializeField>() != null) field.SetValue(player, field.GetValue(source));
        if (change != null) change(player);
        player.enabled = false;
        player.enabled = true;
        return player;
    }

    static Vector3 Vertex(UnityEngine.Mesh mesh, int slot, int stream = 0) {
        return new Vector3(mesh.At(stream, slot, 0), mesh.At(stream, slot, 1), mesh.At(stream, slot, 2));
    }

    static UnityEngine.Mesh MeshOf(MarrowPlayer player, string name) {
        return player.transform.gameObject.Find(name).GetComponent<MeshFilter>().sharedMesh;
    }

    // corner.py's clip ends at (10, 20, 30), turned by 90 degrees about z: its corners at (10, 21, 30), (8, 20, 30) and
    // (10, 20, 33), and for Unity with the other x.
    static void Corner(AssetImportContext corner) {
        MarrowPlayer player = Instance(corner, p => {
            Set(p, "mode", MarrowPlayMode.Once);
            Set(p, "posesJoints", true);
        });
        player.Advance(2);
        UnityEngine.Mesh mesh = MeshOf(player, "corner");
        Expect(mesh.vertexCount == 4 && mesh.indices.Length == 3 && mesh.dynamic, "the mesh");
        Expect(mesh.layout.Length == 5 && mesh.layout[3].attribute == VertexAttribute.Color, "all attributes");
        for (int i = 0; i < 3; ++i) {
            int slot = mesh.indices[i];
            byte[] colour = new byte[3];
            Array.Copy(mesh.streams[3], 12 * slot, colour, 0, 3);
            if (colour[0] == 255) {
                Near(Vertex(mesh, slot), -10, 21, 30, "the red corner");
                Near(Vertex(mesh, slot, 1), 0, 1, 0, "the red normal");
                Near(Vertex(mesh, slot, 2), 1, 0, 0, "the red tangent");
                Expect(mesh.At(2, slot, 3) == -1, "its handedness");
            }
            if (colour[1] == 255) {
                Near(Vertex(mesh, slot), -8, 20, 30, "the green corner");
                Expect(mesh.At(3, slot, 1) == 0.25f && mesh.At(3, slot, 2) == 0.875f, "its texture coordinates");
            }
            if (colour[2] == 255) Near(Vertex(mesh, slot), -10, 20, 33, "the blue corner");
        }
        Vector3 a = Vertex(mesh, mesh.indices[0]), b = Vertex(mesh, mesh.indices[1]), c = Vertex(mesh, mesh.indices[2]);
        // The front's normal in glTF is (6, 3, 2) / 7; turned about z (-3, 6, 2) / 7; mirrored (3, 6, 2) / 7.
        Near(Vector3.Cross(b - a, c - a), 3, 6, 2, "the front");
        // A Transform is where the joint is: its point (1, 0, 0) of glTF, in Unity (-1, 0, 0), is the red corner.
        Near(player.Joint("hinge").TransformPoint(new Vector3(-1, 0, 0)), -10, 21, 30, "the joint's Transform");
        Expect(player.Joint("no such") == null, "no other joint");
        Vector3 least = mesh.bounds.center - mesh.bounds.extents, most = mesh.bounds.center + mesh.bounds.extents;
        Expect(least.x <= -10 && most.x >= 0 && most.y >= 21 && most.z >= 33, "the box holds the clip");
        Color colourOf = player.transform.gameObject.Find("corner").GetComponent<MeshRenderer>().sharedMaterial.color;
        Expect(Math.Abs(colourOf.g - 0.5f) < 1e-4f, "the base colour for Unity's eyes is 0.5, not " + colourOf.g);
        GameObject.Destroy(player.gameObject);
    }

    // A rig of the game's own is found by names, and not destroyed.
    static void Rig(AssetImportContext corner) {
        GameObject rig = new GameObject("rig"), hinge = new GameObject("hinge");
        hinge.transform.SetParent(rig.transform, false);
        MarrowPlayer player = Instance(corner, p => {
            Set(p, "mode", MarrowPlayMode.Once);
            Set(p, "rig", rig.transform);
            Set(p, "skinsMeshes", false);
        });
        player.Advance(2);
        Expect(player.Joint("hinge") == hinge.transform, "the rig's joint");
        Near(hinge.transform.localPosition, -10, 20, 30, "the rig's joint");
        Expect(player.transform.childCount == 0, "nothing is shown");
        GameObject.Destroy(player.gameObject);
        Expect(hinge != null, "the rig stays");
        GameObject.Destroy(rig);
    }

    static void Newt(AssetImportContext newt) {
        MarrowPlayer player = Instance(newt, p => Set(p, "posesJoints", true));
        Expect(player.Clip.Name == "idle" && player.transform.childCount == 7, "six meshes and a root joint");
        player.Play("walk", 0.1f);
        int posed = 0;
        player.Posed += p => ++posed;
        for (int i = 0; i < 20; ++i) player.Advance(1.0f / 60);
        MethodInfo update =
            typeof(MarrowPlayer).GetMethod("LateUpdate", BindingFlags.Instance | BindingFlags.NonPublic);
        Action frame = (Action)Delegate.CreateDelegate(typeof(Action), player, update);
        float before = player.Time;
        frame();
        Expect(Math.Abs(player.Time - before - 1.0f / 60) < 1e-6, "time goes on");
        player.Play("idle", 1);
        player.Advance(0.1f);  // fading
        long allocated = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 30; ++i) frame();
        allocated = GC.GetAllocatedBytesForCurrentThread() - allocated;
        Expect(allocated == 0, "30 frames allocate " + allocated + " bytes");
        Expect(posed == 52, "Posed came " + posed + " times");
        CompareWithGltf(player);
        Expect(Lowest(MeshOf(player, "body")) > -0.05f, "the newt stands on the ground");
        try {
            player.Play("wlak");
            throw new Exception("a clip that there is not plays");
        } catch (MarrowException problem) {
            Expect(problem.Message.Contains("wlak") && problem.Message.Contains("idle, walk"), problem.Message);
        }
        GameObject.Destroy(player.gameObject);
    }

    // The same pose in glTF's space: every vertex and normal, mirrored.
    static void CompareWithGltf(MarrowPlayer player) {
        using (MarrowCharacter plain = new MarrowCharacter(player.File)) {
            float[] positions = new float[3 * plain.Mesh(0).SlotCount], normals = new float[positions.Length];
            player.Play("walk", 0);
            player.Advance(0.4f);
            plain.Pose(player.Clip, player.Time);
            plain.Finish();
            plain.Skin(0, positions, normals, null);
            UnityEngine.Mesh mesh = MeshOf(player, "body");
            for (int i = 0; i < mesh.vertexCount; ++i) {
                Near(Vertex(mesh, i), -positions[3 * i], positions[3 * i + 1], positions[3 * i + 2], "slot " + i);
                Near(Vertex(mesh, i, 1), -normals[3 * i], normals[3 * i + 1], normals[3 * i + 2], "normal " + i);
            }
            int head = plain.FindJoint(0, "head");
            float[] rows = new float[12];
            plain.GetScene(0, head, rows);
            Near(player.Joint("head").TransformPoint(new Vector3()), -rows[3], rows[7], rows[11], "the head");
        }
    }

    static float Lowest(UnityEngine.Mesh mesh) {
        float least = 1e9f;
        for (int i = 0; i < mesh.vertexCount; ++i) least = Math.Min(least, mesh.At(0, i, 1));
        return least;
    }

    static void BadFiles(AssetImportContext newt, string folder) {
        string name = Path.Combine(folder, "damaged.mrw");
        byte[] bytes = System.IO.File.ReadAllBytes(newt.assetPath);
        bytes[bytes.Length / 2] ^= 1;
        System.IO.File.WriteAllBytes(name, bytes);
        AssetImportContext damaged = Import(name);
        Expect(damaged.Errors.Count == 1 && damaged.Errors[0].Contains("damaged.mrw"), "the importer tells");
        Console.WriteLine("importer: " + damaged.Errors[0].Substring(folder.Length + 1));
        MarrowAsset asset = MarrowAsset.Make(bytes, "damaged.mrw");
        Debug.Said.Clear();
        MarrowPlayer player = Instance(newt, p => p.SetUp(asset, null));
        Expect(Debug.Said.Count == 1 && Debug.Said[0].StartsWith("error: damaged.mrw"), "the player tells");
        player.Advance(1);  // nothing to show
        GameObject.Destroy(player.gameObject);
        Debug.Said.Clear();
        player = Instance(newt, p => Set(p, "clip", "wlak"));
        Expect(Debug.Said.Count == 1 && Debug.Said[0].Contains("\"wlak\""), "a clip that there is not");
        Expect(player.transform.childCount == 0, "nothing is left of it");
        GameObject.Destroy(player.gameObject);
    }

    // Without Unity's renderer: says so, and the player skins to a Mesh.
    static void RenderEvent(AssetImportContext newt) {
        Debug.Said.Clear();
        MarrowPlayer player = Instance(newt);
        MarrowGles3Renderer renderer = player.gameObject.AddComponent<MarrowGles3Renderer>();
        Expect(!renderer.enabled && Debug.Said[0].Contains("Load on startup"), "it is not available");
        Expect(player.SkinsMeshes && player.transform.childCount == 6, "the player goes on");
        player.SkinsMeshes = false;
        Expect(player.Character != null && player.transform.childCount == 0, "poses alone");
        player.SkinsMeshes = true;
        Expect(player.transform.childCount == 6, "and skinned again");
        GameObject.Destroy(player.gameObject);
    }

    // ---- Unity's interfaces of plugins, for the library of the render event ----

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)] delegate int GetRenderer();
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)] delegate void Callback(IntPtr callback);
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)] delegate IntPtr Find(ulong high, ulong low);
    [DllImport("marrow_unity")] static extern void UnityPluginLoad(IntPtr[] interfaces);
    [DllImport("marrow_unity")] static extern void UnityPluginUnload();
    static readonly GetRenderer renderer = () => 11;  // OpenGL ES 3
    static readonly Callback ignored = callback => {};
    static readonly Find find = (high, low) => graphics;
    static readonly IntPtr graphics = Marshal.AllocHGlobal(4 * IntPtr.Size);

    static IntPtr Pointer(Delegate function) { return Marshal.GetFunctionPointerForDelegate(function); }

    // With it: the meshes are opened, each camera asks for an event a mesh, and all is closed before memory goes.
    static void RenderEventThere(AssetImportContext newt) {
        Marshal.Copy(new[] {Pointer(renderer), Pointer(ignored), Pointer(ignored), IntPtr.Zero}, 0, graphics, 4);
        UnityPluginLoad(new[] {IntPtr.Zero, IntPtr.Zero, Pointer(find), IntPtr.Zero});
        Expect(MarrowRenderEvent.Unavailable == "", "it is available, and says " + MarrowRenderEvent.Unavailable);
        MarrowPlayer player = Instance(newt);
        MarrowGles3Renderer drawn = player.gameObject.AddComponent<MarrowGles3Renderer>();
        Expect(drawn.enabled && !player.SkinsMeshes && player.transform.childCount == 0, "the player poses alone");
        Camera.current = new Camera();
        GL.Events.Clear();
        for (int frame = 1; frame <= 3; ++frame) {
            player.Advance(1.0f / 60);
            drawn.Send("LateUpdate");
            drawn.Send("OnRenderObject");
            Expect(GL.Events.Count == 6 * frame && !GL.Events.Contains(0), "an event a mesh");
        }
        Expect(drawn.Problem(0) == "", "no problem: " + drawn.Problem(0));
        player.Open(player.File);  // another character: the meshes of the one before are closed
        Expect(GL.Events.Count == 19 && GL.Events[18] == 0, "an event that deletes");
        drawn.Send("LateUpdate");
        drawn.Send("OnRenderObject");
        Expect(GL.Events.Count == 25, "and it goes on");
        drawn.enabled = false;
        Expect(player.SkinsMeshes && player.transform.childCount == 6, "the player skins again");
        GameObject.Destroy(player.gameObject);
        UnityEngine.Object.Destroy(Camera.current);
        UnityPluginUnload();
    }

    // A pack's clips play, and nothing is culled by boxes that do not know them.
    static void Pack(AssetImportContext newt, AssetImportContext pack) {
        Expect(pack.Errors.Count == 0 && pack.Objects.Count == 2, "a pack is a file without meshes");
        MarrowAsset asset = (MarrowAsset)pack.Objects["file"];
        MarrowPlayer player = Instance(newt), quiet = Instance(pack);
        quiet.Advance(1);
        using (MarrowClips clips = player.File.ClipsOf(asset.File)) {
            Expect(MeshOf(player, "body").bounds.extents.x < 2, "the file's box");
            player.Play(clips["walk"], 0);
            player.Advance(0.1f);
            Expect(MeshOf(player, "body").bounds.extents.x == 100, "no box");
        }
        GameObject.Destroy(player.gameObject);
        GameObject.Destroy(quiet.gameObject);
    }

    static void MoreWays(string path) {
        Application.isPlaying = false;
        Shader.There.Clear();
        GameObject empty = new GameObject("empty");
        MarrowPlayer player = empty.AddComponent<MarrowPlayer>();
        try {
            player.Play("walk");
            throw new Exception("nothing plays");
        } catch (InvalidOperationException) {}
        using (MarrowFile file = MarrowFile.Load(path)) player.Open(file);
        player.Advance(0.5f);
        Expect(MeshOf(player, "body") != null, "without a shader there is a mesh");
        player.SkinsMeshes = false;  // begins anew, with a file that nobody else has any more
        player.SkinsMeshes = true;
        player.Advance(0.5f);
        GameObject.Destroy(empty);
        Application.isPlaying = true;
    }

    public static int Main(string[] args) {
        AssetImportContext newt = Import(args[0]), corner = Import(args[1]), pack = Import(args[2]);
        Expect(newt.Errors.Count == 0 && newt.Objects.Count == 8, "a file, six materials, an object");
        int alive = UnityEngine.Object.Alive;
        Corner(corner);
        Rig(corner);
        Newt(newt);
        RenderEvent(newt);
        RenderEventThere(newt);
        Pack(newt, pack);
        MoreWays(args[0]);
        Expect(UnityEngine.Object.Alive == alive, "objects left: " + (UnityEngine.Object.Alive - alive));
        GraphTests(newt, args[4], args[5], args[6]);
        BadFiles(newt, args[3]);
        Expect(Counted.Open == 0, "native arrays left: " + Counted.Open);
        Console.WriteLine("player: mirrored right, no allocation a frame, nothing left behind");
        return 0;
    }
}
