#include "stage/among_figures.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "stage/recording.h"

namespace marrow::tools {
namespace {

constexpr glm::vec4 kGrid{0.02f, 0.03f, 0.04f, 0.22f}, kGridTenth{0.02f, 0.03f, 0.04f, 0.7f};
constexpr glm::vec4 kWire{0.01f, 0.02f, 0.03f, 0.75f}, kNormal{0.05f, 0.45f, 0.9f, 0.9f};
// Before the moment and after it: the colours of animators' light tables.
constexpr glm::vec3 kBefore{0.9f, 0.16f, 0.08f}, kAfter{0.05f, 0.45f, 0.12f};
constexpr float kGridReach = 2.2f;  // radii, each way from the figure

glm::vec3 at(const std::vector<float>& values, std::size_t slot) {
  return {values[3 * slot], values[3 * slot + 1], values[3 * slot + 2]};
}

std::uint32_t index(const Geometry& g, std::size_t i) {
  return g.index_bytes == 2 ? static_cast<const std::uint16_t*>(g.indices)[i]
                            : static_cast<const std::uint32_t*>(g.indices)[i];
}

// Every tenth line from the origin is darker.
void add_grid(const Shot& shot, Strokes& strokes) {
  const float square = grid_square(shot.radius), y = shot.ground_height;
  const auto nearest = [&](float at_m) { return static_cast<int>(std::lround(at_m / square)); };
  const glm::vec3 centre = shot.box.centre();
  if (std::abs(centre.x) > 1e6f * square || std::abs(centre.z) > 1e6f * square) return;
  const int reach = static_cast<int>(std::ceil(kGridReach * shot.radius / square));
  const int x0 = nearest(centre.x), z0 = nearest(centre.z);
  const auto colour = [](int line) { return line % 10 == 0 ? kGridTenth : kGrid; };
  const auto place = [&](int x, int z) {
    return glm::vec3(static_cast<float>(x) * square, y, static_cast<float>(z) * square);
  };
  for (int i = -reach; i <= reach; ++i) {
    strokes.line(place(x0 + i, z0 - reach), place(x0 + i, z0 + reach), colour(x0 + i));
    strokes.line(place(x0 - reach, z0 + i), place(x0 + reach, z0 + i), colour(z0 + i));
  }
}

// Each edge once where its two triangles name it once up and once down.
void add_wireframe(const Geometry& g, const PosedMesh& posed, Strokes& strokes) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t i = 0; i + 2 < g.index_count; i += 3)
    for (std::size_t k = 0; k < 3; ++k) edges.push_back(std::minmax({index(g, i + k), index(g, i + (k + 1) % 3)}));
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& [a, b] : edges) strokes.line(at(posed.positions, a), at(posed.positions, b), kWire);
}

void add_normals(const PosedMesh& posed, float length, Strokes& strokes) {
  for (std::size_t slot = 0; 3 * slot < posed.normals.size(); ++slot) {
    const glm::vec3 foot = at(posed.positions, slot);
    strokes.line(foot, foot + length * at(posed.normals, slot), kNormal);
  }
}

// As if of glass: its edges, seen aslant, are what shows.
void add_ghost(const Geometry& g, const PosedMesh& posed, glm::vec3 colour, float strength, const Shot& shot,
               Strokes& strokes) {
  const auto corner = [&](std::uint32_t slot) {
    const glm::vec3 place = at(posed.positions, slot);
    float facing = 0.5f;
    if (!posed.normals.empty())
      facing = std::abs(glm::dot(glm::normalize(shot.camera.position - place), at(posed.normals, slot)));
    const float edge = 1 - std::min(facing, 1.0f);
    return Strokes::Corner{place, {colour, strength * (0.03f + 0.55f * edge * edge)}};
  };
  for (std::size_t i = 0; i + 2 < g.index_count; i += 3)
    strokes.face(corner(index(g, i)), corner(index(g, i + 1)), corner(index(g, i + 2)));
}

