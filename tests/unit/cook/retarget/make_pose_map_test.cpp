// Poses of another rig at run time: maps that the cooker makes, read by retarget_pose(), against the formula in double
// precision over matrices; and on real models against the clips that the cooker puts there.
#include "cook/retarget/make_pose_map.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "cook/retarget/plan/retarget_plan.h"
#include "cook/retarget/retarget.h"
#include "cook/scene/matrices.h"
#include "cook/skeleton/build_skeletons.h"
#include "support/places.h"
#include "support/rig.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/options_text.h"
#include "unit/cook/retarget/raw_rig.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

PoseMap view_map(const BuiltPoseMap& map) {
  PoseMap out;
  out.skeleton = map.skeleton;
  out.rig_joint_count = map.rig_joint_count;
  out.rig_hash = map.rig_hash;
  out.groups = map.groups;
  out.turns = map.turns;
  out.places = map.places;
  out.steps = map.steps;
  return out;
}

// Matrices of a skeleton's joints in a local pose, and what is above them.
std::vector<glm::dmat4> model_of(const BuiltSkeleton& skeleton, const std::vector<SoaTransform>& local) {
  BuiltSkeleton posed = skeleton;
  posed.rest = local;
  const std::vector<Transform> transforms = rest_transforms(posed);
  std::vector<glm::dmat4> out;
  for (std::size_t j = 0; j < transforms.size(); ++j) {
    const std::uint16_t parent = skeleton.parents[j];
    out.push_back((parent == kNoJoint ? to_matrix(skeleton.model_from_root[j]) : out[parent]) *
                  matrix_of(transforms[j]));
  }
  return out;
}

// Turned from rest by up to 40 degrees a joint, so that what is between several knows which way round it is.
std::vector<SoaTransform> random_pose(const BuiltSkeleton& skeleton, test::Random& random, double moved) {
  std::vector<SoaTransform> out = skeleton.rest;
  const std::vector<Transform> rest = rest_transforms(skeleton);
  for (std::size_t j = 0; j < skeleton.parents.size(); ++j) {
    const auto some = [&] { return random.between(-0.2, 0.2); };
    const double x = some(), y = some(), z = some();
    const glm::dquat q = glm::normalize(rest[j].rotation * glm::dquat(1, x, y, z));
    const double xyzw[4] = {q.x, q.y, q.z, q.w};
    for (std::size_t c = 0; c < 4; ++c) out[j / 4].rotation[c][j % 4] = static_cast<float>(xyzw[c]);
    for (int axis = 0; axis < 3; ++axis)
      out[j / 4].translation[axis][j % 4] += static_cast<float>(random.between(-moved, moved));
  }
  return out;
}

// What a joint's matrix has been multiplied with since rest: a rotation where scales are those of the rest pose.
glm::dquat turn_since(const glm::dmat4& now, const glm::dmat4& rest) {
  return glm::normalize(glm::quat_cast(glm::dmat3(now) * glm::inverse(glm::dmat3(rest))));
}

double farthest_apart(const glm::dmat3& a, const glm::dmat3& b) {
  double out = 0;
  for (int c = 0; c < 3; ++c) out = std::max(out, glm::length(a[c] - b[c]));
  return out;
}

const std::vector<RawRigBone> kRig = {{"A", -1, {0, 1, 0}},      {"B", 0, {0.1, 1.5, 0}},  {"C", 1, {0.5, 1.7, 0.1}},
                                      {"D", 2, {0.7, 2.2, 0.1}}, {"E", 1, {-0.5, 1.8, 0}}, {"F", 0, {-0.3, 0.4, 0}},
                                      {"G", 5, {-0.3, 0.1, 0.2}}};
const std::vector<RawRigBone> kHero = {{"p", -1, {0, 2, 0}},      {"q", 0, {0, 2.4, 0.3}},  {"r", 1, {0.9, 2.5, 0.3}},
                                       {"s", 2, {1.0, 2.6, 0.1}}, {"t", 1, {-0.8, 2.5, 0}}, {"u", 4, {-0.9, 2.0, 0.1}},
                                       {"v", 2, {1.3, 2.6, 0.4}}};
