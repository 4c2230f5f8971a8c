// The page of a contact sheet: a title, rows of six pictures under a strip of words, and small print below the columns.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "image/image.h"

namespace marrow::tools {

inline constexpr int kSheetColumns = 6;
inline constexpr int kCellWidth = 300;
inline constexpr int kCellHeight = 320;  // where a sheet does not choose another

struct SheetRow {
  std::string name, about;
  std::vector<Image> cells;  // kSheetColumns of them, kCellWidth wide and of one height
  // Draws more at the right end of the strip, whose text stands on this line.
  std::function<void(Image& page, int right, int baseline)> strip;
};

struct SheetPage {
  std::string title, scene, right;  // bold; beside it; at the right edge
  std::vector<SheetRow> rows;
  std::vector<std::string> columns;  // below each
};

Image lay_out(const SheetPage& page);

inline constexpr Rgb kSheetQuiet = {146, 156, 166};

// Text that ends at `right`.
void draw_right(Image& image, int right, int baseline, float size, Rgb colour, const std::string& text);

}  // namespace marrow::tools
