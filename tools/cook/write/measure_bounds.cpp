#include "cook/write/measure_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <string_view>
#include <unordered_map>

#include "common/check_status.h"
#include "common/mutex.h"
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

// What one skeleton of a file moves.
struct Cast {
  std::vector<std::uint32_t> clips, meshes;
};

// Characters that play a file's clips, one a level of detail.
class PoseStage {
 public:
  // whole: null, or all animations of the file. Then its skeletons play together, which spaces of example shapes look
  // at; else each for itself, which takes no longer however many others there are.
  PoseStage(const File& file, const Animations* whole) : file_(file), examples_(file), whole_(whole) {
    std::size_t levels = 0;
    bool in_as = false;
    for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
      const Mesh mesh = file.mesh(m);
      levels = std::max(levels, mesh.lods.size);
      in_as = in_as || mesh.geometry.as_residual != nullptr;
    }
    for (std::uint32_t level = 0; level <= levels; ++level) {
      const CharacterOptions options{1, level, true, in_as};
      Level& made = levels_.emplace_back();
      made.memory = tools::AlignedBytes(character_bytes(file, options));
      tools::check(make_character(file, options, {made.memory.data(), made.memory.size()}, made.character));
    }
  }

  void choose(const Cast& cast, std::uint32_t clip) {
    cast_ = &cast;
    if (whole_ != nullptr) {
      animation_ = whole_->all[clip];
      for (Level& level : levels_) level.shown = level.character;
      return;
    }
    const Clip played = file_.clip(clip);
    channels_.clear();
    std::unordered_map<std::string_view, std::uint32_t> channel_of;
    for (std::uint32_t c = 0; c < played.channels.size; ++c) channel_of.emplace(file_.text(played.channels[c].name), c);
    for (const std::uint32_t m : cast.meshes)
      for (const MeshTarget& target : file_.mesh(m).targets) {
        const auto found = channel_of.find(file_.text(target.channel));
        channels_.push_back(found != channel_of.end() ? found->second : kNoChannel);
      }
    clip_ = clip;
    animation_ = {played.name, file_, played.duration_s, {&clip_, 1}, {channels_.data(), channels_.size()}};
    for (Level& level : levels_) show_alone(cast, played.skeleton, level);
  }

  // Calls visit(i, positions) for the cast's meshes that `wanted` has, as often as there are ways to skin them.
  template <class Visit>
  void show(float time_s, const std::vector<std::size_t>& wanted, const Visit& visit) {
    for (std::uint32_t level = 0; level < levels_.size(); ++level) {
      marrow::Character& c = levels_[level].shown;
      const AnimationLayer layer{&animation_, time_s};
      tools::check(pose_character(c, {&layer, 1}));
      examples_.write({&layer, 1}, c);
      tools::check(finish_character(c));
      for (const std::size_t i : wanted) {
        const std::uint32_t m = cast_->meshes[i];
        if (level <= file_.mesh(m).lods.size) skin(c.meshes[whole_ != nullptr ? m : i], [&] { visit(i, positions_); });
      }
    }
  }

 private:
  struct Level {
    tools::AlignedBytes memory;
    marrow::Character character, shown;  // all of it, and what is posed
    std::vector<CharacterMesh> meshes;   // of `shown`, if it is not all
  };

  // One skeleton and what follows it, as if there were no others.
  static void show_alone(const Cast& cast, std::uint32_t skeleton, Level& level) {
    level.meshes.clear();
    level.shown = level.character;
    level.shown.skeletons = {&level.character.skeletons[skeleton], 1};
    level.shown.target_count = 0;
    for (const std::uint32_t m : cast.meshes) {
      CharacterMesh& mesh = level.meshes.emplace_back(level.character.meshes[m]);
      mesh.mesh.skeleton = 0;
      mesh.first_target = level.shown.target_count;
      level.shown.target_count += static_cast<std::uint32_t>(mesh.weights.size);
    }
    level.shown.meshes = {level.meshes.data(), level.meshes.size()};
  }

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
  const Animations* whole_;
  const Cast* cast_ = nullptr;
  std::uint32_t clip_ = 0;
  std::vector<std::uint32_t> channels_;
  Animation animation_;
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
std::vector<double> measure_radii(PoseStage& stage, const Moments& moments, const std::vector<Motion>& motions) {
  struct Centre {
    double at[3];
  };
  std::vector<Centre> centres(motions.size());
  std::vector<std::size_t> first(motions.size(), 0);
  std::vector<double> radii(motions.size(), 0);
  for (std::size_t m = 0; m < motions.size(); ++m) {
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
    std::vector<std::size_t> shown;
    for (std::size_t m = 0; m < motions.size(); ++m)
      if (counts(m)) shown.push_back(m);
    if (shown.empty()) return;
    stage.show(moments.times_s[moment], shown, [&](std::size_t m, const std::vector<float>& p) {
      radii[m] = std::max(radii[m], farthest(p, centres[m].at));
    });
  };
  for (std::size_t i = 0; i < moments.times_s.size(); ++i) pose(i, [&](std::size_t m) { return first[m] == i; });
  for (std::size_t i = 0; i < moments.times_s.size(); ++i)
    pose(i, [&](std::size_t m) { return motions[m].poses[i].farthest_from(centres[m].at) > radii[m]; });
  for (std::size_t m = 0; m < motions.size(); ++m)
    radii[m] = std::min(radii[m] + motions[m].wider, motions[m].all.farthest_from(centres[m].at));
  return radii;
}

