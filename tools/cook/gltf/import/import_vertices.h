// The per-vertex arrays of one primitive, cleaned of what geometry cannot be.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cook/gltf/document/accessor.h"
#include "cook/gltf/document/findings.h"
#include "cook/gltf/import/import.h"

namespace draco {
class Mesh;
}

namespace marrow::cook::gltf {

// A mesh of KHR_draco_mesh_compression, decoded. Draco data carries no checksum: whatever is read from here may be
// wrong in value, never in size or in bounds.
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

// Where a primitive's numbers come from: its accessors, or the Draco data that stands in for them.
class VertexSource {
 public:
  VertexSource(const Document& document, const tinygltf::Primitive& primitive, std::string where, Budget& budget,
               Report& report);

  bool has(const std::string& attribute) const { return primitive_.attributes.contains(attribute); }
  std::size_t count() const { return count_; }
  bool is_draco() const { return draco_ != nullptr; }
  // False when zeros stand in for numbers that the document does not give: no finding then about what they are.
  bool has_data(const std::string& attribute) const;
  std::string pointer_of(const std::string& attribute) const { return under(where_, "attributes", attribute); }

  // All vertices' components one after another; the document decides how many a vertex has.
  std::vector<float> read(const std::string& attribute);
  std::size_t components(const std::string& attribute) const;

  // As the file has them: three a triangle only for Draco data and triangle lists. Checked against count().
  std::vector<std::uint32_t> read_vertex_indices();

 private:
  const Accessor& accessor_of(const std::string& attribute) const;
  void open_draco();

  const Document& document_;
  const tinygltf::Primitive& primitive_;
  std::string where_;
  Budget& budget_;
  Report& report_;
  std::size_t count_ = 0;
  std::unique_ptr<DracoGeometry> draco_;
};

void import_positions(VertexSource& source, RawPrimitive& raw, Report& report);
// Needs positions and triangles: a normal that is none is made anew from them.
void import_normals(VertexSource& source, RawPrimitive& raw, Report& report);
void import_tangents(VertexSource& source, RawPrimitive& raw, Report& report);
void import_colours(VertexSource& source, RawPrimitive& raw, Report& report);
// The set that `mapping` names, transformed; where the primitive lacks it, TEXCOORD_0 as it is.
void import_uvs(VertexSource& source, const UvMapping& mapping, RawPrimitive& raw, Report& report);
// Needs positions, normals and tangents. Morph targets are never in Draco data.
void import_targets(const Document& document, const tinygltf::Primitive& primitive, const std::string& where,
                    Budget& budget, RawPrimitive& raw, Report& report);
void import_influences(VertexSource& source, RawPrimitive& raw, Report& report);

}  // namespace marrow::cook::gltf
