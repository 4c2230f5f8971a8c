using UnityEngine;

namespace MarrowAnimation {

/// <summary>
/// Draws the player beside it on the render thread: skinned by the GPU, in the plain look of platform/unity/native.
/// Where the graphics device is not OpenGL ES 3 it says so once, and leaves the player to skin to a Mesh.
/// </summary>
[RequireComponent(typeof(MarrowPlayer)), DefaultExecutionOrder(-40), AddComponentMenu("Marrow/Marrow GLES3 Renderer")]
public sealed unsafe class MarrowGles3Renderer : MonoBehaviour {
    MarrowPlayer player;
    int[] handles = new int[0];

    void OnEnable() {
        player = GetComponent<MarrowPlayer>();
        string why = MarrowRenderEvent.Unavailable;
        if (why.Length > 0) {
            Debug.LogWarning(name + ": no drawing on the render thread: " + why, this);
            enabled = false;
            return;
        }
        player.Closing += Close;
        player.SkinsMeshes = false;
    }

    void OnDisable() {
        Close();
        if (player == null) return;
        player.Closing -= Close;
        player.SkinsMeshes = true;
    }

    void Open(MarrowCharacter character) {
        handles = new int[character.MeshCount];
        for (int i = 0; i < handles.Length; ++i) {
            handles[i] = MarrowRenderEvent.Open(character.Mesh(i).Native);
            if (handles[i] == 0)
                Debug.LogError(name + ": \"" + character.Mesh(i).Name + "\": no more than 256 can be drawn", this);
        }
    }

    // The render thread is done with the character after this.
    void Close() {
        if (handles.Length == 0) return;
        foreach (int handle in handles) MarrowRenderEvent.Close(handle);
        handles = new int[0];
        GL.IssuePluginEvent(MarrowRenderEvent.Callback, 0);
    }

    void LateUpdate() {
        MarrowCharacter character = player.Character;
        if (character == null) return;
        if (handles.Length == 0) Open(character);
        for (int i = 0; i < handles.Length; ++i)
            MarrowRenderEvent.Pose(handles[i], &character.Native->skeletons[character.Mesh(i).Skeleton],
                                   &character.Native->meshes[i]);
    }

    void OnRenderObject() {
        Matrix4x4 mirror = Matrix4x4.Scale(new Vector3(-1, 1, 1));
        Camera camera = Camera.current;
        Matrix4x4 clipFromModel = GL.GetGPUProjectionMatrix(camera.projectionMatrix, true) *
                                  camera.worldToCameraMatrix * transform.localToWorldMatrix * mirror;
        for (int i = 0; i < handles.Length; ++i) {
            int id = MarrowRenderEvent.Request(handles[i], (float*)&clipFromModel);
            if (id > 0) GL.IssuePluginEvent(MarrowRenderEvent.Callback, id);
        }
    }

    /// <summary>
    /// What keeps a mesh from being drawn, such as a text that the driver does not take; empty: nothing.
    /// </summary>
    public string Problem(int mesh) { return mesh < handles.Length ? MarrowRenderEvent.Problem(handles[mesh]) : ""; }
}

}
