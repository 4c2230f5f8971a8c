#!/usr/bin/env python3
"""Runs the programs of docs/stages with the sample character, and holds what they print to what it should be.

usage: tests/examples/stages/check.py MARROW PROGRAMS WORK
PROGRAMS: the folder of the built programs, marrow_stage_NAME each. WORK: an empty folder to work in.

A program's second line is its command line, and a comment at its end is what it prints; a number may be off by one in
its last digit. Besides, numbers are compared with what this script makes of the glTF file, with what `marrow pose`,
`info` and `export` say, and with arithmetic by hand. What the pages quote of all that must be so.
"""
import itertools
import json
import math
import pathlib
import re
import struct
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
GOLDEN = ROOT / "tests/golden"


# glTF 2.0 in double precision, as far as the sample needs it.
class Gltf:
    def __init__(self, path):
        data = path.read_bytes()
        size = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20 : 20 + size])
        self.binary = data[28 + size :]
        self.nodes = self.json["nodes"]
        self.number = {n.get("name"): i for i, n in enumerate(self.nodes)}
        self.parent = {c: i for i, n in enumerate(self.nodes) for c in n.get("children", [])}

    def floats(self, accessor):
        a = self.json["accessors"][accessor]
        view = self.json["bufferViews"][a["bufferView"]]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[a["type"]]
        flat = struct.unpack_from(f"<{a['count'] * width}f", self.binary, view.get("byteOffset", 0) + a.get("byteOffset", 0))
        return [flat[i : i + width] for i in range(0, len(flat), width)]

    def rest(self):
        return {(i, path): tuple(n.get(path, default)) for i, n in enumerate(self.nodes) for path, default in
                (("translation", (0, 0, 0)), ("rotation", (0, 0, 0, 1)), ("scale", (1, 1, 1)))}

    # {(node, path): value} of all nodes; weights as the target's node, "weights".
    def pose(self, name, time):
        out = self.rest()
        animation = next(a for a in self.json["animations"] if a["name"] == name)
        for channel in animation["channels"]:
            sampler = animation["samplers"][channel["sampler"]]
            times = [t for (t,) in self.floats(sampler["input"])]
            path = channel["target"]["path"]
            values = self.floats(sampler["output"])
            if path == "weights":
                flat = [v for (v,) in values]
                width = len(flat) // len(times)
                values = [tuple(flat[i : i + width]) for i in range(0, len(flat), width)]
            value = evaluate(times, values, sampler.get("interpolation", "LINEAR"), path == "rotation", time)
            out[channel["target"]["node"], path] = value
        return out

    def place(self, pose, name):
        node, point = self.number[name], (0.0, 0.0, 0.0)
        while node is not None:
            scaled = [p * s for p, s in zip(point, pose[node, "scale"])]
            point = [a + b for a, b in zip(turned(pose[node, "rotation"], scaled), pose[node, "translation"])]
            node = self.parent.get(node)
        return point


def evaluate(times, values, interpolation, rotation, time):
    cubic = interpolation == "CUBICSPLINE"
    key = (lambda i: values[3 * i + 1]) if cubic else (lambda i: values[i])
    if time <= times[0]:
        return key(0)
    if time >= times[-1]:
        return key(len(times) - 1)
    i = max(j for j, t in enumerate(times) if t <= time)
    if interpolation == "STEP":
        return key(i)
    step = times[i + 1] - times[i]
    u = (time - times[i]) / step
    if cubic:
        out = [(2 * u**3 - 3 * u**2 + 1) * a + step * (u**3 - 2 * u**2 + u) * ta + (3 * u**2 - 2 * u**3) * b
               + step * (u**3 - u**2) * tb for a, ta, b, tb in zip(key(i), values[3 * i + 2], key(i + 1), values[3 * i + 3])]
        return unit(out) if rotation else tuple(out)
    if not rotation:
        return tuple(a + (b - a) * u for a, b in zip(key(i), key(i + 1)))
    a, b = key(i), key(i + 1)
    cosine = sum(x * y for x, y in zip(a, b))
    if cosine < 0:
        b, cosine = [-x for x in b], -cosine
    angle = math.acos(min(1, cosine))
    if angle < 1e-6:
        return a
    return unit([(math.sin((1 - u) * angle) * x + math.sin(u * angle) * y) / math.sin(angle) for x, y in zip(a, b)])


def unit(q):
    length = math.sqrt(sum(x * x for x in q))
    return tuple(x / length for x in q)


def turned(q, v):
    x, y, z, w = q
    t = (2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0]))
    return (v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
            v[2] + w * t[2] + x * t[1] - y * t[0])


