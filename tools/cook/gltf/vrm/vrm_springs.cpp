// Spring bones: chains of nodes with their settings, and colliders.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "asset/format.h"
#include "common/elementary.h"
#include "cook/gltf/vrm/vrm.h"

namespace marrow::cook::gltf {
namespace {

constexpr double kStep_s = 1.0 / 60, kGravity = 9.81, kTwoPi = 6.28318530717958648;
constexpr double kHighestOmega = 15 * kTwoPi, kMostDamping = 1.5, kMostDrag = 50, kMostGravity = 10;
constexpr double kLeastPull = 1e-3;     // of VRM's forces: the limit of none
constexpr double kLeastInertia = 1e-3;  // of 1 - drag_force: its logarithm is taken

// Of a number above 0, by Halley's steps on the exponential.
double logarithm(double x) {
  double y = 0;
  for (int i = 0; i < 200; ++i) {
    const double e = tools::exponential(y), step = 2 * (x - e) / (x + e);
    y += step;
    if (std::fabs(step) < 1e-15) break;
  }
  return y;
}

// y'' + damping y' + omega² y = 0, in 1/s.
struct Swing {
  double omega = 0, damping = 0;
  double slow_rate = 0;  // of the slower of two decays; 0: it swings
};

// VRM adds to a bone's end, in each step of 1/60 s, what is left of its last step and a pull, and shortens the sum to
// the bone's length. Small swings about where that rests are a linear recurrence of second order, whose roots are those
// of our spring's differential equation.
//
// Of y[n+1] = shrink ((1 + inertia) y[n] - inertia y[n-1]).
Swing swing_of(double shrink, double inertia) {
  const double sum = shrink * (1 + inertia), product = shrink * inertia, discriminant = sum * sum - 4 * product;
  Swing out;
  out.damping = -logarithm(product) / kStep_s;
  if (discriminant < 0) {
    const double angle = tools::angle_of(std::sqrt(-discriminant), sum), decay = out.damping / 2 * kStep_s;
    out.omega = std::sqrt(angle * angle + decay * decay) / kStep_s;
  } else {
    const double larger = (sum + std::sqrt(discriminant)) / 2;
    out.slow_rate = std::max(-logarithm(larger) / kStep_s, 0.0);
    out.omega = std::sqrt(out.slow_rate * std::max(out.damping - out.slow_rate, 0.0));
  }
  return out;
}

}  // namespace

SpringJoint spring_settings(const VrmSpring& vrm, double bone_m, const glm::dvec3& direction) {
  const double stiffness = std::clamp(vrm.stiffness, 0.0, 1e6), weight = std::clamp(vrm.gravity_power, 0.0, 1e6);
  const double drag = std::clamp(vrm.drag_force, 0.0, 1.0);
  const double down = -vrm.gravity_direction.y;
  // All that pulls where the bone rests; where stiffness and gravity cancel, they do not elsewhere.
  const glm::dvec3 both = stiffness * direction + weight * glm::dvec3(0, -down, 0);
  const double pull = std::max({glm::length(both), std::max(stiffness, weight) / 2, kLeastPull});
  Swing swing = swing_of(bone_m / (bone_m + pull * kStep_s), std::max(1 - drag, kLeastInertia));
  // Of the pull, the stiffness's share turns with the animation; so does as much damping as our range has.
  const double share = std::sqrt(std::min(stiffness / pull, 1.0));
  const double with_animation = 2 * kMostDamping * swing.omega * share;
  const double against_air = swing.omega * swing.omega * bone_m / pull * drag;
  const double air = std::min(std::max(against_air, swing.damping - with_animation), kMostDrag);
  if (swing.slow_rate > 0 && swing.damping - air > with_animation) {  // beyond our settings: the slow decay is kept
    const double r = swing.slow_rate, b = kMostDamping * share * r;
    swing.omega = b + std::sqrt(b * b + r * std::max(air - r, 0.0));
  }
  const double omega = std::min(swing.omega * share, kHighestOmega);
  const double weight_mps2 = swing.omega * swing.omega * bone_m / pull * weight * down;
  SpringJoint out;
  out.frequency_hz = std::min(static_cast<float>(omega / kTwoPi), 15.0f);
  out.damping_ratio =
      omega > 0 ? static_cast<float>(std::clamp((swing.damping - air) / (2 * omega), 0.0, kMostDamping)) : 0.0f;
  out.gravity = static_cast<float>(std::clamp(weight_mps2 / kGravity, -kMostGravity, kMostGravity));
  out.drag = static_cast<float>(air);
  out.radius_m = static_cast<float>(std::clamp(vrm.hit_radius, 0.0, 1e6));
  return out;
}

namespace {

constexpr double kShortestBone_m = 1e-6;
constexpr double kLastBone_m = 0.07;  // of version 0, whose chains end nowhere
constexpr double kFarthest_m = 1e6;
constexpr double kSideways = 0.1;  // of a unit: gravity that does not fall straight

// One spring of the source: a chain of version 1, or the chains of a group of version 0.
struct SpringSource {
  std::vector<std::size_t> groups;  // of colliders
  std::size_t chains = 0;           // that came of it, in a row
};

class SpringImporter {
 public:
  explicit SpringImporter(VrmImport& vrm) : vrm_(vrm), taken_(vrm.scene.nodes.size(), 0) {}

