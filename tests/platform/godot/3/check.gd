# Plays the newt's clips in the engine. Writes what the file's poses are, and compares where Godot puts bones and
# skinned vertices with what reference.c says. Prints what must hold; exit code 1 if anything does not.
extends SceneTree

const STEPS := 30

var failures := 0
var heard := []  # of motion_event: name, number, time


func must(good: bool, what: String) -> void:
	if not good:
		failures += 1
		print("FAILED: " + what)


func _initialize() -> void:
	if OS.get_environment("MARROW_LIBRARY") == "none":
		must(load("res://newt.mrw") == null, "without the library nothing opens")
		quit(failures)
		return
	var cooked = load("res://newt.mrw")
	must(cooked is MarrowFile, "newt.mrw loads as a MarrowFile")
	if cooked is MarrowFile:
		compare(cooked, "expected")
		compare(load("res://turned.mrw"), "turned")
		play_on(cooked)
		add_clips(cooked)
		refuse(cooked)
	behave()
	bad_files()
	var walking: Node = load("res://docs_graph.gd").new()
	get_root().add_child(walking)
	for i in 120:
		walking._process(1.0 / 60)
		walking.hero.advance(1.0 / 60)
	must(abs(walking.hero.translation.z - 0.6) < 1e-3 and walking.steps > 1, "the page's other example walks")
	var example: Node = load("res://docs.gd").new()  # as docs/platforms/godot.md has it
	get_root().add_child(example)
	must(example.get_child_count() == 1 and example.get_child(0).skeleton != null, "the page's example plays")
	print("%d failures" % failures)
	quit(1 if failures > 0 else 0)


func compare(cooked: MarrowFile, expected: String) -> void:
	var native = cooked.native()
	var skeleton: Skeleton = cooked.make_skeleton()
	get_root().add_child(skeleton)
	cooked.add_meshes(skeleton)
	var poses := File.new()
	must(poses.open("res://%s/godot.bin" % expected, File.WRITE) == OK, "godot.bin can be written")
	var scene := File.new()
	must(scene.open("res://%s/scene.bin" % expected, File.READ) == OK, "scene.bin can be read")
	var skinned := File.new()
	must(skinned.open("res://%s/skinned.bin" % expected, File.READ) == OK, "skinned.bin can be read")
	var farthest := 0.0
	var farthest_vertex := 0.0
	for clip in native.clips().size():
		for step in STEPS:
			for real in native.sample(clip, step * 0.05, -1, 0.0, 1.0):
				poses.store_float(real)
			must(native.pose(skeleton, clip, step * 0.05, -1, 0.0, 1.0), "pose: " + native.get_error())
			for bone in skeleton.get_bone_count():
				farthest = max(farthest, distance(skeleton.transform * skeleton.get_bone_global_pose(bone), scene))
			if step == 8:
				farthest_vertex = max(farthest_vertex, skin(skeleton, skinned))
	must(scene.get_position() == scene.get_len(), "all bones were compared")
	must(skinned.get_position() == skinned.get_len(), "all vertices were compared")
	must(farthest < 2e-6, "bones are off by %s" % farthest)
	must(farthest_vertex < 1e-4, "vertices are off by %s m" % farthest_vertex)  # Godot keeps weights in 16 bits
	print("%s: %d clips, %d bones within %.7f of Marrow's, vertices within %.6f m" % [expected,
		native.clips().size(), skeleton.get_bone_count(), farthest, farthest_vertex])
	if expected == "turned":
		must(skeleton.find_bone("rig_pelvis") == 0 and skeleton.find_bone("rig_head") > 0 and
				skeleton.get_bone_count() == 44, "bones have names that Godot takes")
	else:
		time_it(native, skeleton)
	skeleton.free()


# The largest difference of an element from the next matrix of the file, three rows of four.
func distance(got: Transform, expected: File) -> float:
	var out := 0.0
	for row in 3:
		for column in 4:
			var has: float = got.origin[row] if column == 3 else got.basis[column][row]
			out = max(out, abs(has - expected.get_float()))
	return out


