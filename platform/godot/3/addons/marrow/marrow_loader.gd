# Makes load("res://hero.mrw") a MarrowFile. Godot finds this by its name, once the project was open in the editor.
tool
class_name MarrowLoader
extends ResourceFormatLoader


func get_recognized_extensions() -> PoolStringArray:
	return PoolStringArray(["mrw"])


func get_resource_type(path: String) -> String:
	return "Resource" if path.get_extension().to_lower() == "mrw" else ""


func handles_type(type: String) -> bool:
	return type == "Resource"


# Null, not an error's number, if it fails: of a number Godot 3.2 makes a call of this without end.
func load(path: String, original_path: String):
	var stream := File.new()
	if stream.open(path, File.READ) != OK:
		push_error("%s: cannot be read: is it where the scene says?" % original_path)
		return null
	var out = preload("marrow_file.gd").new()
	out.bytes = stream.get_buffer(stream.get_len())
	out.source = original_path
	return out if out.native() != null else null