  void import_0(const Json& secondary, const std::string& where) {
    const Json& groups = member_or_empty(secondary, "colliderGroups");
    for (std::size_t g = 0; g < groups.size(); ++g) {
      groups_.emplace_back();
      for (const Json& collider : member_or_empty(groups[g], "colliders")) {
        const glm::dvec3 offset = vector_or(collider, "offset", {}) * glm::dvec3(1, 1, -1);  // its z goes the other way
        const Json& node = member_or_empty(groups[g], "node");
        add_collider(node, {kNone, offset, offset, number_or(collider, "radius", 0)},
                     under(where, "colliderGroups", g, "node"), true);
      }
    }
    const Json& springs = member_or_empty(secondary, "boneGroups");
    for (std::size_t s = 0; s < springs.size(); ++s) {
      const std::string here = under(where, "boneGroups", s);
      begin_spring(springs[s], here);
      VrmSpring setting = setting_of(springs[s], "stiffiness", "gravityDir", here);
      for (const Json& root : member_or_empty(springs[s], "bones"))
        if (const int node = node_of(root, under(here, "bones")); node != kNone) add_tree(node, setting, here);
    }
  }

  void import_1(const Json& spring_bone, const std::string& where) {
    const Json& colliders = member_or_empty(spring_bone, "colliders");
    for (std::size_t c = 0; c < colliders.size(); ++c) {
      const Json& shape = member_or_empty(colliders[c], "shape");
      const Json& capsule = member_or_empty(shape, "capsule");
      const Json& round = capsule.is_object() ? capsule : member_or_empty(shape, "sphere");
      const glm::dvec3 from = round.is_object() ? vector_or(round, "offset", {}) : glm::dvec3(0);
      const glm::dvec3 to = capsule.is_object() ? vector_or(capsule, "tail", {}) : from;
      const double radius = round.is_object() ? number_or(round, "radius", 0) : -1;  // dropped
      add_collider(colliders[c].at("node"), {kNone, from, to, radius}, under(where, "colliders", c), false);
    }
    const Json& groups = member_or_empty(spring_bone, "colliderGroups");
    for (std::size_t g = 0; g < groups.size(); ++g) {
      groups_.emplace_back();
      for (const Json& c : member_or_empty(groups[g], "colliders")) {
        if (!names_one(c, colliders_.size()))
          vrm_.report.invalid(under(where, "colliderGroups", g, "colliders"), "reference to nothing",
                              "there is no such collider; export again");
        groups_.back().push_back(c.get<std::size_t>());
      }
    }
    const Json& springs = member_or_empty(spring_bone, "springs");
    for (std::size_t s = 0; s < springs.size(); ++s) add_chain_1(springs[s], under(where, "springs", s));
  }

  // Colliders last, for those that most bones meet are kept.
  void finish() {
    std::vector<std::uint64_t> uses_of_group(groups_.size(), 0), uses(colliders_.size(), 0);
    for (const SpringSource& source : sources_)
      for (const std::size_t g : source.groups) uses_of_group[g] += source.chains;
    for (std::size_t g = 0; g < groups_.size(); ++g)
      for (const std::size_t c : groups_[g]) uses[c] += uses_of_group[g];
    const std::vector<std::uint64_t> bit = choose(uses);
    std::vector<std::uint64_t> bits_of_group(groups_.size(), 0);
    for (std::size_t g = 0; g < groups_.size(); ++g)
      for (const std::size_t c : groups_[g]) bits_of_group[g] |= bit[c];
    std::size_t chain = 0;
    for (const SpringSource& source : sources_) {
      std::uint64_t bits = 0;
      for (const std::size_t g : source.groups) bits |= bits_of_group[g];
      for (std::size_t i = 0; i < source.chains; ++i) vrm_.scene.springs[chain++].colliders = bits;
    }
  }

