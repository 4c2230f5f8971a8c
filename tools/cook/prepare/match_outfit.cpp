#include "cook/prepare/match_outfit.h"

#include <algorithm>
#include <set>

#include "common/distinct.h"
#include "common/failure.h"
#include "cook/prepare/check_bind_pose.h"
#include "cook/skeleton/build_skeletons.h"
#include "text/nearest.h"

namespace marrow::cook {
namespace {

// Where a joint of the merged skeleton is from.
struct Origin {
  int body_joint = kNone;
  int node = kNone;  // of the outfit's own
};

class Dressing {
 public:
  Dressing(const Character& body, RawScene scene, Notes& notes)
      : body_(body), notes_(notes), scene_(std::move(scene)), order_(parents_first(scene_)) {}

  void match_names();
  void check_places() const;
  void drop_clips_of_body();
  void find_own_joints();
  void drop_springs_of_body();
  void check_followed();
  void build_skeletons();
  void place_nodes();
  void place_skins();
  Matched take() { return {std::move(scene_), std::move(out_)}; }

 private:
  const RawNode& node(std::size_t n) const { return scene_.nodes[n]; }
  const BuiltSkeleton& skeleton_of(const NearestJoint& joint) const {
    return body_.skeletons[static_cast<std::size_t>(joint.skeleton)];
  }
  bool is_of_body(std::size_t n) const { return at_[n].joint != kNone; }
  // The body's skeleton that the node moves with; kNone: with none.
  int wearer_of(std::size_t n) const {
    const int of = is_of_body(n) ? static_cast<int>(n) : above_[n];
    return of == kNone ? kNone : at_[static_cast<std::size_t>(of)].skeleton;
  }
  [[noreturn]] void fail(std::size_t n, const std::string& rule, const std::string& advice) const {
    throw tools::Failure(tools::Exit::invalid, scene_.source, "/nodes/" + std::to_string(n), rule, advice);
  }
  std::vector<char> followed() const;
  std::vector<Origin> merged(int skeleton) const;
  BuiltSkeleton build_skeleton(const BuiltSkeleton& from, const std::vector<Origin>& joints,
                               std::vector<int>& number_of_body);

