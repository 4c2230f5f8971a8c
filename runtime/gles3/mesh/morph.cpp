// Once a mesh: sparse changes into a texture. Every frame: the weights of the targets that count.
//
// The texture holds one rectangle of whole lines per target, with one texel for each row and attribute. Only slots that
// some target moves have a row; any other slot costs four bytes and one comparison.
#include "gles3/mesh/morph.h"
#include "gles3/program.h"

#include <cstring>

#include "core/check.h"
#include "core/zone.h"
#include "gles3/gl_constants.h"
#include "gles3/gl_size.h"
#include "gles3/mesh/changes.h"
#include "gles3/texture.h"

namespace marrow::gles3 {
namespace {

constexpr std::uint32_t kMaxTextureSize = 2048;
constexpr std::size_t kTexelBytes = 8;
// Spare texels behind the last row. The shader may read normals and tangents of targets that have none, and multiplies
// them by 0; the reads must stay inside the texture.
constexpr std::uint32_t kTexelsBehind = 2;

// Texels a row: positions, normals, tangents, up to the last that any target moves.
std::uint32_t texels_per_row(const Geometry& g) {
  std::uint32_t all = 0;
  for (const MorphTarget& t : g.targets) all |= t.attributes;
  return (all & kMorphsTangents) != 0 ? 3 : (all & kMorphsNormals) != 0 ? 2 : 1;
}

Changes changes_of(const Geometry& g) {
  return {g.target_blocks, g.index_bytes == 4, g.target_records};
}

// rows[slot]: 0, or one more than its row.
std::uint32_t number_rows(const Geometry& g, std::uint32_t* rows) {
  std::memset(rows, 0, std::size_t{4} * g.slot_count);
  for (const MorphTarget& t : g.targets)
    for_each_moved(changes_of(g), t, [&](std::uint32_t slot, const std::int16_t*, std::uint32_t) { rows[slot] = 1; });
  std::uint32_t count = 0;
  for (std::uint32_t slot = 0; slot < g.slot_count; ++slot)
    if (rows[slot] != 0) rows[slot] = ++count;
  return count;
}

void fill_rectangle(const Geometry& g, const MorphTarget& t, const std::uint32_t* rows, std::uint32_t per_row,
                    std::int16_t* texels) {
  for_each_moved(changes_of(g), t, [&](std::uint32_t slot, const std::int16_t* records, std::uint32_t lane) {
    std::int16_t* texel = texels + std::size_t{4} * per_row * (rows[slot] - 1);
    for (std::uint32_t attribute = 0; attribute < per_row; ++attribute, texel += 4) {
      if ((t.attributes >> attribute & 1u) == 0) continue;
      for (int c = 0; c < 3; ++c) texel[c] = records[4 * c + static_cast<int>(lane)];
      records += 12;
    }
  });
}

float magnitude(float x) {
  return x < 0 ? -x : x;
}

// The first texel of a target, then its weight times the step of positions, normals and tangents: what a program takes.
struct TargetValues {
  float values[kMorphTargets][4];
  std::uint32_t count = 0;
};

BadCall choose_targets(const Mesh& mesh, const GpuMesh& gpu, Span<const float> weights, TargetValues& out) {
  const Span<const MorphTarget> targets = mesh.geometry.targets;
  MARROW_CHECK(gpu.morph_texture != 0);
  MARROW_CHECK(holds(weights, targets.size));
  float reach[kMorphTargets];
  for (std::size_t t = 0; t < targets.size; ++t) {
    const MorphTarget& target = targets[t];
    const float w = weights[t];
    MARROW_CHECK(w - w == 0 && "weights are finite");
    if (w == 0 || target.block_count == 0) continue;
    // If there is no room, it replaces the target that moves least.
    const float moves = magnitude(w) * (magnitude(target.position_step) + 1e-30f);
    std::uint32_t at = out.count;
    if (out.count == kMorphTargets) {
      at = 0;
      for (std::uint32_t i = 1; i < out.count; ++i)
        if (reach[i] < reach[at]) at = i;
      if (moves <= reach[at]) continue;
    } else {
      ++out.count;
    }
    reach[at] = moves;
    out.values[at][0] = static_cast<float>(t * gpu.morph_texels);  // below 2^22
    out.values[at][1] = w * target.position_step * gpu.morph_unit;
    out.values[at][2] = w * target.normal_step;
    out.values[at][3] = w * target.tangent_step;
  }
  return {};
}

void set_targets(const Api& api, const TargetValues& targets, std::int32_t count, std::int32_t values) {
  if (count < 0) return;
  api.Uniform1i(count, static_cast<int>(targets.count));
  if (targets.count > 0) api.Uniform4fv(values, static_cast<int>(targets.count), targets.values[0]);
}

}  // namespace

std::size_t morph_scratch_bytes(const Geometry& g) {
  if (g.targets.empty()) return 0;
  // Padding a rectangle's last line takes less than the longest line.
  return g.slot_count * (4 + texels_per_row(g) * kTexelBytes) + (kMaxTextureSize + kTexelsBehind) * kTexelBytes;
}

Status make_morphs(const Api& api, const Geometry& g, float half_extent, Span<std::byte> scratch, GpuMesh& out) {
  if (g.targets.empty()) return Status::ok;
  auto* const rows = reinterpret_cast<std::uint32_t*>(scratch.data);
  auto* const texels = reinterpret_cast<std::int16_t*>(scratch.data + std::size_t{4} * g.slot_count);
  const std::uint32_t per_row = texels_per_row(g);
  const std::uint64_t needed = std::uint64_t{number_rows(g, rows)} * per_row + kTexelsBehind;
  std::uint32_t shift = 0;
  while (shift < 11 && (std::uint64_t{1} << shift) < needed) ++shift;
  const std::uint64_t lines = (needed + (std::uint64_t{1} << shift) - 1) >> shift;
  if (lines > kMaxTextureSize || lines * g.targets.size > kMaxTextureSize) return Status::unsupported;
  const int width = 1 << shift, height = static_cast<int>(lines);
  out.morph_texels = static_cast<std::uint32_t>(lines << shift);
  out.morph_shift = static_cast<std::uint8_t>(shift);
  out.morph_per_row = static_cast<std::uint8_t>(per_row);
  out.morph_unit = 1 / half_extent;

  api.GenBuffers(1, &out.morph_buffer);
  api.BindBuffer(kGlArrayBuffer, out.morph_buffer);
  api.BufferData(kGlArrayBuffer, gl_size(std::uint64_t{4} * g.slot_count), rows, kGlStaticDraw);
  api.BindBuffer(kGlArrayBuffer, 0);
  out.morph_texture = make_texture(api, kGlRgba16i, kGlRgbaInteger, kGlShort, static_cast<std::uint32_t>(width),
                                   static_cast<std::uint32_t>(height) * static_cast<std::uint32_t>(g.targets.size));
  for (std::size_t t = 0; t < g.targets.size; ++t) {
    std::memset(texels, 0, std::size_t{out.morph_texels} * kTexelBytes);
    fill_rectangle(g, g.targets[t], rows, per_row, texels);
    api.TexSubImage2D(kGlTexture2d, 0, 0, height * static_cast<int>(t), width, height, kGlRgbaInteger, kGlShort,
                      texels);
  }
  api.BindTexture(kGlTexture2d, 0);
  return Status::ok;
}

Status set_morphs(const Api& api, const Mesh& mesh, const GpuMesh& gpu, Span<const float> weights,
                  std::uint32_t texture_unit, const Program& program) {
  MARROW_ZONE;
  const ProgramState& at = state_of(program);
  MARROW_REQUIRE(at.morph_changes >= 0 && "a program with kMorphs, in use");
  TargetValues targets;
  MARROW_REQUIRE_GOOD(choose_targets(mesh, gpu, weights, targets));
  api.ActiveTexture(kGlTexture0 + texture_unit);
  api.BindTexture(kGlTexture2d, gpu.morph_texture);
  api.Uniform1i(at.morph_changes, static_cast<int>(texture_unit));
  api.Uniform1i(at.morph_shift, gpu.morph_shift);
  api.Uniform1i(at.morph_per_row, gpu.morph_per_row);
  set_targets(api, targets, at.morph_count, at.morph_targets);
  return Status::ok;
}

Status set_previous_morphs(const Api& api, const Mesh& mesh, const GpuMesh& gpu, Span<const float> weights,
                           const Program& program) {
  TargetValues targets;
  MARROW_REQUIRE_GOOD(choose_targets(mesh, gpu, weights, targets));
  set_targets(api, targets, state_of(program).previous_count, state_of(program).previous_targets);
  return Status::ok;
}

}  // namespace marrow::gles3
