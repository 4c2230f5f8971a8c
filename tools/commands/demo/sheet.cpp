#include "commands/demo/sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "image/caption.h"
#include "render/figure.h"
#include "render/heat.h"
#include "render/performance.h"
#include "text/printable.h"
#include "text/quantity.h"

namespace marrow::tools {
namespace {

constexpr int kLeastHeight = 180, kMostHeight = 330;  // of cells, pixels
constexpr int kCloseUps = 3, kCloseUpHeight = 360;
constexpr float kCellMargin = 0.05f, kCloseUpMargin = 0.04f;  // of their sides

float as_float(int value) {
  return static_cast<float>(value);
}

// One column: a moment of the clip, or a side of the rest pose.
struct Moment {
  float time_s = 0;
  float turn_rad = 0;
};
using Moments = std::array<Moment, kSheetColumns>;

// The worst moment is one of them.
Moments moments_of(float duration_s, float worst_s) {
  Moments out;
  for (int i = 0; i < kSheetColumns; ++i) {
    const float part = as_float(i) / kSheetColumns;
    Moment& moment = out[static_cast<std::size_t>(i)];
    if (duration_s > 0)
      moment.time_s = std::fmod(worst_s, duration_s / kSheetColumns) + part * duration_s;
    else
      moment.turn_rad = 6.2831853f * part;
  }
  return out;
}

// A moment by both deformers.
struct Both {
  std::vector<PosedMesh> plain, as;
};

Both skin_both(const Subject& subject, const Character& posed) {
  return {subject.plain.skin(posed), skin_all(subject.file, posed, Deformer::as)};
}

struct Cells {
  Image plain, as, difference;
};

// What takes the pictures, and of whom.
struct Stand {
  Studio& studio;
  Figure& figure;
  float full_scale_m;

  Cells shoot(Shot shot, const Character& character, const Both& both) const {
    shot.box = box_of(both.as);
    shot.ground_height = shot.box.min.y;  // feet stand on it at each moment
    Cells out;
    out.plain = studio.shoot(shot, figure.from_cpu(both.plain));
    out.as = studio.shoot(shot, figure.on_gpu(character, Deformer::as));
    shot.shading = kHeatShading;
    out.difference = studio.shoot(shot, figure.from_cpu(both.as, compare(both.as, both.plain, full_scale_m).colours));
    return out;
  }
};

struct Rows {
  std::array<std::vector<Image>, 3> cells;  // plain, animation space, difference
  std::vector<Image> close_ups;             // the same; empty where there is nothing to see
  float largest_m = 0, worst_m = 0;         // of all moments, and of the worst one
  float full_scale_m = 0;
  Moments moments;
};

// From where each moment is drawn: all from one distance, as near as one shape of cells allows.
struct Framing {
  std::array<Orbit, kSheetColumns> orbits;
  int cell_height = kCellHeight;
  float aspect() const { return as_float(kCellWidth) / as_float(cell_height); }
};

// What the character is at one moment: as tall as it ever is, so that the ground stays put.
std::vector<glm::vec3> framed_points(const std::vector<PosedMesh>& posed, float tallest) {
  std::vector<glm::vec3> out;
  for (const PosedMesh& mesh : posed)
    for (std::size_t i = 0; i + 2 < mesh.positions.size(); i += 3)
      out.emplace_back(mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]);
  const Box box = box_of(posed);
  out.emplace_back(box.centre().x, box.min.y, box.centre().z);
  out.emplace_back(box.centre().x, box.min.y + tallest, box.centre().z);
  return out;
}

// Width over height of what a camera on that side sees.
float shape_of(const std::vector<glm::vec3>& points, const Orbit& side) {
  Box box;
  for (const glm::vec3& p : points) box.add({glm::dot(p, right_of(side)), glm::dot(p, up_of(side)), 0});
  const glm::vec3 size = box.max - box.min;
  return size.x / std::max(size.y, 1e-20f);
}

// yaw: of the worst place's side, which all are seen from.
Framing frame_moments(const std::vector<Both>& shown, const Moments& moments, float yaw) {
  float tallest = 0;
  for (const Both& both : shown) tallest = std::max(tallest, box_of(both.as).max.y - box_of(both.as).min.y);
  Framing out;
  std::vector<std::vector<glm::vec3>> points;
  float widest = 0;
  for (std::size_t column = 0; column < kSheetColumns; ++column) {
    points.push_back(framed_points(shown[column].as, tallest));
    out.orbits[column].yaw = yaw + moments[column].turn_rad;
    widest = std::max(widest, shape_of(points.back(), out.orbits[column]));
  }
  const float height = as_float(kCellWidth) / std::max(widest, 1e-3f);
  out.cell_height = static_cast<int>(std::clamp(height, as_float(kLeastHeight), as_float(kMostHeight)));
  float distance = 0;
  for (std::size_t column = 0; column < kSheetColumns; ++column) {
    out.orbits[column] = orbit_round(points[column], out.aspect(), kCellMargin, out.orbits[column]);
    distance = std::max(distance, out.orbits[column].distance);
  }
  for (Orbit& orbit : out.orbits) orbit.distance = distance;
  return out;
}

std::vector<Image> shoot_close_ups(const Stand& stand, const Performance& performance, const Character& character,
                                   const Both& both, const WorstPlace& worst) {
  const float aspect = as_float(cell_width(kCloseUps)) / as_float(kCloseUpHeight);
  const Orbit orbit = orbit_round(framed(worst.part), aspect, kCloseUpMargin, worst.side);
  Shot shot = performance.shot_by(camera_on(orbit, aspect, performance.radius()));
  shot.light_turn_rad = worst.side.yaw - Orbit().yaw;
  Cells cells = stand.shoot(shot, character, both);
  return {std::move(cells.plain), std::move(cells.as), std::move(cells.difference)};
}

Rows shoot_rows(const Gl& gl, const Subject& subject, const WorstPlace& worst) {
  const Play play = worst.clip ? play_together(subject.file, *worst.clip) : Play{};
  Character character(subject.file);
  const Performance performance(subject.file, character, play);
  Rows rows;
  rows.moments = moments_of(play.duration_s, worst.time_s);
  std::vector<Both> shown;
  for (const Moment& moment : rows.moments) {
    character.pose(play, moment.time_s);
    shown.push_back(skin_both(subject, character));
    rows.largest_m = std::max(rows.largest_m, largest_distance(shown.back().plain, shown.back().as));
  }
  rows.full_scale_m = sensible_scale(rows.largest_m, performance.diagonal());
  const Framing framing = frame_moments(shown, rows.moments, worst.side.yaw);
  Studio studio(gl, kCellWidth, framing.cell_height);
  Figure figure(gl, studio.programs(), subject.file, &subject.textures);
  const Stand stand{studio, figure, rows.full_scale_m};
  for (std::size_t column = 0; column < kSheetColumns; ++column) {
    character.pose(play, rows.moments[column].time_s);
    const Camera camera = camera_on(framing.orbits[column], framing.aspect(), performance.radius());
    Shot shot = performance.shot_by(camera);
    shot.light_turn_rad = worst.side.yaw - Orbit().yaw;
    Cells cells = stand.shoot(shot, character, shown[column]);
    rows.cells[0].push_back(std::move(cells.plain));
    rows.cells[1].push_back(std::move(cells.as));
    rows.cells[2].push_back(std::move(cells.difference));
  }
  if (worst.joint.empty() || shows_nothing(rows.largest_m, rows.full_scale_m)) return rows;
  studio.resize(cell_width(kCloseUps), kCloseUpHeight);
  character.pose(play, worst.time_s);
  const Both both = skin_both(subject, character);
  rows.worst_m = largest_distance(both.plain, both.as);
  rows.close_ups = shoot_close_ups(stand, performance, character, both, worst);
  return rows;
}

std::string moment_text(const Moment& moment, bool moving) {
  if (moving) return plain_number(static_cast<double>(moment.time_s), 2) + " s";
  return fmt::format("{:.0f} deg", static_cast<double>(moment.turn_rad) * 57.29578);
}

std::uint64_t vertices_of(const File& file) {
  std::uint64_t out = 0;
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) out += file.mesh(i).geometry.vertex_count;
  return out;
}