// Between two joints, below one such, nothing at all, and what hangs otherwise.
constexpr const char* kLines =
    "[joints]\np = \"A\"\nq = [\"B\", \"D\", 0.3]\ns = [\"C\", \"E\", 0.75]\nt = \"F\"\nu = \"E\"\nv = \"C\"\n";

struct Mapped {
  Mapped(RawScene hero_scene, RawScene rig_scene, Role role_of_q = Role::none)
      : scene(std::move(rig_scene)), rig(build_skeletons(scene).skeletons.at(0)) {
    character = {"hero.glb", build_skeletons(hero_scene).skeletons};
    hero().name = "hero";
    if (role_of_q != Role::none) character.skeletons[0].roles.roles = {{joint("q"), role_of_q, 0}};
    const RetargetMap lines = parse_retarget_map("map.toml", kLines);
    built = make_pose_map(character, scene, &lines, notes);
    RigPairing pairing = pair_with(character, scene, &lines);
    pairs = pairing.pairs;
    const Take take(scene);
    std::vector<std::size_t> carried = {joint("p")};
    if (role_of_q != Role::none) carried.push_back(joint("q"));
    plan = plan_carrying(carried, hero(), rig, nodes_of_pairs(pairing), take);
    hero_rest = model_of(hero(), hero().rest);
    rig_rest = model_of(rig, rig.rest);
  }
  BuiltSkeleton& hero() { return character.skeletons[0]; }
  std::uint16_t joint(const std::string& name) {
    return static_cast<std::uint16_t>(std::ranges::find(hero().joint_names, name) - hero().joint_names.begin());
  }
  std::size_t rig_joint(const std::string& name) const {
    return static_cast<std::size_t>(std::ranges::find(rig.joint_names, name) - rig.joint_names.begin());
  }
  std::vector<glm::dmat4> put(const std::vector<SoaTransform>& pose) {
    std::vector<SoaTransform> out(hero().rest.size());
    EXPECT_EQ(retarget_pose(view_map(built), pose, view(hero()), out), Status::ok);
    return model_of(hero(), out);
  }
  glm::dquat rig_turn(const Counterpart& at, const std::vector<glm::dmat4>& model) const {
    const glm::dquat one = turn_since(model[to_index(at.node)], rig_rest[to_index(at.node)]);
    if (at.other == kNone) return one;
    const glm::dquat other = turn_since(model[to_index(at.other)], rig_rest[to_index(at.other)]);
    return glm::normalize(one * (1 - at.share) + other * (glm::dot(one, other) < 0 ? -at.share : at.share));
  }

  RawScene scene;
  BuiltSkeleton rig;
  Character character;
  Notes notes;
  BuiltPoseMap built;
  std::vector<Counterpart> pairs;
  RetargetPlan plan;
  std::vector<glm::dmat4> hero_rest, rig_rest;
};

// F · G · F⁻¹ · A, of the joint's rest.
void expect_the_formula(Mapped& of, std::uint64_t seed) {
  test::Random random(seed);
  double worst = 0, farthest = 0;
  for (int i = 0; i < 40; ++i) {
    const std::vector<SoaTransform> pose = random_pose(of.rig, random, 0.5);
    const std::vector<glm::dmat4> model = model_of(of.rig, pose), got = of.put(pose);
    for (std::size_t j = 0; j < got.size(); ++j) {
      if (!of.pairs[j].is_there()) continue;
      const glm::dquat arc = of.plan.joints[j].aligned * glm::conjugate(of.plan.joints[j].turn);
      const glm::dquat& facing = of.plan.facing;
      const glm::dquat turned = facing * of.rig_turn(of.pairs[j], model) * glm::conjugate(facing) * arc;
      const glm::dmat3 expected = glm::mat3_cast(turned) * glm::dmat3(of.hero_rest[j]);
      worst = std::max(worst, farthest_apart(glm::dmat3(got[j]), expected));
    }
    const CarriedJoint& carried = of.plan.carried[0];
    const std::size_t from = of.rig_joint("A");
    const glm::dvec3 expected = glm::dvec3(of.hero_rest[carried.joint][3]) +
                                carried.scale * (of.plan.facing * glm::dvec3(model[from][3] - of.rig_rest[from][3]));
    farthest = std::max(farthest, glm::length(glm::dvec3(got[carried.joint][3]) - expected));
  }
  EXPECT_LE(worst, 1e-5) << seed;
  EXPECT_LE(farthest, 1e-5) << seed;
}

