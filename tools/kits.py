#!/usr/bin/env python3
"""Runs the kits, checks of what games copy and link, whose inputs have changed since each last passed.

usage: tools/kits.py run [NAME ...]     those of them whose stamp is not of what is here
       tools/kits.py --all [NAME ...]   each, whatever its stamp says
       tools/kits.py trace NAME ...     runs each from nothing under strace: it may open no file that is not among its inputs
       tools/kits.py list               names, and whether the stamps are of what is here

A stamp is a line of tests/kits.stamps: a kit's name, and a hash over its command and its inputs, path by path. It is
written when the kit has passed in full, and is committed with what has changed. Inputs are files, folders and patterns
of the sources; of a folder all files count that git does not ignore. The program `marrow` is none: kits make files with
it, and other tests hold what it writes. MARROW_PROGRAM names one; without, the preset release builds it.
Exit code: 0 all that ran passed or had to be skipped, 1 a kit failed, 2 a wrong call or a wrong table.
"""
import hashlib
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
STAMPS = "tests/kits.stamps"
SKIPPED = 3
# Is installed, whatever it says.
COPIED = {"CHANGELOG.md"}

INSTALL = "tools/install.sh tools/packages/build.txt "
# What every build of the libraries reads.
LIBRARIES = (INSTALL + "CMakeLists.txt cmake runtime platform/CMakeLists.txt platform/egl shaders/skin.glsl "
             "shaders/preskin.* shaders/nothing.frag shaders/self_test.* shaders/crowd.* ")
NEWT = "tools/sample/newt.glb "
# What marrow_bits is made of besides.
BITS = "tests/bits tests/golden/*.mrw " + " ".join(f"tests/support/{name}" for name in (
    "aligned.h", "character.cpp", "double_math.h", "family.h", "fan.h", "golden.h", "morphs.h", "pose_file.*", "poses.h",
    "rig.*", "ring.h", "surface.h")) + " "
# What is built for WebAssembly without Emscripten.
WASM = ("tools/wasm.sh tools/packages/cook-wasm.txt tools/CMakeLists.txt tools/wasm tools/text tools/common tools/toml tools/deform "
        "tools/cook tools/disk tools/pose tools/behave tools/image tools/render tools/stage tools/page/viewer shaders "
        "platform/web ")


class Kit:
    """A command that says by its exit code whether what it tries is good, and what it reads for that."""

    def __init__(self, what, command, inputs, folders=""):
        self.what = what
        self.command = command.split()  # MARROW stands for the program
        self.inputs = sorted(set(inputs.split()))
        self.folders = folders.split()  # where it builds: a trace begins without them


