// The comparison itself: a list of differences, each with a kind for programs and a sentence for people.
#pragma once

#include <nlohmann/json.hpp>

#include "common/load_mrw.h"

namespace marrow::tools {

// [{"kind", "in", "text", …numbers}], in the order sections, skeletons, meshes, clips. Elements and joints are the same
// if they have the same name; of several with one name the first is the first, and so on. Empty if nothing differs that
// has a meaning; the files may still differ in bytes. character: what clips of two packs move, for how far apart their
// poses are; null: not known.
nlohmann::ordered_json compare(const LoadedFile& a, const LoadedFile& b, const LoadedFile* character);

}  // namespace marrow::tools
