#include "cook/write/compact.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "cook/geometry/record.h"
#include "cook/scene/matrices.h"
#include "unpack/rest.h"
#include "unpack/structure.h"

namespace marrow::cook {
namespace {

bool is_identity(const Affine& a) {
  return std::memcmp(&a, &kIdentityMap, sizeof a) == 0;
}

// Two bits a number say which is 0, 1 or -1; others follow.
void add_map(const Affine& map, std::vector<std::byte>& out) {
  const std::uint32_t known[] = {0, std::bit_cast<std::uint32_t>(1.0f), std::bit_cast<std::uint32_t>(-1.0f)};
  const std::size_t at = out.size();
  out.resize(at + 3);
  std::uint32_t codes = 0;
  for (int i = 0; i < 12; ++i) {
    const float x = map.rows[i / 4][i % 4];
    const auto code = static_cast<std::uint32_t>(std::ranges::find(known, std::bit_cast<std::uint32_t>(x)) - known);
    codes |= code << 2 * i;
    if (code == 3) add_value(x, out);
  }
  for (std::size_t i = 0; i < 3; ++i) out[at + i] = static_cast<std::byte>(codes >> 8 * i);
}

bool same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

// The largest component takes no bytes if the others give it to the bit, as they mostly do.
void add_rotation(const float (&q)[4], std::vector<std::byte>& out) {
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (std::abs(q[i]) > std::abs(q[largest])) largest = i;
  double squared = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (i != largest) squared += static_cast<double>(q[i]) * static_cast<double>(q[i]);
  const float left = left_of_rotation(squared);
  std::uint32_t codes = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    std::uint32_t code = same_bits(q[i], 0) ? kCodeZero : kCodeGiven;
    if (i == largest && same_bits(q[i], left)) code = kCodeLeft;
    if (i == largest && same_bits(q[i], -left)) code = kCodeMinusLeft;
    codes |= code << 2 * i;
  }
  add_value(static_cast<std::uint8_t>(codes), out);
  for (std::size_t i = 0; i < 4; ++i)
    if ((codes >> 2 * i & 3) == kCodeGiven) add_value(q[i], out);
}

// 0, -1, 1, -2 … as 0, 1, 2, 3 …
void add_signed(std::int32_t value, std::vector<std::byte>& out) {
  const auto bits = static_cast<std::uint32_t>(value);
  add_varint(bits << 1 ^ (0 - (bits >> 31)), out);
}

bool shares_are_bytes(const BuiltMesh& mesh) {
  return std::ranges::all_of(mesh.helpers, [](const Helper& h) { return h.share * 256 == std::floor(h.share * 256); });
}

void add_scale(const float (&scale)[3], std::vector<std::byte>& out) {
  constexpr auto kOne = std::bit_cast<std::int32_t>(1.0f);
  std::uint32_t codes = 0;
  std::int32_t last_bits[3];
  for (std::uint32_t i = 0; i < 3; ++i) {
    const auto bits = std::bit_cast<std::int32_t>(scale[i]);
    last_bits[i] = bits > 0 ? bits - kOne : INT32_MAX;
    const bool near = last_bits[i] >= INT8_MIN && last_bits[i] <= INT8_MAX;
    codes |= (bits == kOne ? kCodeOne : near ? kCodeNearOne : kCodeScale) << 2 * i;
  }
  add_value(static_cast<std::uint8_t>(codes), out);
  for (std::uint32_t i = 0; i < 3; ++i) {
    if ((codes >> 2 * i & 3) == kCodeScale) add_value(scale[i], out);
    if ((codes >> 2 * i & 3) == kCodeNearOne) add_value(static_cast<std::int8_t>(last_bits[i]), out);
  }
}

void add_helpers(const BuiltMesh& mesh, std::vector<std::byte>& out) {
  const bool bytes = shares_are_bytes(mesh);
  for (const Helper& helper : mesh.helpers) {
    add_varint(helper.first, out);
    add_varint(helper.second, out);
    if (bytes)
      add_value(static_cast<std::uint8_t>(helper.share * 256), out);
    else
      add_value(helper.share, out);
  }
  if (mesh.helper_centres.empty()) return;
  add_value(static_cast<std::int8_t>(mesh.centre_exponent), out);
  for (const float c : mesh.helper_centres)
    add_signed(static_cast<std::int32_t>(std::ldexp(c, -mesh.centre_exponent)), out);
}

std::uint32_t shared_start(const std::string& a, const std::string& b) {
  const std::size_t most = std::min({a.size(), b.size(), std::size_t{63}});
  return static_cast<std::uint32_t>(
      std::mismatch(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(most), b.begin()).first - a.begin());
}

}  // namespace