KITS = {
    "tutorial": Kit(
        "the tutorial, from an empty folder", "tools/check/tutorial.sh MARROW",
        LIBRARIES + "tools/check/tutorial.sh tests/examples/tutorial docs/tutorial "
        "tools/docs/blocks.py tools/docs/snippets.py", "build/tutorial"),
    "bindings": Kit(
        "Rust, C# and JavaScript", "tools/check/bindings.sh MARROW",
        LIBRARIES + NEWT + "tools/check/bindings.sh tools/packages/bindings.txt tools/c_api tests/bindings "
        "tests/c/road.c tests/c/surfaceless.h platform/web/CMakeLists.txt platform/web/*.h platform/web/gl.* "
        "platform/web/load_proc.cpp",
        "build/bindings"),
    "bits": Kit(
        "same bits everywhere", "tools/same_bits.sh",
        LIBRARIES + BITS + "tools/same_bits.sh tools/wasi.mjs tools/packages/bits.txt",
        "build/bits"),
    "fbx": Kit(
        "FBX, by Blender", "tools/check/fbx.sh MARROW",
        INSTALL + NEWT + "tools/check/fbx.sh tools/fbx_to_glb.sh tools/validate_gltf.sh tools/packages/fbx.txt"),
    "web": Kit(
        "WebGL 2, in Chromium", "tools/check/web.sh MARROW",
        LIBRARIES + NEWT + "tools/check/web.sh tools/packages/web.txt tools/web platform/web", "build/web-newt"),
    "package": Kit(
        "the package for npm", "tools/check/package.sh MARROW",
        LIBRARIES + NEWT + "tools/check/package.sh tools/packages/web-package.txt tools/web tools/c_api "
        "platform/web tests/bindings/road.mjs tests/bindings/gles3.mjs tests/c/road.c tests/platform/web LICENSE",
        "build/web-build build/web-check build/web-package"),
    "cook_wasm": Kit(
        "the cooker in WebAssembly", "tools/check/cook_wasm.sh MARROW",
        LIBRARIES + NEWT + WASM + "tools/check/cook_wasm.sh tools/check/cook_wasm.mjs tools/page/*.json "
        "tools/page/check_*.mjs tools/page/src/cook*r.ts tools/page/src/find_file.ts tools/page/src/report.ts "
        "tools/sample/newt_moves.glb tests/golden/dance.gltf docs/report.schema.json", "build/cook-wasm build/wasm"),
    "page": Kit(
        "the page, in Chromium", "tools/check/page.sh MARROW",
        LIBRARIES + NEWT + WASM + "tools/sample/newt_moves.glb tools/sample/newt.anim.toml tools/check/page.sh tools/web.sh "
        "tools/packages/page.txt tools/page tests/page tests/golden/*.gltf tests/golden/*.png",
        "build/page build/web"),
    "machines": Kit(
        "shards, caches, Bazel and Slurm", "tools/check/machines.sh MARROW",
        INSTALL + NEWT + "tools/check/machines.sh tools/packages/machines.txt tools/farm tests/machines tools/jobs "
        "tools/commands/cook tools/commands/report tools/sample/newt.anim.toml"),
    "gpu_cost": Kit(
        "what phones' compilers say", "tools/gpu_cost.sh --if-changed",
        LIBRARIES + "shaders tools/gpu_cost.sh tools/gpu_cost tools/get_arm64.sh tools/packages/gpu-cost.txt "
        "tools/packages/arm64-shaders.txt", "build/gpu-cost/build"),
    "phone": Kit(
        "the kit for phones", "tools/check/phone.sh",
        LIBRARIES + NEWT + BITS + "tools/check/phone.sh tools/phone.sh tools/phone tools/phone_table.py tools/get_arm64.sh "
        "tools/packages/phone.txt tools/packages/test.txt tools/packages/arm64-gl.txt docs/performance.md", "build/phone"),
    "spirv": Kit(
        "SPIR-V, Vulkan and Metal", "tools/check/spirv.sh",
        LIBRARIES + "tools/check/spirv.sh tools/packages/spirv.txt tests/vulkan docs/other_apis.md",
        "build/spirv"),
    "install": Kit(
        "installed, in a game", "tools/check/install.sh",
        LIBRARIES + "shaders tools/check/install.sh tools/amalgamate.sh tests/install tools/c_api docs/install.md LICENSE THIRD_PARTY.md "
        "tests/golden/dance_v1.mrw tests/fuzz/seeds/dance-draco.mrw"),
    "android": Kit(
        "Android: libraries and an app", "tools/check/android.sh MARROW",
        LIBRARIES + NEWT + "tools/check/android.sh tools/android.sh tools/packages/android.txt tools/packaging/android "
        "platform/android tests/platform/android tests/c/road.c docs/platforms/android.md LICENSE", "build/android"),
    "apple": Kit(
        "iOS: a package", "tools/check/apple.sh MARROW",
        LIBRARIES + NEWT + "tools/check/apple.sh tools/apple.sh tools/packages/apple.txt tools/packages/apple-check.txt "
        "tools/packaging/apple platform/apple tests/platform/apple docs/platforms/ios.md LICENSE", "build/apple"),
    "godot": Kit(
        "Godot 3 and 4", "tools/check/godot.sh MARROW",
        LIBRARIES + NEWT + "tools/check/godot.sh tools/packages/godot.txt platform/godot tests/platform/godot "
        "tests/examples/stages/animator.anim.toml docs/platforms/godot.md LICENSE", "build/godot"),
    "sdl": Kit(
        "SDL 2: a game", "tools/check/sdl.sh MARROW",
        LIBRARIES + NEWT + "tools/check/sdl.sh tools/packages/sdl.txt platform/sdl tests/platform/sdl "
        "docs/platforms/sdl.md tests/golden/dance_v1.mrw LICENSE THIRD_PARTY.md", "build/sdl"),
    "unity": Kit(
        "Unity and Unreal", "tools/check/unity.sh MARROW",
        LIBRARIES + NEWT + "tools/check/unity.sh tools/unity.sh tools/unity tools/c_api platform/web/gl.mjs "
        "tools/packages/unity.txt "
        "platform/unity platform/unreal tests/platform/unity tests/platform/unreal tests/c/surfaceless.h docs/platforms/unity.md "
        "docs/platforms/unreal.md tests/examples/stages/animator.anim.toml "
        "LICENSE THIRD_PARTY.md", "build/unity build/unreal"),
}


