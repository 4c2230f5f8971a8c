// A tube of rings on three joints whose residual stands apart from a codec's streams, by hand but for the residual's
// bits, which `marrow cook` would write.
#pragma once

#include <cstdint>
#include <vector>

#include "support/fan.h"
#include "unpack/smoothed.h"

namespace marrow::test {

// Of animation space: three joints or fewer, and four numbers each.
struct RingVertex {
  int position[3];
  std::vector<int> own, weights;  // of linear blend skinning; of 15
  std::vector<int> joints;
  std::vector<std::vector<int>> residual;
};

struct Ring {
  static constexpr int kRings = 8, kAround = 6, kWeightBits = 4;
  static constexpr std::uint32_t kIterations = 4, kShare = Smoothed::kWholeStep / 2;
  static constexpr float kStep = 0.5f, kStepOfW = 0.0625f;

  std::vector<RingVertex> vertices;  // ring by ring, the first once more at the end, as at a seam of UVs
  std::vector<int> triangles;

  static int u(int vertex) { return vertex % (kAround + 1); }
  static int v(int vertex) { return vertex / (kAround + 1); }

  Ring() {
    const int y[] = {220, 174, 82, 36, 82, 174, 220}, z[] = {128, 208, 208, 128, 48, 48, 128};
    std::uint32_t random = 1;
    const auto next = [&](std::uint32_t end) {
      random = random * 1664525 + 1013904223;
      return static_cast<int>((random >> 16) % end);
    };
    for (int r = 0; r < kRings; ++r)
      for (int k = 0; k <= kAround; ++k) {
        RingVertex v{{30 * r, y[k], z[k]}, {r < 3 ? 0 : r < 6 ? 1 : 2}, {15}, {}, {}};
        if (r == 3) v = {{90, y[k], z[k]}, {0, 1}, {6, 9}, {}, {}};
        if (r == 5) v = {{150, y[k], z[k]}, {1, 2}, {11, 4}, {}, {}};
        v.joints = v.own;
        if (r == 2 || r == 4) v.joints = {0, 1};
        if (r == 3 || r == 5) v.joints = {0, 1, 2};
        v.residual.assign(v.joints.size(), std::vector<int>(4, 0));
        for (std::size_t j = 0; r > 0 && j + 1 < v.joints.size(); ++j)
          for (std::size_t c = 0; c < 4; ++c) {
            v.residual[j][c] = next(9) - 4;
            v.residual.back()[c] -= v.residual[j][c];
          }
        if (r == 7 && k == 3) v.residual[0] = {4000, -1, 2, 0};
        if (k == kAround) v = vertices[vertices.size() - kAround];  // the seam; but for one vertex, which moves apart
        if (k == kAround && r == 3) v.residual[1] = {1, 2, 3, 4};
        vertices.push_back(v);
      }
    for (int r = 0; r + 1 < kRings; ++r)
      for (int k = 0; k < kAround; ++k) {
        const int a = r * (kAround + 1) + k, b = a + kAround + 1;
        triangles.insert(triangles.end(), {a, b, a + 1, a + 1, b, b + 1});
      }
  }
};

// What the cooker's encoder makes of it: tests/unit/cook/mesh/residual_apart_test.cpp.
inline constexpr std::uint8_t kRingBits[] = {
    222, 203, 1,   0,   244, 178, 74,  26,  13,  165, 145, 93,  162, 49,  4,   140, 131, 41,  34,  100,
    100, 2,   115, 82,  167, 179, 174, 211, 105, 251, 43,  91,  12,  105, 121, 175, 198, 138, 154, 98,
    157, 58,  43,  199, 28,  158, 68,  36,  53,  22,  125, 60,  241, 230, 226, 121, 23,  53,  120, 202,
    187, 73,  54,  41,  172, 111, 224, 123, 200, 159, 129, 173, 1,   182, 253, 54,  160, 208, 30,  229,
    142, 10,  225, 78,  72,  164, 83,  171, 177, 181, 102, 105, 200, 63,  223, 188, 23,  63,  151, 224,
    18,  215, 238, 222, 46,  72,  26,  202, 90,  100, 241, 76,  47,  209, 195, 208};

// Its scratch memory, exactly, and what it becomes; empty with a rule if it is refused.
struct UnpackedGeometry {
  const char* rule = nullptr;
  std::vector<std::byte> section;
};
inline UnpackedGeometry unpack_plain(const std::vector<std::byte>& record) {
  const AlignedBlock bytes(record.data(), record.size());  // so that a sanitizer sees what lies behind
  const Span<const std::byte> span(bytes.data(), bytes.size());
  UnpackedGeometry out;
  GeometryNeeds needs{};
  out.rule = measure_geometry_record(span, needs);
  if (out.rule != nullptr || needs.scratch_bytes > 1 << 24 || needs.most_section_bytes > 1 << 24) {
    if (out.rule == nullptr) out.rule = "more than a test gives";
    return out;
  }
  AlignedBlock scratch(static_cast<std::size_t>(needs.scratch_bytes));
  AlignedBlock section(static_cast<std::size_t>(needs.most_section_bytes));
  std::uint32_t section_bytes = 0;
  Status decoded = Status::ok;
  out.rule = unpack_geometry(span, kPlainDecoder[0], {scratch.data(), scratch.size()}, {section.data(), section.size()},
                             section_bytes, decoded);
  if (out.rule == nullptr) out.section.assign(section.data(), section.data() + section_bytes);
  return out;
}

inline std::vector<std::byte> ring_record() {
  const Ring ring;
  const auto varint = [](Bytes& b, std::uint32_t x) {
    for (; x >= 0x80; x >>= 7) b.u8(x | 0x80);
    b.u8(x);
  };
  Bytes b;
  varint(b, format::kHasUvs | format::kHasAsResidual | packed::kResidualIsApart);
  b.u8(static_cast<std::uint32_t>(ring.vertices.size())).u8(static_cast<std::uint32_t>(ring.triangles.size() / 3));
  b.u8(3).u8(2).u8(3);                       // joints, influences, those of animation space
  b.u8(8).f32(-1).f32(0).f32(2).f32(0.25f);  // positions
  b.u8(3).f32(0).f32(0).f32(0.125f);         // UVs
  b.u8(Ring::kWeightBits);                   // weights
  b.u8(Ring::kIterations).u8(Ring::kShare & 0xFF).u8(Ring::kShare >> 8).f32(Ring::kStepOfW).f32(Ring::kStep);
  varint(b, sizeof kRingBits);
  for (const std::uint8_t byte : kRingBits) b.u8(byte);
  for (const int v : ring.triangles) b.u32(static_cast<std::uint32_t>(v));
  for (const RingVertex& v : ring.vertices) b.numbers({v.position[0], v.position[1], v.position[2]});
  for (int v = 0; v < static_cast<int>(ring.vertices.size()); ++v) b.numbers({Ring::u(v), Ring::v(v)});
  for (const RingVertex& v : ring.vertices) b.numbers({v.own.front(), v.own.back()});
  for (const RingVertex& v : ring.vertices) b.numbers({v.own.size() > 1 ? v.weights.front() : 0});
  return b.all;
}

}  // namespace marrow::test
