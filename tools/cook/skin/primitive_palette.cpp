#include "cook/skin/primitive_palette.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "common/distinct.h"
#include "common/failure.h"
#include "cook/scene/matrices.h"

namespace marrow::cook {
namespace {

MultiWeightData multi_weight_data(const BoundDeformers& deformers, const std::vector<std::uint32_t>& vertex_of,
                                  const std::vector<BoundVertex>& vertices,
                                  const std::vector<std::uint16_t>& entry_of) {
  MultiWeightData out;
  out.root = entry_of[deformers.root];
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const std::vector<deform::MultiWeight>& learnt = deformers.multi_weights[vertex_of[v]];
    auto& to = out.weights.emplace_back();
    for (const BoundInfluence& i : vertices[v]) {
      auto& twelve = to.emplace_back();  // zeros for what quantisation drops
      const auto found = std::ranges::find(learnt, i.joint, &deform::MultiWeight::joint);
      for (std::size_t n = 0; n < 12 && found != learnt.end(); ++n)
        twelve[n] = found->rows[n / 4][static_cast<int>(n % 4)];
    }
  }
  return out;
}

PoseSpaceData pose_space_data(const deform::PoseSpace& space, const std::vector<std::uint32_t>& vertex_of,
                              const std::vector<BoundVertex>& vertices, const std::vector<std::uint16_t>& entry_of,
                              std::size_t palette_size) {
  PoseSpaceData out;
  out.sigma = space.sigma;
  out.parents.assign(palette_size, kNoJoint);
  std::vector<std::uint32_t> joint_of(palette_size, 0);
  for (const BoundVertex& vertex : vertices)
    for (const BoundInfluence& i : vertex) {
      if (!(i.weight > 0) || space.parents[i.joint] == kNone) continue;
      out.parents[entry_of[i.joint]] = entry_of[to_index(space.parents[i.joint])];
      joint_of[entry_of[i.joint]] = i.joint;
    }
  for (const deform::PoseSpaceExample& from : space.examples) {
    PoseSpaceData::Example& e = out.examples.emplace_back();
    for (std::size_t entry = 0; entry < palette_size; ++entry)
      e.rotations.push_back(out.parents[entry] == kNoJoint ? glm::dquat(1, 0, 0, 0) : from.rotations[joint_of[entry]]);
    for (const std::uint32_t v : vertex_of) e.deltas.push_back(from.deltas[v]);
  }
  return out;
}

using Set = std::vector<std::uint32_t>;  // ascending

Set united(const Set& a, const Set& b) {
  Set out;
  std::ranges::set_union(a, b, std::back_inserter(out));
  return out;
}

// Triangles that need the same, and what that is.
struct Groups {
  std::vector<Set> needs;
  std::vector<std::uint32_t> of_triangle;
};

Groups group_triangles(const std::vector<std::uint32_t>& indices, const std::vector<Set>& needs) {
  Groups out;
  std::map<Set, std::uint32_t> numbers;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    Set all = united(united(needs[indices[i]], needs[indices[i + 1]]), needs[indices[i + 2]]);
    const auto [at, is_new] = numbers.try_emplace(std::move(all), static_cast<std::uint32_t>(numbers.size()));
    if (is_new) out.needs.push_back(at->first);
    out.of_triangle.push_back(at->second);
  }
  return out;
}

// Grows one part after the other, a group at a time.
class Splitter {
 public:
  Splitter(const std::vector<Set>& needs, std::size_t most) : needs_(needs), most_(most), part_of_(needs.size(), 0) {
    for (std::uint32_t g = 0; g < needs.size(); ++g) {
      missing_.push_back(needs[g].size());
      far_.emplace(needs[g].size(), g);
      for (const std::uint32_t n : needs[g]) {
        if (n >= users_.size()) users_.resize(std::size_t{n} + 1);
        users_[n].push_back(g);
      }
    }
    has_.resize(users_.size(), 0);
    is_taken_.resize(needs.size(), 0);
  }

  // For each group its part.
  std::vector<std::uint32_t> run() {
    for (std::uint32_t part = 0; !far_.empty(); ++part) grow(part);
    return part_of_;
  }

 private:
  using Queue = std::set<std::pair<std::size_t, std::uint32_t>>;  // how much a group would add, and which

  void grow(std::uint32_t part) {
    std::size_t size = 0;
    if (has_next_) take(next_, part, size);
    has_next_ = false;
    while (!near_.empty() || !far_.empty()) {
      // What shares something with the part comes first.
      const Queue& from = !near_.empty() ? near_ : far_;
      if (from.empty() || size + from.begin()->first > most_) break;
      take(from.begin()->second, part, size);
    }
    // The next part begins where this one ends.
    if (!near_.empty()) next_ = near_.begin()->second;
    has_next_ = !near_.empty();
    for (const auto& [missing, g] : near_) {
      missing_[g] = needs_[g].size();
      far_.emplace(missing_[g], g);
    }
    near_.clear();
    for (const std::uint32_t n : in_part_) has_[n] = 0;
    in_part_.clear();
  }

