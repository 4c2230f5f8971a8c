using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using UnityEngine;
using UnityEngine.Rendering;

namespace MarrowAnimation {

/// <summary>A Unity mesh that one of a character's meshes is skinned into, and the object that shows it.</summary>
internal sealed unsafe class MarrowSkin {
    const MeshUpdateFlags Quietly = MeshUpdateFlags.DontValidateIndices | MeshUpdateFlags.DontRecalculateBounds |
                                    MeshUpdateFlags.DontNotifyMeshUsers | MeshUpdateFlags.DontResetBoneBounds;
    const float Far = 100;  // metres: always in sight
    readonly int index, slots;
    readonly GameObject shown;
    readonly UnityEngine.Mesh mesh;
    readonly Material made;
    // A stream of the vertex buffer each.
    NativeArray<Vector3> positions, normals;
    NativeArray<Vector4> tangents;

    internal MarrowSkin(MarrowCharacter character, int index, MarrowFile file, Transform parent, Material material) {
        MarrowMesh source = character.Mesh(index);
        this.index = index;
        slots = source.SlotCount;
        positions = new NativeArray<Vector3>(slots, Allocator.Persistent);
        if (source.HasNormals) normals = new NativeArray<Vector3>(slots, Allocator.Persistent);
        if (source.HasTangents && source.HasNormals)
            tangents = new NativeArray<Vector4>(slots, Allocator.Persistent);
        mesh = new UnityEngine.Mesh();
        mesh.name = source.Name;
        mesh.hideFlags = HideFlags.HideAndDontSave;
        mesh.MarkDynamic();
        SetUp(source);
        mesh.bounds = BoxOf(file, index);
        if (material == null) material = made = MarrowMaterials.Make(source);
        if (made != null) made.hideFlags = HideFlags.HideAndDontSave;
        shown = new GameObject(source.Name);
        shown.hideFlags = HideFlags.DontSave | HideFlags.NotEditable;
        shown.transform.SetParent(parent, false);
        shown.AddComponent<MeshFilter>().sharedMesh = mesh;
        shown.AddComponent<MeshRenderer>().sharedMaterial = material;
    }

    // Attributes of a stream stand in the order of Unity's enum: colour before texture coordinates.
    void SetUp(MarrowMesh source) {
        int streams = 1 + (normals.IsCreated ? 1 : 0) + (tangents.IsCreated ? 1 : 0), at = 0;
        VertexAttributeDescriptor[] layout = new VertexAttributeDescriptor[streams + 2];
        layout[at] = new VertexAttributeDescriptor(VertexAttribute.Position, VertexAttributeFormat.Float32, 3, at++);
        if (normals.IsCreated)
            layout[at] = new VertexAttributeDescriptor(VertexAttribute.Normal, VertexAttributeFormat.Float32, 3, at++);
        if (tangents.IsCreated)
            layout[at] = new VertexAttributeDescriptor(VertexAttribute.Tangent, VertexAttributeFormat.Float32, 4, at++);
        layout[at] = new VertexAttributeDescriptor(VertexAttribute.Color, VertexAttributeFormat.UNorm8, 4, streams);
        layout[at + 1] =
            new VertexAttributeDescriptor(VertexAttribute.TexCoord0, VertexAttributeFormat.Float32, 2, streams);
        mesh.SetVertexBufferParams(slots, layout);
        NativeArray<Vector3> surface = new NativeArray<Vector3>(slots, Allocator.Persistent);  // 12 bytes each
        source.CopySurface((byte*)surface.GetUnsafePtr());
        mesh.SetVertexBufferData(surface, 0, 0, slots, streams, Quietly);
        surface.Dispose();
        mesh.indexFormat = slots > 65535 ? IndexFormat.UInt32 : IndexFormat.UInt16;
        mesh.SetIndices(source.MakeIndices(), MeshTopology.Triangles, 0, false);
    }

    static Bounds BoxOf(MarrowFile file, int index) {
        float[] least = new float[3], largest = new float[3];
        Bounds box = new Bounds();
        if (file.TryGetBox(index, MarrowSpace.Unity, least, largest))
            box.SetMinMax(new Vector3(least[0], least[1], least[2]), new Vector3(largest[0], largest[1], largest[2]));
        else
            box.extents = new Vector3(Far, Far, Far);
        return box;
    }

    internal void NeverCull() {
        Bounds box = new Bounds();
        box.extents = new Vector3(Far, Far, Far);
        mesh.bounds = box;
    }

    /// <summary>After MarrowCharacter.Finish(). Allocates nothing.</summary>
    internal void Show(MarrowCharacter character) {
        character.Skin(index, (float*)positions.GetUnsafePtr(),
                       normals.IsCreated ? (float*)normals.GetUnsafePtr() : null,
                       tangents.IsCreated ? (float*)tangents.GetUnsafePtr() : null);
        int stream = 0;
        mesh.SetVertexBufferData(positions, 0, 0, slots, stream++, Quietly);
        if (normals.IsCreated) mesh.SetVertexBufferData(normals, 0, 0, slots, stream++, Quietly);
        if (tangents.IsCreated) mesh.SetVertexBufferData(tangents, 0, 0, slots, stream, Quietly);
    }

    internal void Destroy() {
        MarrowPlayer.Remove(shown);
        MarrowPlayer.Remove(mesh);
        MarrowPlayer.Remove(made);
        positions.Dispose();
        if (normals.IsCreated) normals.Dispose();
        if (tangents.IsCreated) tangents.Dispose();
    }
}

}
