// What tests/bindings/gles3.c does, in C#: the same lines must come of it.
using System;
using System.Globalization;
using System.Runtime.InteropServices;
using MarrowRuntime;
using M = MarrowRuntime.Marrow;

public static unsafe class Gles3 {
    const string Egl = "libEGL.so.1";
    [DllImport(Egl)]
    static extern void* eglGetProcAddress(byte* name);
    [DllImport(Egl)]
    static extern void* eglGetPlatformDisplay(uint platform, void* native, IntPtr* attributes);
    [DllImport(Egl)]
    static extern uint eglInitialize(void* display, int* major, int* minor);
    [DllImport(Egl)]
    static extern uint eglBindAPI(uint api);
    [DllImport(Egl)]
    static extern void* eglCreateContext(void* display, void* config, void* share, int* wanted);
    [DllImport(Egl)]
    static extern uint eglMakeCurrent(void* display, void* draw, void* read, void* context);

    static readonly Gles3LoadProc loadProc = name => eglGetProcAddress(name);

    static void Must(Status status) {
        if (status != Status.Ok) throw new Exception(M.Text(M.StatusText(status)));
    }

    static void OpenContext() {
        void* display = eglGetPlatformDisplay(0x31DD, null, null);  // Mesa's surfaceless platform
        int* version = stackalloc int[3];
        version[0] = 0x3098;
        version[1] = 3;
        version[2] = 0x3038;
        if (eglInitialize(display, null, null) == 0 || eglBindAPI(0x30A0) == 0) throw new Exception("no EGL");
        if (eglMakeCurrent(display, null, null, eglCreateContext(display, null, null, version)) == 0)
            throw new Exception("no context");
    }

    public static void Main() {
        if (M.Gles3Abi() != M.Gles3AbiNumber) throw new Exception("the library is of another ABI");
        if (IntPtr.Size == 8 && !M.IsLaidOut()) throw new Exception("C# lays structs out as C does not");
        OpenContext();
        Gles3Api api;
        Gles3Caps caps = Gles3Caps.New();
        Must(M.Gles3LoadApi(&api, Marshal.GetFunctionPointerForDelegate(loadProc), null));
        Must(M.Gles3QueryCaps(&api, &caps));
        Console.WriteLine(caps.uniform_block_bytes + " " + caps.texture_size + " " + caps.compute);
        Gles3SelfTestOptions options = Gles3SelfTestOptions.New();
        UIntPtr bytes = M.Gles3SelfTestBytes(&options);
        void* memory = M.Block((ulong)bytes);
        Gles3SelfTest test;
        Must(M.Gles3RunSelfTest(&api, &caps, &options, memory, bytes, &test));
        Gles3PathResult* results = &test.paths0;
        for (int i = 0; i < M.Gles3PathCount; ++i)
            Console.WriteLine(M.Text(M.Gles3SkinningPathText((Gles3SkinningPath)i)) + " " + (int)results[i].verdict + " " +
                results[i].position_error.ToString("F7", CultureInfo.InvariantCulture));
        Gles3PathNeed need = Gles3PathNeed.New();
        Gles3SkinningPath best;
        Must(M.Gles3Choose(&test, &need, &best));
        Console.WriteLine(M.Text(M.Gles3SkinningPathText(best)));
        M.FreeBlock(memory);
    }
}
