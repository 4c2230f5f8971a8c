// Poses of what an animator is in: a walk down the graph, and back up with the poses.
#include <cstring>

#include "character/sample_animation.h"
#include "core/check.h"
#include "core/zone.h"
#include "graph/graph_step.h"
#include "pose/sample_state.h"

namespace marrow {
namespace {

constexpr std::uint32_t kLocal = kMaxGraphPoses;  // the character's own pose, in place of one that is sampled

// A pose that a node takes: of a node, or of a clip in step at its time.
struct Part {
  std::uint32_t node = 0;
  float weight = 0;
  float time_s = 0;
  bool has_time = false;
  std::uint32_t pose = 0;  // where it is, once it is made
};

// A node whose parts are being made.
struct Visit {
  std::uint32_t node = 0;
  float share = 1;             // of the weights of morph targets
  bool is_expression = false;  // it adds to them
  bool to_local = false;
  std::uint32_t count = 0, next = 0;
  Part parts[kMaxFading];
};

class GraphPoser {
 public:
  GraphPoser(Character& c, const Animator& a, Span<const GivenPose> given)
      : c_(c), step_{*a.binding, a.binding->graph, a.state, *a.scratch, 0}, g_(a.binding->graph), given_(given) {}

  // shift_s: how long before now; weights are those of now. Weights of morph targets only with is_first.
  Status pose(std::uint32_t skeleton, std::size_t first_joint, double shift_s, bool is_first) {
    skeleton_ = skeleton;
    first_joint_ = first_joint;
    shift_s_ = shift_s;
    morphs_ = is_first && c_.target_count > 0;
    fresh_ = 0;
    free_ = 0;
    depth_ = 0;
    if (morphs_) clear_weights();
    std::uint32_t made = 0;
    Status status = open({.node = 0, .weight = 1}, 1, false, true, made);
    while (depth_ > 0 && status == Status::ok) status = go_on();
    if (status == Status::ok && morphs_) status = fill_weights();
    return status;
  }

 private:
  CharacterSkeleton& own() { return c_.skeletons[skeleton_]; }
  const Skeleton& skeleton() { return own().pose.skeleton; }
  Span<SoaTransform> at(std::uint32_t pose) {
    const std::size_t size = skeleton().soa_size();
    return pose == kLocal ? own().pose.local : Span<SoaTransform>(own().sampled.data + pose * size, size);
  }
  // It is written by others than sample_cached().
  Span<SoaTransform> written(std::uint32_t pose) {
    if (pose != kLocal) state_of(own().caches[pose]).out = 0;
    return at(pose);
  }

  // One that nothing was sampled into yet in this walk, if there is one; so caches keep what they have.
  std::uint32_t take_pose() {
    const std::uint32_t count = c_.options.layers < kMaxGraphPoses ? c_.options.layers : kMaxGraphPoses;
    if (fresh_ < count) return fresh_++;
    std::uint32_t pose = 0;
    while (pose + 1 < count && (free_ >> pose & 1) == 0) ++pose;
    free_ &= ~(std::uint64_t{1} << pose);
    return pose;
  }
  void release(std::uint32_t pose) {
    if (pose != kLocal) free_ |= std::uint64_t{1} << pose;
  }

  void clear_weights() {
    total_ = 0;
    for (CharacterMesh& m : c_.meshes)
      for (float& weight : m.weights) weight = 0;
  }
  // Defaults have the share that no clip has.
  Status fill_weights() {
    for (CharacterMesh& m : c_.meshes)
      for (std::size_t t = 0; t < m.weights.size; ++t) m.weights[t] += (1.0f - total_) * m.mesh.targets[t].weight;
    return Status::ok;
  }
  Status weigh_targets(const Animation& animation, float time_s, float share, bool is_expression) {
    if (!is_expression) total_ += share;
    for (CharacterMesh& m : c_.meshes) {
      const Status status = is_expression ? for_each_weight(animation, time_s, m, true,
                                                            [&](std::size_t t, float weight, float rest) {
                                                              m.weights[t] += share * (weight - rest);
                                                            })
                                          : add_weights(animation, time_s, share, m);
      if (status != Status::ok) return status;
    }
    return Status::ok;
  }