  const Character& body_;
  Notes& notes_;
  RawScene scene_;
  std::vector<std::size_t> order_;
  std::vector<NearestJoint> at_;          // a node: the joint of the body that it is
  std::vector<int> above_;                // a node: the nearest above that is a joint of the body
  std::vector<char> own_;                 // a node: whether it is a joint that only the outfit has
  std::vector<int> follows_;              // the body's skeletons that something here follows
  std::vector<std::vector<int>> number_;  // of each of those, a joint of the body: its number in the outfit
  BuiltScene out_;
};

// Names that a skeleton has twice.
std::set<std::pair<int, std::string>> names_twice(const Character& body) {
  std::set<std::pair<int, std::string>> seen, out;
  for (std::size_t s = 0; s < body.skeletons.size(); ++s)
    for (const std::string& name : body.skeletons[s].joint_names)
      if (!seen.insert({static_cast<int>(s), name}).second) out.insert({static_cast<int>(s), name});
  return out;
}

// Nodes that skins name go first, for a mesh is often called like the joint that it hangs on.
void Dressing::match_names() {
  expect_skeletons(body_);
  const std::map<std::string, NearestJoint> joints = joints_by_name(body_);
  const std::set<std::pair<int, std::string>> twice = names_twice(body_);
  std::vector<int> rank(scene_.nodes.size(), 1);
  for (const RawSkin* const skin : skins_in_use(scene_))
    for (const int joint : skin->joints) rank[static_cast<std::size_t>(joint)] = 2;
  for (const RawInstance& instance : scene_.instances)
    if (instance.skin != kNone && rank[static_cast<std::size_t>(instance.node)] == 1)
      rank[static_cast<std::size_t>(instance.node)] = 0;
  std::map<std::string, std::vector<std::size_t>> found;  // of the highest rank
  for (std::size_t n = 0; n < scene_.nodes.size(); ++n) {
    if (!node(n).in_scene || node(n).name.empty() || rank[n] == 0 || !joints.contains(node(n).name)) continue;
    std::vector<std::size_t>& nodes = found[node(n).name];
    if (!nodes.empty() && rank[nodes.front()] < rank[n]) nodes.clear();
    if (nodes.empty() || rank[nodes.front()] == rank[n]) nodes.push_back(n);
  }
  at_.resize(scene_.nodes.size());
  for (const auto& [name, nodes] : found) {
    const NearestJoint& joint = joints.at(name);
    const bool in_body = twice.contains({joint.skeleton, name});
    if (in_body || nodes.size() > 1)
      fail(nodes.back(), "a name that is not unique",
           '"' + name + "\" is found twice in " + (in_body ? body_.file : "this file") + "; rename one");
    at_[nodes.front()] = joint;
  }
  above_.assign(scene_.nodes.size(), kNone);
  for (const std::size_t n : order_) {
    const int parent = node(n).parent;
    if (parent == kNone) continue;
    const auto up = static_cast<std::size_t>(parent);
    above_[n] = is_of_body(up) ? parent : above_[up];
  }
}

// Joints of the body may be left out, but those that are there hang as in the body.
void Dressing::check_places() const {
  for (std::size_t n = 0; n < at_.size(); ++n) {
    if (!is_of_body(n) || above_[n] == kNone) continue;
    const auto up = static_cast<std::size_t>(above_[n]);
    const BuiltSkeleton& skeleton = skeleton_of(at_[n]);
    const auto parent_of = [&](int joint) {
      const std::uint16_t parent = skeleton.parents[static_cast<std::size_t>(joint)];
      return parent == kNoJoint ? kNone : static_cast<int>(parent);
    };
    int joint = parent_of(at_[n].joint);
    while (joint != kNone && joint != at_[up].joint) joint = parent_of(joint);
    if (joint == kNone || at_[n].skeleton != at_[up].skeleton)
      fail(n, "another parent",
           '"' + node(n).name + "\" hangs on \"" + node(up).name + "\", which is not above it in " + body_.file +
               "; export from the same skeleton");
  }
}

void Dressing::drop_clips_of_body() {
  std::size_t touched = 0;
  for (RawClip& clip : scene_.clips) {
    const std::size_t dropped = std::erase_if(clip.channels, [&](const RawChannel& channel) {
      const auto n = static_cast<std::size_t>(channel.node);
      return is_of_body(n) || above_[n] == kNone;
    });
    touched += dropped > 0 ? 1 : 0;
  }
  const std::size_t left_out =
      std::erase_if(scene_.clips, [](const RawClip& clip) { return clip.channels.empty() && clip.scalars.empty(); });
  if (touched == 0) return;
  notes_.warnings.push_back({"/animations", "clips-of-body",
                             "what clips do to joints of " + body_.file + " is left out (" + std::to_string(touched) +
                                 " clips, of which " + std::to_string(left_out) +
                                 " do nothing else), as its own clips or a clip pack move them"});
}

// What is wanted, and what lies between it and a joint of the body.
void Dressing::find_own_joints() {
  own_.assign(scene_.nodes.size(), 0);
  const std::vector<char> wanted = named_or_moved(scene_);
  for (std::size_t n = 0; n < at_.size(); ++n) {
    if (wanted[n] == 0 || is_of_body(n) || above_[n] == kNone) continue;
    for (std::size_t up = n; !is_of_body(up) && own_[up] == 0; up = static_cast<std::size_t>(node(up).parent))
      own_[up] = 1;
  }
}

// Springs of the body are the body's file's.
void Dressing::drop_springs_of_body() {
  const std::size_t dropped = std::erase_if(scene_.springs, [&](const RawSpring& spring) {
    return std::ranges::any_of(spring.nodes, [&](int n) { return own_[static_cast<std::size_t>(n)] == 0; });
  });
  if (dropped > 0)
    notes_.warnings.push_back({"/nodes", "springs-of-body",
                               std::to_string(dropped) + " springs are left out: they move more than joints that " +
                                   body_.file + " lacks and that hang on it"});
}

// Nodes that vertices follow, or that a mesh hangs on.
std::vector<char> Dressing::followed() const {
  std::vector<char> out(scene_.nodes.size(), 0);
  for (const RawInstance& instance : scene_.instances)
    for (const RawPrimitive& primitive : scene_.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
      if (instance.skin == kNone || primitive.influences.empty()) {
        out[static_cast<std::size_t>(instance.node)] = 1;
        continue;
      }
      const std::vector<int>& joints = scene_.skins[static_cast<std::size_t>(instance.skin)].joints;
      for (const std::vector<RawInfluence>& influences : primitive.influences)
        for (const RawInfluence& i : influences)
          if (i.weight > 0) out[static_cast<std::size_t>(joints[i.joint])] = 1;
    }
  return out;
}

void Dressing::check_followed() {
  const std::vector<char> needed = followed();
  std::vector<std::size_t> lost;
  for (std::size_t n = 0; n < at_.size(); ++n) {
    if (needed[n] != 0 && wearer_of(n) == kNone) lost.push_back(n);
    if ((needed[n] != 0 || own_[n] != 0) && wearer_of(n) != kNone) follows_.push_back(wearer_of(n));
  }
  tools::make_distinct(follows_);
  if (lost.empty() && !follows_.empty()) return;
  std::vector<std::string> names, joints;
  for (const std::size_t n : lost)
    names.push_back(node(n).name.empty() ? "nodes[" + std::to_string(n) + ']' : '"' + node(n).name + '"');
  if (lost.empty())
    throw tools::Failure(tools::Exit::invalid, scene_.source, "/nodes", "nothing follows " + body_.file,
                         "no vertex follows a joint of it; --clips-only makes a clip pack");
  for (const BuiltSkeleton& skeleton : body_.skeletons)
    joints.insert(joints.end(), skeleton.joint_names.begin(), skeleton.joint_names.end());
  const std::string question = tools::did_you_mean(node(lost.front()).name, joints);
  fail(lost.front(), "no such joint in " + body_.file,
       tools::listed(names) + ": no joint of it is there or above; " + question + (question.empty() ? "" : " ") +
           "rename, or hang it on a node that is called like a joint");
}

// The body's joints and the outfit's own, breadth-first.
std::vector<Origin> Dressing::merged(int skeleton) const {
  const BuiltSkeleton& from = body_.skeletons[static_cast<std::size_t>(skeleton)];
  std::vector<std::vector<Origin>> below_body(from.parents.size()), below_own(scene_.nodes.size());
  std::vector<Origin> out;
  for (std::size_t j = 0; j < from.parents.size(); ++j)
    (from.parents[j] == kNoJoint ? out : below_body[from.parents[j]]).push_back({static_cast<int>(j), kNone});
  for (std::size_t n = 0; n < own_.size(); ++n) {
    if (own_[n] == 0 || wearer_of(n) != skeleton) continue;
    const auto parent = static_cast<std::size_t>(node(n).parent);
    (is_of_body(parent) ? below_body[static_cast<std::size_t>(at_[parent].joint)] : below_own[parent])
        .push_back({kNone, static_cast<int>(n)});
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Origin of = out[i];
    const std::vector<Origin>& next = of.node == kNone ? below_body[static_cast<std::size_t>(of.body_joint)]
                                                       : below_own[static_cast<std::size_t>(of.node)];
    out.insert(out.end(), next.begin(), next.end());
  }
  return out;
}

void copy_rest(const BuiltSkeleton& from, std::size_t joint, BuiltSkeleton& to, std::size_t as) {
  const SoaTransform& four = from.rest[joint / 4];
  SoaTransform& out = to.rest[as / 4];
  for (std::size_t i = 0; i < 4; ++i) out.rotation[i][as % 4] = four.rotation[i][joint % 4];
  for (std::size_t i = 0; i < 3; ++i) {
    out.translation[i][as % 4] = four.translation[i][joint % 4];
    out.scale[i][as % 4] = four.scale[i][joint % 4];
  }
}

// number_of_body: gets, for each joint of the body, its place in `joints`.
BuiltSkeleton Dressing::build_skeleton(const BuiltSkeleton& from, const std::vector<Origin>& joints,
                                       std::vector<int>& number_of_body) {
  BuiltSkeleton to;
  to.name = from.name;
  to.model_from_root = from.model_from_root;
  to.rest.assign(soa_count(joints.size()), kRestOfNone);
  number_of_body.resize(from.parents.size());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    int parent = kNone;
    if (joints[j].node == kNone) {
      const auto body_joint = static_cast<std::size_t>(joints[j].body_joint);
      number_of_body[body_joint] = static_cast<int>(j);
      if (from.parents[body_joint] != kNoJoint) parent = number_of_body[from.parents[body_joint]];
      to.joint_names.push_back(from.joint_names[body_joint]);
      copy_rest(from, body_joint, to, j);
    } else {
      const auto n = static_cast<std::size_t>(joints[j].node), up = static_cast<std::size_t>(node(n).parent);
      out_.joint_of_node[n] = static_cast<int>(j);
      parent = is_of_body(up) ? number_of_body[static_cast<std::size_t>(at_[up].joint)] : out_.joint_of_node[up];
      to.joint_names.push_back(node(n).name);
      set_rest(node(n), j, to);
    }
    to.parents.push_back(parent == kNone ? kNoJoint : static_cast<std::uint16_t>(parent));
    to.node_of_joint.push_back(joints[j].node);
  }
  return to;
}

void Dressing::build_skeletons() {
  out_.is_outfit = true;
  out_.joint_of_node.assign(scene_.nodes.size(), kNone);
  for (const int skeleton : follows_) {
    const std::vector<Origin> joints = merged(skeleton);
    if (joints.size() > kMaxJoints)
      throw tools::Failure(tools::Exit::unsupported, scene_.source, "/nodes", "too-many-joints",
                           std::to_string(joints.size()) + " joints with those of " + body_.file + "; the most is " +
                               std::to_string(kMaxJoints));
    out_.skeletons.push_back(
        build_skeleton(body_.skeletons[static_cast<std::size_t>(skeleton)], joints, number_.emplace_back()));
  }
}

void Dressing::place_nodes() {
  out_.nearest.assign(scene_.nodes.size(), {});
  for (const std::size_t n : order_) {
    const auto follows = std::ranges::find(follows_, wearer_of(n));
    const auto skeleton = static_cast<std::size_t>(follows - follows_.begin());
    if (is_of_body(n) && follows != follows_.end())
      out_.joint_of_node[n] = number_[skeleton][static_cast<std::size_t>(at_[n].joint)];
    if (out_.joint_of_node[n] != kNone) {
      out_.nearest[n] = {static_cast<int>(skeleton), out_.joint_of_node[n], glm::dmat4(1.0)};
    } else {
      place_below_parent(scene_, n, out_.nearest);
    }
  }
}

// All joints of a skin are of one skeleton. Those that nothing follows and that hang on nothing stand for its first.
void Dressing::place_skins() {
  for (const RawSkin* const skin : skins_in_use(scene_)) {
    int skeleton = kNone;
    for (const int joint : skin->joints) {
      const int other = out_.nearest[static_cast<std::size_t>(joint)].skeleton;
      if (skeleton != kNone && other != kNone && other != skeleton)
        fail(static_cast<std::size_t>(joint), "a skin across two skeletons",
             "the joints of a skin are in two skeletons of " + body_.file + "; split the mesh");
      if (other != kNone) skeleton = other;
    }
    if (skeleton == kNone)
      fail(static_cast<std::size_t>(skin->joints.front()), "no such joint in " + body_.file,
           "no joint of the skin is one of the body's");
    for (const int joint : skin->joints) {
      const auto n = static_cast<std::size_t>(joint);
      if (out_.nearest[n].skeleton != kNone) continue;
      out_.nearest[n] = {skeleton, 0, glm::dmat4(1.0)};
      out_.joint_of_node[n] = 0;
    }
  }
}

}  // namespace

Matched match_outfit(const Character& body, RawScene scene, Notes& notes) {
  Dressing dressing(body, std::move(scene), notes);
  dressing.match_names();
  dressing.check_places();
  dressing.drop_clips_of_body();
  dressing.find_own_joints();
  dressing.drop_springs_of_body();
  dressing.check_followed();
  dressing.build_skeletons();
  dressing.place_nodes();
  dressing.place_skins();
  Matched out = dressing.take();
  check_bind_pose(out.scene, out.built, body.file, notes);
  return out;
}

}  // namespace marrow::cook
