// Two clips averaged, a third one for the arms alone, and a change laid on top.
// $ blending hero.mrw
#include "asset.h"

using marrow::Status;
using LocalPose = std::vector<marrow::SoaTransform>;

struct Character {
  Asset asset;
  marrow::Skeleton skeleton;

  bool open(const char* path) {
    if (asset.open(path) != Status::ok) return false;
    skeleton = asset.file.skeleton(0);
    return true;
  }
  LocalPose sampled(const char* clip, float time_s) const {
    LocalPose out(skeleton.soa_size());
    const Status status = sample(skeleton, asset.file.clip(asset.file.find_clip(clip)), time_s, out);
    if (status != Status::ok) std::printf("%s: %s\n", clip, to_string(status));
    return out;
  }
  std::uint32_t joint(const char* name) const { return asset.file.find_joint(skeleton, name); }
  void print(const char* what, const LocalPose& pose, const char* name) const {
    marrow::JointTransform t;
    if (get_joint(pose, joint(name), t) != Status::ok) return;
    std::printf("%s: %s is at %.4f %.4f %.4f m, turned by %.4f %.4f %.4f %.4f\n", what, name, double(t.translation[0]),
                double(t.translation[1]), double(t.translation[2]), double(t.rotation[0]), double(t.rotation[1]),
                double(t.rotation[2]), double(t.rotation[3]));
  }
};

int main(int argc, char** argv) {
  Character c;
  if (!c.open(argc > 1 ? argv[1] : "hero.mrw")) return 1;
  const LocalPose idle = c.sampled("idle", 0.5f), walk = c.sampled("walk", 0.4f), reach = c.sampled("reach", 1.5f);
  LocalPose pose(c.skeleton.soa_size());

  // Half a walk: means of all joints.
  if (blend(c.skeleton, {{idle, 0.5f}, {walk, 0.5f}}, pose) != Status::ok) return 1;
  c.print("blended", pose, "pelvis");

  // The left arm reaches, whatever the rest of the body does.
  std::vector<float> arm(4 * c.skeleton.soa_size());
  if (mask_below(c.skeleton, c.joint("clavicle.L"), 0, arm) != Status::ok) return 1;
  if (overlay(c.skeleton, {.pose = reach, .weight = 1, .mask = arm}, pose) != Status::ok) return 1;
  c.print("reaching", pose, "pelvis");
  c.print("reaching", pose, "upper_arm.L");

  // Breath: what the idle clip changes from one moment to another, at half its strength.
  std::vector<marrow::AdditiveTransform> breath(c.skeleton.soa_size());
  if (make_additive(c.skeleton, c.sampled("idle", 1.5f), c.sampled("idle", 0), breath) != Status::ok) return 1;
  if (add(c.skeleton, {.change = breath, .weight = 0.5f}, pose) != Status::ok) return 1;
  c.print("breathing", pose, "pelvis");
}

// Prints:
//   blended: pelvis is at 0.0128 0.4884 -0.0217 m, turned by 0.0680 0.0203 0.0172 0.9973
//   reaching: pelvis is at 0.0128 0.4884 -0.0217 m, turned by 0.0680 0.0203 0.0172 0.9973
//   reaching: upper_arm.L is at 0.0000 0.1012 0.0000 m, turned by 0.2682 -0.1957 0.4020 0.8533
//   breathing: pelvis is at 0.0187 0.4900 -0.0217 m, turned by 0.0682 0.0198 0.0095 0.9974
