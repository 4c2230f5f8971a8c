// The vertices of a pose, by linear blend skinning and in animation space.
// $ skinning smooth.mrw
#include "asset.h"

#include <cmath>

using marrow::Status;

// Where the highest vertex is, and how far two sets of positions are apart at most.
void print(const char* what, const std::vector<float>& positions) {
  std::size_t top = 0;
  for (std::size_t i = 0; i < positions.size(); i += 3)
    if (positions[i + 1] > positions[top + 1]) top = i;
  std::printf("%s: the highest vertex is at %.4f %.4f %.4f m\n", what, double(positions[top]),
              double(positions[top + 1]), double(positions[top + 2]));
}

int main(int argc, char** argv) {
  Asset asset;
  if (asset.open(argc > 1 ? argv[1] : "smooth.mrw") != Status::ok) return 1;
  const marrow::File& file = asset.file;
  const marrow::Skeleton skeleton = file.skeleton(0);
  const marrow::Mesh body = file.mesh(file.find_mesh("body"));
  std::vector<marrow::SoaTransform> local(skeleton.soa_size());
  std::vector<marrow::Affine> model_from_joint(skeleton.joint_count), palette(body.palette_size());
  if (sample(skeleton, file.clip(file.find_clip("twist")), 1.4f, local) != Status::ok ||
      local_to_model(skeleton, local, model_from_joint) != Status::ok ||
      build_palette(body, model_from_joint, palette) != Status::ok)
    return 1;

  // Linear blend skinning, with normals for a shader that normalises.
  const std::size_t slots = body.geometry.slot_count;
  std::vector<float> positions(3 * slots), normals(3 * slots);
  marrow::SkinOutput out;
  out.positions = positions;
  out.normals = normals;
  out.normal_transform = marrow::NormalTransform::blended_matrix;
  if (skin_ssd(body, palette, out) != Status::ok) return 1;
  std::printf("%u vertices in %zu slots\n", body.geometry.vertex_count, slots);
  print("SSD", positions);

  // Animation space: coordinates once a load, then the same palette.
  std::vector<float> coordinates(as_coordinate_count(body.geometry)), deformed(3 * slots);
  if (as_coordinates(body.geometry, coordinates) != Status::ok) return 1;
  if (skin_as(body, coordinates, palette, {.positions = deformed}) != Status::ok) return 1;
  print("AS ", deformed);

  double apart = 0;
  for (std::size_t i = 0; i < positions.size(); i += 3)
    apart = std::max(apart, std::hypot(double(positions[i]) - double(deformed[i]),
                                       double(positions[i + 1]) - double(deformed[i + 1]),
                                       double(positions[i + 2]) - double(deformed[i + 2])));
  std::printf("they differ by up to %.1f mm\n", 1000 * apart);
}

// Prints:
//   6789 vertices in 7028 slots
//   SSD: the highest vertex is at 0.2476 1.3375 -0.1046 m
//   AS : the highest vertex is at 0.2476 1.3375 -0.1046 m
//   they differ by up to 11.4 mm