def fail(words):
    print(f"kits: {words}", file=sys.stderr)
    raise SystemExit(2)


def files_of(inputs):
    """The files below the inputs; those that git ignores are none. None where there is no git to ask."""
    missing = [path for path in inputs if not any(ROOT.glob(path))]
    if missing:
        fail(f"inputs that are not there: {' '.join(missing)}")
    asked = subprocess.run(
        ["git", "ls-files", "-co", "--exclude-standard", "--deduplicate", "-z", "--", *inputs],
        cwd=ROOT, capture_output=True, text=True, check=False)
    if asked.returncode != 0:
        return None
    return sorted(path for path in asked.stdout.split("\0") if path and (ROOT / path).is_file())


def hash_of(kit):
    """Over the command and every input; None where there is no git."""
    files = files_of(kit.inputs)
    if files is None:
        return None
    made_of = hashlib.sha256("\0".join(kit.command + ["", *kit.inputs]).encode())
    for path in files:
        file = ROOT / path
        runs = "x" if file.stat().st_mode & 0o100 else "-"
        content = hashlib.sha256(file.read_bytes()).hexdigest()
        made_of.update(f"\0{path}\0{runs}{content}".encode())
    return made_of.hexdigest()


def read_stamps():
    file = ROOT / STAMPS
    lines = file.read_text().splitlines() if file.exists() else []
    return dict(line.split() for line in lines if line.strip())


def write_stamp(name, value):
    stamps = {**read_stamps(), name: value}
    lines = [f"{each} {stamps[each]}\n" for each in sorted(stamps) if each in KITS]
    (ROOT / STAMPS).write_text("".join(lines))


def program():
    """The program that kits make files with. Some find it by the environment."""
    if "MARROW_PROGRAM" not in os.environ:
        # Beside it, what kits compare with.
        targets = ["marrow", "marrow_bits", "marrow_c"]
        for step in (["cmake", "--preset", "release"], ["cmake", "--build", "--preset", "release", "--target", *targets]):
            if subprocess.run(step, cwd=ROOT, stdout=subprocess.DEVNULL, check=False).returncode != 0:
                fail("the program `marrow` cannot be built")
        os.environ["MARROW_PROGRAM"] = str(ROOT / "build/release/tools/marrow")
    return os.environ["MARROW_PROGRAM"]


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(kit, before=()):
    """Its exit code, behind the words of another command that runs it; and what it took, as text."""
    command = [program() if word == "MARROW" else word for word in kit.command]
    program()
    wall, used = time.monotonic(), processor_seconds()
    code = subprocess.run([*before, *command], cwd=ROOT, check=False).returncode
    return code, f"{time.monotonic() - wall:6.0f} s {processor_seconds() - used:6.0f} s of processor"


