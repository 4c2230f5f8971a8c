// Meshes as lists a vertex, as engines take them, from blocks of four as the file has them.
#include <algorithm>
#include <utility>

#include "cooked.h"

namespace marrow_godot {
namespace {

struct Influence {
  std::uint32_t entry;
  float weight;
};

// What one vertex follows: a helper, which blends two joints, counts as these two.
class Influences {
 public:
  void add(const mrw_mesh& mesh, std::uint32_t entry, float weight) {
    if (entry >= mesh.joint_count) {
      const mrw_helper& helper = mesh.helpers[entry - mesh.joint_count];
      add(mesh, helper.first, weight * (1 - helper.share));
      add(mesh, helper.second, weight * helper.share);
      return;
    }
    for (std::size_t i = 0; i < count_; ++i) {
      if (all_[i].entry != entry) continue;
      all_[i].weight += weight;
      return;
    }
    all_[count_++] = {entry, weight};
  }

  // The `most` largest, their weights made to sum to 1.
  void keep(std::size_t most) {
    float sum = 0;
    for (std::size_t i = 0; i < count_ && i < most; ++i) {
      for (std::size_t other = i + 1; other < count_; ++other)
        if (all_[other].weight > all_[i].weight) std::swap(all_[i], all_[other]);
      sum += all_[i].weight;
    }
    count_ = std::min(count_, most);
    for (std::size_t i = 0; i < count_; ++i) all_[i].weight = sum > 0 ? all_[i].weight / sum : float(i == 0);
  }

  std::size_t count() const { return count_; }
  Influence get(std::size_t i) const { return i < count_ ? all_[i] : Influence{0, 0}; }

