## Plays a graph of behaviour of a cooked file, or its clips, on a Skeleton3D below it, which it makes, and shows its
## meshes.
class_name MarrowPlayer
extends Node3D

signal finished(clip: String)
signal motion_event(name: String, number: float, time: float)  ## of a graph's clips; seconds in the clip

@export var file: Resource  ## a MarrowFile, as load("res://hero.mrw") gives it
@export var skeleton_index := 0  ## which of the file's
@export var graph := ""  ## plays from the start; empty: the file's first, if `clip` is empty, too
@export var clip := ""  ## without a graph plays from the start; empty: the rest pose
@export var speed := 1.0
@export var loop := true
@export var playing := true
@export var show_meshes := true
@export var apply_root_motion := false  ## moves this node as the clips of its graph do

var time := 0.0  ## in the clip, seconds
var skeleton: Skeleton3D

var _native: Object
var _clip := -1
var _other := -1  # what the clip fades from
var _other_time := 0.0
var _fade := 0.0
var _fade_left := 0.0
var _animator := -1  # what plays a graph
var _parameters := {}  # by their names
var _values := {}  # what they were set to, likewise
var _root_position := Vector3()
var _root_rotation := Quaternion()


func _ready() -> void:
	if file != null and skeleton == null:
		open(file)


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE:
		_leave_graph()


## Another file, or the first one.
func open(cooked: Resource) -> bool:
	_leave_graph()
	file = cooked
	if skeleton != null:
		skeleton.queue_free()
		skeleton = null
	_native = null if cooked == null else cooked.native(skeleton_index)
	_clip = -1
	_other = -1
	if _native == null:
		return false
	skeleton = cooked.make_skeleton(skeleton_index)
	add_child(skeleton)
	if show_meshes:
		cooked.add_meshes(skeleton, skeleton_index)
	var goes_on := playing
	var good := true
	if graph != "" or (clip == "" and not graphs().is_empty()):
		good = play_graph(graph)
	elif clip != "":
		good = play(clip)
	playing = goes_on
	return good


func clips() -> PackedStringArray:
	return PackedStringArray() if _native == null else _native.clips()


func graphs() -> PackedStringArray:
	return PackedStringArray() if _native == null else _native.graphs()


## Seconds.
func duration() -> float:
	return 0.0 if _native == null else _native.duration(_clip)


## From its start; the clip before fades out within fade_s seconds. A graph ends at once.
func play(clip_name: String, fade_s: float = 0.0) -> bool:
	if _native == null:
		push_error("MarrowPlayer: nothing is open: set `file`, or call open()")
		return false
	var found: int = _native.find_clip(clip_name)
	if found < 0:
		push_error(_native.get_error())
		return false
	_leave_graph()
	_other = _clip if fade_s > 0.0 else -1
	_other_time = time
	_fade = fade_s
	_fade_left = fade_s
	clip = clip_name
	_clip = found
	time = 0.0
	playing = true
	return apply()


## From its start: a graph of the file or of its packs, or of none the first.
func play_graph(graph_name: String = "") -> bool:
	if _native == null:
		push_error("MarrowPlayer: nothing is open: set `file`, or call open()")
		return false
	var made: int = _native.make_animator(graph_name)
	if made < 0:
		push_error(_native.get_error())
		return false
	_leave_graph()
	_animator = made
	_clip = -1
	_other = -1
	playing = true
	_read_parameters()
	notify_property_list_changed()
	return true


## Of the graph: a number, which is clamped to its range, or a flag.
func set_parameter(parameter: StringName, value: Variant) -> bool:
	var found := _parameter(parameter)
	if found < 0 or not _must(_native.set_parameter(_animator, found, float(value))):
		return false
	_values[String(parameter)] = float(value)
	return true


## A trigger of the graph, until a transition takes it or its time is over.
func fire(trigger: StringName) -> bool:
	var found := _parameter(trigger)
	return found >= 0 and _must(_native.fire(_animator, found))


func _read_parameters() -> void:
	var reals: PackedFloat32Array = _native.parameter_reals(_animator)
	var names: Array = Array(parameters())
	for i in names.size():
		_values[names[i]] = reals[4 * i + 1]


# Parameters are properties, too, as an AnimationTree's are: parameters/speed, for the remote inspector and for tweens.
# A trigger is fired when it is set, and reads false.
func _get_property_list() -> Array[Dictionary]:
	var out: Array[Dictionary] = []
	if _animator < 0:
		return out
	var reals: PackedFloat32Array = _native.parameter_reals(_animator)
	for parameter: String in _values:
		var at := 4 * out.size()
		var is_number := reals[at] == 0
		out.append({
			"name": "parameters/" + parameter,
			"type": TYPE_FLOAT if is_number else TYPE_BOOL,
			"hint": PROPERTY_HINT_RANGE if is_number else PROPERTY_HINT_NONE,
			"hint_string": "%s,%s,0.001" % [reals[at + 2], reals[at + 3]] if is_number else "",
			"usage": PROPERTY_USAGE_EDITOR,
		})
	return out


