"""Puts a Swift package together: Marrow.xcframework of static libraries, Package.swift, its Swift and the example.

usage: package.py MARROW OUT SLICE=LIBRARY ...
MARROW: the folder of Marrow's sources. OUT: the package's folder; what it had of a package before is replaced.
SLICE: as ios-arm64_x86_64-simulator, SYSTEM-PROCESSOR_PROCESSOR[-VARIANT]. tools/apple.sh calls this.
"""

import pathlib
import plistlib
import shutil
import sys

# C++ headers of what is not in the library.
NOT_IN_IT = {"draco.h", "meshopt.h", "glm.h"}


def processors(name):
    """ "arm64_x86_64" as a list."""
    return name.replace("x86_64", "x86-64").replace("_", " ").replace("x86-64", "x86_64").split()


def describe(slice_name, library):
    """What Info.plist says of a slice."""
    system, names, *variant = slice_name.split("-")
    out = {
        "BinaryPath": library,
        "HeadersPath": "Headers",
        "LibraryIdentifier": slice_name,
        "LibraryPath": library,
        "SupportedArchitectures": processors(names),
        "SupportedPlatform": system,
    }
    if variant:
        out["SupportedPlatformVariant"] = variant[0]
    return out


def main():
    marrow, out = (pathlib.Path(argument) for argument in sys.argv[1:3])
    apple = marrow / "platform/apple"
    framework = out / "Marrow.xcframework"
    for old in (framework, out / "Sources", out / "Example"):
        if old.exists():
            shutil.rmtree(old)
    available = []
    for argument in sys.argv[3:]:
        slice_name, library = argument.split("=", 1)
        library = pathlib.Path(library)
        headers = framework / slice_name / "Headers/marrow"
        headers.mkdir(parents=True)
        shutil.copyfile(library, framework / slice_name / library.name)
        for header in sorted((marrow / "runtime/include/marrow").glob("*.h")):
            if header.name not in NOT_IN_IT:
                shutil.copyfile(header, headers / header.name)
        shutil.copyfile(apple / "module.modulemap", headers / "module.modulemap")
        available.append(describe(slice_name, library.name))
    with open(framework / "Info.plist", "wb") as plist:
        plistlib.dump(
            {"AvailableLibraries": available, "CFBundlePackageType": "XFWK", "XCFrameworkFormatVersion": "1.0"}, plist
        )
    for folder in ("Sources", "Example"):
        shutil.copytree(apple / folder, out / folder)
    shutil.copyfile(apple / "Package.swift", out / "Package.swift")
    for text in ("LICENSE", "THIRD_PARTY.md"):
        shutil.copyfile(marrow / text, out / text)
    print(f"{framework}: {', '.join(a['LibraryIdentifier'] for a in available)}")


if __name__ == "__main__":
    main()
