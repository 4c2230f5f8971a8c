#include "commands/demo/sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "commands/demo/layout.h"
#include "image/caption.h"
#include "render/figure.h"
#include "render/heat.h"
#include "render/performance.h"

namespace marrow::tools {
namespace {

float as_float(int value) {
  return static_cast<float>(value);
}

// One column: a moment of the clip, or a side of the rest pose.
struct Moment {
  float time_s = 0;
  float turn_rad = 0;
};

Moment moment_at(float duration_s, int column) {
  const float part = as_float(column) / kSheetColumns;
  return duration_s > 0 ? Moment{duration_s * part, 0} : Moment{0, 6.2831853f * part};
}

// Metres in a unit that reads well; models need not be in metres, which is for the reader to know.
std::string length_text(float length_m) {
  const double mm = 1e3 * static_cast<double>(length_m);
  return mm > 0 && mm < 0.001 ? fmt::format("{:.6f} mm", mm) : fmt::format("{:.4g} mm", mm);
}

struct Rows {
  std::array<std::vector<Image>, 3> cells;  // SSD, AS, difference
  float largest_m = 0;
  float full_scale_m = 0;
};

// The largest distance over all moments first: one ramp serves the whole row.
float largest_over(const File& file, Character& character, const Play& play) {
  float largest = 0;
  for (int column = 0; column < kSheetColumns; ++column) {
    character.pose(play, moment_at(play.duration_s, column).time_s);
    largest = std::max(
        largest, largest_distance(skin_all(file, character, Deformer::ssd), skin_all(file, character, Deformer::as)));
  }
  return largest;
}

Rows shoot_rows(const Gl& gl, const File& file, const Textures& textures, const Play& play) {
  Character character(file, AsNormals::tangents);
  const Performance performance(file, character, play);
  Studio studio(gl, kCellWidth, kCellHeight);
  Figure figure(gl, studio.programs(), file, &textures, AsNormals::tangents);
  Rows rows;
  rows.largest_m = largest_over(file, character, play);
  rows.full_scale_m = sensible_scale(rows.largest_m, performance.diagonal());
  for (int column = 0; column < kSheetColumns; ++column) {
    const Moment moment = moment_at(play.duration_s, column);
    character.pose(play, moment.time_s);
    const std::vector<PosedMesh> ssd = skin_all(file, character, Deformer::ssd);
    const std::vector<PosedMesh> as = skin_all(file, character, Deformer::as);
    Shot shot = performance.shot(character, as_float(kCellWidth) / kCellHeight, 0.05f, moment.turn_rad);
    shot.box = box_of(ssd);
    rows.cells[0].push_back(studio.shoot(shot, figure.on_gpu(character, Deformer::ssd)));
    rows.cells[1].push_back(studio.shoot(shot, figure.on_gpu(character, Deformer::as)));
    shot.shading = 0.25f;
    rows.cells[2].push_back(studio.shoot(shot, figure.from_cpu(ssd, compare(ssd, as, rows.full_scale_m).colours)));
  }
  return rows;
}

void draw_ramp(Image& image, int edge, int baseline, float full_scale_m) {
  constexpr int kLength = 180;
  const std::string hottest = length_text(full_scale_m);
  draw_right(image, edge, baseline, 11, kSheetQuiet, hottest);
  const int right = edge - static_cast<int>(text_width(11, hottest)) - 12;
  for (int x = 0; x < kLength; ++x) {
    const Rgb colour = heat_colour(as_float(x) / (kLength - 1));
    for (int y = baseline - 10; y <= baseline; ++y) blend(image, right - kLength + x, y, colour, 1);
  }
  draw_right(image, right - kLength - 10, baseline, 11, kSheetQuiet, "0");
}

std::string moment_text(const Moment& moment, bool moving) {
  if (moving) return fmt::format("{:.2f} s", static_cast<double>(moment.time_s));
  return fmt::format("{:.0f} deg", static_cast<double>(moment.turn_rad) * 57.29578);
}

}  // namespace

std::optional<std::uint32_t> liveliest_clip(const File& file) {
  std::optional<std::uint32_t> best;
  double most = -1;
  Character character(file);
  for (std::uint32_t clip = 0; clip < file.clip_count(); ++clip) {
    const Play play = play_together(file, clip);
    double bending = 0;
    for (int m = 0; m < kSheetColumns; ++m) {
      character.pose(play, play.duration_s * as_float(m) / kSheetColumns);
      const std::vector<PosedMesh> rigid = skin_all(file, character, Deformer::rigid);
      bending += static_cast<double>(largest_distance(rigid, skin_all(file, character, Deformer::ssd)));
    }
    // A clip that does not move is the last choice; the first of equals the best.
    if (play.duration_s <= 0) bending = -0.5;
    if (bending > most * 1.001) {
      most = bending;
      best = clip;
    }
  }
  return best;
}

Sheet make_sheet(const Gl& gl, const File& file, const Textures& textures, std::optional<std::uint32_t> clip,
                 const std::string& title) {
  const Play play = clip ? play_together(file, *clip) : Play{};
  Rows rows = shoot_rows(gl, file, textures, play);
  std::uint64_t vertices = 0, joints = 0;
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) vertices += file.mesh(i).geometry.vertex_count;
  for (std::uint32_t i = 0; i < file.skeleton_count(); ++i) joints += file.skeleton(i).joint_count;

  SheetPage page;
  page.title = title;
  page.scene = clip ? fmt::format("clip \"{}\", {:.2f} s", file.clip(*clip).name, static_cast<double>(play.duration_s))
                    : std::string("rest pose");
  page.right = fmt::format("{} joints   {} vertices", joints, vertices);
  page.rows = {
      {"SSD", "skeletal subspace deformation, by the vertex shader", std::move(rows.cells[0]), {}},
      {"AS", "animation space, by the vertex shader", std::move(rows.cells[1]), {}},
      {"Difference", "largest distance between SSD and AS: " + length_text(rows.largest_m), std::move(rows.cells[2]),
       [&](Image& image, int right, int baseline) { draw_ramp(image, right, baseline, rows.full_scale_m); }}};
  for (int column = 0; column < kSheetColumns; ++column)
    page.columns.push_back(moment_text(moment_at(play.duration_s, column), play.duration_s > 0));
  return {lay_out(page), rows.largest_m};
}

}  // namespace marrow::tools
