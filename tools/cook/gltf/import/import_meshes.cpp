// Imports meshes as triangle lists.
#include "cook/gltf/import/import_vertices.h"

namespace marrow::cook::gltf {
namespace {

constexpr std::uint64_t kFreeBytes = std::uint64_t{1} << 28;
constexpr std::uint64_t kMostExpansion = 32;    // Draco reaches about 20 on smooth meshes
constexpr std::uint64_t kBytesPerVertex = 128;  // a RawPrimitive's, with influences

// Degenerate triangles join the parts of a strip and show nothing.
void add_if_visible(std::vector<std::uint32_t>& triangles, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (a == b || b == c || c == a) return;
  triangles.insert(triangles.end(), {a, b, c});
}

// glTF 2.0, section 3.7.2.1, "Topology types".
std::vector<std::uint32_t> unroll_strip(const std::vector<std::uint32_t>& strip) {
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
    add_if_visible(triangles, strip[i], strip[i + 1 + i % 2], strip[i + 2 - i % 2]);
  }
  return triangles;
}

std::vector<std::uint32_t> unroll_fan(const std::vector<std::uint32_t>& fan) {
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i + 2 < fan.size(); ++i) add_if_visible(triangles, fan[i + 1], fan[i + 2], fan[0]);
  return triangles;
}

std::vector<std::uint32_t> import_triangles(VertexSource& source, const tinygltf::Primitive& primitive,
                                            const std::string& where, Report& report) {
  std::vector<std::uint32_t> indices = source.read_vertex_indices();
  switch (source.is_draco() ? TINYGLTF_MODE_TRIANGLES : primitive.mode) {
    case TINYGLTF_MODE_TRIANGLES:
      if (indices.size() % 3 != 0) {
        report.warn(where, "incomplete-triangle",
                    "the vertices are not a multiple of three; the last ones are left out");
        indices.resize(indices.size() / 3 * 3);
      }
      return indices;
    case TINYGLTF_MODE_TRIANGLE_STRIP:
      return unroll_strip(indices);
    case TINYGLTF_MODE_TRIANGLE_FAN:
      return unroll_fan(indices);
    default:
      break;
  }
  report.warn(where, "points-and-lines-dropped", "only triangles are drawn");
  return {};
}

RawPrimitive import_primitive(const Document& document, const Materials& materials,
                              const tinygltf::Primitive& primitive, const std::string& where, Budget& budget,
                              Report& report) {
  RawPrimitive raw;
  raw.pointer = where;
  if (!primitive.attributes.contains("POSITION")) {
    report.warn(under(where, "attributes"), "primitive-without-positions", "nothing can be drawn; left out");
    return raw;
  }
  VertexSource source(document, primitive, where, budget, report);
  budget.take(source.count() * kBytesPerVertex, where, report);
  import_positions(source, raw, report);
  raw.indices = import_triangles(source, primitive, where, report);
  import_normals(source, raw, report);
  import_tangents(source, raw, report);
  import_colours(source, raw, report);
  raw.material = primitive.material < 0 ? kNone : primitive.material;
  import_uvs(source, raw.material == kNone ? UvMapping{} : materials.uvs[static_cast<std::size_t>(raw.material)], raw,
             report);
  import_targets(document, primitive, where, budget, raw, report);
  import_influences(source, raw, report);
  return raw;
}

}  // namespace

Budget::Budget(std::uint64_t source_bytes) : left_(kFreeBytes + kMostExpansion * source_bytes) {}

void Budget::take(std::uint64_t bytes, const std::string& where, const Report& report) {
  if (bytes > left_) {
    report.unsupported(where, "scene unfolds too far", "the file's data is used over and over; split or export again");
  }
  left_ -= bytes;
}

std::vector<RawMesh> import_meshes(const Document& document, const Materials& materials, Budget& budget,
                                   Report& report) {
  std::vector<RawMesh> meshes;
  for (std::size_t m = 0; m < document.model.meshes.size(); ++m) {
    const tinygltf::Mesh& mesh = document.model.meshes[m];
    RawMesh& raw = meshes.emplace_back();
    raw.name = clean_name(mesh.name, pointer("meshes", m), report);
    raw.weights = mesh_weights(document, m, raw.name, {}, pointer("meshes", m), report);
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const std::string where = pointer("meshes", m, "primitives", p);
      RawPrimitive primitive = import_primitive(document, materials, mesh.primitives[p], where, budget, report);
      budget.take(mesh.primitives.front().targets.size() * sizeof(RawTarget), where, report);
      primitive.targets.resize(mesh.primitives.front().targets.size());
      if (!primitive.indices.empty()) raw.primitives.push_back(std::move(primitive));
    }
  }
  return meshes;
}

}  // namespace marrow::cook::gltf
