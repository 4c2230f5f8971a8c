#include "commands/demo/zoom.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace marrow::tools {
namespace {

constexpr float kLeastWeight = 0.05f;  // of a joint that counts
constexpr double kSharpness = 4;       // of a vertex's weight for the middle: the power of its distance
constexpr float kDeviations = 2;       // from the middle to the edge
// Shares of the character's radius: how much of it is seen at least, and how far from the worst vertex.
constexpr float kLeastSeen = 0.16f, kMostSeen = 0.32f;
constexpr float kMargin = 0.08f;
constexpr std::array<float, 3> kPitches = {0.21f, 0.75f, -0.3f};  // radians
constexpr int kYaws = 8;
// The usual side stays if it shows this share of what the best side shows.
constexpr float kNearlyAsGood = 0.7f;

glm::vec3 vertex(const std::vector<PosedMesh>& posed, const Farthest& place) {
  const float* const at = posed[place.mesh].positions.data() + 3 * place.slot;
  return {at[0], at[1], at[2]};
}

glm::vec3 place_of(const Affine& joint) {
  return {joint.rows[0][3], joint.rows[1][3], joint.rows[2][3]};
}

// What belongs into the picture: a ball round the middle of the difference near its worst place, which vertices that
// are far apart weigh most for.
std::vector<glm::vec3> region(const std::vector<PosedMesh>& a, const std::vector<PosedMesh>& b, const Farthest& place,
                              float radius) {
  const glm::vec3 worst = vertex(a, place);
  double weights = 0, spread = 0;
  glm::dvec3 sum(0);
  for (std::uint32_t mesh = 0; mesh < a.size(); ++mesh) {
    for (std::size_t slot = 0; 3 * slot < a[mesh].positions.size(); ++slot) {
      const glm::vec3 p = vertex(a, {mesh, slot, 0}), q = vertex(b, {mesh, slot, 0});
      const glm::dvec3 away = 0.5f * (p + q) - worst;
      if (glm::length(away) > static_cast<double>(kMostSeen * radius)) continue;
      const double weight = std::pow(static_cast<double>(glm::length(p - q) / place.distance), kSharpness);
      weights += weight;
      sum += weight * away;
      spread += weight * glm::dot(away, away);
    }
  }
  const glm::dvec3 middle = sum / weights;
  const double deviation = std::sqrt(std::max(0.0, spread / weights - glm::dot(middle, middle)));
  const float seen = std::clamp(kDeviations * static_cast<float>(deviation), kLeastSeen * radius, kMostSeen * radius);
  std::vector<glm::vec3> points;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.0f, 1.0f}) {
      glm::vec3 p = worst + glm::vec3(middle);
      p[axis] += sign * seen;
      points.push_back(p);
    }
  }
  return points;
}

// How much of a heat map's picture glows, most of all in its middle: red, amber and yellow have far more red than blue,
// all else has not.
float glow(const Image& image) {
  constexpr int kLeastGlow = 40;
  const float middle_x = 0.5f * static_cast<float>(image.width), middle_y = 0.5f * static_cast<float>(image.height);
  float sum = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* const rgb = image.pixel(x, y);
      const float away = std::hypot(static_cast<float>(x) - middle_x, static_cast<float>(y) - middle_y) / middle_y;
      sum += static_cast<float>(std::max(0, rgb[0] - rgb[2] - kLeastGlow)) * std::max(0.0f, 1 - away);
    }
  }
  return sum;
}

}  // namespace

std::string joint_about(const File& file, const Character& character, const Farthest& place) {
  if (place.mesh >= file.mesh_count()) return "";
  const Mesh mesh = file.mesh(place.mesh);
  PosedMesh posed;
  character.skin(place.mesh, Deformer::ssd, posed);
  const glm::vec3 at = vertex({posed}, {0, place.slot, 0});
  std::optional<std::uint32_t> best;
  float nearest = 0;
  for (std::uint32_t entry = 0; entry < mesh.joint_count; ++entry) {
    const std::uint32_t joint = mesh.joints[entry];
    if (joint_weights(mesh, joint)[place.slot] < kLeastWeight) continue;
    const float distance = glm::length(place_of(character.scene_from_joint(mesh.skeleton)[joint]) - at);
    if (best && distance >= nearest) continue;
    best = joint;
    nearest = distance;
  }
  if (!best) return "";
  const std::string name = file.text(file.skeleton(mesh.skeleton).names[*best]);
  return name.empty() ? std::to_string(*best) : name;
}

Zoom shoot_zoom(Studio& studio, Figure& figure, const Performance& performance, const File& file, Character& character,
                const Play& play, const WorstMoment& worst, float aspect, float full_scale_m) {
  character.pose(play, worst.time_s);
  const std::vector<PosedMesh> ssd = skin_all(file, character, Deformer::ssd);
  const std::vector<PosedMesh> as = skin_all(file, character, Deformer::as);
  const std::vector<glm::vec3> points = region(ssd, as, worst.place, performance.radius());
  const std::vector<std::vector<float>> heat = compare(ssd, as, full_scale_m).colours;
  const auto shot_from = [&](const Orbit& side) {
    const Orbit orbit = orbit_round(points, aspect, kMargin, side);
    Shot shot = performance.shot_by(camera_on(orbit, aspect, performance.radius()));
    shot.box = box_of(ssd);
    shot.light_turn_rad = side.yaw - Orbit().yaw;
    return shot;
  };
  const auto heat_picture = [&](Shot shot) {
    shot.shading = kHeatShading;
    return studio.shoot(shot, figure.from_cpu(ssd, heat));
  };
  Orbit side;
  const float usual = glow(heat_picture(shot_from(side)));
  float best = usual / kNearlyAsGood;
  for (const float pitch : kPitches) {
    for (int i = 0; i < kYaws; ++i) {
      Orbit other;
      other.yaw += 6.2831853f * static_cast<float>(i) / kYaws;
      other.pitch = pitch;
      const float seen = glow(heat_picture(shot_from(other)));
      if (seen <= best) continue;
      best = seen;
      side = other;
    }
  }
  const Shot shot = shot_from(side);
  Zoom out;
  out.joint = joint_about(file, character, worst.place);
  out.cells.push_back(studio.shoot(shot, figure.on_gpu(character, Deformer::ssd)));
  out.cells.push_back(studio.shoot(shot, figure.on_gpu(character, Deformer::as)));
  out.cells.push_back(heat_picture(shot));
  return out;
}

}  // namespace marrow::tools
