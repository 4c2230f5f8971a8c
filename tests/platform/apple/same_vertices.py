"""Says whether every vertex of one file is in another, in order and to the bit: float32 x y z each.

usage: same_vertices.py VERTICES SLOTS
VERTICES: of `marrow pose -o P.bin`. SLOTS: the same with padding between, as the runtime skins them.
"""

import pathlib
import sys


def points(name):
    data = pathlib.Path(name).read_bytes()
    return [data[i : i + 12] for i in range(0, len(data), 12)]


def main():
    vertices, slots = points(sys.argv[1]), points(sys.argv[2])
    rest = iter(slots)
    for number, vertex in enumerate(vertices):
        if vertex not in rest:  # which takes from rest up to the vertex
            print(f"{sys.argv[2]}: vertex {number} of {len(vertices)} is other bits", file=sys.stderr)
            return 1
    if not vertices or len(slots) > len(vertices) * 1.1:
        print(f"{sys.argv[2]}: {len(slots)} slots for {len(vertices)} vertices", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