# What Godot's own skinning makes of the meshes: the same sum over the lists that its shader gets.
func skin(skeleton: Skeleton, expected: File) -> float:
	var out := 0.0
	for instance in skeleton.get_children():
		var arrays: Array = instance.mesh.surface_get_arrays(0)
		var bones = arrays[Mesh.ARRAY_BONES]
		var weights: PoolRealArray = arrays[Mesh.ARRAY_WEIGHTS]
		var palette := []
		for i in instance.skin.get_bind_count():
			var global: Transform = skeleton.get_bone_global_pose(instance.skin.get_bind_bone(i))
			palette.append(skeleton.transform * global * instance.skin.get_bind_pose(i))
		var positions: PoolVector3Array = arrays[Mesh.ARRAY_VERTEX]
		for v in positions.size():
			var sum := Vector3()
			for i in 4:
				sum += weights[4 * v + i] * palette[int(bones[4 * v + i])].xform(positions[v])
			var at := Vector3(expected.get_float(), expected.get_float(), expected.get_float())
			out = max(out, sum.distance_to(at))
	return out


func time_it(native, skeleton: Skeleton) -> void:
	var calls := 2000
	var began := OS.get_ticks_usec()
	for i in calls:
		native.pose(skeleton, 1, 0.0006 * i, -1, 0.0, 1.0)
	var each := float(OS.get_ticks_usec() - began) / calls
	print("pose(): %.1f us a call, %d bones set" % [each, skeleton.get_bone_count()])


func play_on(cooked: MarrowFile) -> void:
	var player := MarrowPlayer.new()
	player.file = cooked
	player.clip = "walk"
	get_root().add_child(player)
	must(Array(player.clips()) == ["idle", "walk", "twist", "reach"], "clips: " + str(player.clips()))
	must(player.skeleton.get_child_count() == 6, "six meshes are shown")
	for i in 100:
		player.advance(1.0 / 60)
	must(is_equal_approx(player.time, fposmod(100.0 / 60, player.duration())), "walk goes round: %s" % player.time)
	var walking: Transform = player.skeleton.get_bone_pose(10)
	must(player.play("idle", 0.5), "idle plays")
	must(player.skeleton.get_bone_pose(10).is_equal_approx(walking), "a fade begins where walk was")
	for i in 40:
		player.advance(1.0 / 60)
	var faded: Transform = player.skeleton.get_bone_pose(10)
	player.apply()
	must(player.skeleton.get_bone_pose(10) == faded and not faded.is_equal_approx(walking), "and ends at idle")
	player.loop = false
	must(player.play("reach"), "reach plays")
	player.speed = 2.0
	player.advance(60.0)
	must(not player.playing and player.time == player.duration(), "without loop it stops at the end")
	must(player.play("reach") and player.playing, "and plays again")
	must(not player.play("wolk"), "a clip that is not there is refused")
	must(player.clip == "reach", "and the clip before stays")
	player.free()


