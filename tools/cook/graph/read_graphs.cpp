#include "cook/graph/build_graph.h"

#include <algorithm>
#include <set>

#include "text/nearest.h"

namespace marrow::cook {
namespace {

void warn_of_missing(const BuiltGraph& graph, const std::string& file, const std::vector<BuiltClip>& clips,
                     Notes& notes) {
  std::vector<std::string> names;
  for (const BuiltClip& clip : clips) names.push_back(clip.name);
  for (const std::string& name : std::set<std::string>(graph.clip_names.begin(), graph.clip_names.end())) {
    if (std::ranges::find(names, name) != names.end()) continue;
    const std::string meant = tools::did_you_mean(name, names);
    notes.warnings.push_back(
        {file, "no-such-clip",
         "no clip here is called \"" + name + "\": " + (meant.empty() ? "it must come from a clip pack" : meant)});
  }
}

// Several of them would stand at one place, 0 m/s.
void warn_of_still(const BuiltGraph& graph, const std::string& file, const std::vector<BuiltClip>& clips,
                   Notes& notes) {
  std::set<std::string> still;
  for (const GraphPoint& p : graph.points) {
    if (p.own_speed == 0) continue;
    const std::string& name = graph.clip_names[graph.nodes[p.node].record];
    const auto clip = std::ranges::find(clips, name, &BuiltClip::name);
    if (clip != clips.end() && clip->motion.speed_m_s == 0) still.insert(name);
  }
  for (const std::string& name : still)
    notes.warnings.push_back({file, "no-speed",
                              "\"" + name +
                                  "\" moves at 0 m/s, and stands in a space at its own speed: give its point "
                                  "at = …, or the character roles of feet"});
}

}  // namespace

std::vector<BuiltGraph> build_graphs(const std::vector<GraphRule>& rules, Notes& notes) {
  std::vector<BuiltGraph> out;
  for (const GraphRule& rule : rules) out.push_back(build_graph(parse_graph(rule.file, rule.text), notes));
  return out;
}

void warn_of_clips(const std::vector<GraphRule>& rules, const std::vector<BuiltGraph>& graphs,
                   const std::vector<BuiltClip>& clips, Notes& notes) {
  for (std::size_t g = 0; g < graphs.size(); ++g) {
    warn_of_missing(graphs[g], rules[g].file, clips, notes);
    warn_of_still(graphs[g], rules[g].file, clips, notes);
  }
}

}  // namespace marrow::cook
