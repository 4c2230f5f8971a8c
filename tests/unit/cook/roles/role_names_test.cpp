// Roles of joints by names: one body, called as many programs call it.
#include <gtest/gtest.h>

#include "common/failure.h"
#include "unit/cook/roles/bodies_with_roles.h"

namespace marrow::cook {
namespace {

// A joint of the body: its role, that of the joint that it hangs on, and where it is on the left side or in the middle.
struct Slot {
  const char *role, *parent;
  glm::dvec3 place;
};
const Slot kSlots[] = {
    {"root", "", {0, 0, 0}},
    {"hips", "root", {0, 1, 0}},
    {"spine", "hips", {0, 1.1, 0}},
    {"chest", "spine", {0, 1.2, 0}},
    {"upper_chest", "chest", {0, 1.35, 0}},
    {"neck", "upper_chest", {0, 1.5, 0}},
    {"head", "neck", {0, 1.6, 0}},
    {"left_shoulder", "upper_chest", {0.05, 1.45, 0}},
    {"left_upper_arm", "left_shoulder", {0.2, 1.45, 0}},
    {"left_lower_arm", "left_upper_arm", {0.45, 1.4, 0}},
    {"left_hand", "left_lower_arm", {0.7, 1.35, 0}},
    {"left_upper_leg", "hips", {0.1, 0.95, 0}},
    {"left_lower_leg", "left_upper_leg", {0.1, 0.5, 0.02}},
    {"left_foot", "left_lower_leg", {0.1, 0.1, 0}},
    {"left_toes", "left_foot", {0.1, 0.02, 0.12}},
};

std::string other(const std::string& role) {
  return role.starts_with("left_") ? "right_" + role.substr(5) : role;
}

// What each slot is called on both sides; "" or missing: not there, its children hang on its parent.
using NamesOfRoles = std::map<std::string, std::pair<std::string, std::string>>;

std::string parent_in(const NamesOfRoles& names, const std::string& role, bool right) {
  for (std::string at = role;;) {
    const auto slot = std::find_if(std::begin(kSlots), std::end(kSlots), [&](const Slot& s) { return at == s.role; });
    at = slot->parent;
    if (at.empty()) return "";
    if (const auto found = names.find(at); found != names.end())
      return right && at.starts_with("left_") ? found->second.second : found->second.first;
  }
}

std::vector<BodyJoint> joints_of(const NamesOfRoles& names) {
  std::vector<BodyJoint> out;
  for (const Slot& slot : kSlots) {
    const auto found = names.find(slot.role);
    if (found == names.end()) continue;
    out.push_back({found->second.first, parent_in(names, slot.role, false), slot.place});
    if (other(slot.role) == slot.role) continue;
    out.push_back(
        {found->second.second, parent_in(names, slot.role, true), {-slot.place.x, slot.place.y, slot.place.z}});
  }
  return out;
}

RoleTable table_of(const NamesOfRoles& names) {
  RoleTable out;
  for (const auto& [role, called] : names) {
    out[role] = called.first;
    if (other(role) != role) out[other(role)] = called.second;
  }
  return out;
}

// From the left side's names: `left` in them becomes `right`.
NamesOfRoles with_sides(const std::map<std::string, std::string>& names, const std::string& left,
                        const std::string& right) {
  NamesOfRoles out;
  for (const auto& [role, name] : names) {
    std::string mirrored = name;
    if (role.starts_with("left_")) {
      const std::size_t at = name.find(left);
      EXPECT_NE(at, std::string::npos) << name;
      mirrored.replace(at, left.size(), right);
    }
    out[role] = {name, mirrored};
  }
  return out;
}

// names: of the slots in their order, with "-" for what is not there. more: joints that get no role, see
// joints_of_text().
struct Convention {
  const char *name, *left, *right, *names, *more = "";
};
const Convention kConventions[] = {
    {"Godot", "Left", "Right",
     "Root, Hips, Spine, Chest, UpperChest, Neck, Head, LeftShoulder, LeftUpperArm, LeftLowerArm, LeftHand, "
     "LeftUpperLeg, LeftLowerLeg, LeftFoot, LeftToes"},
    {"Mixamo", "Left", "Right",
     "-, mixamorig1:Hips, mixamorig1:Spine, mixamorig1:Spine1, mixamorig1:Spine2, mixamorig1:Neck, "
     "mixamorig1:Head, mixamorig1:LeftShoulder, mixamorig1:LeftArm, mixamorig1:LeftForeArm, mixamorig1:LeftHand, "
     "mixamorig1:LeftUpLeg, mixamorig1:LeftLeg, mixamorig1:LeftFoot, mixamorig1:LeftToeBase",
     "mixamorig1:HeadTop_End < mixamorig1:Head 0 1.8 0; "
     "mixamorig1:LeftToe_End < mixamorig1:LeftToeBase 0.1 0.02 0.2"},
    {"Unreal", "_l", "_r",
     "root, pelvis, spine_01, spine_02, spine_03, neck_01, head, clavicle_l, upperarm_l, lowerarm_l, hand_l, "
     "thigh_l, calf_l, foot_l, ball_l",
     "thigh_twist_01_l < thigh_l 0.1 0.8 0; ik_foot_root < root 0 0 0; ik_foot_l < ik_foot_root 0.1 0.1 0; "
     "ik_hand_root < root 0 0 0; ik_hand_l < ik_hand_root 0.7 1.35 0; "
     "lowerarm_correctiveRoot_l < lowerarm_l 0.45 1.4 0; calf_kneeBack_l < calf_l 0.1 0.5 -0.05; "
     "weapon_l < hand_l 0.75 1.35 0"},
    {"Rigify", ".L", ".R",
     "-, DEF-spine, DEF-spine.001, DEF-spine.002, DEF-spine.003, DEF-spine.004, DEF-spine.006, DEF-shoulder.L, "
     "DEF-upper_arm.L, DEF-forearm.L, DEF-hand.L, DEF-thigh.L, DEF-shin.L, DEF-foot.L, DEF-toe.L",
     "DEF-thigh.L.001 < DEF-thigh.L 0.1 0.7 0; MCH-foot_roll.L < DEF-foot.L 0.1 0.1 0; "
     "DEF-pelvis.L < DEF-spine 0.05 1.02 0; DEF-breast.L < DEF-spine.003 0.1 1.3 0.1; "
     "thigh_ik.L < DEF-spine 0.1 0.95 0; foot_ik.L < thigh_ik.L 0.1 0.1 0"},
    {"3ds Max", " L ", " R ",
     "Bip01, Bip01 Pelvis, Bip01 Spine, Bip01 Spine1, Bip01 Spine2, Bip01 Neck, Bip01 Head, Bip01 L Clavicle, "
     "Bip01 L UpperArm, Bip01 L Forearm, Bip01 L Hand, Bip01 L Thigh, Bip01 L Calf, Bip01 L Foot, Bip01 L Toe0",
     "Bip01 HeadNub < Bip01 Head 0 1.8 0; Bip01 L Toe0Nub < Bip01 L Toe0 0.1 0.02 0.2; "
     "Bip01 Footsteps < Bip01 0 0 0"},
    {"MakeHuman", ".L", ".R",
     "-, root, spine05, spine02, spine01, neck01, head, clavicle.L, upperarm01.L, lowerarm01.L, wrist.L, "
     "upperleg01.L, lowerleg01.L, foot.L, -",
     "upperarm02.L < upperarm01.L 0.3 1.42 0; toe1-1.L < foot.L 0.08 0.02 0.1; toe2-1.L < foot.L 0.1 0.02 0.1; "
     "pelvis.L < root 0.05 1 0"},
    {"CMU", "Left", "Right",
     "-, Hips, LowerBack, Spine, Spine1, Neck, Head, LeftShoulder, LeftArm, LeftForeArm, LeftHand, LeftUpLeg, "
     "LeftLeg, LeftFoot, LeftToeBase",
     "LHipJoint < Hips 0.02 1 0; LeftFingerBase < LeftHand 0.75 1.35 0"},
    {"BVH", "Left", "Right",
     "-, Hips, Chest, Chest2, -, Neck, Head, LeftCollar, LeftShoulder, LeftElbow, LeftWrist, LeftHip, LeftKnee, "
     "LeftAnkle, LeftToe"},
    {"DAZ", "l", "r",
     "-, hip, abdomenLower, chestLower, chestUpper, neckLower, head, lCollar, lShldrBend, lForearmBend, lHand, "
     "lThighBend, lShin, lFoot, lToe",
     "lShldrTwist < lShldrBend 0.3 1.42 0; lBigToe < lToe 0.08 0 0.2"},
    {"VRoid", "_L_", "_R_",
     "Root, J_Bip_C_Hips, J_Bip_C_Spine, J_Bip_C_Chest, J_Bip_C_UpperChest, J_Bip_C_Neck, J_Bip_C_Head, "
     "J_Bip_L_Shoulder, J_Bip_L_UpperArm, J_Bip_L_LowerArm, J_Bip_L_Hand, J_Bip_L_UpperLeg, J_Bip_L_LowerLeg, "
     "J_Bip_L_Foot, J_Bip_L_ToeBase"},
    {"in small letters", "left", "right",
     "-, hips, spine, chest, -, neck, head, leftshoulder, leftupperarm, leftforearm, lefthand, leftupleg, "
     "leftleg, leftfoot, lefttoebase"},
    {"with a name before all", "L_", "R_",
     "-, Hero_Hips, Hero_Spine, Hero_Chest, -, Hero_Neck, Hero_Head, -, Hero_L_UpperArm, Hero_L_Elbow, "
     "Hero_L_Hand, Hero_L_Thigh, Hero_L_Knee, Hero_L_Foot, -"},
};

NamesOfRoles names_of(const Convention& convention) {
  std::map<std::string, std::string> out;
  const std::vector<std::string> names = tokens(convention.names, ", ");
  EXPECT_EQ(names.size(), std::size(kSlots)) << convention.name;
  for (std::size_t s = 0; s < names.size(); ++s)
    if (names[s] != "-") out[kSlots[s].role] = names[s];
  return with_sides(out, convention.left, convention.right);
}

TEST(RoleNames, OfManyPrograms) {
  std::size_t tried = 0;
  for (const Convention& c : kConventions) {
    SCOPED_TRACE(c.name);
    const NamesOfRoles names = names_of(c);
    std::vector<BodyJoint> joints = joints_of(names);
    const std::vector<BodyJoint> more = joints_of_text(c.more);
    joints.insert(joints.end(), more.begin(), more.end());
    const FoundRoles found = find_roles_of(scene_of(joints));
    EXPECT_EQ(found.table, table_of(names));
    EXPECT_TRUE(found.warnings.empty()) << found.warnings[0].text;
    for (const auto& [role, called] : names)
      if (other(role) != role) EXPECT_TRUE(found.has_pair(called.first, called.second)) << role;
    ++tried;
  }
  EXPECT_EQ(tried, 12u);
}

const NamesOfRoles& plain_names() {
  static const NamesOfRoles names = names_of(kConventions[0]);
  return names;
}

FoundRoles find_with(std::vector<BodyJoint> more, const std::vector<RoleRule>& rules = {}, bool behind = true) {
  std::vector<BodyJoint> joints = joints_of(plain_names());
  joints.insert(behind ? joints.end() : joints.begin(), more.begin(), more.end());
  return find_roles_of(scene_of(joints), rules);
}

// chain: from the hand out; those in brackets get no role. first: the role of the first that gets one.
TEST(RoleNames, OfFingers) {
  const struct {
    const char *what, *first, *chain;
  } fingers[] = {{"Mixamo", "left_index_proximal", "LeftHandIndex1, LeftHandIndex2, LeftHandIndex3, (LeftHandIndex4)"},
                 {"Unreal 5", "left_ring_proximal", "(ring_metacarpal_l), ring_01_l, ring_02_l, ring_03_l"},
                 {"Godot", "left_little_proximal", "LeftLittleProximal, LeftLittleIntermediate, LeftLittleDistal"},
                 {"a thumb", "left_thumb_metacarpal", "LeftThumbMetacarpal, LeftThumbProximal, LeftThumbDistal"},
                 {"a thumb with an end", "left_thumb_metacarpal", "Thumb.L, Thumb1.L, Thumb2.L, (Thumb3.L)"},
                 {"3ds Max", "left_thumb_metacarpal", "Bip01 L Finger0, Bip01 L Finger01, Bip01 L Finger02"},
                 {"MakeHuman", "left_index_proximal", "(metacarpal1.L), finger2-1.L, finger2-2.L, finger2-3.L"},
                 {"Rigify", "left_middle_proximal", "(palm.02.L), f_middle.01.L, f_middle.02.L, f_middle.03.L"},
                 {"two joints", "left_index_proximal", "Index.L, Index2.L"}};
  for (const auto& f : fingers) {
    SCOPED_TRACE(f.what);
    std::vector<BodyJoint> more;
    RoleTable expected = table_of(plain_names());
    std::string parent = "LeftHand";
    auto role = static_cast<std::size_t>(find_role(f.first));
    for (std::string name : tokens(f.chain, ", ")) {
      const bool has_role = name[0] != '(';
      if (!has_role) name = name.substr(1, name.size() - 2);
      if (has_role) expected[role_name(static_cast<Role>(role++))] = name;
      more.push_back({name, parent, {0.75 + 0.03 * static_cast<double>(more.size()), 1.35, 0}});
      parent = name;
    }
    EXPECT_EQ(find_with(more).table, expected);
  }
}

TEST(RoleNames, OfFacesAndTails) {
  const FoundRoles found = find_with(joints_of_text(
      "eye_L < Head 0.03 1.65 0.08; eye_R < Head -0.03 1.65 0.08; eyelid_L < Head 0.03 1.66 0.08; "
      "eyebrow_L < Head 0.03 1.68 0.08; jaw < Head 0 1.58 0.05; jaw_end < jaw 0 1.55 0.1; hair_tail < Head 0 1.7 -0.1; "
      "tail < Hips 0 0.95 -0.1; tail.001 < tail 0 0.9 -0.2; tail_tip < tail.001 0 0.85 -0.3"));
  RoleTable expected = table_of(plain_names());
  expected.merge(roles_of_text("left_eye=eye_L right_eye=eye_R jaw=jaw tail=tail,tail.001"));
  EXPECT_EQ(found.table, expected);
}

// Whatever hangs about: none of it gets a role, and no role is lost to it.
TEST(RoleNames, OfHelpersAreNone) {
  const char* const helpers[] = {
      "LeftUpLegTwist",  "LeftForeArmRoll1", "LeftFootIK",       "foot_ctrl.L",     "LeftHandSocket",
      "Head_End",        "LeftToesNub",      "knee_pole.L",      "LeftFoot_helper", "skirt.L",
      "LeftShoulderPad", "weapon_hand_L",    "wing_upper_arm.L", "ear.L",           "HairTail"};
  const RoleTable expected = table_of(plain_names());
  for (const char* const name : helpers)
    for (const char* const parent : {"LeftUpperLeg", "LeftFoot", "LeftHand", "Head", "Hips", "Root"})
      EXPECT_EQ(find_with({{name, parent, {0.2, 0.5, 0.1}}}).table, expected) << name << " below " << parent;
}

// A foot that something else moves is no foot of the leg.
TEST(RoleNames, MustHangWhereTheyBelong) {
  NamesOfRoles names = plain_names();
  names.erase("left_foot");
  names.erase("left_toes");
  std::vector<BodyJoint> joints = joints_of(names);
  joints.push_back({"LeftFoot", "Root", {0.1, 0.1, 0}});
  joints.push_back({"RightFoot", "Root", {-0.1, 0.1, 0}});
  const FoundRoles found = find_roles_of(scene_of(joints));
  EXPECT_EQ(found.table, table_of(names));
  ASSERT_EQ(found.warnings.size(), 2u);
  EXPECT_EQ(found.warnings[0].rule, "role-in-doubt");
  EXPECT_NE(found.warnings[0].text.find("\"LeftFoot\""), std::string::npos) << found.warnings[0].text;
}

TEST(RoleNames, OfTwoBodiesInOneAreInDoubt) {
  std::vector<BodyJoint> joints = joints_of(plain_names());
  for (const BodyJoint& j : joints_of(plain_names()))
    if (!j.parent.empty())
      joints.push_back({j.name + "_2", j.parent == "Root" ? "Root" : j.parent + "_2", j.place + glm::dvec3(2, 0, 0)});
  for (const auto& [role, joint] : find_roles_of(scene_of(joints)).table)
    EXPECT_TRUE(role == "root" || role == "hips") << role << " " << joint;
}

TEST(RoleNames, OfCrossedSidesAreLeftOut) {
  NamesOfRoles names = plain_names();
  for (auto& [role, called] : names)
    if (role == "left_upper_arm" || role == "left_lower_arm" || role == "left_hand" || role == "left_shoulder")
      std::swap(called.first, called.second);
  const FoundRoles found = find_roles_of(scene_of(joints_of(names)));
  for (const auto& [role, joint] : found.table) EXPECT_EQ(role.find("left_"), std::string::npos) << joint;
  EXPECT_FALSE(found.warnings.empty());
}

// The character looks back: its left is where x is less, and names say so.
TEST(RoleNames, DecideSidesOfWhatLooksBack) {
  std::vector<BodyJoint> joints = joints_of(plain_names());
  for (BodyJoint& j : joints) j.place = {-j.place.x, j.place.y, -j.place.z};
  const FoundRoles found = find_roles_of(scene_of(joints));
  EXPECT_EQ(found.table, table_of(plain_names()));
  EXPECT_TRUE(found.has_pair("LeftFoot", "RightFoot"));
}

TEST(RoleNames, OfFilesOutrankNames) {
  RawScene scene = scene_of(joints_of(plain_names()));
  const auto say = [&](const std::string& joint, const std::string& bone) {
    for (RawNode& node : scene.nodes)
      if (node.name == joint) node.extras.push_back({"vrm/humanoid", PropertyType::text, 0, bone});
  };
  say("Hips", "hips");
  say("Chest", "spine");  // the file says so, whatever it is called
  say("LeftUpperArm", "leftUpperArm");
  say("LeftHand", "leftThumbProximal");  // of VRM 0, as the next one shows
  say("RightHand", "leftThumbIntermediate");
  EXPECT_EQ(find_roles_of(scene).table, roles_of_text("root=Root hips=Hips spine=Chest left_upper_arm=LeftUpperArm "
                                                      "left_thumb_metacarpal=LeftHand left_thumb_proximal=RightHand"));
}

TEST(RoleRules, ReplaceWhatIsFound) {
  const FoundRoles found = find_with({{"tail", "Hips", {0, 0.9, -0.1}}, {"stump", "tail", {0, 0.9, -0.2}}},
                                     {{Role::left_hand, "LeftLowerArm"}, {Role::head, ""}, {Role::tail, "tail"}});
  RoleTable expected = table_of(plain_names());
  expected["left_hand"] = "LeftLowerArm";
  expected.erase("left_lower_arm");
  expected.erase("head");
  expected["tail"] = "tail,stump";
  EXPECT_EQ(found.table, expected);
}

TEST(RoleRules, OfAJointThatIsNotThereAreRefused) {
  for (const bool must_fit : {true, false}) {
    try {
      find_with({}, {{Role::head, "Hed", {"marrow.toml", "3:8", must_fit}}});
      ADD_FAILURE();
    } catch (const tools::Failure& failure) {
      const std::string text = failure.what();
      EXPECT_NE(text.find("marrow.toml: 3:8"), std::string::npos) << text;
      EXPECT_NE(text.find("no joint \"Hed\" for head"), std::string::npos) << text;
      EXPECT_NE(text.find("did you mean \"Head\"?"), std::string::npos) << text;
    }
  }
  // Settings for many files, of which this is none.
  EXPECT_EQ(find_with({}, {{Role::head, "kopf", {"marrow.toml", "3:8", false}}}).table, table_of(plain_names()));
  EXPECT_THROW(find_with({}, {{Role::head, "kopf", {"--roles", "", true}}}), tools::Failure);
}

// Without any names: a body's shape says the same.
TEST(RoleShapes, SayWhatNamesDoNot) {
  std::vector<BodyJoint> joints = joints_of(plain_names());
  std::map<std::string, std::string> number;
  for (std::size_t i = 0; i < joints.size(); ++i) number[joints[i].name] = "joint_" + std::to_string(i);
  for (const bool back : {false, true}) {
    std::vector<BodyJoint> nameless = joints;
    for (BodyJoint& j : nameless) {
      j.name = number[j.name];
      j.parent = j.parent.empty() ? "" : number[j.parent];
      if (back) j.place = {-j.place.x, j.place.y, -j.place.z};
    }
    // Something behind the toes, for a last joint may be an end.
    for (const char* const toes : {"LeftToes", "RightToes"})
      for (const BodyJoint& j : joints)
        if (j.name == toes) {
          const double side = back ? -1 : 1;
          nameless.push_back({number[toes] + "_9", number[toes], {side * j.place.x, 0, side * 0.2}});
        }
    RoleTable expected;
    for (const auto& [role, joint] : table_of(plain_names())) expected[role] = number[joint];
    EXPECT_EQ(find_roles_of(scene_of(nameless)).table, expected) << back;
  }
}

}  // namespace
}  // namespace marrow::cook
