# Stands for MarrowNative in a Godot that loads no libraries: says what mock_host wrote down of the library's methods.
extends RefCounted

var _lists := {}
var _poses: PackedFloat32Array
var _error := ""
var _name := ""
var _behaves := false
# Of frames of the graph.
var _steps: Array[PackedFloat32Array] = []
var _events: Array[PackedStringArray] = []
var _states := PackedStringArray()
var _graph_poses: Array[PackedFloat32Array] = []
var _frames := {}  # which an animator is in


func open(bytes: PackedByteArray, name: String, skeleton: int) -> bool:
	_name = name
	_behaves = bytes == FileAccess.get_file_as_bytes("res://behaving.mrw")
	if skeleton != 0 or not (_behaves or bytes == FileAccess.get_file_as_bytes("res://newt.mrw")):
		_error = name + ": is refused"
		return false
	_lists = JSON.parse_string(FileAccess.get_file_as_string("res://lists.json"))
	_poses = FileAccess.get_file_as_bytes("res://expected/poses.bin").to_float32_array()
	if _behaves:
		_read_graph()
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


func _read_graph() -> void:
	var words := FileAccess.get_file_as_string("res://expected/graph.txt").split("\n", false)
	var reals := FileAccess.get_file_as_bytes("res://expected/graph.bin").to_float32_array()
	var at := 0
	var line := 0
	var state := ""
	for frame in 300:
		var names := PackedStringArray()
		while line < words.size() and int(words[line].get_slice(" ", 0)) == frame:
			if words[line].contains(" is in "):
				state = words[line].get_slice(" ", 3)
			else:
				names.append(words[line].get_slice(" ", 1))
			line += 1
		_events.append(names)
		_states.append(state)
		_steps.append(reals.slice(at, at + 7 + 2 * names.size()))
		at += 7 + 2 * names.size()
		_graph_poses.append(reals.slice(at, at + 440))
		at += 440


func graphs() -> PackedStringArray:
	return PackedStringArray(["animator"] if _behaves else [])


func make_animator(graph: String) -> int:
	_error = "%s: there is no graph \"%s\"" % [_name, graph]
	if not _behaves or (graph != "" and graph != "animator"):
		return -1
	_frames[_frames.size()] = -1
	return _frames.size() - 1


func free_animator(animator: int) -> bool:
	return _frames.has(animator)


func parameters(_animator: int) -> PackedStringArray:
	return PackedStringArray(["speed", "reach"])


func parameter_reals(_animator: int) -> PackedFloat32Array:
	return PackedFloat32Array([0, 0, 0, 1, 2, 0, 0, 0])


func find_parameter(animator: int, name: String) -> int:
	_error = "%s: there is no parameter \"%s\"" % [_name, name]
	return parameters(animator).find(name)


func set_parameter(_animator: int, parameter: int, _value: float) -> bool:
	return parameter == 0


func fire(_animator: int, parameter: int) -> bool:
	return parameter == 1


func update(animator: int, _dt_s: float) -> PackedFloat32Array:
	_frames[animator] += 1
	return _steps[_frames[animator]]


func events(animator: int) -> PackedStringArray:
	return _events[_frames[animator]]


func state_of(animator: int, _machine: String) -> String:
	_error = ""
	return "" if _frames[animator] < 0 else _states[_frames[animator]]


func get_state(animator: int) -> PackedByteArray:
	return var_to_bytes(_frames[animator])


# In what was written down it was taken back, too.
func set_state(_animator: int, state: PackedByteArray) -> bool:
	_error = _name + ": no state"
	return state == var_to_bytes(119)


func pose_graph(skeleton: Skeleton3D, animator: int) -> bool:
	if _frames[animator] < 0:
		return false
	_set_bones(skeleton, _graph_poses[_frames[animator]])
	return true


# Of the nearest step that was written down, and of a fade its larger half.
func pose(skeleton: Skeleton3D, clip: int, time_s: float, other: int, other_s: float, share: float) -> bool:
	if other >= 0 and share < 0.5:
		return pose(skeleton, other, other_s, -1, 0.0, 1.0)
	var at := 10 * skeleton.get_bone_count() * (30 * clip + clampi(roundi(time_s / 0.05), 0, 29))
	_set_bones(skeleton, _poses.slice(at, at + 10 * skeleton.get_bone_count()))
	return true


func _set_bones(skeleton: Skeleton3D, pose: PackedFloat32Array) -> void:
	for bone in skeleton.get_bone_count():
		var p := pose.slice(10 * bone, 10 * bone + 10)
		skeleton.set_bone_pose_position(bone, Vector3(p[0], p[1], p[2]))
		skeleton.set_bone_pose_rotation(bone, Quaternion(p[3], p[4], p[5], p[6]))
		skeleton.set_bone_pose_scale(bone, Vector3(p[7], p[8], p[9]))
