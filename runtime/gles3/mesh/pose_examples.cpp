// Once a mesh: the examples' changes into a texture. Every frame: how far poses are from the examples.
//
// The texture holds the changes of one vertex next to each other, a texel for each example that moves it, so a vertex
// reads what moves it and no more. What no example moves costs four bytes and one comparison.
#include "gles3/mesh/pose_examples.h"
#include "gles3/program.h"

#include <cstring>

#include "core/check.h"
#include "core/zone.h"
#include "gles3/gl_constants.h"
#include "gles3/mesh/changes.h"
#include "gles3/texture.h"
#include "marrow/skin.h"

namespace marrow::gles3 {
namespace {

constexpr std::uint32_t kWidth = 2048, kMostLines = 2048;  // what GLES 3.0 promises
constexpr std::size_t kChangeBytes = 8;

Changes example_changes(const Geometry& g) {
  return {g.pose_space.blocks, g.index_bytes == 4, g.pose_space.records};
}

// Texels for a palette entry's distances: to the bind pose, then to the examples, four per texel.
std::uint32_t distance_texels(const Geometry& g) {
  return (static_cast<std::uint32_t>(g.pose_space.examples.size) + 4) / 4;
}

// The word of each vertex that says where its changes are.
class Rows {
 public:
  Rows(std::byte* vertices, const VertexLayout& layout)
      : first_(vertices + layout.example_row), stride_(layout.ssd_stride) {}

  std::uint32_t get(std::uint32_t slot) const {
    std::uint32_t row = 0;
    std::memcpy(&row, first_ + slot * stride_, sizeof(row));
    return row;
  }
  void set(std::uint32_t slot, std::uint32_t row) const { std::memcpy(first_ + slot * stride_, &row, sizeof(row)); }

