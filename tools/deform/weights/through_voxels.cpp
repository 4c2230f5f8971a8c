#include "deform/weights/through_voxels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "common/parallel.h"
#include "deform/surface.h"
#include "deform/weights/places.h"

namespace marrow::deform {
namespace {

constexpr double kFarthest = 1e12;  // voxels; beyond it, one distance is like another

// Nearer first; at one distance the joint that comes first.
bool before(const JointDistance& a, const JointDistance& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.joint < b.joint;
}

struct Step {
  int x, y, z;
  double length;
};

std::vector<Step> steps_around() {
  std::vector<Step> out;
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        if (x != 0 || y != 0 || z != 0) out.push_back({x, y, z, std::sqrt(static_cast<double>(x * x + y * y + z * z))});
  return out;
}

// The part of a segment in a box that spans 0 … size, as shares of its length; false if there is none.
bool clip(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& size, double& first, double& last) {
  first = 0;
  last = 1;
  for (int i = 0; i < 3; ++i) {
    const double along = to[i] - from[i];
    if (std::abs(along) < 1e-12) {
      if (!(from[i] >= 0 && from[i] <= size[i])) return false;
      continue;
    }
    const double a = -from[i] / along, b = (size[i] - from[i]) / along;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first <= last;
}

}  // namespace

Geodesic::Geodesic(const Voxels& voxels, std::span<const Bone> bones, std::size_t most)
    : voxels_(voxels), most_(std::max<std::size_t>(most, 1)) {
  number_solid();
  std::vector<Bone> sorted;
  for (const Bone& bone : bones) sorted.push_back({bone.joint, voxels.to_grid(bone.from), voxels.to_grid(bone.to)});
  std::stable_sort(sorted.begin(), sorted.end(), [](const Bone& a, const Bone& b) { return a.joint < b.joint; });
  std::vector<std::span<const Bone>> joints;
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto last = std::find_if(first, sorted.end(), [&](const Bone& bone) { return bone.joint != first->joint; });
    joints.push_back({first, last});
    first = last;
  }
  std::vector<std::vector<Start>> of_joint(joints.size());
  tools::for_each_in_parallel(joints.size(), [&](std::size_t j) { of_joint[j] = starts_of(joints[j]); });
  std::vector<Start> starts;
  for (const std::vector<Start>& own : of_joint) starts.insert(starts.end(), own.begin(), own.end());
  spread(starts);
}

void Geodesic::number_solid() {
  number_.assign(voxels_.cells(), kNotSolid);
  for (std::size_t cell = 0; cell < voxels_.cells(); ++cell) {
    if (!voxels_.solid(cell)) continue;
    number_[cell] = static_cast<std::uint32_t>(cell_.size());
    if (on_surface(cell)) surface_.push_back(cell_.size());
    cell_.push_back(cell);
  }
  nearest_.resize(cell_.size() * most_);
  found_.assign(cell_.size(), 0);
}

bool Geodesic::on_surface(std::size_t cell) const {
  for (const std::ptrdiff_t step : {voxels_.offset(1, 0, 0), voxels_.offset(0, 1, 0), voxels_.offset(0, 0, 1)})
    if (!voxels_.solid(cell + static_cast<std::size_t>(step)) || !voxels_.solid(cell - static_cast<std::size_t>(step)))
      return true;
  return false;
}

// joint: the bones of one, in grid coordinates.
std::vector<Geodesic::Start> Geodesic::starts_of(std::span<const Bone> joint) const {
  std::vector<Start> out;
  for (const Bone& bone : joint) start_within(bone, out);
  if (out.empty()) start_nearby(joint, out);
  return out;
}

void Geodesic::start_within(const Bone& bone, std::vector<Start>& out) const {
  double first = 0, last = 1;
  if (!clip(bone.from, bone.to, glm::dvec3(voxels_.size()), first, last)) return;
  const glm::dvec3 along = bone.to - bone.from;
  const double length = glm::length(along) * (last - first);
  const int steps = 1 + static_cast<int>(std::min(2 * length, 1e6));  // the grid's diagonal is far below
  for (int i = 0; i <= steps; ++i) {
    const glm::dvec3 p = bone.from + along * (first + (last - first) * i / steps);
    if (!voxels_.is_inner(p)) continue;
    const std::size_t cell = voxels_.cell_at(p);
    if (!voxels_.solid(cell)) continue;
    const double distance = distance_to(bone, glm::dvec3(voxels_.voxel_of(cell)) + 0.5);
    out.push_back({number_[cell], {bone.joint, distance}});
  }
}

// Not only the very nearest voxel: a bone in the middle of an open sleeve is as far from all of it.
void Geodesic::start_nearby(std::span<const Bone> joint, std::vector<Start>& out) const {
  std::vector<double> distances;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t v : surface_) {
    const glm::dvec3 centre = glm::dvec3(voxels_.voxel_of(cell_[v])) + 0.5;
    distances.push_back(distance_to(joint.front(), centre));
    for (const Bone& bone : joint) distances.back() = std::min(distances.back(), distance_to(bone, centre));
    least = std::min(least, distances.back());
  }
  for (std::size_t i = 0; i < surface_.size(); ++i)
    if (distances[i] <= 1.25 * least + 1)
      out.push_back({surface_[i], {joint.front().joint, std::min(distances[i], kFarthest)}});
}

