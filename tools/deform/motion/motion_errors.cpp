#include "deform/motion/motion_errors.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "common/elementary.h"
#include "common/parallel.h"
#include "deform/deformers.h"

namespace marrow::deform {
namespace {

constexpr std::size_t kRings = 7;
constexpr std::size_t kLeastPoints = 3;
constexpr double kLeastBothSides = 1e-3;  // of a vertex that belongs to both sides
constexpr double kLeastVolume = 0.05;     // of what it would be if all triangles faced outwards
constexpr double kRounding = 1e-9;        // of SSD's distance, and of the diagonal

// A point of an edge.
struct Cut {
  std::uint32_t a, b;
  double of_b;
};

// Where what a joint turns goes over into the rest.
class Border {
 public:
  Border(const SkinnedMesh& mesh, const std::vector<char>& turns) : mesh_(mesh), shares_(turned_shares(mesh, turns)) {
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
      bool both = false;
      for (std::size_t i = 0; i < 3; ++i) {
        cut(mesh.indices[t + i], mesh.indices[t + (i + 1) % 3]);
        const double share = shares_[mesh.indices[t + i]];
        both = both || (share > kLeastBothSides && share < 1 - kLeastBothSides) ||
               std::abs(share - shares_[mesh.indices[t]]) > kLeastBothSides;
      }
      if (both) triangles_.push_back(t);
    }
  }

  // The mean distance of each ring's points from the line that the joint turns about; 0 for what is no ring.
  std::array<double, kRings> radii(const MotionPose& pose, const Positions& p) const {
    std::array<double, kRings> out{};
    for (std::size_t r = 0; r < kRings; ++r) {
      if (cuts_[r].size() < kLeastPoints) continue;
      for (const Cut& c : cuts_[r])
        out[r] += glm::length(glm::cross(p[c.a] * (1 - c.of_b) + p[c.b] * c.of_b - pose.centre, pose.axis));
      out[r] /= static_cast<double>(cuts_[r].size());
    }
    return out;
  }

  struct Volume {
    double enclosed = 0, most = 0;  // most: were each triangle's of one sign
  };
  Volume volume(const glm::dvec3& centre, const Positions& p) const {
    Volume out;
    for (const std::size_t t : triangles_) {
      const auto arm = [&](std::size_t i) { return p[mesh_.indices[t + i]] - centre; };
      const double six = glm::dot(arm(0), glm::cross(arm(1), arm(2)));
      out.enclosed += six / 6;
      out.most += std::abs(six) / 6;
    }
    return out;
  }

  // Where each triangle would face, had it turned as its vertices' weights have it.
  std::vector<glm::dvec3> facing(const MotionPose& pose) const {
    const double sine = tools::sine(pose.angle_rad / 2), cosine = tools::cosine(pose.angle_rad / 2);
    std::vector<glm::dvec3> out;
    for (std::size_t t = 0; t + 2 < mesh_.indices.size(); t += 3) {
      const std::uint32_t* const i = &mesh_.indices[t];
      const double share = (shares_[i[0]] + shares_[i[1]] + shares_[i[2]]) / 3;
      const glm::dvec3 v = pose.axis * (share * sine);
      out.push_back(glm::normalize(glm::dquat(1 - share + share * cosine, v.x, v.y, v.z)) *
                    doubled_area(mesh_.positions, i[0], i[1], i[2]));
    }
    return out;
  }
  std::size_t flipped(const std::vector<glm::dvec3>& facing, const Positions& p) const {
    std::size_t out = 0;
    for (std::size_t t = 0; t < facing.size(); ++t) {
      const std::uint32_t* const i = &mesh_.indices[3 * t];
      out += glm::dot(doubled_area(p, i[0], i[1], i[2]), facing[t]) < 0;
    }
    return out;
  }

 private:
  void cut(std::uint32_t a, std::uint32_t b) {
    for (std::size_t r = 0; r < kRings; ++r) {
      const double at = static_cast<double>(r + 1) / (kRings + 1);
      if ((shares_[a] < at) != (shares_[b] < at))
        cuts_[r].push_back({a, b, (at - shares_[a]) / (shares_[b] - shares_[a])});
    }
  }

