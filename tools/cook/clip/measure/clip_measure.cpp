#include "cook/clip/measure/clip_measure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "common/check_status.h"
#include "cook/scene/influences.h"
#include "cook/scene/matrices.h"
#include "cook/scene/views.h"
#include "marrow/blend.h"
#include "marrow/palette.h"
#include "marrow/sample.h"
#include "marrow/skin.h"

namespace marrow::cook {
namespace {

// The points that are farthest along each axis and against it.
class Farthest {
 public:
  void add(const glm::dvec4& point) {
    for (std::size_t side = 0; side < 6; ++side) {
      const double along = (side < 3 ? 1 : -1) * point[static_cast<int>(side % 3)];
      if (along <= along_[side]) continue;
      along_[side] = along;
      points_[side] = point;
    }
  }
  std::vector<glm::dvec4> distinct() const {
    std::vector<glm::dvec4> out;
    for (std::size_t side = 0; side < 6; ++side)
      if (along_[side] > 0 && std::ranges::find(out, points_[side]) == out.end()) out.push_back(points_[side]);
    return out;
  }

 private:
  std::array<double, 6> along_ = {};
  std::array<glm::dvec4, 6> points_ = {};
};

// How much of a vertex's error one of its joints may make alone: all of it if it has half of the weight or more. The
// vertices themselves are measured in the end.
double alone(double weight) {
  const double size = std::fabs(weight);
  return size > 1e-6 ? std::min(1.0, 2 * size) / size : 1;
}

void add_points(const Mesh& mesh, std::vector<Farthest>& farthest) {
  for_each_vertex(mesh.geometry, [&](std::size_t, const std::vector<Influence>& influences) {
    for (const Influence& i : influences)
      for_each_joint(mesh, i.entry, [&](std::uint16_t joint, const Affine& bind, double share) {
        farthest[joint].add(transformed(bind, i.coordinate) * (share * alone(i.coordinate.w * share)));
      });
  });
}

double square(double x) {
  return x * x;
}

std::vector<double> strictness_of(const Mesh& mesh, const Promise& promise) {
  std::vector<double> out(mesh.geometry.slot_count);
  for_each_vertex(mesh.geometry, [&](std::size_t slot, const std::vector<Influence>& influences) {
    double sum = 0;
    for (const Influence& i : influences)
      for_each_joint(mesh, i.entry, [&](std::uint16_t joint, const Affine&, double share) {
        sum += i.weight * share * promise.error[joint];
      });
    out[slot] = sum != 0 ? 1 / square(sum) : 0;
  });
  return out;
}

double squared_distance(const float* a, const float* b) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) sum += square(static_cast<double>(a[4 * c]) - static_cast<double>(b[4 * c]));
  return sum;
}

// The floats of a geometry's skin.
std::size_t skin_size(const Geometry& g) {
  std::size_t floats = 0;
  for (const Run& run : g.runs) floats += (run.vertex_count + 3) / 4 * (12 + 4 * (std::size_t{run.influences} - 1));
  return floats;
}

// The skin with each vertex where the target that takes it farthest has it.
std::vector<float> farthest_skin(const Geometry& g) {
  tools::AlignedBytes memory(morphed_bytes(g));
  MorphedGeometry morphed;
  tools::check(make_morphed(g, {memory.data(), memory.size()}, morphed));
  std::vector<float> out(g.skin, g.skin + skin_size(g)), weights(g.targets.size, 0.0f);
  for (float& weight : weights) {
    weight = 1;
    tools::check(morph(weights, morphed));
    weight = 0;
    const float* block = g.skin;
    for (const Run& run : g.runs)
      for (std::uint32_t b = 0; b < (run.vertex_count + 3) / 4; ++b, block += 12 + 4 * (run.influences - 1))
        for (std::ptrdiff_t lane = 0; lane < 4; ++lane) {
          float* const best = out.data() + (block - g.skin) + lane;
          const float* const moved = morphed.geometry.skin + (block - g.skin) + lane;
          if (squared_distance(moved, block + lane) <= squared_distance(best, block + lane)) continue;
          for (int c = 0; c < 3; ++c) best[4 * c] = moved[4 * c];
        }
  }
  return out;
}

HungMesh hung_mesh(const Mesh& mesh, const Promise& promise) {
  HungMesh out{mesh, {}, {}, {}, strictness_of(mesh, promise)};
  if (mesh.geometry.as_residual == nullptr) return out;
  out.coordinates.resize(as_coordinate_count(mesh.geometry));
  tools::check(as_coordinates(mesh.geometry, out.coordinates));
  return out;
}

Affine to_affine(const World& w) {
  Affine out;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) out.rows[r][c] = static_cast<float>(w.linear[c][r]);
    out.rows[r][3] = static_cast<float>(w.origin[r]);
  }
  return out;
}

