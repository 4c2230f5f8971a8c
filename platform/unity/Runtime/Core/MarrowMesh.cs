using System;
using MarrowRuntime;

namespace MarrowAnimation {

/// <summary>What of a character's mesh does not move: triangles, texture coordinates, colours, material.</summary>
public sealed unsafe class MarrowMesh {
    readonly MarrowCharacter character;
    readonly MarrowSpace space;

    internal int Index { get; private set; }
    public string Name { get; private set; }
    public string MaterialName { get; private set; }
    public int Skeleton { get; private set; }
    /// <summary>Vertices, of which some fill up blocks of four: indices count them all.</summary>
    public int SlotCount { get; private set; }
    public int IndexCount { get; private set; }
    public bool HasNormals { get; private set; }
    public bool HasTangents { get; private set; }
    public bool HasUvs { get; private set; }
    public bool HasColours { get; private set; }
    public bool DoubleSided { get; private set; }

    internal MarrowMesh(MarrowCharacter character, int index, MarrowSpace space) {
        this.character = character;
        this.space = space;
        Index = index;
        MarrowRuntime.Mesh* mesh = Native;
        Name = Marrow.Text(mesh->name);
        MaterialName = mesh->material == null ? "" : Marrow.Text(mesh->material);
        Skeleton = (int)mesh->skeleton;
        SlotCount = (int)mesh->geometry.slot_count;
        IndexCount = (int)mesh->geometry.index_count;
        HasNormals = mesh->geometry.normals != null;
        HasTangents = mesh->geometry.tangents != null;
        HasUvs = mesh->geometry.uvs != null;
        HasColours = mesh->geometry.colours != null;
        DoubleSided = mesh->double_sided != 0;
    }

    /// <summary>For calls of MarrowRuntime.Marrow; as long as the character is there.</summary>
    public MarrowRuntime.Mesh* Native { get { return &character.Native->meshes[Index].mesh; } }

    /// <summary>Red, green, blue, alpha; linear. What is not in a texture.</summary>
    public void GetBaseColour(float[] rgba) {
        for (int i = 0; i < 4; ++i) rgba[i] = Native->base_colour[i];
    }

    /// <summary>
    /// Three a triangle. Fronts are those whose corners a, b, c make (b - a) × (c - a) point outwards in the numbers of
    /// the character's space: so Unity sees them clockwise, glTF the other way round.
    /// </summary>
    public int[] MakeIndices() {
        Geometry* geometry = &Native->geometry;
        int[] made = new int[IndexCount];
        for (int i = 0; i < made.Length; ++i) {
            made[i] = geometry->index_bytes == 2 ? ((ushort*)geometry->indices)[i]
                                                 : (int)((uint*)geometry->indices)[i];
        }
        for (int i = 0; space == MarrowSpace.Unity && i + 2 < made.Length; i += 3) {
            int second = made[i + 1];
            made[i + 1] = made[i + 2];
            made[i + 2] = second;
        }
        return made;
    }

    /// <summary>
    /// 12 bytes a slot: red, green, blue, alpha as bytes, then u and v as floats. White and zeros where there are none.
    /// </summary>
    public void CopySurface(byte* to) {
        Geometry* geometry = &Native->geometry;
        for (int i = 0; i < SlotCount; ++i, to += 12) {
            for (int k = 0; k < 4; ++k) to[k] = HasColours ? geometry->colours[4 * i + k] : (byte)255;
            float* uv = (float*)(to + 4);
            uv[0] = HasUvs ? geometry->uvs[2 * i] : 0;
            uv[1] = HasUvs ? geometry->uvs[2 * i + 1] : 0;
            if (space == MarrowSpace.Unity && HasUvs) uv[1] = 1 - uv[1];
        }
    }
}

}