def run_kits(names, each):
    """What ran, and what became of it, a line a kit."""
    rows, failed = [], False
    stamps = read_stamps()
    for name in names:
        kit = KITS[name]
        made_of = hash_of(kit)
        if made_of is None and not rows:
            print("kits: no git tells which files are inputs: every kit runs, and no stamp is written", file=sys.stderr)
        if not each and made_of is not None and stamps.get(name) == made_of:
            rows.append((name, "as stamped", ""))
            continue
        print(f"== {name}: {kit.what}", file=sys.stderr, flush=True)
        if each and "--if-changed" in kit.command:
            kit = Kit(kit.what, " ".join(kit.command).replace("--if-changed", ""), "")
        code, took = run(kit)
        if code == 0 and made_of is not None:
            write_stamp(name, made_of)
        failed |= code not in (0, SKIPPED)
        rows.append((name, {0: "passed", SKIPPED: "SKIPPED, some or all"}.get(code, f"FAILED, {code}"), took))
    for name, became, took in rows:
        print(f"{name:10} {became:22} {took}".rstrip(), file=sys.stderr)
    return 1 if failed else 0


OPENED = re.compile(r"(?:open|openat|openat2)(?:\(| resumed).* = \d+<([^>]+)>$")


def opened_files(record):
    """Files of the sources that a record of strace says were opened, whatever the path."""
    root = str(ROOT.resolve()) + "/"
    found = set()
    for line in record.open(errors="replace"):
        match = OPENED.search(line.rstrip())
        if match and match[1].startswith(root):
            found.add(match[1][len(root):])
    return found


def trace(name):
    """Exit code 1 where the kit fails or opens what is not among its inputs."""
    kit, record = KITS[name], ROOT / "build" / f"{name}.trace"
    made_of = hash_of(kit)
    everything, inputs = files_of([]), files_of(kit.inputs)
    if everything is None:
        fail("without git nothing can be traced")
    for folder in kit.folders:
        shutil.rmtree(ROOT / folder, ignore_errors=True)
    record.parent.mkdir(exist_ok=True)
    # ccache reads what it knows of files elsewhere; the leak sanitizer works in no traced process.
    os.environ.update(CCACHE_NOINODECACHE="1", ASAN_OPTIONS="detect_leaks=0")
    kit = Kit(kit.what, " ".join(kit.command).replace("--if-changed", ""), "")
    code, took = run(kit, ["strace", "-f", "-y", "-qq", "--seccomp-bpf", "-e", "trace=?open,openat,?openat2", "-o", record])
    opened = opened_files(record) & set(everything)
    strange = sorted(opened - set(inputs) - COPIED)
    unread = sorted(set(inputs) - opened)
    print(f"kits: {name} does not open: {' '.join(unread)}", file=sys.stderr)
    for path in strange:
        print(f"kits: {name}: opens {path}, which is not among its inputs", file=sys.stderr)
    print(f"{name}: exit code {code}; {len(opened)} files opened, {len(strange)} of them no inputs; {len(unread)} inputs "
          f"not opened; {took}", file=sys.stderr)
    if code == 0 and not strange:
        write_stamp(name, made_of)
    return 1 if strange or code not in (0, SKIPPED) else 0


def main(words):
    command, names = (words[0], words[1:]) if words else ("", [])
    if command not in ("run", "--all", "trace", "list") or (command == "trace" and not names):
        fail(__doc__[__doc__.index("usage"):__doc__.index("\n\nA stamp")])
    unknown = [name for name in names if name not in KITS]
    if unknown:
        fail(f"no kits: {' '.join(unknown)}; there are {' '.join(KITS)}")
    names = names or list(KITS)
    if command == "trace":
        return max(trace(name) for name in names)
    if command == "list":
        stamps = read_stamps()
        for name in names:
            print(f"{name:10} {'as stamped' if stamps.get(name) == hash_of(KITS[name]) else 'changed':12} {KITS[name].what}")
        return 0
    return run_kits(names, command == "--all")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
