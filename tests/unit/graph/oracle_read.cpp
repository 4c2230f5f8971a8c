// Reads the text of a graph for the oracle: one that is known to be valid.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <toml++/toml.h>

#include "unit/graph/graph_rig.h"
#include "unit/graph/oracle.h"

namespace marrow::test::oracle {

std::size_t Graph::parameter(const std::string& name) const {
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].name == name) return i;
  throw std::runtime_error("oracle: no parameter " + name);
}

namespace {

using Table = toml::table;

// Numbers of a file are floats.
double number(const toml::node* n, double otherwise) {
  if (n == nullptr) return otherwise;
  return static_cast<double>(static_cast<float>(n->value<double>().value()));
}
std::string text(const toml::node* n, const std::string& otherwise = "") {
  return n == nullptr ? otherwise : n->value<std::string>().value();
}
bool flag(const toml::node* n) {
  return n != nullptr && n->value<bool>().value();
}
// One, or a list.
std::vector<std::string> texts(const toml::node* n) {
  std::vector<std::string> out;
  if (n == nullptr) return out;
  if (const toml::array* list = n->as_array())
    for (const toml::node& each : *list) out.push_back(text(&each));
  else
    out.push_back(text(n));
  return out;
}

class Reader {
 public:
  explicit Reader(const std::string& from) : file_(toml::parse(from)), named_(file_["node"].as_table()) {}

  Graph read() {
    if (const Table* all = file_["parameters"].as_table())
      for (const auto& [name, value] : *all) parameter(std::string(name.str()), *value.as_table());
    graph_.output = pose(file_["output"].value<std::string>().value(), false);
    order();
    return graph_;
  }

 private:
  void parameter(const std::string& name, const Table& t) {
    Parameter& p = graph_.parameters.emplace_back();
    p.name = name;
    const std::string type = text(t.get("type"));
    if (type == "number") {
      p.least = number(&*t.get("range")->as_array()->get(0), 0);
      p.most = number(&*t.get("range")->as_array()->get(1), 0);
      p.initial = number(t.get("initial"), std::clamp(0.0, p.least, p.most));
      p.seconds = number(t.get("half_life"), 0);
    } else if (type == "flag") {
      p.kind = ParameterKind::flag;
      p.initial = flag(t.get("initial")) ? 1 : 0;
    } else {
      p.kind = ParameterKind::trigger;
      p.seconds = number(t.get("hold"), 0);
    }
  }

  std::size_t clip(const std::string& name) const {
    for (std::size_t i = 0; i < clips().size(); ++i)
      if (clips()[i].name == name) return i;
    throw std::runtime_error("oracle: no clip " + name);
  }
  int add(Node node) {
    graph_.nodes.push_back(std::move(node));
    return static_cast<int>(graph_.nodes.size()) - 1;
  }
  // The node of a name; a clip's is new each time. waits: something waits for its end.
  int pose(const std::string& name, bool waits) {
    if (const auto it = made_.find(name); it != made_.end()) return it->second;
    const toml::node* found = named_ != nullptr ? named_->get(name) : nullptr;
    if (found == nullptr) {
      Node node;
      node.clip = clip(name);
      if (waits) node.play = Play::once;
      return add(node);
    }
    const Table& t = *found->as_table();
    const std::string type = text(t.get("type"));
    Node node;
    node.name = name;
    if (type == "clip") clip_node(t, waits, node);
    if (type == "space") space(t, node);
    if (type == "machine") machine(t, node);
    if (type == "layer" || type == "add") layer(t, type == "add", node);
    if (type == "one_shot") one_shot(t, node);
    if (type == "pick") pick(t, node);
    if (type == "given") node.kind = Kind::given;
    return made_[name] = add(node);
  }

  void clip_node(const Table& t, bool waits, Node& node) {
    node.clip = clip(text(t.get("clip")));
    node.speed = number(t.get("speed"), 1);
    const std::string play = text(t.get("play"), waits ? "once" : "loop");
    node.play = play == "once" ? Play::once : play == "loop" ? Play::loop : Play::ping_pong;
  }

