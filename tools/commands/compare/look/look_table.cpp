#include "commands/compare/look/look_table.h"

#include <algorithm>

namespace marrow::tools {
namespace {

using Line = const TableLine&;
using Value = std::optional<double>;

// Of a deformer.
template <class Member>
Value of(Line l, Member member, double factor = 1) {
  return l.row != nullptr ? Value(factor * static_cast<double>(l.row->*member)) : std::nullopt;
}
// 0 is not known.
template <class Member>
Value above_0(Line l, Member member) {
  return l.row != nullptr && l.row->*member > 0 ? Value(static_cast<double>(l.row->*member)) : std::nullopt;
}
Value gpu(Line l, double VertexCost::*cost) {
  return l.row != nullptr && l.row->gpu.*cost > 0 ? Value(l.row->gpu.*cost) : std::nullopt;
}

}  // namespace

const std::vector<TableColumn> kLookColumns = {
    {"RMS, learnt from", "mm", "learnt", 9, 3, [](Line l, Line) { return of(l, &DeformerRow::train_rms, 1e3); }},
    {"RMS, held out", "mm", "held out", 9, 3, [](Line l, Line) { return of(l, &DeformerRow::held_rms, 1e3); }},
    {"of SSD's", "", "of ssd's", 9, 3,
     [](Line l, Line ssd) {
       if (l.row == nullptr) return Value();
       return Value(ssd.row->held_rms > 0 ? l.row->held_rms / ssd.row->held_rms : 1.0);
     }},
    {"largest", "mm", "largest", 9, 2, [](Line l, Line) { return of(l, &DeformerRow::held_max, 1e3); }},
    {"poses worse than SSD", "%", "worse %", 8, 1, [](Line l, Line) { return of(l, &DeformerRow::worse_share, 100); }},
    {"flipped triangles", "a pose", "flips", 8, kFlippedDecimals, [](Line l, Line) { return Value(l.look.flipped); },
     true},
    {"bend", "degrees", "bend °", 8, kBendDecimals, [](Line l, Line) { return Value(l.look.bend_deg); }, true},
    {"creases", "%", "crease %", 9, kCreasedDecimals, [](Line l, Line) { return Value(100 * l.look.creased); }, true},
    {"narrowest ring", "", "ring", 6, 2, [](Line l, Line) { return l.ring; }},
    {"jumps of SSD's", "", "jumps", 7, 2, [](Line l, Line) { return l.look.jump_of_ssd; }},
    {"volume of the truth's", "", "volume", 8, 3, [](Line l, Line) { return of(l, &DeformerRow::volume); }},
    {"sharpest edge", "degrees", "sharpest", 9, 1, [](Line l, Line) { return of(l, &DeformerRow::crease_deg); }},
    {"normals off by", "degrees", "normals", 8, 2, [](Line l, Line) { return of(l, &DeformerRow::normal_deg); }},
    {"if blended", "degrees", "blended", 8, 2, [](Line l, Line) { return of(l, &DeformerRow::blended_normal_deg); }},
};

const std::vector<TableColumn> kCostColumns = {
    {"influences", "", "influences", 11, 0, [](Line l, Line) { return above_0(l, &DeformerRow::influences); }},
    {"palette entries", "", "palette", 8, 0, [](Line l, Line) { return above_0(l, &DeformerRow::palette_entries); }},
    {"size", "bytes a vertex", "B/vertex", 9, 2,
     [](Line l, Line) { return above_0(l, &DeformerRow::bytes_per_vertex); }},
    {"displacements", "a vertex", "displaced", 10, 2,
     [](Line l, Line) { return above_0(l, &DeformerRow::displacements_per_vertex); }},
    {"time", "ns a vertex", "ns", 8, 2, [](Line l, Line) { return above_0(l, &DeformerRow::ns_per_vertex); }},
    {"instructions", "a vertex", "instr", 8, 2,
     [](Line l, Line) { return above_0(l, &DeformerRow::instructions_per_vertex); }},
    {"Mali-G57", "cycles a vertex", "Mali", 7, 0, [](Line l, Line) { return gpu(l, &VertexCost::mali_cycles); }},
    {"Adreno 660", "instructions a vertex", "Adreno", 8, 0,
     [](Line l, Line) { return gpu(l, &VertexCost::adreno_instructions); }},
    {"V3D 4.2", "instructions a vertex", "V3D", 6, 0,
     [](Line l, Line) { return gpu(l, &VertexCost::videocore_instructions); }},
};

std::vector<TableLine> table_lines(const DeformerComparison& c, const MotionStudy& motion) {
  std::vector<TableLine> out;
  for (std::size_t d = 0; d < c.rows.size(); ++d)
    out.push_back({c.rows[d].deformer, &c.rows[d], c.rows[d].look,
                   motion.of.empty() ? std::nullopt : motion.of[d].ring_over_bind});
  out.push_back({"truth", nullptr, c.truth, motion.truth_ring});
  return out;
}

const TableLine& plain_of(const std::vector<TableLine>& lines) {
  return *std::ranges::find(lines, "ssd", &TableLine::name);
}

std::vector<TableColumn> known(const std::vector<TableColumn>& columns, const std::vector<TableLine>& lines) {
  std::vector<TableColumn> out;
  for (const TableColumn& column : columns)
    if (std::ranges::any_of(lines, [&](Line l) { return column.value(l, plain_of(lines)).has_value(); }))
      out.push_back(column);
  return out;
}

bool is_uglier(const TableColumn& column, const TableLine& line, const TableLine& ssd) {
  return column.more_is_uglier && reads_more(*column.value(line, ssd), *column.value(ssd, ssd), column.decimals);
}

}  // namespace marrow::tools
