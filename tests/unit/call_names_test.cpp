// Every public function that refuses a call says so under its own name, once.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "marrow/marrow.h"
#include "support/call_errors.h"
#include "support/places.h"

namespace marrow {
namespace {

constexpr Affine kHere = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

// Of one joint, one mesh vertex and one morph target; the pointers lead nowhere.
struct One {
  One() {
    skeleton.joint_count = 1;
    geometry.slot_count = 4;
    geometry.joint_count = 1;
    geometry.runs = runs;
    geometry.targets = targets;
    mesh.joint_count = 1;
    mesh.targets = mesh_targets;
    mesh.geometry = geometry;
    clip.channels = channels;
    morphed.bind = geometry;
  }
  Run runs[1] = {{4, 1}};
  MorphTarget targets[1];
  MeshTarget mesh_targets[1];
  Channel channels[1];
  Skeleton skeleton;
  Geometry geometry;
  Mesh mesh;
  Clip clip;
  MorphedGeometry morphed;
};

// What is refused of each call, from first to last: all but one argument are left out.
class CallNames : public testing::Test {
 protected:
  void refused(const char* name, Status status) {
    EXPECT_EQ(status, Status::bad_argument) << name;
    const std::vector<test::CallError> heard = errors_.take();
    ASSERT_EQ(heard.size(), 1u) << name;
    EXPECT_EQ(heard[0].function, name);
    EXPECT_GT(heard[0].condition.size(), 3u) << name;
    covered().insert(name);
  }
  static std::set<std::string>& covered() {
    static std::set<std::string> names;
    return names;
  }

  One one_;
  test::CallErrors errors_;
};

// The names of functions that return a Status, from the headers.
std::set<std::string> declared() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(test::in_source("runtime/include/marrow"))) {
    if (entry.path().filename().string().rfind("gles3", 0) == 0) continue;
    std::ifstream in(entry.path());
    const std::regex function(R"(^(?:MARROW_API )?Status (\w+)\()");
    std::smatch found;
    for (std::string line; std::getline(in, line);)
      if (std::regex_search(line, found, function)) names.insert(found[1]);
  }
  return names;
}

#define REFUSED(function, ...) refused(#function, function(__VA_ARGS__))

TEST_F(CallNames, OfPoses) {
  float f = 0;
  Inertia inertia;
  Playback playback;
  JointTransform joint;
  File file;
  REFUSED(load, {}, file);
  REFUSED(bind_clips, File{}, 0, File{}, 0);
  REFUSED(bind_outfit, File{}, 0, File{}, 0, {});
  REFUSED(get_joint, {}, 0, joint);
  REFUSED(set_joint, {}, 0, joint);
  REFUSED(advance, playback, 1, NAN);
  REFUSED(sample, one_.skeleton, one_.clip, 0, {});
  SampleCache cache;
  REFUSED(sample_cached, one_.skeleton, one_.clip, 0, {}, cache);
  REFUSED(sample_additive, one_.skeleton, one_.clip, 0, {});
  REFUSED(sample_channels, one_.clip, 0, {});
  REFUSED(blend, one_.skeleton, {}, {});
  REFUSED(overlay, one_.skeleton, {}, {});
  REFUSED(make_additive, one_.skeleton, {}, {}, {});
  REFUSED(add, one_.skeleton, {}, {});
  REFUSED(cross_fade, one_.skeleton, {}, {}, 0.5f, {});
  REFUSED(begin_inertia, one_.skeleton, {}, 1, inertia);
  REFUSED(apply_inertia, one_.skeleton, {}, 0, {});
  REFUSED(local_to_model, one_.skeleton, {}, {});
  REFUSED(local_to_model_first, one_.skeleton, {}, 1, {});
  REFUSED(local_to_model_below, one_.skeleton, {}, 0, {});
  REFUSED(follow_body, one_.skeleton, {}, {}, {}, {});
  REFUSED(check_curve, {});
  REFUSED(evaluate_curve, {}, 0, {});
  REFUSED(curve_velocity, {}, 0, {});
  REFUSED(natural_spline, {}, {});
  REFUSED(clamped_spline, {}, {}, {}, {});
  REFUSED(bezier, {}, 1, 0, {}, {});
  REFUSED(bezier_rotation, {}, 0, {}, {});
  REFUSED(bicubic_patch, PatchBasis::bezier, {}, 1, 0, 0, {});
  REFUSED(build_arc_length, {}, 1, {});
  REFUSED(time_at_distance, {}, {}, 0, f);
  REFUSED(ease, {.x1 = 2}, 0, f);
}

