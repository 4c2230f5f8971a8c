// The page of a contact sheet: a title, rows of pictures under a strip of words, and small print below some rows.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "image/image.h"

namespace marrow::tools {

inline constexpr int kSheetColumns = 6;
inline constexpr int kCellWidth = 300;
inline constexpr int kCellHeight = 320;  // where a sheet does not choose another
inline constexpr int kCellGap = 4;
// Of each of so many cells that fill a row.
constexpr int cell_width(int columns) {
  return (kSheetColumns * kCellWidth + (kSheetColumns - columns) * kCellGap) / columns;
}

struct SheetRow {
  std::string name, about;
  std::vector<Image> cells;           // of one size; kSheetColumns that are kCellWidth wide, or fewer and wider
  std::vector<std::string> captions;  // below each cell; empty: none
  // Draws more at the right end of the strip, whose text stands on this line.
  std::function<void(Image& page, int right, int baseline)> strip;
};

struct SheetPage {
  std::string title, scene, right;  // bold; beside it; at the right edge
  std::vector<SheetRow> rows;
};

Image lay_out(const SheetPage& page);

inline constexpr Rgb kSheetQuiet = {146, 156, 166};

// Text that ends at `right`.
void draw_right(Image& image, int right, int baseline, float size, Rgb colour, const std::string& text);

}  // namespace marrow::tools
