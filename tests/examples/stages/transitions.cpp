// From walking to standing in a quarter of a second, in two ways.
// $ transitions hero.mrw
#include "asset.h"

using marrow::Status;
using LocalPose = std::vector<marrow::SoaTransform>;

constexpr float kFrame_s = 1.0f / 60, kFade_s = 0.25f, kBegin_s = 0.5f;

// How far the pelvis is to the left, in millimetres.
double sway(const marrow::File& file, const marrow::Skeleton& skeleton, const LocalPose& pose) {
  marrow::JointTransform pelvis;
  if (get_joint(pose, file.find_joint(skeleton, "pelvis"), pelvis) != Status::ok) return 0;
  return 1000 * double(pelvis.translation[0]);
}

int main(int argc, char** argv) {
  Asset asset;
  if (asset.open(argc > 1 ? argv[1] : "hero.mrw") != Status::ok) return 1;
  const marrow::File& file = asset.file;
  const marrow::Skeleton skeleton = file.skeleton(0);
  const marrow::Clip walk = file.clip(file.find_clip("walk")), idle = file.clip(file.find_clip("idle"));
  LocalPose from(skeleton.soa_size()), to(skeleton.soa_size()), shown(skeleton.soa_size()), before(skeleton.soa_size());

  // Inertialisation begins with the two poses that were shown last, and the new clip's first.
  std::vector<marrow::InertialOffset> offsets(skeleton.soa_size());
  marrow::Inertia inertia;
  inertia.offsets = offsets;
  if (sample(skeleton, walk, kBegin_s - kFrame_s, before) != Status::ok ||
      sample(skeleton, walk, kBegin_s, shown) != Status::ok || sample(skeleton, idle, 0, to) != Status::ok ||
      begin_inertia(skeleton, {.before = before, .now = shown, .target = to, .frame_s = kFrame_s}, kFade_s, inertia) !=
          Status::ok)
    return 1;

  std::printf("  time   walk   idle   fade   inertia\n");
  for (int frame = 0; frame <= 15; ++frame) {
    const float time_s = float(frame) * kFrame_s;
    if (sample(skeleton, walk, kBegin_s + time_s, from) != Status::ok ||
        sample(skeleton, idle, time_s, to) != Status::ok)
      return 1;
    const double old_sway = sway(file, skeleton, from), new_sway = sway(file, skeleton, to);

    // A fade needs both clips in every frame.
    const float weight = marrow::fade_weight(marrow::Fade::smoothstep, time_s, kFade_s);
    if (cross_fade(skeleton, from, to, weight, shown) != Status::ok) return 1;
    const double faded = sway(file, skeleton, shown);

    // Inertia needs the new one alone, and goes over it in place.
    if (apply_inertia(skeleton, inertia, time_s, to) != Status::ok) return 1;
    if (frame % 5 == 0)
      std::printf("%.3f s  %5.1f  %5.1f  %5.1f  %5.1f mm\n", double(time_s), old_sway, new_sway, faded,
                  sway(file, skeleton, to));
  }
}

// Prints:
//     time   walk   idle   fade   inertia
//   0.000 s   16.3   -5.9   16.3   16.3 mm
//   0.083 s    8.6   -4.4    5.2    4.7 mm
//   0.167 s   -0.8   -2.8   -2.2   -1.9 mm
//   0.250 s   -9.9   -1.0   -1.0   -1.0 mm
