// A game's calls, so that tools/sizes/code.sh can say what linking them costs. Never run. STAGES: 0 nothing, 1 poses,
// 2 and SSD, 3 and animation space; UNPACK: a function of marrow/draco.h or marrow/meshopt.h; IK: 1 limbs and eyes, 2
// and chains and limits, 3 and bodies, 4 and rates, springs and feet, 5 and the genetic solver.
#include "marrow/blend.h"
#include "marrow/draco.h"
#include "marrow/feet.h"
#include "marrow/file.h"
#include "marrow/ik.h"
#include "marrow/ik_solve.h"
#include "marrow/limits.h"
#include "marrow/local_to_model.h"
#include "marrow/meshopt.h"
#include "marrow/palette.h"
#include "marrow/sample.h"
#include "marrow/skin.h"
#include "marrow/springs.h"
#include "marrow/unpack.h"

#if STAGES == 0
int main() {
  return 0;
}
#else

namespace {

// Nothing is known of what lies here, so nothing can be left out.
struct Memory {
  std::byte* bytes;
  marrow::SoaTransform* poses[2];
  marrow::Affine *joints, *palette;
  float *positions, *normals, *coordinates;
  std::size_t size;
  struct {
    marrow::TwoBone limb;
    marrow::Aim aim;
    const std::uint32_t* joints;
    marrow::IkProblem problem;
    marrow::IkOptions options;
    marrow::RotationFollower* followers;
    marrow::SpringChain springs;
    marrow::SpringFrame spring_frame;
    marrow::Feet feet;
    marrow::FeetFrame feet_frame;
    const marrow::FootGround* ground;
    marrow::FootMotion* motion;
  } ik;
};

#ifdef IK
void reach(const marrow::Skeleton& skeleton, const Memory& m) {
  const marrow::Pose pose{skeleton, {m.poses[0], m.size}, {m.joints, m.size}};
  solve_two_bone(pose, {m.ik.joints[0], m.ik.joints[1], m.ik.joints[2]}, m.ik.limb);
  solve_look_at(pose, {m.ik.joints, m.size}, m.ik.aim, 0.5f);
#if IK >= 2
  solve_ik_chain(pose, m.ik.problem, m.ik.options, {m.bytes, ik_scratch_bytes(skeleton, m.ik.problem, m.ik.options)});
  limit_pose(skeleton.limits, pose.local);
#endif
#if IK >= 3
  solve_ik_body(pose, m.ik.problem, m.ik.options, {m.bytes, m.size});
#endif
#if IK >= 4
  follow_pose(skeleton.limits, {m.ik.followers, m.size}, 0.01f, pose.local);
  marrow::Springs springs;
  make_springs(skeleton, {&m.ik.springs, 1}, {m.bytes, m.size}, springs);
  simulate_springs(pose, m.ik.spring_frame, springs);
  place_feet(pose, m.ik.feet, m.ik.feet_frame, {m.ik.ground, m.size}, {m.ik.motion, m.size});
#endif
#if IK >= 5
  solve_ik_genetic(pose, m.ik.problem, m.ik.options, {m.bytes, m.size});
#endif
}
#endif

marrow::Status frame(marrow::Span<const std::byte> bytes, const Memory& m) {
#ifdef UNPACK
  const marrow::MeshDecoder decoders[] = {marrow::UNPACK()};
  if (unpack(bytes, {decoders, 1}, {m.bytes, m.size}, bytes) != marrow::Status::ok) return marrow::Status::bad_data;
#endif
  marrow::File file;
  if (load(bytes, file) != marrow::Status::ok) return marrow::Status::bad_data;
  const marrow::Skeleton skeleton = file.skeleton(0);
  marrow::BlendLayer layers[2];
  for (std::uint32_t i = 0; i < 2; ++i) {
    sample(skeleton, file.clip(i), 0.5f, {m.poses[i], m.size});
    layers[i].pose = {m.poses[i], m.size};
  }
  blend(skeleton, {layers, 2}, {m.poses[0], m.size});
  local_to_model(skeleton, {m.poses[0], m.size}, {m.joints, m.size});
#ifdef IK
  reach(skeleton, m);
#endif
#if STAGES >= 2
  const marrow::Mesh mesh = file.mesh(0);
  build_palette(mesh, {m.joints, m.size}, {m.palette, m.size});
  const marrow::SkinOutput out{.positions = {m.positions, m.size}, .normals = {m.normals, m.size}, .tangents = {}};
  skin_ssd(mesh, {m.palette, m.size}, out);
#if STAGES >= 3
  as_coordinates(mesh.geometry, {m.coordinates, m.size});
  skin_as(mesh, {m.coordinates, m.size}, {m.palette, m.size}, out);
#endif
#endif
  return marrow::Status::ok;
}

}  // namespace

int main(int argc, char** argv) {
  return static_cast<int>(frame({reinterpret_cast<const std::byte*>(argv[0]), static_cast<std::size_t>(argc)},
                                *reinterpret_cast<const Memory*>(argv[1])));
}
#endif
