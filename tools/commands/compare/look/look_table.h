// What is told of each deformer, and of the truth: columns of figures, the same on the page and on the terminal.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands/compare/motion/motion_study.h"

namespace marrow::tools {

// A deformer's line, or the truth's, of which only the look and the ring are known.
struct TableLine {
  std::string name;
  const DeformerRow* row;  // null: the truth
  const SurfaceLook& look;
  std::optional<double> ring;  // MotionRow::ring_over_bind
};
std::vector<TableLine> table_lines(const DeformerComparison& comparison, const MotionStudy& motion);

struct TableColumn {
  const char* heading;  // of the page
  const char* unit;
  const char* brief;  // of the terminal
  int width, decimals;
  std::optional<double> (*value)(const TableLine& line, const TableLine& ssd);
  bool more_is_uglier = false;
};
extern const std::vector<TableColumn> kLookColumns;  // how near, and how it looks
extern const std::vector<TableColumn> kCostColumns;

// Those of which something is known.
std::vector<TableColumn> known(const std::vector<TableColumn>& columns, const std::vector<TableLine>& lines);

const TableLine& plain_of(const std::vector<TableLine>& lines);

// Whether plain skinning's figure is lower where more is uglier, as far as the figures show.
bool is_uglier(const TableColumn& column, const TableLine& line, const TableLine& ssd);

}  // namespace marrow::tools