# Means of two poses by weights a and 1 - a: quaternions of one hemisphere are summed.
def mean(one, a, other):
    out = {}
    for key, value in one.items():
        b = other[key]
        if key[1] == "rotation" and sum(x * y for x, y in zip(value, b)) < 0:
            b = [-x for x in b]
        out[key] = [a * x + (1 - a) * y for x, y in zip(value, b)]
        if key[1] == "rotation":
            out[key] = unit(out[key])
    return out


class Check:
    def __init__(self, marrow, programs, work):
        self.marrow, self.programs, self.work = marrow, programs, work
        self.failures = []
        self.count = 0
        self.printed = {}

    def say(self, *arguments):
        return subprocess.run([self.marrow, *arguments], cwd=self.work, check=True, capture_output=True, text=True).stdout

    # Vertices of a pose, {mesh: [(x, y, z), …]}.
    def obj(self, *arguments):
        self.say("pose", *arguments, "-o", "pose.obj")
        meshes = {}
        for line in (self.work / "pose.obj").read_text().splitlines():
            if line.startswith("o "):
                vertices = meshes.setdefault(line[2:], [])
            elif line.startswith("v "):
                vertices.append(tuple(float(x) for x in line.split()[1:]))
        return meshes

    # What a program printed, as the numbers of the line that begins so.
    def numbers(self, program, start):
        for line in self.printed[program].splitlines():
            if line.startswith(start):
                return [float(x) for x in re.findall(r"(?<![\w.])-?\d+(?:\.\d+)?(?![\w\[]|\.\w)", line[len(start):])]
        self.failures.append(f"{program}: no line that begins with {start!r}")
        return []

    def near(self, what, got, want, tolerance):
        self.count += 1
        if len(got) != len(want) or not all(abs(a - b) <= tolerance for a, b in zip(got, want)):
            self.failures.append(f"{what}: {got} where it should be {[round(float(x), 5) for x in want]}")

    # A rotation, whose sign is open.
    def near_rotation(self, what, got, want, tolerance):
        sign = -1 if sum(a * b for a, b in zip(got, want)) < 0 else 1
        self.near(what, got, [sign * x for x in want], tolerance)


def split_numbers(text):
    return re.split(r"(-?\d+(?:\.\d+)?)", text)


# Equal but for one in the last digit of numbers with a fraction.
def same_text(got, want):
    a, b = split_numbers(got), split_numbers(want)
    if len(a) != len(b):
        return False
    for x, y in zip(a, b):
        if x == y:
            continue
        if "." not in y or not re.fullmatch(r"-?\d+\.\d+", x):
            return False
        if abs(float(x) - float(y)) > 1.01 * 10 ** -len(y.split(".")[1]):
            return False
    return True


def wanted(source):
    text = source.read_text()
    found = re.search(r"\n// Prints:\n((?://.*\n)+)\Z", text)
    return re.sub(r"(?m)^//   ?", "", found.group(1)) if found else None


def run_programs(c):
    for source in sorted(HERE.glob("*.cpp")):
        text = source.read_text()
        name, *arguments = re.search(r"\n// \$ (.*)\n", text).group(1).split()
        if name != source.stem:
            c.failures.append(f"{source.name}: its command line is of {name}")
        if source.stem != "mistakes" and text.count("\n") > 80:
            c.failures.append(f"{source.name}: {text.count(chr(10))} lines")
        result = subprocess.run([c.programs / f"marrow_stage_{source.stem}", *arguments], cwd=c.work, text=True,
                                capture_output=True)
        c.printed[source.stem] = result.stdout
        c.count += 1
        if result.returncode != 0:
            c.failures.append(f"{source.stem} exits with {result.returncode}: {result.stderr}")
        want = wanted(source)
        if want is not None and not same_text(result.stdout, want):
            c.failures.append(f"{source.stem} prints\n{result.stdout}instead of\n{want}")


def check_loading(c):
    info = json.loads(c.say("info", "hero.mrw", "--json"))
    skeleton = info["skeletons"][0]
    c.near("joints", c.numbers("loading", f"skeleton \"{skeleton['name']}\":")[:1], [skeleton["joints"]], 0)
    for clip in info["clips"]:
        c.near(clip["name"], c.numbers("loading", f"clip \"{clip['name']}\":"), [clip["duration_s"]], 0.0006)
    for mesh in info["meshes"]:
        c.near(mesh["name"], c.numbers("loading", f"mesh \"{mesh['name']}\":"), [mesh["vertices"], mesh["triangles"]], 0)
    total = sum(mesh["vertices"] for mesh in info["meshes"])
    meshes = len(info["meshes"])
    c.near("an outfit", c.numbers("outfits", ""), [meshes, meshes, 60 * 2 * total, 60], 0)
    c.near("vertices", [float(re.search(r"(\d+) vertices are skinned", c.printed["characters"]).group(1))], [total], 0)


