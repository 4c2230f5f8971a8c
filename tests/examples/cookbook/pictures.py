#!/usr/bin/env python3
"""Draws, by marrow and ffmpeg, the poses that the recipes of docs/ik/cookbook.md save, with what the hands and feet are on.

usage: pictures.py MARROW HERO.glb POSES DOCS_IMAGES    (POSES: the folder that was given to hands, look, legs, body)
"""
import json
import pathlib
import struct
import subprocess
import sys

BOXES = {  # of each recipe: middle and half sizes, metres
    "rail": [((0.38, 0.57, 0), (0.02, 0.02, 0.7)), ((0.38, 0.28, -0.6), (0.015, 0.28, 0.015)),
             ((0.38, 0.28, 0.6), (0.015, 0.28, 0.015))],
    "stairs": [((0, 0.03 * s - 0.05, 0.3 * s + 0.15), (0.45, 0.03 * s + 0.05, 0.15)) for s in range(5)],
    "seat-low": [((0, 0.11, -0.22), (0.2, 0.11, 0.13))],
    "seat-high": [((0, 0.145, -0.22), (0.2, 0.145, 0.13))],
    "door": [((0.25, 0.38, 0.66), (0.08, 0.015, 0.015)), ((0.25, 0.3, 0.7), (0.25, 0.3, 0.02))],
    "look": [((0.9, 1.5, 0.8), (0.03, 0.03, 0.03))],
}
MOVED = {"stairs": 0.375 * 118 / 60}  # how far the character has walked, along z
VIEWS = {"rail": "three-quarter", "stairs": "left", "seat-low": "left", "seat-high": "left", "door": "left"}


def read_glb(path):
    data = path.read_bytes()
    size = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + size]), data[28 + size:]


def write_glb(path, gltf, binary):
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    path.write_bytes(struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(binary), len(text), 0x4E4F534A) + text +
                     struct.pack("<II", len(binary), 0x004E4942) + binary)


def add_box(gltf, binary, middle, half):
    corners, triangles = [], []
    for axis in range(3):
        for sign in (-1, 1):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            first = len(corners)
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                place, normal = [0, 0, 0], [0, 0, 0]
                place[axis], place[u], place[v] = sign, a * sign, b
                normal[axis] = sign
                corners.append(([m + h * p for m, h, p in zip(middle, half, place)], normal))
            triangles += [first, first + 1, first + 2, first, first + 2, first + 3]
    at = len(binary)
    binary += b"".join(struct.pack("<3f", *place) for place, _ in corners)
    binary += b"".join(struct.pack("<3f", *normal) for _, normal in corners)
    binary += struct.pack(f"<{len(triangles)}H", *triangles)
    lows = [min(c[0][i] for c in corners) for i in range(3)]
    highs = [max(c[0][i] for c in corners) for i in range(3)]
    views, accessors = gltf["bufferViews"], gltf["accessors"]
    for offset, length in ((0, 288), (288, 288), (576, 72)):
        views.append({"buffer": 0, "byteOffset": at + offset, "byteLength": length})
    n = len(accessors)
    accessors += [{"bufferView": len(views) - 3, "componentType": 5126, "count": 24, "type": "VEC3", "min": lows, "max": highs},
                  {"bufferView": len(views) - 2, "componentType": 5126, "count": 24, "type": "VEC3"},
                  {"bufferView": len(views) - 1, "componentType": 5123, "count": 36, "type": "SCALAR"}]
    if gltf["materials"][-1].get("name") != "prop":
        gltf["materials"].append({"name": "prop", "pbrMetallicRoughness": {"baseColorFactor": [0.34, 0.31, 0.27, 1]}})
    gltf["meshes"].append({"primitives": [{"attributes": {"POSITION": n, "NORMAL": n + 1}, "indices": n + 2,
                                           "material": len(gltf["materials"]) - 1}]})
    gltf["nodes"].append({"mesh": len(gltf["meshes"]) - 1})
    gltf["scenes"][0]["nodes"].append(len(gltf["nodes"]) - 1)
    return binary


def main():
    marrow, hero, poses, images = sys.argv[1], *map(pathlib.Path, sys.argv[2:])
    for pose in sorted(poses.glob("*.pose")):
        name = pose.stem
        gltf, binary = read_glb(hero)
        gltf.pop("animations", None)
        at = {node.get("name"): node for node in gltf["nodes"]}
        for line in pose.read_text().splitlines():
            joint, *numbers = line.split(" ")
            numbers = list(map(float, numbers))
            at[joint]["translation"], at[joint]["rotation"] = numbers[:3], numbers[3:]
        at["Armature"]["translation"] = [0, 0, MOVED.get(name, 0)]
        for middle, half in BOXES.get(name, []):
            binary = add_box(gltf, binary, middle, half)
        gltf["buffers"][0]["byteLength"] = len(binary)
        glb, cooked = poses / f"{name}.glb", poses / f"{name}.mrw"
        write_glb(glb, gltf, binary)
        subprocess.run([marrow, "cook", glb, "-o", cooked, "--mesh-codec", "none"], check=True, stdout=subprocess.DEVNULL)
        drawn = poses / f"{name}.png"
        subprocess.run([marrow, "render", cooked, "--view", VIEWS.get(name, "three-quarter"), "--size", "720x600", "-o", drawn],
                       check=True)
        subprocess.run(["ffmpeg", "-v", "error", "-y", "-i", drawn, "-vf", "scale=400:-1:flags=area,split[a][b];"
                        "[a]palettegen=max_colors=255[p];[b][p]paletteuse=dither=bayer:bayer_scale=4",
                        images / f"cookbook-{name}.png"], check=True)


main()
