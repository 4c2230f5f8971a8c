#include "commands/demo/scenery.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "common/check_status.h"
#include "disk/cook_on_disk.h"

namespace marrow::tools {
namespace {

constexpr float kTurn = 6.2831853f;
constexpr float kFireflyRadius = 0.032f;
constexpr float kFreshPrint = 0.52f, kOldPrint = 0.30f;  // how dark
constexpr float kPrintLasts_s = 5, kPrintFades_s = 1.5f;
const glm::vec3 kLight{1.0f, 0.72f, 0.22f};

// A sphere of triangles that are about alike: an octahedron, each triangle of it in four, so many times.
cook::RawPrimitive sphere(int times) {
  cook::RawPrimitive out;
  out.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  out.indices = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  for (int t = 0; t < times; ++t) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), out.positions.size());
      if (is_new) out.positions.push_back(glm::normalize(out.positions[a] + out.positions[b]));
      return found->second;
    };
    std::vector<std::uint32_t> finer;
    for (std::size_t i = 0; i < out.indices.size(); i += 3) {
      const std::uint32_t a = out.indices[i], b = out.indices[i + 1], c = out.indices[i + 2];
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
    }
    out.indices = std::move(finer);
  }
  return out;
}

// Of its triangles' areas, as the surface is smooth.
void add_normals(cook::RawPrimitive& to) {
  to.normals.assign(to.positions.size(), glm::vec3(0));
  for (std::size_t i = 0; i < to.indices.size(); i += 3) {
    const std::uint32_t a = to.indices[i], b = to.indices[i + 1], c = to.indices[i + 2];
    const glm::vec3 area = glm::cross(to.positions[b] - to.positions[a], to.positions[c] - to.positions[a]);
    for (const std::uint32_t v : {a, b, c}) to.normals[v] += area;
  }
  for (glm::vec3& normal : to.normals) normal = glm::normalize(normal);
}

// Worn round, with dents and a flat side on the ground.
cook::RawScene stone_scene(const Story& story) {
  cook::RawPrimitive stone = sphere(4);
  for (glm::vec3& p : stone.positions) {
    const glm::vec3 d = p;
    const float lumps = 1 + 0.07f * std::sin(3.1f * d.x + 1.3f) * std::cos(2.3f * d.z + 0.4f) +
                        0.05f * std::sin(5.3f * d.y + 4.1f * d.x) + 0.02f * std::sin(11 * d.z + 7 * d.y + 3 * d.x);
    p = d * lumps * glm::vec3(story.stone_radius * 1.12f, story.stone_height, story.stone_radius * 0.85f);
    p.y = std::max(0.86f * p.y + 0.14f * story.stone_height, -0.005f);
    p += story.stone;
  }
  add_normals(stone);
  return prop_scene(std::move(stone), {0.21f, 0.22f, 0.24f});
}

cook::RawScene firefly_scene() {
  cook::RawPrimitive body = sphere(3);
  body.normals = body.positions;
  for (glm::vec3& p : body.positions) p *= kFireflyRadius;
  return prop_scene(std::move(body), kLight, 4.0f * kLight);
}

// A round patch that fades towards its edge. right, up: from its middle to its edge.
void add_glow(const glm::vec3& at, const glm::vec3& right, const glm::vec3& up, float strength, Strokes& strokes) {
  constexpr int kRings = 6, kParts = 28;
  const auto corner = [&](int ring, int part) {
    const float r = static_cast<float>(ring) / kRings, angle = kTurn * static_cast<float>(part) / kParts;
    const float fall = 1 - r * r;
    return Strokes::Corner{at + r * (std::cos(angle) * right + std::sin(angle) * up),
                           glm::vec4(kLight, strength * fall * fall * fall)};
  };
  for (int ring = 0; ring < kRings; ++ring)
    for (int part = 0; part < kParts; ++part) {
      const Strokes::Corner a = corner(ring, part), b = corner(ring, part + 1), c = corner(ring + 1, part + 1),
                            d = corner(ring + 1, part);
      strokes.face(a, b, c);
      strokes.face(a, c, d);
    }
}

// An ellipse on the ground with a soft edge. along, across: its half axes.
void add_dent(const glm::vec3& at, const glm::vec3& along, const glm::vec3& across, float strength, Strokes& strokes) {
  constexpr int kParts = 18;
  constexpr float kSoft = 0.72f;
  const auto corner = [&](float r, int part) {
    const float angle = kTurn * static_cast<float>(part) / kParts;
    return Strokes::Corner{at + r * (std::cos(angle) * along + std::sin(angle) * across),
                           glm::vec4(0.012f, 0.016f, 0.022f, r < 1 ? strength : 0)};
  };
  for (int part = 0; part < kParts; ++part) {
    const Strokes::Corner middle{at, corner(0, 0).colour}, a = corner(kSoft, part), b = corner(kSoft, part + 1),
                                                           c = corner(1, part + 1), d = corner(1, part);
    strokes.face(middle, a, b);
    strokes.face(a, d, c);
    strokes.face(a, c, b);
  }
}

