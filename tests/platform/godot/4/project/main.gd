# What 3/check.gd does, in Godot 4 with recorded.gd in the library's place; and a picture, as a line of base 64.
extends Node3D

const STEPS := 30

var failures := 0


func must(good: bool, what: String) -> void:
	if not good:
		failures += 1
		print("FAILED: " + what)


func _ready() -> void:
	var cooked: Resource = load("res://newt.mrw")
	must(cooked is MarrowFile, "newt.mrw loads as a MarrowFile")
	for bad: String in ["empty", "short", "missing"]:
		must(load("res://bad/%s.mrw" % bad) == null, bad + ".mrw is refused")
	if cooked is MarrowFile:
		compare(cooked)
		play_on(cooked)
		must(cooked.add_clips("res://bad/pack.mrw") and not cooked.add_clips("res://bad/short.mrw") and
				not cooked.add_clips("res://bad/missing.mrw"), "clips are added")
		behave()
		await take_picture(cooked)
	must(load("res://original.gd").new().native() == null, "without the library nothing opens")
	var walking: Node = load("res://docs_graph.gd").new()
	add_child(walking)
	for i in 120:
		walking._process(1.0 / 60)
		walking.hero.advance(1.0 / 60)
	must(absf(walking.hero.position.z - 0.6) < 1e-3 and walking.steps > 1, "the page's other example walks")
	var example: Node = load("res://docs.gd").new()  # as docs/platforms/godot.md has it
	add_child(example)
	must(example.get_child_count() == 1 and example.get_child(0).skeleton != null, "the page's example plays")
	print("%d failures" % failures)
	get_tree().quit(1 if failures > 0 else 0)


func compare(cooked: MarrowFile) -> void:
	var native := cooked.native()
	var skeleton := cooked.make_skeleton()
	add_child(skeleton)
	cooked.add_meshes(skeleton)
	var scene := FileAccess.get_file_as_bytes("res://expected/scene.bin").to_float32_array()
	var skinned := FileAccess.get_file_as_bytes("res://expected/skinned.bin").to_float32_array()
	var farthest := 0.0
	var farthest_vertex := 0.0
	var next := 0
	var next_vertex := 0
	for clip: int in native.clips().size():
		for step in STEPS:
			must(native.pose(skeleton, clip, step * 0.05, -1, 0.0, 1.0), "a pose")
			for bone in skeleton.get_bone_count():
				var at := skeleton.transform * skeleton.get_bone_global_pose(bone)
				for row in 3:
					for column in 4:
						var has: float = at.origin[row] if column == 3 else at.basis[column][row]
						farthest = maxf(farthest, absf(has - scene[next]))
						next += 1
			if step == 8:
				for vertex in skin(skeleton):
					var expected := Vector3(skinned[next_vertex], skinned[next_vertex + 1], skinned[next_vertex + 2])
					farthest_vertex = maxf(farthest_vertex, vertex.distance_to(expected))
					next_vertex += 3
	must(next == scene.size(), "all bones were compared")
	must(next_vertex == skinned.size(), "all vertices were compared")
	must(farthest < 2e-6, "bones are off by %s" % farthest)
	must(farthest_vertex < 1e-4, "vertices are off by %s m" % farthest_vertex)  # Godot keeps weights in 16 bits
	print("%d clips, %d bones within %.7f of Marrow's, vertices within %.6f m" % [
			native.clips().size(), skeleton.get_bone_count(), farthest, farthest_vertex])
	skeleton.free()


# What Godot's own skinning makes of the meshes: the same sum over the lists that its shader gets.
func skin(skeleton: Skeleton3D) -> PackedVector3Array:
	var out := PackedVector3Array()
	for instance: MeshInstance3D in skeleton.get_children():
		var arrays := instance.mesh.surface_get_arrays(0)
		var bones: PackedInt32Array = arrays[Mesh.ARRAY_BONES]
		var weights: PackedFloat32Array = arrays[Mesh.ARRAY_WEIGHTS]
		var palette: Array[Transform3D] = []
		for i in instance.skin.get_bind_count():
			var global := skeleton.get_bone_global_pose(instance.skin.get_bind_bone(i))
			palette.append(skeleton.transform * global * instance.skin.get_bind_pose(i))
		var positions: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
		for v in positions.size():
			var sum := Vector3()
			for i in 4:
				sum += weights[4 * v + i] * (palette[bones[4 * v + i]] * positions[v])
			out.append(sum)
	return out


