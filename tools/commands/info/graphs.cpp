#include "commands/info/graphs.h"

#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "asset/format.h"
#include "behave/find_graph.h"
#include "text/printable.h"
#include "text/quantity.h"

namespace marrow::tools {
namespace {

using nlohmann::ordered_json;

ordered_json describe_parameter(const File& file, const GraphParameter& p) {
  const char* const name = file.text(p.name);
  switch (p.kind) {
    case ParameterKind::number:
      return {{"name", name},
              {"type", "number"},
              {"range", {p.least, p.most}},
              {"initial", p.initial},
              {"half_life_s", p.seconds}};
    case ParameterKind::flag:
      return {{"name", name}, {"type", "flag"}, {"initial", p.initial > 0.5f}};
    case ParameterKind::trigger:
      break;
  }
  return {{"name", name}, {"type", "trigger"}, {"hold_s", p.seconds}};
}

ordered_json describe_graph(const File& file, const Graph& graph, std::size_t bytes) {
  ordered_json parameters = ordered_json::array(), clips = ordered_json::array();
  for (const GraphParameter& p : graph.parameters) parameters.push_back(describe_parameter(file, p));
  std::set<std::string> there, wanted;
  for (std::uint32_t c = 0; c < file.clip_count(); ++c) there.insert(file.clip(c).name);
  for (const GraphClip& clip : graph.clips) {
    const std::string name = file.text(clip.name);
    if (wanted.insert(name).second) clips.push_back({{"name", name}, {"in_file", there.contains(name)}});
  }
  return {{"name", graph.name},
          {"bytes", bytes},
          {"nodes", graph.nodes.size},
          {"parameters", parameters},
          {"clips", clips}};
}

std::string number(const ordered_json& value) {
  return plain_number(value.get<double>());
}

void print_parameter(const ordered_json& p, std::size_t width) {
  const std::string type = p["type"].get<std::string>();
  std::string words = type;
  if (type == "number") {
    words +=
        fmt::format(" from {} to {}, {} at first", number(p["range"][0]), number(p["range"][1]), number(p["initial"]));
    if (p["half_life_s"] != 0.0) words += fmt::format(", half of the way in {} s", number(p["half_life_s"]));
  } else if (type == "flag") {
    words += p["initial"].get<bool>() ? ", set at first" : "";
  } else if (p["hold_s"] != 0.0) {
    words += fmt::format(", waits {} s", number(p["hold_s"]));
  }
  fmt::print("  {:<{}}  {}\n", printable(p["name"].get<std::string>()), width, words);
}

}  // namespace

void describe_graphs(const std::string& path, const LoadedFile& loaded, ordered_json& description) {
  std::vector<std::size_t> bytes;
  for (const File::Section& s : loaded.stored)
    if (s.type == format::kTypes[format::kGraphs]) bytes.push_back(s.bytes);
  ordered_json graphs = ordered_json::array();
  for (const Graph& graph : graphs_of(path, loaded.file))
    graphs.push_back(describe_graph(loaded.file, graph, bytes.at(graphs.size())));
  description["graphs"] = graphs;
}

void print_graphs(const ordered_json& description) {
  for (const ordered_json& g : description["graphs"]) {
    fmt::print("graph \"{}\": {} bytes, {} nodes\n", printable(g["name"].get<std::string>()),
               g["bytes"].get<std::size_t>(), g["nodes"].get<std::size_t>());
    std::size_t width = 0;
    for (const ordered_json& p : g["parameters"])
      width = std::max(width, printable(p["name"].get<std::string>()).size());
    for (const ordered_json& p : g["parameters"]) print_parameter(p, width);
    std::vector<std::string> there, elsewhere;
    for (const ordered_json& clip : g["clips"])
      (clip["in_file"].get<bool>() ? there : elsewhere).push_back(printable(clip["name"].get<std::string>()));
    if (!there.empty()) fmt::print("  clips: {}\n", fmt::join(there, ", "));
    if (!elsewhere.empty()) fmt::print("  clips of other files: {}\n", fmt::join(elsewhere, ", "));
  }
}

}  // namespace marrow::tools
