#include "commands/demo/worst_place.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <map>

#include <glm/geometric.hpp>

#include "common/failure.h"
#include "common/vertex_order.h"
#include "disk/cook_on_disk.h"
#include "render/heat.h"
#include "render/performance.h"

namespace marrow::tools {
namespace {

constexpr std::size_t kMoments = 16, kLeastMoments = 4, kMostMoments = 400;  // a clip; of all clips
constexpr float kStill = 0.02f;  // of the radius: a clip in which nothing moves farther stands still
constexpr float kLeastWeight = 0.05f, kMostWeight = 0.95f;  // of one joint, where skin bends
constexpr std::size_t kCandidates = 6;
constexpr float kLeastLoss = 1e-3f;  // of a place's area, to be a candidate
// Shares of the character's radius: how much of it is seen about the joint.
constexpr float kLeastSeen = 0.2f, kMostSeen = 0.34f;
constexpr float kDeviations = 2.2f;  // from the middle to the edge

constexpr std::uint32_t kNoPlace = 0xFFFFFFFF;

glm::vec3 vertex(const PosedMesh& mesh, std::size_t slot) {
  return {mesh.positions[3 * slot], mesh.positions[3 * slot + 1], mesh.positions[3 * slot + 2]};
}

float area(const PosedMesh& mesh, const std::uint32_t* corners) {
  const glm::vec3 a = vertex(mesh, corners[0]);
  return 0.5f * glm::length(glm::cross(vertex(mesh, corners[1]) - a, vertex(mesh, corners[2]) - a));
}

// The skin about a joint.
struct Place {
  std::uint32_t skeleton = 0, joint = 0;
  float area = 0;  // at rest
};

struct Triangle {
  std::uint32_t mesh, corners[3], place;
};

// Triangles where skin bends, each at the joint that is nearest at rest of those that its first corner follows.
struct Bends {
  std::vector<Place> places;
  std::vector<Triangle> triangles;
};

// A slot: the joint about which it bends.
std::vector<std::uint32_t> joints_of_slots(const Mesh& mesh, const PosedMesh& rest, std::span<const Affine> joints) {
  const std::size_t slots = rest.positions.size() / 3;
  std::vector<std::uint32_t> out(slots, kNoPlace);
  std::vector<float> nearest(slots, 0), most(slots, 0);
  for (std::uint32_t entry = 0; entry < mesh.joint_count; ++entry) {
    const std::uint32_t joint = mesh.joints[entry];
    const std::vector<float> weights = joint_weights(mesh, joint);
    const Affine& at = joints[joint];
    const glm::vec3 place = {at.rows[0][3], at.rows[1][3], at.rows[2][3]};
    for (std::size_t slot = 0; slot < slots; ++slot) {
      most[slot] = std::max(most[slot], weights[slot]);
      if (weights[slot] < kLeastWeight) continue;
      const float distance = glm::length(vertex(rest, slot) - place);
      if (out[slot] != kNoPlace && distance >= nearest[slot]) continue;
      out[slot] = joint;
      nearest[slot] = distance;
    }
  }
  for (std::size_t slot = 0; slot < slots; ++slot)
    if (most[slot] > kMostWeight) out[slot] = kNoPlace;
  return out;
}

Bends find_bends(const File& file, Character& character) {
  character.pose({}, 0);
  const std::vector<PosedMesh> rest = skin_all(file, character, Deformer::as);
  std::vector<std::vector<std::uint32_t>> place_of;  // a skeleton and joint
  for (std::uint32_t s = 0; s < file.skeleton_count(); ++s)
    place_of.emplace_back(file.skeleton(s).joint_count, kNoPlace);
  Bends out;
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    const Mesh mesh = file.mesh(m);
    const std::vector<std::uint32_t> joints = joints_of_slots(mesh, rest[m], character.model_from_joint(mesh.skeleton));
    const Geometry& g = mesh.geometry;
    for (std::uint32_t i = 0; i + 2 < g.index_count; i += 3) {
      Triangle t = {m, {index_at(g, i), index_at(g, i + 1), index_at(g, i + 2)}, 0};
      const std::uint32_t joint = joints[t.corners[0]];
      if (joint == kNoPlace) continue;
      std::uint32_t& place = place_of[mesh.skeleton][joint];
      if (place == kNoPlace) {
        place = static_cast<std::uint32_t>(out.places.size());
        out.places.push_back({mesh.skeleton, joint, 0});
      }
      t.place = place;
      out.places[place].area += area(rest[m], t.corners);
      out.triangles.push_back(t);
    }
  }
  return out;
}

// Where and when a joint is worst.
struct Candidate {
  std::uint32_t place = 0, clip = 0;
  float time_s = 0;
  float score = 0;
};

// What triangles lose of their area, a place.
std::vector<float> losses(const Bends& bends, const std::vector<PosedMesh>& plain, const std::vector<PosedMesh>& as) {
  std::vector<float> out(bends.places.size(), 0);
  for (const Triangle& t : bends.triangles)
    out[t.place] += std::max(0.0f, area(as[t.mesh], t.corners) - area(plain[t.mesh], t.corners));
  return out;
}

// A clip's worst moment of each place. Returns whether it moves.
bool judge_clip(const File& file, Character& character, PlainSkin& plain, const Bends& bends, std::uint32_t clip,
                std::size_t moments, std::vector<Candidate>& worst) {
  const Play play = play_together(file, clip);
  std::vector<PosedMesh> first;
  float moved = 0, radius = 0;
  for (std::size_t m = 0; m < moments; ++m) {
    const float time_s = play.duration_s * static_cast<float>(m) / static_cast<float>(moments);
    character.pose(play, time_s);
    const std::vector<PosedMesh> as = skin_all(file, character, Deformer::as);
    const std::vector<float> lost = losses(bends, plain.skin(character), as);
    for (std::uint32_t p = 0; p < lost.size(); ++p) {
      if (!(lost[p] > kLeastLoss * bends.places[p].area)) continue;
      // Half by how much is lost, half by its share: a wrist is small.
      const float score = lost[p] / std::sqrt(bends.places[p].area);
      if (score > worst[p].score) worst[p] = {p, clip, time_s, score};
    }
    if (m == 0) {
      first = as;
      radius = box_of(as).radius();
    } else {
      moved = std::max(moved, largest_distance(first, as));
    }
  }
  return moved >= kStill * radius;
}

// The middle of what a joint's skin differs in, and how far that reaches.
Part part_of(const Bends& bends, std::uint32_t place, const std::vector<PosedMesh>& plain,
             const std::vector<PosedMesh>& as, float radius) {
  glm::dvec3 sum(0);
  double weights = 0, squares = 0;
  const Triangle* const origin = &*std::ranges::find(bends.triangles, place, &Triangle::place);
  const glm::vec3 from = vertex(as[origin->mesh], origin->corners[0]);
  for (const Triangle& t : bends.triangles) {
    if (t.place != place) continue;
    const glm::vec3 at = vertex(as[t.mesh], t.corners[0]), off = vertex(plain[t.mesh], t.corners[0]);
    const double weight = static_cast<double>(glm::length(at - off) * area(as[t.mesh], t.corners));
    const glm::dvec3 away = at - from;
    sum += weight * away;
    squares += weight * glm::dot(away, away);
    weights += weight;
  }
  if (!(weights > 0)) return {from, kLeastSeen * radius};
  const glm::dvec3 middle = sum / weights;
  const auto deviation = static_cast<float>(std::sqrt(std::max(0.0, squares / weights - glm::dot(middle, middle))));
  return {from + glm::vec3(middle), std::clamp(kDeviations * deviation, kLeastSeen * radius, kMostSeen * radius)};
}

// What tells a primitive's vertices apart: their place, their place in the texture and their normal, to the bit.
using Key = std::array<std::uint32_t, 9>;

Key key_of(std::uint32_t primitive, const Geometry& g, const float* block, std::size_t slot) {
  Key key = {primitive};
  const std::size_t lane = slot % 4;
  for (std::size_t c = 0; c < 3; ++c) key[1 + c] = std::bit_cast<std::uint32_t>(block[4 * c + lane]);
  for (std::size_t c = 0; c < 2 && g.uvs != nullptr; ++c)
    key[4 + c] = std::bit_cast<std::uint32_t>(g.uvs[2 * slot + c]);
  for (std::size_t c = 0; c < 3 && g.normals != nullptr; ++c)
    key[6 + c] = std::bit_cast<std::uint32_t>(g.normals[12 * (slot / 4) + 4 * c + lane]);
  return key;
}

// Calls with the key of each slot of a geometry.
template <class Visit>
void visit_slots(std::uint32_t primitive, const Geometry& g, const Visit& visit) {
  const float* block = g.skin;
  std::uint32_t slot = 0;
  for (const Run& run : g.runs) {
    for (std::uint32_t b = 0; b < (run.vertex_count + 3) / 4; ++b) {
      for (std::uint32_t lane = 0; lane < 4; ++lane, ++slot) visit(slot, key_of(primitive, g, block, slot));
      block += 12 + 4 * (std::size_t{run.influences} - 1);
    }
  }
}

// A mesh: the number of its primitive. What one palette is too small for is several meshes.
std::vector<std::uint32_t> primitives_of(const File& file) {
  std::vector<std::uint32_t> out;
  std::uint32_t count = 0;
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    if (!file.mesh(m).is_next_part) ++count;
    out.push_back(count - 1);
  }
  return out;
}

