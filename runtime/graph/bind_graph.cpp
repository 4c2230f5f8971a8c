// A graph's clips, masks and places in the state, found once for all its animators.
#include <cstring>

#include "core/check.h"
#include "core/memory.h"
#include "core/off_boundary.h"
#include "core/zone.h"
#include "graph/animator_state.h"
#include "graph/graph_fault.h"

namespace marrow {
namespace {

std::size_t masked_joints(const File& character) {
  std::size_t joints = 0;
  for (std::uint32_t s = 0; s < character.skeleton_count(); ++s) joints += 4 * character.skeleton(s).soa_size();
  return joints;
}

struct BindingPieces {
  Span<Animation> clips;
  Span<SpeedPoint> points;
  Span<float> masks, hips;
  Span<std::uint32_t> state_at, first_link;
};

BindingPieces lay_out(const Graph& graph, const File& character, Memory& memory) {
  BindingPieces out;
  out.clips = memory.take<Animation>(graph.clips.size);
  out.points = memory.take<SpeedPoint>(graph.points.size);
  out.masks = memory.take<float>(graph.masks.size * masked_joints(character));
  out.hips = memory.take<float>(graph.masks.size);
  out.state_at = memory.take<std::uint32_t>(graph.nodes.size);
  out.first_link = memory.take<std::uint32_t>(graph.nodes.size);
  return out;
}

class GraphBinder {
 public:
  GraphBinder(const File& file, const Graph& graph, const File& character, const BindingPieces& pieces)
      : file_(file), g_(graph), character_(character), pieces_(pieces) {}

  // False: see misfit().
  bool find_clips(Span<const Animations> animations) {
    for (std::size_t i = 0; i < g_.clips.size; ++i) {
      const char* const name = file_.text(g_.clips[i].name);
      const Animation* found = nullptr;
      for (std::size_t a = 0; a < animations.size && found == nullptr; ++a) found = find_animation(animations[a], name);
      if (found == nullptr) return fail("a clip of this name", name);
      if (found->clip_of_skeleton.size != character_.skeleton_count() || found->channels.size != target_count())
        return fail("animations that are made for the character", name);
      pieces_.clips[i] = *found;
    }
    return true;
  }

  bool make_masks() {
    const std::size_t joints = masked_joints(character_);
    for (std::size_t m = 0; m < g_.masks.size; ++m) {
      const Span<float> mask(pieces_.masks.data + m * joints, joints);
      for (float& factor : mask) factor = 0;
      for (std::uint32_t p = 0; p < g_.masks[m].part_count; ++p)
        if (!add_part(g_.mask_parts[g_.masks[m].first_part + p], mask)) return false;
      pieces_.hips[m] = mask.empty() ? 0 : mask[hips_in_masks()];
    }
    return true;
  }

  bool place_points() {
    for (std::size_t n = 0; n < g_.nodes.size; ++n)
      if (g_.nodes[n].kind == GraphNodeKind::space && !place(g_.spaces[g_.nodes[n].record])) return false;
    return true;
  }

  // Bytes of a state.
  std::size_t number_nodes(std::uint32_t& links) {
    std::size_t at = sizeof(AnimatorHead) + g_.parameters.size * sizeof(ParameterState);
    for (std::size_t n = 0; n < g_.nodes.size; ++n) {
      const GraphNode& node = g_.nodes[n];
      pieces_.state_at[n] = static_cast<std::uint32_t>(at);
      pieces_.first_link[n] = links;
      switch (node.kind) {
        case GraphNodeKind::clip:
          at += sizeof(ClipState);
          break;
        case GraphNodeKind::space:
          at += sizeof(SpaceState);
          links += g_.spaces[node.record].point_count;
          break;
        case GraphNodeKind::machine:
          at += sizeof(MachineState);
          links += g_.machines[node.record].state_count;
          break;
        case GraphNodeKind::layer:
          at += sizeof(LayerState);
          links += 2;
          break;
        case GraphNodeKind::given:
          at += sizeof(LayerState);
          break;
      }
    }
    return at;
  }

