## A file that `marrow cook` made: all players of it share what it opened, and its meshes.
@tool
class_name MarrowFile
extends Resource

@export var bytes: PackedByteArray

var source := ""  ## the file's name in messages

var _natives := {}
var _meshes := {}
var _packs := {}


## What poses one skeleton of the file, or null, and the reason as an error.
func native(skeleton: int = 0) -> Object:
	if not _natives.has(skeleton):
		if not ClassDB.class_exists(&"MarrowNative"):
			push_error("%s: addons/marrow/bin has no library for this system: build it, see docs/platforms/godot.md"
					% source)
			return null
		var opened: Object = ClassDB.instantiate(&"MarrowNative")
		if not opened.open(bytes, source, skeleton):
			push_error(opened.get_error())
			return null
		for path: String in _packs:
			if not opened.add_clips(_packs[path], path):
				push_error(opened.get_error())
		_natives[skeleton] = opened
	return _natives[skeleton]


## Adds the clips of a pack, cooked with --clips-only --skeleton: for all skeletons that they fit. Does so once.
func add_clips(path: String) -> bool:
	if _packs.has(path):
		return true
	if not FileAccess.file_exists(path):
		push_error("%s: cannot be read: is it there?" % path)
		return false
	_packs[path] = FileAccess.get_file_as_bytes(path)
	for skeleton: int in _natives:
		if not _natives[skeleton].add_clips(_packs[path], path):
			push_error(_natives[skeleton].get_error())
			_packs.erase(path)
			return false
	return true


func make_skeleton(skeleton: int = 0) -> Skeleton3D:
	var from := native(skeleton)
	if from == null:
		return null
	var out := Skeleton3D.new()
	var parents: PackedInt32Array = from.parents()
	var rests: PackedFloat32Array = from.rests()
	for bone: String in from.bones():
		out.add_bone(bone)
	for i in parents.size():
		out.set_bone_parent(i, parents[i])
		var r := 10 * i
		var basis := Basis(Quaternion(rests[r + 3], rests[r + 4], rests[r + 5], rests[r + 6]))
		basis.x *= rests[r + 7]
		basis.y *= rests[r + 8]
		basis.z *= rests[r + 9]
		out.set_bone_rest(i, Transform3D(basis, Vector3(rests[r], rests[r + 1], rests[r + 2])))
	out.reset_bone_poses()
	out.transform = _transform(from.above(), 0)
	return out


## Adds a MeshInstance3D for each mesh below a skeleton of make_skeleton(). Godot skins them.
func add_meshes(to: Skeleton3D, skeleton: int = 0) -> void:
	var from := native(skeleton)
	if from == null:
		return
	if not _meshes.has(skeleton):
		var all := []
		for i: int in from.mesh_count():
			all.append([from.mesh_name(i), _make_mesh(from, i), _make_skin(from, i)])
		_meshes[skeleton] = all
	for each: Array in _meshes[skeleton]:
		var instance := MeshInstance3D.new()
		instance.name = each[0]
		instance.mesh = each[1]
		instance.skin = each[2]
		to.add_child(instance)
		instance.skeleton = NodePath("..")


static func _make_mesh(from: Object, mesh: int) -> ArrayMesh:
	var wide: bool = from.mesh_ints(mesh, "influences", 8)[0] > 4
	var influences := 8 if wide else 4
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = _vectors(from.mesh_reals(mesh, "positions", influences))
	var normals: PackedFloat32Array = from.mesh_reals(mesh, "normals", influences)
	if not normals.is_empty():
		arrays[Mesh.ARRAY_NORMAL] = _vectors(normals)
	var tangents: PackedFloat32Array = from.mesh_reals(mesh, "tangents", influences)
	if not tangents.is_empty():
		arrays[Mesh.ARRAY_TANGENT] = tangents
	var uvs: PackedFloat32Array = from.mesh_reals(mesh, "uvs", influences)
	if not uvs.is_empty():
		var pairs := PackedVector2Array()
		for i in range(0, uvs.size(), 2):
			pairs.append(Vector2(uvs[i], uvs[i + 1]))
		arrays[Mesh.ARRAY_TEX_UV] = pairs
	var colours: PackedFloat32Array = from.mesh_reals(mesh, "colours", influences)
	if not colours.is_empty():
		var all := PackedColorArray()
		for i in range(0, colours.size(), 4):
			all.append(Color(colours[i], colours[i + 1], colours[i + 2], colours[i + 3]).linear_to_srgb())
		arrays[Mesh.ARRAY_COLOR] = all
	arrays[Mesh.ARRAY_BONES] = from.mesh_ints(mesh, "bones", influences)
	arrays[Mesh.ARRAY_WEIGHTS] = from.mesh_reals(mesh, "weights", influences)
	arrays[Mesh.ARRAY_INDEX] = from.mesh_ints(mesh, "indices", influences)
	var out := ArrayMesh.new()
	out.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays, [], {},
			Mesh.ARRAY_FLAG_USE_8_BONE_WEIGHTS if wide else 0)
	var material := StandardMaterial3D.new()
	var colour: PackedFloat32Array = from.mesh_reals(mesh, "colour", influences)
	material.albedo_color = Color(colour[0], colour[1], colour[2], colour[3]).linear_to_srgb()
	material.vertex_color_use_as_albedo = not colours.is_empty()
	material.vertex_color_is_srgb = true  # the one way that looks alike in all of Godot's renderers
	if from.mesh_ints(mesh, "double_sided", influences)[0] == 1:
		material.cull_mode = BaseMaterial3D.CULL_DISABLED
	out.surface_set_material(0, material)
	return out


static func _make_skin(from: Object, mesh: int) -> Skin:
	var out := Skin.new()
	var binds: PackedFloat32Array = from.mesh_reals(mesh, "binds", 4)
	var bones: PackedInt32Array = from.mesh_ints(mesh, "bind_bones", 4)
	for i in bones.size():
		out.add_bind(bones[i], _transform(binds, 12 * i))
	return out


# From three rows of four.
static func _transform(m: PackedFloat32Array, i: int) -> Transform3D:
	return Transform3D(
			Vector3(m[i], m[i + 4], m[i + 8]),
			Vector3(m[i + 1], m[i + 5], m[i + 9]),
			Vector3(m[i + 2], m[i + 6], m[i + 10]),
			Vector3(m[i + 3], m[i + 7], m[i + 11]))


static func _vectors(reals: PackedFloat32Array) -> PackedVector3Array:
	var out := PackedVector3Array()
	for i in range(0, reals.size(), 3):
		out.append(Vector3(reals[i], reals[i + 1], reals[i + 2]))
	return out
