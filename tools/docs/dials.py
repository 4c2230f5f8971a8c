#!/usr/bin/env python3
"""Draws docs/images/dials: what the dials of `--truth elastic` do to an arm that bends, and to one that twists.

usage: tools/docs/dials.py MARROW [FOLDER]
"""
import base64
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
RINGS, SIDES = 49, 32
LENGTH_M, RADIUS_M = 2.0, 0.22
BLEND_M = 0.3  # to each side of the joint both weigh
# picture: the motion, the dials
PICTURES = {
    "bend": ("bend", "volume=6,keep=0.1"), "bend-keep-1": ("bend", "volume=6,keep=1"),
    "twist": ("twist", "volume=6,keep=0.1"), "twist-volume-60": ("twist", "volume=60,keep=0.1"),
}
TURNS = {"bend": ((0, 0, 1), 120), "twist": ((0, 1, 0), 170)}  # axis, degrees


def arm(motion):
    """A closed tube along y on two joints, the second in its middle, as glTF."""
    positions, normals, joints, weights, indices = [], [], [], [], []
    for ring in range(RINGS):
        y = LENGTH_M * ring / (RINGS - 1)
        end = min(y, LENGTH_M - y) / RADIUS_M  # half balls close the ends
        radius = RADIUS_M * (math.sqrt(max(0, 1 - (1 - end) ** 2)) if end < 1 else 1)
        upper = min(1, max(0, (y - LENGTH_M / 2 + BLEND_M) / (2 * BLEND_M)))
        upper = upper * upper * (3 - 2 * upper)
        for side in range(SIDES):
            angle = 2 * math.pi * side / SIDES
            positions.append((radius * math.sin(angle), y, radius * math.cos(angle)))
            slope = max(0, 1 - end) * (1 if y > LENGTH_M / 2 else -1)
            along = radius / RADIUS_M
            normals.append((along * math.sin(angle), slope, along * math.cos(angle)))
            joints.append((0, 1, 0, 0))
            weights.append((1 - upper, upper, 0, 0))
    for ring in range(RINGS - 1):
        for side in range(SIDES):
            a, b = ring * SIDES + side, ring * SIDES + (side + 1) % SIDES
            if ring > 0:
                indices += [a, b, b + SIDES]
            if ring < RINGS - 2:
                indices += [a, b + SIDES, a + SIDES]
    axis, degrees = TURNS[motion]
    frames = 24
    times = [i / 24 for i in range(frames + 1)]
    turns = []
    for i in range(frames + 1):
        half = math.radians(degrees) * i / frames / 2
        turns.append(tuple(math.sin(half) * a for a in axis) + (math.cos(half),))
    inverse = [(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -y, 0, 1) for y in (0, LENGTH_M / 2)]
    buffer, views, accessors = b"", [], []

    def add(rows, code, component, kind):
        nonlocal buffer
        rows = [row if isinstance(row, tuple) else (row,) for row in rows]
        data = b"".join(struct.pack(f"<{len(row)}{code}", *row) for row in rows)
        views.append({"buffer": 0, "byteOffset": len(buffer), "byteLength": len(data)})
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": len(rows), "type": kind,
                          "min": [min(c) for c in zip(*rows)], "max": [max(c) for c in zip(*rows)]})
        buffer += data + bytes(-len(data) % 4)
        return len(accessors) - 1

    attributes = {"POSITION": add(positions, "f", 5126, "VEC3"), "NORMAL": add(normals, "f", 5126, "VEC3"),
                  "JOINTS_0": add(joints, "B", 5121, "VEC4"), "WEIGHTS_0": add(weights, "f", 5126, "VEC4")}
    primitive = {"attributes": attributes, "indices": add(indices, "H", 5123, "SCALAR"), "material": 0}
    sampler = {"input": add(times, "f", 5126, "SCALAR"), "output": add(turns, "f", 5126, "VEC4")}
    return {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"name": "arm", "mesh": 0, "skin": 0}, {"name": "lower", "children": [2]},
                  {"name": "upper", "translation": [0, LENGTH_M / 2, 0]}],
        "meshes": [{"primitives": [primitive]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.45, 0.32, 1], "metallicFactor": 0,
                                                "roughnessFactor": 0.6}}],
        "skins": [{"joints": [1, 2], "inverseBindMatrices": add(inverse, "f", 5126, "MAT4")}],
        "animations": [{"name": motion, "samplers": [sampler],
                        "channels": [{"sampler": 0, "target": {"node": 2, "path": "rotation"}}]}],
        "accessors": accessors, "bufferViews": views,
        "buffers": [{"byteLength": len(buffer), "uri": "data:application/octet-stream;base64,"
                     + base64.b64encode(buffer).decode()}]}


def shrink(picture, out):
    subprocess.run(["ffmpeg", "-loglevel", "error", "-y", "-i", picture, "-vf", "scale=320:-1", "-q:v", "3", out], check=True)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    marrow = sys.argv[1]
    out = pathlib.Path(sys.argv[2]) if len(sys.argv) == 3 else ROOT / "docs/images/dials"
    out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as work:
        work = pathlib.Path(work)
        for motion in TURNS:
            (work / f"{motion}.gltf").write_text(json.dumps(arm(motion)))
        for name, (motion, dials) in PICTURES.items():
            drawn = work / name
            subprocess.run([marrow, "compare", work / f"{motion}.gltf", "--truth", "elastic", "--elastic", dials,
                            "--show", "as_lift", "--pictures", drawn, "-o", work / "page.html"],
                           check=True, stdout=subprocess.DEVNULL)
            shrink(drawn / "1-3-truth.png", out / f"{name}.jpg")
            if name == motion:
                shrink(drawn / "1-1-ssd.png", out / f"{motion}-plain.jpg")


if __name__ == "__main__":
    main()