Failure not_the_same(const std::string& source) {
  return Failure(Exit::internal, source, "", "cooked plainly it has other vertices", "please report this");
}

}  // namespace

WorstPlace find_worst(const File& file, Character& character, PlainSkin& plain, std::span<const std::uint32_t> clips) {
  WorstPlace out;
  if (clips.empty()) return out;
  out.clip = clips.front();
  const Bends bends = find_bends(file, character);
  const std::size_t moments = std::clamp(kMostMoments / clips.size(), kLeastMoments, kMoments);
  std::vector<Candidate> moving(bends.places.size()), standing(bends.places.size());
  bool any_moves = false;
  for (const std::uint32_t clip : clips) {
    std::vector<Candidate> worst(bends.places.size());
    const bool still = !judge_clip(file, character, plain, bends, clip, moments, worst);
    if (!still && !any_moves) out.clip = clip;
    any_moves = any_moves || !still;
    std::vector<Candidate>& all = still ? standing : moving;
    for (std::size_t p = 0; p < all.size(); ++p)
      if (worst[p].score > all[p].score) all[p] = worst[p];
  }
  std::vector<Candidate> candidates = any_moves ? std::move(moving) : std::move(standing);
  std::ranges::stable_sort(candidates, std::ranges::greater(), &Candidate::score);
  if (candidates.size() > kCandidates) candidates.resize(kCandidates);
  float best = 0;
  for (const Candidate& c : candidates) {
    if (!(c.score > 0)) continue;
    const Play play = play_together(file, c.clip);
    const Performance performance(file, character, play);
    character.pose(play, c.time_s);
    const std::vector<PosedMesh> as = skin_all(file, character, Deformer::as), of_plain = plain.skin(character);
    const Part part = part_of(bends, c.place, of_plain, as, performance.radius());
    const Seen seen = clearest_side(file, of_plain, as, part);
    if (!(c.score * seen.share > best)) continue;
    best = c.score * seen.share;
    const Place& place = bends.places[c.place];
    const std::string name = file.text(file.skeleton(place.skeleton).names[place.joint]);
    out = {c.clip, c.time_s, name.empty() ? std::to_string(place.joint) : name, part, seen.side};
  }
  return out;
}

