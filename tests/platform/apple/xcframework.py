"""Says what is wrong with Marrow.xcframework: its plists, its folders, and what each slice is made of.

usage: xcframework.py MARROW PACKAGE
       xcframework.py --stub
MARROW: the folder of Marrow's sources. PACKAGE: what tools/apple.sh has made. Exit code: 0 good, 1 not.
--stub: prints what a linker wants to know of the system's library, with what the slices may want of it.
"""

import pathlib
import plistlib
import re
import sys

import macho

MINIMUM = {"ios": "14.0", "ios-simulator": "14.0", "macos": "11.0"}
# What the library may want: of C, and what Clang makes of the same. None of it needs a reason in a privacy manifest,
# none of it is C++'s.
OF_THE_SYSTEM = {
    "_" + name
    for name in "__stack_chk_fail __stack_chk_guard bzero __bzero floor floorf ldexpf memchr memcmp memcpy memmove "
    "memset strcmp strlen".split()
}
PRIVACY = {
    "NSPrivacyTracking": False,
    "NSPrivacyTrackingDomains": [],
    "NSPrivacyCollectedDataTypes": [],
    "NSPrivacyAccessedAPITypes": [],
}


class Wrong(Exception):
    """One line: file: what is wrong: what to do."""


def demand(holds, place, what):
    if not holds:
        raise Wrong(f"{place}: {what}: make the package anew by tools/apple.sh")


def read_plist(path):
    try:
        with open(path, "rb") as file:
            return plistlib.load(file)
    except OSError as error:
        raise Wrong(f"{path}: {error.strerror}: make the package anew by tools/apple.sh") from None
    except Exception as error:  # plistlib raises what its parsers do
        raise Wrong(f"{path}: is no property list ({error}): make the package anew by tools/apple.sh") from None


def check_library(path, processors, platform, wanted):
    """Every object of a slice's library. Returns how many."""
    objects = 0
    try:
        data = path.read_bytes()
        parts = macho.fat_parts(data)
        if None in parts and len(processors) == 1:
            parts = {processors[0]: parts[None]}
        demand(sorted(parts, key=str) == sorted(processors), path, f"is for {list(parts)}, and not for {processors}")
        for processor, part in parts.items():
            defined, undefined = set(), set()
            for name, member in macho.members(part):
                it = macho.read_object(name, member)
                place = f"{path}({name})"
                demand(it.processor == processor, place, f"is for {it.processor}, and not for {processor}")
                demand(it.platform == platform, place, f"is for {it.platform}, and not for {platform}")
                demand(it.minimum == MINIMUM[platform], place, f"needs {it.minimum}, and not {MINIMUM[platform]}")
                defined |= it.defined
                undefined |= it.undefined
                objects += 1
            missing = sorted(wanted - defined)
            demand(not missing, path, f"{processor}: {len(missing)} functions are missing, as {missing[:3]}")
            foreign = sorted(undefined - defined - OF_THE_SYSTEM)
            demand(not foreign, path, f"{processor}: wants of the system what it should not: {foreign[:5]}")
    except macho.Damaged as damage:
        raise Wrong(f"{path}: {damage}: make the package anew by tools/apple.sh") from None
    return objects


def check_headers(marrow, headers):
    """The headers are Marrow's, and the map names some of them."""
    files = {path.name for path in headers.iterdir()}
    for name in files - {"module.modulemap"}:
        source = marrow / "runtime/include/marrow" / name
        demand(source.exists() and source.read_bytes() == (headers / name).read_bytes(), headers / name, "is another's")
    named = set(re.findall(r'header "(.+)"', (headers / "module.modulemap").read_text()))
    demand(named == {"c.h", "c_gles3.h"} and named <= files, headers / "module.modulemap", f"names {sorted(named)}")


def check_slice(marrow, framework, entry, wanted):
    """One entry of Info.plist and its folder."""
    place = framework / "Info.plist"
    name = entry.get("LibraryIdentifier", "")
    system, processors = entry.get("SupportedPlatform", ""), entry.get("SupportedArchitectures", [])
    variant = entry.get("SupportedPlatformVariant")
    platform = f"{system}-{variant}" if variant else system
    demand(platform in MINIMUM, place, f"{name}: the platform {platform} is unknown")
    spelled = "-".join([system, "_".join(processors)] + ([variant] if variant else []))
    demand(name == spelled, place, f"{name}: what it says of itself is {spelled}")
    for key in ("LibraryPath", "HeadersPath"):
        demand((framework / name / entry.get(key, "?")).exists(), place, f"{name}: there is no {entry.get(key)}")
    check_headers(marrow, framework / name / entry["HeadersPath"] / "marrow")
    library = framework / name / entry["LibraryPath"]
    objects = check_library(library, processors, platform, wanted)
    print(f"{name}: {objects} objects, {library.stat().st_size} B, {platform} {MINIMUM[platform]}")


def stub():
    """A text-based stub of libSystem."""
    targets = "[ arm64-ios, arm64-ios-simulator, x86_64-ios-simulator, arm64-macos, x86_64-macos ]"
    return f"""--- !tapi-tbd
tbd-version: 4
targets: {targets}
install-name: '/usr/lib/libSystem.B.dylib'
exports:
  - targets: {targets}
    symbols: [ {', '.join(sorted(OF_THE_SYSTEM))}, dyld_stub_binder ]
..."""


def main():
    if sys.argv[1:] == ["--stub"]:
        print(stub())
        return 0
    marrow, package = (pathlib.Path(argument) for argument in sys.argv[1:3])
    framework = package / "Marrow.xcframework"
    wanted = set()
    for wrappers in ("wrappers.cpp", "gles3_wrappers.cpp"):
        text = (marrow / "runtime/c" / wrappers).read_text()
        wanted |= {"_" + name for name in re.findall(r"^[a-z].*?(mrw_\w+)\(", text, re.M)}
    try:
        place = framework / "Info.plist"
        plist = read_plist(place)
        entries = plist.get("AvailableLibraries", [])
        demand(plist.get("CFBundlePackageType") == "XFWK", place, "is not that of an XCFramework")
        demand(plist.get("XCFrameworkFormatVersion") == "1.0", place, "is of another format")
        folders = {path.name for path in framework.iterdir() if path.is_dir()}
        names = {entry.get("LibraryIdentifier") for entry in entries}
        demand(folders == names, place, f"names {sorted(map(str, names))}, and there are {sorted(folders)}")
        demand({"ios-arm64", "ios-arm64_x86_64-simulator"} <= names, place, f"has only {sorted(names)}")
        for entry in entries:
            check_slice(marrow, framework, entry, wanted)
        place = package / "Sources/MarrowKit/PrivacyInfo.xcprivacy"
        demand(read_plist(place) == PRIVACY, place, "says other than that nothing is collected, tracked or asked for")
    except Wrong as wrong:
        print(f"xcframework: {wrong}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