  void take(std::uint32_t group, std::uint32_t part, std::size_t& size) {
    part_of_[group] = part;
    queue_of(group).erase({missing_[group], group});
    size += missing_[group];
    is_taken_[group] = 1;
    for (const std::uint32_t n : needs_[group]) {
      if (has_[n] != 0) continue;
      has_[n] = 1;
      in_part_.push_back(n);
      std::erase_if(users_[n], [&](std::uint32_t g) { return is_taken_[g] != 0; });
      for (const std::uint32_t g : users_[n]) {
        queue_of(g).erase({missing_[g], g});
        near_.emplace(--missing_[g], g);
      }
    }
  }

  // Where a group that is not yet taken stands.
  Queue& queue_of(std::uint32_t group) { return missing_[group] < needs_[group].size() ? near_ : far_; }

  const std::vector<Set>& needs_;
  std::size_t most_;
  std::vector<std::uint32_t> part_of_;
  std::vector<std::vector<std::uint32_t>> users_;  // of what is needed: the groups, not yet taken ones at least
  std::vector<std::size_t> missing_;               // a group: how much of its needs the part lacks
  std::vector<char> has_, is_taken_;               // the part, of what is needed; a group
  std::vector<std::uint32_t> in_part_;
  Queue near_, far_;  // groups that share something with the part, and the others
  std::uint32_t next_ = 0;
  bool has_next_ = false;
};

[[noreturn]] void refuse_split(const std::string& source, const RawPrimitive& primitive, const std::string& rule,
                               std::size_t enough) {
  throw tools::Failure(tools::Exit::unsupported, source, primitive.pointer, rule,
                       "give --palette " + std::to_string(enough) + " or more");
}

// Joints that a palette must have for a vertex beside those that it follows.
std::vector<std::uint32_t> joints_of_deformers(const BoundDeformers& deformers, const BoundVertex& vertex) {
  std::vector<std::uint32_t> out;
  if (!deformers.multi_weights.empty()) out.push_back(deformers.root);
  if (deformers.pose_space.examples.empty()) return out;
  for (const BoundInfluence& i : vertex)
    if (i.weight > 0 && deformers.pose_space.parents[i.joint] != kNone)
      out.push_back(static_cast<std::uint32_t>(deformers.pose_space.parents[i.joint]));
  return out;
}

}  // namespace

DeformerData deformer_data(const SkinBinding& binding, std::size_t primitive,
                           const std::vector<std::uint16_t>& entry_of, std::size_t palette_size) {
  const BoundDeformers& from = binding.deformers;
  const std::vector<BoundVertex>& vertices = binding.primitives[primitive];
  DeformerData out;
  if (!from.multi_weights.empty())
    out.multi_weight = multi_weight_data(from, from.vertex_of[primitive], vertices, entry_of);
  if (!from.pose_space.examples.empty())
    out.pose_space = pose_space_data(from.pose_space, from.vertex_of[primitive], vertices, entry_of, palette_size);
  return out;
}

std::vector<std::uint32_t> palette_needs(const SkinBinding& binding, std::size_t joint_count,
                                         const BoundVertex& vertex) {
  std::vector<std::uint32_t> out = joints_of_deformers(binding.deformers, vertex);
  for (const BoundInfluence& i : vertex) {
    out.push_back(i.joint);
    if (i.joint < joint_count) continue;
    const deform::Helper& helper = binding.helpers[i.joint - joint_count];
    out.insert(out.end(), {helper.first, helper.second});
  }
  tools::make_distinct(out);
  return out;
}

Palette make_palette(const RawSkin& skin, const SkinBinding& binding, const std::vector<BoundVertex>& vertices,
                     const std::vector<int>& joint_of_node, std::vector<std::uint16_t>& entry_of) {
  const std::size_t joints = skin.joints.size();
  entry_of.assign(joints + binding.helpers.size(), 0);
  for (const BoundVertex& vertex : vertices)
    for (const std::uint32_t needed : palette_needs(binding, joints, vertex)) entry_of[needed] = 1;
  if (std::ranges::count(entry_of, 1) > static_cast<std::ptrdiff_t>(kMaxJoints))
    throw tools::Failure(tools::Exit::unsupported, "", "", "too-many-joints",
                         "a primitive follows at most 32767 joints and helpers");
  Palette out;
  for (std::size_t j = 0; j < joints; ++j) {
    if (entry_of[j] == 0) continue;
    entry_of[j] = static_cast<std::uint16_t>(out.joints.size());
    out.joints.push_back(static_cast<std::uint16_t>(joint_of_node[to_index(skin.joints[j])]));
    out.inverse_bind.push_back(to_affine(skin.inverse_bind[j]));
  }
  for (std::size_t h = 0; h < binding.helpers.size(); ++h) {
    if (entry_of[joints + h] == 0) continue;
    const deform::Helper& helper = binding.helpers[h];
    entry_of[joints + h] = static_cast<std::uint16_t>(out.size());
    out.helpers.push_back({entry_of[helper.first], entry_of[helper.second], static_cast<float>(helper.share)});
    if (helper.by_dual_quaternions) continue;
    const glm::dvec4 centre = skin.inverse_bind[helper.second] * glm::dvec4(helper.centre, 1);
    for (int c = 0; c < 3; ++c) out.helper_centres.push_back(static_cast<float>(centre[c]));
  }
  return out;
}