  const GraphMisfit& misfit() const { return misfit_; }

 private:
  std::size_t target_count() const {
    std::size_t count = 0;
    for (std::uint32_t m = 0; m < character_.mesh_count(); ++m) count += character_.mesh(m).targets.size;
    return count;
  }
  bool fail(const char* rule, const char* name) {
    misfit_ = {rule, name};
    return false;
  }

  std::size_t hips_in_masks() const {
    std::size_t first = 0;
    for (std::uint32_t s = 0; s < character_.skeleton_count(); ++s) {
      const std::uint16_t hips = joint_of(character_.roles(s), Role::hips);
      if (hips != kNoJoint) return first + hips;
      first += 4 * character_.skeleton(s).soa_size();
    }
    return 0;
  }

  // To every skeleton that has such a joint.
  bool add_part(const GraphMaskPart& part, Span<float> mask) {
    std::size_t first = 0;
    bool found = false;
    const auto role = static_cast<Role>(part.role);
    for (std::uint32_t s = 0; s < character_.skeleton_count(); ++s) {
      const Skeleton skeleton = character_.skeleton(s);
      std::uint32_t joint = skeleton.joint_count;
      if (role != Role::none)
        joint = joint_of(character_.roles(s), role);
      else
        while (joint > 0 && std::strcmp(character_.text(skeleton.names[joint - 1]), file_.text(part.joint)) != 0)
          --joint;
      if (role == Role::none) joint = joint == 0 ? skeleton.joint_count : joint - 1;
      const std::size_t size = 4 * skeleton.soa_size();
      if (joint < skeleton.joint_count) {
        found = true;
        if (mask_below(skeleton, joint, part.falloff, {mask.data + first, size}) != Status::ok) return false;
      }
      first += size;
    }
    return found || fail("a joint of a mask", role != Role::none ? role_name(role) : file_.text(part.joint));
  }

  const Animation* clip_at(const GraphPoint& point) const {
    const GraphNode& node = g_.nodes[point.node];
    return node.kind == GraphNodeKind::clip ? &pieces_.clips[node.record] : nullptr;
  }
  static std::uint32_t segments_of(const ClipMotion& m) {
    return m.phase_marks.empty() ? 1 : static_cast<std::uint32_t>(m.phase_marks.size);
  }

  // The segments of a group's cycle; 0: there are too many.
  std::uint32_t cycle_of(const GraphSpace& s) const {
    std::uint32_t cycle = 1;
    for (std::uint32_t i = 0; i < s.point_count; ++i) {
      const Animation* const clip = clip_at(g_.points[s.first_point + i]);
      if (clip == nullptr) continue;
      const std::uint32_t step = cycle;
      for (const std::uint32_t segments = segments_of(clip->motion); cycle % segments != 0;) cycle += step;
      if (cycle > kMaxMarks) return 0;
    }
    return cycle;
  }

  bool place(const GraphSpace& s) {
    const bool in_step = (s.flags & kSpaceInStep) != 0;
    for (std::uint32_t i = 0; i < s.point_count; ++i)
      if (const Animation* const clip = clip_at(g_.points[s.first_point + i]))
        if (!is_valid(clip->motion)) return fail("a motion that keeps the rules of clip_motion.h", clip->name);
    const std::uint32_t cycle = in_step ? cycle_of(s) : 1;
    if (cycle == 0)
      return fail("phase marks whose common multiple is at most 64", clip_at(g_.points[s.first_point])->name);
    const SpeedPoint* before = nullptr;
    for (std::uint32_t i = 0; i < s.point_count; ++i) {
      const GraphPoint& point = g_.points[s.first_point + i];
      const Animation* const clip = clip_at(point);
      SpeedPoint& out = pieces_.points[s.first_point + i];
      out = {point.own_speed != 0 ? clip->motion.speed_m_s : point.x, 1};
      if (clip != nullptr && in_step)
        out.duration_s =
            clip->motion.duration_s * (static_cast<float>(cycle) / static_cast<float>(segments_of(clip->motion)));
      const char* const name = clip != nullptr ? clip->name : file_.text(g_.nodes[point.node].name);
      if (s.triangle_count == 0 && before != nullptr && !(before->speed_m_s < out.speed_m_s))
        return fail("points of a space that ascend", name);
      if ((s.flags & kSpaceMatchesSpeed) != 0 && !(out.speed_m_s >= 0 && out.duration_s > 0))
        return fail("a clip that takes time, at a speed that is not negative", name);
      before = &out;
    }
    return true;
  }

