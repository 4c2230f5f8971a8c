// From a walk to a reach in a quarter of a second, in two ways.
// $ transitions hero.mrw
#include "asset.h"

using marrow::Status;
using Pose = std::vector<marrow::SoaTransform>;

constexpr float kFrame_s = 1.0f / 60, kFade_s = 0.25f, kBegin_s = 0.4f;

double height(const marrow::File& file, const marrow::Skeleton& skeleton, const Pose& pose) {
  marrow::JointTransform pelvis;
  return get_joint(pose, file.find_joint(skeleton, "pelvis"), pelvis) == Status::ok ? double(pelvis.translation[1]) : 0;
}

int main(int argc, char** argv) {
  Asset asset;
  if (asset.open(argc > 1 ? argv[1] : "hero.mrw") != Status::ok) return 1;
  const marrow::File& file = asset.file;
  const marrow::Skeleton skeleton = file.skeleton(0);
  const marrow::Clip walk = file.clip(file.find_clip("walk")), reach = file.clip(file.find_clip("reach"));
  Pose from(skeleton.soa_size()), to(skeleton.soa_size()), shown(skeleton.soa_size()), before(skeleton.soa_size());

  // Inertialisation begins with the two poses that were shown last, and the new clip's first.
  std::vector<marrow::InertialOffset> offsets(skeleton.soa_size());
  marrow::Inertia inertia;
  inertia.offsets = offsets;
  if (sample(skeleton, walk, kBegin_s - kFrame_s, before) != Status::ok ||
      sample(skeleton, walk, kBegin_s, shown) != Status::ok || sample(skeleton, reach, 0, to) != Status::ok ||
      begin_inertia(skeleton, {.before = before, .now = shown, .target = to, .frame_s = kFrame_s}, kFade_s, inertia) !=
          Status::ok)
    return 1;

  std::printf("  time   walk   reach  fade   inertia\n");
  for (int frame = 0; frame <= 15; ++frame) {
    const float time_s = float(frame) * kFrame_s;
    if (sample(skeleton, walk, kBegin_s + time_s, from) != Status::ok ||
        sample(skeleton, reach, time_s, to) != Status::ok)
      return 1;
    const double old_height = height(file, skeleton, from), new_height = height(file, skeleton, to);

    // A fade needs both clips in every frame.
    const float weight = marrow::fade_weight(marrow::Fade::smoothstep, time_s, kFade_s);
    if (cross_fade(skeleton, from, to, weight, shown) != Status::ok) return 1;
    const double faded = height(file, skeleton, shown);

    // Inertia needs the new one alone, and goes over it in place.
    if (apply_inertia(skeleton, inertia, time_s, to) != Status::ok) return 1;
    if (frame % 5 == 0)
      std::printf("%.3f s  %.4f %.4f %.4f %.4f m\n", double(time_s), old_height, new_height, faded,
                  height(file, skeleton, to));
  }
}

// Prints:
//     time   walk   reach  fade   inertia
//   0.000 s  0.4875 0.4880 0.4875 0.4875 m
//   0.083 s  0.4807 0.4785 0.4801 0.4781 m
//   0.167 s  0.4706 0.4540 0.4583 0.4540 m
//   0.250 s  0.4645 0.4203 0.4203 0.4203 m
