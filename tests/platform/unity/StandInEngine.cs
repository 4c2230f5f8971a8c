// Of UnityEngine what the package uses of objects, written by hand from Unity's manual. A mesh checks what Unity
// checks: the order of attributes, the sizes of streams, the range of indices.
using System;
using System.Collections.Generic;
using System.Reflection;
using System.Runtime.InteropServices;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using UnityEngine.Rendering;

namespace UnityEngine {

public class Object {
    public virtual string name { get; set; } = "";
    public HideFlags hideFlags { get; set; }
    internal bool gone;
    public static int Alive;
    public Object() { ++Alive; }
    public static void Destroy(Object what) { what.Go(); }
    public static void DestroyImmediate(Object what) { what.Go(); }
    internal virtual void Go() {
        if (gone) throw new Exception(name + " is destroyed twice");
        gone = true;
        --Alive;
    }
    // What is destroyed counts as null.
    public static bool operator ==(Object a, Object b) {
        bool noA = ReferenceEquals(a, null) || a.gone, noB = ReferenceEquals(b, null) || b.gone;
        return noA || noB ? noA == noB : ReferenceEquals(a, b);
    }
    public static bool operator !=(Object a, Object b) { return !(a == b); }
    public override bool Equals(object other) { return ReferenceEquals(this, other); }
    public override int GetHashCode() { return base.GetHashCode(); }
    public void Send(string message) {
        MethodInfo method = GetType().GetMethod(message, BindingFlags.Instance | BindingFlags.NonPublic |
                                                         BindingFlags.Public);
        if (method != null) method.Invoke(this, null);
    }
}

public class ScriptableObject : Object {
    public static T CreateInstance<T>() where T : ScriptableObject, new() { return new T(); }
    internal override void Go() { Send("OnDisable"); base.Go(); }
}

public class Component : Object {
    public GameObject gameObject { get; internal set; }
    public Transform transform { get { return gameObject.transform; } }
    public override string name { get { return gameObject.name; } set { gameObject.name = value; } }
    public T GetComponent<T>() where T : Component { return gameObject.GetComponent<T>(); }
    public T[] GetComponentsInChildren<T>(bool inactiveToo) where T : Component {
        List<T> found = new List<T>();
        gameObject.Collect(found);
        return found.ToArray();
    }
}

public class Behaviour : Component {
    bool on = true;
    public bool enabled {
        get { return on; }
        set {
            if (on == value) return;
            on = value;
            Send(value ? "OnEnable" : "OnDisable");
        }
    }
    internal override void Go() { enabled = false; base.Go(); }
}
public class MonoBehaviour : Behaviour {}
public class MeshFilter : Component { public Mesh sharedMesh; }
public class MeshRenderer : Component { public Material sharedMaterial; }

public sealed class Transform : Component {
    public Vector3 localPosition, localScale = new Vector3(1, 1, 1);
    public Quaternion localRotation = new Quaternion(0, 0, 0, 1);
    public Vector3 position { get { return TransformPoint(new Vector3()); } }
    public Quaternion rotation { get { return localRotation; } set { localRotation = value; } }  // without a parent
    public Transform parent { get; private set; }
    internal readonly List<Transform> children = new List<Transform>();
    public int childCount { get { return children.Count; } }
    public void SetParent(Transform to, bool worldPositionStays) {
        if (parent != null) parent.children.Remove(this);
        parent = to;
        if (to != null) to.children.Add(this);
    }
    public Vector3 TransformPoint(Vector3 p) {
        p = localPosition + localRotation * Vector3.Scale(localScale, p);
        return parent == null ? p : parent.TransformPoint(p);
    }
    public Matrix4x4 localToWorldMatrix { get { return Matrix4x4.identity; } }
    internal override void Go() {
        SetParent(null, false);
        base.Go();
    }
}

public sealed class GameObject : Object {
    readonly List<Component> components = new List<Component>();
    public Transform transform { get; private set; }
    public GameObject(string name = "") {
        this.name = name;
        transform = AddComponent<Transform>();
    }
    public T AddComponent<T>() where T : Component, new() {
        T made = new T();
        made.gameObject = this;
        components.Add(made);
        if (made is MonoBehaviour) made.Send("OnEnable");
        return made;
    }
    public T GetComponent<T>() where T : Component {
        foreach (Component one in components)
            if (one is T) return (T)one;
        return null;
    }
    internal void Collect<T>(List<T> found) where T : Component {
        foreach (Component one in components)
            if (one is T) found.Add((T)one);
        foreach (Transform child in transform.children) child.gameObject.Collect(found);
    }
    public Transform Find(string path) { return transform.children.Find(c => c.name == path); }
    internal override void Go() {
        while (transform.children.Count > 0) transform.children[0].gameObject.Go();
        for (int i = components.Count - 1; i >= 0; --i)
            if (!components[i].gone) components[i].Go();
        base.Go();
    }
}

public sealed unsafe class Mesh : Object {
    public Bounds bounds;
    public IndexFormat indexFormat;
    public int vertexCount { get; private set; }
    public byte[][] streams = new byte[0][];
    public VertexAttributeDescriptor[] layout = new VertexAttributeDescriptor[0];
    public int[] indices = new int[0];
    public bool dynamic;
    public void MarkDynamic() { dynamic = true; }

