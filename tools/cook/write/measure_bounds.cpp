#include "cook/write/measure_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/check_status.h"
#include "common/parallel.h"
#include "common/shape_weights.h"
#include "marrow/character.h"
#include "marrow/skin.h"

namespace marrow::cook {
namespace {

constexpr double kMostGap_s = 1.0 / 60, kLeastGap_s = 1e-4;
constexpr std::size_t kMostPosesBetween = 240;     // poses between two keys
constexpr std::size_t kMostVertices = 60'000'000;  // skinned a clip and pass
constexpr std::size_t kMostExtents = 1'000'000;    // kept a clip, one a mesh and moment: 48 MB

struct Extent {
  double least[3] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                     std::numeric_limits<double>::infinity()};
  double most[3] = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};

  void add(const Extent& other) {
    for (int c = 0; c < 3; ++c) {
      least[c] = std::min(least[c], other.least[c]);
      most[c] = std::max(most[c], other.most[c]);
    }
  }
  double farthest_from(const double (&centre)[3]) const {
    double sum = 0;
    for (int c = 0; c < 3; ++c) {
      const double side = std::max(most[c] - centre[c], centre[c] - least[c]);
      sum += side * side;
    }
    return std::sqrt(sum);
  }
};

// Characters that play a file's clips, one a level of detail.
class Stage {
 public:
  explicit Stage(const File& file) : file_(file), examples_(file) {
    std::size_t levels = 0;
    bool in_as = false;
    for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
      const Mesh mesh = file.mesh(m);
      levels = std::max(levels, mesh.lods.size);
      in_as = in_as || mesh.geometry.as_residual != nullptr;
    }
    animation_memory_ = tools::AlignedBytes(animations_bytes(file, file));
    tools::check(make_animations(file, file, {animation_memory_.data(), animation_memory_.size()}, animations_));
    for (std::uint32_t level = 0; level <= levels; ++level) {
      const CharacterOptions options{1, level, true, in_as};
      Level& made = levels_.emplace_back();
      made.memory = tools::AlignedBytes(character_bytes(file, options));
      tools::check(make_character(file, options, {made.memory.data(), made.memory.size()}, made.character));
    }
  }

  // Calls visit(mesh, positions) for every mesh that `wanted` has, as often as there are ways to skin it.
  template <class Visit>
  void show(std::uint32_t clip, float time_s, const std::vector<std::uint32_t>& wanted, const Visit& visit) {
    for (std::uint32_t level = 0; level < levels_.size(); ++level) {
      marrow::Character& c = levels_[level].character;
      const AnimationLayer layer{&animations_.all[clip], time_s};
      tools::check(pose_character(c, {&layer, 1}));
      examples_.write({&layer, 1}, c);
      tools::check(finish_character(c));
      for (const std::uint32_t m : wanted)
        if (level <= file_.mesh(m).lods.size) skin(c.meshes[m], [&] { visit(m, positions_); });
    }
  }

 private:
  struct Level {
    tools::AlignedBytes memory;
    marrow::Character character;
  };

  template <class Visit>
  void skin(const CharacterMesh& m, const Visit& visit) {
    const Geometry& g = m.mesh.geometry;
    positions_.resize(3 * std::size_t{g.slot_count});
    const SkinOutput out{positions_};
    tools::check(skin_ssd(m.mesh, m.palette, out));
    visit();
    if (g.as_residual != nullptr) {
      tools::check(skin_as(m.mesh, m.coordinates, m.palette, out));
      visit();
    }
    if (g.mwe_residual != nullptr) {
      tools::check(skin_mwe(m.mesh, m.palette, out));
      visit();
    }
    if (!g.pose_space.examples.empty()) {
      distances_.resize(psd_distance_count(g));
      tools::check(psd_distances(g, m.palette, distances_));
      tools::check(skin_psd(m.mesh, distances_, m.palette, out));
      visit();
    }
  }

  const File& file_;
  tools::ShapeWeights examples_;
  tools::AlignedBytes animation_memory_;
  Animations animations_;
  std::vector<Level> levels_;
  std::vector<float> positions_, distances_;
};

void add_positions(const std::vector<float>& positions, Extent& extent) {
  float least[3] = {INFINITY, INFINITY, INFINITY}, most[3] = {-INFINITY, -INFINITY, -INFINITY};
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    for (std::size_t c = 0; c < 3; ++c) {
      least[c] = std::min(least[c], positions[i + c]);
      most[c] = std::max(most[c], positions[i + c]);
    }
  }
  for (int c = 0; c < 3; ++c) {
    extent.least[c] = std::min(extent.least[c], static_cast<double>(least[c]));
    extent.most[c] = std::max(extent.most[c], static_cast<double>(most[c]));
  }
}

double farthest(const std::vector<float>& positions, const double (&centre)[3]) {
  double squared = 0;
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double side = static_cast<double>(positions[i + c]) - centre[c];
      sum += side * side;
    }
    squared = std::max(squared, sum);
  }
  return std::sqrt(squared);
}