TEST(MakePoseMap, TurnsFollowTheFormula) {
  for (int seed = 1; seed < 6; ++seed) {
    Mapped of(raw_rig(kHero, seed), raw_rig(kRig, 2 * seed + 1));
    expect_the_formula(of, static_cast<std::uint64_t>(seed));
  }
}

// Of a skeleton or a rig in a mirror, or of both.
TEST(MakePoseMap, MirrorsFollowTheFormula) {
  for (const int which : {1, 2, 3}) {
    RawScene hero = raw_rig(kHero, 4), rig = raw_rig(kRig, 3);
    if ((which & 1) != 0) hero.nodes[0].scale.x *= -1;
    if ((which & 2) != 0) rig.nodes[0].scale.x *= -1;
    Mapped of(hero, rig);
    expect_the_formula(of, static_cast<std::uint64_t>(which));
  }
}

// Joints in mirrors within the skeletons.
TEST(MakePoseMap, MirroredJointsFollowTheFormula) {
  for (const int which : {1, 2, 3}) {
    RawScene hero = raw_rig(kHero, 4), rig = raw_rig(kRig, 3);
    if ((which & 1) != 0) hero.nodes[2].scale.x *= -1;
    if ((which & 2) != 0) rig.nodes[2].scale.x *= -1;
    Mapped of(hero, rig);
    expect_the_formula(of, static_cast<std::uint64_t>(which));
  }
}

// Hips go along with the root's turn, and beyond it by as much as the rig's have left their place below its root.
TEST(MakePoseMap, HipsGoAlongWithTheirRoot) {
  Mapped of(raw_rig(kHero, 2), raw_rig(kRig, 3), Role::hips);
  ASSERT_EQ(of.built.places.size(), 2u);
  test::Random random(5);
  const std::size_t a = of.rig_joint("A"), b = of.rig_joint("B"), p = of.joint("p"), q = of.joint("q");
  const double scale = of.plan.carried[1].scale;
  const glm::dquat arc = of.plan.joints[p].aligned * glm::conjugate(of.plan.joints[p].turn);
  for (int i = 0; i < 40; ++i) {
    const std::vector<SoaTransform> pose = random_pose(of.rig, random, 0.5);
    const std::vector<glm::dmat4> model = model_of(of.rig, pose), got = of.put(pose);
    const glm::dquat turned = turn_since(model[a], of.rig_rest[a]);
    const glm::dvec3 rest = of.hero_rest[q][3] - of.hero_rest[p][3], rig_rest = of.rig_rest[b][3] - of.rig_rest[a][3],
                     rig_now = model[b][3] - model[a][3];
    const glm::dquat& facing = of.plan.facing;
    const glm::dvec3 expected = glm::dvec3(got[p][3]) + facing * turned * glm::conjugate(facing) * (arc * rest) +
                                scale * (facing * (rig_now - turned * rig_rest));
    EXPECT_LE(glm::length(glm::dvec3(got[q][3]) - expected), 1e-5);
  }
}