  float time_of(std::uint32_t node) {
    const GraphClip& clip = g_.clips[g_.nodes[node].record];
    const ClipMotion& motion = step_.b.clips[g_.nodes[node].record].motion;
    const auto& state = step_.own<ClipState>(node);
    Playback at{.time_s = state.time_s,
                .speed = clip.speed,
                .mode = static_cast<PlayMode>(clip.mode),
                .returning = state.returning != 0};
    if (shift_s_ > 0) static_cast<void>(advance(at, motion.duration_s, static_cast<float>(-shift_s_)));
    return clip_time(at);
  }

  // A leaf's pose is made at once; of others the visit begins.
  Status open(const Part& part, float share, bool is_expression, bool to_local, std::uint32_t& made) {
    const GraphNode& node = g_.nodes[part.node];
    if (node.kind == GraphNodeKind::clip) {
      const Animation& animation = step_.b.clips[node.record];
      const float time_s = part.has_time ? part.time_s : time_of(part.node);
      const std::uint32_t pose = take_pose();
      Status status =
          sample_animation(skeleton(), animation, time_s, skeleton_, c_.change, at(pose), own().caches[pose]);
      if (status == Status::ok && morphs_ && share != 0)
        status = weigh_targets(animation, time_s, share, is_expression);
      made = to_local ? local_from(pose) : pose;
      return status;
    }
    if (node.kind == GraphNodeKind::given) return open_given(node.record, to_local, made);
    Visit& visit = visits_[depth_++];
    visit = {};
    visit.node = part.node;
    visit.share = share;
    visit.is_expression = is_expression;
    visit.to_local = to_local;
    return find_parts(visit);
  }
  std::uint32_t local_from(std::uint32_t pose) {
    std::memcpy(own().pose.local.data, at(pose).data, at(pose).size * sizeof(SoaTransform));
    release(pose);
    return kLocal;
  }

  Status open_given(std::uint32_t which, bool to_local, std::uint32_t& made) {
    const std::size_t number = std::size_t{which} * c_.skeletons.size + skeleton_;
    made = to_local ? kLocal : take_pose();
    const Span<SoaTransform> out = written(made);
    const bool is_given = number < given_.size && !given_[number].local.empty();
    std::memcpy(out.data, is_given ? given_[number].local.data : skeleton().rest, out.size * sizeof(SoaTransform));
    return Status::ok;
  }

  Status find_parts(Visit& visit) {
    const GraphNode& node = g_.nodes[visit.node];
    if (node.kind == GraphNodeKind::space) return find_points(visit, g_.spaces[node.record]);
    if (node.kind == GraphNodeKind::machine) {
      find_states(visit, g_.machines[node.record]);
    } else {
      const GraphLayer& layer = g_.layers[node.record];
      const float weight = weight_of(step_, layer, step_.own<LayerState>(visit.node)) * presence_of(layer.pose);
      visit.parts[visit.count++] = {.node = layer.base, .weight = 1};
      if (weight > 0) visit.parts[visit.count++] = {.node = layer.pose, .weight = weight};
    }
    return Status::ok;
  }

  Status find_points(Visit& visit, const GraphSpace& space) {
    float at[2] = {}, rate = 1;
    for (int i = 0; i < 2; ++i)
      if (space.by[i] != kNoIndex) at[i] = step_.parameter(space.by[i]).value;
    float* const weights = step_.s.weights.data + step_.b.first_link[visit.node];
    if (weigh_points(step_.b, space, at, weights, rate) != Status::ok) return Status::bad_data;
    Phase phase{step_.own<SpaceState>(visit.node).share, step_.own<SpaceState>(visit.node).segment, 0};
    const bool in_step = (space.flags & kSpaceInStep) != 0;
    if (in_step && shift_s_ > 0 &&
        move_back(step_, space, weights, static_cast<float>(shift_s_) * rate, phase) != Status::ok)
      return Status::bad_data;
    for (std::uint32_t i = 0; i < space.point_count && visit.count < kMaxFading; ++i) {
      if (!(weights[i] > 0)) continue;
      Part& part = visit.parts[visit.count++];
      part = {.node = g_.points[space.first_point + i].node, .weight = weights[i], .has_time = in_step};
      if (!in_step) continue;
      Playback now;
      if (follow_phase(step_.b.clips[g_.nodes[part.node].record].motion, phase, phase, now, now) != Status::ok)
        return Status::bad_data;
      part.time_s = clip_time(now);
    }
    return Status::ok;
  }

