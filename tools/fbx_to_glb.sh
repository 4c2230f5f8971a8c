#!/usr/bin/env bash
# Turns an FBX file into a GLB that `marrow cook` reads, by Blender: meshes, skins, shape keys, materials, every take.
# Nothing is left of a failure. Exit 1 if the file cannot be read, 2 on wrong usage, 3 without Blender.
# usage: tools/fbx_to_glb.sh IN.fbx OUT.glb       ($BLENDER: the program, else `blender` of the path)
set -euo pipefail
usage() { sed -n '4s/^# //p' "$0" >&2; exit 2; }
{ [ $# -eq 2 ] && [[ ${1,,} == *.fbx && ${2,,} == *.glb ]]; } || usage
in=$1 out=$2
[ -r "$in" ] || { echo "fbx_to_glb: $in: cannot be read" >&2; exit 1; }
[ -d "$(dirname "$out")" ] || { echo "fbx_to_glb: $out: there is no folder $(dirname "$out")" >&2; exit 1; }
blender=${BLENDER:-blender}
command -v "$blender" >/dev/null || { echo "fbx_to_glb: Blender is not installed" >&2; exit 3; }
work=$(mktemp -d "$out.XXXXXX")
trap 'rm -rf "$work"' EXIT
cat >"$work/convert.py" <<'PYTHON'
import sys

import numpy

# Blender 3.4's glTF add-on uses names that newer numpy has not.
for name, kind in (("bool", bool), ("object", object)):
    if name not in numpy.__dict__:
        setattr(numpy, name, kind)

import bpy

source, target = sys.argv[sys.argv.index("--") + 1 :]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.fbx(filepath=source, anim_offset=0.0)
if not bpy.data.objects:
    sys.exit("nothing is in it")

# The importer plays the first take alone. A track a take on whatever it moves: tracks of one name become one clip.
# Actions are named OWNER|TAKE|LAYER, or OWNER|TAKE if the layer has the take's name; Blender's takes are OBJECT|ACTION.
owners = {owner.name: owner for owner in [*bpy.data.shape_keys, *bpy.data.objects]}
for action in bpy.data.actions:
    name, *parts = action.name.split("|")
    if name not in owners or not owners[name].animation_data:
        continue
    take = parts[1] if len(parts) > 1 and parts[0] in bpy.data.objects else parts[0]
    tracks = owners[name].animation_data.nla_tracks
    if take in tracks:
        print(f"warning: {action.name}: only the first layer of a take is kept")
        continue
    track = tracks.new()
    track.name = take
    track.strips.new(take, int(action.frame_range[0]), action).extrapolation = "NOTHING"
for owner in owners.values():
    if owner.animation_data:
        owner.animation_data.action = None
    if getattr(owner, "pose", None):
        for bone in owner.pose.bones:
            bone.matrix_basis.identity()
bpy.context.scene.frame_set(-1)  # before every take: what is at rest stays so

# Blender 3.4's glTF add-on takes colours of corners for those of vertices.
for mesh in bpy.data.meshes if bpy.app.version < (3, 5) else []:
    for name in [a.name for a in mesh.color_attributes if a.domain == "CORNER"]:
        of_corners = numpy.empty(4 * len(mesh.loops), numpy.float32)
        vertices = numpy.empty(len(mesh.loops), numpy.int32)
        mesh.color_attributes[name].data.foreach_get("color", of_corners)
        mesh.loops.foreach_get("vertex_index", vertices)
        of_vertices = numpy.ones((len(mesh.vertices), 4), numpy.float32)
        of_vertices[vertices] = of_corners.reshape(-1, 4)
        if not numpy.array_equal(of_vertices[vertices], of_corners.reshape(-1, 4)):
            print(f"warning: {mesh.name}: colours that change at a vertex keep one there")
        mesh.color_attributes.remove(mesh.color_attributes[name])
        mesh.color_attributes.new(name, "FLOAT_COLOR", "POINT").data.foreach_set("color", of_vertices.ravel())
    mesh.color_attributes.render_color_index = 0 if mesh.color_attributes else -1

bpy.ops.export_scene.gltf(
    filepath=target,
    export_format="GLB",
    export_all_influences=True,
    export_force_sampling=True,
    export_optimize_animation_size=False,
    export_frame_range=False,
)
PYTHON
if ! "$blender" --background --factory-startup -noaudio --python-exit-code 1 --python "$work/convert.py" \
  -- "$in" "$work/out.glb" >"$work/log" 2>&1 || [ ! -s "$work/out.glb" ]; then
  echo "fbx_to_glb: $in: Blender cannot turn it into glTF" >&2
  reason=$(sed -n 's/^RuntimeError: Error: //p' "$work/log")
  echo "${reason:-$(grep -v '^$' "$work/log" | tail -3)}" >&2
  exit 1
fi
sed -n 's/^warning: /fbx_to_glb: warning: /p' "$work/log" >&2
mv "$work/out.glb" "$out"