  void space(const Table& t, Node& node) {
    node.kind = Kind::space;
    for (const std::string& by : texts(t.get("by"))) node.by.push_back(graph_.parameter(by));
    node.in_step = flag(t.get("sync"));
    node.matches = flag(t.get("match_speed"));
    for (const toml::node& each : *t.get("points")->as_array()) {
      const Table& p = *each.as_table();
      Point point;
      point.node = pose(text(p.get("pose")), false);
      const toml::node* at = p.get("at");
      if (at == nullptr) {
        const Clip& own = clips()[graph_.nodes[static_cast<std::size_t>(point.node)].clip];
        point.x = own.speed_m_s;
      } else if (const toml::array* both = at->as_array()) {
        point.x = number(both->get(0), 0);
        point.y = number(both->get(1), 0);
      } else {
        point.x = number(at, 0);
      }
      node.points.push_back(point);
    }
    if (node.by.size() == 2) node.triangles = triangulated(node.points);
  }

  std::vector<int> states(const Node& node, const toml::node* n) const {
    std::vector<int> out;
    for (const std::string& name : texts(n))
      for (std::size_t s = 0; s < node.states.size(); ++s)
        if (node.states[s].name == name) out.push_back(static_cast<int>(s));
    return out;
  }

  Condition condition(const std::string& from) const {
    std::istringstream words(from);
    std::string first, test;
    words >> first;
    Condition out;
    if (first == "not") {
      words >> first;
      out.test = Test::not_set;
    } else if (words >> test) {
      double value = 0;
      words >> value;
      out.value = static_cast<double>(static_cast<float>(value));
      out.test = test == ">" ? Test::above : test == "<" ? Test::below : test == ">=" ? Test::at_least : Test::at_most;
    }
    out.parameter = graph_.parameter(first);
    return out;
  }

  void machine(const Table& t, Node& node) {
    node.kind = Kind::machine;
    const Table& all = *t.get("state")->as_table();
    // In the file's order.
    std::vector<std::pair<toml::source_position, std::string>> names;
    for (const auto& [name, value] : all) names.emplace_back(value.source().begin, std::string(name.str()));
    std::sort(names.begin(), names.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [where, name] : names) node.states.push_back({name, -1});
    node.start = states(node, t.get("start"));
    std::vector<bool> waits(node.states.size(), false);
    if (const toml::node* list = t.get("transition"))
      for (const toml::node& each : *list->as_array()) transition(*each.as_table(), node, waits);
    for (std::size_t s = 0; s < node.states.size(); ++s)
      if (const toml::node* p = all.get(node.states[s].name)->as_table()->get("pose"))
        node.states[s].node = pose(text(p), waits[s]);
  }
  void transition(const Table& t, Node& node, std::vector<bool>& waits) const {
    Transition out;
    out.to = states(node, t.get("to"));
    out.in_turn = text(t.get("choose"), "chance") == "turn";
    for (const std::string& when : texts(t.get("when"))) out.when.push_back(condition(when));
    out.after_s = number(t.get("after"), -1);
    out.at_end_s = number(t.get("at_end"), -1);
    out.fade_s = number(t.get("fade"), 0);
    out.inertial = text(t.get("kind")) == "inertial";
    if (const toml::node* enter = t.get("enter")) {
      if (enter->is_number()) {
        out.enter = Enter::seconds;
        out.enter_s = number(enter, 0);
      } else if (text(enter) == "same_phase") {
        out.enter = Enter::phase;
      }
    }
    std::vector<int> from = states(node, t.get("from"));
    if (from.empty()) from = {-1};
    for (const int f : from) {
      out.from = f;
      if (out.at_end_s >= 0 && f >= 0) waits[static_cast<std::size_t>(f)] = true;
      node.transitions.push_back(out);
    }
  }

  void mask(const Table& t, Node& node) const {
    const toml::node* n = t.get("mask");
    if (n == nullptr) return;
    node.mask.assign(kGraphBones.size(), 0);
    const auto part = [&](const Table& p) {
      const std::string joint = text(p.get(p.contains("role") ? "role" : "joint"));
      const double grows = number(p.get("falloff"), 0) + 1;
      for (std::size_t b = 0; b < kGraphBones.size(); ++b) {
        double depth = 1;
        for (int up = static_cast<int>(b); up >= 0; up = kGraphBones[static_cast<std::size_t>(up)].parent, ++depth)
          if (kGraphBones[static_cast<std::size_t>(up)].name == joint)
            node.mask[b] = std::max(node.mask[b], std::min(1.0, depth / grows));
      }
    };
    if (const toml::array* list = n->as_array())
      for (const toml::node& each : *list) part(*each.as_table());
    else
      part(*n->as_table());
  }