PlainSkin::PlainSkin(const std::string& source, const File& file) : other_(file) {
  cook::CookOptions options;  // as precise as the other
  options.mesh.codec = cook::MeshCodec::meshopt;
  options.clips.raw = true;
  options.source.images = cook::Images::none;
  const std::vector<std::byte> bytes = cook::cook_file(source, options).file;
  loaded_ = load_mrw(source, AlignedBytes{std::span<const std::byte>(bytes)});
  character_ = std::make_unique<Character>(loaded_.file);
  const std::vector<std::uint32_t> own = primitives_of(loaded_.file), others = primitives_of(file);
  std::map<Key, Place> place_of;
  for (std::uint32_t m = 0; m < own.size(); ++m) {
    visit_slots(own[m], loaded_.file.mesh(m).geometry, [&](std::uint32_t slot, const Key& key) {
      place_of.try_emplace(key, Place{m, slot});
    });
    const auto twin = std::ranges::find(others, own[m]);
    if (twin == others.end()) throw not_the_same(source);
    twin_.push_back(static_cast<std::uint32_t>(twin - others.begin()));
  }
  for (std::uint32_t m = 0; m < others.size(); ++m) {
    std::vector<Place>& places = places_.emplace_back();
    visit_slots(others[m], file.mesh(m).geometry, [&](std::uint32_t, const Key& key) {
      const auto at = place_of.find(key);
      if (at == place_of.end()) throw not_the_same(source);
      places.push_back(at->second);
    });
  }
}

std::vector<PosedMesh> PlainSkin::skin(const Character& posed) {
  character_->set_change([&](std::uint32_t skeleton, const Pose& pose) {
    std::ranges::copy(posed.model_from_joint(skeleton), pose.model_from_joint.begin());
  });
  character_->set_weigh(
      [&](std::uint32_t mesh, Span<float> weights) { std::ranges::copy(posed.weights(twin_[mesh]), weights.begin()); });
  character_->pose({}, 0);
  std::vector<PosedMesh> own(loaded_.file.mesh_count()), out(other_.mesh_count());
  for (std::uint32_t m = 0; m < own.size(); ++m) character_->skin(m, Deformer::ssd, own[m]);
  for (std::uint32_t m = 0; m < out.size(); ++m) {
    for (const Place& place : places_[m]) {
      const PosedMesh& from = own[place.mesh];
      const std::size_t at = 3 * std::size_t{place.slot};
      for (std::size_t c = at; c < at + 3; ++c) {
        out[m].positions.push_back(from.positions[c]);
        if (!from.normals.empty()) out[m].normals.push_back(from.normals[c]);
      }
      out[m].inside_out = from.inside_out;
    }
  }
  return out;
}

}  // namespace marrow::tools