# A graph, as reference.c plays it: 0.3 m/s for 2 s, then it reaches, then it is taken back and goes on.
func behave() -> void:
	var player := MarrowPlayer.new()
	player.file = load("res://behaving.mrw")
	player.apply_root_motion = true
	player.playing = false
	must(player.connect("motion_event", self, "hear") == OK, "motion_event is a signal")
	get_root().add_child(player)
	must(not player.playing and Array(player.graphs()) == ["animator"], "the first graph plays")
	must(Array(player.parameters()) == ["speed", "reach"], "parameters: %s" % player.parameters())
	var numbers := File.new()
	var words := File.new()
	must(numbers.open("res://expected/godot_graph.bin", File.WRITE) == OK, "godot_graph.bin can be written")
	must(words.open("res://expected/godot_graph.txt", File.WRITE) == OK, "godot_graph.txt can be written")
	must(player.set_parameter("speed", 0.3), "speed is set")
	var state := ""
	var saved := PoolByteArray()
	for frame in 300:
		if frame == 120:
			must(abs(player.translation.z - 0.6) < 1e-3, "2 s at 0.3 m/s are %s m" % player.translation.z)
			saved = player.get_state()
			must(player.set_parameter("speed", 0) and player.fire("reach"), "it is asked to reach")
		if frame == 240:
			must(player.set_state(saved) and player.state_of("body") == "moves", "it is taken back")
		heard.clear()
		player.advance(1.0 / 60)
		var turn: Quat = player.get_root_motion_rotation()
		var way: Vector3 = player.get_root_motion_position()
		for real in [turn.x, turn.y, turn.z, turn.w, way.x, way.y, way.z]:
			numbers.store_float(real)
		for event in heard:
			numbers.store_float(event[1])
			numbers.store_float(event[2])
			words.store_line("%d %s" % [frame, event[0]])
		for real in player._native.sample_graph(player._animator):
			numbers.store_float(real)
		if player.state_of("body") != state:
			state = player.state_of("body")
			words.store_line("%d is in %s" % [frame, state])
	must(abs(player.state_time("body") - 3) < 1e-3, "it moves for 3 s: %s" % player.state_time("body"))
	numbers.close()
	words.close()
	print("a graph: the way of 2 s and of 1 s at 0.3 m/s is %.4f m" % player.translation.z)
	behave_otherwise(player, saved)
	var began := OS.get_ticks_usec()
	for i in 2000:
		player.advance(1.0 / 60)
	print("advance() by a graph: %.1f us a call" % (float(OS.get_ticks_usec() - began) / 2000))
	player.free()


# Parameters as properties: an AnimationTree has them so.
func set_as_properties(player: MarrowPlayer) -> void:
	var listed := {}
	for property in player.get_property_list():
		if property.name.begins_with("parameters/"):
			listed[property.name] = property
	must(listed.keys() == ["parameters/speed", "parameters/reach"], "properties: %s" % [listed.keys()])
	must(listed["parameters/speed"].hint_string == "0,1,0.001", "a range: %s" % listed["parameters/speed"].hint_string)
	must(listed["parameters/reach"].type == TYPE_BOOL, "a trigger is a truth")
	must(player.get("parameters/speed") == 0.0 and player.get("parameters/sped") == null, "speed reads as it was set")
	player.set("parameters/speed", 0.05)
	must(is_equal_approx(player.get("parameters/speed"), 0.05), "and is set")
	player.set("parameters/reach", false)
	player.advance(0.1)
	must(player.state_of("body") == "moves", "nothing is fired")
	player.set("parameters/reach", true)
	player.advance(0.1)
	must(player.state_of("body") == "reaches" and not player.get("parameters/reach"), "it is fired")


func hear(name: String, number: float, time: float) -> void:
	heard.append([name, number, time])


func behave_otherwise(player: MarrowPlayer, saved: PoolByteArray) -> void:
	must(not player.set_parameter("sped", 1.0) and not player.fire("speed"), "a parameter that is not there")
	must(player.state_of("move") == "" and not player.set_state(PoolByteArray([1, 2])), "a space is no machine")
	must(not player.play_graph("animatr") and player.state_of("body") == "moves", "the graph before stays")
	var other := MarrowPlayer.new()  # looks along the scene's x axis, twice as large
	other.file = player.file
	other.apply_root_motion = true
	other.transform = Transform(Basis(Vector3(0, PI / 2, 0)).scaled(Vector3(2, 2, 2)), Vector3(5, 1, 0))
	get_root().add_child(other)
	must(other._animator != player._animator, "each has its own")
	must(other.set_state(saved) and other.set_parameter("speed", 0.3), "of another player of the graph")
	var before := player.get_state()
	for i in 60:
		other.advance(1.0 / 60)
	must(other.translation.distance_to(Vector3(5.6, 1, 0)) < 2e-3, "it came to %s" % other.translation)
	must(other.scale.is_equal_approx(Vector3(2, 2, 2)), "it stays as large: %s" % other.scale)
	must(player.get_state() == before, "and moves no other")
	must(other.play("walk") and other._animator == -1 and other.get_state().size() == 0, "a clip ends the graph")
	must(not other.set_parameter("speed", 1.0) and other.state_of("body") == "", "then nothing is set")
	must(other.get_root_motion_position() == Vector3(), "nor moved")
	must(other.get("parameters/speed") == null, "then there are no parameters")
	must(other.play_graph(), "and a graph ends the clip")
	set_as_properties(other)
	var number: int = other._animator
	other.free()
	must(player._native.update(number, 0.1).size() == 0, "who is freed lets go of what played")


