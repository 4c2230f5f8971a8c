// Lays the built scene out as a cooked file.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "common/aligned_bytes.h"
#include "cook/scene/built.h"

namespace marrow::cook {

struct WrittenFile {
  std::vector<std::byte> bytes;
  tools::AlignedBytes plain;  // as load() takes it, not packed
  // Bytes of each clip's, geometry's and mesh's section, in their order; of a clip's once it is unpacked, too.
  std::vector<std::size_t> clip_bytes, geometry_bytes, mesh_bytes, clip_memory_bytes;
  struct Part {
    std::uint32_t type;  // as File::Section's
    std::uint32_t bytes;
  };
  std::vector<Part> sections;  // or, in a packed file, the records that stand for them
};

// docs/format.md; packed if a geometry is, or a clip that may be. The result has passed load(). Throws tools::Failure
// (unsupported) beyond 4 GiB.
WrittenFile write_scene(const BuiltScene& scene, const std::string& source);

}  // namespace marrow::cook