func play_on(cooked: MarrowFile) -> void:
	var player := MarrowPlayer.new()
	player.file = cooked
	player.clip = "walk"
	var ended: Array[String] = []
	player.finished.connect(func(clip: String) -> void: ended.append(clip))
	add_child(player)
	must(player.clips() == PackedStringArray(["idle", "walk", "twist", "reach"]), "clips: %s" % player.clips())
	must(player.skeleton.get_child_count() == 6, "six meshes are shown")
	for i in 100:
		player.advance(1.0 / 60)
	must(is_equal_approx(player.time, fposmod(100.0 / 60, player.duration())), "walk goes round: %s" % player.time)
	must(player.play("idle", 0.5), "idle plays")
	for i in 40:
		player.advance(1.0 / 60)
	player.loop = false
	must(player.play("reach"), "reach plays")
	player.speed = 2.0
	player.advance(60.0)
	must(not player.playing and player.time == player.duration() and ended == ["reach"], "it stops at the end")
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
	player.rotation.y = PI / 2  # looks along the scene's x axis, twice as large
	player.scale = Vector3(2, 2, 2)
	var heard := PackedStringArray()
	player.motion_event.connect(func(name: String, _number: float, time: float) -> void:
		must(time >= 0, "it has a time")
		heard.append(name))
	add_child(player)
	must(not player.playing and player.graphs() == PackedStringArray(["animator"]), "the first graph plays")
	must(player.parameters() == PackedStringArray(["speed", "reach"]), "parameters: %s" % player.parameters())
	must(player.state_of("body") == "", "nothing is shown at first")
	must(player.set_parameter("speed", 0.3), "speed is set")
	var saved := PackedByteArray()
	var lines := PackedStringArray()
	var state := ""
	for frame in 300:
		if frame == 120:
			must(player.position.distance_to(Vector3(1.2, 0, 0)) < 2e-3, "2 s at twice 0.3 m/s: %s" % player.position)
			must(player.get_root_motion_position().distance_to(Vector3(0, 0, 0.005)) < 1e-4, "of a frame in its own axes")
			must(player.get_root_motion_rotation().is_equal_approx(Quaternion()), "and turns by nothing")
			saved = player.get_state()
			must(player.set_parameter("speed", 0) and player.fire(&"reach"), "it is asked to reach")
			set_as_properties(player)
		if frame == 240:
			must(player.set_state(saved), "it is taken back")
		heard.clear()
		player.advance(1.0 / 60)
		for name in heard:
			lines.append("%d %s" % [frame, name])
		if player.state_of("body") != state:
			state = player.state_of("body")
			lines.append("%d is in %s" % [frame, state])
	var expected := FileAccess.get_file_as_string("res://expected/graph.txt")
	must("\n".join(lines) + "\n" == expected, "events and states: %s" % lines)
	must(player.scale.is_equal_approx(Vector3(2, 2, 2)), "it stays as large: %s" % player.scale)
	must(not player.set_parameter("sped", 1.0) and not player.play_graph("animatr"), "what is not there")
	must(not player.set_state(PackedByteArray([1, 2])) and player.state_of("body") == "moves", "nor another state")
	must(player.play("walk") and player.get_state().is_empty() and not player.fire("reach"), "a clip ends the graph")
	must(player.get_root_motion_position() == Vector3(), "nothing is moved")
	print("a graph: %d events and states, %.4f m" % [lines.size(), player.position.x])
	player.free()


# Parameters as properties: an AnimationTree has them so.
func set_as_properties(player: MarrowPlayer) -> void:
	var listed := {}
	for property in player.get_property_list():
		if property.name.begins_with("parameters/"):
			listed[property.name] = property
	must(listed.keys() == ["parameters/speed", "parameters/reach"], "properties: %s" % [listed.keys()])
	must(listed["parameters/speed"].hint_string == "0.0,1.0,0.001", "a range: %s" % listed["parameters/speed"].hint_string)
	must(listed["parameters/reach"].type == TYPE_BOOL, "a trigger is a truth")
	must(player.get("parameters/speed") == 0.0 and player.get("parameters/sped") == null, "speed reads as it was set")
	player.set("parameters/speed", 0.05)
	must(is_equal_approx(player.get("parameters/speed"), 0.05), "and is set")
	player.set("parameters/reach", true)
	must(player.get("parameters/reach") == false, "a trigger reads false")


# The newt at 0.4 s of its walk: where Godot draws must be where Marrow's skinned vertices are.
func take_picture(cooked: MarrowFile) -> void:
	var player := MarrowPlayer.new()
	player.file = cooked
	player.clip = "walk"
	player.playing = false
	add_child(player)
	player.seek(0.4)
	var camera := Camera3D.new()
	camera.fov = 27
	add_child(camera)
	camera.look_at_from_position(Vector3(2.4, 1.4, 3.6), Vector3(0, 0.65, 0))
	var light := DirectionalLight3D.new()
	add_child(light)
	light.rotation = Vector3(-0.7, 0.7, 0)
	for i in 3:
		await RenderingServer.frame_post_draw
	var image := get_viewport().get_texture().get_image()
	var drawn := Rect2i()
	for y in image.get_height():
		for x in image.get_width():
			if is_drawn(image, Vector2i(x, y)):
				drawn = Rect2i(x, y, 1, 1) if not drawn.has_area() else drawn.expand(Vector2i(x, y))
	var skinned := FileAccess.get_file_as_bytes("res://expected/skinned.bin").to_float32_array()
	var floats := skinned.size() / 4  # of each clip; walk is the second
	var vertices := Rect2()
	var missed := 0
	for i in range(floats, 2 * floats, 3):
		var at := camera.unproject_position(Vector3(skinned[i], skinned[i + 1], skinned[i + 2]))
		vertices = Rect2(at, Vector2()) if i == floats else vertices.expand(at)
		var nearby := false
		for x in 3:
			for y in 3:
				nearby = nearby or is_drawn(image, Vector2i(at) + Vector2i(x - 1, y - 1))
		missed += int(not nearby)
	must(missed == 0, "%d of %d vertices are drawn elsewhere" % [missed, floats / 3])
	must(Vector2(drawn.position).distance_to(vertices.position) < 3 and Vector2(drawn.end).distance_to(vertices.end) < 3,
			"%s is drawn of %s" % [drawn, vertices])
	print("drawn in %s, %d of %d vertices beside it" % [drawn, missed, floats / 3])
	print("PNG:" + Marshalls.raw_to_base64(image.save_png_to_buffer()))


# What is not the character has the colour of project.godot.
func is_drawn(image: Image, at: Vector2i) -> bool:
	return image.get_pixelv(at) != Color8(96, 112, 128)
