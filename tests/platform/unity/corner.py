"""Writes a glTF whose numbers a person can follow: a triangle on one joint, and a clip that turns the joint.

usage: corner.py OUT.gltf
The corners are (1, 0, 0), (0, 2, 0), (0, 0, 3). The clip "turn" lasts a second; at its end the joint stands at
(10, 20, 30), turned by 90 degrees about z, and at half of it by 90 degrees about y.
"""
import base64
import json
import struct
import sys

H = 0.5 ** 0.5
DATA, VIEWS, ACCESSORS = bytearray(), [], []


def accessor(kind, rows, component=5126, bounds=False):
    flat = [x for row in rows for x in row]
    packed = struct.pack('<%d%s' % (len(flat), {5126: 'f', 5123: 'H', 5121: 'B'}[component]), *flat)
    VIEWS.append({'buffer': 0, 'byteOffset': len(DATA), 'byteLength': len(packed)})
    DATA.extend(packed + b'\0' * (-len(packed) % 4))
    made = {'bufferView': len(VIEWS) - 1, 'componentType': component, 'count': len(rows), 'type': kind}
    if bounds:
        made.update(min=[min(c) for c in zip(*rows)], max=[max(c) for c in zip(*rows)])
    ACCESSORS.append(made)
    return len(ACCESSORS) - 1


third = 1 / 3 ** 0.5
mesh = {
    'POSITION': accessor('VEC3', [(1, 0, 0), (0, 2, 0), (0, 0, 3)], bounds=True),
    'NORMAL': accessor('VEC3', [(1, 0, 0), (0, 1, 0), (third, third, third)]),
    'TANGENT': accessor('VEC4', [(0, 1, 0, 1), (1, 0, 0, -1), (H, -H, 0, 1)]),
    'TEXCOORD_0': accessor('VEC2', [(0, 0), (0.25, 0.125), (1, 1)]),
    'COLOR_0': accessor('VEC4', [(255, 0, 0, 255), (0, 255, 0, 255), (0, 0, 255, 255)], 5121),
    'JOINTS_0': accessor('VEC4', [(0, 0, 0, 0)] * 3, 5121),
    'WEIGHTS_0': accessor('VEC4', [(1, 0, 0, 0)] * 3),
}
ACCESSORS[mesh['COLOR_0']]['normalized'] = True
indices = accessor('SCALAR', [(0,), (1,), (2,)], 5123)
times = accessor('SCALAR', [(0,), (0.5,), (1,)], bounds=True)
turns = accessor('VEC4', [(0, 0, 0, 1), (0, H, 0, H), (0, 0, H, H)])
moves = accessor('VEC3', [(0, 0, 0), (0, 0, 0), (10, 20, 30)])
identity = accessor('MAT4', [(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)])
json.dump({
    'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0, 1]}],
    'nodes': [{'name': 'hinge'}, {'name': 'corner', 'mesh': 0, 'skin': 0}],
    'skins': [{'joints': [0], 'inverseBindMatrices': identity}],
    'materials': [{'name': 'clay', 'pbrMetallicRoughness': {'baseColorFactor': [1, 0.21404114, 0, 1]}}],
    'meshes': [{'name': 'corner', 'primitives': [{'attributes': mesh, 'indices': indices, 'material': 0}]}],
    'animations': [{'name': 'turn', 'channels': [
        {'sampler': 0, 'target': {'node': 0, 'path': 'rotation'}},
        {'sampler': 1, 'target': {'node': 0, 'path': 'translation'}}],
        'samplers': [{'input': times, 'output': turns}, {'input': times, 'output': moves}]}],
    'buffers': [{'byteLength': len(DATA),
                 'uri': 'data:application/octet-stream;base64,' + base64.b64encode(DATA).decode()}],
    'bufferViews': VIEWS, 'accessors': ACCESSORS}, open(sys.argv[1], 'w'))
