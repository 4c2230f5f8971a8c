// One pose by every deformer that a file has data for, and how far each is from linear blend skinning.
// $ deformers learnt.mrw
#include "asset.h"

#include <cmath>

using marrow::Status;

int main(int argc, char** argv) {
  Asset asset;
  if (asset.open(argc > 1 ? argv[1] : "learnt.mrw") != Status::ok) return 1;
  const marrow::File& file = asset.file;
  const marrow::Skeleton skeleton = file.skeleton(0);
  const marrow::Mesh body = file.mesh(file.find_mesh("body"));
  std::vector<marrow::SoaTransform> local(skeleton.soa_size());
  std::vector<marrow::Affine> scene_from_joint(skeleton.joint_count), palette(body.palette_size());
  if (sample(skeleton, file.clip(file.find_clip("twist")), 1.4f, local) != Status::ok ||
      local_to_model(skeleton, local, scene_from_joint) != Status::ok ||
      build_palette(body, scene_from_joint, palette) != Status::ok)
    return 1;

  const std::size_t floats = 3 * std::size_t(body.geometry.slot_count);
  std::vector<float> ssd(floats), other(floats);
  if (skin_ssd(body, palette, {.positions = ssd}) != Status::ok) return 1;
  const auto compare = [&](const char* name, Status status) {
    if (status != Status::ok) return;
    double apart = 0;
    for (std::size_t i = 0; i < floats; i += 3)
      apart = std::max(apart, std::hypot(double(ssd[i]) - double(other[i]), double(ssd[i + 1]) - double(other[i + 1]),
                                         double(ssd[i + 2]) - double(other[i + 2])));
    std::printf("%s: up to %.1f mm\n", name, 1000 * apart);
  };

  // Rigid: each vertex follows its heaviest joint.
  compare("rigid", skin_rigid(body, palette, {.positions = other}));

  // Animation space: coordinates once a load.
  std::vector<float> coordinates(as_coordinate_count(body.geometry));
  if (as_coordinates(body.geometry, coordinates) != Status::ok) return 1;
  compare("animation space", skin_as(body, coordinates, palette, {.positions = other}));

  // Multi-weight enveloping: only with what `marrow cook --mwe` learnt.
  if (body.geometry.mwe_residual != nullptr)
    compare("multi-weight enveloping", skin_mwe(body, palette, {.positions = other}));

  // Pose space: how far the pose is from the examples, once a mesh and frame.
  std::vector<float> distances(psd_distance_count(body.geometry));
  if (psd_distances(body.geometry, palette, distances) != Status::ok) return 1;
  compare("pose space", skin_psd(body, distances, palette, {.positions = other}));
}

// Prints:
//   rigid: up to 76.4 mm
//   animation space: up to 11.4 mm
//   multi-weight enveloping: up to 25.5 mm
//   pose space: up to 28.0 mm