def check_missing_file(c):
    ran = subprocess.run([c.programs / "marrow_stage_loading", "nowhere.mrw"], cwd=c.work, text=True, capture_output=True, check=False)
    c.count += 1
    if ran.returncode != 1 or "nowhere.mrw: No such file or directory" not in ran.stderr:
        c.failures.append(f"loading says of a file that is not there: {ran.stderr}")


def check_sampling(c, gltf):
    hand = gltf.number["hand.L"]
    walk = gltf.pose("walk", 0.3)
    got = c.numbers("sampling", "hand.L:")
    c.near("hand.L's place", got[:3], walk[hand, "translation"], 0.0006)
    c.near_rotation("hand.L's rotation", got[3:], walk[hand, "rotation"], 0.002)
    c.near_rotation("hand.L at 0.1 s", c.numbers("sampling", "at 0.1 s its rotation is"),
                    gltf.pose("walk", 0.1)[hand, "rotation"], 0.002)
    c.near_rotation("hand.L of the pack", c.numbers("clip_packs", "hand.L is turned by"), walk[hand, "rotation"], 0.0002)
    c.near_rotation("hand.L by a pose map", c.numbers("pose_maps", "hand.L turns by"), walk[hand, "rotation"], 0.002)


def check_blending(c, gltf):
    pelvis, arm = gltf.number["pelvis"], gltf.number["upper_arm.L"]
    half = mean(gltf.pose("idle", 0.5), 0.5, gltf.pose("walk", 0.4))
    for line in ("blended", "reaching"):
        got = c.numbers("blending", f"{line}: pelvis")
        c.near(f"{line} pelvis", got[:3], half[pelvis, "translation"], 0.0003)
        c.near_rotation(f"{line} pelvis turns", got[3:], half[pelvis, "rotation"], 0.002)
    reach = gltf.pose("reach", 1.5)
    c.near_rotation("the arm", c.numbers("blending", "reaching: upper_arm.L")[3:], reach[arm, "rotation"], 0.002)
    later, first = gltf.pose("idle", 1.5), gltf.pose("idle", 0)
    breath = [x + 0.5 * (b - a) for x, a, b in
              zip(half[pelvis, "translation"], first[pelvis, "translation"], later[pelvis, "translation"])]
    c.near("breath", c.numbers("blending", "breathing: pelvis")[:3], breath, 0.0004)
    # 24 frames of the character: the idle clip and the walk at 0.4 s, half and half.
    both = mean(gltf.pose("idle", 0.4), 0.5, gltf.pose("walk", 0.4))
    c.near("a character's hand", c.numbers("characters", "hand.L is at"), gltf.place(both, "hand.L"), 0.0015)


def check_transitions(c, gltf):
    sway = lambda clip, time: 1000 * gltf.pose(clip, time)[gltf.number["pelvis"], "translation"][0]
    frame, whole, start = 1 / 60, 0.25, 0.5
    begin = sway("walk", start) - sway("idle", 0)
    speed = (sway("walk", start) - sway("walk", start - frame)) / frame
    for time in (0, 5 * frame, 10 * frame, 15 * frame):
        walk, idle = sway("walk", start + time), sway("idle", time)
        share = time / whole
        fade = 3 * share**2 - 2 * share**3
        # The quintic of begin_inertia(): of a duration in which it does not pass 0.
        ends = min(whole, -5 * begin / speed) if begin * speed < 0 else whole
        s = min(time / ends, 1)
        offset = (1 - s) ** 4 * (begin + (4 * begin + speed * ends) * s)
        c.near(f"transition at {time:.3f} s", c.numbers("transitions", f"{time:.3f} s"),
               [walk, idle, walk + (idle - walk) * fade, idle + offset], 0.3)