  const SkinnedMesh& mesh_;
  std::vector<double> shares_;
  std::array<std::vector<Cut>, kRings> cuts_;
  std::vector<std::size_t> triangles_;  // their first index
};

std::optional<double> narrowest(const std::array<double, kRings>& radii, const std::array<double, kRings>& over) {
  std::optional<double> out;
  for (std::size_t r = 0; r < kRings; ++r)
    if (over[r] > 0 && (!out || radii[r] / over[r] < *out)) out = radii[r] / over[r];
  return out;
}

double rms(const Positions& a, const Positions& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += glm::dot(a[v] - b[v], a[v] - b[v]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

struct Judge {
  const SkinnedMesh& mesh;
  const Deformer& truth;
  Deformer plain;
  std::span<const Deformer> deformers;
  double rounding;

  MotionErrors errors_in(const MotionPose& motion, const Border& border) const {
    const Pose pose = motion.pose();
    Positions wanted, got;
    truth(pose, wanted);
    MotionErrors out;
    out.is_usable = is_finite(wanted);
    if (!out.is_usable) return out;
    plain(pose, got);
    out.ssd_rms = rms(got, wanted);
    const std::vector<glm::dvec3> facing = border.facing(motion);
    out.truth_flipped = border.flipped(facing, wanted);
    const auto at_rest = border.radii(motion, mesh.positions), wanted_radii = border.radii(motion, wanted);
    out.truth_ring_over_bind = narrowest(wanted_radii, at_rest);
    const Border::Volume whole = border.volume(motion.centre, wanted);
    for (const Deformer& deformer : deformers) {
      deformer(pose, got);
      const auto radii = border.radii(motion, got);
      MotionFigures& figures = out.of.emplace_back();
      figures.rms = rms(got, wanted);
      figures.is_worse = !(figures.rms <= out.ssd_rms * (1 + kRounding) + rounding);
      figures.ring_over_bind = narrowest(radii, at_rest);
      figures.ring_over_truth = narrowest(radii, wanted_radii);
      if (std::abs(whole.enclosed) > kLeastVolume * whole.most)
        figures.volume_over_truth = border.volume(motion.centre, got).enclosed / whole.enclosed;
      figures.flipped = border.flipped(facing, got);
    }
    return out;
  }
};

// Where poses of another joint begin, and the end.
std::vector<std::size_t> firsts_of_joints(const std::vector<MotionPose>& poses) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < poses.size(); ++i)
    if (i == 0 || poses[i].turns != poses[i - 1].turns) out.push_back(i);
  out.push_back(poses.size());
  return out;
}

}  // namespace

std::vector<MotionErrors> motion_errors(const SkinnedMesh& mesh, const std::vector<MotionPose>& poses,
                                        const Deformer& truth, std::span<const Deformer> deformers) {
  const Judge judge{mesh, truth, ssd(mesh), deformers, kRounding * diagonal(mesh)};
  const std::vector<std::size_t> first = firsts_of_joints(poses);
  std::vector<MotionErrors> out(poses.size());
  tools::for_each_in_parallel(first.size() - 1, [&](std::size_t joint) {
    const Border border(mesh, *poses[first[joint]].turns);
    for (std::size_t i = first[joint]; i < first[joint + 1]; ++i) out[i] = judge.errors_in(poses[i], border);
  });
  return out;
}

std::vector<std::size_t> worse_than_ssd(const SkinnedMesh& mesh, const std::vector<MotionPose>& poses,
                                        const Deformer& truth, const Deformer& deformer) {
  const std::vector<MotionErrors> errors = motion_errors(mesh, poses, truth, {&deformer, 1});
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (errors[i].is_usable && errors[i].truth_flipped == 0 && errors[i].of[0].is_worse) out.push_back(i);
  return out;
}

}  // namespace marrow::deform
