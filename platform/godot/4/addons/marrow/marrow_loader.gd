## Makes load("res://hero.mrw") a MarrowFile. Godot finds this by its name, once the project was open in the editor.
@tool
class_name MarrowLoader
extends ResourceFormatLoader


func _get_recognized_extensions() -> PackedStringArray:
	return PackedStringArray(["mrw"])


func _get_resource_type(path: String) -> String:
	return "Resource" if path.get_extension().to_lower() == "mrw" else ""


func _handles_type(type: StringName) -> bool:
	return type == &"Resource"


func _load(path: String, original_path: String, _use_sub_threads: bool, _cache_mode: int) -> Variant:
	if not FileAccess.file_exists(path):
		push_error("%s: cannot be read: is it where the scene says?" % original_path)
		return ERR_FILE_CANT_OPEN
	var out: Resource = preload("marrow_file.gd").new()
	out.bytes = FileAccess.get_file_as_bytes(path)
	out.source = original_path
	return out if out.native() != null else ERR_FILE_CORRUPT
