// `marrow graph dot`: a graph as Graphviz draws it.
#include <string>

#include <fmt/format.h>

#include "behave/behaviour.h"
#include "behave/find_graph.h"
#include "commands/command.h"
#include "commands/graph/starter.h"
#include "disk/files.h"
#include "jobs/batch.h"
#include "open/open_model.h"
#include "text/printable.h"

namespace marrow::tools {
namespace {

constexpr const char* kHead = R"(  rankdir = LR; compound = true; nodesep = 0.25; ranksep = 0.7;
  node [fontname = "Helvetica", fontsize = 11, shape = box, style = "rounded,filled", fillcolor = "#eef2f5"];
  edge [fontname = "Helvetica", fontsize = 9, color = "#557080", arrowsize = 0.7];
)";

std::string label(const std::string& text) {
  std::string out;
  for (const char c : printable(text)) out += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return out;
}

class DotWriter {
 public:
  explicit DotWriter(const FoundGraph& found) : f_(found.file), g_(found.graph) {}

  std::string write() {
    out_ = fmt::format("digraph \"{}\" {{\n{}", label(g_.name), kHead);
    for (std::uint32_t n = 0; n < g_.nodes.size; ++n) write_node(n);
    out_ += "  output [shape = plaintext, style = \"\"];\n";
    edge("output", 0, "");
    for (std::uint32_t n = 0; n < g_.nodes.size; ++n) write_links(n);
    return out_ + "}\n";
  }

 private:
  bool is_machine(std::uint32_t n) const { return g_.nodes[n].kind == GraphNodeKind::machine; }
  std::string parameter(std::uint32_t p) const { return label(f_.text(g_.parameters[p].name)); }
  const GraphMachine& machine(std::uint32_t n) const { return g_.machines[g_.nodes[n].record]; }
  static std::string state_id(std::uint32_t n, std::uint32_t state) { return fmt::format("n{}s{}", n, state); }

  // To a node; to a machine's frame.
  void edge(const std::string& from, std::uint32_t to, const std::string& text, const std::string& style = "") {
    std::string with = text.empty() ? "" : fmt::format("label = \"{}\"", text);
    if (!style.empty()) with += (with.empty() ? "" : ", ") + style;
    if (is_machine(to)) with += (with.empty() ? "" : ", ") + fmt::format("lhead = cluster{}", to);
    out_ += fmt::format("  {} -> {}{};\n", from, is_machine(to) ? fmt::format("n{}begin", to) : fmt::format("n{}", to),
                        with.empty() ? "" : " [" + with + "]");
  }

  void write_node(std::uint32_t n) {
    const GraphNode& node = g_.nodes[n];
    if (is_machine(n)) return write_machine(n);
    const std::string name = label(f_.text(node.name));
    std::string text = name, colour = "#eef2f5";
    const auto line = [&](const std::string& more) { text += (text.empty() ? "" : "\\n") + more; };
    if (node.kind == GraphNodeKind::clip) {
      const GraphClip& clip = g_.clips[node.record];
      line(label(f_.text(clip.name)));
      if (clip.mode == static_cast<std::uint32_t>(PlayMode::once)) line("once");
      if (clip.mode == static_cast<std::uint32_t>(PlayMode::ping_pong)) line("ping-pong");
      if (clip.speed != 1) line(fmt::format("× {:g}", clip.speed));
      colour = "#fdf3dc";
    } else if (node.kind == GraphNodeKind::space) {
      const GraphSpace& space = g_.spaces[node.record];
      line("space by " + parameter(space.by[0]) + (space.by[1] == kNoIndex ? "" : ", " + parameter(space.by[1])));
      if ((space.flags & kSpaceMatchesSpeed) != 0)
        line("exactly as fast, in step");
      else if ((space.flags & kSpaceInStep) != 0)
        line("in step");
      colour = "#dff0e2";
    } else if (node.kind == GraphNodeKind::layer) {
      describe_layer(g_.layers[node.record], line);
      colour = "#e6e6f7";
    } else {
      line("given by the game");
    }
    out_ += fmt::format("  n{} [label = \"{}\", fillcolor = \"{}\"];\n", n, text, colour);
  }
  template <class Line>
  void describe_layer(const GraphLayer& layer, const Line& line) const {
    line((layer.flags & kLayerIsAdditive) != 0 ? "add" : "layer");
    if (layer.by != kNoIndex)
      line("weight " + parameter(layer.by));
    else if (layer.weight != 1)
      line(fmt::format("weight {:g}", layer.weight));
    if (layer.mask == kNoIndex) return;
    for (std::uint32_t i = 0; i < g_.masks[layer.mask].part_count; ++i) {
      const GraphMaskPart& part = g_.mask_parts[g_.masks[layer.mask].first_part + i];
      line("from " +
           (part.role != 0 ? std::string(role_name(static_cast<Role>(part.role))) : label(f_.text(part.joint))) +
           " on");
    }
  }

