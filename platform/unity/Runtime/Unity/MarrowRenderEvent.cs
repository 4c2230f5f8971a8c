using System;
using System.Runtime.InteropServices;
using UnityEngine;

namespace MarrowAnimation {

/// <summary>The library marrow_unity, which draws on Unity's render thread where that has OpenGL ES 3.</summary>
public static unsafe class MarrowRenderEvent {
#if (UNITY_IOS || UNITY_TVOS || UNITY_VISIONOS || UNITY_WEBGL) && !UNITY_EDITOR
    // Not linked: Unity has no OpenGL ES 3 there, or no render thread.
    /// <summary>Why nothing can be drawn; empty if it can.</summary>
    public static string Unavailable { get { return "there is no marrow_unity for this system: skin to a Mesh"; } }
    internal static IntPtr Callback { get { return IntPtr.Zero; } }
    internal static int Open(MarrowRuntime.Mesh* mesh) { return 0; }
    internal static void Pose(int handle, MarrowRuntime.CharacterSkeleton* skeleton,
                              MarrowRuntime.CharacterMesh* mesh) {}
    internal static int Request(int handle, float* clipFromModel) { return 0; }
    internal static string Problem(int handle) { return ""; }
    internal static void Close(int handle) {}
#else
    const string Library = "marrow_unity";

    [DllImport(Library)] static extern uint marrow_unity_abi();
    [DllImport(Library)] static extern byte* marrow_unity_unavailable();
    [DllImport(Library)] static extern IntPtr marrow_unity_render_event();
    [DllImport(Library)] static extern int marrow_unity_open(MarrowRuntime.Mesh* mesh);
    [DllImport(Library)]
    static extern MarrowRuntime.Status marrow_unity_pose(int handle, MarrowRuntime.Affine* joints, UIntPtr jointCount,
                                                         float* weights, UIntPtr weightCount);
    [DllImport(Library)] static extern int marrow_unity_request(int handle, float* clipFromModel);
    [DllImport(Library)] static extern MarrowRuntime.Status marrow_unity_status(int handle);
    [DllImport(Library)] static extern byte* marrow_unity_log();
    [DllImport(Library)] static extern void marrow_unity_close(int handle);

    /// <summary>Why nothing can be drawn, and what to do; empty if it can.</summary>
    public static string Unavailable {
        get {
            try {
                if (marrow_unity_abi() != MarrowRuntime.Marrow.Gles3AbiNumber)
                    return "marrow_unity is of another release than Marrow.cs: take both from one";
                return MarrowRuntime.Marrow.Text(marrow_unity_unavailable());
            } catch (DllNotFoundException) {
                return "there is no marrow_unity for this system and processor: skin to a Mesh";
            }
        }
    }

    internal static IntPtr Callback { get { return marrow_unity_render_event(); } }
    internal static int Open(MarrowRuntime.Mesh* mesh) { return marrow_unity_open(mesh); }
    internal static void Pose(int handle, MarrowRuntime.CharacterSkeleton* skeleton,
                              MarrowRuntime.CharacterMesh* mesh) {
        marrow_unity_pose(handle, skeleton->pose.model_from_joint, skeleton->pose.model_from_joint_count, mesh->weights,
                          mesh->weight_count);
    }
    internal static int Request(int handle, float* clipFromModel) {
        return marrow_unity_request(handle, clipFromModel);
    }

    /// <summary>What keeps a mesh from being drawn; empty: nothing that lasts.</summary>
    internal static string Problem(int handle) {
        MarrowRuntime.Status status = marrow_unity_status(handle);
        if (status == MarrowRuntime.Status.Ok || status == MarrowRuntime.Status.GlError) return "";
        return MarrowRuntime.Marrow.Text(MarrowRuntime.Marrow.StatusText(status)) + " " +
               MarrowRuntime.Marrow.Text(marrow_unity_log());
    }

    internal static void Close(int handle) { marrow_unity_close(handle); }
#endif
}

}
