#include "demo/sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "render/caption.h"
#include "render/figure.h"
#include "render/heat.h"
#include "render/performance.h"

namespace marrow::tools {
namespace {

constexpr int kMoments = 6;
constexpr int kCellWidth = 300;
constexpr int kCellHeight = 320;
constexpr int kGap = 4;
constexpr int kEdge = 28;
constexpr int kTitleHeight = 76;
constexpr int kStripHeight = 42;  // above each row
constexpr int kFooterHeight = 40;
constexpr int kWidth = 2 * kEdge + kMoments * kCellWidth + (kMoments - 1) * kGap;
constexpr int kHeight = kTitleHeight + 3 * (kStripHeight + kCellHeight) + kFooterHeight;

constexpr Rgb kPaper = {20, 25, 31};
constexpr Rgb kBright = {236, 233, 226};
constexpr Rgb kQuiet = {146, 156, 166};

float as_float(int value) {
  return static_cast<float>(value);
}

// One column: a moment of the clip, or a side of the rest pose.
struct Moment {
  float time_s = 0;
  float turn_rad = 0;
};

Moment moment_at(float duration_s, int column) {
  const float part = as_float(column) / kMoments;
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
  for (int column = 0; column < kMoments; ++column) {
    character.pose(play, moment_at(play.duration_s, column).time_s);
    largest = std::max(
        largest, largest_distance(skin_all(file, character, Deformer::ssd), skin_all(file, character, Deformer::as)));
  }
  return largest;
}

Rows shoot_rows(const Gl& gl, const File& file, const Play& play) {
  Character character(file, AsNormals::tangents);
  const Performance performance(file, character, play);
  Figure figure(gl, file, nullptr, AsNormals::tangents);
  Studio studio(gl, kCellWidth, kCellHeight);
  Rows rows;
  rows.largest_m = largest_over(file, character, play);
  rows.full_scale_m = sensible_scale(rows.largest_m, performance.diagonal());
  for (int column = 0; column < kMoments; ++column) {
    const Moment moment = moment_at(play.duration_s, column);
    character.pose(play, moment.time_s);
    const std::vector<PosedMesh> ssd = skin_all(file, character, Deformer::ssd);
    const std::vector<PosedMesh> as = skin_all(file, character, Deformer::as);
    Shot shot = performance.shot(character, as_float(kCellWidth) / kCellHeight, 0.05f, moment.turn_rad);
    shot.palettes = &figure.palettes();
    shot.box = box_of(ssd);
    rows.cells[0].push_back(studio.shoot(shot, figure.on_gpu(character, Deformer::ssd)));
    rows.cells[1].push_back(studio.shoot(shot, figure.on_gpu(character, Deformer::as)));
    shot.shading = 0.25f;
    rows.cells[2].push_back(studio.shoot(shot, figure.from_cpu(ssd, compare(ssd, as, rows.full_scale_m).colours)));
  }
  return rows;
}

void draw_right(Image& image, int right, int y, float size, Rgb colour, const std::string& text) {
  draw_text(image, as_float(right) - text_width(size, text), as_float(y), size, colour, text);
}

// The strip above a row: what it is, and something about it at the right.
void draw_strip(Image& image, int baseline, const char* name, const std::string& about, const std::string& right) {
  const float end = draw_text(image, kEdge, as_float(baseline), 13, kBright, name);
  draw_text(image, end + 14, as_float(baseline), 11, kQuiet, about);
  if (!right.empty()) draw_right(image, kWidth - kEdge, baseline, 11, kQuiet, right);
}

void draw_ramp(Image& image, int baseline, float full_scale_m) {
  constexpr int kLength = 180;
  const std::string hottest = length_text(full_scale_m);
  draw_right(image, kWidth - kEdge, baseline, 11, kQuiet, hottest);
  const int right = kWidth - kEdge - static_cast<int>(text_width(11, hottest)) - 12;
  for (int x = 0; x < kLength; ++x) {
    const Rgb colour = heat_colour(as_float(x) / (kLength - 1));
    for (int y = baseline - 10; y <= baseline; ++y) blend(image, right - kLength + x, y, colour, 1);
  }
  draw_right(image, right - kLength - 10, baseline, 11, kQuiet, "0");
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
    for (int m = 0; m < kMoments; ++m) {
      character.pose(play, play.duration_s * as_float(m) / kMoments);
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

Sheet make_sheet(const Gl& gl, const File& file, std::optional<std::uint32_t> clip, const std::string& title) {
  const Play play = clip ? play_together(file, *clip) : Play{};
  const Rows rows = shoot_rows(gl, file, play);
  std::uint64_t vertices = 0, joints = 0;
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) vertices += file.mesh(i).geometry.vertex_count;
  for (std::uint32_t i = 0; i < file.skeleton_count(); ++i) joints += file.skeleton(i).joint_count;

  Sheet sheet{Image(kWidth, kHeight, kPaper), rows.largest_m};
  Image& image = sheet.image;
  const float title_end = draw_text(image, kEdge, 50, 24, kBright, title);
  const std::string scene =
      clip ? fmt::format("clip \"{}\", {:.2f} s", file.clip(*clip).name, static_cast<double>(play.duration_s))
           : std::string("rest pose");
  draw_text(image, title_end + 24, 50, 13, kQuiet, scene);
  draw_right(image, kWidth - kEdge, 50, 13, kQuiet, fmt::format("{} joints   {} vertices", joints, vertices));

  int y = kTitleHeight;
  for (std::size_t row = 0; row < 3; ++row) {
    const int baseline = y + kStripHeight - 14;
    if (row == 0) draw_strip(image, baseline, "SSD", "skeletal subspace deformation, by the vertex shader", "");
    if (row == 1) draw_strip(image, baseline, "AS", "animation space, by the vertex shader", "");
    if (row == 2) {
      draw_strip(image, baseline, "Difference", "largest distance between SSD and AS: " + length_text(rows.largest_m),
                 "");
      draw_ramp(image, baseline, rows.full_scale_m);
    }
    y += kStripHeight;
    for (int column = 0; column < kMoments; ++column) {
      paste(image, rows.cells[row][static_cast<std::size_t>(column)], kEdge + column * (kCellWidth + kGap), y);
    }
    y += kCellHeight;
  }
  for (int column = 0; column < kMoments; ++column) {
    const float x = as_float(kEdge + column * (kCellWidth + kGap));
    draw_text(image, x, as_float(y + 24), 11, kQuiet,
              moment_text(moment_at(play.duration_s, column), play.duration_s > 0));
  }
  return sheet;
}

}  // namespace marrow::tools
