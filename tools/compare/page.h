// A comparison as one self-contained page: its pictures, charts (SVG), and the columns of figures, which are the same
// on the terminal.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/measure.h"
#include "compare/motion_study.h"
#include "compare/pictures.h"
#include "compare/verdict.h"
#include "text/html.h"

namespace marrow::tools {

// What a page is made of. title: what was compared. truth: its name.
struct PageContent {
  std::string title, truth;
  const Study& study;
  const DeformerComparison& comparison;
  const MotionStudy& motion;
  const Verdict& verdict;
  std::vector<PictureRow> worst_poses, worst_joints;
};
std::string comparison_page(const PageContent& content);

// Shapes above, and below each how far it is from the truth.
std::string picture_row(const PictureRow& row);

// A key and a chart a clip, of the first round; empty if there is nothing to draw. Lines that would flatten the others
// are hidden until the page's script shows them.
std::string charts(const Study& study, const DeformerComparison& comparison);

// The range of motion as a part of the page. What stands below the pictures of the worst joints: a table of deformers,
// one of joints for each of them, and the poses in which the truth folds.
std::string motion_tables(const Study& study, const DeformerComparison& comparison, const MotionStudy& motion);

// What is told of each deformer. A deformer's line, or the truth's, of which only the look and the ring are known.
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
