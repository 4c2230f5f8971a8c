#include "cook/write/write_graph.h"

#include "graph/graph_section.h"

namespace marrow::cook {

Section write_graph(const BuiltGraph& g, Names& names) {
  Section out;
  const auto count = [](const auto& records) { return static_cast<std::uint32_t>(records.size()); };
  const auto named = [&](auto records, const std::vector<std::string>& texts) {
    for (std::size_t i = 0; i < records.size(); ++i) records[i].name = names.add(texts[i]);
    return records;
  };
  std::vector<GraphMaskPart> parts = g.mask_parts;
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i].joint = names.add(g.part_joints[i]);
  const auto l = out.begin(format::GraphHeader{names.add(g.name), count(g.parameters), count(g.nodes), count(g.clips),
                                               count(g.spaces), count(g.points), count(g.triangles), count(g.machines),
                                               count(g.states), count(g.transitions), count(g.conditions),
                                               count(g.layers), count(g.masks), count(g.mask_parts), g.given_count});
  out.set(l.parameters, named(g.parameters, g.parameter_names));
  out.set(l.nodes, named(g.nodes, g.node_names));
  out.set(l.clips, named(g.clips, g.clip_names));
  out.set(l.spaces, g.spaces);
  out.set(l.points, g.points);
  out.set(l.triangles, g.triangles);
  out.set(l.machines, g.machines);
  out.set(l.states, named(g.states, g.state_names));
  out.set(l.transitions, g.transitions);
  out.set(l.conditions, g.conditions);
  out.set(l.layers, g.layers);
  out.set(l.masks, g.masks);
  out.set(l.parts, parts);
  return out;
}

}  // namespace marrow::cook