// A sole and three toes, as the newt's feet have them.
void add_print(const Print& print, float strength, Strokes& strokes) {
  const glm::vec3 ahead(std::sin(print.heading_rad), 0, std::cos(print.heading_rad)), side(ahead.z, 0, -ahead.x);
  const auto on = [&](float forward, float sideways) { return print.at + forward * ahead + sideways * side; };
  add_dent(on(-0.055f, 0), 0.085f * ahead, 0.045f * side, strength, strokes);
  for (const float toe : {-1.0f, 0.0f, 1.0f}) {
    const glm::vec3 along = glm::normalize(ahead + 0.45f * toe * side);
    add_dent(on(0.070f - 0.016f * std::abs(toe), 0.048f * toe), 0.040f * along,
             0.021f * glm::vec3(along.z, 0, -along.x), strength, strokes);
  }
}

cook::CookOptions raw() {
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  return options;
}

}  // namespace

Scenery::Scenery(const Gl& gl, gles3::ProgramSet& programs, const Story& story)
    : story_(story), stone_(gl, programs, stone_scene(story)), firefly_(gl, programs, firefly_scene()) {}

std::vector<Drawable> Scenery::drawables(std::size_t moment) {
  std::vector<Drawable> out = stone_.drawables();
  for (const Drawable& d : firefly_.drawables_at(story_.steps[moment].firefly)) out.push_back(d);
  return out;
}

void Scenery::draw(std::size_t moment, const Camera& camera, Strokes& strokes) const {
  strokes.clear();
  for (const Print& print : story_.prints) {
    // Those of the round before go on.
    const std::size_t since = moment >= print.from ? moment : moment + story_.steps.size();
    const float age_s = static_cast<float>(since - print.from) / kStoryFps;
    const float left = std::clamp((kPrintLasts_s + kPrintFades_s - age_s) / kPrintFades_s, 0.0f, 1.0f);
    const float fresh = std::exp(-0.7f * age_s);
    if (left > 0) add_print(print, left * (kOldPrint + (kFreshPrint - kOldPrint) * fresh), strokes);
  }
  const glm::vec3 at = story_.steps[moment].firefly;
  // On the ground below it, the wider and weaker the higher it is; and round it.
  const float wide = 0.30f + 0.35f * at.y, flicker = 1 + 0.12f * std::sin(0.9f * static_cast<float>(moment));
  add_glow({at.x, 0.001f, at.z}, {wide, 0, 0}, {0, 0, wide}, 0.16f * flicker / (0.4f + at.y), strokes);
  const glm::vec3 back = glm::normalize(camera.position - at);
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), back)), up = glm::cross(back, right);
  add_glow(at, 0.085f * right, 0.085f * up, 0.75f * flicker, strokes);
  add_glow(at, 0.24f * right, 0.24f * up, 0.22f * flicker, strokes);
}

cook::RawScene prop_scene(cook::RawPrimitive primitive, const glm::vec3& colour, const glm::vec3& glow) {
  primitive.pointer = "/meshes/0/primitives/0";
  primitive.material = 0;
  cook::RawScene scene;
  scene.source = "prop";
  scene.nodes.emplace_back().name = "prop";
  cook::RawMaterial& material = scene.materials.emplace_back();
  material.base_colour = glm::vec4(colour, 1);
  material.emissive = glow;
  scene.meshes.push_back({"prop", {}, {std::move(primitive)}});
  cook::RawInstance& instance = scene.instances.emplace_back();
  instance.node = instance.mesh = 0;
  return scene;
}

Prop::Prop(const Gl& gl, gles3::ProgramSet& programs, const cook::RawScene& scene)
    : bytes_(cook::cook_scene(scene, raw()).file) {
  check(load({bytes_.data(), bytes_.size()}, file_));
  figure_ = std::make_unique<Figure>(gl, programs, file_);
  posed_ = skin_all(file_, Character(file_), Deformer::ssd);
}

std::vector<Drawable> Prop::drawables_at(const glm::vec3& place) {
  moved_ = posed_;
  for (PosedMesh& mesh : moved_)
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) mesh.positions[i] += place[static_cast<int>(i % 3)];
  return figure_->from_cpu(moved_);
}

}  // namespace marrow::tools
