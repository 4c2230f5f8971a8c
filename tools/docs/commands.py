#!/usr/bin/env python3
"""Runs the commands of the manual, page by page, as a reader would.

usage: tools/docs/commands.py MARROW [PAGE.md ...]    (MARROW: the built program)

The blocks `sh` of a page run in order in a folder of its own, which has hero.glb (the sample character), hero.mrw (cooked
from it), walk.bvh (motion capture) and scan.glb (a mesh without joints). Each command must end with exit code 0. A block
with a comment `<!-- not run: why -->` before it is left out, but that `marrow` must have the options that stand there;
pages whose commands another check runs are left out. Exit 1 if a command fails.
"""
import concurrent.futures
import functools
import json
import os
import pathlib
import re
import shlex
import struct
import subprocess
import sys
import tempfile
import time

import blocks

# Metres; BVH has no units, and the cooker takes them as they are.
BODY = {"pelvis": (None, (0, .5, 0)), "spine_1": ("pelvis", (0, .09, 0)), "spine_2": ("spine_1", (0, .1, 0)),
        "chest": ("spine_2", (0, .1, 0)), "neck": ("chest", (0, .12, 0)), "head": ("neck", (0, .08, 0)),
        "upper_arm.L": ("chest", (.14, .07, 0)), "forearm.L": ("upper_arm.L", (.2, 0, 0)), "hand.L": ("forearm.L", (.2, 0, 0)),
        "upper_arm.R": ("chest", (-.14, .07, 0)), "forearm.R": ("upper_arm.R", (-.2, 0, 0)), "hand.R": ("forearm.R", (-.2, 0, 0)),
        "thigh.L": ("pelvis", (.11, -.03, 0)), "shin.L": ("thigh.L", (0, -.2, 0)), "foot.L": ("shin.L", (0, -.2, 0)),
        "thigh.R": ("pelvis", (-.11, -.03, 0)), "shin.R": ("thigh.R", (0, -.2, 0)), "foot.R": ("shin.R", (0, -.2, 0))}


def motion_capture():
    """Two seconds in which thighs swing, as BVH."""
    order = []

    def joint(name, depth):
        pad = "  " * depth
        order.append(name)
        children = [n for n, (parent, _) in BODY.items() if parent == name]
        channels = "6 Xposition Yposition Zposition" if depth == 0 else "3"
        return "".join([f"{pad}{'JOINT' if depth else 'ROOT'} {name}\n{pad}{{\n",
                        f"{pad}  OFFSET {' '.join(str(x) for x in BODY[name][1])}\n",
                        f"{pad}  CHANNELS {channels} Zrotation Xrotation Yrotation\n",
                        *[joint(n, depth + 1) for n in children],
                        "" if children else f"{pad}  End Site\n{pad}  {{\n{pad}    OFFSET 0 0.1 0\n{pad}  }}\n", f"{pad}}}\n"])

    hierarchy = joint("pelvis", 0)
    frames = []
    for i in range(60):
        swing = 30 - abs(i % 30 - 15) * 4
        turns = {"thigh.L": (0, swing, 0), "thigh.R": (0, -swing, 0)}
        numbers = [0, .5, 0] + [x for name in order for x in turns.get(name, (0, 0, 0))]
        frames.append(" ".join(str(x) for x in numbers))
    return f"HIERARCHY\n{hierarchy}MOTION\nFrames: {len(frames)}\nFrame Time: 0.0333333\n" + "\n".join(frames) + "\n"


def without_joints(glb):
    """A .glb's meshes alone."""
    size = struct.unpack_from("<I", glb, 12)[0]
    scene = json.loads(glb[20:20 + size])
    for key in ("skins", "animations", "extensions", "extensionsUsed"):
        scene.pop(key, None)
    meshes = [{"mesh": node["mesh"]} for node in scene["nodes"] if "mesh" in node][:1]
    scene["nodes"], scene["scenes"], scene["scene"] = meshes, [{"nodes": list(range(len(meshes)))}], 0
    for mesh in scene["meshes"]:
        mesh.pop("extras", None)
        for primitive in mesh["primitives"]:
            primitive.pop("targets", None)
            for name in ("JOINTS_0", "WEIGHTS_0"):
                primitive["attributes"].pop(name, None)
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    rest = glb[20 + size:]
    return struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), 0x4E4F534A) + text + rest


