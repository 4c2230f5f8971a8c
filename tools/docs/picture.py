#!/usr/bin/env python3
"""Makes README.md's picture of the sample, docs/images/newt.jpg, or finds that it is of other sources.

usage: tools/docs/picture.py MARROW   draws it by the program MARROW, in full colour
       tools/docs/picture.py          exit 1 if what the picture is made of has changed since

The picture is `marrow demo`'s contact sheet of the sample, as JPEG by ffmpeg: a fifth of the bytes, as it is drawn often.
A comment within it has a hash over the sample and the sources that choose, deform and lay out what is seen.
"""
import hashlib
import pathlib
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PICTURE = ROOT / "docs/images/newt.jpg"
INPUTS = ("tools/sample/newt.glb", "tools/commands/demo", "tools/cook/learn", "tools/deform")
BEGIN, COMMENT = b"\xff\xd8", b"\xff\xfe"  # of JPEG


def inputs_hash():
    files = [path for name in INPUTS for path in [ROOT / name, *sorted((ROOT / name).rglob("*"))] if path.is_file()]
    total = hashlib.sha256()
    for path in files:
        total.update(f"{path.relative_to(ROOT).as_posix()}\0".encode() + hashlib.sha256(path.read_bytes()).digest())
    return total.hexdigest().encode()


def note():
    text = b"made of " + inputs_hash()
    return COMMENT + struct.pack(">H", len(text) + 2) + text


def main():
    if len(sys.argv) > 1:
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.argv[1], "demo", "-o", folder], check=True)
            drawn = pathlib.Path(folder) / "newt.jpg"
            subprocess.run(["ffmpeg", "-loglevel", "error", "-i", drawn.with_suffix(".png"), "-q:v", "2",
                            "-pix_fmt", "yuvj444p", drawn], check=True)
            PICTURE.write_bytes(BEGIN + note() + drawn.read_bytes()[len(BEGIN):])
        return 0
    if PICTURE.read_bytes().startswith(BEGIN + note()):
        return 0
    print(f"{PICTURE.relative_to(ROOT)} is of other sources than these: tools/docs/picture.py MARROW, look at it, and "
          "commit it", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
