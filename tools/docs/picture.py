#!/usr/bin/env python3
"""Makes README.md's pictures of the sample, docs/images/newt-moves.webp and newt.jpg, or finds that they are of other sources.

usage: tools/docs/picture.py MARROW   draws them by the program MARROW
       tools/docs/picture.py          exit 1 if what they are made of has changed since

The first is `marrow demo`'s movie, as it is. The second is its contact sheet of the sample, as JPEG by ffmpeg: a fifth
of the bytes, as it is drawn often. A comment within it has a hash over the movie, the sample, and the sources that
choose, deform and lay out what is seen.
"""
import hashlib
import pathlib
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PICTURE = ROOT / "docs/images/newt.jpg"
MOVIE = ROOT / "docs/images/newt-moves.webp"
MOST_BYTES = 1_500_000  # of the movie
INPUTS = ("docs/images/newt-moves.webp", "tools/sample/newt.glb", "tools/sample/newt_moves.glb",
          "tools/sample/newt.anim.toml", "tools/commands/demo", "tools/story", "tools/cook/learn", "tools/deform")
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
            moves = (pathlib.Path(folder) / "newt-moves.webp").read_bytes()
            if len(moves) > MOST_BYTES:
                sys.exit(f"newt-moves.webp: {len(moves)} bytes are too many for a page")
            MOVIE.write_bytes(moves)
            drawn = pathlib.Path(folder) / "newt.jpg"
            subprocess.run(["ffmpeg", "-loglevel", "error", "-i", drawn.with_suffix(".png"), "-q:v", "2",
                            "-pix_fmt", "yuvj444p", drawn], check=True)
            PICTURE.write_bytes(BEGIN + note() + drawn.read_bytes()[len(BEGIN):])
        return 0
    if PICTURE.read_bytes().startswith(BEGIN + note()):
        return 0
    print(f"{MOVIE.relative_to(ROOT)} and {PICTURE.name} are of other sources than these: tools/docs/picture.py MARROW, "
          "look at them, and commit them", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
