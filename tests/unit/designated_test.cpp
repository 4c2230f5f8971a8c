// Public structs may be filled in by name, and what is left out draws no warning: this file is compiled with -Wextra
// and warnings as errors.
#include <gtest/gtest.h>

#include "marrow/marrow.h"

namespace marrow {
namespace {

TEST(Designated, MembersMayBeLeftOut) {
  float numbers[4] = {1, 2, 3, 4};
  const SoaTransform pose[1] = {};
  const BlendLayer layer = {.pose = pose};
  const AdditiveLayer change = {.weight = 0.5f};
  const Curve curve = {.values = numbers};
  const ArcLength length = {.steps = 2};
  const Feet feet = {.reach = 0.9f};
  const Foot foot = {.ankle = 2};
  const FootGround ground = {.hit = true};
  const FootMotion motion = {.planted = 1};
  const FeetFrame feet_frame = {.dt_s = 0.1f};
  const Skeleton skeleton = {.joint_count = 1};
  const Clip clip = {.duration_s = 1};
  const Mesh mesh = {.name = "newt"};
  const Geometry geometry = {.slot_count = 4};
  const Track track = {.path = TrackPath::scale};
  const Channel channel = {.rest = 1};
  const MorphTarget target = {.block_count = 1};
  const Texture texture = {.role = TextureRole::normal};
  const Material material = {.name = "skin"};
  const Node node = {.joint = 3};
  const Helper helper = {.share = 0.5f};
  const JointLimit limit = {.joint = 1};
  const LimitDescription described = {.kind = LimitKind::hinge};
  const RateLimit rate = {.speed = 1};
  const RotationFollower turning = {.mode = 1};
  const PointFollower going = {.frame_s = 1};
  const IkGoal goal = {.joint = 1};
  const IkProblem problem = {.root_travel_m = 1};
  const IkOptions options = {.damping = 2};
  const TwoBoneLimb limb = {.end = 3};
  const TwoBone reach = {.weight = 1};
  const Aim aim_at = {.twist_rad = 1};
  const Playback playback = {.speed = 2};
  const SampleOptions sampling = {.joints = {}};
  const SkinOutput out = {.positions = numbers};
  const AsPart part = {.mesh = &mesh};
  const SpringJoint spring = {.joint = 1};
  const SpringChain chain = {.tip = {0, 1, 0}};
  const SpringCollider collider = {.radius_m = 1};
  const SpringFrame spring_frame = {.dt_s = 0.1f};
  const Inertia inertia = {.duration_s = 1};
  const InertialStart start = {.frame_s = 1};
  const JointTransform joint = {.scale = {2, 2, 2}};
  const DataError error = {.rule = "none"};
  const MeshDecoder decoder = {.codec = 1};
  const UnpackSizes sizes = {.file_bytes = 1};
  const JointMisfit misfit = {.joint = 1};
  const ExampleParameter parameter = {.rest = 1};
  const ExampleSpace space = {.name = "moods"};

  EXPECT_EQ(layer.weight, 1.0f);
  EXPECT_TRUE(change.mask.empty() && curve.times_s.empty() && length.lengths.empty() && out.normals.empty());
  EXPECT_TRUE(feet.feet.empty() && foot.hip == 0 && ground.normal[1] == 1 && motion.begun == 0);
  EXPECT_TRUE(feet_frame.weight == 1 && skeleton.limits.empty() && clip.tracks.empty() && mesh.targets.empty());
  EXPECT_TRUE(geometry.runs.empty() && track.joint == 0 && channel.name == 0 && target.attributes == 0);
  EXPECT_TRUE(texture.image == 0 && material.textures.empty() && node.properties.empty());
  EXPECT_TRUE(helper.first == 0 && limit.limit_from_parent[3] == 1 && described.zero[3] == 1 && rate.acceleration == 0);
  EXPECT_TRUE(turning.frame_s == 0 && going.mode == 0 && goal.rotation[3] == 1 && problem.goals.empty());
  EXPECT_TRUE(options.max_iterations == 16 && limb.start == 0 && reach.soft == 1 && aim_at.weight == 1);
  EXPECT_TRUE(playback.time_s == 0 && sampling.joints.empty() && part.tangents.empty() && spring.weight == 1);
  EXPECT_TRUE(chain.joints.empty() && collider.joint == 0 && spring_frame.weight == 1 && inertia.offsets.empty());
  EXPECT_TRUE(start.now.empty() && joint.rotation[3] == 1 && error.offset == 0 && decoder.decode == nullptr);
  EXPECT_TRUE(sizes.memory_bytes == 0 && misfit.how == Misfit::missing);
  EXPECT_TRUE(parameter.name == 0 && space.example_count == 0);
}

}  // namespace
}  // namespace marrow