Palette some_of(const Palette& whole, const std::vector<std::uint16_t>& entries) {
  const auto place_of = [&](std::uint16_t entry) {
    return static_cast<std::uint16_t>(std::ranges::lower_bound(entries, entry) - entries.begin());
  };
  Palette out;
  for (const std::uint16_t entry : entries) {
    if (entry < whole.joints.size()) {
      out.joints.push_back(whole.joints[entry]);
      out.inverse_bind.push_back(whole.inverse_bind[entry]);
    } else {
      const std::size_t h = entry - whole.joints.size();
      const Helper& helper = whole.helpers[h];
      out.helpers.push_back({place_of(helper.first), place_of(helper.second), helper.share});
      for (std::size_t i = 3 * h; i < 3 * h + 3 && i < whole.helper_centres.size(); ++i)
        out.helper_centres.push_back(whole.helper_centres[i]);
    }
  }
  return out;
}

std::vector<Binding> bind_vertices(const SkinBinding& binding, const std::vector<BoundVertex>& vertices,
                                   const std::vector<std::uint16_t>& entry_of) {
  std::vector<Binding> out;
  for (const BoundVertex& vertex : vertices) {
    Binding b;
    for (const BoundInfluence& i : vertex) {
      b.set.push_back(entry_of[i.joint]);
      b.weights.push_back(i.weight);
      if (binding.residual_step_m > 0) b.residual.push_back(i.residual);
    }
    out.push_back(std::move(b));
  }
  return out;
}

std::vector<std::uint32_t> split_triangles(const std::vector<std::uint32_t>& indices, const std::vector<Set>& needs,
                                           std::size_t most) {
  const Groups groups = group_triangles(indices, needs);
  const std::vector<std::uint32_t> part_of = Splitter(groups.needs, most).run();
  std::vector<std::uint32_t> out;
  for (const std::uint32_t g : groups.of_triangle) out.push_back(part_of[g]);
  return out;
}

std::vector<std::vector<std::uint32_t>> split_primitives(const std::string& source, const RawMesh& mesh,
                                                         std::size_t joint_count, std::size_t most,
                                                         const SkinBinding& binding) {
  std::vector<std::vector<std::uint32_t>> out(mesh.primitives.size());
  for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
    const RawPrimitive& primitive = mesh.primitives[p];
    std::vector<Set> needs;
    std::vector<char> used(joint_count + binding.helpers.size(), 0);
    for (const BoundVertex& vertex : binding.primitives[p]) {
      needs.push_back(palette_needs(binding, joint_count, vertex));
      for (const std::uint32_t n : needs.back()) used[n] = 1;
    }
    if (static_cast<std::size_t>(std::ranges::count(used, 1)) <= most) continue;
    std::size_t largest = 0;
    for (const Set& set : group_triangles(primitive.indices, needs).needs) largest = std::max(largest, set.size());
    if (largest > most)
      refuse_split(source, primitive, "a triangle follows " + std::to_string(largest) + " joints and helpers", largest);
    out[p] = split_triangles(primitive.indices, needs, most);
    const std::size_t parts = std::size_t{1} + std::ranges::max(out[p]);
    if (parts > kMostParts)
      refuse_split(source, primitive, "more than " + std::to_string(kMostParts) + " parts", most * 2);
  }
  return out;
}

std::vector<PrimitivePart> parts_of(const RawPrimitive& primitive, const std::vector<std::uint32_t>& part_of) {
  std::vector<PrimitivePart> out(1);
  if (part_of.empty()) {
    out[0].vertices.resize(primitive.positions.size());
    std::iota(out[0].vertices.begin(), out[0].vertices.end(), 0u);
    out[0].indices = primitive.indices;
    return out;
  }
  out.resize(std::size_t{1} + std::ranges::max(part_of));
  for (std::size_t t = 0; t < part_of.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c) out[part_of[t]].indices.push_back(primitive.indices[3 * t + c]);
  for (PrimitivePart& part : out) {
    part.vertices = part.indices;
    tools::make_distinct(part.vertices);
  }
  return out;
}
}  // namespace marrow::cook
