// Marrow for Unreal, as a module of libraries that are built outside it: see docs/platforms/unreal.md. Untried.
//
//   Source/ThirdParty/Marrow/Marrow.Build.cs     this file
//                            include/marrow/     headers
//                            lib/Linux, …        static libraries, a folder for each platform
using System.IO;
using UnrealBuildTool;

public class Marrow : ModuleRules {
    public Marrow(ReadOnlyTargetRules Target) : base(Target) {
        Type = ModuleType.External;
        PublicSystemIncludePaths.Add(Path.Combine(ModuleDirectory, "include"));
        string folder = Path.Combine(ModuleDirectory, "lib", FolderOf(Target.Platform));
        bool windows = Target.Platform == UnrealTargetPlatform.Win64;
        // What needs others comes before them. Codecs are taken where they were installed; the others must be there.
        foreach (string name in new[] {"marrow_draco", "draco", "marrow_meshopt", "meshoptimizer", "marrow_c",
                                       "marrow_unpack", "marrow_runtime"}) {
            string library = Path.Combine(folder, windows ? name + ".lib" : "lib" + name + ".a");
            if (File.Exists(library)) {
                PublicAdditionalLibraries.Add(library);
            } else if (name == "marrow_c" || name == "marrow_unpack" || name == "marrow_runtime") {
                throw new BuildException("Marrow: {0} is not there: build and install Marrow for this platform, see " +
                                         "docs/platforms/unreal.md", library);
            }
        }
    }

    static string FolderOf(UnrealTargetPlatform platform) {
        if (platform == UnrealTargetPlatform.Android) return "Android/arm64-v8a";
        return platform.ToString();  // Win64, Linux, LinuxArm64, Mac, IOS
    }
}
