#include "cook/graph/build_graph.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "common/failure.h"
#include "graph/graph_fault.h"
#include "text/nearest.h"
#include "toml/toml_reader.h"

namespace marrow::cook {
namespace {

// A node on its way, with those whose poses it takes in the order of its points, states, or base and pose.
struct Draft {
  const NodeText* text = nullptr;  // null: a clip that is named in place
  std::string name, clip;
  GraphNodeKind kind = GraphNodeKind::clip;
  PlayMode mode = PlayMode::loop;
  bool is_shot = false;            // the machine of a one_shot
  std::vector<std::size_t> below;  // kNothing: a state without pose
  const NameText* used_at = nullptr;
  std::size_t height = 0, number = 0;
};
constexpr std::size_t kNothing = static_cast<std::size_t>(-1);

class GraphBuilder {
 public:
  GraphBuilder(const GraphText& text, Notes& notes) : text_(text), notes_(notes), at_(text.path) {}

  BuiltGraph build() {
    for (std::size_t i = 0; i < text_.nodes.size(); ++i) node_of_[text_.nodes[i].name] = i;
    for (std::size_t i = 0; i < text_.parameters.size(); ++i) parameter_of_[text_.parameters[i].name] = i;
    for (const ParameterText& p : text_.parameters) {
      out_.parameters.push_back(p.values);
      out_.parameter_names.push_back(p.name);
    }
    out_.name = text_.name;
    const std::size_t output = expand(text_.output, nullptr, 0);
    expect_shown(output);
    order(output);
    if (order_.size() > kMaxGraphNodes) at_.fail(text_.output.at, "more than 512 nodes", "make two graphs of it");
    for (std::size_t i = 0; i < order_.size(); ++i) drafts_[order_[order_.size() - 1 - i]].number = i;
    for (std::size_t i = order_.size(); i-- > 0;) write(drafts_[order_[i]]);
    finish();
    warn_of_unused();
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(const NameText& at, const std::string& rule, const std::string& advice) const {
    at_.fail(at.at, rule, advice);
  }

  std::vector<std::string> names_of_nodes() const {
    std::vector<std::string> out;
    for (const NodeText& n : text_.nodes) out.push_back(n.name);
    return out;
  }

  // The node of a name.
  // waiter: who waits for its end; null: nobody.
  std::size_t expand(const NameText& name, const char* waiter, std::size_t depth) {
    if (depth >= kMaxGraphHeight) fail(name, "nodes that stand 16 below each other, or more", "make the graph flatter");
    const auto found = node_of_.find(name.name);
    if (found == node_of_.end()) {
      Draft clip;
      clip.name = "";
      clip.clip = name.name;
      clip.mode = waiter != nullptr ? PlayMode::once : PlayMode::loop;
      clip.used_at = &name;
      drafts_.push_back(clip);
      return drafts_.size() - 1;
    }
    const NodeText& node = text_.nodes[found->second];
    if (open_.contains(found->second))
      fail(name, fmt::format("\"{}\" is made of itself", name.name),
           "take another; if a clip is meant, call the node by another name");
    if (const auto made = made_.find(found->second); made != made_.end()) {
      if (waiter != nullptr) want_end(made->second, name, waiter);
      return made->second;
    }
    open_.insert(found->second);
    const std::size_t made = make(node, name, depth);
    open_.erase(found->second);
    made_[found->second] = made;
    if (waiter != nullptr) want_end(made, name, waiter);
    return made;
  }

  // Its clip plays once, as far as the text leaves that open.
  void want_end(std::size_t draft, const NameText& name, const char* waiter) {
    Draft& d = drafts_[draft];
    if (d.kind == GraphNodeKind::layer) return want_end(d.below[0], name, waiter);
    if (d.kind != GraphNodeKind::clip)
      fail(name, fmt::format("{} waits for the end of \"{}\", which is no clip", waiter, name.name),
           "give a clip, or a machine with after = SECONDS");
    if (d.text == nullptr || !d.text->mode) d.mode = PlayMode::once;
  }

  std::size_t make(const NodeText& node, const NameText& name, std::size_t depth) {
    Draft d;
    d.text = &node;
    d.name = node.name;
    d.used_at = &name;
    switch (node.type) {
      case NodeType::clip:
        d.clip = node.clip.name;
        d.mode = node.mode.value_or(PlayMode::loop);
        break;
      case NodeType::space:
        d.kind = GraphNodeKind::space;
        for (const PointText& p : node.points) d.below.push_back(expand_point(node, p, depth + 1));
        break;
      case NodeType::machine:
        d.kind = GraphNodeKind::machine;
        for (const StateText& s : node.states)
          d.below.push_back(s.pose ? expand(*s.pose, waits_for_end(node, s) ? "at_end" : nullptr, depth + 1)
                                   : kNothing);
        break;
      case NodeType::layer:
      case NodeType::add:
        d.kind = GraphNodeKind::layer;
        d.below = {expand(node.base, nullptr, depth + 1), expand(node.pose, nullptr, depth + 1)};
        break;
      case NodeType::one_shot:
        return make_one_shot(node, name, depth);
      case NodeType::pick:
        d.kind = GraphNodeKind::machine;
        for (const NameText& pose : node.poses)
          d.below.push_back(expand(pose, node.poses.size() > 1 ? "a pick" : nullptr, depth + 1));
        break;
      case NodeType::given:
        d.kind = GraphNodeKind::given;
        break;
    }
    drafts_.push_back(d);
    return drafts_.size() - 1;
  }

  std::size_t expand_point(const NodeText& node, const PointText& p, std::size_t depth) {
    const std::size_t made = expand(p.pose, nullptr, depth);
    const bool is_clip = drafts_[made].kind == GraphNodeKind::clip;
    if (!is_clip && node.sync) fail(p.pose, "poses in step must be clips", "leave sync out, or give a clip");
    if (!is_clip && p.at.empty())
      fail(p.pose, "only a clip has a speed of its own", "say where the pose stands: at = 1.5");
    return made;
  }

  static bool waits_for_end(const NodeText& node, const StateText& state) {
    return std::ranges::any_of(node.transitions, [&](const TransitionText& t) {
      return (t.values.flags & kWaitsForEnd) != 0 &&
             (t.from.empty() || std::ranges::find(t.from, state.name, &NameText::name) != t.from.end());
    });
  }

  // A layer over a machine that shows nothing, or the pose.
  std::size_t make_one_shot(const NodeText& node, const NameText& name, std::size_t depth) {
    Draft machine;
    machine.text = &node;
    machine.name = node.name;
    machine.kind = GraphNodeKind::machine;
    machine.is_shot = true;
    machine.used_at = &name;
    const std::size_t base = expand(node.base, nullptr, depth + 1);
    machine.below = {kNothing, expand(node.pose, "a one_shot", depth + 2)};
    drafts_.push_back(machine);
    Draft layer;
    layer.text = &node;
    layer.kind = GraphNodeKind::layer;
    layer.used_at = &name;
    layer.below = {base, drafts_.size() - 1};
    drafts_.push_back(layer);
    return drafts_.size() - 1;
  }

  // States that show nothing are for layers.
  void expect_shown(std::size_t output) const {
    const auto expect = [&](std::size_t below) {
      if (below == kNothing) return;
      const Draft& d = drafts_[below];
      if (d.kind != GraphNodeKind::machine || d.is_shot) return;
      for (std::size_t i = 0; i < d.below.size(); ++i)
        if (d.below[i] == kNothing)
          at_.fail(d.text->states[i].at, fmt::format("\"{}\" shows nothing", d.text->states[i].name),
                   "give it a pose, or take the machine as the pose of a layer");
    };
    expect(output);
    for (const Draft& d : drafts_)
      for (std::size_t i = 0; i < d.below.size(); ++i)
        if (d.kind != GraphNodeKind::layer || i == 0) expect(d.below[i]);
  }

  // Those below first.
  void order(std::size_t draft) {
    if (draft == kNothing || !ordered_.insert(draft).second) return;
    // From the last to the first, so that in the order from above the first comes first.
    for (std::size_t i = drafts_[draft].below.size(); i-- > 0;) order(drafts_[draft].below[i]);
    for (const std::size_t below : drafts_[draft].below)
      if (below != kNothing) drafts_[draft].height = std::max(drafts_[draft].height, drafts_[below].height + 1);
    order_.push_back(draft);
  }

  std::uint32_t number(std::size_t draft) const {
    return draft == kNothing ? kNoIndex : static_cast<std::uint32_t>(drafts_[draft].number);
  }

  std::uint32_t parameter(const NameText& name) const {
    const auto found = parameter_of_.find(name.name);
    if (found != parameter_of_.end()) return static_cast<std::uint32_t>(found->second);
    std::vector<std::string> names;
    for (const ParameterText& p : text_.parameters) names.push_back(p.name);
    fail(name, fmt::format("there is no parameter \"{}\"", name.name),
         names.empty() ? "give it in [parameters]" : tools::suggestion(name.name, names));
  }
  std::uint32_t number_parameter(const NameText& name) const {
    const std::uint32_t p = parameter(name);
    if (out_.parameters[p].kind != ParameterKind::number)
      fail(name, fmt::format("\"{}\" is no number", name.name), "give { type = \"number\", range = [0, 1] }");
    return p;
  }

  GraphCondition condition(const ConditionText& text) const {
    const std::uint32_t p = parameter(text.parameter);
    const bool is_number = out_.parameters[p].kind == ParameterKind::number,
               compares = text.test >= ConditionTest::above;
    if (is_number && !compares)
      fail(text.parameter, fmt::format("\"{}\" is a number", text.parameter.name),
           fmt::format("compare it, as in \"{} > 0.5\"", text.parameter.name));
    if (!is_number && compares)
      fail(text.parameter, fmt::format("\"{}\" is no number", text.parameter.name),
           fmt::format("\"{0}\", or \"not {0}\"", text.parameter.name));
    return {p, text.test, text.value};
  }

  void write(const Draft& d) {
    GraphNode n;
    n.kind = d.kind;
    n.height = static_cast<std::uint16_t>(d.height);
    out_.nodes.push_back(n);
    out_.node_names.push_back(d.name);
    switch (d.kind) {
      case GraphNodeKind::clip: {
        GraphClip clip;
        if (d.text != nullptr) clip.speed = d.text->play.speed;
        clip.mode = static_cast<std::uint32_t>(d.mode);
        out_.nodes.back().record = static_cast<std::uint32_t>(out_.clips.size());
        out_.clips.push_back(clip);
        out_.clip_names.push_back(d.clip);
        break;
      }
      case GraphNodeKind::space:
        write_space(d);
        break;
      case GraphNodeKind::machine:
        write_machine(d);
        break;
      case GraphNodeKind::layer:
        write_layer(d);
        break;
      case GraphNodeKind::given:
        out_.nodes.back().record = out_.given_count++;
        break;
    }
  }
  void write_space(const Draft& d) {
    const NodeText& text = *d.text;
    GraphSpace s;
    s.first_point = static_cast<std::uint32_t>(out_.points.size());
    s.point_count = static_cast<std::uint32_t>(text.points.size());
    for (std::size_t i = 0; i < text.by.size(); ++i) s.by[i] = number_parameter(text.by[i]);
    s.flags =
        (text.sync ? std::uint32_t{kSpaceInStep} : 0) | (text.match_speed ? std::uint32_t{kSpaceMatchesSpeed} : 0);
    std::vector<GraphPoint> points;
    for (std::size_t i = 0; i < text.points.size(); ++i) {
      const std::vector<float>& at = text.points[i].at;
      points.push_back({number(d.below[i]), at.empty() ? 0 : at[0], at.size() < 2 ? 0 : at[1], at.empty() ? 1u : 0u});
    }
    const bool is_line = text.by.size() == 1;
    if (is_line && std::ranges::none_of(points, [](const GraphPoint& p) { return p.own_speed != 0; })) {
      std::ranges::stable_sort(points, {}, &GraphPoint::x);
      if (std::ranges::adjacent_find(points, {}, &GraphPoint::x) != points.end())
        fail(text.points[0].pose, "two points at one place", "move one");
    }
    s.first_triangle = static_cast<std::uint32_t>(out_.triangles.size());
    if (!is_line) {
      std::vector<PlanePoint> places;
      for (const GraphPoint& p : points) places.push_back({p.x, p.y});
      const std::vector<PlaneTriangle> triangles = triangulate(places);
      if (triangles.empty())
        fail(text.points[0].pose, "points of a plane that are on one line, or two of which are at one place",
             "give three that are not, or go by one number");
      out_.triangles.insert(out_.triangles.end(), triangles.begin(), triangles.end());
      s.triangle_count = static_cast<std::uint32_t>(triangles.size());
    }
    out_.points.insert(out_.points.end(), points.begin(), points.end());
    out_.nodes.back().record = static_cast<std::uint32_t>(out_.spaces.size());
    out_.spaces.push_back(s);
  }

  std::uint32_t state(const NodeText& text, const NameText& name) const {
    const auto found = std::ranges::find(text.states, name.name, &StateText::name);
    if (found != text.states.end()) return static_cast<std::uint32_t>(found - text.states.begin());
    std::vector<std::string> names;
    for (const StateText& s : text.states) names.push_back(s.name);
    fail(name, fmt::format("there is no state \"{}\"", name.name), tools::suggestion(name.name, names));
  }

  void write_machine(const Draft& d) {
    GraphMachine m;
    m.first_state = static_cast<std::uint32_t>(out_.states.size());
    m.state_count = static_cast<std::uint32_t>(d.below.size());
    m.first_transition = static_cast<std::uint32_t>(out_.transitions.size());
    for (std::size_t i = 0; i < d.below.size(); ++i) {
      out_.states.push_back({0, number(d.below[i])});
      out_.state_names.push_back(d.is_shot                        ? (i == 0 ? "off" : "on")
                                 : d.text->type == NodeType::pick ? d.text->poses[i].name
                                                                  : d.text->states[i].name);
    }
    if (d.is_shot) {
      write_shot(*d.text);
    } else if (d.text->type == NodeType::pick) {
      m.start_count = m.state_count;
      m.flags = d.text->in_turn ? std::uint32_t{kChooseInTurn} : 0;
      GraphTransition next;
      next.to_count = m.state_count;
      next.fade_s = next.at_end_s = d.text->fade_s;
      next.flags = kWaitsForEnd | m.flags;
      if (m.state_count > 1) add_transition(next, {});
    } else {
      m.start = state(*d.text, d.text->start);
      for (const TransitionText& t : d.text->transitions) write_transition(*d.text, t);
    }
    m.transition_count = static_cast<std::uint32_t>(out_.transitions.size()) - m.first_transition;
    if (m.transition_count > 256) at_.fail(d.text->at, "more than 256 transitions", "make two machines of it");
    out_.nodes.back().record = static_cast<std::uint32_t>(out_.machines.size());
    out_.machines.push_back(m);
  }
  void write_shot(const NodeText& text) {
    GraphTransition on;
    on.from = 0;
    on.to = 1;
    on.fade_s = text.fade_in_s;
    add_transition(on, text.when);
    GraphTransition off;
    off.from = 1;
    off.to = 0;
    off.fade_s = off.at_end_s = text.fade_out_s;
    off.flags = kWaitsForEnd;
    add_transition(off, {});
  }
  void write_transition(const NodeText& machine, const TransitionText& t) {
    GraphTransition made = t.values;
    made.to = state(machine, t.to[0]);
    made.to_count = static_cast<std::uint32_t>(t.to.size());
    for (std::size_t i = 1; i < t.to.size(); ++i)
      if (state(machine, t.to[i]) != made.to + i)
        fail(t.to[i], "states of which one is chosen must follow one another",
             "in the order in which they are written");
    if (t.from.empty()) return add_transition(made, t.when);
    for (const NameText& from : t.from) {
      made.from = state(machine, from);
      add_transition(made, t.when);
    }
  }
  void add_transition(GraphTransition t, const std::vector<ConditionText>& when) {
    t.first_condition = static_cast<std::uint32_t>(out_.conditions.size());
    t.condition_count = static_cast<std::uint32_t>(when.size());
    if (when.size() > 16) fail(when[16].parameter, "more than 16 conditions", "make two transitions of it");
    for (const ConditionText& c : when) out_.conditions.push_back(condition(c));
    out_.transitions.push_back(t);
  }

  void write_layer(const Draft& d) {
    const NodeText& text = *d.text;
    GraphLayer l;
    l.base = number(d.below[0]);
    l.pose = number(d.below[1]);
    l.mask = mask(text.mask);
    l.weight = text.weight;
    if (text.type != NodeType::one_shot) l.fade_s = text.fade_s;
    l.flags = text.type == NodeType::add ? std::uint32_t{kLayerIsAdditive} : 0;
    if (text.in_model_space) l.flags = kLayerInModelSpace;
    if (text.weight_by) {
      l.by = parameter(*text.weight_by);
      if (out_.parameters[l.by].kind == ParameterKind::trigger)
        fail(*text.weight_by, fmt::format("\"{}\" is a trigger", text.weight_by->name), "a number or a flag");
    }
    const bool by_flag = l.by != kNoIndex && out_.parameters[l.by].kind == ParameterKind::flag;
    if (l.fade_s > 0 && !by_flag)
      at_.fail(text.at, "only a layer that goes by a flag fades",
               text.weight_by ? "give the number a half_life" : "weight = the name of a flag, or leave fade out");
    out_.nodes.back().record = static_cast<std::uint32_t>(out_.layers.size());
    out_.layers.push_back(l);
  }
  // The mask of these parts, each once.
  std::uint32_t mask(const std::vector<MaskPartText>& parts) {
    if (parts.empty()) return kNoIndex;
    std::string key;
    for (const MaskPartText& p : parts)
      key += fmt::format("{} {} {} ", p.role ? static_cast<int>(*p.role) : 0, p.falloff, p.joint.size()) + p.joint;
    const auto [at, is_new] = masks_.try_emplace(key, static_cast<std::uint32_t>(out_.masks.size()));
    if (!is_new) return at->second;
    out_.masks.push_back(
        {static_cast<std::uint32_t>(out_.mask_parts.size()), static_cast<std::uint32_t>(parts.size())});
    for (const MaskPartText& p : parts) {
      out_.mask_parts.push_back({p.role ? static_cast<std::uint32_t>(*p.role) : 0, 0, p.falloff});
      out_.part_joints.push_back(p.joint);
    }
    return at->second;
  }

  // How many poses each node holds, from the last on; and whether all is as the runtime wants it.
  void finish() {
    Graph g = view(out_);
    for (std::size_t n = out_.nodes.size(); n-- > 0;)
      out_.nodes[n].poses = static_cast<std::uint16_t>(poses_of(g, static_cast<std::uint32_t>(n)));
    if (out_.nodes[0].poses > kMaxGraphPoses)
      at_.fail(text_.output.at, "a graph that holds more than 64 poses at once", "nest fewer machines and spaces");
    const GraphFault fault = find_fault(g);
    if (fault.rule != nullptr)
      throw tools::Failure(tools::Exit::usage, text_.path, "", fault.rule, "make the graph smaller");
  }

  void warn_of_unused() {
    std::vector<std::string> unused;
    for (std::size_t i = 0; i < text_.nodes.size(); ++i)
      if (!made_.contains(i)) unused.push_back(text_.nodes[i].name);
    if (!unused.empty())
      notes_.warnings.push_back({text_.path, "unused-node", "nothing takes the poses of " + tools::listed(unused)});
  }

  const GraphText& text_;
  Notes& notes_;
  tools::TomlReader at_;
  BuiltGraph out_;
  std::map<std::string, std::size_t> node_of_, parameter_of_;
  std::vector<Draft> drafts_;
  std::map<std::size_t, std::size_t> made_;  // the draft of a node of the text
  std::set<std::size_t> open_, ordered_;
  std::vector<std::size_t> order_;
  std::map<std::string, std::uint32_t> masks_;
};

}  // namespace

Graph view(const BuiltGraph& g) {
  Graph out;
  out.name = g.name.c_str();
  out.parameters = g.parameters;
  out.nodes = g.nodes;
  out.clips = g.clips;
  out.spaces = g.spaces;
  out.points = g.points;
  out.triangles = g.triangles;
  out.machines = g.machines;
  out.states = g.states;
  out.transitions = g.transitions;
  out.conditions = g.conditions;
  out.layers = g.layers;
  out.masks = g.masks;
  out.mask_parts = g.mask_parts;
  out.given_count = g.given_count;
  return out;
}

BuiltGraph build_graph(const GraphText& text, Notes& notes) {
  return GraphBuilder(text, notes).build();
}

}  // namespace marrow::cook
