#include "gl/support/worst.h"

namespace marrow::test {
namespace {

double row_dot(const double* a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double conditioning_of(const double m[9]) {
  const double det =
      m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
  const double size = std::sqrt(row_dot(m, m) * row_dot(m + 3, m + 3) * row_dot(m + 6, m + 6));
  return size > 0 ? std::fabs(det) / size : 0;
}

}  // namespace

std::vector<double> conditioning(const Geometry& g, Span<const Affine> palette, bool residual_weights) {
  std::vector<double> out;
  const float* skin = g.skin;
  const float* residual = g.as_residual;
  const std::uint16_t* set = g.sets;
  for (const Run& run : g.runs) {
    const std::uint32_t k = run.influences;
    for (std::uint32_t slot = 0; slot < (run.vertex_count + 3) / 4 * 4; ++slot) {
      const float* const block = skin + std::size_t{slot / 4} * 4 * (k + 2);
      double matrix[9] = {};
      double last = 1;
      for (std::uint32_t j = 0; j < k; ++j) {
        double w = j + 1 < k ? static_cast<double>(block[12 + 4 * j + slot % 4]) : last;
        last -= w;
        if (residual_weights && residual != nullptr) {
          w += static_cast<double>(residual[std::size_t{slot / 4} * 16 * k + 16 * j + 12 + slot % 4]);
        }
        for (std::size_t c = 0; c < 9; ++c) matrix[c] += w * static_cast<double>(palette[set[j]].rows[c / 3][c % 3]);
      }
      out.push_back(conditioning_of(matrix));
    }
    const std::size_t blocks = (run.vertex_count + 3) / 4;
    skin += blocks * 4 * (k + 2);
    if (residual != nullptr) residual += blocks * 16 * k;
    set += k;
  }
  return out;
}

std::vector<double> surface_conditioning(const Geometry& g, Span<const float> tangents, Span<const Affine> palette) {
  double centre[3], half = 1e-30;
  for (int c = 0; c < 3; ++c) {
    centre[c] = 0.5 * (static_cast<double>(g.box_min[c]) + static_cast<double>(g.box_max[c]));
    half = std::max(half, static_cast<double>(g.box_max[c]) - centre[c]);
  }
  std::vector<double> out;
  const float* block = tangents.data;
  const std::uint16_t* set = g.sets;
  for (const Run& run : g.runs) {
    const std::uint32_t k = run.influences;
    for (std::uint32_t slot = 0; slot < (run.vertex_count + 3) / 4 * 4; ++slot) {
      const float* const lane = block + std::size_t{slot / 4} * (32 * k - 8) + slot % 4;
      double t[2][3] = {}, ratio[2];
      for (std::size_t a = 0; a < 2; ++a) {
        double left[4] = {}, largest = 0;
        for (std::size_t c = 0; c < 3; ++c) left[c] = static_cast<double>(lane[12 * a + 4 * c]);
        for (std::uint32_t j = 0; j < k; ++j) {
          double tau[4];
          for (std::size_t c = 0; c < 4; ++c) {
            tau[c] = j + 1 < k ? static_cast<double>(lane[24 + 32 * j + 16 * a + 4 * c]) : left[c];
            if (j + 1 < k) left[c] -= tau[c];
          }
          for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 4; ++c) t[a][r] += static_cast<double>(palette[set[j]].rows[r][c]) * tau[c];
          for (std::size_t c = 0; c < 3; ++c)
            largest = std::max(largest, std::fabs(tau[c] - centre[c] * tau[3]) / half);
          largest = std::max(largest, std::fabs(tau[3]));
        }
        ratio[a] = largest > 0 ? std::sqrt(row_dot(t[a], t[a])) / (half * largest) : 0;
      }
      const double n[3] = {t[0][1] * t[1][2] - t[0][2] * t[1][1], t[0][2] * t[1][0] - t[0][0] * t[1][2],
                           t[0][0] * t[1][1] - t[0][1] * t[1][0]};
      const double lengths = row_dot(t[0], t[0]) * row_dot(t[1], t[1]);
      out.push_back(lengths > 0 ? std::min(ratio[0], ratio[1]) * std::sqrt(row_dot(n, n) / lengths) : 0);
    }
    block += std::size_t{(run.vertex_count + 3) / 4} * (32 * k - 8);
    set += k;
  }
  return out;
}

Worst compare(const Geometry& g, const Skinned& got, const SkinOutput& want, double diagonal,
              const std::vector<double>& well, double least) {
  Worst worst;
  for (std::size_t slot = 0; slot < g.slot_count; ++slot) {
    double squared = 0;
    for (std::size_t c = 3 * slot; c < 3 * slot + 3; ++c) {
      const double d = static_cast<double>(got.positions[c]) - static_cast<double>(want.positions[c]);
      squared += d * d;
    }
    // A NaN must not pass for a small error.
    worst.position = squared >= 0 ? std::max(worst.position, std::sqrt(squared) / diagonal) : 1e30;
    ++worst.vertices;
    if (well[slot] < least) continue;
    const auto length2 = [](const float* v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; };
    if (!want.normals.empty() && length2(&want.normals[3 * slot]) > 0.5f) {
      worst.normal_deg = std::max(worst.normal_deg, angle_deg(&got.normals[3 * slot], &want.normals[3 * slot]));
      ++worst.normals;
    }
    if (!want.tangents.empty() && length2(&want.tangents[4 * slot]) > 0.5f) {
      worst.tangent_deg = std::max(worst.tangent_deg, angle_deg(&got.tangents[4 * slot], &want.tangents[4 * slot]));
      if (!(got.tangents[4 * slot + 3] * want.tangents[4 * slot + 3] > 0)) ++worst.wrong_signs;
      ++worst.tangents;
    }
  }
  return worst;
}

}  // namespace marrow::test