// How a mesh's vertices may be skinned, besides rigidly.
enum Deforming { kSsd, kAs, kMwe, kPsd, kDeformings };

bool has(const HungMesh& hung, int deformer) {
  const Geometry& g = hung.mesh.geometry;
  return deformer == kSsd || (deformer == kAs && !hung.coordinates.empty()) ||
         (deformer == kMwe && g.mwe_residual != nullptr) ||
         (deformer == kPsd && !g.pose_space.examples.empty() && hung.skin.empty() && hung.targets.empty());
}

struct VertexError {
  double error_m = 0;
  double share = 0;  // of what is promised for the vertex
};

// The largest distance between the same vertices in two poses, by the runtime's own skinning: linear blend skinning,
// and whatever other deformer a mesh has data for.
class VertexErrors {
 public:
  // channels: of the clip, by which morph targets are weighed. Both outlive this.
  VertexErrors(const Hung& hung, const BuiltClip& channels)
      : hung_(hung), values_(channels), weighed_(hung.meshes.size()) {
    std::size_t slots = 0;
    for (std::size_t m = 0; m < hung.meshes.size(); ++m) {
      const HungMesh& of = hung.meshes[m];
      slots = std::max<std::size_t>(slots, of.mesh.geometry.slot_count);
      if (of.targets.empty()) continue;
      Weighed& weighed = weighed_[m];
      weighed.memory = tools::AlignedBytes(morphed_bytes(of.mesh.geometry));
      tools::check(make_morphed(of.mesh.geometry, {weighed.memory.data(), weighed.memory.size()}, weighed.morphed));
      for (const MorphedMesh::Target& target : of.targets) weighed.channels.push_back(values_.find(target.channel));
      weighed.weights.resize(of.targets.size());
      weighed.coordinates.resize(of.coordinates.size());
    }
    here_.resize(3 * slots);
    there_.resize(3 * slots);
  }

  // At a moment of the clip.
  VertexError at(const std::vector<World>& source, const std::vector<World>& other, float time_s) {
    VertexError out;
    values_.go_to(time_s);
    for (std::size_t m = 0; m < hung_.meshes.size(); ++m) {
      const HungMesh& hung = hung_.meshes[m];
      const bool is_weighed = !hung.targets.empty();
      if (is_weighed && !weigh(hung, weighed_[m])) continue;
      Mesh mesh = hung.mesh;
      if (is_weighed) mesh.geometry = weighed_[m].morphed.geometry;
      const std::vector<float>& coordinates = is_weighed ? weighed_[m].coordinates : hung.coordinates;
      for (int deformer = kSsd; deformer < kDeformings; ++deformer) {
        if (!has(hung, deformer)) continue;
        skin(mesh, coordinates, source, deformer, here_);
        skin(mesh, coordinates, other, deformer, there_);
        double largest = 0, share = 0;
        const float *here = here_.data(), *there = there_.data();
        for (const double strictness : hung.strictness) {
          double sum = 0;
          for (int c = 0; c < 3; ++c) sum += square(static_cast<double>(*here++ - *there++));
          if (strictness == 0) continue;
          largest = std::max(largest, sum);
          share = std::max(share, sum * strictness);
        }
        out.error_m = std::max(out.error_m, std::sqrt(largest));
        out.share = std::max(out.share, std::sqrt(share));
      }
    }
    return out;
  }

 private:
  // A mesh with morph targets, as the clip has it at a moment.
  struct Weighed {
    tools::AlignedBytes memory;
    MorphedGeometry morphed;
    std::vector<int> channels;  // a target
    std::vector<float> weights, coordinates;
  };

  // False: it is as without targets.
  bool weigh(const HungMesh& hung, Weighed& to) {
    bool moves = false;
    for (std::size_t t = 0; t < to.weights.size(); ++t) {
      to.weights[t] = static_cast<float>(values_.value(to.channels[t], hung.targets[t].rest));
      moves = moves || to.weights[t] != 0;
    }
    if (!moves) return false;
    tools::check(morph(to.weights, to.morphed));
    if (!to.coordinates.empty()) tools::check(as_coordinates(to.morphed.geometry, to.coordinates));
    return true;
  }

  void skin(const Mesh& mesh, const std::vector<float>& coordinates, const std::vector<World>& pose, int deformer,
            std::vector<float>& out) {
    joints_.clear();
    for (const World& w : pose) joints_.push_back(to_affine(w));
    palette_.resize(mesh.palette_size());
    tools::check(build_palette(mesh, joints_, palette_));
    const SkinOutput to{{out.data(), std::size_t{3} * mesh.geometry.slot_count}};
    if (deformer == kSsd) return tools::check(skin_ssd(mesh, palette_, to));
    if (deformer == kAs) return tools::check(skin_as(mesh, coordinates, palette_, to));
    if (deformer == kMwe) return tools::check(skin_mwe(mesh, palette_, to));
    distances_.resize(psd_distance_count(mesh.geometry));
    tools::check(psd_distances(mesh.geometry, palette_, distances_));
    tools::check(skin_psd(mesh, distances_, palette_, to));
  }