  void layer(const Table& t, bool additive, Node& node) {
    node.kind = Kind::layer;
    node.additive = additive;
    node.base = pose(text(t.get("base")), false);
    node.pose = pose(text(t.get("pose")), false);
    mask(t, node);
    node.fade_s = number(t.get("fade"), 0);
    node.in_model = t.contains("space") && text(t.get("space")) == "model";
    if (const toml::node* w = t.get("weight")) {
      if (w->is_string())
        node.by_parameter = static_cast<int>(graph_.parameter(text(w)));
      else
        node.weight = number(w, 1);
    }
  }

  void one_shot(const Table& t, Node& node) {
    Node machine;
    machine.kind = Kind::machine;
    std::swap(machine.name, node.name);  // who asks for its state asks for the machine's
    machine.states = {{"off", -1}, {"on", -1}};
    machine.start = {0};
    Transition on;
    on.from = 0;
    on.to = {1};
    for (const std::string& when : texts(t.get("when"))) on.when.push_back(condition(when));
    on.fade_s = number(t.get("fade_in"), static_cast<double>(0.1f));
    Transition off;
    off.from = 1;
    off.to = {0};
    off.at_end_s = off.fade_s = number(t.get("fade_out"), static_cast<double>(0.2f));
    machine.transitions = {on, off};
    machine.states[1].node = pose(text(t.get("pose")), true);
    node.kind = Kind::layer;
    node.base = pose(text(t.get("base")), false);
    node.pose = add(machine);
    mask(t, node);
  }

  void pick(const Table& t, Node& node) {
    node.kind = Kind::machine;
    const std::vector<std::string> poses = texts(t.get("poses"));
    Transition next;
    next.in_turn = node.start_in_turn = text(t.get("choose"), "chance") == "turn";
    next.at_end_s = next.fade_s = number(t.get("fade"), static_cast<double>(0.2f));
    for (const std::string& p : poses) {
      node.start.push_back(static_cast<int>(node.states.size()));
      node.states.push_back({p, pose(p, poses.size() > 1)});
    }
    next.to = node.start;
    if (poses.size() > 1) node.transitions = {next};
  }

  // Numbers the nodes anew: each before those that it takes, the first of them first.
  void order() {
    std::vector<int> order, at(graph_.nodes.size(), -1);
    std::vector<bool> met(graph_.nodes.size(), false);
    const std::function<void(int)> go = [&](int n) {
      if (n < 0 || met[static_cast<std::size_t>(n)]) return;
      met[static_cast<std::size_t>(n)] = true;
      const Node& node = graph_.nodes[static_cast<std::size_t>(n)];
      go(node.pose);
      go(node.base);
      for (std::size_t i = node.states.size(); i-- > 0;) go(node.states[i].node);
      for (std::size_t i = node.points.size(); i-- > 0;) go(node.points[i].node);
      order.push_back(n);
    };
    go(graph_.output);
    std::reverse(order.begin(), order.end());
    std::vector<Node> nodes;
    for (std::size_t i = 0; i < order.size(); ++i) {
      at[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
      nodes.push_back(graph_.nodes[static_cast<std::size_t>(order[i])]);
    }
    const auto renumber = [&](int& n) {
      if (n >= 0) n = at[static_cast<std::size_t>(n)];
    };
    for (Node& node : nodes) {
      for (Point& p : node.points) renumber(p.node);
      for (State& s : node.states) renumber(s.node);
      renumber(node.base);
      renumber(node.pose);
    }
    graph_.nodes = nodes;
    renumber(graph_.output);
  }

  Table file_;
  const Table* named_;
  Graph graph_;
  std::map<std::string, int> made_;
};

}  // namespace

Graph read(const std::string& text) {
  return Reader(text).read();
}

}  // namespace marrow::test::oracle
