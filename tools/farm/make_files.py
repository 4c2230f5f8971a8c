#!/usr/bin/env python3
"""Makes a folder of rigged models to try cooking on many machines with: worms that crawl, a few of them large.

usage: make_files.py FOLDER COUNT [SEED]

The same bytes for the same numbers. Sizes are spread as a studio's are: half of the files have below 700 vertices, one in
fifty has above 6 000; clips have 20 to 120 frames. A subfolder has at most 200.
"""
import array
import json
import math
import pathlib
import random
import struct
import sys


def worm(rings, sides, joints):
    """A tube along Y: positions, joints and weights of each vertex, triangles."""
    positions, places, weights, triangles = array.array('f'), array.array('H'), array.array('f'), array.array('H')
    for ring in range(rings):
        along = ring / (rings - 1)
        radius = 0.1 * (0.3 + math.sin(math.pi * along))
        at = along * (joints - 1)
        first = min(int(at), joints - 2)
        for side in range(sides):
            angle = 2 * math.pi * side / sides
            positions.extend((radius * math.cos(angle), along * 0.2 * joints, radius * math.sin(angle)))
            places.extend((first, first + 1, 0, 0))
            weights.extend((1 - (at - first), at - first, 0, 0))
            if ring + 1 < rings:
                here, beside = ring * sides + side, ring * sides + (side + 1) % sides
                triangles.extend((here, here + sides, beside, beside, here + sides, beside + sides))
    return positions, places, weights, triangles


def motion(rng, joints, frames):
    """Times, and for each joint a quaternion a frame: sums of three waves about X and Z."""
    times = array.array('f', (frame / 30 for frame in range(frames)))
    tracks = []
    for _ in range(joints):
        waves = [[(rng.uniform(0, 0.25), rng.uniform(0.5, 6), rng.uniform(0, 6.28)) for _ in range(3)] for _ in range(2)]
        track = array.array('f')
        for time in times:
            x, z = (sum(size * math.sin(rate * time + start) for size, rate, start in wave) for wave in waves)
            half = 0.5 * math.hypot(x, z)
            scale = 0.5 * math.sin(half) / half if half > 1e-9 else 0.5
            track.extend((x * scale, 0, z * scale, math.cos(half)))
        tracks.append(track)
    return times, tracks


class Glb:
    def __init__(self):
        self.bytes, self.views, self.accessors = bytearray(), [], []

    def add(self, values, component, kind, **more):
        width = {'SCALAR': 1, 'VEC3': 3, 'VEC4': 4, 'MAT4': 16}[kind]
        self.bytes += b'\0' * (-len(self.bytes) % 4)
        data = values.tobytes()
        self.views.append({'buffer': 0, 'byteOffset': len(self.bytes), 'byteLength': len(data)})
        self.bytes += data
        self.accessors.append({'bufferView': len(self.views) - 1, 'componentType': component, 'type': kind,
                               'count': len(values) // width, **more})
        return len(self.accessors) - 1

    def write(self, path, document):
        document.update({'asset': {'version': '2.0'}, 'bufferViews': self.views, 'accessors': self.accessors,
                         'buffers': [{'byteLength': len(self.bytes)}]})
        text = json.dumps(document, separators=(',', ':')).encode()
        text += b' ' * (-len(text) % 4)
        data = bytes(self.bytes) + b'\0' * (-len(self.bytes) % 4)
        path.write_bytes(struct.pack('<III', 0x46546C67, 2, 28 + len(text) + len(data)) +
                         struct.pack('<II', len(text), 0x4E4F534A) + text + struct.pack('<II', len(data), 0x004E4942) + data)


def write_model(path, rng):
    joints = rng.randint(4, 24)
    sides = rng.randint(8, 24)
    rings = min(max(int(math.exp(rng.gauss(math.log(660), 1.1)) / sides), joints), 65000 // sides)
    frames = rng.randint(20, 120)
    positions, places, weights, triangles = worm(rings, sides, joints)
    times, tracks = motion(rng, joints, frames)
    glb = Glb()
    low = [min(positions[axis::3]) for axis in range(3)]
    high = [max(positions[axis::3]) for axis in range(3)]
    attributes = {'POSITION': glb.add(positions, 5126, 'VEC3', min=low, max=high),
                  'JOINTS_0': glb.add(places, 5123, 'VEC4'), 'WEIGHTS_0': glb.add(weights, 5126, 'VEC4')}
    indices = glb.add(triangles, 5123, 'SCALAR')
    binds = array.array('f')
    for joint in range(joints):
        binds.extend((1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -0.2 * joint, 0, 1))
    inverse = glb.add(binds, 5126, 'MAT4')
    time = glb.add(times, 5126, 'SCALAR', min=[0], max=[times[-1]])
    samplers, channels = [], []
    for joint, track in enumerate(tracks):
        samplers.append({'input': time, 'output': glb.add(track, 5126, 'VEC4')})
        channels.append({'sampler': joint, 'target': {'node': joint, 'path': 'rotation'}})
    nodes = [{'name': f'joint.{joint}', 'translation': [0, 0.2 if joint else 0, 0],
              **({'children': [joint + 1]} if joint + 1 < joints else {})} for joint in range(joints)]
    nodes.append({'name': 'worm', 'mesh': 0, 'skin': 0})
    glb.write(path, {
        'scene': 0, 'scenes': [{'nodes': [0, joints]}], 'nodes': nodes,
        'meshes': [{'primitives': [{'attributes': attributes, 'indices': indices}]}],
        'skins': [{'joints': list(range(joints)), 'inverseBindMatrices': inverse}],
        'animations': [{'name': 'crawl', 'samplers': samplers, 'channels': channels}]})


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    folder, count = pathlib.Path(sys.argv[1]), int(sys.argv[2])
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    for number in range(count):
        path = folder / f'{number // 200:03}' / f'{number:06}.glb'
        path.parent.mkdir(parents=True, exist_ok=True)
        write_model(path, random.Random(seed * 1_000_003 + number))


if __name__ == '__main__':
    main()