def check_posed(c, gltf):
    walk = gltf.pose("walk", 0.4)
    c.near("the hand", c.numbers("posed", "hand.L is at"), gltf.place(walk, "hand.L"), 0.0011)
    x, y, z, w = walk[gltf.number["forearm.L"], "rotation"]
    walk[gltf.number["forearm.L"], "rotation"] = (-x, -y, -z, w)
    c.near("the bent arm", c.numbers("posed", "and with the elbow bent the other way"), gltf.place(walk, "hand.L"), 0.0011)
    always = c.numbers("posed", "the walk stays within")
    farthest = 0
    for frame in range(5):
        for v in c.obj("hero.mrw", "--clip", "walk", "--time", str(0.3 * frame))["body"]:
            farthest = max(farthest, math.dist(v, always[1:4]))
    c.count += 1
    if not always[0] / 1.1 <= farthest <= always[0] + 0.005:
        c.failures.append(f"the walk's vertices go as far as {farthest}, its bounds as {always[0]}")


def check_skinning(c):
    ssd, smooth = (c.obj("smooth.mrw", "--clip", "twist", "--time", "1.4", "--deformer", d)["body"] for d in ("ssd", "as"))
    for name, vertices in (("SSD:", ssd), ("AS :", smooth)):
        top = max(vertices, key=lambda v: v[1])
        c.near(name, c.numbers("skinning", f"{name} the highest vertex is at"), top, 0.0001)
    apart = lambda a, b: 1000 * max(math.dist(v, w) for v, w in zip(a, b))
    c.near("SSD and AS", c.numbers("skinning", "they differ by up to"), [apart(ssd, smooth)], 0.1)
    clip = json.loads(c.say("info", "learnt.mrw", "--json"))["clips"][0]
    posed = {d: c.obj("learnt.mrw", "--clip", clip["name"], "--time", str(clip["duration_s"] / 2), "--deformer", d)["sleeve"]
             for d in ("ssd", "rigid", "as", "mwe", "psd")}
    for name, deformer in (("rigid", "rigid"), ("animation space", "as"), ("multi-weight enveloping", "mwe"),
                           ("pose space", "psd")):
        c.near(name, c.numbers("deformers", f"{name}: up to"), [apart(posed["ssd"], posed[deformer])], 0.1)


def check_morphs(c):
    c.say("export", "morphs.mrw", "-o", "exported.glb")
    exported = Gltf(c.work / "exported.glb")
    for time in (0, 0.7, 1.4):
        pose = exported.pose("twist", time)
        weights = next(v for (_, path), v in pose.items() if path == "weights")
        c.near(f"weight at {time}", c.numbers("morphs", f"{time:.1f} s: eigenskin[0] has weight")[:1], weights[:1], 0.0002)
        if time:
            continue
        weights = next(v for (_, path), v in exported.pose("walk", 0.4).items() if path == "weights")
        c.near("channel", c.numbers("channels", "0.4 s: body.eigenskin[0] is")[:1], weights[:1], 0.0002)


def check_shapes(c):
    # At an example's place its target has all the weight: tests/golden/shapes.toml.
    for place, weights in (("0.0 0.0", (0, 0)), ("1.0 0.0", (100, 0)), ("0.0 1.0", (0, 100)), ("2.0 2.0", (100, 0))):
        c.near(f"shapes at {place}", c.numbers("shapes", f"at {place}:"), weights, 0)


def check_curves(c):
    points = [(0, 0), (1, 1), (2, 0), (4, 0)]
    # The natural spline's slopes of keys 1 apart: 2 m0 + m1 = 3 (p1 - p0); m_{i-1} + 4 m_i + m_{i+1} = 3 (p_{i+1} - p_{i-1}).
    slopes = []
    for axis in (0, 1):
        p = [point[axis] for point in points]
        rows = [[2, 1, 0, 0, 3 * (p[1] - p[0])], [1, 4, 1, 0, 3 * (p[2] - p[0])], [0, 1, 4, 1, 3 * (p[3] - p[1])],
                [0, 0, 1, 2, 3 * (p[3] - p[2])]]
        for i in range(4):
            for j in range(i + 1, 4):
                rows[j] = [b - a * rows[j][i] / rows[i][i] for a, b in zip(rows[i], rows[j])]
        m = [0] * 4
        for i in reversed(range(4)):
            m[i] = (rows[i][4] - sum(rows[i][j] * m[j] for j in range(i + 1, 4))) / rows[i][i]
        slopes.append(m)

    def at(time):
        i = min(int(time), 2)
        return [evaluate([0, 1], [(0,), (points[i][a],), (slopes[a][i],), (slopes[a][i + 1],), (points[i + 1][a],), (0,)],
                         "CUBICSPLINE", False, time - i)[0] for a in (0, 1)]
    place, before, after = at(1.5), at(1.4999), at(1.5001)
    speed = [(b - a) / 0.0002 for a, b in zip(before, after)]
    c.near("the spline", c.numbers("curves", "at 1.5 s:"), place + speed, 0.0002)
    steps = [math.dist(at(i / 3000), at((i + 1) / 3000)) for i in range(9000)]
    whole = sum(steps)
    c.near("its length", c.numbers("curves", "the path is"), [whole], 0.002)
    lengths = list(itertools.accumulate(steps))
    for quarter in (1, 2, 3):
        time = next(i for i, x in enumerate(lengths) if x >= whole * quarter / 4) / 3000
        c.near(f"quarter {quarter}", c.numbers("curves", f"after {quarter} quarters:"), at(time) + [time], 0.01)
    # 0.5², 4 · 0.5³, and the middle of a curve that is the same from both ends.
    c.near("easings", c.numbers("curves", "half way: quad in")[:1] + c.numbers("curves", "half way: quad in 0.25, cubic in and out"),
           [0.25, 0.5, 0.5], 0)


