// A contact sheet: a character by plain skinning, by animation space, and how far these are apart: from near by where
// plain skinning is worst, and as a whole at four moments of that clip.
#pragma once

#include <string>
#include <vector>

#include "commands/demo/timings.h"
#include "commands/demo/worst_place.h"
#include "image/image.h"
#include "render/gl.h"
#include "render/textures.h"

namespace marrow::tools {

// Who is shown. title: what the file is called.
struct Subject {
  const File& file;
  PlainSkin& plain;
  const Textures& textures;
  std::string title;
  Timings timings;
};

struct Sheet {
  Image image;
  float largest_m = 0;  // between the two at the moments shown, scene units
};

// Its name, or as --clip takes one without a name: its number.
std::string name_of_clip(const File& file, std::uint32_t clip);

// All clips of the name of the worst place's play, one a skeleton. Without a clip the rest pose is shown from four
// sides.
Sheet make_sheet(const Gl& gl, const Subject& subject, const WorstPlace& worst);

// How a sheet is laid out: rows of cells, with words about them.
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