  void find_states(Visit& visit, const GraphMachine& machine) {
    const auto& state = step_.own<MachineState>(visit.node);
    float weights[kMaxFading];
    weigh_chain(state, weights);
    for (std::uint32_t i = 0; i < state.count; ++i) {
      const std::uint32_t node = g_.states[machine.first_state + state.chain[i]].node;
      if (node != kNoIndex && weights[i] > 0) visit.parts[visit.count++] = {.node = node, .weight = weights[i]};
    }
  }
  // How much a machine shows.
  float presence_of(std::uint32_t node) {
    if (g_.nodes[node].kind != GraphNodeKind::machine) return 1;
    const auto& state = step_.own<MachineState>(node);
    float weights[kMaxFading], sum = 0;
    weigh_chain(state, weights);
    for (std::uint32_t i = 0; i < state.count; ++i)
      if (g_.states[g_.machines[g_.nodes[node].record].first_state + state.chain[i]].node != kNoIndex)
        sum += weights[i];
    return sum < 1 ? sum : 1.0f;
  }

  Status go_on() {
    Visit& visit = visits_[depth_ - 1];
    if (visit.next < visit.count) return open_next(visit);
    std::uint32_t made = kLocal;
    const Status status = close(visit, made);
    --depth_;
    if (depth_ > 0) {
      Visit& above = visits_[depth_ - 1];
      above.parts[above.next - 1].pose = made;
    }
    return status;
  }

  Status open_next(Visit& visit) {
    const std::uint32_t which = visit.next++;
    Part& part = visit.parts[which];
    float share = visit.share;
    bool is_expression = visit.is_expression, to_local = visit.to_local && visit.count == 1;
    if (g_.nodes[visit.node].kind == GraphNodeKind::layer) {
      const GraphLayer& layer = g_.layers[g_.nodes[visit.node].record];
      const bool adds = (layer.flags & kLayerIsAdditive) != 0, is_masked = layer.mask != kNoIndex;
      const float over = visit.count == 2 ? visit.parts[1].weight : 0;
      if (which == 0) {
        to_local = visit.to_local;
        if (!adds && !is_masked) share *= 1.0f - over;
      } else {
        share = adds ? share * over : is_masked ? 0 : share * over;
        is_expression = is_expression || adds;
      }
    } else {
      float sum = 0;
      for (std::uint32_t i = 0; i < visit.count; ++i) sum += visit.parts[i].weight;
      if (visit.count > 1 || sum != 1) share *= part.weight / sum;
    }
    std::uint32_t made = 0;
    const std::uint32_t depth = depth_;
    const Status status = open(part, share, is_expression, to_local, made);
    if (depth_ == depth) part.pose = made;
    return status;
  }

  Status close(Visit& visit, std::uint32_t& made) {
    if (g_.nodes[visit.node].kind == GraphNodeKind::layer) return close_layer(visit, made);
    if (visit.count == 1) {
      made = visit.parts[0].pose;
      return Status::ok;
    }
    if (visit.count == 0) {
      made = visit.to_local ? kLocal : take_pose();
      std::memcpy(written(made).data, skeleton().rest, at(made).size * sizeof(SoaTransform));
      return Status::ok;
    }
    BlendLayer layers[kMaxFading];
    float sum = 0;
    for (std::uint32_t i = 0; i < visit.count; ++i) sum += visit.parts[i].weight;
    for (std::uint32_t i = 0; i < visit.count; ++i)
      layers[i] = {at(visit.parts[i].pose), sum < 0.5f ? visit.parts[i].weight / sum : visit.parts[i].weight, {}};
    const bool has_fresh = fresh_ < c_.options.layers && fresh_ < kMaxGraphPoses;
    made = visit.to_local ? kLocal : has_fresh ? take_pose() : visit.parts[0].pose;
    const Status status = blend(skeleton(), {layers, visit.count}, written(made));
    for (std::uint32_t i = 0; i < visit.count; ++i)
      if (visit.parts[i].pose != made) release(visit.parts[i].pose);
    return status;
  }

