// Where the joints are, what moves the vertices, and how large it all is.
// $ posed hero.mrw
#include "asset.h"

using marrow::Status;

int main(int argc, char** argv) {
  Asset asset;
  if (asset.open(argc > 1 ? argv[1] : "hero.mrw") != Status::ok) return 1;
  const marrow::File& file = asset.file;
  const marrow::Skeleton skeleton = file.skeleton(0);
  const std::uint32_t walk = file.find_clip("walk"), hand = file.find_joint(skeleton, "hand.L");
  std::vector<marrow::SoaTransform> local(skeleton.soa_size());
  if (sample(skeleton, file.clip(walk), 0.4f, local) != Status::ok) return 1;

  // Local to model: a matrix a joint, in model space.
  std::vector<marrow::Affine> model_from_joint(skeleton.joint_count);
  if (local_to_model(skeleton, local, model_from_joint) != Status::ok) return 1;
  const marrow::Affine& at = model_from_joint[hand];
  std::printf("hand.L is at %.3f %.3f %.3f m\n", double(at.rows[0][3]), double(at.rows[1][3]), double(at.rows[2][3]));

  // A joint is turned by hand: only what hangs below it is brought up to date.
  const std::uint32_t elbow = file.find_joint(skeleton, "forearm.L");
  marrow::JointTransform t;
  if (get_joint(local, elbow, t) != Status::ok) return 1;
  for (int i = 0; i < 3; ++i) t.rotation[i] = -t.rotation[i];  // the inverse of a unit quaternion
  if (set_joint(local, elbow, t) != Status::ok ||
      local_to_model_below(skeleton, local, elbow, model_from_joint) != Status::ok)
    return 1;
  std::printf("and with the elbow bent the other way %.3f %.3f %.3f m\n", double(at.rows[0][3]), double(at.rows[1][3]),
              double(at.rows[2][3]));

  // Palette: what skinning blends, for the joints that this mesh follows.
  const std::uint32_t number = file.find_mesh("body");
  const marrow::Mesh body = file.mesh(number);
  std::vector<marrow::Affine> palette(body.palette_size());
  if (build_palette(body, model_from_joint, palette) != Status::ok) return 1;
  std::printf("%u joints, %u of them move the body's vertices\n", skeleton.joint_count, body.palette_size());

  // Bounds: of the clip from the file, of this pose from the palette.
  std::vector<std::byte> memory(marrow::block_bytes(extents_bytes(body)));
  marrow::MeshExtents extents;  // once a load
  if (make_extents(body, marrow::block_in(memory), extents) != Status::ok) return 1;
  marrow::Bounds now;
  if (palette_bounds(extents, palette, {}, now) != Status::ok) return 1;
  const marrow::Bounds always = file.bounds(walk, number);
  std::printf("the walk stays within %.2f m of %.2f %.2f %.2f, this pose within %.2f m of %.2f %.2f %.2f\n",
              double(always.radius_m), double(always.centre(0)), double(always.centre(1)), double(always.centre(2)),
              double(now.radius_m), double(now.centre(0)), double(now.centre(1)), double(now.centre(2)));
}

// Prints:
//   hand.L is at 0.326 0.509 0.219 m
//   and with the elbow bent the other way 0.383 0.492 -0.056 m
//   44 joints, 40 of them move the body's vertices
//   the walk stays within 0.97 m of 0.00 0.67 -0.37, this pose within 1.05 m of 0.04 0.67 -0.45
