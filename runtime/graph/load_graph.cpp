// GRPH sections: the view of one that keeps its rules, and what is in it by name.
#include <cstring>

#include "asset/checker.h"
#include "core/check.h"
#include "core/zone.h"
#include "graph/graph_fault.h"
#include "graph/graph_section.h"
#include "marrow/graph.h"

namespace marrow {
namespace {

Graph view(const format::GraphHeader& h, const format::GraphLayout& l) {
  Graph g;
  g.parameters = l.parameters.in(&h);
  g.nodes = l.nodes.in(&h);
  g.clips = l.clips.in(&h);
  g.spaces = l.spaces.in(&h);
  g.points = l.points.in(&h);
  g.triangles = l.triangles.in(&h);
  g.machines = l.machines.in(&h);
  g.states = l.states.in(&h);
  g.transitions = l.transitions.in(&h);
  g.conditions = l.conditions.in(&h);
  g.layers = l.layers.in(&h);
  g.masks = l.masks.in(&h);
  g.mask_parts = l.parts.in(&h);
  g.given_count = h.given_count;
  return g;
}

}  // namespace

Status File::graph(std::uint32_t index, Graph& out, DataError* error) const {
  MARROW_ZONE;
  if (error != nullptr) *error = {Status::bad_argument, 0, "an index below graph_count()"};
  MARROW_REQUIRE(index < graph_count());
  const Span<const std::byte> block(block_, reinterpret_cast<const format::Header*>(block_)->file_bytes);
  Checker checker(block, sections_, first_, counts_);
  const auto& h = *reinterpret_cast<const format::GraphHeader*>(section(format::kGraphs, index));
  format::GraphLayout l;
  Graph made;
  if (checker.begin(sections_[first_[format::kGraphs] + index], sizeof h, format::kCodecRaw) &&
      check_fields(checker, h, l)) {
    made = view(h, l);
    made.name = text(h.name);
    const GraphFault fault = find_fault(made);
    if (fault.rule != nullptr) checker.fail(fault.where != nullptr ? fault.where : &h, fault.rule);
  }
  if (error != nullptr) *error = checker.error();
  if (!checker.good()) return checker.error().status;
  out = made;
  return Status::ok;
}

}  // namespace marrow