// What a frame pays: matrices that go up, and time.
std::string cost_text(const File& file, double us) {
  std::size_t joints = 0, helpers = 0;
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) {
    joints += file.mesh(i).joint_count;
    helpers += file.mesh(i).helpers.size;
  }
  const std::string of_these = helpers > 0 ? fmt::format(", {} of them helpers", helpers) : "";
  return fmt::format("{} palette entries{};  {:.1f} ns a vertex on this CPU", joints + helpers, of_these,
                     1e3 * us / static_cast<double>(std::max<std::uint64_t>(1, vertices_of(file))));
}

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

std::string name_of_clip(const File& file, std::uint32_t clip) {
  const std::string name = file.clip(clip).name;
  return name.empty() ? std::to_string(clip) : name;
}

Sheet make_sheet(const Gl& gl, const Subject& subject, const WorstPlace& worst) {
  Rows rows = shoot_rows(gl, subject, worst);
  const bool moving = rows.moments[1].time_s > rows.moments[0].time_s;
  std::uint64_t joints = 0;
  for (std::uint32_t i = 0; i < subject.file.skeleton_count(); ++i) joints += subject.file.skeleton(i).joint_count;
  SheetPage page;
  page.title = subject.title;
  page.scene = worst.clip ? fmt::format("clip \"{}\"", name_of_clip(subject.file, *worst.clip)) : "rest pose";
  page.right = fmt::format("{} joints   {} vertices", joints, vertices_of(subject.file));
  const bool differs = !shows_nothing(rows.largest_m, rows.full_scale_m);
  const std::string largest = length_text(static_cast<double>(rows.largest_m));
  if (!rows.close_ups.empty())
    page.rows.push_back(
        {"Where plain skinning is worst",
         fmt::format("about {}, at {} s", printable(worst.joint), plain_number(static_cast<double>(worst.time_s), 2)),
         std::move(rows.close_ups),
         {"plain skinning", "Marrow", "difference: up to " + length_text(static_cast<double>(rows.worst_m))},
         "",
         0});
  page.rows.push_back({"Plain skinning",
                       "linear blend over the joints, as any engine draws it",
                       std::move(rows.cells[0]),
                       {},
                       cost_text(subject.plain.file(), subject.timings.plain_us),
                       0});
  page.rows.push_back(
      {"Marrow", "animation space", std::move(rows.cells[1]), {}, cost_text(subject.file, subject.timings.as_us), 0});
  page.rows.push_back({"Difference",
                       "how far the two are apart: up to " + largest,
                       std::move(rows.cells[2]),
                       {},
                       "",
                       differs ? rows.full_scale_m : 0.0f});
  for (const Moment& moment : rows.moments) page.rows.back().captions.push_back(moment_text(moment, moving));
  return {lay_out(page), rows.largest_m};
}

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
