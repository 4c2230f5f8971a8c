"""Lays out an AAR's prefab folder: the module marrow, a static library, and marrow_c, a shared one for C.

usage: make_prefab.py BUILD OUT [NDK]
BUILD has ABI/libraries/libmarrow.a and libmarrow_c.so; NDK is its major number. The format is Prefab's, version 2.
"""
import json
import pathlib
import re
import shutil
import sys

ABIS = ("arm64-v8a", "armeabi-v7a", "x86_64")
NEEDS_OTHERS = ("draco.h", "meshopt.h", "egl.h")  # headers of libraries that are not in the AAR


def write(path, value):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(value, indent=2) + "\n", encoding="utf-8")


def make_module(build, prefab, name, library, headers, ndk):
    module = prefab / "modules" / name
    write(module / "module.json", {"export_libraries": ["-lm"], "library_name": library, "android": {}})
    (module / "include/marrow").mkdir(parents=True)
    for header in headers:
        shutil.copy(header, module / "include/marrow")
    static = name == "marrow"
    for abi in ABIS:
        libraries = module / "libs" / f"android.{abi}"
        write(libraries / "abi.json", {"abi": abi, "api": 21, "ndk": ndk, "stl": "none", "static": static})
        shutil.copy(build / abi / "libraries" / f"{library}.{'a' if static else 'so'}", libraries)


def main():
    build, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    ndk = int(sys.argv[3]) if len(sys.argv) > 3 and sys.argv[3] else 27
    include = pathlib.Path(__file__).parents[3] / "runtime/include/marrow"
    numbers = dict(re.findall(r"#define MARROW_VERSION_(\w+) (\d+)", (include / "version.h").read_text()))
    version = ".".join(numbers[part] for part in ("MAJOR", "MINOR", "PATCH"))
    write(out / "prefab/prefab.json", {"schema_version": 2, "name": "marrow", "version": version, "dependencies": []})
    headers = sorted(h for h in include.glob("*.h") if h.name not in NEEDS_OTHERS)
    make_module(build, out / "prefab", "marrow", "libmarrow", headers, ndk)
    make_module(build, out / "prefab", "marrow_c", "libmarrow_c", [include / "c.h", include / "c_gles3.h"], ndk)


if __name__ == "__main__":
    main()