// What one mesh does in one clip.
struct Motion {
  std::vector<Extent> poses;  // one a moment
  Extent all;                 // of all of them, and between
  double wider = 0;           // the most that was added for what is between
  format::BoundsCodes codes{};

  // Between poses a face goes on a curve. With its height over the chord of the poses about it, s, a parabola is at
  // most s/4 beyond the highest of the three; twice that is added.
  void take_in(const Moments& moments) {
    for (const Extent& pose : poses) all.add(pose);
    for (std::size_t i = 1; i + 1 < poses.size(); ++i) {
      if (moments.is_key[i] != 0) continue;
      const Extent &before = poses[i - 1], &here = poses[i], &after = poses[i + 1];
      Extent reached = before;
      reached.add(here);
      reached.add(after);
      double squared = 0;
      for (int c = 0; c < 3; ++c) {
        const double below = std::max(0.0, (before.least[c] + after.least[c]) / 2 - here.least[c]) / 2;
        const double above = std::max(0.0, here.most[c] - (before.most[c] + after.most[c]) / 2) / 2;
        reached.least[c] -= below;
        reached.most[c] += above;
        squared += std::max(below, above) * std::max(below, above);
      }
      all.add(reached);
      wider = std::max(wider, std::sqrt(squared));
    }
  }
};

void centre_of(const format::BoundsCodes& codes, double (&out)[3]) {
  const double step = std::ldexp(1.0, codes.exponent);
  for (int c = 0; c < 3; ++c) out[c] = step * (double{1} * codes.box_min[c] + codes.box_max[c]) / 2;
}

// The radii of the meshes' spheres, each about the centre of its decoded box. Every moment is posed twice at most,
// however many meshes there are: first for those that may reach furthest in it, then for those that may go beyond what
// was found.
std::vector<double> measure_radii(Stage& stage, std::uint32_t clip, const std::vector<std::uint32_t>& meshes,
                                  const std::vector<std::size_t>& place, const Moments& moments,
                                  const std::vector<Motion>& motions) {
  struct Centre {
    double at[3];
  };
  std::vector<Centre> centres(meshes.size());
  std::vector<std::size_t> first(meshes.size(), 0);
  std::vector<double> radii(meshes.size(), 0);
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    centre_of(motions[m].codes, centres[m].at);
    double furthest = 0;
    for (std::size_t i = 0; i < motions[m].poses.size(); ++i) {
      const double most = motions[m].poses[i].farthest_from(centres[m].at);
      if (!(most > furthest)) continue;
      furthest = most;
      first[m] = i;
    }
  }
  const auto pose = [&](std::size_t moment, const auto& counts) {
    std::vector<std::uint32_t> shown;
    for (std::size_t m = 0; m < meshes.size(); ++m)
      if (counts(m)) shown.push_back(meshes[m]);
    if (shown.empty()) return;
    stage.show(clip, moments.times_s[moment], shown, [&](std::uint32_t mesh, const std::vector<float>& p) {
      const std::size_t m = place[mesh];
      radii[m] = std::max(radii[m], farthest(p, centres[m].at));
    });
  };
  for (std::size_t i = 0; i < moments.times_s.size(); ++i) pose(i, [&](std::size_t m) { return first[m] == i; });
  for (std::size_t i = 0; i < moments.times_s.size(); ++i)
    pose(i, [&](std::size_t m) { return motions[m].poses[i].farthest_from(centres[m].at) > radii[m]; });
  for (std::size_t m = 0; m < meshes.size(); ++m)
    radii[m] = std::min(radii[m] + motions[m].wider, motions[m].all.farthest_from(centres[m].at));
  return radii;
}

// The moments of a clip at which these meshes are posed.
Moments moments_for(const File& file, std::uint32_t clip, const std::vector<std::uint32_t>& meshes) {
  std::size_t slots = 1;
  for (const std::uint32_t m : meshes) slots += file.mesh(m).geometry.slot_count;
  return moments_of(file.clip(clip), std::max<std::size_t>(16, kMostVertices / slots));
}

std::vector<Motion> measure_clip(const File& file, std::uint32_t clip, const std::vector<std::uint32_t>& meshes) {
  Stage stage(file);
  const Moments moments = moments_for(file, clip, meshes);
  std::vector<std::size_t> place(file.mesh_count());
  for (std::size_t i = 0; i < meshes.size(); ++i) place[meshes[i]] = i;
  std::vector<Motion> out(meshes.size());
  for (Motion& motion : out) motion.poses.resize(moments.times_s.size());
  for (std::size_t i = 0; i < moments.times_s.size(); ++i)
    stage.show(clip, moments.times_s[i], meshes, [&](std::uint32_t m, const std::vector<float>& positions) {
      add_positions(positions, out[place[m]].poses[i]);
    });
  for (Motion& motion : out) {
    motion.take_in(moments);
    motion.codes = encode_box(motion.all.least, motion.all.most);
  }
  const std::vector<double> radii = measure_radii(stage, clip, meshes, place, moments, out);
  for (std::size_t m = 0; m < out.size(); ++m) out[m].codes.radius = encode_radius(out[m].codes, radii[m]);
  return out;
}