  void write_machine(std::uint32_t n) {
    const GraphMachine& m = machine(n);
    out_ += fmt::format(
        "  subgraph cluster{} {{\n    label = \"{}\"; fontname = \"Helvetica\"; fontsize = 11;\n"
        "    style = \"rounded,filled\"; color = \"#c3ccd4\"; fillcolor = \"#f7f9fa\";\n"
        "    n{}begin [shape = point, width = 0.12, fillcolor = \"#557080\"];\n",
        n, label(f_.text(g_.nodes[n].name)), n);
    bool has_any = false;
    for (std::uint32_t s = 0; s < m.state_count; ++s)
      out_ += fmt::format("    {} [label = \"{}\", fillcolor = \"#ffffff\"];\n", state_id(n, s),
                          label(f_.text(g_.states[m.first_state + s].name)));
    for (std::uint32_t i = 0; i < m.transition_count; ++i)
      has_any = has_any || g_.transitions[m.first_transition + i].from == kNoIndex;
    if (has_any) out_ += fmt::format("    n{}any [label = \"any state\", style = dashed];\n", n);
    for (std::uint32_t i = 0; i < m.start_count; ++i)
      out_ += fmt::format("    n{}begin -> {};\n", n, state_id(n, m.start + i));
    for (std::uint32_t i = 0; i < m.transition_count; ++i) write_transition(n, g_.transitions[m.first_transition + i]);
    out_ += "  }\n";
  }
  void write_transition(std::uint32_t n, const GraphTransition& t) {
    const std::string from = t.from == kNoIndex ? fmt::format("n{}any", n) : state_id(n, t.from);
    for (std::uint32_t i = 0; i < t.to_count; ++i)
      out_ += fmt::format("    {} -> {} [label = \"{}\", color = \"#b0562c\"];\n", from, state_id(n, t.to + i),
                          words_of(t));
  }
  std::string condition(const GraphCondition& c) const {
    constexpr const char* kSigns[] = {"", "", ">", "<", ">=", "<="};
    const std::string name = parameter(c.parameter);
    if (c.test == ConditionTest::set) return name;
    if (c.test == ConditionTest::not_set) return "not " + name;
    return fmt::format("{} {} {:g}", name, kSigns[static_cast<std::size_t>(c.test)], c.value);
  }
  std::string words_of(const GraphTransition& t) const {
    std::string out;
    const auto line = [&](const std::string& more) { out += (out.empty() ? "" : "\\n") + more; };
    for (std::uint32_t i = 0; i < t.condition_count; ++i) line(condition(g_.conditions[t.first_condition + i]));
    if (t.after_s > 0) line(fmt::format("after {:g} s", t.after_s));
    if ((t.flags & kWaitsForEnd) != 0)
      line(t.at_end_s > 0 ? fmt::format("{:g} s before the end", t.at_end_s) : "at the end");
    if (t.to_count > 1) line((t.flags & kChooseInTurn) != 0 ? "in turn" : "by chance");
    return out;
  }

  void write_links(std::uint32_t n) {
    const GraphNode& node = g_.nodes[n];
    const std::string id = fmt::format("n{}", n);
    if (node.kind == GraphNodeKind::space) {
      const GraphSpace& space = g_.spaces[node.record];
      for (std::uint32_t i = 0; i < space.point_count; ++i) {
        const GraphPoint& p = g_.points[space.first_point + i];
        edge(id, p.node,
             p.own_speed != 0          ? "at its speed"
             : space.by[1] == kNoIndex ? fmt::format("at {:g}", p.x)
                                       : fmt::format("at {:g}, {:g}", p.x, p.y));
      }
    } else if (node.kind == GraphNodeKind::layer) {
      edge(id, g_.layers[node.record].base, "base");
      edge(id, g_.layers[node.record].pose, "pose");
    } else if (node.kind == GraphNodeKind::machine) {
      for (std::uint32_t s = 0; s < machine(n).state_count; ++s)
        if (const std::uint32_t below = g_.states[machine(n).first_state + s].node; below != kNoIndex)
          edge(state_id(n, s), below, "", "style = dashed");
    }
  }

