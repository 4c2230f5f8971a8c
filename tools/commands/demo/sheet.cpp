#include "commands/demo/sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "commands/demo/layout.h"
#include "commands/demo/zoom.h"
#include "render/figure.h"
#include "render/heat.h"
#include "render/legend.h"
#include "render/performance.h"
#include "text/quantity.h"

namespace marrow::tools {
namespace {

constexpr int kLeastHeight = 200, kMostHeight = 440;  // of cells, pixels
constexpr int kZoomHeight = 440;                      // of the worst joint's
constexpr float kCellMargin = 0.05f;                  // of their sides

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

struct Rows {
  std::array<std::vector<Image>, 3> cells;  // SSD, AS, difference
  WorstMoment worst;
  float full_scale_m = 0;
  Zoom zoom;  // without cells where there is nothing to see

  float largest_m() const { return worst.place.distance; }
};

// From where each moment is drawn: all from one distance, as near as one shape of cells allows.
struct Framing {
  std::array<Orbit, kSheetColumns> orbits;
  int cell_height = kCellHeight;
  float aspect() const { return as_float(kCellWidth) / as_float(cell_height); }
};

// What the character is at one moment: how high and low it ever is belongs to it, so that the ground stays put.
std::vector<glm::vec3> framed_points(const std::vector<PosedMesh>& posed, float low, float high) {
  std::vector<glm::vec3> out;
  for (const PosedMesh& mesh : posed)
    for (std::size_t i = 0; i + 2 < mesh.positions.size(); i += 3)
      out.emplace_back(mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]);
  const glm::vec3 centre = box_of(posed).centre();
  out.emplace_back(centre.x, low, centre.z);
  out.emplace_back(centre.x, high, centre.z);
  return out;
}

// Width over height of what a camera on that side sees.
float shape_of(const std::vector<glm::vec3>& points, const Orbit& side) {
  Box box;
  for (const glm::vec3& p : points) box.add({glm::dot(p, right_of(side)), glm::dot(p, up_of(side)), 0});
  const glm::vec3 size = box.max - box.min;
  return size.x / std::max(size.y, 1e-20f);
}

Framing frame_moments(const File& file, Character& character, const Play& play) {
  std::vector<std::vector<PosedMesh>> moments;
  Box all;
  for (int column = 0; column < kSheetColumns; ++column) {
    character.pose(play, moment_at(play.duration_s, column).time_s);
    moments.push_back(skin_all(file, character, Deformer::ssd));
    const Box box = box_of(moments.back());
    all.add(box.min);
    all.add(box.max);
  }
  Framing out;
  std::vector<std::vector<glm::vec3>> points;
  float widest = 0;
  for (std::size_t column = 0; column < kSheetColumns; ++column) {
    points.push_back(framed_points(moments[column], all.min.y, all.max.y));
    out.orbits[column].yaw += moment_at(play.duration_s, static_cast<int>(column)).turn_rad;
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

// The largest distance over all moments first: one ramp serves the whole row.
WorstMoment worst_of(const File& file, Character& character, const Play& play) {
  WorstMoment worst;
  for (int column = 0; column < kSheetColumns; ++column) {
    const float time_s = moment_at(play.duration_s, column).time_s;
    character.pose(play, time_s);
    const Farthest place = farthest(skin_all(file, character, Deformer::ssd), skin_all(file, character, Deformer::as));
    if (place.distance > worst.place.distance) worst = {time_s, place};
  }
  return worst;
}

Rows shoot_rows(const Gl& gl, const File& file, const Textures& textures, const Play& play) {
  Character character(file, AsNormals::tangents);
  const Performance performance(file, character, play);
  const Framing framing = frame_moments(file, character, play);
  Studio studio(gl, kCellWidth, framing.cell_height);
  Figure figure(gl, studio.programs(), file, &textures, AsNormals::tangents);
  Rows rows;
  rows.worst = worst_of(file, character, play);
  rows.full_scale_m = sensible_scale(rows.largest_m(), performance.diagonal());
  for (int column = 0; column < kSheetColumns; ++column) {
    const Moment moment = moment_at(play.duration_s, column);
    character.pose(play, moment.time_s);
    const std::vector<PosedMesh> ssd = skin_all(file, character, Deformer::ssd);
    const std::vector<PosedMesh> as = skin_all(file, character, Deformer::as);
    const Orbit& orbit = framing.orbits[static_cast<std::size_t>(column)];
    Shot shot = performance.shot_by(camera_on(orbit, framing.aspect(), performance.radius()));
    shot.box = box_of(ssd);
    rows.cells[0].push_back(studio.shoot(shot, figure.on_gpu(character, Deformer::ssd)));
    rows.cells[1].push_back(studio.shoot(shot, figure.on_gpu(character, Deformer::as)));
    shot.shading = kHeatShading;
    rows.cells[2].push_back(studio.shoot(shot, figure.from_cpu(ssd, compare(ssd, as, rows.full_scale_m).colours)));
  }
  if (shows_nothing(rows.largest_m(), rows.full_scale_m)) return rows;
  studio.resize(cell_width(kZoomColumns), kZoomHeight);
  const float aspect = as_float(cell_width(kZoomColumns)) / as_float(kZoomHeight);
  rows.zoom = shoot_zoom(studio, figure, performance, file, character, play, rows.worst, aspect, rows.full_scale_m);
  return rows;
}

std::string moment_text(const Moment& moment, bool moving) {
  if (moving) return plain_number(static_cast<double>(moment.time_s), 2) + " s";
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

std::string name_of_clip(const File& file, std::uint32_t clip) {
  const std::string name = file.clip(clip).name;
  return name.empty() ? std::to_string(clip) : name;
}

Sheet make_sheet(const Gl& gl, const File& file, const Textures& textures, std::optional<std::uint32_t> clip,
                 const std::string& title) {
  const Play play = clip ? play_together(file, *clip) : Play{};
  Rows rows = shoot_rows(gl, file, textures, play);
  std::uint64_t vertices = 0, joints = 0;
  bool helped = false;  // then SSD's weights are over helpers, too, and its elbows are better than without
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) {
    vertices += file.mesh(i).geometry.vertex_count;
    helped = helped || file.mesh(i).helpers.size > 0;
  }
  for (std::uint32_t i = 0; i < file.skeleton_count(); ++i) joints += file.skeleton(i).joint_count;

  SheetPage page;
  page.title = title;
  page.scene = clip ? fmt::format("clip \"{}\", {} s", name_of_clip(file, *clip),
                                  plain_number(static_cast<double>(play.duration_s)))
                    : std::string("rest pose");
  page.right = fmt::format("{} joints   {} vertices", joints, vertices);
  const bool differs = !shows_nothing(rows.largest_m(), rows.full_scale_m);
  const std::string largest = length_text(static_cast<double>(rows.largest_m()));
  const std::string ssd = helped ? "over the same joints and helpers, by the vertex shader" : "by the vertex shader";
  page.rows = {{"SSD", "skeletal subspace deformation, " + ssd, std::move(rows.cells[0]), {}, {}},
               {"AS", "animation space, by the vertex shader", std::move(rows.cells[1]), {}, {}},
               {"Difference",
                "largest distance between SSD and AS: " + largest,
                std::move(rows.cells[2]),
                {},
                [&](Image& image, int right, int baseline) {
                  if (differs) draw_ramp(image, right, baseline, 11, kSheetQuiet, rows.full_scale_m);
                }}};
  for (int column = 0; column < kSheetColumns; ++column)
    page.rows.back().captions.push_back(moment_text(moment_at(play.duration_s, column), play.duration_s > 0));
  if (differs)
    page.rows.push_back({"Worst joint",
                         fmt::format("{}, {} apart at {} s", rows.zoom.joint, largest,
                                     plain_number(static_cast<double>(rows.worst.time_s), 2)),
                         std::move(rows.zoom.cells),
                         {"SSD", "AS", "difference"},
                         {}});
  return {lay_out(page), rows.largest_m(), rows.zoom.joint};
}

}  // namespace marrow::tools