  Status close_layer(Visit& visit, std::uint32_t& made) {
    const GraphLayer& layer = g_.layers[g_.nodes[visit.node].record];
    made = visit.parts[0].pose;
    if (visit.count == 1) return Status::ok;
    const Part& over = visit.parts[1];
    Span<const float> mask;
    if (layer.mask != kNoIndex) {
      const std::size_t joints = step_.b.masks.size / g_.masks.size;
      mask = {step_.b.masks.data + layer.mask * joints + first_joint_, 4 * skeleton().soa_size()};
    }
    Status status = Status::ok;
    if ((layer.flags & kLayerInModelSpace) != 0) {
      status = overlay_in_model_space(skeleton(), {at(over.pose), over.weight, mask}, written(made),
                                      own().pose.model_from_joint);
    } else if ((layer.flags & kLayerIsAdditive) == 0) {
      status = overlay(skeleton(), {at(over.pose), over.weight, mask}, written(made));
    } else {
      const Span<AdditiveTransform> change(c_.change.data, skeleton().soa_size());
      status = make_additive(skeleton(), at(over.pose), reference_of(over.node), change);
      if (status == Status::ok) status = add(skeleton(), {change, over.weight, mask}, written(made));
    }
    release(over.pose);
    return status;
  }

  // What the changes of a node's first clip are laid on.
  Span<const SoaTransform> reference_of(std::uint32_t node) {
    const Span<const SoaTransform> rest(skeleton().rest, skeleton().soa_size());
    for (std::uint32_t i = 0; i < kMaxGraphHeight && node != kNoIndex; ++i) {
      const GraphNode& of = g_.nodes[node];
      switch (of.kind) {
        case GraphNodeKind::clip: {
          const Clip clip = clip_of(step_.b.clips[of.record], skeleton_);
          return clip.reference != nullptr ? Span<const SoaTransform>(clip.reference, rest.size) : rest;
        }
        case GraphNodeKind::space:
          node = g_.points[g_.spaces[of.record].first_point].node;
          break;
        case GraphNodeKind::machine:
          node = g_.states[g_.machines[of.record].first_state].node;
          break;
        case GraphNodeKind::layer:
          node = g_.layers[of.record].base;
          break;
        case GraphNodeKind::given:
          return rest;
      }
    }
    return rest;
  }

  Character& c_;
  GraphStep step_;
  const Graph& g_;
  Span<const GivenPose> given_;
  std::uint32_t skeleton_ = 0;
  std::size_t first_joint_ = 0;
  double shift_s_ = 0;
  bool morphs_ = false;
  float total_ = 0;
  std::uint32_t fresh_ = 0;  // poses taken in this walk
  std::uint64_t free_ = 0;   // those that can be taken again
  std::uint32_t depth_ = 0;
  Visit visits_[kMaxGraphHeight];
};

Status pose_all(Character& c, GraphPoser& poser, double shift_s, bool with_weights) {
  std::size_t first_joint = 0;
  for (std::uint32_t s = 0; s < c.skeletons.size; ++s) {
    const Status status = poser.pose(s, first_joint, shift_s, with_weights && s == 0);
    if (status != Status::ok) return status;
    first_joint += 4 * c.skeletons[s].pose.skeleton.soa_size();
  }
  return Status::ok;
}

// Fades that are inertial, and the poses that they lead away from.
class Inertias {
 public:
  Inertias(Character& c, const Animator& a, GraphPoser& poser)
      : c_(c), head_(head_of(a)), s_(*a.scratch), poser_(poser) {}

  bool is_there() const { return !s_.skeletons.empty(); }

