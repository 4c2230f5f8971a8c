"""Writes a folder as a pack that Godot 4 starts from. usage: pack.py FOLDER OUT.pck"""
import hashlib
import os
import struct
import sys


def padded(data, size):
    return data + b"\0" * (-len(data) % size)


def main(folder, out):
    names = sorted(os.path.relpath(os.path.join(at, name), folder) for at, _, all in os.walk(folder) for name in all)
    entries, data = b"", b""
    for name in names:
        with open(os.path.join(folder, name), "rb") as file:
            content = file.read()
        path = padded(b"res://" + name.encode(), 4)
        entries += struct.pack("<I", len(path)) + path + struct.pack("<QQ", len(data), len(content))
        entries += hashlib.md5(content).digest() + struct.pack("<I", 0)
        data += padded(content, 16)
    # Version 2 of packs, of Godot 4.1; then flags, where the data begin, 16 numbers that are not used.
    head = struct.pack("<4sIIIII", b"GDPC", 2, 4, 1, 0, 0)
    first = len(head) + 8 + 64 + 4 + len(entries)
    first += -first % 16
    head += struct.pack("<Q", first) + b"\0" * 64 + struct.pack("<I", len(names)) + entries
    with open(out, "wb") as file:
        file.write(padded(head, 16) + data)


main(*sys.argv[1:])