  const Hung& hung_;
  ChannelValues values_;
  std::vector<Weighed> weighed_;  // a mesh
  std::vector<Affine> joints_, palette_;
  std::vector<float> here_, there_, distances_;
};

constexpr std::size_t kMostSkinned = 15'000'000;  // vertices that one measurement skins, if it need not more
constexpr double kNearest = 0.1;                  // of what is between two moments

// Looks at moments, and keeps the worst that it has seen.
class Look {
 public:
  Look(const BuiltClip& source, const BuiltClip& channels, const BuiltSkeleton& skeleton, const Rig& rig,
       const Hung& hung, const SourceCurves& curves, const BuiltClip& out, const Promise& promise)
      : source_clip_(source),
        skeleton_(skeleton),
        rig_(rig),
        curves_(curves),
        promise_(promise),
        clip_(view(out, view(skeleton))),
        local_(skeleton.rest.size()),
        source_(rig.size()),
        decoded_(rig.size()),
        vertices_(hung, channels) {}

  // How far the joints stray at a moment, as a share of the promise.
  double joints(float at_s) {
    pose(at_s);
    BuiltSkeleton posed;
    posed.rest = local_;
    posed.parents = skeleton_.parents;
    const std::vector<Transform> transforms = rest_transforms(posed);
    double most = 0;
    for (std::size_t j = 0; j < rig_.size(); ++j) {
      const bool root = rig_.parents[j] == kNone;
      const auto up = to_index(rig_.parents[j]);
      const auto time_s = static_cast<double>(at_s);
      source_[j] = rig_.place(j, root ? nullptr : &source_[up], curves_.at(j, time_s));
      decoded_[j] = rig_.place(j, root ? nullptr : &decoded_[up], transforms[j]);
      const double error = shell_error(source_[j], decoded_[j], promise_.shell);
      const double share = error / promise_.error[j];
      if (!(share <= most)) most = share;
      if (!(share <= worst_.share)) worst_.share = share;
      if (error <= worst_.error_m) continue;
      worst_.error_m = error;
      worst_.joint = j;
      worst_.time_s = time_s;
    }
    return most;
  }

  // The vertices, in units of the scene, where joints() has looked.
  double vertices(float at_s) {
    const VertexError here = vertices_.at(source_, decoded_, at_s);
    worst_.vertex_error_m = std::max(worst_.vertex_error_m, here.error_m);
    worst_.vertex_share = std::max(worst_.vertex_share, here.share);
    return here.error_m;
  }

  const ClipError& worst() const { return worst_; }

 private:
  // As a game plays it: an additive clip's change is added to the pose that it was taken from.
  void pose(float time_s) {
    const Skeleton skeleton = view(skeleton_);
    tools::check(sample(skeleton, clip_, time_s, local_));
    if (source_clip_.additive.empty()) return;
    const std::vector<SoaTransform>& reference =
        source_clip_.reference.empty() ? skeleton_.rest : source_clip_.reference;
    std::vector<AdditiveTransform> change(local_.size());
    tools::check(make_additive(skeleton, local_, reference, change));
    local_ = reference;
    tools::check(add(skeleton, {change}, local_));
  }

  const BuiltClip& source_clip_;
  const BuiltSkeleton& skeleton_;
  const Rig& rig_;
  const SourceCurves& curves_;
  const Promise& promise_;
  Clip clip_;
  std::vector<SoaTransform> local_;
  std::vector<World> source_, decoded_;
  VertexErrors vertices_;
  ClipError worst_;
};

// Goes from a moment to where `look` gives more, by ever smaller steps. Moments are counted in halves and quarters,
// too.
template <class Visit>
void climb(const std::vector<float>& moments, std::size_t from, double most, std::size_t stride, Visit look) {
  const auto last = static_cast<double>(moments.size() - 1);
  const auto time_of = [&](double moment) {
    const auto before = static_cast<std::size_t>(moment), after = std::min(before + 1, moments.size() - 1);
    const double a = static_cast<double>(moments[before]), b = static_cast<double>(moments[after]);
    return static_cast<float>(a + (b - a) * (moment - static_cast<double>(before)));
  };
  auto best = static_cast<double>(from);
  double step = static_cast<double>(stride);
  while (step > kNearest) {
    step /= 2;
    if (step > 1) step = std::floor(step);
    const double middle = best;
    for (const double moment : {middle - step, middle + step}) {
      if (moment < 0 || moment > last) continue;
      const double here = look(time_of(moment));
      if (here <= most) continue;
      most = here;
      best = moment;
    }
  }
}