TEST_F(CallNames, OfReaching) {
  float point[3] = {}, rotation[4] = {};
  RotationFollower turning;
  PointFollower going;
  JointLimit limit;
  Springs springs;
  TwoBoneTurns turns, four[4];
  AimTurn turn;
  const TwoBoneJoints limb = {&kHere, &kHere, &kHere};
  const TwoBone wide = {.weight = 2};
  REFUSED(make_limit, {.kind = static_cast<LimitKind>(9)}, 0, limit);
  REFUSED(clamp_rotation, limit, rotation);
  REFUSED(limit_pose, {limit}, {});
  REFUSED(follow_point, going, point, -1, {});
  REFUSED(follow_rotation, turning, {0, 0, 0, 1}, -1, {});
  REFUSED(follow_pose, {limit}, {}, 0, {});
  REFUSED(two_bone, limb, wide, turns);
  REFUSED(two_bone_x4, {limb, limb, limb, limb}, {wide, wide, wide, wide}, four);
  REFUSED(solve_two_bone, one_.skeleton, {}, {}, {}, {});
  REFUSED(aim, kHere, {.weight = 2}, turn);
  REFUSED(solve_aim, one_.skeleton, 0, {}, {}, {});
  REFUSED(solve_look_at, one_.skeleton, {}, {}, 1, {}, {});
  REFUSED(solve_ik, one_.skeleton, {}, {}, {}, {}, {});
  REFUSED(solve_ik_chain, one_.skeleton, {}, {}, {}, {.method = IkMethod::ccd}, {});
  REFUSED(solve_ik_body, one_.skeleton, {}, {}, {}, {}, {});
  REFUSED(solve_ik_genetic, one_.skeleton, {}, {}, {}, {}, {});
  REFUSED(foot_sole, {}, kHere, {}, point);
  REFUSED(place_feet, one_.skeleton, {}, {}, {}, {}, {}, {});
  REFUSED(make_springs, one_.skeleton, {SpringChain{}}, {}, springs);
  REFUSED(set_springs, one_.skeleton, {}, springs);
  REFUSED(simulate_springs, one_.skeleton, {}, springs, {}, {});
}

TEST_F(CallNames, OfLines) {
  DebugLines lines;
  REFUSED(joint_lines, one_.skeleton, {}, 0, lines);
  REFUSED(limit_lines, one_.skeleton, {}, {}, {}, 0, lines);
  REFUSED(goal_lines, one_.skeleton, {}, {}, 0, 0, lines);
  REFUSED(spring_lines, one_.skeleton, {}, {}, lines);
  REFUSED(collider_lines, one_.skeleton, {}, {}, lines);
  lines.count = 1;
  REFUSED(bounds_lines, Bounds{}, lines);
}