std::vector<Motion> measure_clip(PoseStage& stage, const Cast& cast, std::uint32_t clip, const Moments& moments) {
  stage.choose(cast, clip);
  std::vector<Motion> out(cast.meshes.size());
  std::vector<std::size_t> all(out.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (Motion& motion : out) motion.poses.resize(moments.times_s.size());
  for (std::size_t i = 0; i < moments.times_s.size(); ++i)
    stage.show(moments.times_s[i], all,
               [&](std::size_t m, const std::vector<float>& positions) { add_positions(positions, out[m].poses[i]); });
  for (Motion& motion : out) {
    motion.take_in(moments);
    motion.codes = encode_box(motion.all.least, motion.all.most);
  }
  const std::vector<double> radii = measure_radii(stage, moments, out);
  for (std::size_t m = 0; m < out.size(); ++m) out[m].codes.radius = encode_radius(out[m].codes, radii[m]);
  return out;
}

// Stages that threads take and give back.
class Stages {
 public:
  Stages(const File& file, const Animations* whole) : file_(file), whole_(whole) {}
  std::unique_ptr<PoseStage> take() {
    {
      const tools::Locked lock(mutex_);
      if (!free_.empty()) {
        std::unique_ptr<PoseStage> out = std::move(free_.back());
        free_.pop_back();
        return out;
      }
    }
    return std::make_unique<PoseStage>(file_, whole_);
  }
  void give_back(std::unique_ptr<PoseStage> stage) {
    const tools::Locked lock(mutex_);
    free_.push_back(std::move(stage));
  }

 private:
  const File& file_;
  const Animations* whole_;
  tools::Mutex mutex_;
  std::vector<std::unique_ptr<PoseStage>> free_;
};

std::vector<Cast> casts_of(const File& file) {
  std::vector<Cast> out(file.skeleton_count());
  for (std::uint32_t c = 0; c < file.clip_count(); ++c)
    if (const std::uint32_t s = file.clip(c).skeleton; s < out.size()) out[s].clips.push_back(c);
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) out[file.mesh(m).skeleton].meshes.push_back(m);
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
  tools::AlignedBytes memory;
  Animations animations;
  const bool together = file.example_space_count() > 0 && file.clip_count() > 0;
  if (together) {
    memory = tools::AlignedBytes(animations_bytes(file, file));
    tools::check(make_animations(file, file, {memory.data(), memory.size()}, animations));
  }
  Stages stages(file, together ? &animations : nullptr);
  const std::vector<Cast> casts = casts_of(file);
  std::vector<MeasuredBounds> out;
  for (std::uint32_t s = 0; s < casts.size(); ++s) {
    const Cast& cast = casts[s];
    if (cast.clips.empty() || cast.meshes.empty()) continue;
    std::size_t slots = 1;
    for (const std::uint32_t m : cast.meshes) slots += file.mesh(m).geometry.slot_count;
    const auto moments_for = [&](std::uint32_t clip) {
      return moments_of(file.clip(clip), std::max<std::size_t>(16, kMostVertices / slots));
    };
    const auto is_too_much = [&](std::uint32_t clip) {
      return moments_for(clip).times_s.size() > kMostExtents / cast.meshes.size();
    };
    if (std::ranges::any_of(cast.clips, is_too_much)) continue;
    MeasuredBounds made;
    made.header = {s, static_cast<std::uint32_t>(cast.clips.size()), static_cast<std::uint32_t>(cast.meshes.size())};
    made.codes.resize(cast.clips.size() * cast.meshes.size());
    tools::for_each_in_parallel(cast.clips.size(), [&](std::size_t i) {
      std::unique_ptr<PoseStage> stage = stages.take();
      const std::vector<Motion> motions = measure_clip(*stage, cast, cast.clips[i], moments_for(cast.clips[i]));
      for (std::size_t m = 0; m < motions.size(); ++m) made.codes[i * motions.size() + m] = motions[m].codes;
      stages.give_back(std::move(stage));
    });
    out.push_back(std::move(made));
  }
  return out;
}

}  // namespace marrow::cook
