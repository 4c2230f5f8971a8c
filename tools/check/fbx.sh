#!/usr/bin/env bash
# The sample's body becomes FBX by Blender, GLB by tools/fbx_to_glb.sh, is cooked, and is compared with the sample: the
# rest pose and every clip, vertex by vertex. Exit 1 if something is lost, 3 without Blender.
# usage: tools/check/fbx.sh MARROW      (the program)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
marrow=$1
tools/install.sh tools/packages/fbx.txt || echo "check/fbx: some packages cannot be installed" >&2
blender=${BLENDER:-blender}
command -v "$blender" >/dev/null || { echo "check/fbx: Blender is not installed" >&2; exit 3; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
run_blender() {  # SCRIPT ARGUMENT ...
  local script=$1
  shift
  "$blender" --background --factory-startup -noaudio --python-exit-code 1 --python "$script" -- "$@" \
    >"$work/log" 2>&1 || { tail -5 "$work/log" >&2; exit 1; }
}
complain() { echo "check/fbx: $*" >&2; exit 1; }

cat >"$work/write_fbx.py" <<'PYTHON'
import sys

import numpy

for name, kind in (("bool", bool), ("object", object)):  # as in fbx_to_glb.sh
    if name not in numpy.__dict__:
        setattr(numpy, name, kind)

import bpy

source, target = sys.argv[-2:]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.context.scene.render.fps = 30
bpy.ops.import_scene.gltf(filepath=source)
# The body and its armature: the exporter bakes every action on everything that moves.
for thing in list(bpy.data.objects):
    if thing.name not in ("Armature", "body"):
        bpy.data.objects.remove(thing)
for action in list(bpy.data.actions):
    clip, _, owner = action.name.partition("_")
    if owner == "Armature":
        action.name = clip
    else:
        bpy.data.actions.remove(action)
armature, body = bpy.data.objects["Armature"], bpy.data.objects["body"]
for track in armature.animation_data.nla_tracks:
    track.mute = True
armature.animation_data.action = None
for bone in armature.pose.bones:
    bone.matrix_basis.identity()
body.shape_key_add(name="Basis")
taller = body.shape_key_add(name="taller")
for point in taller.data:
    point.co.z += 0.5
bpy.ops.export_scene.fbx(
    filepath=target,
    add_leaf_bones=False,
    bake_anim_use_all_actions=True,
    bake_anim_use_nla_strips=False,
    bake_anim_simplify_factor=0.0,
)
PYTHON

# Farthest vertex of the first cloud from the second, in metres.
cat >"$work/compare.py" <<'PYTHON'
import array
import sys

from mathutils.kdtree import KDTree

def vertices(path):
    numbers = array.array("f", open(path, "rb").read())
    return list(zip(*[iter(numbers)] * 3))

of, among = map(vertices, sys.argv[-2:])
tree = KDTree(len(among))
for i, vertex in enumerate(among):
    tree.insert(vertex, i)
tree.balance()
worst = max(tree.find(vertex)[2] for vertex in of)
print(f"vertices {len(of)}, farthest {worst:.6f} m")
sys.exit(not (len(of) > 6000 and worst < 5e-4))
PYTHON

run_blender "$work/write_fbx.py" tools/sample/newt.glb "$work/body.FBX"
tools/fbx_to_glb.sh "$work/body.FBX" "$work/body.glb"
tools/validate_gltf.sh "$work/body.glb" || [ $? -eq 3 ] || complain "the GLB is not valid"
"$marrow" cook "$work/body.glb" -o "$work/body.mrw" >/dev/null
"$marrow" cook tools/sample/newt.glb -o "$work/newt.mrw" >/dev/null 2>&1
info=$("$marrow" info "$work/body.mrw")
for clip in "" idle reach twist walk; do
  play=()
  if [ -n "$clip" ]; then
    grep -q "clip . \"$clip\"" <<<"$info" || complain "no clip $clip"
    play=(--clip "$clip" --time 0.7)
  fi
  for file in body newt; do "$marrow" pose "$work/$file.mrw" "${play[@]}" -o "$work/$file.bin"; done
  run_blender "$work/compare.py" "$work/body.bin" "$work/newt.bin"
  echo "check/fbx: ${clip:-rest}: $(grep ^vertices "$work/log")" >&2
done
grep -q ', 1 morph targets' <<<"$info" || complain "no morph target"

# What is none is refused, and leaves nothing.
printf 'Kaydara FBX Binary  \0\x1a\0' >"$work/broken.fbx"
for wrong in "$work/broken.fbx" "$work/none.fbx"; do
  if tools/fbx_to_glb.sh "$wrong" "$work/out.glb" 2>"$work/said"; then complain "$wrong is taken"; fi
  [ -s "$work/said" ] || complain "$wrong is refused in silence"
done
for left in "$work"/out.glb*; do [ ! -e "$left" ] || complain "$left is left"; done
echo "check/fbx: the same rest pose and clips" >&2