// Whether it is among the voxel's nearest, and better than what was known of the joint.
bool Geodesic::offer(std::size_t voxel, const JointDistance& distance) {
  JointDistance* const first = &nearest_[voxel * most_];
  std::uint32_t& found = found_[voxel];
  JointDistance* at = std::find_if(first, first + found, [&](const auto& d) { return d.joint == distance.joint; });
  if (at == first + found) {
    if (found == most_ && !before(distance, first[found - 1])) return false;
    if (found < most_) ++found;
    at = first + found - 1;
  } else if (!(distance.distance < at->distance)) {
    return false;
  }
  for (; at != first && before(distance, at[-1]); --at) *at = at[-1];
  *at = distance;
  return true;
}

// Dijkstra's algorithm from all joints at once. A joint that is not among a voxel's nearest is not among those of any
// voxel behind it, so it need not go on. No step is shorter than a voxel: what lies within one voxel's distance is
// final when its turn comes, in any order.
void Geodesic::spread(const std::vector<Start>& starts) {
  std::map<std::uint64_t, std::vector<Start>> waiting;  // by whole voxels of distance
  const auto add = [&](std::size_t voxel, const JointDistance& distance) {
    if (offer(voxel, distance)) waiting[static_cast<std::uint64_t>(distance.distance)].push_back({voxel, distance});
  };
  for (const Start& start : starts) add(start.voxel, start.distance);
  const std::vector<Step> steps = steps_around();
  while (!waiting.empty()) {
    const std::vector<Start> now = std::move(waiting.begin()->second);
    waiting.erase(waiting.begin());
    for (const Start& start : now) {
      const JointDistance* const first = &nearest_[start.voxel * most_];
      const bool is_current = std::any_of(first, first + found_[start.voxel], [&](const JointDistance& d) {
        return d.joint == start.distance.joint && d.distance == start.distance.distance;
      });
      if (!is_current) continue;
      for (const Step& step : steps) {
        const std::ptrdiff_t cell =
            static_cast<std::ptrdiff_t>(cell_[start.voxel]) + voxels_.offset(step.x, step.y, step.z);
        const std::uint32_t next = number_[static_cast<std::size_t>(cell)];
        if (next != kNotSolid) add(next, {start.distance.joint, start.distance.distance + step.length});
      }
    }
  }
}

std::vector<JointDistance> Geodesic::at(const glm::dvec3& p) const {
  std::vector<JointDistance> out;
  const glm::dvec3 grid = voxels_.to_grid(p);
  if (!voxels_.is_inner(grid)) return out;
  const auto own = static_cast<std::ptrdiff_t>(voxels_.cell_at(grid));
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const auto cell = static_cast<std::size_t>(own + voxels_.offset(x, y, z));
        if (!voxels_.solid(cell)) continue;
        const std::size_t voxel = number_[cell];
        const double way = glm::length(grid - (glm::dvec3(voxels_.voxel_of(cell)) + 0.5));
        for (std::size_t i = voxel * most_; i < voxel * most_ + found_[voxel]; ++i) {
          const JointDistance d = {nearest_[i].joint, nearest_[i].distance + way};
          const auto known = std::find_if(out.begin(), out.end(), [&](const auto& o) { return o.joint == d.joint; });
          if (known == out.end()) {
            out.push_back(d);
          } else {
            known->distance = std::min(known->distance, d.distance);
          }
        }
      }
    }
  }
  std::sort(out.begin(), out.end(), before);
  if (out.size() > most_) out.resize(most_);
  for (JointDistance& d : out) d.distance *= voxels_.side();
  return out;
}

