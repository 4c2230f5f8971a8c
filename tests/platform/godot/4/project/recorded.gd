# Stands for MarrowNative in a Godot that loads no libraries: says what mock_host wrote down of the library's methods.
extends RefCounted

var _lists := {}
var _poses: PackedFloat32Array
var _error := ""
var _name := ""


func open(bytes: PackedByteArray, name: String, skeleton: int) -> bool:
	_name = name
	if skeleton != 0 or bytes != FileAccess.get_file_as_bytes("res://newt.mrw"):
		_error = name + ": is refused"
		return false
	_lists = JSON.parse_string(FileAccess.get_file_as_string("res://lists.json"))
	_poses = FileAccess.get_file_as_bytes("res://expected/poses.bin").to_float32_array()
	return true


func add_clips(_bytes: PackedByteArray, name: String) -> bool:
	_error = name + ": is refused"
	return name.ends_with("pack.mrw")


func get_error() -> String:
	return _error


func clips() -> PackedStringArray:
	return PackedStringArray(_lists.clips)


func find_clip(name: String) -> int:
	_error = "%s: there is no clip \"%s\"" % [_name, name]
	return clips().find(name)


func duration(clip: int) -> float:
	return _lists.durations[clip] if clip >= 0 else 0.0


func bones() -> PackedStringArray:
	return PackedStringArray(_lists.bones)


func parents() -> PackedInt32Array:
	return PackedInt32Array(_lists.parents)


func rests() -> PackedFloat32Array:
	return PackedFloat32Array(_lists.rests)


func above() -> PackedFloat32Array:
	return PackedFloat32Array(_lists.above)


func mesh_count() -> int:
	return 6


func mesh_name(mesh: int) -> String:
	return _lists["mesh_name %d" % mesh]


func mesh_reals(mesh: int, what: String, _influences: int) -> PackedFloat32Array:
	return PackedFloat32Array(_lists["%s %d" % [what, mesh]])


func mesh_ints(mesh: int, what: String, _influences: int) -> PackedInt32Array:
	return PackedInt32Array(_lists["%s %d" % [what, mesh]])


# Of the nearest step that was written down, and of a fade its larger half.
func pose(skeleton: Skeleton3D, clip: int, time_s: float, other: int, other_s: float, share: float) -> bool:
	if other >= 0 and share < 0.5:
		return pose(skeleton, other, other_s, -1, 0.0, 1.0)
	var at := 10 * skeleton.get_bone_count() * (30 * clip + clampi(roundi(time_s / 0.05), 0, 29))
	for bone in skeleton.get_bone_count():
		var p := _poses.slice(at + 10 * bone, at + 10 * bone + 10)
		skeleton.set_bone_pose_position(bone, Vector3(p[0], p[1], p[2]))
		skeleton.set_bone_pose_rotation(bone, Quaternion(p[3], p[4], p[5], p[6]))
		skeleton.set_bone_pose_scale(bone, Vector3(p[7], p[8], p[9]))
	return true
