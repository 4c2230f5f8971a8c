// Roles of joints of real models, against tables that were written from their names and shapes.
#include <cstdio>
#include <filesystem>

#include <gtest/gtest.h>

#include "common/aligned_bytes.h"
#include "disk/cook_on_disk.h"
#include "marrow/marrow.h"
#include "support/places.h"
#include "unit/cook/cook_text.h"
#include "unit/cook/roles/bodies_with_roles.h"

namespace marrow::cook {
namespace {

// soles: how many. roles: "{l|r}" is what differs between the sides, "{1|2|3}" the joints of a finger. A role without a
// side is one joint, or several of a tail.
struct Model {
  const char* file;
  std::size_t soles;
  const char* roles;
};
const Model kModels[] = {
    {"CesiumMan.glb", 2,
     "hips=Skeleton_torso_joint_1 spine=Skeleton_torso_joint_2 chest=torso_joint_3 neck=Skeleton_neck_joint_1 "
     "head=Skeleton_neck_joint_2 upper_arm=Skeleton_arm_joint_{L__4_|R} "
     "lower_arm=Skeleton_arm_joint_{L__3_|R__2_} hand=Skeleton_arm_joint_{L__2_|R__3_} "
     "upper_leg=leg_joint_{L|R}_1 lower_leg=leg_joint_{L|R}_2 foot=leg_joint_{L|R}_3 toes=leg_joint_{L|R}_5"},
    {"RiggedFigure.glb", 2,
     "hips=torso_joint_1 spine=torso_joint_2 chest=torso_joint_3 neck=neck_joint_1 head=neck_joint_2 "
     "upper_arm=arm_joint_{L|R}_1 lower_arm=arm_joint_{L|R}_2 hand=arm_joint_{L|R}_3 "
     "upper_leg=leg_joint_{L|R}_1 lower_leg=leg_joint_{L|R}_2 foot=leg_joint_{L|R}_3 toes=leg_joint_{L|R}_5"},
    // No hands, no toes, and a second HEAD that only leads the first.
    {"godot_robot.glb", 2,
     "root=MASTER hips=hip spine=waist chest=chest neck=neck head=head upper_arm={l|r}-arm "
     "lower_arm={l|r}-forearm upper_leg={l|r}-thigh lower_leg={l|r}-leg foot={l|r}-foot"},
    // A body, hands and feet that float.
    {"greenman.glb", 0, ""},
    {"Fox.glb", 4,
     "root=_rootJoint hips=b_Hip_01 spine=b_Spine01_02 chest=b_Spine02_03 neck=b_Neck_04 head=b_Head_05 "
     "upper_arm=b_{LeftUpperArm_09|RightUpperArm_06} lower_arm=b_{LeftForeArm_010|RightForeArm_07} "
     "hand=b_{LeftHand_011|RightHand_08} upper_leg=b_{LeftLeg01_015|RightLeg01_019} "
     "lower_leg=b_{LeftLeg02_016|RightLeg02_020} foot=b_{LeftFoot01_017|RightFoot01_021} "
     "toes=b_{LeftFoot02_018|RightFoot02_022} tail=b_Tail01_012,b_Tail02_013,b_Tail03_014"},
    {"KayKit_Knight.glb", 2,
     "root=root hips=hips spine=spine chest=chest head=head upper_arm=upperarm.{l|r} lower_arm=lowerarm.{l|r} "
     "hand=hand.{l|r} upper_leg=upperleg.{l|r} lower_leg=lowerleg.{l|r} foot=foot.{l|r} toes=toes.{l|r}"},
    // Front legs; wings, which hang on "shoulder_l", have no role.
    {"m2m_dragon.glb", 4,
     "root=root hips=hips spine=spine_0 chest=spine_1 neck=spine_2 head=head jaw=mouth_lower "
     "shoulder=front_leg_collar_{l|r} upper_arm=front_leg_{l|r} lower_arm=front_ankle_{l|r} "
     "hand=front_foot_{l|r} upper_leg=back_leg_{l|r} lower_leg=back_ankle_{l|r} foot=back_foot_{l|r} "
     "toes=back_toes_{l|r} tail=tail_1,tail_2,tail_3,tail_4,tail_5,tail_6"},
    {"m2m_shark.glb", 0,
     "root=root hips=pelvis neck=neck head=head tail=tail_1,tail_2,tail_3,tail_4,tail_5,tail_6,tail_7,tail_8"},
    {"m2m_sintel.glb", 2,
     "root=root hips=pelvis spine=spine_01 chest=spine_02 upper_chest=spine_03 neck=neck_01 head=head "
     "shoulder=clavicle_{l|r} upper_arm=upperarm_{l|r} lower_arm=lowerarm_{l|r} hand=hand_{l|r} "
     "upper_leg=thigh_{l|r} lower_leg=calf_{l|r} foot=foot_{l|r} toes=ball_{l|r} thumb=thumb_0{1|2|3}_{l|r} "
     "index=index_0{1|2|3}_{l|r} middle=middle_0{1|2|3}_{l|r} ring=ring_0{1|2|3}_{l|r} "
     "little=pinky_0{1|2|3}_{l|r}"},
    {"mannequiny.glb", 2,
     "hips=pelvis spine=spine_01 chest=spine_02 neck=neck_01 head=head shoulder=clavicle.{l|r} "
     "upper_arm=upperarm.{l|r} lower_arm=lowerarm.{l|r} hand=hand.{l|r} upper_leg=thigh.{l|r} "
     "lower_leg=calf.{l|r} foot=foot.{l|r} toes=ball.{l|r} thumb=thumb_0{1|2|3}.{l|r} "
     "index=index_0{1|2|3}.{l|r} middle=middle_0{1|2|3}.{l|r} ring=ring_0{1|2|3}.{l|r}"},
    // Legs hang on the lowest joint of the spine, and names are of two programs.
    {"pab.glb", 2,
     "root=Hips hips=Pelvis spine=Spine chest=Spine2 upper_chest=Spine3 neck=Neck head=Head "
     "shoulder={Left|Right}Shoulder upper_arm={Left|Right}Arm lower_arm={Left|Right}ForeArm "
     "hand={Lefthand|RightHand} upper_leg={Left|Right}UpLeg lower_leg={Left|Right}Leg foot={Left|Right}Foot "
     "toes={Left|Right}FootThumb1 thumb={Left|Right}HandThumb{1|2|3} index={Left|Right}HandIndex{1|2|3} "
     "middle={Left|Right}HandMiddle{1|2|3} ring={Left|Right}HandRing{1|2|3} "
     "little={LeftHandRing|RightHand}Pinky{1|2|3}"},
    // Feet stand beside the body, which inverse kinematics ties to them.
    {"raylib_robot.glb", 0,
     "root=Bone hips=Body spine=Abdomen chest=Torso neck=Neck head=Head shoulder=Shoulder.{L|R} "
     "upper_arm=UpperArm.{L|R} lower_arm=LowerArm.{L|R} upper_leg=UpperLeg.{L|R} lower_leg=LowerLeg.{L|R} "
     "thumb=Thumb{|2}.{L|R} index=Index{|2}.{L|R} middle=Middle{1|2}.{L|R} ring=Ring{1|2}.{L|R}"},
    {"ruby.glb", 2,
     "root=Bip001_Root hips=Bip001_Pelvis spine=Bip001_Spine chest=Bip001_Spine2 upper_chest=Bip001_Spine3 "
     "neck=Bip001_Neck head=Bip001_Head jaw=Bip001_Jaw eye=Bip001_Eye_{L|R} shoulder=Bip001_Clavicle_{L|R} "
     "upper_arm=Bip001_UpperArm_{L|R} lower_arm=Bip001_Forearm_{L|R} hand=Bip001_Hand_{L|R} "
     "upper_leg=Bip001_Thigh_{L|R} lower_leg=Bip001_Calf_{L|R} foot=Bip001_Foot_{L|R} toes=Bip001_Toe_{L|R} "
     "thumb=Bip001_Thumb{|1|2}_{L|R} index=Bip001_Index{1|2|3}_{L|R} middle=Bip001_Middle{1|2|3}_{L|R} "
     "ring=Bip001_Ring{1|2|3}_{L|R} little=Bip001_Pinky{1|2|3}_{L|R}"},
    // A hand alone, of which no name says which.
    {"webxr_hand_right.glb", 0, ""},
};

std::vector<std::string> choices(const std::string& text, std::size_t& begin, std::size_t& end) {
  begin = text.find('{');
  end = text.find('}', begin);
  std::vector<std::string> out;
  for (std::size_t at = begin + 1; begin != std::string::npos && at <= end;) {
    const std::size_t next = std::min(text.find('|', at), end);
    out.push_back(text.substr(at, next - at));
    at = next + 1;
  }
  return out;
}

// The choice of that number in the pair of braces that has letters, of which sides are; else in the other.
std::string chosen(const std::string& text, bool side, std::size_t number) {
  std::size_t begin = 0, end = 0;
  std::string head, rest = text;
  for (std::vector<std::string> all = choices(rest, begin, end); !all.empty(); all = choices(rest, begin, end)) {
    const bool is_side = all[0].find_first_not_of("0123456789") != std::string::npos;
    if (is_side == side)
      return number < all.size() ? head + rest.substr(0, begin) + all[number] + rest.substr(end + 1) : "";
    head += rest.substr(0, end + 1);
    rest = rest.substr(end + 1);
  }
  return text;
}

RoleTable expected_of(const Model& model) {
  RoleTable out;
  for (const auto& [role, named] : roles_of_text(model.roles)) {
    const bool finger = role == "thumb" || role == "index" || role == "middle" || role == "ring" || role == "little";
    if (named.find('{') == std::string::npos) {
      out[role] = named;
      continue;
    }
    for (const std::size_t side : {0u, 1u}) {
      const std::string on = side == 0 ? "left_" : "right_", joint = chosen(named, true, side);
      if (!finger) {
        out[on + role] = joint;
        continue;
      }
      const char* const segments[] = {role == "thumb" ? "_metacarpal" : "_proximal",
                                      role == "thumb" ? "_proximal" : "_intermediate", "_distal"};
      for (std::size_t i = 0; i < 3; ++i)
        if (const std::string name = chosen(joint, false, i); !name.empty()) out[on + role + segments[i]] = name;
    }
  }
  return out;
}

RoleTable table_in(const File& file, std::uint32_t skeleton) {
  RoleTable out;
  for (const JointRole& r : file.roles(skeleton).roles) {
    std::string& names = out[role_name(r.role)];
    names += (names.empty() ? "" : ",") + std::string(file.text(file.skeleton(skeleton).names[r.joint]));
  }
  return out;
}

// The lowest joint's place and soles' in model space: soles are on the ground, which the models stand on.
void expect_on_ground(const File& file, const Model& model) {
  const Skeleton skeleton = file.skeleton(0);
  std::vector<Affine> rest(skeleton.joint_count);
  ASSERT_EQ(local_to_model(skeleton, {skeleton.rest, skeleton.soa_size()}, rest), Status::ok);
  float high = 0;
  for (const Affine& a : rest) high = std::max(high, a.rows[1][3]);
  const Roles roles = file.roles(0);
  EXPECT_EQ(roles.soles.size, model.soles);
  for (const JointSole& s : roles.soles) {
    float place[3];
    transform_point(rest[s.joint], s.place, place);
    EXPECT_NEAR(place[1] / high, 0, 0.03f) << s.joint;
    const JointSole* const other = sole_of(roles, mirror_of(roles, s.joint));
    EXPECT_NE(other, nullptr);
  }
}

TEST(RoleModels, AreAsInTheirTables) {
  const std::filesystem::path folder = test::assets_folder();
  std::size_t found = 0, wrong = 0, missed = 0, tried = 0;
  for (const Model& model : kModels) {
    const std::filesystem::path path = folder / model.file;
    if (!std::filesystem::exists(path)) {
      std::fprintf(stderr, "SKIPPED: no %s; name its folder in MARROW_ASSETS\n", model.file);
      continue;
    }
    SCOPED_TRACE(model.file);
    const Result cooked = cook_file(path.string(), options_of("--mesh-codec none --clip-codec raw --images none"));
    const tools::AlignedBytes bytes(cooked.file);
    File file;
    ASSERT_EQ(load({bytes.data(), bytes.size()}, file), Status::ok);
    const RoleTable expected = expected_of(model), got = table_in(file, 0);
    EXPECT_EQ(got, expected);
    for (const auto& [role, joint] : got) {
      const auto right = expected.find(role);
      (right != expected.end() && right->second == joint ? found : wrong) += 1;
    }
    for (const auto& [role, joint] : expected) missed += got.contains(role) ? 0 : 1;
    expect_on_ground(file, model);
    ++tried;
  }
  std::printf("%zu models: %zu roles found, %zu missed, %zu wrong\n", tried, found, missed, wrong);
  if (tried == 0) GTEST_SKIP() << "no models; name their folder in MARROW_ASSETS";
}

}  // namespace
}  // namespace marrow::cook
