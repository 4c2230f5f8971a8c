// The whole cooker: an artist's file in, a cooked file and a report out.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

struct CookResult {
  std::vector<std::byte> file;
  nlohmann::ordered_json report;  // see report_scene()
  std::vector<RawRead> reads;     // what the result depends on, besides the options
};

// Throws tools::Failure, located.
CookResult cook_file(const std::string& path, const CookOptions& options);
CookResult cook_scene(RawScene scene, const CookOptions& options);
// A graph pack: the options' graphs alone, for characters of other files. At least one is asked for.
CookResult cook_graphs(const CookOptions& options);

// What a clip pack is for: a cooked file, or one that is cooked plainly. Throws as load_mrw() and cook_file().
Character read_character(const std::string& path);

// What is written of a scene: from the artist's to the runtime's. Notes what is mended or left out. Throws
// tools::Failure (invalid: nothing to cook; unsupported: a limit of the format; usage: an option fits nothing).
BuiltScene build_scene(RawScene scene, const CookOptions& options, Notes& notes);

}  // namespace marrow::cook