  // Before the pose of now is made.
  Status begin() {
    if (s_.shown_count > 0 && head_.age_s < s_.shown_at_s[s_.newest]) s_.shown_count = 0;  // it was taken back
    const bool is_new = head_.inertia_count != s_.inertia_count;
    if (is_new || s_.shown_count == 0)
      for (ShownSkeleton& of : s_.skeletons) of.inertia.duration_s = 0;
    s_.inertia_count = head_.inertia_count;
    if (!is_new || s_.shown_count == 0) return Status::ok;
    const double shown_s = s_.shown_at_s[s_.newest], ago_s = head_.age_s - shown_s;
    if (!(ago_s < static_cast<double>(head_.inertia_s))) return Status::ok;
    s_.inertia_at_s = shown_s;
    const double frame_s = s_.shown_count > 1 ? shown_s - s_.shown_at_s[1 - s_.newest] : 0;
    if (frame_s > 0) {
      const Status status = pose_all(c_, poser_, ago_s + frame_s, false);
      if (status != Status::ok) return status;
      for (std::uint32_t i = 0; i < c_.skeletons.size; ++i) copy(c_.skeletons[i].pose.local, s_.skeletons[i].spare);
    }
    Status status = pose_all(c_, poser_, ago_s, false);
    for (std::uint32_t i = 0; i < c_.skeletons.size && status == Status::ok; ++i) {
      ShownSkeleton& of = s_.skeletons[i];
      const Span<SoaTransform> now = of.shown[s_.newest];
      InertialStart start{now, now, c_.skeletons[i].pose.local, {}, 1.0f / 60};
      if (frame_s > 0) {
        start.before = of.shown[1 - s_.newest];
        start.target_was = of.spare;
        start.frame_s = static_cast<float>(frame_s);
      }
      status = begin_inertia(c_.skeletons[i].pose.skeleton, start, head_.inertia_s, of.inertia);
    }
    return status;
  }

  // On the pose of now, which is kept.
  Status apply() {
    const auto time_s = static_cast<float>(head_.age_s - s_.inertia_at_s);
    const bool is_again = s_.shown_count > 0 && s_.shown_at_s[s_.newest] == head_.age_s;
    if (!is_again) {
      s_.newest = 1 - s_.newest;
      if (s_.shown_count < 2) ++s_.shown_count;
    }
    s_.shown_at_s[s_.newest] = head_.age_s;
    for (std::uint32_t i = 0; i < c_.skeletons.size; ++i) {
      const CharacterSkeleton& own = c_.skeletons[i];
      ShownSkeleton& of = s_.skeletons[i];
      if (of.inertia.duration_s > 0) {
        const Status status = apply_inertia(own.pose.skeleton, of.inertia, time_s, own.pose.local);
        if (status != Status::ok) return status;
      }
      copy(own.pose.local, of.shown[s_.newest]);
    }
    return Status::ok;
  }

 private:
  static void copy(Span<const SoaTransform> from, Span<SoaTransform> to) {
    std::memcpy(to.data, from.data, to.size * sizeof(SoaTransform));
  }

  Character& c_;
  const AnimatorHead& head_;
  AnimatorScratch& s_;
  GraphPoser& poser_;
};

BadCall check_posed(const Character& c, const Animator& a, Span<const GivenPose> given) {
  MARROW_CHECK(a.binding != nullptr && a.scratch != nullptr && a.state.size >= a.binding->state_bytes);
  MARROW_CHECK(c.file.sections().data == a.binding->character.sections().data && "a character of the binding's file");
  MARROW_CHECK(c.options.layers >= a.binding->graph.nodes[0].poses);
  MARROW_CHECK(holds(given));
  for (std::size_t i = 0; i < given.size; ++i) {
    const std::size_t joints = c.skeletons.empty() ? 0 : c.skeletons[i % c.skeletons.size].pose.local.size;
    MARROW_CHECK(given[i].local.empty() || holds(given[i].local, joints));
  }
  MARROW_CHECK(head_of(a).is_updated != 0 && "an animator that was updated");
  return {};
}

Status sample_graph(Character& c, Animator& a, Span<const GivenPose> given) {
  if (head_of(a).graph != a.binding->hash) return Status::bad_data;
  GraphPoser poser(c, a, given);
  Inertias inertias(c, a, poser);
  const bool fades = inertias.is_there() && !a.binding->graph.machines.empty();
  Status status = fades ? inertias.begin() : Status::ok;
  if (status == Status::ok) status = pose_all(c, poser, 0, true);
  return fades && status == Status::ok ? inertias.apply() : status;
}

}  // namespace

Status sample_character(Character& character, Animator& animator, Span<const GivenPose> given) {
  MARROW_ZONE;
  MARROW_REQUIRE_GOOD(check_posed(character, animator, given));
  return sample_graph(character, animator, given);
}

Status pose_character(Character& character, Animator& animator, Span<const GivenPose> given) {
  MARROW_ZONE;
  MARROW_REQUIRE_GOOD(check_posed(character, animator, given));
  const Status status = sample_graph(character, animator, given);
  return status == Status::ok ? local_to_model(character) : status;
}

}  // namespace marrow
