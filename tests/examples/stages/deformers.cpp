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
  const marrow::Mesh mesh = file.mesh(0);
  const marrow::Clip clip = file.clip(0);
  std::vector<marrow::SoaTransform> local(skeleton.soa_size());
  std::vector<marrow::Affine> model_from_joint(skeleton.joint_count), palette(mesh.palette_size());
  if (sample(skeleton, clip, 0.5f * clip.duration_s, local) != Status::ok ||
      local_to_model(skeleton, local, model_from_joint) != Status::ok ||
      build_palette(mesh, model_from_joint, palette) != Status::ok)
    return 1;

  const std::size_t floats = 3 * std::size_t(mesh.geometry.slot_count);
  std::vector<float> ssd(floats), other(floats);
  if (skin_ssd(mesh, palette, {.positions = ssd}) != Status::ok) return 1;
  const auto compare = [&](const char* name, Status status) {
    if (status != Status::ok) return;
    double apart = 0;
    for (std::size_t i = 0; i < floats; i += 3)
      apart = std::max(apart, std::hypot(double(ssd[i]) - double(other[i]), double(ssd[i + 1]) - double(other[i + 1]),
                                         double(ssd[i + 2]) - double(other[i + 2])));
    std::printf("%s: up to %.1f mm\n", name, 1000 * apart);
  };

  // Rigid: each vertex follows its heaviest joint.
  compare("rigid", skin_rigid(mesh, palette, {.positions = other}));

  // Animation space: coordinates once a load.
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry));
  if (as_coordinates(mesh.geometry, coordinates) != Status::ok) return 1;
  compare("animation space", skin_as(mesh, coordinates, palette, {.positions = other}));

  // Multi-weight enveloping: only with what `marrow cook --mwe` learnt.
  if (mesh.geometry.mwe_residual != nullptr)
    compare("multi-weight enveloping", skin_mwe(mesh, palette, {.positions = other}));

  // Pose space: how far the pose is from the examples, once a mesh and frame.
  std::vector<float> distances(psd_distance_count(mesh.geometry));
  if (psd_distances(mesh.geometry, palette, distances) != Status::ok) return 1;
  compare("pose space", skin_psd(mesh, distances, palette, {.positions = other}));
}

// Prints:
//   rigid: up to 321.5 mm
//   animation space: up to 100.7 mm
//   multi-weight enveloping: up to 200.3 mm
//   pose space: up to 181.8 mm