func _get(property: StringName) -> Variant:
	var parameter := String(property).trim_prefix("parameters/")
	if _animator < 0 or parameter == property or not _values.has(parameter):
		return null
	return _values[parameter] if _kind(parameter) == 0 else _values[parameter] != 0.0


func _set(property: StringName, value: Variant) -> bool:
	var parameter := String(property).trim_prefix("parameters/")
	if _animator < 0 or parameter == property or not _values.has(parameter):
		return false
	if _kind(parameter) != 2:
		return set_parameter(parameter, value)
	return value != true or fire(parameter)


func _kind(parameter: String) -> int:
	return int(_native.parameter_reals(_animator)[4 * _parameter(parameter)])


## The names of the graph's parameters.
func parameters() -> PackedStringArray:
	return PackedStringArray() if _animator < 0 else _native.parameters(_animator)


## The name of the state that a machine of the graph is in; empty if nothing of it is shown.
func state_of(machine: String) -> String:
	if _animator < 0:
		push_error("MarrowPlayer: no graph is played: cook the file with --graph, or call play_graph()")
		return ""
	var state: String = _native.state_of(_animator, machine)
	_must(state != "" or _native.get_error() == "")
	return state


## Seconds since then.
func state_time(machine: String) -> float:
	return 0.0 if state_of(machine) == "" else _native.state_time(_animator, machine)


## What the graph is in, to save and to take back: some hundred bytes. Where this node stands is not among them.
func get_state() -> PackedByteArray:
	return PackedByteArray() if _animator < 0 else _native.get_state(_animator)


## Takes back what get_state() gave, of this player or another of the graph. False, and nothing changes, of other bytes.
func set_state(state: PackedByteArray) -> bool:
	if _animator < 0:
		push_error("MarrowPlayer: no graph is played, whose state could be set")
		return false
	if not _must(_native.set_state(_animator, state)):
		return false
	_read_parameters()
	_native.pose_graph(skeleton, _animator)  # unless it is from before the first step, when there is nothing to show
	return true


## How far the graph's clips moved the character in the last step, in its own axes.
func get_root_motion_position() -> Vector3:
	return _root_position


## Likewise how they turned it.
func get_root_motion_rotation() -> Quaternion:
	return _root_rotation


func seek(time_s: float) -> bool:
	time = time_s
	return apply()


## Poses the skeleton as the graph, or the clip, has it now.
func apply() -> bool:
	if _animator >= 0:
		return _must(_native.pose_graph(skeleton, _animator))
	if _native == null or _clip < 0:
		return false
	var share := 1.0 if _other < 0 else 1.0 - _fade_left / _fade
	return _must(_native.pose(skeleton, _clip, time, _other, _other_time, share))


func _process(delta: float) -> void:
	if playing:
		advance(delta)


func advance(delta: float) -> void:
	if _animator >= 0:
		_behave(delta)
		return
	if _native == null or _clip < 0:
		return
	var length := duration()
	var at_end := false
	time += delta * speed
	if loop and length > 0.0:
		time = fposmod(time, length)
	else:
		at_end = time >= length or time < 0.0
		time = clampf(time, 0.0, length)
	_fade_left = maxf(_fade_left - delta, 0.0)
	if _fade_left == 0.0:
		_other = -1
	var ended := clip
	if not apply():
		playing = false
	elif at_end:
		playing = false
		finished.emit(ended)


func _behave(delta: float) -> void:
	var step: PackedFloat32Array = _native.update(_animator, maxf(delta * speed, 0.0))
	if not _must(not step.is_empty()):
		playing = false
		return
	_root_rotation = Quaternion(step[0], step[1], step[2], step[3])
	_root_position = Vector3(step[4], step[5], step[6])
	if apply_root_motion:
		position += basis * _root_position
		quaternion = (quaternion * _root_rotation).normalized()
	if not apply():
		playing = false
	if step.size() == 7:
		return
	var names: PackedStringArray = _native.events(_animator)
	for i in names.size():  # after the pose, as who hears one may end the graph
		motion_event.emit(names[i], step[7 + 2 * i], step[8 + 2 * i])


func _leave_graph() -> void:
	if _animator >= 0:
		_native.free_animator(_animator)
	_animator = -1
	_parameters.clear()
	_values.clear()
	_root_position = Vector3()
	_root_rotation = Quaternion()


func _parameter(parameter: StringName) -> int:
	if _parameters.has(parameter):
		return _parameters[parameter]
	if _animator < 0:
		push_error("MarrowPlayer: no graph is played that has \"%s\": cook the file with --graph, or call play_graph()"
				% parameter)
		return -1
	var found: int = _native.find_parameter(_animator, parameter)
	if _must(found >= 0):
		_parameters[parameter] = found
	return found


func _must(good: bool) -> bool:
	if not good:
		push_error(_native.get_error())
	return good
