#include <fmt/format.h>

#include "behave/behaviour.h"
#include "behave/open_character.h"
#include "commands/command.h"
#include "commands/graph/dot.h"
#include "commands/graph/starter.h"
#include "disk/files.h"
#include "jobs/batch.h"

namespace marrow::tools {
namespace {

struct GraphCommandArguments {
  std::string file, name, character, output;
  std::vector<std::string> packs;
};

LoadedFile hero_of(const std::string& path) {
  return std::move(open_character(path, {.takes_roots = true, .look = {}}).loaded);
}

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
    const LoadedFile hero = hero_of(a.character);
    print_or_write(starter_graph(a.character, hero.file, a.packs), a.output);
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
  CLI::Option* const hero =
      checks->add_option("--for", a.character, "the character that is to go by it: a cooked file, or a model")
          ->type_name("HERO.mrw");
  add_packs(checks, a.packs);
  checks->get_option("--clips")->needs(hero);
  checks->callback([&a] {
    FoundGraph found = open_graph(a.file, a.name);
    for (const std::string& warning : found.warnings) fmt::print(stderr, "{}\n", warning);
    const Graph g = found.graph;
    if (!a.character.empty()) {
      const LoadedFile hero = hero_of(a.character);
      const Behaviour fits(a.character, hero.file, std::move(found), a.packs);
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