 private:
  std::byte* first_;
  std::size_t stride_;
};

// Sets each slot's row to its first change. Returns the number of changes.
std::uint64_t number_rows(const Geometry& g, const Rows& rows) {
  for (std::uint32_t slot = 0; slot < g.slot_count; ++slot) rows.set(slot, 0);
  for (const MorphTarget& example : g.pose_space.examples)
    for_each_moved(example_changes(g), example,
                   [&](std::uint32_t slot, const std::int16_t*, std::uint32_t) { rows.set(slot, rows.get(slot) + 1); });
  std::uint64_t total = 0;
  for (std::uint32_t slot = 0; slot < g.slot_count; ++slot) {
    const std::uint32_t count = rows.get(slot);
    rows.set(slot, static_cast<std::uint32_t>(total));
    total += count;
  }
  return total;
}

// One step for all examples: the largest change is 32767 of it.
double common_step(const Geometry& g) {
  double largest = 0;
  for (const MorphTarget& example : g.pose_space.examples)
    for_each_moved(example_changes(g), example, [&](std::uint32_t, const std::int16_t* records, std::uint32_t lane) {
      for (std::uint32_t c = 0; c < 3; ++c) {
        const double change = double{example.position_step} * records[4 * c + lane];
        if (change > largest) largest = change;
        if (-change > largest) largest = -change;
      }
    });
  return largest > 0 ? largest / 32767 : 1;
}

// A texel is a change in steps, then 1 + the number of its example, negated in the last texel of a vertex.
void fill_texels(const Geometry& g, const Rows& rows, double step, std::int16_t* texels) {
  std::int16_t number = 0;
  for (const MorphTarget& example : g.pose_space.examples) {
    ++number;
    const double scale = double{example.position_step} / step;
    for_each_moved(example_changes(g), example,
                   [&](std::uint32_t slot, const std::int16_t* records, std::uint32_t lane) {
                     const std::uint32_t row = rows.get(slot);
                     std::int16_t* const texel = texels + std::size_t{4} * row;
                     for (std::uint32_t c = 0; c < 3; ++c) {
                       const double change = scale * records[4 * c + lane];
                       texel[c] = static_cast<std::int16_t>(change < 0 ? change - 0.5 : change + 0.5);
                     }
                     texel[3] = number;
                     rows.set(slot, row + 1);
                   });
  }
  // Each slot's row has advanced to the first change of the next slot.
  std::uint32_t first = 0;
  for (std::uint32_t slot = 0; slot < g.slot_count; ++slot) {
    const std::uint32_t end = rows.get(slot);
    rows.set(slot, end > first ? first + 1 : 0);
    std::int16_t* const number_of_last = texels + std::size_t{4} * end - 1;
    if (end > first) *number_of_last = static_cast<std::int16_t>(-*number_of_last);
    first = end;
  }
}

}  // namespace

std::size_t example_scratch_bytes(const Geometry& g) {
  std::size_t most = 0;
  for (const MorphTarget& example : g.pose_space.examples) most += std::size_t{4} * example.block_count;
  return g.pose_space.examples.empty() ? 0 : (most + kWidth) * kChangeBytes;
}

Status make_examples(const Api& api, const Geometry& g, float half_extent, std::byte* vertices, Span<std::byte> scratch,
                     GpuMesh& out) {
  const Rows rows(vertices, out.layout);
  const std::uint64_t lines = number_rows(g, rows) / kWidth + 1;
  if (lines > kMostLines) return Status::unsupported;
  auto* const texels = reinterpret_cast<std::int16_t*>(scratch.data);
  std::memset(texels, 0, static_cast<std::size_t>(lines) * kWidth * kChangeBytes);
  const double step = common_step(g);
  fill_texels(g, rows, step, texels);
  out.example_step = static_cast<float>(step / double{half_extent});
  out.distances = distance_matrices(g);
  out.distance_texels = distance_texels(g);
  out.example_texture =
      make_texture(api, kGlRgba16i, kGlRgbaInteger, kGlShort, kWidth, static_cast<std::uint32_t>(lines));
  api.TexSubImage2D(kGlTexture2d, 0, 0, 0, static_cast<int>(kWidth), static_cast<int>(lines), kGlRgbaInteger, kGlShort,
                    texels);
  api.BindTexture(kGlTexture2d, 0);
  return Status::ok;
}

std::uint32_t distance_matrices(const Geometry& g) {
  return g.pose_space.examples.empty() ? 0 : (g.joint_count * distance_texels(g) + 2) / 3;
}

Status pack_distances(const Geometry& g, Span<const Affine> palette, Span<Affine> out) {
  MARROW_ZONE;
  const std::size_t examples = g.pose_space.examples.size, stride = std::size_t{4} * distance_texels(g);
  MARROW_REQUIRE(examples > 0 && "a geometry with examples");
  MARROW_REQUIRE(holds(palette, g.joint_count));
  MARROW_REQUIRE(holds(out, distance_matrices(g)));
  float* const floats = out.data->rows[0];
  static_cast<void>(psd_distances(g, palette, {floats, psd_distance_count(g)}));
  // Backwards, since an entry's numbers move to a higher place: entries take more room here.
  for (std::size_t j = g.joint_count; j-- > 0;) {
    const float* const from = floats + (examples + 1) * j;
    float* const to = floats + stride * j;
    const float bind = from[examples];
    std::memmove(to + 1, from, examples * sizeof(float));
    to[0] = bind;
    for (std::size_t i = examples + 1; i < stride; ++i) to[i] = 0;
  }
  return Status::ok;
}

Status bind_examples(const Api& api, const GpuMesh& mesh, const PaletteTexture& distances, std::uint32_t first,
                     std::uint32_t texture_unit, const Program& program) {
  MARROW_ZONE;
  const ProgramState& at = state_of(program);
  MARROW_REQUIRE(mesh.example_texture != 0 && "prepared for this deformer");
  MARROW_REQUIRE(at.examples >= 0 && "a program of Deformer::psd, in use");
  MARROW_REQUIRE(first < distances.count && mesh.distances <= distances.count - first);
  api.ActiveTexture(kGlTexture0 + texture_unit);
  api.BindTexture(kGlTexture2d, mesh.example_texture);
  api.Uniform1i(at.examples, static_cast<int>(texture_unit));
  api.ActiveTexture(kGlTexture0 + texture_unit + 1);
  api.BindTexture(kGlTexture2d, distances.textures[distances.current]);
  api.Uniform1i(at.distances, static_cast<int>(texture_unit + 1));
  const int row[] = {static_cast<int>(3 * first), static_cast<int>(3 * mesh.distances),
                     static_cast<int>(mesh.distance_texels)};
  api.Uniform1iv(at.distance_row, 3, row);
  api.Uniform1f(at.example_step, mesh.example_step);
  return Status::ok;
}

Status bind_previous_distances(const Api& api, const GpuMesh& mesh, const PaletteTexture& distances,
                               std::uint32_t first, bool kept, std::uint32_t texture_unit, const Program& program) {
  const ProgramState& at = state_of(program);
  MARROW_REQUIRE(at.examples >= 0 && "a program of Deformer::psd, in use");
  const std::uint32_t count = kept ? distances.previous_count : distances.count;
  MARROW_REQUIRE(first < count && mesh.distances <= count - first);
  if (at.previous_distances < 0) return Status::ok;
  api.ActiveTexture(kGlTexture0 + texture_unit);
  api.BindTexture(kGlTexture2d, distances.textures[(distances.current + (kept ? 2 : 0)) % 3]);
  api.Uniform1i(at.previous_distances, static_cast<int>(texture_unit));
  return Status::ok;
}

}  // namespace marrow::gles3
