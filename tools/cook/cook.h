// The whole cooker: an artist's file in, a cooked file and a report out.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cook/build.h"

namespace marrow::cook {

struct CookResult {
  std::vector<std::byte> file;
  // {source {file, bytes}, output {bytes, sections [{type, bytes}]}, clip_pack, skeletons [{name, joints}], meshes
  // [{name, vertices, triangles, influences, codec, bytes, max_position_error_m}], clips [{name, skeleton, duration_s,
  // raw_bytes, bytes, additive, channels [name], max_error_m}], materials [{name, alpha, textures [{role, image}]}],
  // images [{name, uri, format, bytes}], nodes [{name, skeleton, joint, properties}], keep [{glob, nodes [name]}],
  // warnings [{pointer, rule, text}]}; docs/architecture.md says what each means.
  nlohmann::ordered_json report;
  std::vector<RawRead> reads;  // what the result depends on, besides the options
};

// Throws tools::Failure, located.
CookResult cook_file(const std::string& path, const CookOptions& options);
CookResult cook_scene(RawScene scene, const CookOptions& options);

}  // namespace marrow::cook
