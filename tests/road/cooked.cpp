#include "road/cooked.h"

#include <cstring>
#include <stdexcept>

#include "common/unpack_mrw.h"

namespace marrow::test {
namespace {

Vec3 three(const std::vector<float>& v, std::size_t first) {
  if (v.empty()) return {0, 0, 0};
  return {static_cast<double>(v[first]), static_cast<double>(v[first + 1]), static_cast<double>(v[first + 2])};
}

}  // namespace

std::uint32_t next_animation(const File& file, std::uint32_t clip) {
  const Clip first = file.clip(clip);
  std::uint32_t last = first.skeleton;
  while (++clip < file.clip_count()) {
    const Clip next = file.clip(clip);
    if (std::strcmp(next.name, first.name) != 0 || next.skeleton <= last) break;
    last = next.skeleton;
  }
  return clip;
}

Cooked::Cooked(const std::string& path, cook::MeshCodec codec)
    : Cooked(path, [codec] {
        cook::CookOptions options;
        options.mesh.codec = codec;
        options.clips.raw = true;
        return options;
      }()) {}

Cooked::Cooked(const std::string& path, cook::CookOptions options) {
  options.mesh.keep_vertex_order = true;
  const cook::Result result = cook::cook_file(path, options);
  report_ = result.report;
  bytes_ = result.file.size();
  if (options.mesh.codec == cook::MeshCodec::none) {
    block_ = std::make_unique<AlignedBlock>(result.file.data(), result.file.size());
  } else {
    const tools::AlignedBytes unpacked = tools::unpacked(result.file, path);
    block_ = std::make_unique<AlignedBlock>(unpacked.data(), unpacked.size());
  }
  DataError error;
  if (load(*block_, file_, &error) != Status::ok)
    throw std::runtime_error(path + ": cooked, but not loaded: " + error.rule);
}

CookedPose Cooked::pose(std::uint32_t clip, float time_s, Deformer deformer, const std::vector<float>& cycle) const {
  CookedPose out;
  for (std::uint32_t m = 0; m < file_.mesh_count(); ++m) {
    const PosedMesh posed = pose_mesh(file_, clip, time_s, m, deformer, cycle);
    const auto slots = file_.mesh(m).geometry.source_slots;
    const std::size_t first = out.used.size() - (file_.mesh(m).is_next_part ? slots.size : 0);
    out.used.resize(first + slots.size, false);
    out.positions.resize(out.used.size());
    out.normals.resize(out.used.size());
    out.tangents.resize(out.used.size());
    out.tangent_signs.resize(out.used.size(), 0);
    for (std::size_t v = 0; v < slots.size; ++v) {
      const std::size_t slot = slots[v];
      if (slot == kNoSlot) continue;
      out.used[first + v] = true;
      out.positions[first + v] = three(posed.positions, slot * 3);
      out.normals[first + v] = three(posed.normals, slot * 3);
      out.tangents[first + v] = three(posed.tangents, slot * 4);
      if (!posed.tangents.empty()) out.tangent_signs[first + v] = static_cast<double>(posed.tangents[slot * 4 + 3]);
    }
  }
  return out;
}

}  // namespace marrow::test
