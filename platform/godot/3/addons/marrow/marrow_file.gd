# A file that `marrow cook` made: all players of it share what it opened, and its meshes.
tool
class_name MarrowFile
extends Resource

export var bytes := PoolByteArray()

var source := ""  # the file's name in messages

var _natives := {}
var _meshes := {}
var _packs := {}


# What poses one skeleton of the file, or null, and the reason as an error.
func native(skeleton := 0) -> Reference:
	if not _natives.has(skeleton):
		var script: Script = load("res://addons/marrow/marrow_native.gdns")
		var opened: Reference = script.new() if script != null and script.can_instance() else null
		if opened == null:
			push_error("%s: addons/marrow/bin has no library for this system: build it, see docs/platforms/godot.md"
					% source)
			return null
		if not opened.open(bytes, source, skeleton):
			push_error(opened.get_error())
			return null
		for path in _packs:
			if not opened.add_clips(_packs[path], path):
				push_error(opened.get_error())
		_natives[skeleton] = opened
	return _natives[skeleton]


# Adds the clips of a pack, cooked with --clips-only --skeleton: for all skeletons that they fit. Does so once.
func add_clips(path: String) -> bool:
	if _packs.has(path):
		return true
	var stream := File.new()
	if stream.open(path, File.READ) != OK:
		push_error("%s: cannot be read: is it there?" % path)
		return false
	_packs[path] = stream.get_buffer(stream.get_len())
	for skeleton in _natives:
		if not _natives[skeleton].add_clips(_packs[path], path):
			push_error(_natives[skeleton].get_error())
			_packs.erase(path)
			return false
	return true


func make_skeleton(skeleton := 0) -> Skeleton:
	var from = native(skeleton)
	if from == null:
		return null
	var out := Skeleton.new()
	var parents: PoolIntArray = from.parents()
	var rests: PoolRealArray = from.rests()
	for bone in from.bones():
		out.add_bone(bone)
	for i in parents.size():
		out.set_bone_parent(i, parents[i])
		var r: int = 10 * i
		var basis: Basis = Basis(Quat(rests[r + 3], rests[r + 4], rests[r + 5], rests[r + 6]))
		basis.x *= rests[r + 7]
		basis.y *= rests[r + 8]
		basis.z *= rests[r + 9]
		out.set_bone_rest(i, Transform(basis, Vector3(rests[r], rests[r + 1], rests[r + 2])))
	out.transform = _transform(from.above(), 0)
	return out


# Adds a MeshInstance for each mesh below a skeleton of make_skeleton(). Godot skins them.
func add_meshes(to: Skeleton, skeleton := 0) -> void:
	var from = native(skeleton)
	if from == null:
		return
	if not _meshes.has(skeleton):
		var all := []
		for i in from.mesh_count():
			all.append([from.mesh_name(i), _make_mesh(from, i), _make_skin(from, i)])
		_meshes[skeleton] = all
	for each in _meshes[skeleton]:
		var instance := MeshInstance.new()
		instance.name = each[0]
		instance.mesh = each[1]
		instance.skin = each[2]
		to.add_child(instance)
		instance.skeleton = NodePath("..")


static func _make_mesh(from: Reference, mesh: int) -> ArrayMesh:
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = _vectors(from.mesh_reals(mesh, "positions", 4))
	var normals: PoolRealArray = from.mesh_reals(mesh, "normals", 4)
	if normals.size() > 0:
		arrays[Mesh.ARRAY_NORMAL] = _vectors(normals)
	var tangents: PoolRealArray = from.mesh_reals(mesh, "tangents", 4)
	if tangents.size() > 0:
		arrays[Mesh.ARRAY_TANGENT] = tangents
	var uvs: PoolRealArray = from.mesh_reals(mesh, "uvs", 4)
	if uvs.size() > 0:
		var pairs := PoolVector2Array()
		for i in range(0, uvs.size(), 2):
			pairs.append(Vector2(uvs[i], uvs[i + 1]))
		arrays[Mesh.ARRAY_TEX_UV] = pairs
	var colours: PoolRealArray = from.mesh_reals(mesh, "colours", 4)
	if colours.size() > 0:
		var all := PoolColorArray()
		for i in range(0, colours.size(), 4):
			all.append(Color(_srgb(colours[i]), _srgb(colours[i + 1]), _srgb(colours[i + 2]), colours[i + 3]))
		arrays[Mesh.ARRAY_COLOR] = all
	arrays[Mesh.ARRAY_BONES] = from.mesh_ints(mesh, "bones", 4)
	arrays[Mesh.ARRAY_WEIGHTS] = from.mesh_reals(mesh, "weights", 4)
	arrays[Mesh.ARRAY_INDEX] = from.mesh_ints(mesh, "indices", 4)
	var out := ArrayMesh.new()
	out.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	var material := SpatialMaterial.new()
	var colour: PoolRealArray = from.mesh_reals(mesh, "colour", 4)
	material.albedo_color = Color(_srgb(colour[0]), _srgb(colour[1]), _srgb(colour[2]), colour[3])
	material.vertex_color_use_as_albedo = colours.size() > 0
	material.vertex_color_is_srgb = true  # the one way that looks alike in both of Godot's renderers
	if from.mesh_ints(mesh, "double_sided", 4)[0] == 1:
		material.params_cull_mode = SpatialMaterial.CULL_DISABLED
	out.surface_set_material(0, material)
	return out


static func _make_skin(from: Reference, mesh: int) -> Skin:
	var out := Skin.new()
	var binds: PoolRealArray = from.mesh_reals(mesh, "binds", 4)
	var bones: PoolIntArray = from.mesh_ints(mesh, "bind_bones", 4)
	for i in bones.size():
		out.add_bind(bones[i], _transform(binds, 12 * i))
	return out


# From three rows of four.
static func _transform(m: PoolRealArray, i: int) -> Transform:
	return Transform(
		Vector3(m[i], m[i + 4], m[i + 8]),
		Vector3(m[i + 1], m[i + 5], m[i + 9]),
		Vector3(m[i + 2], m[i + 6], m[i + 10]),
		Vector3(m[i + 3], m[i + 7], m[i + 11])
	)


static func _vectors(reals: PoolRealArray) -> PoolVector3Array:
	var out := PoolVector3Array()
	for i in range(0, reals.size(), 3):
		out.append(Vector3(reals[i], reals[i + 1], reals[i + 2]))
	return out


static func _srgb(linear: float) -> float:
	return 12.92 * linear if linear < 0.0031308 else 1.055 * pow(linear, 1 / 2.4) - 0.055
