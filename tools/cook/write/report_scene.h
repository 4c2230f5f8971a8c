// What the cooker reports about a file that it has written.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cook/scene/built.h"
#include "cook/scene/raw.h"
#include "cook/write/write_scene.h"
#include "marrow/file.h"

namespace marrow::cook {

// What was cooked.
struct SourceFile {
  std::string file;         // as given
  std::uint64_t bytes = 0;  // of it and whatever else was read for it
};

// {source {file, bytes}, output {bytes, sections [{type, bytes}]}, clip_pack, skeletons [{name, joints}], meshes
// [{name, vertices, triangles, influences, codec, bytes, max_position_error_m}], clips [{name, skeleton, duration_s,
// raw_bytes, bytes, memory_bytes, additive, channels [name], max_error_m, max_vertex_error_m, bounds}], materials
// [{name, alpha, textures
// [{role, image}]}], images [{name, uri, format, bytes}], nodes [{name, skeleton, joint, properties}], keep [{glob,
// nodes [name]}], warnings [{pointer, rule, text}]}; docs/reference/report.md says what each means.
nlohmann::ordered_json report_scene(const SourceFile& source, const BuiltScene& built, const WrittenFile& written,
                                    const std::vector<RawWarning>& warnings);

// One a clip of `file`, whose block is `bytes`: [{mesh, box_min, box_max, radius_m}] of every mesh that it moves. Reads
// the sections themselves, since File::bounds() looks at every clip and mesh for each.
std::vector<nlohmann::ordered_json> report_bounds(const File& file, const tools::AlignedBytes& bytes);

}  // namespace marrow::cook
