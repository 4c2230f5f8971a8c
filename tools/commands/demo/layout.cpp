#include "commands/demo/layout.h"

#include "image/caption.h"
#include "render/legend.h"

namespace marrow::tools {
namespace {

constexpr int kEdge = 24;
constexpr int kTitleHeight = 64;
constexpr int kStripHeight = 40;    // above each row
constexpr int kCaptionHeight = 34;  // below a row that has captions
constexpr int kFooterHeight = 8;
constexpr int kWidth = 2 * kEdge + kSheetColumns * kCellWidth + (kSheetColumns - 1) * kCellGap;

constexpr Rgb kPaper = {20, 25, 31};
constexpr Rgb kBright = {236, 233, 226};
constexpr Rgb kSheetQuiet = {166, 175, 184};

float to_float(int value) {
  return static_cast<float>(value);
}

int column_x(const SheetRow& row, std::size_t column) {
  return kEdge + static_cast<int>(column) * (row.cells.front().width + kCellGap);
}

int height_of(const SheetRow& row) {
  return kStripHeight + row.cells.front().height + (row.captions.empty() ? 0 : kCaptionHeight);
}

// Text that ends at `right`.
void draw_right(Image& image, int right, int baseline, float size, Rgb colour, const std::string& text) {
  draw_text(image, to_float(right) - text_width(size, text), to_float(baseline), size, colour, text);
}

}  // namespace

Image lay_out(const SheetPage& page) {
  int height = kTitleHeight + kFooterHeight;
  for (const SheetRow& row : page.rows) height += height_of(row);
  Image image(kWidth, height, kPaper);
  const float title_end = draw_text(image, kEdge, 42, 24, kBright, page.title);
  draw_text(image, title_end + 24, 42, 14, kSheetQuiet, page.scene);
  draw_right(image, kWidth - kEdge, 42, 14, kSheetQuiet, page.right);
  int y = kTitleHeight;
  for (const SheetRow& row : page.rows) {
    const int baseline = y + kStripHeight - 14;
    const float name_end = draw_text(image, kEdge, to_float(baseline), 14, kBright, row.name);
    draw_text(image, name_end + 14, to_float(baseline), 12, kSheetQuiet, row.about);
    if (row.ramp_m > 0)
      draw_ramp(image, kWidth - kEdge, baseline, 12, kSheetQuiet, row.ramp_m);
    else
      draw_right(image, kWidth - kEdge, baseline, 12, kSheetQuiet, row.right);
    for (std::size_t column = 0; column < row.cells.size(); ++column)
      paste(image, row.cells[column], column_x(row, column), y + kStripHeight);
    y += height_of(row);
    for (std::size_t column = 0; column < row.captions.size(); ++column)
      draw_text(image, to_float(column_x(row, column)), to_float(y - kCaptionHeight + 22), 12, kSheetQuiet,
                row.captions[column]);
  }
  return image;
}

}  // namespace marrow::tools