namespace {

constexpr std::size_t kRays = 16;     // from a vertex to a bone
constexpr double kLeastHeight = 0.5;  // voxels: nearer, voxels say nothing of what is between

// Whether most triangles face inwards, seen from the middle, so that a mesh that is open does not depend on its place.
bool is_inside_out(Positions positions, std::span<const std::uint32_t> indices) {
  const Box box = box_of(positions, indices);
  const glm::dvec3 middle = (box.low + box.high) * 0.5;
  for (glm::dvec3& p : positions) p -= middle;
  return volume(positions, indices) < 0;
}

std::vector<glm::dvec3> outward_normals(const Positions& positions, std::span<const std::uint32_t> indices) {
  const Places places = places_of(positions);
  const std::vector<std::uint32_t> triangles = indices_of(places, indices);
  const std::vector<glm::dvec3> normals = vertex_normals(places.positions, triangles);
  const double sign = is_inside_out(places.positions, triangles) ? -1 : 1;
  std::vector<glm::dvec3> out;
  for (const std::uint32_t place : places.of_vertex) out.push_back(normals[place] * sign);
  return out;
}

// ∫ sine / r² ds along a rod is (high - low) / height in terms of this: equal steps of it are equal shares of light.
double share_at(double s, double height) {
  return s / std::sqrt(s * s + height * height);
}

}  // namespace

Glow::Glow(const Voxels& voxels, const Positions& positions, std::span<const std::uint32_t> indices,
           std::span<const Bone> bones)
    : voxels_(voxels), normals_(outward_normals(positions, indices)) {
  for (const Bone& bone : bones) {
    const glm::dvec3 from = voxels.to_grid(bone.from), along = voxels.to_grid(bone.to) - from;
    const double length = glm::length(along);
    if (length > 0) rods_.push_back({bone.joint, from, along / length, length});
  }
  std::stable_sort(rods_.begin(), rods_.end(), [](const Rod& a, const Rod& b) { return a.joint < b.joint; });
}

Glow::View Glow::view_of(const Rod& rod, const glm::dvec3& p) const {
  const glm::dvec3 to_vertex = p - rod.from;
  const double foot = glm::dot(to_vertex, rod.axis);
  const double height = std::max(glm::length(to_vertex - rod.axis * foot), kLeastHeight);
  return {&rod, foot, height, share_at(-foot, height), share_at(rod.length - foot, height)};
}

double Glow::light_of(const View& view, const glm::dvec3& p, const glm::dvec3& normal, double needed) const {
  const Rod& rod = *view.rod;
  const bool has_normal = glm::dot(normal, normal) > 0;
  std::array<glm::dvec3, kRays> ends;
  std::array<double, kRays> lights;
  double hoped_for = 0;  // were nothing in the way
  for (std::size_t ray = 0; ray < kRays; ++ray) {
    const double share = view.low + (view.high - view.low) * ((static_cast<double>(ray) + 0.5) / kRays);
    const double s = view.height * share / std::sqrt(std::max(1 - share * share, 1e-30));
    ends[ray] = rod.from + rod.axis * std::clamp(view.foot + s, 0.0, rod.length);
    const glm::dvec3 way = ends[ray] - p;
    const double distance = glm::length(way);
    const double cosine = has_normal && distance > 0 ? -glm::dot(normal, way) / distance : 1;
    hoped_for += lights[ray] = std::max(cosine, 0.0) * view.most_light() / kRays;
  }
  double light = 0;
  for (std::size_t ray = 0; ray < kRays && light + hoped_for > needed; ++ray) {
    hoped_for -= lights[ray];
    if (lights[ray] > 0 && voxels_.sees(p, ends[ray])) light += lights[ray];
  }
  return light;
}

std::vector<Influence> Glow::at(const glm::dvec3& p, std::size_t vertex, std::size_t most) const {
  const glm::dvec3 grid = voxels_.to_grid(p);
  if (!voxels_.is_inner(grid)) return {};
  std::vector<View> views;
  struct Candidate {
    std::size_t first, end;  // of a joint's views
    double most_light;       // were nothing in the way
  };
  std::vector<Candidate> candidates;
  for (const Rod& rod : rods_) {
    views.push_back(view_of(rod, grid));
    if (candidates.empty() || views[candidates.back().first].rod->joint != rod.joint)
      candidates.push_back({views.size() - 1, views.size() - 1, 0});
    ++candidates.back().end;
    candidates.back().most_light += views.back().most_light();
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.most_light > b.most_light; });
  std::vector<Influence> lit;
  for (const Candidate& candidate : candidates) {
    // All that follow are darker than what is kept already.
    if (lit.size() == most && !(candidate.most_light > lit.back().weight)) break;
    const double needed = lit.size() == most ? lit.back().weight : 0;
    double light = 0, others = candidate.most_light;  // of the joint's bones; of those to come, at most
    for (std::size_t v = candidate.first; v < candidate.end; ++v) {
      others -= views[v].most_light();
      light += light_of(views[v], grid, normals_[vertex], needed - light - others);
    }
    if (!(light > needed)) continue;
    const auto darker = std::find_if(lit.begin(), lit.end(), [&](const Influence& i) { return i.weight < light; });
    lit.insert(darker, {views[candidate.first].rod->joint, light});
    if (lit.size() > most) lit.pop_back();
  }
  return lit;
}

}  // namespace marrow::deform
