#!/usr/bin/env python3
"""Makes README.md's picture of the sample, docs/images/newt.png, or finds that it is of other sources.

usage: tools/docs/picture.py MARROW   draws it by the program MARROW, in full colour
       tools/docs/picture.py          exit 1 if what the picture is made of has changed since

The picture is `marrow demo`'s contact sheet of the sample. A note within it, a tEXt chunk, has a hash over the sample
and the sources that choose, deform and lay out what is seen.
"""
import hashlib
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
PICTURE = ROOT / "docs/images/newt.png"
INPUTS = ("tools/sample/newt.glb", "tools/commands/demo", "tools/cook/learn", "tools/deform")
NOTE = b"made of\0"
SIGNATURE = b"\x89PNG\r\n\x1a\n"


def inputs_hash():
    files = [path for name in INPUTS for path in [ROOT / name, *sorted((ROOT / name).rglob("*"))] if path.is_file()]
    total = hashlib.sha256()
    for path in files:
        total.update(f"{path.relative_to(ROOT).as_posix()}\0".encode() + hashlib.sha256(path.read_bytes()).digest())
    return total.hexdigest().encode()


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def noted(png, text):
    """A PNG file's bytes with a note behind its heading."""
    end = len(SIGNATURE) + 25
    if png[:8] != SIGNATURE or png[12:16] != b"IHDR":
        sys.exit("marrow demo wrote no PNG file")
    return png[:end] + chunk(b"tEXt", NOTE + text) + png[end:]


def main():
    if len(sys.argv) > 1:
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.argv[1], "demo", "-o", folder], check=True)
            PICTURE.write_bytes(noted((pathlib.Path(folder) / "newt.png").read_bytes(), inputs_hash()))
        return 0
    if chunk(b"tEXt", NOTE + inputs_hash()) in PICTURE.read_bytes()[:200]:
        return 0
    print(f"{PICTURE.relative_to(ROOT)} is of other sources than these: tools/docs/picture.py MARROW, look at it, and "
          "commit it", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