 private:
  Influence all_[2 * MRW_MAX_INFLUENCES];
  std::size_t count_ = 0;
};

// Calls visit(slot, position, influences) of each vertex.
template <typename Visit>
void each_vertex(const mrw_mesh& mesh, Visit visit) {
  const mrw_geometry& geometry = mesh.geometry;
  const float* block = geometry.skin;
  const std::uint16_t* set = geometry.sets;
  std::uint32_t slot = 0;
  for (std::size_t r = 0; r < geometry.run_count; ++r) {
    const std::uint32_t k = geometry.runs[r].influences;
    const std::uint32_t blocks = (geometry.runs[r].vertex_count + 3) / 4;
    for (std::uint32_t b = 0; b < blocks; ++b, block += std::size_t(4) * (2 + k)) {
      for (std::uint32_t lane = 0; lane < 4; ++lane, ++slot) {
        Influences influences;
        float rest = 1;
        for (std::uint32_t i = 0; i + 1 < k; ++i) {
          influences.add(mesh, set[i], block[4 * (3 + i) + lane]);
          rest -= block[4 * (3 + i) + lane];
        }
        influences.add(mesh, set[k - 1], rest);
        const float position[3] = {block[lane], block[4 + lane], block[8 + lane]};
        visit(slot, position, influences);
      }
    }
    set += k;
  }
}

// From blocks x[4] y[4] … to a list of vertices.
std::vector<float> spread(const float* blocks, std::uint32_t slots, std::uint32_t width) {
  std::vector<float> out;
  if (blocks == nullptr) return out;
  out.reserve(std::size_t(slots) * width);
  for (std::size_t slot = 0; slot < slots; ++slot)
    for (std::size_t i = 0; i < width; ++i) out.push_back(blocks[(slot / 4 * width + i) * 4 + slot % 4]);
  return out;
}

std::vector<float> positions_of(const mrw_mesh& mesh) {
  std::vector<float> out;
  out.reserve(3 * std::size_t(mesh.geometry.slot_count));
  each_vertex(mesh, [&](std::uint32_t, const float* at, const Influences&) { out.insert(out.end(), at, at + 3); });
  return out;
}

std::vector<std::int32_t> indices_of(const mrw_geometry& geometry) {
  std::vector<std::int32_t> out;
  out.reserve(geometry.index_count);
  const auto index = [&](std::size_t i) {
    if (geometry.index_bytes == 2) return std::int32_t(static_cast<const std::uint16_t*>(geometry.indices)[i]);
    return std::int32_t(static_cast<const std::uint32_t*>(geometry.indices)[i]);
  };
  for (std::size_t i = 0; i + 2 < geometry.index_count; i += 3) {
    out.push_back(index(i));
    out.push_back(index(i + 2));
    out.push_back(index(i + 1));
  }
  return out;
}

std::int32_t most_influences(const mrw_mesh& mesh) {
  std::size_t most = 0;
  each_vertex(mesh, [&](std::uint32_t, const float*, const Influences& of) { most = std::max(most, of.count()); });
  return std::int32_t(most);
}

}  // namespace

std::string Cooked::mesh_name(std::int64_t mesh) const {
  return mesh < 0 || mesh >= mesh_count() ? "" : meshes_[std::size_t(mesh)].name;
}

std::vector<float> Cooked::mesh_reals(std::int64_t mesh, const std::string& what, std::int64_t influences) {
  std::vector<float> out;
  if (mesh < 0 || mesh >= mesh_count()) return fail("there is no mesh " + std::to_string(mesh)), out;
  const mrw_mesh& m = meshes_[std::size_t(mesh)];
  const mrw_geometry& geometry = m.geometry;
  const std::size_t slots = geometry.slot_count;
  const float* const uvs = geometry.uvs;
  if (what == "positions") return positions_of(m);
  if (what == "normals") return spread(geometry.normals, geometry.slot_count, 3);
  if (what == "tangents") return spread(geometry.tangents, geometry.slot_count, 4);
  if (what == "uvs") return uvs == nullptr ? out : std::vector<float>(uvs, uvs + 2 * slots);
  if (what == "colour") return {m.base_colour, m.base_colour + 4};
  if (what == "colours") {
    for (std::size_t i = 0; geometry.colours != nullptr && i < 4 * slots; ++i)
      out.push_back(float(geometry.colours[i]) / 255);
    return out;
  }
  if (what == "binds") {
    const float* const rows = &m.inverse_bind[0].rows[0][0];
    return {rows, rows + 12 * std::size_t(m.joint_count)};
  }
  if (what != "weights") return fail("meshes have no list \"" + what + "\""), out;
  if (influences < 1 || influences > MRW_MAX_INFLUENCES) return fail("a vertex has 1 … 8 influences"), out;
  each_vertex(m, [&](std::uint32_t, const float*, Influences of) {
    of.keep(std::size_t(influences));
    for (std::size_t i = 0; i < std::size_t(influences); ++i) out.push_back(of.get(i).weight);
  });
  return out;
}

std::vector<std::int32_t> Cooked::mesh_ints(std::int64_t mesh, const std::string& what, std::int64_t influences) {
  std::vector<std::int32_t> out;
  if (mesh < 0 || mesh >= mesh_count()) return fail("there is no mesh " + std::to_string(mesh)), out;
  const mrw_mesh& m = meshes_[std::size_t(mesh)];
  if (what == "indices") return indices_of(m.geometry);
  if (what == "bind_bones") return {m.joints, m.joints + m.joint_count};
  if (what == "influences") return {most_influences(m)};
  if (what == "double_sided") return {m.double_sided ? 1 : 0};
  if (what != "bones") return fail("meshes have no list \"" + what + "\""), out;
  if (influences < 1 || influences > MRW_MAX_INFLUENCES) return fail("a vertex has 1 … 8 influences"), out;
  each_vertex(m, [&](std::uint32_t, const float*, Influences of) {
    of.keep(std::size_t(influences));
    for (std::size_t i = 0; i < std::size_t(influences); ++i) out.push_back(std::int32_t(of.get(i).entry));
  });
  return out;
}

}  // namespace marrow_godot
