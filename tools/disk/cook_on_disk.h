// The cooker's functions, with this machine's files and all of its threads.
#pragma once

#include <string>
#include <vector>

#include "cook/road.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"
#include "disk/read_on_disk.h"

namespace marrow::cook {

RawScene read_rig(const std::string& path);
Character read_character(const std::string& path);
Result cook_file(const std::string& path, const CookOptions& options);
Result cook_scene(RawScene scene, const CookOptions& options);
// Reads what options name from the disk.
CookOptions with_named_files(CookOptions options);

}  // namespace marrow::cook
