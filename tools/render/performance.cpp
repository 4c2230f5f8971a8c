#include "render/performance.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "pose/worn.h"

namespace marrow::tools {
namespace {

constexpr int kMoments = 16;    // of a clip
constexpr float kFarthest = 2;  // radii
constexpr int kMostMoments = 128;
constexpr std::size_t kPointsPerMoment = 4000;
constexpr float kBands = 64;  // a radius, on a turntable
constexpr int kSides = 32;    // likewise

glm::vec3 point(const PosedMesh& mesh, std::size_t slot) {
  return {mesh.positions[3 * slot], mesh.positions[3 * slot + 1], mesh.positions[3 * slot + 2]};
}

Box box_of(const std::vector<glm::vec3>& points) {
  Box box;
  for (const glm::vec3& p : points) box.add(p);
  return box;
}

}  // namespace

std::vector<PosedMesh> skin_all(const File& file, const Character& character, Deformer deformer) {
  std::vector<PosedMesh> posed(file.mesh_count());
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) character.skin(i, deformer, posed[i]);
  for (const std::shared_ptr<Worn>& worn : character.worn())
    for (PosedMesh& mesh : skin_all(worn->loaded.file, *worn->character, deformer)) posed.push_back(std::move(mesh));
  return posed;
}

Box box_of(const std::vector<PosedMesh>& posed) {
  Box box;
  for (const PosedMesh& mesh : posed) {
    for (std::size_t slot = 0; 3 * slot < mesh.positions.size(); ++slot) box.add(point(mesh, slot));
  }
  if (box.empty()) box.add(glm::vec3(0));
  return box;
}

// The mean of all joints on the ground plane: steadier than the middle of a box with waving arms.
glm::vec3 Performance::anchor(const Character& character) const {
  glm::dvec3 sum(0);
  double count = 0;
  for (std::uint32_t i = 0; i < file_.skeleton_count(); ++i) {
    for (const Affine& joint : character.model_from_joint(i)) {
      sum += glm::dvec3(static_cast<double>(joint.rows[0][3]), 0, static_cast<double>(joint.rows[2][3]));
      count += 1;
    }
  }
  return count > 0 ? glm::vec3(sum / count) : glm::vec3(0);
}

Performance::Performance(const File& file, Character& character, const Play& play) : file_(file) {
  const Moments moments{play.duration_s, [&](float time_s) { character.pose(play, time_s); }};
  look(character, moments, play.duration_s > 0 ? kMoments : 1);
  keep_points(way_.radius() > 0.5f * radius_);
}

Performance::Performance(const File& file, Character& character, const Moments& moments) : file_(file) {
  look(character, moments, std::clamp(static_cast<int>(kMomentsPerSecond * moments.duration_s) + 1, 1, kMostMoments));
  ground_height_ = first_lowest_;
  keep_points(moments.follows.value_or(way_.radius() > kFarthest * radius_));
}

void Performance::look(Character& character, const Moments& moments, int count) {
  character.pose({}, 0);
  diagonal_ = 2 * box_of(skin_all(file_, character, Deformer::ssd)).radius();
  duration_s_ = moments.duration_s;
  Box ground;
  radius_ = 0;
  for (int m = 0; m < count; ++m) {
    moments.pose(duration_s_ * static_cast<float>(m) / static_cast<float>(count));
    const std::vector<PosedMesh> posed = skin_all(file_, character, Deformer::ssd);
    const Box box = box_of(posed);
    ground.add(box.min);
    if (m == 0) first_lowest_ = box.min.y;
    radius_ = std::max(radius_, box.radius());
    anchors_.push_back(anchor(character));
    way_.add(anchors_.back());
    std::size_t slots = 0;
    for (const PosedMesh& mesh : posed) slots += mesh.positions.size() / 3;
    const std::size_t stride = std::max<std::size_t>(1, slots / kPointsPerMoment);
    std::vector<glm::vec3>& kept = moved_.emplace_back();
    for (const PosedMesh& mesh : posed) {
      for (std::size_t slot = 0; 3 * slot < mesh.positions.size(); slot += stride) kept.push_back(point(mesh, slot));
    }
    if (kept.empty()) kept.push_back(box.centre());
  }
  ground_height_ = ground.min.y;
  radius_ = std::max(radius_, 1e-20f);
}

void Performance::keep_points(bool follows) {
  follows_ = follows;
  for (std::size_t m = 0; m < moved_.size(); ++m) {
    for (const glm::vec3& p : moved_[m]) points_.push_back(follows_ ? p - anchors_[m] : p);
  }
  moved_.clear();
}

Shot Performance::shot(const Character& character, float aspect, float margin, float turn_rad) const {
  return shot_by(moved(frame_points(points_, aspect, margin, turn_rad), followed(character)));
}

Shot Performance::shot_from(const Orbit& side, const Character& character, float aspect, float margin) const {
  return shot_by(moved(frame_points_from(side, points_, aspect, margin), followed(character)));
}

Shot Performance::shot_by(const Camera& camera) const {
  Shot shot;
  shot.camera = camera;
  shot.radius = radius_;
  shot.ground_height = ground_height_;
  return shot;
}

Box Performance::box(const Character& character) const {
  Box box = box_of(points_);
  box.min += followed(character);
  box.max += followed(character);
  return box;
}

Shot Performance::turned_shot(const Character& character, float aspect, float margin, float turn_rad,
                              const Orbit& side) const {
  // What a point passes on its way round; of near-by points the outermost are enough.
  const glm::vec3 axis = box_of(points_).centre();
  std::map<int, glm::vec2> widest;  // by height: how far from the axis, and how high
  for (const glm::vec3& p : points_) {
    const float away = glm::length(glm::vec2(p.x - axis.x, p.z - axis.z));
    const int band = static_cast<int>(std::floor(kBands * (p.y - axis.y) / radius_));
    const auto [at, is_new] = widest.try_emplace(band, away, p.y);
    if (away > at->second.x) at->second = {away, p.y};
  }
  std::vector<glm::vec3> swept;
  for (const auto& [band, profile] : widest) {
    for (int i = 0; i < kSides; ++i) {
      const float angle = 6.2831853f * static_cast<float>(i) / kSides;
      swept.emplace_back(axis.x + profile.x * std::cos(angle), profile.y, axis.z + profile.x * std::sin(angle));
    }
  }
  Shot shot =
      shot_by(moved(turned(frame_points_from(side, swept, aspect, margin), axis, turn_rad), followed(character)));
  shot.light_turn_rad = turn_rad;
  return shot;
}

}  // namespace marrow::tools