TEST(MakePoseMap, OntoItselfAPoseStaysAsItIs) {
  const RawScene scene = raw_rig(kRig, 3);
  const Character character{"own.glb", build_skeletons(scene).skeletons};
  const BuiltSkeleton& skeleton = character.skeletons[0];
  Notes notes;
  const BuiltPoseMap map = make_pose_map(character, scene, nullptr, notes);
  EXPECT_TRUE(notes.warnings.empty());
  EXPECT_EQ(map.turns.size(), 0u) << "all in their groups";
  EXPECT_EQ(map.steps.size(), 1u);
  test::Random random(9);
  double worst = 0;
  for (int i = 0; i < 40; ++i) {
    std::vector<SoaTransform> pose = random_pose(skeleton, random, 0), out(pose.size());
    for (int axis = 0; axis < 3; ++axis) pose[0].translation[axis][0] += static_cast<float>(random.between(-2, 2));
    ASSERT_EQ(retarget_pose(view_map(map), pose, view(skeleton), out), Status::ok);
    const std::vector<glm::dmat4> expected = model_of(skeleton, pose), got = model_of(skeleton, out);
    for (std::size_t j = 0; j < got.size(); ++j) {
      worst = std::max(worst, farthest_apart(glm::dmat3(got[j]), glm::dmat3(expected[j])));
      worst = std::max(worst, glm::length(glm::dvec3(got[j][3] - expected[j][3])));
    }
  }
  std::printf("onto itself: %.2g off\n", worst);
  EXPECT_LE(worst, 2e-6);
}

// A joint that nothing turns stays as it is below its parent.
TEST(MakePoseMap, OthersRest) {
  Mapped of(raw_rig(kHero, 2), raw_rig(kRig, 3));
  test::Random random(5);
  std::vector<SoaTransform> out(of.hero().rest.size());
  ASSERT_EQ(retarget_pose(view_map(of.built), random_pose(of.rig, random, 1), view(of.hero()), out), Status::ok);
  const std::size_t r = of.joint("r");
  for (int c = 0; c < 4; ++c)
    EXPECT_NEAR(out[r / 4].rotation[c][r % 4], of.hero().rest[r / 4].rotation[c][r % 4], 2e-7) << c;
}

// Motion capture hangs its hips at the origin at rest, and says where they are in each frame.
TEST(MakePoseMap, WhatRestsHungUpIsWhereItSays) {
  const std::vector<RawRigBone> bones = {
      {"hips", -1, {0, 0, 0}}, {"leg", 0, {0.1, -0.1, 0}}, {"foot", 1, {0.1, -0.9, 0}}};
  const std::vector<RawRigBone> tall = {{"hips", -1, {0, 1.8, 0}}, {"leg", 0, {0.2, 1.6, 0}}, {"foot", 1, {0.2, 0, 0}}};
  const RawScene scene = raw_rig(bones, 0), other = raw_rig(tall, 0);
  const Character character{"hero.glb", build_skeletons(other).skeletons};
  const BuiltSkeleton rig = build_skeletons(scene).skeletons.at(0);
  Notes notes;
  const BuiltPoseMap map = make_pose_map(character, scene, nullptr, notes);
  std::vector<SoaTransform> pose = rig.rest, out(1);
  const glm::dmat4 above = to_matrix(rig.model_from_root[0]);
  const glm::dvec3 now = glm::dvec3(glm::inverse(above) * glm::dvec4(0.3, 0.9, -0.2, 1));
  for (int axis = 0; axis < 3; ++axis) pose[0].translation[axis][0] = static_cast<float>(now[axis]);
  ASSERT_EQ(retarget_pose(view_map(map), pose, view(character.skeletons[0]), out), Status::ok);
  const glm::dvec3 at = model_of(character.skeletons[0], out)[0][3];
  const glm::dvec3 origin = to_matrix(character.skeletons[0].model_from_root[0])[3];
  EXPECT_NEAR(at.y - origin.y, 1.8, 0.2) << "twice as high";
  EXPECT_NEAR(at.x - origin.x, 0.6, 0.1);
}

CookOptions for_models() {
  return options_of("--mesh-codec none --images none --clip-codec raw");
}

std::vector<glm::dquat> model_turns(const Skeleton& skeleton, const std::vector<SoaTransform>& local) {
  std::vector<glm::dquat> out;
  for (std::uint32_t j = 0; j < skeleton.joint_count; ++j) {
    const auto& r = local[j / 4].rotation;
    const glm::dquat q(r[3][j % 4], r[0][j % 4], r[1][j % 4], r[2][j % 4]);
    out.push_back(glm::normalize(skeleton.parents[j] == kNoJoint ? q : out[skeleton.parents[j]] * q));
  }
  return out;
}