  const File& file_;
  const Graph& g_;
  const File& character_;
  const BindingPieces& pieces_;
  GraphMisfit misfit_;
};

// FNV-1a over the records, eight bytes at a time but for what is left.
class Hash {
 public:
  template <class T>
  void add(Span<T> records) {
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(records.data);
    for (std::size_t i = 0; i < records.size * sizeof(T); ++i) value_ = (value_ ^ bytes[i]) * 1099511628211ull;
    value_ = (value_ ^ records.size) * 1099511628211ull;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037ull;
};

// Of all that a state depends on.
std::uint64_t hash_of(const Graph& g) {
  Hash hash;
  hash.add(g.parameters);
  hash.add(g.nodes);
  hash.add(g.machines);
  hash.add(g.states);
  hash.add(g.transitions);
  hash.add(g.layers);
  hash.add(g.points);
  return hash.value();
}

BadCall check_spans(const Graph& g) {
  MARROW_CHECK(holds(g.parameters) && holds(g.nodes) && holds(g.clips) && holds(g.spaces) && holds(g.points));
  MARROW_CHECK(holds(g.triangles) && holds(g.machines) && holds(g.states) && holds(g.transitions));
  MARROW_CHECK(holds(g.conditions) && holds(g.layers) && holds(g.masks) && holds(g.mask_parts));
  return {};
}

}  // namespace

std::size_t graph_binding_bytes(const Graph& graph, const File& character) {
  Memory counted;
  lay_out(graph, character, counted);
  return counted.whole();
}

Status bind_graph(const File& file, const Graph& graph, const File& character, Span<const Animations> animations,
                  Span<std::byte> memory, GraphBinding& out, GraphMisfit* misfit) {
  MARROW_ZONE;
  MARROW_REQUIRE_GOOD(check_spans(graph));
  MARROW_REQUIRE(holds(animations));
  MARROW_REQUIRE(holds(memory, graph_binding_bytes(graph, character)));
  MARROW_REQUIRE_GOOD(check_boundary(memory.data));
  const GraphFault fault = find_fault(graph);
  if (misfit != nullptr) *misfit = {fault.rule != nullptr ? fault.rule : "", ""};
  if (fault.rule != nullptr) return Status::bad_data;
  Memory taken{memory.data};
  const BindingPieces pieces = lay_out(graph, character, taken);
  GraphBinder binder(file, graph, character, pieces);
  const bool fits = binder.find_clips(animations) && binder.make_masks() && binder.place_points();
  if (misfit != nullptr) *misfit = binder.misfit();
  if (!fits) return Status::mismatch;
  GraphBinding made;
  made.state_bytes = static_cast<std::uint32_t>(binder.number_nodes(made.link_count));
  made.file = file;
  made.graph = graph;
  made.character = character;
  made.clips = pieces.clips;
  made.points = pieces.points;
  made.masks = pieces.masks;
  made.hips = pieces.hips;
  made.state_at = pieces.state_at;
  made.first_link = pieces.first_link;
  made.hash = hash_of(graph);
  out = made;
  return Status::ok;
}

}  // namespace marrow
