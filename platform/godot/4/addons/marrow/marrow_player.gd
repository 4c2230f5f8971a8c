## Plays clips of a cooked file on a Skeleton3D below it, which it makes, and shows its meshes.
class_name MarrowPlayer
extends Node3D

signal finished(clip: String)

@export var file: Resource  ## a MarrowFile, as load("res://hero.mrw") gives it
@export var skeleton_index := 0  ## which of the file's
@export var clip := ""  ## plays from the start; empty: the rest pose
@export var speed := 1.0
@export var loop := true
@export var playing := true
@export var show_meshes := true

var time := 0.0  ## in the clip, seconds
var skeleton: Skeleton3D

var _native: Object
var _clip := -1
var _other := -1  # what the clip fades from
var _other_time := 0.0
var _fade := 0.0
var _fade_left := 0.0


func _ready() -> void:
	if file != null and skeleton == null:
		open(file)


## Another file, or the first one.
func open(cooked: Resource) -> bool:
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
	if clip == "":
		return true
	var goes_on := playing
	var good := play(clip)
	playing = goes_on
	return good


func clips() -> PackedStringArray:
	return PackedStringArray() if _native == null else _native.clips()


## Seconds.
func duration() -> float:
	return 0.0 if _native == null else _native.duration(_clip)


## From its start; the clip before fades out within fade_s seconds.
func play(clip_name: String, fade_s: float = 0.0) -> bool:
	if _native == null:
		push_error("MarrowPlayer: nothing is open: set `file`, or call open()")
		return false
	var found: int = _native.find_clip(clip_name)
	if found < 0:
		push_error(_native.get_error())
		return false
	_other = _clip if fade_s > 0.0 else -1
	_other_time = time
	_fade = fade_s
	_fade_left = fade_s
	clip = clip_name
	_clip = found
	time = 0.0
	playing = true
	return apply()


func seek(time_s: float) -> bool:
	time = time_s
	return apply()


## Poses the skeleton as the clip has it now.
func apply() -> bool:
	if _native == null or _clip < 0:
		return false
	var share := 1.0 if _other < 0 else 1.0 - _fade_left / _fade
	if _native.pose(skeleton, _clip, time, _other, _other_time, share):
		return true
	push_error(_native.get_error())
	return false


func _process(delta: float) -> void:
	if playing:
		advance(delta)


func advance(delta: float) -> void:
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
