// Decodes KHR_draco_mesh_compression.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cook/gltf/document/accessor.h"
#include "cook/gltf/document/findings.h"

namespace draco {
class Mesh;
}

namespace marrow::cook::gltf {

// A decoded mesh. Draco data carries no checksum: whatever is read from here may be wrong in value, never in size or
// in bounds.
class DracoGeometry {
 public:
  // What the document promises about the data. Data that differs is refused, as a rule before it is unfolded: a few
  // bytes of Draco can stand for millions of points.
  struct Promise {
    std::uint64_t points;
    std::uint64_t most_faces;
  };

  DracoGeometry(std::span<const std::byte> bytes, const Promise& promise, const std::string& where,
                const Report& report);
  ~DracoGeometry();
  DracoGeometry(const DracoGeometry&) = delete;
  DracoGeometry& operator=(const DracoGeometry&) = delete;

  // Three a triangle, each below the number of points.
  std::vector<std::uint32_t> indices() const;

  // As many floats a point as the accessor says, in point order. Integers are normalised if it says so.
  std::vector<float> attribute(std::uint32_t unique_id, const Accessor& accessor, const std::string& where) const;

 private:
  std::unique_ptr<draco::Mesh> mesh_;
  const Report& report_;
};

}  // namespace marrow::cook::gltf
