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
