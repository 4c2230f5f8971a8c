// The page of a contact sheet: a title, rows of pictures under a strip of words, and small print below some rows.
#pragma once

#include <string>
#include <vector>

#include "image/image.h"

namespace marrow::tools {

inline constexpr int kSheetColumns = 4;
inline constexpr int kCellWidth = 305;   // of a sheet that is 1280 wide
inline constexpr int kCellHeight = 305;  // where a sheet does not choose another
inline constexpr int kCellGap = 4;
// Of each of so many cells that fill a row.
constexpr int cell_width(int columns) {
  return (kSheetColumns * kCellWidth + (kSheetColumns - columns) * kCellGap) / columns;
}

struct SheetRow {
  std::string name, about;
  std::vector<Image> cells;           // of one size; kSheetColumns that are kCellWidth wide, or fewer and wider
  std::vector<std::string> captions;  // below each cell; empty: none
  std::string right;                  // at the right end of the strip
  float ramp_m = 0;                   // instead of it the colours of distances up to this one, if it is not 0
};

struct SheetPage {
  std::string title, scene, right;  // bold; beside it; at the right edge
  std::vector<SheetRow> rows;
};

Image lay_out(const SheetPage& page);

}  // namespace marrow::tools