 private:
  // A bit a collider that is kept, in its order; 0 for others.
  std::vector<std::uint64_t> choose(const std::vector<std::uint64_t>& uses) {
    std::vector<std::size_t> order(colliders_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order, [&](std::size_t c) { return uses[c] == 0 || colliders_[c].node == kNone; });
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return uses[a] > uses[b]; });
    if (order.size() > kMaxSpringColliders) {
      vrm_.report.warn(where_, "too-many-colliders",
                       std::to_string(order.size()) + " colliders; the " + std::to_string(kMaxSpringColliders) +
                           " that most chains meet are kept");
      order.resize(kMaxSpringColliders);
    }
    std::ranges::sort(order);
    std::vector<std::uint64_t> bit(colliders_.size(), 0);
    for (std::size_t i = 0; i < order.size(); ++i) {
      bit[order[i]] = std::uint64_t{1} << i;
      vrm_.scene.colliders.push_back(colliders_[order[i]]);
    }
    return bit;
  }

  RawNode& node(int n) { return vrm_.scene.nodes[to_index(n)]; }
  glm::dvec3 place(int n) const { return glm::dvec3(vrm_.model_from_node[to_index(n)][3]); }

  // kNone for version 0's -1.
  int node_of(const Json& index, const std::string& where) {
    if (names_one(index, vrm_.scene.nodes.size())) return index.get<int>();
    if (index.is_number() && index.get<double>() != -1)
      vrm_.report.invalid(where, "reference to nothing", "there is no such node; export again");
    return kNone;
  }

