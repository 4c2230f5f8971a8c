"""Scenes for growth.py that grow in one respect each, as GLB: what a stranger's file may have many of."""
import base64
import json
import math
import struct

FLOAT, U32, U16, U8 = 5126, 5125, 5123, 5121
LETTERS = {FLOAT: "f", U32: "I", U16: "H", U8: "B"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
PIXEL = base64.b64decode("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==")
TRIANGLE = [0, 0, 0, 1, 0, 0, 0, 1, 0]


class Scene:
    def __init__(self):
        self.bytes = bytearray()
        self.root = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": []}

    def put(self, what, item):
        items = self.root.setdefault(what, [])
        items.append(item)
        return len(items) - 1

    def view(self, data):
        self.bytes += bytes(-len(self.bytes) % 4)
        at = len(self.bytes)
        self.bytes += data
        return self.put("bufferViews", {"buffer": 0, "byteOffset": at, "byteLength": len(data)})

    def numbers(self, kind, component, values):
        made = {"bufferView": self.view(struct.pack(f"<{len(values)}{LETTERS[component]}", *values)), "type": kind,
                "componentType": component, "count": len(values) // WIDTHS[kind]}
        if component == FLOAT and kind in ("SCALAR", "VEC3"):
            made["min"] = [min(values[c::WIDTHS[kind]]) for c in range(WIDTHS[kind])]
            made["max"] = [max(values[c::WIDTHS[kind]]) for c in range(WIDTHS[kind])]
        return self.put("accessors", made)

    def node(self, parent=None, **more):
        index = self.put("nodes", {"name": f"n{len(self.root['nodes'])}", **more})
        if parent is None:
            self.root["scenes"][0]["nodes"].append(index)
        else:
            self.root["nodes"][parent].setdefault("children", []).append(index)
        return index

    def mesh(self, primitives):
        return self.put("meshes", {"name": f"m{len(self.root.get('meshes', []))}", "primitives": primitives})

    def triangle(self, **more):
        if not hasattr(self, "corners"):
            self.corners = self.numbers("VEC3", FLOAT, TRIANGLE)
        return {"attributes": {"POSITION": self.corners}, **more}

    # On a node that stands there already.
    def draw(self, node, primitive=None):
        self.root["nodes"][node]["mesh"] = self.mesh([primitive or self.triangle()])

    # Three vertices that follow these joints.
    def skin(self, joints):
        of = [0] * 12
        for corner in range(3):
            of[4 * corner] = (len(joints) - 1) * corner // 2
        attributes = {"POSITION": self.triangle()["attributes"]["POSITION"], "JOINTS_0": self.numbers("VEC4", U16, of),
                      "WEIGHTS_0": self.numbers("VEC4", FLOAT, [1, 0, 0, 0] * 3)}
        self.node(mesh=self.mesh([{"attributes": attributes}]), skin=self.put("skins", {"joints": joints}))

    def turning(self, nodes, name, keys=3):
        if keys not in self.__dict__.setdefault("curves", {}):
            turns = [x for k in range(keys) for x in (0, 0, math.sin(k % 7 / 10), math.cos(k % 7 / 10))]
            self.curves[keys] = {"input": self.numbers("SCALAR", FLOAT, [k / 30 for k in range(keys)]),
                                 "output": self.numbers("VEC4", FLOAT, turns)}
        self.put("animations", {"name": name, "samplers": [self.curves[keys]],
                                "channels": [{"sampler": 0, "target": {"node": n, "path": "rotation"}} for n in nodes]})

    def write(self, path):
        self.bytes += bytes(-len(self.bytes) % 4)
        self.root["buffers"] = [{"byteLength": len(self.bytes)}]
        text = json.dumps(self.root, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        with open(path, "wb") as out:
            out.write(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(self.bytes)))
            out.write(struct.pack("<II", len(text), 0x4E4F534A) + text)
            out.write(struct.pack("<II", len(self.bytes), 0x004E4942) + self.bytes)


def joints(s, n):  # of one skin, four below each
    for i in range(n):
        s.node((i - 1) // 4 if i else None, translation=[0, 1, i % 4])
    s.skin(list(range(n)))


def skins(s, n):
    for _ in range(n):
        s.skin([s.node()])


def clips(s, n):
    s.draw(s.node())
    for c in range(n):
        s.turning([0], f"clip {c}")


def channels(s, n):
    joints(s, n)
    s.turning(range(n), "clip")


def moving_skins(s, n):  # by one animation, which becomes a clip for each
    for _ in range(n):
        s.skin([s.node()])
    s.turning(range(0, 2 * n, 2), "clip")


def moving_targets(s, n):
    targets(s, n)
    times = s.numbers("SCALAR", FLOAT, [0, 1])
    weights = s.numbers("SCALAR", FLOAT, [0] * n + [1] * n)
    s.put("animations", {"name": "clip", "samplers": [{"input": times, "output": weights}],
                         "channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}]})


def moving_chain(s, n):
    for i in range(n):
        s.node(i - 1 if i else None, translation=[1e-3, 0, 0])
    s.draw(n - 1)
    s.turning(range(n), "clip")


def keys(s, n):
    s.draw(s.node())
    s.turning([0], "clip", n)


def meshes(s, n):
    for _ in range(n):
        s.draw(s.node())


def instances(s, n):
    s.mesh([s.triangle()])
    for _ in range(n):
        s.node(mesh=0)


def primitives(s, n):
    s.root["nodes"] = []
    s.node(mesh=s.mesh([s.triangle() for _ in range(n)]))


def targets(s, n):
    primitive = s.triangle()
    moved = s.numbers("VEC3", FLOAT, TRIANGLE)
    primitive["targets"] = [{"POSITION": moved} for _ in range(n)]
    s.draw(s.node(), primitive)


def images(s, n):
    s.mesh([])
    view = s.view(PIXEL)
    for i in range(n):
        texture = s.put("textures", {"source": s.put("images", {"bufferView": view, "mimeType": "image/png"})})
        material = s.put("materials", {"pbrMetallicRoughness": {"baseColorTexture": {"index": texture}}})
        s.root["meshes"][0]["primitives"].append(s.triangle(material=material))
    s.node(mesh=0)


def materials(s, n):
    s.mesh([])
    for i in range(n):
        material = s.put("materials", {"pbrMetallicRoughness": {"roughnessFactor": i / n}})
        s.root["meshes"][0]["primitives"].append(s.triangle(material=material))
    s.node(mesh=0)


def deep(s, n):
    for i in range(n):
        s.node(i - 1 if i else None, translation=[1e-3, 0, 0])
    s.draw(n - 1)
    s.turning([0, n - 1], "clip")


def wide(s, n):
    s.node()
    for _ in range(n):
        s.draw(s.node(0))
    s.turning([0], "clip")


def unused(s, n):
    s.draw(s.node())
    for _ in range(n):
        s.node(0)


def names(s, n):  # all alike
    joints(s, n)
    for node in s.root["nodes"]:
        node["name"] = "same"


def triangles(s, n, corner):  # over places that are a step or more apart, whatever they are rounded to
    positions = [x for i in range(n + 2) for x in (i % 100, i // 100 % 100, i // 10000)]
    indices = [x for i in range(n) for x in corner(i)]
    s.draw(s.node(), {"attributes": {"POSITION": s.numbers("VEC3", FLOAT, positions)},
                      "indices": s.numbers("SCALAR", U32, indices)})


def grid(s, n):
    side = math.isqrt(n // 2)
    positions = [x for j in range(side + 1) for i in range(side + 1) for x in (i, math.sin(i * j), j)]
    indices = [x for j in range(side) for i in range(side) for a in [j * (side + 1) + i]
               for x in (a, a + 1, a + side + 1, a + 1, a + side + 2, a + side + 1)]
    s.draw(s.node(), {"attributes": {"POSITION": s.numbers("VEC3", FLOAT, positions)},
                      "indices": s.numbers("SCALAR", U32, indices)})


def one_place(s, n):  # vertices that differ by their normals alone
    normals = [x for i in range(3 * n) for x in (math.cos(i), math.sin(i), 0)]
    s.draw(s.node(), {"attributes": {"POSITION": s.numbers("VEC3", FLOAT, TRIANGLE * n),
                                     "NORMAL": s.numbers("VEC3", FLOAT, normals)}})


# What grows: how it is made, and how many of it there are at 1×.
KINDS = {
    "joints": (joints, 1000),
    "skins": (skins, 250),
    "skins that move": (moving_skins, 8),
    "clips": (clips, 500),
    "channels": (channels, 125),
    "keys": (keys, 2000),
    "meshes": (meshes, 500),
    "nodes of one mesh": (instances, 1000),
    "primitives": (primitives, 500),
    "morph targets": (targets, 1000),
    "morph targets that move": (moving_targets, 200),
    "images": (images, 500),
    "materials": (materials, 500),
    "nodes deep": (deep, 500),
    "nodes deep that move": (moving_chain, 60),
    "nodes wide": (wide, 500),
    "nodes that draw nothing": (unused, 5000),
    "joints of one name": (names, 1000),
    "equal triangles": (lambda s, n: triangles(s, n, lambda i: (0, 1, 100)), 5000),
    "triangles round a vertex": (lambda s, n: triangles(s, n, lambda i: (0, i + 1, i + 2)), 5000),
    "triangles at an edge": (lambda s, n: triangles(s, n, lambda i: (0, 1, i + 2)), 5000),
    "triangles of a grid": (grid, 5000),
    "triangles at one place": (one_place, 2000),
}


def make(kind, count, path):
    scene = Scene()
    KINDS[kind][0](scene, count)
    scene.write(path)