TEST_F(CallNames, OfSkinning) {
  REFUSED(find_weight_channels, {}, one_.mesh, {}, {}, {});
  REFUSED(morph_weights, one_.mesh, {}, {}, {});
  REFUSED(find_example_channels, {}, {{}, 0, {{}, 1}}, {}, {}, {});
  REFUSED(evaluate_examples, {{}, 1}, {}, {});
  REFUSED(make_morphed, one_.geometry, {}, one_.morphed);
  REFUSED(morph, {}, one_.morphed);
  REFUSED(morph_coordinates, one_.morphed, {});
  REFUSED(build_palette, one_.mesh, {}, {});
  Reach reach;
  Bounds bounds;
  REFUSED(make_reach, one_.mesh, {}, reach);
  reach.targets = {nullptr, 1};
  const float not_finite = INFINITY;
  REFUSED(palette_bounds, reach, {}, {&not_finite, 1}, bounds);
  REFUSED(as_coordinates, one_.geometry, {});
  REFUSED(as_tangents, {AsPart{}}, {});
  REFUSED(psd_distances, one_.geometry, {}, {});
  REFUSED(skin_rigid, one_.mesh, {}, {});
  REFUSED(skin_ssd, one_.mesh, {}, {});
  REFUSED(skin_as, one_.mesh, {}, {}, {});
  REFUSED(skin_mwe, one_.mesh, {}, {});
  REFUSED(skin_psd, one_.mesh, {}, {}, {});
}

// After the tests above, in the order in which they stand.
TEST_F(CallNames, OfEveryFunctionInTheHeaders) {
  if (covered().empty()) GTEST_SKIP() << "run alone";
  // What takes a packed file or a character is asked where there is one.
  const std::set<std::string> elsewhere = {"unpack",           "unpack_sizes",   "begin_unpack",     "unpack_step",
                                           "make_animations",  "make_character", "sample_character", "pose_character",
                                           "finish_character", "add_expression", "make_outfit"};
  const std::set<std::string> all = declared();
  EXPECT_GT(all.size(), 60u);
  for (const std::string& name : all)
    EXPECT_TRUE(covered().count(name) || elsewhere.count(name)) << name << " is not asked what it says of a bad call";
}

// A condition that several functions share is told under each one's name, and says which it is.
TEST_F(CallNames, ConditionsAreTold) {
  FootMotion motion[1];
  FootGround ground[1];
  Foot foot[1];
  const std::vector<SoaTransform> rest(1);
  const std::uint16_t parents[1] = {kNoParent};
  one_.skeleton.parents = parents;
  std::vector<SoaTransform> local(1);
  Affine joints[1] = {kHere};
  const auto said = [&](const Feet& feet, const FeetFrame& frame) {
    EXPECT_EQ(place_feet(one_.skeleton, feet, frame, ground, motion, local, joints), Status::bad_argument);
    const std::vector<test::CallError> heard = errors_.take();
    return heard.size() == 1 ? heard[0].function + ": " + heard[0].condition : "not once";
  };
  EXPECT_EQ(said({}, {.dt_s = -1}), "place_feet: within(frame.dt_s, 0, kFarthest)");
  EXPECT_EQ(said({}, {.weight = 2}), "place_feet: within(frame.weight, 0, 1)");
  EXPECT_EQ(said({.reach = 2}, {}), "place_feet: within(call.feet.reach, 0, 1)");
  EXPECT_EQ(said({.ease_s = 0}, {}), "place_feet: within(call.feet.ease_s, 1e-3f, 1e3f)");
  EXPECT_EQ(said({.pelvis = 7}, {}), "place_feet: pelvis == kNoJoint || pelvis < skeleton.joint_count");
  EXPECT_EQ(said({.feet = foot}, {}),
            "place_feet: foot.hip < foot.knee && foot.knee < foot.ankle && foot.ankle < skeleton.joint_count");
}

// load() says in its DataError, too, that the block is not on a boundary.
TEST_F(CallNames, ABlockOffItsBoundary) {
  alignas(16) std::byte block[64] = {};
  File file;
  DataError error;
  EXPECT_EQ(load({block + 4, 32}, file, &error), Status::bad_argument);
  EXPECT_EQ(error.status, Status::bad_argument);
  EXPECT_NE(std::string(error.rule).find("16 bytes"), std::string::npos);
  const std::vector<test::CallError> heard = errors_.take();
  ASSERT_EQ(heard.size(), 1u);
  EXPECT_EQ(heard[0].function, "load");
  EXPECT_EQ(load({block, 32}, file, &error), Status::bad_magic);
  EXPECT_TRUE(errors_.take().empty()) << "bad data is no bad call";
}

}  // namespace
}  // namespace marrow