bool jumps_somewhere(const BuiltClip& channels, const Channel& channel) {
  if (channel.interpolation == Interpolation::step) return true;
  const float* const times = channels.times_s.data() + channel.first_time;
  return std::adjacent_find(times, times + channel.key_count) != times + channel.key_count;
}

}  // namespace

ChannelValues::ChannelValues(const BuiltClip& clip)
    : names_(clip.channel_names), clip_(view(clip, Skeleton{})), values_(clip.channel_names.size()) {}

void ChannelValues::go_to(float time_s) {
  if (!values_.empty()) tools::check(sample_channels(clip_, time_s, values_));
}

int ChannelValues::find(const std::string& name) const {
  const auto found = std::ranges::find(names_, name);
  return found == names_.end() ? kNone : static_cast<int>(found - names_.begin());
}

Hung hang(const std::vector<Mesh>& meshes, const std::vector<MorphedMesh>& morphed, const Rig& rig, Promise& promise) {
  Hung out;
  std::vector<Farthest> farthest(rig.size());
  for (const Mesh& mesh : meshes) {
    out.meshes.push_back(hung_mesh(mesh, promise));
    if (mesh.geometry.targets.empty()) continue;
    std::vector<float> skin = farthest_skin(mesh.geometry);
    Mesh moved = mesh;
    moved.geometry.skin = skin.data();
    out.meshes.push_back(hung_mesh(moved, promise));
    out.meshes.back().skin = std::move(skin);
  }
  for (const MorphedMesh& one : morphed) {
    out.meshes.push_back(hung_mesh(one.mesh, promise));
    out.meshes.back().targets = one.targets;
  }
  out.is_weighed = !morphed.empty();
  for (const HungMesh& hung : out.meshes) {
    add_points(hung.mesh, farthest);
    for (int deformer = kSsd; deformer < kDeformings; ++deformer)
      if (has(hung, deformer)) out.slots += hung.mesh.geometry.slot_count;
  }
  for (std::size_t j = 0; j < rig.size(); ++j)
    for (const glm::dvec4& point : farthest[j].distinct()) promise.watch(j, point, rig);
  return out;
}

void hang(std::size_t joint, const glm::dvec3& place, const Rig& rig, Promise& promise) {
  promise.watch(joint, {place, 1}, rig);
}

ClipMeasure::ClipMeasure(const BuiltClip& clip, const BuiltClip& channels, const BuiltSkeleton& skeleton,
                         const Rig& rig, const Hung& hung)
    : clip_(clip), channels_(channels), skeleton_(skeleton), rig_(rig), hung_(hung), curves_(clip, skeleton) {}

std::vector<float> ClipMeasure::moments(const std::vector<float>& of_grid) const {
  std::vector<float> out = of_grid;
  const auto add = [&](float key_s, bool both_sides) {
    const auto end = of_grid.end(), after = std::lower_bound(of_grid.begin(), end, key_s);
    const float near = key_s * 0x1p-22f;
    const bool is_there =
        (after != end && *after - key_s <= near) || (after != of_grid.begin() && key_s - after[-1] <= near);
    if (both_sides) out.push_back(just_before(key_s));
    if (both_sides || !is_there) out.push_back(key_s);
  };
  for (const Track& track : clip_.tracks) {
    const bool both_sides = jumps(clip_, track);
    for (std::uint32_t k = 0; k < track.key_count; ++k) add(clip_.times_s[track.first_time + k], both_sides);
  }
  for (const Channel& channel : channels_.channels) {
    const bool both_sides = jumps_somewhere(channels_, channel);
    for (std::uint32_t k = 0; k < channel.key_count && hung_.is_weighed; ++k)
      add(channels_.times_s[channel.first_time + k], both_sides);
  }
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

ClipError ClipMeasure::measure(const BuiltClip& out, const std::vector<float>& moments, const Promise& promise) const {
  const std::size_t stride = 1 + hung_.slots * moments.size() / kMostSkinned;
  Look look(clip_, channels_, skeleton_, rig_, hung_, curves_, out, promise);
  struct Worst {
    double error = 0;
    std::size_t moment = 0;
  } joints, vertices;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const double share = look.joints(moments[i]);
    if (share > joints.error) joints = {share, i};
    if (i % stride != 0 || !(look.worst().share <= 1)) continue;
    const double error = look.vertices(moments[i]);
    if (error > vertices.error) vertices = {error, i};
  }
  climb(moments, joints.moment, joints.error, 1, [&](float time_s) { return look.joints(time_s); });
  if (!(look.worst().share <= 1)) return look.worst();
  climb(moments, vertices.moment, vertices.error, stride, [&](float time_s) {
    look.joints(time_s);
    return look.vertices(time_s);
  });
  return look.worst();
}
}  // namespace marrow::cook
