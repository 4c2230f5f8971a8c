// What was cooked, packed or not, as the runtime sees it.
#pragma once

#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "common/unpack_mrw.h"
#include "cook/write/write_scene.h"
#include "disk/cook_on_disk.h"
#include "marrow/marrow.h"

namespace marrow::cook {

struct LoadedCook {
  explicit LoadedCook(const Result& result) : report(result.report) {
    bytes = format::kPackedMagic == magic(result.file) ? tools::unpacked(result.file, "")
                                                       : tools::AlignedBytes{std::span<const std::byte>(result.file)};
    EXPECT_EQ(load({bytes.data(), bytes.size()}, file), Status::ok);
  }
  static std::uint32_t magic(const std::vector<std::byte>& file) {
    std::uint32_t out = 0;
    std::memcpy(&out, file.data(), sizeof out);
    return out;
  }

  nlohmann::ordered_json report;
  tools::AlignedBytes bytes;
  File file;
};

// The mesh at a moment of a clip, in model space: by skin_ssd and by skin_as.
struct Skins {
  std::vector<glm::vec3> ssd, as;  // a slot each
};

// straight: helpers are means of their joints' matrices.
inline Skins skins_at(const File& file, std::uint32_t clip, float time_s, const Mesh& mesh, bool straight = false) {
  const Skeleton skeleton = file.skeleton(mesh.skeleton);
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> model(skeleton.joint_count), palette(mesh.palette_size());
  EXPECT_EQ(sample(skeleton, file.clip(clip), time_s, local), Status::ok);
  EXPECT_EQ(local_to_model(skeleton, local, model), Status::ok);
  EXPECT_EQ(build_palette(mesh, model, palette), Status::ok);
  for (std::size_t h = 0; straight && h < mesh.helpers.size; ++h) {
    const Helper& helper = mesh.helpers[h];
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c)
        palette[mesh.joint_count + h].rows[r][c] =
            palette[helper.first].rows[r][c] * (1 - helper.share) + palette[helper.second].rows[r][c] * helper.share;
  }
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry)), at(std::size_t{3} * mesh.geometry.slot_count);
  EXPECT_EQ(as_coordinates(mesh.geometry, coordinates), Status::ok);
  const auto places = [&at] {
    std::vector<glm::vec3> out;
    for (std::size_t i = 0; i < at.size(); i += 3) out.emplace_back(at[i], at[i + 1], at[i + 2]);
    return out;
  };
  Skins out;
  EXPECT_EQ(skin_ssd(mesh, palette, {at, {}, {}}), Status::ok);
  out.ssd = places();
  EXPECT_EQ(skin_as(mesh, coordinates, palette, {at, {}, {}}), Status::ok);
  out.as = places();
  return out;
}

}  // namespace marrow::cook