    public void SetVertexBufferParams(int count, params VertexAttributeDescriptor[] layout) {
        vertexCount = count;
        this.layout = layout;
        streams = new byte[4][];
        for (int i = 0; i < layout.Length; ++i) {
            if (i > 0 && layout[i].attribute <= layout[i - 1].attribute) throw new Exception("attributes out of order");
            int bytes = streams[layout[i].stream] == null ? 0 : streams[layout[i].stream].Length;
            streams[layout[i].stream] = new byte[bytes + count * layout[i].Bytes];
        }
    }

    public void SetVertexBufferData<T>(NativeArray<T> data, int dataStart, int meshStart, int count, int stream,
                                       MeshUpdateFlags flags) where T : struct {
        if (dataStart != 0 || meshStart != 0 || count != vertexCount || data.Length < count)
            throw new Exception("not all of a stream");
        int bytes = streams[stream].Length;
        if (bytes != count * SizeOf(stream)) throw new Exception("the size of stream " + stream);
        Marshal.Copy((IntPtr)data.GetUnsafePtr(), streams[stream], 0, bytes);
    }

    int SizeOf(int stream) {
        int bytes = 0;
        for (int i = 0; i < layout.Length; ++i) bytes += layout[i].stream == stream ? layout[i].Bytes : 0;
        return bytes;
    }

    public void SetIndices(int[] indices, MeshTopology topology, int submesh, bool calculateBounds) {
        foreach (int index in indices)
            if (index < 0 || index >= vertexCount || (indexFormat == IndexFormat.UInt16 && index > 65535))
                throw new Exception("an index out of range");
        this.indices = indices;
    }

    // Float k of a vertex in a stream.
    public float At(int stream, int vertex, int k) {
        return BitConverter.ToSingle(streams[stream], vertex * SizeOf(stream) + 4 * k);
    }
}

public sealed class Shader : Object {
    public static readonly List<string> There = new List<string> {"Standard"};
    public static Shader Find(string name) { return There.Contains(name) ? new Shader() : null; }
}

public sealed class Material : Object {
    public Color color;
    public Material(Shader shader) { Destroy(shader); }
    public bool HasProperty(string name) { return false; }
    public void SetFloat(string name, float value) {}
}

public sealed class CharacterController : Component { public void Move(Vector3 motion) {} }

public sealed class Camera : Behaviour {
    public static Camera current;
    public Matrix4x4 projectionMatrix = Matrix4x4.identity, worldToCameraMatrix = Matrix4x4.identity;
}

public static class GL {
    public static readonly List<int> Events = new List<int>();
    public static Matrix4x4 GetGPUProjectionMatrix(Matrix4x4 projection, bool intoTexture) { return projection; }
    public static void IssuePluginEvent(IntPtr callback, int id) { Events.Add(id); }
}

public static class Application { public static bool isPlaying = true; }
public static class Time { public static float deltaTime = 1.0f / 60, time; }

public static class Debug {
    public static readonly List<string> Said = new List<string>();
    public static void LogError(object message, Object about) { Said.Add("error: " + message); }
    public static void LogWarning(object message, Object about) { Said.Add("warning: " + message); }
}

}

namespace UnityEngine.Events {

public class UnityEvent<A, B, C> {
    Action<A, B, C> listeners;
    public void AddListener(Action<A, B, C> listener) { listeners += listener; }
    public void Invoke(A a, B b, C c) { if (listeners != null) listeners(a, b, c); }
}

}

namespace UnityEditor.AssetImporters {

public sealed class ScriptedImporterAttribute : Attribute {
    public ScriptedImporterAttribute(int version, string extension) {}
}
public abstract class ScriptedImporter : UnityEngine.Object {
    public abstract void OnImportAsset(AssetImportContext context);
}
public sealed class AssetImportContext {
    public string assetPath;
    public readonly Dictionary<string, UnityEngine.Object> Objects = new Dictionary<string, UnityEngine.Object>();
    public readonly List<string> Errors = new List<string>();
    public UnityEngine.Object Main;
    public void AddObjectToAsset(string id, UnityEngine.Object what) { Objects.Add(id, what); }
    public void SetMainObject(UnityEngine.Object what) { Main = what; }
    public void LogImportError(string message) { Errors.Add(message); }
}

}
