using System;
using MarrowRuntime;

namespace MarrowAnimation {

/// <summary>What went wrong: the file's name, the place in it where that is known, and what to do.</summary>
public sealed class MarrowException : Exception {
    /// <summary>As the runtime has it, as 6 of a file that breaks a rule; 0 where the runtime was not asked.</summary>
    public int Status { get; private set; }

    internal MarrowException(string message, Status status = MarrowRuntime.Status.Ok, Exception inner = null)
        : base(message, inner) {
        Status = (int)status;
    }

    internal static unsafe void Must(Status status, string what) {
        if (status == MarrowRuntime.Status.Ok) return;
        throw new MarrowException(what + ": " + Marrow.Text(Marrow.StatusText(status)), status);
    }

    /// <summary>Of a file that cannot be read.</summary>
    internal static unsafe MarrowException Of(string name, DataError error) {
        string what = Marrow.Text(Marrow.StatusText(error.status)), place = "";
        if (error.rule != null) {
            string rule = Marrow.Text(error.rule);
            place = ": byte " + error.offset + (rule == what ? "" : ": the rule \"" + rule + "\" does not hold");
        }
        return new MarrowException(name + place + ": " + what + ": " + WhatToDo(error.status), error.status);
    }

    static string WhatToDo(Status status) {
        switch (status) {
            case MarrowRuntime.Status.BadMagic:
                return "give a file that `marrow cook` wrote; one that git keeps in LFS has to be fetched first";
            case MarrowRuntime.Status.BadVersion:
                return "cook it again with the program of this release";
            case MarrowRuntime.Status.Unsupported:
                return "build marrow_c with the codec (MARROW_DRACO, MARROW_MESHOPT), or cook with --mesh-codec none";
            default:
                return "copy it again, or cook it again";
        }
    }
}

}
