// Morph targets whose weights a clip moves: the bind pose is changed, then skinned like any other.
// $ morphs morphs.mrw
#include "asset.h"

#include <cmath>

using marrow::Status;

int main(int argc, char** argv) {
  Asset asset;
  if (asset.open(argc > 1 ? argv[1] : "morphs.mrw") != Status::ok) return 1;
  const marrow::File& file = asset.file;
  const marrow::Skeleton skeleton = file.skeleton(0);
  const marrow::Clip clip = file.clip(file.find_clip("twist"));
  const marrow::Mesh body = file.mesh(file.find_mesh("body"));

  // Once a load: which channel of the clip drives which target.
  std::vector<std::uint32_t> channels(body.targets.size);
  if (find_weight_channels(file, body, file, clip, channels) != Status::ok) return 1;

  // Once a character: vertices of its own.
  std::vector<std::byte> memory(marrow::block_bytes(morphed_bytes(body.geometry)));
  marrow::MorphedGeometry morphed;
  if (make_morphed(body.geometry, marrow::block_in(memory), morphed) != Status::ok) return 1;
  marrow::Mesh own = body;
  own.geometry = morphed.geometry;

  // Every frame: a pose, weights, vertices.
  std::vector<marrow::SoaTransform> local(skeleton.soa_size());
  std::vector<marrow::Affine> model_from_joint(skeleton.joint_count), palette(body.palette_size());
  std::vector<float> values(clip.channels.size), weights(body.targets.size);
  std::vector<float> positions(3 * std::size_t(body.geometry.slot_count)), plain(positions.size());
  for (const float time_s : {0.0f, 0.7f, 1.4f}) {
    if (sample(skeleton, clip, time_s, local) != Status::ok ||
        local_to_model(skeleton, local, model_from_joint) != Status::ok ||
        build_palette(body, model_from_joint, palette) != Status::ok)
      return 1;
    if (sample_channels(clip, time_s, values) != Status::ok ||
        morph_weights(body, channels, values, weights) != Status::ok || morph(weights, morphed) != Status::ok)
      return 1;
    if (skin_ssd(own, palette, {.positions = positions}) != Status::ok ||
        skin_ssd(body, palette, {.positions = plain}) != Status::ok)
      return 1;
    double moved = 0;
    for (std::size_t i = 0; i < positions.size(); ++i)
      moved = std::max(moved, std::abs(double(positions[i]) - double(plain[i])));
    std::printf("%.1f s: %s has weight %.4f, and a vertex is moved by %.1f mm\n", double(time_s),
                file.text(body.targets[0].name), double(weights[0]), 1000 * moved);
  }
}

// Prints:
//   0.0 s: eigenskin[0] has weight 0.0217, and a vertex is moved by 10.1 mm
//   0.7 s: eigenskin[0] has weight 0.9989, and a vertex is moved by 37.2 mm
//   1.4 s: eigenskin[0] has weight 0.0217, and a vertex is moved by 10.5 mm