glm::dvec3 place_of_joint(const Skeleton& skeleton, const std::vector<SoaTransform>& local, std::uint32_t joint) {
  std::vector<Affine> model(skeleton.joint_count);
  EXPECT_EQ(local_to_model(skeleton, local, model), Status::ok);
  return {model[joint].rows[0][3], model[joint].rows[1][3], model[joint].rows[2][3]};
}

// The walk of one body, frame by frame, beside the clip that the cooker makes of it.
TEST(MakePoseMap, OfARealModelIsWhatTheCookerMakes) {
  const std::string source = test::assets_folder() + "/pab.glb";
  if (!std::filesystem::exists(source)) GTEST_SKIP() << "no models; name their folder in MARROW_ASSETS";
  const LoadedCook rig(cook_file(source, for_models()));
  const Skeleton rig_skeleton = rig.file.skeleton(0);
  const Clip walk = rig.file.clip(rig.file.find_clip("pab_walk_raw"));
  for (const char* const name : {"mannequiny", "KayKit_Knight"}) {
    CookOptions options = for_models();
    options.retarget.clips = options.retarget.poses = {{source, "", {}}};
    const LoadedCook hero(cook_file(test::assets_folder() + "/" + name + ".glb", options));
    ASSERT_EQ(hero.file.pose_map_count(), 1u);
    const PoseMap map = hero.file.pose_map(hero.file.find_pose_map("pab"));
    EXPECT_EQ(map.rig_hash, skeleton_hash(rig.file, 0));
    EXPECT_NE(map.rig_hash, skeleton_hash(hero.file, 0));
    const Skeleton skeleton = hero.file.skeleton(map.skeleton);
    const Clip made = hero.file.clip(hero.file.find_clip("pab_walk_raw", map.skeleton));
    const Roles roles = hero.file.roles(map.skeleton);
    const auto is_bent = [&](std::uint32_t joint) {
      for (; joint != kNoJoint; joint = skeleton.parents[joint]) switch (role_of(roles, joint)) {
          case Role::left_upper_leg:
          case Role::right_upper_leg:
            return true;
          default:
            break;
        }
      return false;
    };
    std::vector<SoaTransform> pose(rig_skeleton.soa_size()), out(skeleton.soa_size()), clip(out);
    double worst = 0, legs = 0, hips_m = 0;
    std::size_t compared = 0;
    for (int i = 0; i <= 30; ++i) {
      const float time_s = walk.times_s[0] + walk.duration_s * static_cast<float>(i) / 30;
      ASSERT_EQ(sample(rig_skeleton, walk, time_s, pose), Status::ok);
      ASSERT_EQ(sample(skeleton, made, time_s, clip), Status::ok);
      ASSERT_EQ(retarget_pose(map, pose, skeleton, out), Status::ok);
      const std::vector<glm::dquat> a = model_turns(skeleton, out), b = model_turns(skeleton, clip);
      for (std::uint32_t j = 0; j < skeleton.joint_count; ++j) {
        double& of = is_bent(j) ? legs : worst;
        of = std::max(of, angle_between(a[j], b[j]));
        compared += is_bent(j) ? 0 : 1;
      }
      const std::uint32_t hips = joint_of(roles, Role::hips);
      hips_m =
          std::max(hips_m, glm::length(place_of_joint(skeleton, out, hips) - place_of_joint(skeleton, clip, hips)));
    }
    std::printf("%-14s %zu turns beside the groups, %.2g rad apart; legs %.2g rad, hips %.3f m\n", name, map.turns.size,
                worst, legs, hips_m);
    EXPECT_GT(compared, 300u);
    EXPECT_LE(worst, 1e-3) << name;
    EXPECT_LE(hips_m, 0.05) << name;
  }
}

}  // namespace
}  // namespace marrow::cook
