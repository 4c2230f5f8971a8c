// What each vertex of a mesh follows, and with which weight.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

#include "marrow/file.h"

namespace marrow::cook {

// One influence of a vertex: what its palette entry's matrix is multiplied by.
struct Influence {
  std::uint32_t entry;
  double weight;
  glm::dvec4 coordinate;  // of animation space, where its residual has it
};

// Calls visit(slot, influences) for every vertex, without those that fill up blocks.
template <class Visit>
void for_each_vertex(const Geometry& g, Visit visit) {
  const std::uint16_t* set = g.sets;
  const float *skin = g.skin, *residual = g.as_residual;
  std::size_t block = 0;
  std::vector<Influence> influences;
  for (const Run& run : g.runs) {
    const std::size_t k = run.influences;
    for (std::uint32_t v = 0; v < run.vertex_count; ++v) {
      const std::size_t lane = v % 4;
      const float* const at = skin + (v / 4) * (12 + 4 * (k - 1)) + lane;
      const glm::dvec4 place(at[0], at[4], at[8], 1);
      influences.resize(k);
      double left = 1;
      for (std::size_t j = 0; j < k; ++j) {
        const double weight = j + 1 < k ? static_cast<double>(at[12 + 4 * j]) : left;
        left -= weight;
        influences[j] = {set[j], weight, place * weight};
        if (residual == nullptr) continue;
        const float* const r = residual + ((v / 4) * k + j) * 16 + lane;
        influences[j].coordinate += glm::dvec4(r[0], r[4], r[8], r[12]);
      }
      visit(4 * (block + v / 4) + lane, influences);
    }
    const std::size_t blocks = (run.vertex_count + 3) / 4;
    block += blocks;
    skin += blocks * (12 + 4 * (k - 1));
    if (residual != nullptr) residual += blocks * 16 * k;
    set += k;
  }
}

// Calls visit(joint, inverse bind, share) for the joints that a palette entry follows.
template <class Visit>
void for_each_joint(const Mesh& mesh, std::uint32_t entry, Visit visit) {
  const auto one = [&](std::uint32_t e, double share) { visit(mesh.joints[e], mesh.inverse_bind[e], share); };
  if (entry < mesh.joint_count) return one(entry, 1);
  const Helper& helper = mesh.helpers[entry - mesh.joint_count];
  one(helper.first, 1 - static_cast<double>(helper.share));
  one(helper.second, static_cast<double>(helper.share));
}

inline glm::dvec4 transformed(const Affine& m, const glm::dvec4& v) {
  glm::dvec4 out(0, 0, 0, v.w);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) out[r] += static_cast<double>(m.rows[r][c]) * v[c];
  return out;
}

}  // namespace marrow::cook
