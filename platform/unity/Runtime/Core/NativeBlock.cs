using System;
using MarrowRuntime;

namespace MarrowAnimation {

/// <summary>
/// Memory on a boundary of 16 bytes that no collector moves; freed at the latest when it is collected itself.
/// </summary>
internal sealed unsafe class NativeBlock : IDisposable {
    void* first;

    internal NativeBlock(ulong bytes) {
        if (bytes > int.MaxValue) throw new MarrowException("more than 2 GiB of memory are asked for");
        first = Marrow.Block(bytes);
    }

    ~NativeBlock() { Free(); }

    /// <summary>Up to the next boundary of 16 bytes.</summary>
    internal static ulong Rounded(int bytes) { return ((ulong)bytes + 15) / 16 * 16; }

    internal byte* First { get { return (byte*)first; } }

    public void Dispose() {
        Free();
        GC.SuppressFinalize(this);
    }

    void Free() {
        if (first != null) Marrow.FreeBlock(first);
        first = null;
    }
}

}