  const File& f_;
  const Graph& g_;
  std::string out_;
};

// A digraph: nodes, with what they take poses of; machines with their states and what leads from one to another.
std::string dot_text(const FoundGraph& found) {
  return DotWriter(found).write();
}

struct GraphCommandArguments {
  std::string file, name, character, output;
  std::vector<std::string> packs;
};

void print_or_write(const std::string& text, const std::string& output) {
  if (output.empty()) {
    fmt::print("{}", text);
  } else {
    write_file_atomically(output, text);
  }
}

void add_output(CLI::App* command, std::string& to, const char* type) {
  command->add_option("-o,--output", to, "write it to a file instead of stdout")->type_name(type);
}

void add_packs(CLI::App* command, std::vector<std::string>& to) {
  command->add_option("--clips", to, "also clips of this clip pack; may be given several times")
      ->type_name("PACK.mrw")
      ->allow_extra_args(false);
}

void add_new(CLI::App* command, GraphCommandArguments& a) {
  CLI::App* const starts =
      command->add_subcommand("new", "Print a graph to begin with, by what clips are called and measured to do");
  starts->add_option("character", a.character, "the cooked file, or a model")->required()->type_name("HERO.mrw");
  add_packs(starts, a.packs);
  add_output(starts, a.output, "HERO.anim.toml");
  starts->callback([&a] {
    if (!a.output.empty()) {
      expect_distinct({a.output}, {a.character});
      expect_writable(a.output);
    }
    const OpenedModel hero = open_model(a.character, Opens::models_by_graph);
    print_or_write(starter_graph(a.character, hero.file(), a.packs), a.output);
  });
}

void add_graph_file(CLI::App* command, GraphCommandArguments& a) {
  command->add_option("file", a.file, "a graph's text, or a cooked file that has one")
      ->required()
      ->type_name("FILE.toml|FILE.mrw");
  command->add_option("name", a.name, "which of several graphs of a cooked file")->type_name("NAME");
}

void add_check(CLI::App* command, GraphCommandArguments& a) {
  CLI::App* const checks = command->add_subcommand("check", "Say whether a graph is right, and fits a character");
  add_graph_file(checks, a);
  CLI::Option* const is_for =
      checks->add_option("--for", a.character, "the character that is to go by it: a cooked file, or a model")
          ->type_name("HERO.mrw");
  add_packs(checks, a.packs);
  checks->get_option("--clips")->needs(is_for);
  checks->callback([&a] {
    FoundGraph found = open_graph(a.file, a.name);
    for (const std::string& warning : found.warnings) fmt::print(stderr, "{}\n", warning);
    const Graph g = found.graph;
    if (!a.character.empty()) {
      const OpenedModel hero = open_model(a.character, Opens::models_by_graph);
      const Behaviour fits(a.character, hero.file(), std::move(found), a.packs);
    }
    fmt::print("{}: {} nodes, {} parameters, {} clips{}\n", a.file, g.nodes.size, g.parameters.size, g.clips.size,
               a.character.empty() ? "" : "; it fits " + a.character);
  });
}

void add_dot(CLI::App* command, GraphCommandArguments& a) {
  CLI::App* const draws = command->add_subcommand("dot", "Print a graph for Graphviz: marrow graph dot F | dot -Tsvg");
  add_graph_file(draws, a);
  add_output(draws, a.output, "GRAPH.dot");
  draws->callback([&a] {
    if (!a.output.empty()) {
      expect_distinct({a.output}, {a.file});
      expect_writable(a.output);
    }
    print_or_write(dot_text(open_graph(a.file, a.name)), a.output);
  });
}

}  // namespace

void add_graph(CLI::App& app, int&) {
  static GraphCommandArguments a;  // as long as the options that point at it
  CLI::App* const command = app.add_subcommand("graph", "Begin, check and draw graphs of behaviour");
  command->require_subcommand(1);
  add_new(command, a);
  add_check(command, a);
  add_dot(command, a);
}

}  // namespace marrow::tools
