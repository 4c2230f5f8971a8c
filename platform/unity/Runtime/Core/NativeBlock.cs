using System;
using System.Threading;
using MarrowRuntime;

namespace MarrowAnimation {

/// <summary>Memory that no collector moves, on a boundary of 16 bytes; freed when its last owner lets go of it.</summary>
internal sealed unsafe class NativeBlock {
    void* first;
    int owners = 1;

    internal NativeBlock(ulong bytes) {
        if (bytes > int.MaxValue) throw new MarrowException("more than 2 GiB of memory are asked for");
        first = Marrow.Block(bytes);
    }

    ~NativeBlock() { Free(); }

    internal byte* First { get { return (byte*)first; } }

    internal void Keep() { Interlocked.Increment(ref owners); }

    internal void LetGo() {
        if (Interlocked.Decrement(ref owners) > 0) return;
        Free();
        GC.SuppressFinalize(this);
    }

    void Free() {
        if (first != null) Marrow.FreeBlock(first);
        first = null;
    }
}

}
