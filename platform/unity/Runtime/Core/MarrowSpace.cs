using System;
using MarrowRuntime;

namespace MarrowAnimation {

/// <summary>Whose axes and texture coordinates numbers are in.</summary>
public enum MarrowSpace {
    /// <summary>As cooked: x to the character's left, y up, z forward, right-handed; v downwards.</summary>
    Gltf,
    /// <summary>x mirrored, which makes it left-handed: a character still looks along z; v upwards.</summary>
    Unity,
}

/// <summary>A transform of a joint: parent_from_joint = translate · rotate · scale.</summary>
public struct MarrowTransform {
    public float Px, Py, Pz;
    /// <summary>A unit quaternion.</summary>
    public float Rx, Ry, Rz, Rw;
    public float Sx, Sy, Sz;

    /// <summary>
    /// Of three rows of four. False if the map shears, which no such transform can: then the nearest axes.
    /// </summary>
    public static bool TryMake(float[] rows, out MarrowTransform made) {
        made = default(MarrowTransform);
        made.Px = rows[3];
        made.Py = rows[7];
        made.Pz = rows[11];
        made.Sx = Length(rows[0], rows[4], rows[8]);
        made.Sy = Length(rows[1], rows[5], rows[9]);
        made.Sz = Length(rows[2], rows[6], rows[10]);
        made.Rw = 1;
        if (made.Sx < 1e-9f || made.Sy < 1e-9f || made.Sz < 1e-9f) return false;
        float xx = rows[0] / made.Sx, yx = rows[4] / made.Sx, zx = rows[8] / made.Sx;
        float xy = rows[1] / made.Sy, yy = rows[5] / made.Sy, zy = rows[9] / made.Sy;
        float xz = rows[2] / made.Sz, yz = rows[6] / made.Sz, zz = rows[10] / made.Sz;
        float volume = xx * (yy * zz - yz * zy) - xy * (yx * zz - yz * zx) + xz * (yx * zy - yy * zx);
        if (volume < 0) {  // a mirror: along x
            made.Sx = -made.Sx;
            xx = -xx;
            yx = -yx;
            zx = -zx;
        }
        // Four times the squares of x, y, z, w; by the largest the others.
        float x = 1 + xx - yy - zz, y = 1 - xx + yy - zz, z = 1 - xx - yy + zz, w = 1 + xx + yy + zz;
        if (w >= x && w >= y && w >= z) made.SetRotation(zy - yz, xz - zx, yx - xy, w);
        else if (x >= y && x >= z) made.SetRotation(x, xy + yx, xz + zx, zy - yz);
        else if (y >= z) made.SetRotation(xy + yx, y, yz + zy, xz - zx);
        else made.SetRotation(xz + zx, yz + zy, z, yx - xy);
        float shear = Math.Abs(xx * xy + yx * yy + zx * zy) + Math.Abs(xx * xz + yx * yz + zx * zz) +
                      Math.Abs(xy * xz + yy * yz + zy * zz);
        return shear < 1e-4f;
    }

    static float Length(float x, float y, float z) { return (float)Math.Sqrt(x * x + y * y + z * z); }

    void SetRotation(float x, float y, float z, float w) {
        float length = (float)Math.Sqrt(x * x + y * y + z * z + w * w);
        Rx = x / length;
        Ry = y / length;
        Rz = z / length;
        Rw = w / length;
    }
}

/// <summary>
/// The mirror x → -x between both spaces, which is its own inverse. With M = diag(-1, 1, 1) a point p becomes M p and a
/// map A becomes M A M; so a rotation about the axis a by an angle becomes one about -M a by the same angle.
/// </summary>
public static class MarrowMirror {
    public static MarrowTransform Mirrored(MarrowTransform t) {
        t.Px = -t.Px;
        t.Ry = -t.Ry;
        t.Rz = -t.Rz;
        return t;
    }

    /// <summary>M A: takes points of glTF's space to those of Unity's.</summary>
    internal static unsafe void MirrorResult(Affine* map) {
        for (int i = 0; i < 4; ++i) map->rows[i] = -map->rows[i];
    }

    /// <summary>M A M.</summary>
    internal static unsafe void MirrorBoth(Affine* map) {
        map->rows[1] = -map->rows[1];
        map->rows[2] = -map->rows[2];
        map->rows[3] = -map->rows[3];
        map->rows[4] = -map->rows[4];
        map->rows[8] = -map->rows[8];
    }
}

}
