#include "commands/demo/plain_skin.h"

#include <algorithm>
#include <array>
#include <bit>
#include <map>

#include "common/failure.h"
#include "disk/cook_on_disk.h"

namespace marrow::tools {
namespace {

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
