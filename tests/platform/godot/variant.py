"""Writes the newt as other characters stand. usage: variant.py NEWT.glb OUT.glb turned|parted

turned: below a node that moves, turns and stretches it unevenly, with names of joints that Godot refuses.
parted: its tail hangs on another such node, so that there are two roots."""
import json
import struct
import sys


def main(source, out, how):
    with open(source, "rb") as file:
        data = file.read()
    size = struct.unpack_from("<I", data, 12)[0]
    scene = json.loads(data[20:20 + size])
    nodes = scene["nodes"]
    joint = {node.get("name"): i for i, node in enumerate(nodes)}
    nodes[joint["Armature"]].update(translation=[0.5, 0.25, -1], rotation=[0.5, 0.5, -0.5, 0.5], scale=[0.5, 0.25, 2])
    nodes[joint["pelvis"]]["name"] = "rig:pelvis"
    nodes[joint["head"]]["name"] = "rig/head"
    nodes[joint["tail_8"]]["name"] = "rig_head"
    if how == "parted":
        for node in nodes:
            if joint["tail_1"] in node.get("children", []):
                node["children"].remove(joint["tail_1"])
        scene["scenes"][0]["nodes"].append(len(nodes))
        nodes.append({"name": "Other", "translation": [0, 1, 0], "children": [joint["tail_1"]]})
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + size:]
    with open(out, "wb") as file:
        file.write(struct.pack("<4sIII4s", b"glTF", 2, 20 + len(text) + len(rest), len(text), b"JSON") + text + rest)


main(*sys.argv[1:])