def check_debug_lines(c):
    # A bone for each joint but the root, and three axes each; the box's edges and three circles of 16.
    lines = c.printed["debug_lines"].splitlines()
    c.near("lines of joints", [float(lines[0].split()[0])], [43 + 3 * 44], 0)
    c.near("lines of bounds", [float(lines[2].split()[0])], [12 + 3 * 16], 0)


# What the pages quote: what is printed, and what is said of mistakes.
def check_pages(c):
    prints = [wanted(source) or "" for source in HERE.glob("*.cpp")]
    said = c.printed["mistakes"].splitlines()
    quoted = 0
    for page in sorted((ROOT / "docs/stages").glob("*.md")):
        text = page.read_text()
        for block in re.findall(r"(?m)^```text\n(.*?)^```$", text, re.S):
            c.count += 1
            if not any(block in p for p in prints):
                c.failures.append(f"{page.name} shows what no program prints:\n{block}")
        for line in re.findall(r"(?m)^\| `([^`]+: [^`]+)`[^|]*\|", text.partition("## Mistakes")[2].replace("\\|", "¦")):
            quoted += 1
            if line.replace("¦", "|") not in said:
                c.failures.append(f"{page.name} quotes what no mistake brings: {line}")
    if quoted < 20:
        c.failures.append(f"the pages quote {quoted} mistakes alone")


def main():
    marrow, programs, work = (pathlib.Path(a).resolve() for a in sys.argv[1:])
    work.mkdir(parents=True, exist_ok=True)
    c = Check(marrow, programs, work)
    c.say("sample", "-o", "hero.glb")
    cookings = [
        ["hero.mrw"],
        ["morphs.mrw", "--clip-codec", "raw", "--eigenskin", "4"],
        ["smooth.mrw", "--clip-codec", "raw", "--as", "smooth"],
        ["pack.mrw", "--clip-codec", "raw", "--clips-only", "--skeleton", "hero.glb"],
        ["mapped.mrw", "--clip-codec", "raw", "--pose-map", "hero.glb"],  # onto itself
        ["behaving.mrw", "--root", "*=ground", "--graph", str(HERE / "animator.anim.toml")],
        ["suit.mrw", "--clip-codec", "raw", "--skeleton", "hero.glb"],  # the sample in its own skin
    ]
    running = [subprocess.Popen([marrow, "cook", "hero.glb", "-o", *options], cwd=work, stdout=subprocess.DEVNULL,
                                stderr=subprocess.PIPE, text=True) for options in cookings]
    for options, process in zip(cookings, running):
        said = process.communicate()[1]
        if process.returncode != 0:
            sys.exit(f"{options[0]}: {said}")
    c.say("cook", str(GOLDEN / "elbow.gltf"), "-o", "learnt.mrw", "--as", "smooth", "--truth", "dqs", "--mwe", "--psd", "2")
    for name, golden in (("stranger", "dance_v1"), ("face", "shapes_v1")):
        (work / f"{name}.mrw").write_bytes((GOLDEN / f"{golden}.mrw").read_bytes())
    run_programs(c)
    gltf = Gltf(work / "hero.glb")
    check_loading(c)
    check_missing_file(c)
    check_sampling(c, gltf)
    check_blending(c, gltf)
    check_transitions(c, gltf)
    check_posed(c, gltf)
    check_skinning(c)
    check_morphs(c)
    check_shapes(c)
    check_curves(c)
    check_debug_lines(c)
    if c.printed["mistakes"]:  # a build without texts of bad calls says nothing
        check_pages(c)
    for failure in c.failures:
        print(failure, file=sys.stderr)
    print(f"{c.count} checks, {len(c.failures)} failures")
    return 1 if c.failures or c.count < 60 else 0


if __name__ == "__main__":
    sys.exit(main())
