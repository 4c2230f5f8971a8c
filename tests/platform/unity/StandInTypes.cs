// Of UnityEngine what the package uses of plain types, written by hand from Unity's manual, so that the package can be
// compiled and run without Unity.
using System;
using System.Runtime.InteropServices;

namespace UnityEngine {

public struct Vector3 {
    public float x, y, z;
    public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
    public float magnitude { get { return (float)Math.Sqrt(Dot(this, this)); } }
    public static Vector3 Scale(Vector3 a, Vector3 b) { return new Vector3(a.x * b.x, a.y * b.y, a.z * b.z); }
    public static Vector3 operator +(Vector3 a, Vector3 b) { return new Vector3(a.x + b.x, a.y + b.y, a.z + b.z); }
    public static Vector3 operator -(Vector3 a, Vector3 b) { return new Vector3(a.x - b.x, a.y - b.y, a.z - b.z); }
    public static Vector3 operator *(float s, Vector3 a) { return new Vector3(s * a.x, s * a.y, s * a.z); }
    public static Vector3 Cross(Vector3 a, Vector3 b) {
        return new Vector3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    }
    public static float Dot(Vector3 a, Vector3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    public override string ToString() { return x + " " + y + " " + z; }
}

public struct Vector4 {
    public float x, y, z, w;
    public Vector4(float x, float y, float z, float w) { this.x = x; this.y = y; this.z = z; this.w = w; }
}

public static class Mathf {
    public static float Sin(float x) { return (float)Math.Sin(x); }
    public static float Clamp(float x, float least, float most) { return Math.Min(Math.Max(x, least), most); }
}

public struct Quaternion {
    public float x, y, z, w;
    public Quaternion(float x, float y, float z, float w) { this.x = x; this.y = y; this.z = z; this.w = w; }
    public static Quaternion AngleAxis(float degrees, Vector3 axis) {
        float half = degrees * (float)Math.PI / 360, s = (float)Math.Sin(half);
        return new Quaternion(s * axis.x, s * axis.y, s * axis.z, (float)Math.Cos(half));
    }
    public Quaternion normalized {
        get {
            float s = 1 / (float)Math.Sqrt(x * x + y * y + z * z + w * w);
            return new Quaternion(s * x, s * y, s * z, s * w);
        }
    }
    // For what is compiled and not run.
    public static Quaternion LookRotation(Vector3 forward) { throw new NotImplementedException(); }
    public static Quaternion RotateTowards(Quaternion from, Quaternion to, float most) {
        throw new NotImplementedException();
    }
    public static Quaternion operator *(Quaternion a, Quaternion b) {
        return new Quaternion(a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                              a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                              a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
                              a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z);
    }
    public static Vector3 operator *(Quaternion q, Vector3 v) {
        Vector3 u = new Vector3(q.x, q.y, q.z);
        Vector3 t = 2 * Vector3.Cross(u, v);
        return v + q.w * t + Vector3.Cross(u, t);
    }
}

// Columns, as Unity keeps them.
[StructLayout(LayoutKind.Sequential)]
public struct Matrix4x4 {
    public float m00, m10, m20, m30, m01, m11, m21, m31, m02, m12, m22, m32, m03, m13, m23, m33;
    public static unsafe Matrix4x4 operator *(Matrix4x4 a, Matrix4x4 b) {
        Matrix4x4 made = new Matrix4x4();
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r)
                for (int k = 0; k < 4; ++k) (&made.m00)[4 * c + r] += (&a.m00)[4 * k + r] * (&b.m00)[4 * c + k];
        return made;
    }
    public static Matrix4x4 Scale(Vector3 by) {
        Matrix4x4 made = new Matrix4x4();
        made.m00 = by.x;
        made.m11 = by.y;
        made.m22 = by.z;
        made.m33 = 1;
        return made;
    }
    public static Matrix4x4 identity { get { return Scale(new Vector3(1, 1, 1)); } }
}

public struct Color {
    public float r, g, b, a;
    public Color(float r, float g, float b, float a) { this.r = r; this.g = g; this.b = b; this.a = a; }
    public Color gamma { get { return new Color(Encoded(r), Encoded(g), Encoded(b), a); } }
    static float Encoded(float v) {
        return v <= 0.0031308f ? 12.92f * v : 1.055f * (float)Math.Pow(v, 1 / 2.4) - 0.055f;
    }
}

public struct Bounds {
    public Vector3 center, extents;
    public void SetMinMax(Vector3 least, Vector3 most) {
        extents = 0.5f * (most - least);
        center = least + extents;
    }
}

[Flags]
public enum HideFlags { None = 0, NotEditable = 8, DontSave = 52, HideAndDontSave = 61 }
public enum MeshTopology { Triangles = 0 }

public sealed class SerializeField : Attribute {}
public sealed class HideInInspector : Attribute {}
public sealed class ExecuteAlways : Attribute {}
public sealed class DisallowMultipleComponent : Attribute {}
public sealed class TooltipAttribute : Attribute { public TooltipAttribute(string text) {} }
public sealed class AddComponentMenu : Attribute { public AddComponentMenu(string name) {} }
public sealed class DefaultExecutionOrder : Attribute { public DefaultExecutionOrder(int order) {} }
public sealed class RequireComponent : Attribute { public RequireComponent(Type type) {} }

}

namespace UnityEngine.Rendering {

public enum VertexAttribute { Position, Normal, Tangent, Color, TexCoord0 }
public enum VertexAttributeFormat { Float32, Float16, UNorm8 }
public enum IndexFormat { UInt16, UInt32 }
[Flags]
public enum MeshUpdateFlags {
    Default = 0, DontValidateIndices = 1, DontResetBoneBounds = 2, DontNotifyMeshUsers = 4, DontRecalculateBounds = 8
}
public struct VertexAttributeDescriptor {
    public VertexAttribute attribute;
    public VertexAttributeFormat format;
    public int dimension, stream;
    public VertexAttributeDescriptor(VertexAttribute attribute, VertexAttributeFormat format, int dimension,
                                     int stream) {
        this.attribute = attribute;
        this.format = format;
        this.dimension = dimension;
        this.stream = stream;
    }
    public int Bytes { get { return format == VertexAttributeFormat.UNorm8 ? dimension : 4 * dimension; } }
}

}

namespace Unity.Collections {

public enum Allocator { Persistent = 4 }

// Unity counts what is not disposed of; so does this.
public unsafe struct NativeArray<T> where T : struct {
    internal void* memory;
    public int Length { get; private set; }
    public bool IsCreated { get { return memory != null; } }
    public NativeArray(int length, Allocator allocator) : this() {
        memory = (void*)Marshal.AllocHGlobal(length * Marshal.SizeOf(typeof(T)));
        Length = length;
        ++Counted.Open;
    }
    public void Dispose() {
        if (memory == null) throw new ObjectDisposedException("NativeArray");
        Marshal.FreeHGlobal((IntPtr)memory);
        memory = null;
        --Counted.Open;
    }
}

public static class Counted { public static int Open; }

}

namespace Unity.Collections.LowLevel.Unsafe {

public static unsafe class NativeArrayUnsafeUtility {
    public static void* GetUnsafePtr<T>(this Unity.Collections.NativeArray<T> of) where T : struct { return of.memory; }
}

}