def make_files(marrow, folder):
    run = lambda *arguments: subprocess.run([marrow, *arguments], check=True, stdout=subprocess.DEVNULL, cwd=folder)
    run("sample", "-o", "hero.glb")
    run("cook", "hero.glb", "-o", "hero.mrw")
    (folder / "walk.bvh").write_text(motion_capture())
    (folder / "scan.glb").write_bytes(without_joints((folder / "hero.glb").read_bytes()))


@functools.lru_cache(maxsize=None)
def options_of(marrow, command):
    """Those that `marrow COMMAND --help` lists; None where there is no such command."""
    ran = subprocess.run([marrow, command, "--help"], capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)
    lines = [line.split()[0] for line in ran.stdout.splitlines() if line.startswith("  -")]
    return None if ran.returncode else {option for line in lines for option in line.split(",")}


def commands_of(block):
    for command in block.text.replace("\\\n", " ").splitlines():
        if command.strip() and not command.lstrip().startswith("#"):
            yield command


def misspelt(marrow, page):
    """What of blocks that are not run `marrow` does not know."""
    failures = []
    for block in blocks.blocks(page):
        for command in commands_of(block) if block.language == "sh" and block.excuse else ():
            words = shlex.split(command, comments=True)
            if words[0] != "marrow" or len(words) < 2 or words[1].startswith("-"):
                continue
            known = options_of(marrow, words[1])
            given = {word.split("=")[0] for word in words[2:] if re.match("--?[a-z]", word)}
            unknown = [f"marrow {words[1]}"] if known is None else sorted(given - known)
            if unknown:
                failures.append(f"{page.relative_to(blocks.ROOT)}:{block.line}: no such {' '.join(unknown)}: {command}")
    return failures


def run_page(marrow, page, files):
    """What failed, how many commands ran."""
    failures, count, slow = [], 0, []
    with tempfile.TemporaryDirectory() as folder:
        for path in files.iterdir():
            os.link(path, pathlib.Path(folder) / path.name)
        environment = {**os.environ, "PATH": f"{pathlib.Path(marrow).parent}:{os.environ['PATH']}"}
        for block in blocks.blocks(page):
            if block.language != "sh" or block.excuse:
                continue
            for command in commands_of(block):
                start = time.monotonic()
                ran = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, capture_output=True, text=True,
                                     stdin=subprocess.DEVNULL, timeout=300, check=False)
                count += 1
                if time.monotonic() - start > 5:
                    slow.append((time.monotonic() - start, command))
                if ran.returncode:
                    failures.append(f"{page.relative_to(blocks.ROOT)}:{block.line}: exit code {ran.returncode}: {command}\n"
                                    f"  {ran.stderr.strip()[-400:]}")
    return failures, count, slow


def main():
    marrow = str(pathlib.Path(sys.argv[1]).resolve())
    pages = [p for p in blocks.pages(sys.argv[2:]) if not blocks.run_by(p)]
    with tempfile.TemporaryDirectory() as folder:
        files = pathlib.Path(folder)
        make_files(marrow, files)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            results = list(pool.map(lambda page: run_page(marrow, page, files), pages))
    failures = [line for failed, _, _ in results for line in failed]
    failures += [line for page in pages for line in misspelt(marrow, page)]
    for seconds, command in sorted(line for _, _, slow in results for line in slow):
        print(f"{seconds:5.1f} s  {command}", file=sys.stderr)
    print("\n".join(failures), file=sys.stderr)
    print(f"{sum(count for _, count, _ in results)} commands of {len(pages)} pages, {len(failures)} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
