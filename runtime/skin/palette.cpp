#include "marrow/palette.h"

#include "core/builtins.h"
#include "core/check.h"
#include "core/zone.h"
#include "math/affine.h"
#include "skin/helper.h"

namespace marrow {
namespace {

// The determinant, in double precision: in single precision it would underflow to 0 for tiny scales.
double volume(const Affine& map) {
  double m[3][3];
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) m[r][c] = static_cast<double>(map.rows[r][c]);
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) + m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// Whether all helpers keep the rules in file.h. A float is above 0 and below 1 exactly if its bits are between theirs.
bool blend_two(Span<const Helper> helpers, std::size_t joint_count) {
  constexpr std::uint32_t kOne = 0x3F800000;
  const auto count = static_cast<std::uint32_t>(joint_count < 65536 ? joint_count : 65536);
  std::uint32_t bad = 0;
  for (const Helper& h : helpers) {
    const std::uint32_t first = h.first, second = h.second;
    bad |= static_cast<std::uint32_t>(first >= count) | static_cast<std::uint32_t>(second >= count) |
           static_cast<std::uint32_t>(first == second) |
           static_cast<std::uint32_t>(bit_cast<std::uint32_t>(h.share) - 1 >= kOne - 1);
  }
  return bad == 0;
}

}  // namespace

Status build_palette(Span<const std::uint16_t> joints, Span<const Affine> bind, Span<const Affine> model_from_joint,
                     Span<Affine> out, Span<const Helper> helpers, Span<const float> centres) {
  MARROW_ZONE;
  MARROW_REQUIRE(holds(joints) && holds(helpers) && holds(model_from_joint));
  MARROW_REQUIRE(holds(bind, joints.size));
  MARROW_REQUIRE(holds(out, joints.size + helpers.size));
  MARROW_REQUIRE(centres.empty() || holds(centres, 3 * helpers.size));
  MARROW_REQUIRE(blend_two(helpers, joints.size) && "two joints of the palette, a share between 0 and 1");
  std::uint16_t last = 0;
  for (const std::uint16_t joint : joints) last = last < joint ? joint : last;
  MARROW_REQUIRE(joints.empty() || last < model_from_joint.size);
  const auto product = [&](std::size_t i) {
    multiply(model_from_joint.data[joints.data[i]], bind.data[i], out.data[i]);
  };
  std::size_t i = 0;
  for (; i + 4 <= joints.size; i += 4) {
    product(i);
    product(i + 1);
    product(i + 2);
    product(i + 3);
  }
  for (; i < joints.size; ++i) product(i);
  add_helpers(helpers, centres.empty() ? nullptr : centres.data, {bind.data, joints.size}, out.data);
  return Status::ok;
}

Status build_palette(const Mesh& mesh, Span<const Affine> model_from_joint, Span<Affine> out) {
  MARROW_ZONE;
  return build_palette({mesh.joints, mesh.joint_count}, {mesh.inverse_bind, mesh.joint_count}, model_from_joint, out,
                       mesh.helpers, mesh.helper_centres);
}

bool turns_inside_out(const Affine& map) {
  return volume(map) < 0;
}

bool turns_inside_out(Span<const Affine> palette) {
  std::ptrdiff_t mirrors = 0;
  for (const Affine& map : palette) {
    const double v = volume(map);
    mirrors += (v < 0 ? 1 : 0) - (v > 0 ? 1 : 0);
  }
  return mirrors > 0;
}

}  // namespace marrow
