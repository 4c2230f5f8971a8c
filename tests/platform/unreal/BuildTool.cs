// Of UnrealBuildTool what Marrow.Build.cs uses, written by hand, and a program that makes the module and prints what it
// asks the compiler and the linker for.
// usage: BuildTool.exe PLATFORM FOLDER
using System;
using System.Collections.Generic;

namespace UnrealBuildTool {

public struct UnrealTargetPlatform {
    readonly string name;
    UnrealTargetPlatform(string name) { this.name = name; }
    public static readonly UnrealTargetPlatform Win64 = new UnrealTargetPlatform("Win64");
    public static readonly UnrealTargetPlatform Android = new UnrealTargetPlatform("Android");
    public static UnrealTargetPlatform Parse(string name) { return new UnrealTargetPlatform(name); }
    public static bool operator ==(UnrealTargetPlatform a, UnrealTargetPlatform b) { return a.name == b.name; }
    public static bool operator !=(UnrealTargetPlatform a, UnrealTargetPlatform b) { return a.name != b.name; }
    public override bool Equals(object other) {
        return other is UnrealTargetPlatform && this == (UnrealTargetPlatform)other;
    }
    public override int GetHashCode() { return name.GetHashCode(); }
    public override string ToString() { return name; }
}

public class BuildException : Exception {
    public BuildException(string format, params object[] arguments) : base(string.Format(format, arguments)) {}
}

public class ReadOnlyTargetRules {
    public UnrealTargetPlatform Platform;
    public string FolderOfModule;
}

public class ModuleRules {
    public enum ModuleType { CPlusPlus, External }
    public ModuleType Type;
    public string ModuleDirectory;
    public List<string> PublicSystemIncludePaths = new List<string>(), PublicAdditionalLibraries = new List<string>();
    public ModuleRules(ReadOnlyTargetRules target) { ModuleDirectory = target.FolderOfModule; }
}

}

public static class BuildTool {
    public static int Main(string[] args) {
        UnrealBuildTool.ReadOnlyTargetRules target = new UnrealBuildTool.ReadOnlyTargetRules();
        target.Platform = UnrealBuildTool.UnrealTargetPlatform.Parse(args[0]);
        target.FolderOfModule = args[1];
        try {
            Marrow module = new Marrow(target);
            if (module.Type != UnrealBuildTool.ModuleRules.ModuleType.External) return 1;
            foreach (string folder in module.PublicSystemIncludePaths) Console.WriteLine("-I" + folder);
            foreach (string library in module.PublicAdditionalLibraries) Console.WriteLine(library);
            return 0;
        } catch (UnrealBuildTool.BuildException problem) {
            Console.WriteLine(problem.Message);
            return 6;
        }
    }
}