std::vector<float> keys_of(const Clip& clip) {
  std::vector<float> keys = {0.0f, clip.duration_s};
  const auto add = [&](const auto& track) {
    const float* const times_s = clip.times_s + track.first_time;
    keys.insert(keys.end(), times_s, times_s + track.key_count);
    if (track.interpolation != Interpolation::step) return;
    for (std::uint32_t k = 0; k < track.key_count; ++k) keys.push_back(std::nextafter(times_s[k], 0.0f));
  };
  for (const Track& track : clip.tracks) add(track);
  for (const Channel& channel : clip.channels) add(channel);
  for (std::uint32_t f = 0; f < clip.coded.frame_count; ++f) keys.push_back(clip.coded.time_of(f));
  for (float& key : keys) key = std::clamp(key, 0.0f, clip.duration_s);
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

}  // namespace

Moments moments_of(const Clip& clip, std::size_t most) {
  const std::vector<float> keys = keys_of(clip);
  const std::size_t stride = (2 * keys.size() + most - 1) / most;
  Moments out;
  for (std::size_t k = 0; k < keys.size(); k += stride) {
    out.times_s.push_back(keys[k]);
    out.is_key.push_back(1);
    const std::size_t next = std::min(k + stride, keys.size() - 1);
    if (next == k) break;
    const double gap = static_cast<double>(keys[next]) - static_cast<double>(keys[k]);
    const double least = gap > kLeastGap_s ? 2 : 1;
    const double parts = std::clamp(std::ceil(gap / kMostGap_s), least, static_cast<double>(kMostPosesBetween));
    for (int i = 1; i < static_cast<int>(parts); ++i) {
      out.times_s.push_back(static_cast<float>(static_cast<double>(keys[k]) + gap * i / parts));
      out.is_key.push_back(0);
    }
    if (next < k + stride || next + 1 == keys.size()) {
      out.times_s.push_back(keys[next]);
      out.is_key.push_back(1);
      break;
    }
  }
  return out;
}

format::BoundsCodes encode_box(const double (&least)[3], const double (&most)[3]) {
  format::BoundsCodes out{};
  for (int e = format::kLeastBoundsExponent; e <= format::kMostBoundsExponent; ++e) {
    const double step = std::ldexp(1.0, e);
    bool fits = true;
    for (int c = 0; c < 3; ++c) fits = fits && least[c] >= -128 * step && most[c] <= 127 * step && least[c] <= most[c];
    if (!fits && e < format::kMostBoundsExponent) continue;
    out.exponent = static_cast<std::int8_t>(e);
    for (int c = 0; c < 3; ++c) {
      out.box_min[c] = fits ? static_cast<std::int8_t>(std::floor(least[c] / step)) : std::int8_t{-128};
      out.box_max[c] = fits ? static_cast<std::int8_t>(std::ceil(most[c] / step)) : std::int8_t{127};
    }
    break;
  }
  return out;
}

std::uint8_t encode_radius(const format::BoundsCodes& box, double radius) {
  const double code = std::ceil(radius / std::ldexp(1.0, box.exponent));
  return code >= 0 && code <= 255 ? static_cast<std::uint8_t>(code) : std::uint8_t{255};
}

std::vector<MeasuredBounds> measure_bounds(const tools::AlignedBytes& bytes) {
  File file;
  tools::check(load({bytes.data(), bytes.size()}, file));
  std::vector<MeasuredBounds> out;
  for (std::uint32_t s = 0; s < file.skeleton_count(); ++s) {
    std::vector<std::uint32_t> clips, meshes;
    for (std::uint32_t c = 0; c < file.clip_count(); ++c)
      if (file.clip(c).skeleton == s) clips.push_back(c);
    for (std::uint32_t m = 0; m < file.mesh_count(); ++m)
      if (file.mesh(m).skeleton == s) meshes.push_back(m);
    if (clips.empty() || meshes.empty()) continue;
    const auto is_too_much = [&](std::uint32_t clip) {
      return moments_for(file, clip, meshes).times_s.size() > kMostExtents / meshes.size();
    };
    if (std::ranges::any_of(clips, is_too_much)) continue;
    MeasuredBounds made;
    made.header = {s, static_cast<std::uint32_t>(clips.size()), static_cast<std::uint32_t>(meshes.size())};
    made.codes.resize(clips.size() * meshes.size());
    tools::for_each_in_parallel(clips.size(), [&](std::size_t i) {
      const std::vector<Motion> motions = measure_clip(file, clips[i], meshes);
      for (std::size_t m = 0; m < motions.size(); ++m) made.codes[i * meshes.size() + m] = motions[m].codes;
    });
    out.push_back(std::move(made));
  }
  return out;
}

}  // namespace marrow::cook