# The pack has the newt's own clips, each of which then plays as the one that it is.
func add_clips(cooked: MarrowFile) -> void:
	must(not cooked.add_clips("res://turned.mrw"), "a character is no pack")
	must(not cooked.add_clips("res://bad/short.mrw") and not cooked.add_clips("res://bad/missing.mrw"), "nor bad files")
	must(cooked.add_clips("res://bad/pack.mrw"), "clips are added")
	var native = cooked.native()
	must(Array(native.clips()) == ["idle", "walk", "twist", "reach", "idle", "walk", "twist", "reach"], "twice as many")
	must(Array(native.graphs()) == ["animator"], "and a graph: %s" % native.graphs())
	var player := MarrowPlayer.new()
	player.file = cooked
	get_root().add_child(player)
	player.advance(0.5)
	must(player.state_of("body") == "moves", "which plays")
	player.free()
	for clip in 4:
		var poses := [native.sample(clip, 0.7, -1, 0.0, 1.0), native.sample(clip + 4, 0.7, -1, 0.0, 1.0)]
		must(poses[0].size() == 440 and Array(poses[0]) == Array(poses[1]), "clip %d plays from a pack" % clip)


func refuse(cooked: MarrowFile) -> void:
	var native = cooked.native()
	expect(native.find_clip("wolk") < 0, native, "newt.mrw: there is no clip \"wolk\": it has idle, walk, twist, reach, idle, walk, twist, reach")
	expect(not native.pose(null, 0, 0.0, -1, 0.0, 1.0), native, "is no skeleton of 44 bones")
	var other := Spatial.new()
	expect(not native.pose(other, 0, 0.0, -1, 0.0, 1.0), native, "is no skeleton of 44 bones")
	other.free()
	var few := Skeleton.new()
	few.add_bone("one")
	expect(not native.pose(few, 0, 0.0, -1, 0.0, 1.0), native, "is no skeleton of 44 bones")
	few.free()
	expect(native.sample(8, 0.0, -1, 0.0, 1.0).size() == 0, native, "there is no clip 8")
	expect(native.sample(0, NAN, -1, 0.0, 1.0).size() == 0, native, "not a number")
	expect(native.sample(0, 0.0, 1, 0.0, 2.0).size() == 0, native, "share")
	expect(native.mesh_reals(77, "positions", 4).size() == 0, native, "no mesh 77")
	expect(native.mesh_reals(0, "wights", 4).size() == 0, native, "\"wights\"")
	expect(native.mesh_ints(0, "bones", 99).size() == 0, native, "1 … 8 influences")
	expect(native.duration("walk") == 0.0, native, "MarrowNative.duration is to be called with (clip)")
	expect(native.clips(1).size() == 0, native, "MarrowNative.clips is to be called with ()")


func expect(refused: bool, native, message: String) -> void:
	must(refused and message in native.get_error(), "\"%s\" has \"%s\"" % [native.get_error(), message])


func bad_files() -> void:
	for name in ["empty", "text", "short", "damaged", "version", "meshopt", "pack", "parted", "missing"]:
		must(load("res://bad/%s.mrw" % name) == null, name + ".mrw is refused")
	var several = preload("res://addons/marrow/marrow_native.gdns").new()
	must(several.clips().size() == 0 and several.sample(0, 0.0, -1, 0.0, 1.0).size() == 0, "nothing is open")
	var stream := File.new()
	must(stream.open("res://newt.mrw", File.READ) == OK, "newt.mrw can be read")
	var bytes := stream.get_buffer(stream.get_len())
	expect(not several.open(bytes, "newt.mrw", 3), several, "newt.mrw: has no skeleton 3: choose one of 0 … 0")
	must(several.open(bytes, "newt.mrw", 0) and several.get_error() == "", "and then it opens")