  // in_group: it is the last group's, too.
  void add_collider(const Json& on, RawCollider collider, const std::string& where, bool in_group) {
    collider.node = node_of(on, where);
    const auto is_far = [](const glm::dvec3& v) {
      return !(std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}) <= kFarthest_m);
    };
    if (is_far(collider.from) || is_far(collider.to) || !(collider.radius_m >= 0 && collider.radius_m <= kFarthest_m)) {
      vrm_.report.warn(where, "collider-dropped",
                       "neither a sphere nor a capsule, a radius below 0, or a number beyond a million");
      collider.node = kNone;
    }
    if (collider.node != kNone && !node(collider.node).in_scene) collider.node = kNone;
    if (in_group) groups_.back().push_back(colliders_.size());
    colliders_.push_back(collider);
  }

  void begin_spring(const Json& spring, const std::string& where) {
    where_ = where.substr(0, where.rfind('/'));
    SpringSource& source = sources_.emplace_back();
    for (const Json& g : member_or_empty(spring, "colliderGroups")) {
      if (g.get<double>() == -1) continue;
      if (!names_one(g, groups_.size()))
        vrm_.report.invalid(under(where, "colliderGroups"), "reference to nothing",
                            "there is no such group of colliders; export again");
      source.groups.push_back(g.get<std::size_t>());
    }
    std::ranges::sort(source.groups);
    source.groups.erase(std::unique(source.groups.begin(), source.groups.end()), source.groups.end());
    if (member_or_empty(spring, "center").is_number() && spring.at("center").get<double>() >= 0)
      vrm_.report.warn(under(where, "center"), "spring-center-dropped",
                       "springs feel all motion in the world; SpringFrame::world_from_model can leave out some");
  }

  VrmSpring setting_of(const Json& json, const char* stiffness, const char* gravity, const std::string& where) {
    VrmSpring out;
    out.stiffness = number_or(json, stiffness, out.stiffness);
    out.gravity_power = number_or(json, "gravityPower", out.gravity_power);
    out.drag_force = number_or(json, "dragForce", out.drag_force);
    out.hit_radius = number_or(json, "hitRadius", out.hit_radius);
    const glm::dvec3 direction = vector_or(json, gravity, out.gravity_direction);
    const double length = glm::length(direction);
    if (length > kShortestBone_m && length <= kFarthest_m) out.gravity_direction = direction / length;
    const double x = out.gravity_direction.x, z = out.gravity_direction.z;
    if (out.gravity_power > 0 && x * x + z * z > kSideways * kSideways)
      vrm_.report.warn(where, "spring-gravity-sideways", "only what pulls down is kept; SpringFrame::wind blows aside");
    return out;
  }

  void take(int n) {
    taken_[to_index(n)] = 1;
    node(n).moved_by_game = true;
  }
  bool is_taken(int n) const { return taken_[to_index(n)] != 0; }

  void drop(const std::string& where, const std::string& rule, const std::string& why) {
    vrm_.report.warn(where, rule, why + "; this chain is left out");
  }

  // Fills in what depends on lengths. end: of the last bone, scene.
  void add_chain(RawSpring spring, const std::vector<VrmSpring>& settings, const glm::dvec3& end) {
    for (std::size_t i = 0; i < spring.nodes.size(); ++i) {
      const glm::dvec3 to = i + 1 < spring.nodes.size() ? place(spring.nodes[i + 1]) : end;
      const glm::dvec3 bone = to - place(spring.nodes[i]);
      const double length = glm::length(bone);
      const bool has_length = length > kShortestBone_m && length < kFarthest_m;
      spring.settings.push_back(has_length ? spring_settings(settings[i], length, bone / length) : SpringJoint{});
    }
    const glm::dmat4& last = vrm_.model_from_node[to_index(spring.nodes.back())];
    spring.tip = glm::dvec3(glm::inverse(last) * glm::dvec4(end, 1));
    const double reach = glm::length(spring.tip);
    if (!(reach > kShortestBone_m && reach < kFarthest_m)) spring.tip = glm::dvec3(0);
    if (spring.tip == glm::dvec3(0) && spring.nodes.size() == 1) return;
    vrm_.scene.springs.push_back(std::move(spring));
    ++sources_.back().chains;
  }

  // Within as many generations as a file may have between.
  bool is_below(int lower, int upper) {
    int at = node(lower).parent;
    for (std::uint32_t n = 0; n < format::kLongestSpringBone && at != kNone; ++n, at = node(at).parent)
      if (at == upper) return true;
    return false;
  }

  void add_chain_1(const Json& json, const std::string& where) {
    begin_spring(json, where);
    const Json& joints = member_or_empty(json, "joints");
    if (joints.size() < 2) return drop(where, "spring-without-bone", "a bone goes from one joint to the next");
    RawSpring spring;
    std::vector<VrmSpring> settings;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const auto n = joints[j].at("node").get<int>();
      const std::string here = under(where, "joints", j);
      if (!node(n).in_scene) return drop(here, "spring-outside-scene", "the node is not in the scene");
      if (j > 0 && !is_below(n, joints[j - 1].at("node").get<int>()))
        return drop(here, "spring-goes-up", "the node is not below the one before it, by 255 generations at most");
      if (j + 1 == joints.size()) break;  // only where the last bone ends
      if (is_taken(n)) return drop(here, "spring-shares-joint", "another chain has the node");
      spring.nodes.push_back(n);
      settings.push_back(setting_of(joints[j], "stiffness", "gravityDir", here));
    }
    for (const int n : spring.nodes) take(n);
    add_chain(std::move(spring), settings, place(joints.back().at("node").get<int>()));
  }

  // All that hangs below a root: a chain along first children, and one from each other child.
  void add_tree(int root, const VrmSpring& setting, const std::string& where) {
    if (!node(root).in_scene) return drop(where, "spring-outside-scene", "a bone is not in the scene");
    std::vector<int> starts = {root};
    while (!starts.empty()) {
      int n = starts.back();
      starts.pop_back();
      RawSpring spring;
      for (;; n = spring.nodes.empty() ? n : vrm_.document.model.nodes[to_index(n)].children.front()) {
        if (is_taken(n)) break;
        take(n);
        spring.nodes.push_back(n);
        const std::vector<int>& children = vrm_.document.model.nodes[to_index(n)].children;
        if (children.empty()) break;
        for (std::size_t i = children.size(); i-- > 1;) starts.push_back(children[i]);
      }
      if (spring.nodes.empty() || is_cut(spring, n)) {
        vrm_.report.warn(where, "spring-shares-joint", "a bone is in two groups; the first has it");
        if (spring.nodes.empty()) continue;
      }
      const int last = spring.nodes.back(), parent = node(last).parent;
      const glm::dvec3 way = parent == kNone ? glm::dvec3(0) : place(last) - place(parent);
      const double length = glm::length(way);
      const glm::dvec3 end = place(last) + (length > kShortestBone_m ? way * (kLastBone_m / length) : glm::dvec3(0));
      const std::vector<VrmSpring> settings(spring.nodes.size(), setting);
      add_chain(std::move(spring), settings, end);
    }
  }
  // Whether the walk ended at a bone that another chain has.
  static bool is_cut(const RawSpring& spring, int at) { return spring.nodes.back() != at; }

  VrmImport& vrm_;
  std::string where_;  // of the list of springs
  std::vector<char> taken_;
  std::vector<RawCollider> colliders_;
  std::vector<std::vector<std::size_t>> groups_;
  std::vector<SpringSource> sources_;
};

}  // namespace

void import_springs(VrmImport& vrm) {
  SpringImporter importer(vrm);
  const Json& spring_bone = member_or_empty(vrm.document.vrm, "VRMC_springBone");
  if (spring_bone.is_object()) {
    importer.import_1(spring_bone, pointer("extensions", "VRMC_springBone"));
  } else if (vrm.is_0) {
    const Json& secondary = member_or_empty(vrm.vrm, "secondaryAnimation");
    if (secondary.is_object()) importer.import_0(secondary, under(vrm.where, "secondaryAnimation"));
  }
  importer.finish();
}

}  // namespace marrow::cook::gltf