void add_ghosts(Actor& actor, const Settings& s, const Shot& shot, Strokes& strokes) {
  const float duration_s = actor.plays()[s.clip].play.duration_s;
  if (duration_s <= 0) return;
  const float apart_s = static_cast<float>(s.overlays.ghost_step) / actor.rate_hz(s);
  for (int i = -s.overlays.ghosts; i <= s.overlays.ghosts; ++i) {
    const float time_s = clip_time(s.playback) + apart_s * static_cast<float>(i);
    if (i == 0 || time_s < 0 || time_s > duration_s) continue;
    const float strength = 1 - 0.8f * static_cast<float>(std::abs(i) - 1) / static_cast<float>(s.overlays.ghosts);
    const std::vector<PosedMesh> posed = actor.ghost(s, time_s);
    for (std::uint32_t m = 0; m < posed.size(); ++m)
      add_ghost(actor.file().mesh(m, static_cast<std::uint32_t>(actor.coarsest_lod())).geometry, posed[m],
                i < 0 ? kBefore : kAfter, strength, shot, strokes);
  }
}

constexpr glm::vec3 kWay{0.26f, 0.78f, 0.26f};
constexpr float kWayWidth = 0.018f;   // radii
constexpr float kWayStrength = 0.8f;  // of what is new
constexpr float kPiece = 0.04f;       // radii, at least: of one straight piece

// As a ribbon, which has a width on any screen, and lies under what stands on it.
void add_ribbon(const Rehearsal& rehearsal, const Shot& shot, Strokes& strokes) {
  const double now_s = rehearsal.time_s();
  const float half = 0.5f * kWayWidth * shot.radius;
  std::vector<std::pair<glm::vec3, double>> points;
  for (const Rehearsal::Place& place : rehearsal.way()) {
    if (place.at_s > now_s) break;
    const glm::vec3 at(place.at.x, shot.ground_height, place.at.z);
    if (points.size() < 2 || glm::length(at - points[points.size() - 2].first) > kPiece * shot.radius) {
      points.emplace_back(at, place.at_s);
    } else {
      points.back() = {at, place.at_s};
    }
  }
  const auto colour = [&](double at_s) {
    const auto age = static_cast<float>((now_s - at_s) / Rehearsal::kKept_s);
    return glm::vec4(kWay, kWayStrength * (1 - age) * (1 - age));
  };
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto& [from, from_s] = points[i - 1];
    const auto& [to, to_s] = points[i];
    const float length = glm::length(to - from);
    if (!(length > 0)) continue;
    const glm::vec3 side = half / length * glm::vec3(to.z - from.z, 0, from.x - to.x);
    const Strokes::Corner a{from - side, colour(from_s)}, b{from + side, colour(from_s)}, c{to + side, colour(to_s)},
        d{to - side, colour(to_s)};
    strokes.face(a, b, c);
    strokes.face(a, c, d);
  }
}

// What a character that goes by a graph leaves on the ground, up to the moment of now.
void add_way(const Rehearsal& rehearsal, const Shot& shot, Strokes& strokes) {
  add_squares(shot, {}, strokes);
  add_ribbon(rehearsal, shot, strokes);
  for (const Rehearsal::Print& print : rehearsal.prints()) {
    if (print.at_s > rehearsal.time_s()) break;
    add_print(print.print, rehearsal.time_s() - print.at_s, shot, strokes);
  }
}

}  // namespace

float grid_square(float radius) {
  return std::pow(10.0f, std::floor(std::log10(std::max(radius, 1e-20f) / 4)));
}

std::string length_of_square(float radius) {
  const double metres = static_cast<double>(grid_square(radius));
  if (metres > 0.9) return fmt::format("{:.6g} m", metres);
  return metres > 0.009 ? fmt::format("{:.3g} cm", 100 * metres) : fmt::format("{:.3g} mm", 1000 * metres);
}

void add_strokes(Actor& actor, const Settings& s, const Shot& shot, Strokes& strokes) {
  strokes.clear();
  if (s.overlays.grid) add_grid(shot, strokes);
  if (actor.rehearsal() != nullptr && s.overlays.steps) add_way(*actor.rehearsal(), shot, strokes);
  if (s.overlays.ghosts > 0) add_ghosts(actor, s, shot, strokes);
  if (!s.overlays.wireframe && !s.overlays.normals) return;
  const std::vector<PosedMesh> posed = actor.posed(s.colours == Colours::distance ? s.pair.first : s.deformer);
  for (std::uint32_t m = 0; m < posed.size(); ++m) {
    if (s.overlays.wireframe)
      add_wireframe(actor.file().mesh(m, static_cast<std::uint32_t>(s.lod)).geometry, posed[m], strokes);
    if (s.overlays.normals) add_normals(posed[m], 0.02f * shot.radius, strokes);
  }
}

}  // namespace marrow::tools
