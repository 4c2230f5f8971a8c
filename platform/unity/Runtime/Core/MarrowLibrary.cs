using System;
using MarrowRuntime;

namespace MarrowAnimation {

/// <summary>The native library, which is asked once whether it is there and the right one.</summary>
public static class MarrowLibrary {
    static bool good;

    /// <summary>
    /// Throws a MarrowException that says what to do. Files call it; a game may call it at its start.
    /// </summary>
    public static void Check() {
        if (good) return;
        uint abi;
        try {
            abi = Marrow.Abi();
        } catch (DllNotFoundException missing) {
            throw new MarrowException(Marrow.Library + ": the library is not found: assemble the package with " +
                "tools/unity.sh, and see that Plugins has it for this system and processor", Status.Ok, missing);
        } catch (BadImageFormatException wrong) {
            throw new MarrowException(Marrow.Library + ": the library is for another processor: see the settings of " +
                "the files in Plugins", Status.Ok, wrong);
        } catch (EntryPointNotFoundException wrong) {
            throw new MarrowException(Marrow.Library + ": a library of this name has no mrw_abi: another one comes " +
                "first, or it was linked without Marrow", Status.Ok, wrong);
        }
        if (abi != Marrow.AbiNumber) {
            throw new MarrowException(string.Format("{0}: the library has the ABI {1:x8}, Marrow.cs has {2:x8}: take " +
                "both from one release, and start the Editor again", Marrow.Library, abi, Marrow.AbiNumber));
        }
        if (IntPtr.Size == 8 && !Marrow.IsLaidOut())
            throw new MarrowException("Marrow.cs: this compiler lays structs out otherwise than C: please report it");
        good = true;
    }
}

}