std::vector<std::byte> compact_skeleton(const BuiltSkeleton& s, std::uint32_t name,
                                        const std::vector<std::uint32_t>& joint_names) {
  const std::size_t joints = s.parents.size(), roots = s.model_from_root.size();
  std::vector<std::byte> out;
  add_varint(name, out);
  add_varint(static_cast<std::uint32_t>(joints), out);
  add_varint(static_cast<std::uint32_t>(roots), out);
  for (const Affine& above : s.model_from_root) {
    add_value(static_cast<std::uint8_t>(is_identity(above) ? 0 : 1), out);
    if (!is_identity(above)) add_map(above, out);
  }
  std::vector<std::uint32_t> children(joints, 0);
  for (std::size_t j = roots; j < joints; ++j) ++children[s.parents[j]];
  for (std::size_t j = 0; j < joints; ++j) {
    const SoaTransform& four = s.rest[j / 4];
    const std::size_t lane = j % 4;
    float t[3], q[4];
    std::uint32_t flags = 0;
    bool scales = false;
    for (std::uint32_t i = 0; i < 3; ++i) {
      t[i] = four.translation[i][lane];
      if (!same_bits(t[i], 0)) flags |= packed::kJointTranslates << i;
      scales = scales || four.scale[i][lane] != 1;
    }
    for (int i = 0; i < 4; ++i) q[i] = four.rotation[i][lane];
    if (!(same_bits(q[0], 0) && same_bits(q[1], 0) && same_bits(q[2], 0) && q[3] == 1)) flags |= packed::kJointRotates;
    if (scales) flags |= packed::kJointScales;
    if (joint_names[j] != 0) flags |= packed::kJointNameIsOld;
    const bool many = children[j] >= packed::kJointManyChildren;
    flags |= (many ? packed::kJointManyChildren : children[j]) << packed::kJointChildrenShift;
    add_value(static_cast<std::uint8_t>(flags), out);
    if (many) add_varint(children[j], out);
    if (joint_names[j] != 0) add_varint(joint_names[j] - 1, out);
    for (const float x : t)
      if (!same_bits(x, 0)) add_value(x, out);
    if ((flags & packed::kJointRotates) != 0) add_rotation(q, out);
    if (scales) add_scale({four.scale[0][lane], four.scale[1][lane], four.scale[2][lane]}, out);
  }
  return out;
}

std::vector<std::byte> compact_mesh(const BuiltMesh& mesh, const format::MeshHeader& h,
                                    const std::vector<MeshTarget>& targets) {
  const bool coloured = std::any_of(h.base_colour, h.base_colour + 4, [](float c) { return c != 1; });
  const bool placed = !is_identity(mesh.model_from_mesh);
  const bool helps = !mesh.helpers.empty();
  const bool gives = std::count(mesh.bind_is_given.begin(), mesh.bind_is_given.end(), 1) > 0;
  std::vector<std::byte> out;
  add_varint((mesh.double_sided ? packed::kMeshIsDoubleSided : 0u) | (mesh.part > 0 ? packed::kMeshIsNextPart : 0u) |
                 (coloured ? packed::kMeshHasColour : 0u) | (placed ? packed::kMeshHasPlace : 0u) |
                 (gives ? packed::kMeshGivesBinds : 0u) | (helps ? packed::kMeshHasHelpers : 0u) |
                 (helps && shares_are_bytes(mesh) ? packed::kMeshSharesAreBytes : 0u) |
                 (mesh.helper_centres.empty() ? 0u : packed::kMeshHasCentres) |
                 (mesh.lods.empty() ? 0u : packed::kMeshHasLods),
             out);
  for (const std::uint32_t n :
       {h.name, h.material, h.material_section, h.skeleton, h.geometry, h.joint_count, h.target_count})
    add_varint(n, out);
  if (helps) add_varint(h.helper_count, out);
  if (!mesh.lods.empty()) add_varint(h.lod_count, out);
  if (coloured) add_value(h.base_colour, out);
  if (placed) add_map(mesh.model_from_mesh, out);
  std::uint32_t next = 0;
  for (const std::uint16_t joint : mesh.joints) {
    const std::uint32_t step = joint - next;
    add_signed(static_cast<std::int32_t>(step), out);
    next = joint + 1u;
  }
  if (gives) {
    for (std::size_t i = 0; i < mesh.joints.size(); i += 8) {
      unsigned bits = 0;
      for (std::size_t k = i; k < std::min(i + 8, mesh.joints.size()); ++k)
        bits |= static_cast<unsigned>(mesh.bind_is_given[k] != 0) << (k - i);
      out.push_back(static_cast<std::byte>(bits));
    }
    for (std::size_t i = 0; i < mesh.joints.size(); ++i)
      if (mesh.bind_is_given[i] != 0) add_map(mesh.inverse_bind[i], out);
  }
  for (const MeshTarget& t : targets) {
    add_varint(t.name, out);
    add_varint(t.channel, out);
    add_value(t.weight, out);
  }
  add_helpers(mesh, out);
  for (const BuiltLod& lod : mesh.lods) {
    add_varint(lod.geometry, out);
    add_value(static_cast<float>(lod.max_error_m), out);
  }
  return out;
}

std::vector<std::byte> compact_names(const std::vector<char>& pool) {
  std::vector<std::byte> out;
  add_varint(static_cast<std::uint32_t>(pool.size()), out);
  std::string last[4];  // newest first
  for (std::size_t at = 1; at < pool.size();) {
    const std::string name(pool.data() + at);
    at += name.size() + 1;
    unsigned best = 0;
    for (unsigned i = 1; i < 4; ++i)
      if (shared_start(name, last[i]) > shared_start(name, last[best])) best = i;
    const std::uint32_t shared = shared_start(name, last[best]);
    out.push_back(static_cast<std::byte>(best << 6 | shared));
    for (std::size_t i = shared; i <= name.size(); ++i) out.push_back(static_cast<std::byte>(name.c_str()[i]));
    std::rotate(last, last + 3, last + 4);
    last[0] = name;
  }
  return out;
}

std::uint64_t compact_scratch_bytes(const BuiltSkeleton& skeleton) {
  return skeleton.parents.size() * sizeof(Affine);
}

}  // namespace marrow::cook
