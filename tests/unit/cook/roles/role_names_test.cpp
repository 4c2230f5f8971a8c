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

struct Convention {
  const char *name, *left, *right;
  std::map<std::string, std::string> names;
  std::vector<BodyJoint> more = {};  // that get no role
};

std::vector<Convention> conventions() {
  return {
      {"Godot",
       "Left",
       "Right",
       {{"root", "Root"},
        {"hips", "Hips"},
        {"spine", "Spine"},
        {"chest", "Chest"},
        {"upper_chest", "UpperChest"},
        {"neck", "Neck"},
        {"head", "Head"},
        {"left_shoulder", "LeftShoulder"},
        {"left_upper_arm", "LeftUpperArm"},
        {"left_lower_arm", "LeftLowerArm"},
        {"left_hand", "LeftHand"},
        {"left_upper_leg", "LeftUpperLeg"},
        {"left_lower_leg", "LeftLowerLeg"},
        {"left_foot", "LeftFoot"},
        {"left_toes", "LeftToes"}}},
      {"Mixamo",
       "Left",
       "Right",
       {{"hips", "mixamorig1:Hips"},
        {"spine", "mixamorig1:Spine"},
        {"chest", "mixamorig1:Spine1"},
        {"upper_chest", "mixamorig1:Spine2"},
        {"neck", "mixamorig1:Neck"},
        {"head", "mixamorig1:Head"},
        {"left_shoulder", "mixamorig1:LeftShoulder"},
        {"left_upper_arm", "mixamorig1:LeftArm"},
        {"left_lower_arm", "mixamorig1:LeftForeArm"},
        {"left_hand", "mixamorig1:LeftHand"},
        {"left_upper_leg", "mixamorig1:LeftUpLeg"},
        {"left_lower_leg", "mixamorig1:LeftLeg"},
        {"left_foot", "mixamorig1:LeftFoot"},
        {"left_toes", "mixamorig1:LeftToeBase"}},
       {{"mixamorig1:HeadTop_End", "mixamorig1:Head", {0, 1.8, 0}},
        {"mixamorig1:LeftToe_End", "mixamorig1:LeftToeBase", {0.1, 0.02, 0.2}}}},
      {"Unreal",
       "_l",
       "_r",
       {{"root", "root"},
        {"hips", "pelvis"},
        {"spine", "spine_01"},
        {"chest", "spine_02"},
        {"upper_chest", "spine_03"},
        {"neck", "neck_01"},
        {"head", "head"},
        {"left_shoulder", "clavicle_l"},
        {"left_upper_arm", "upperarm_l"},
        {"left_lower_arm", "lowerarm_l"},
        {"left_hand", "hand_l"},
        {"left_upper_leg", "thigh_l"},
        {"left_lower_leg", "calf_l"},
        {"left_foot", "foot_l"},
        {"left_toes", "ball_l"}},
       {{"thigh_twist_01_l", "thigh_l", {0.1, 0.8, 0}},
        {"ik_foot_root", "root", {0, 0, 0}},
        {"ik_foot_l", "ik_foot_root", {0.1, 0.1, 0}},
        {"ik_hand_root", "root", {0, 0, 0}},
        {"ik_hand_l", "ik_hand_root", {0.7, 1.35, 0}},
        {"lowerarm_correctiveRoot_l", "lowerarm_l", {0.45, 1.4, 0}},
        {"calf_kneeBack_l", "calf_l", {0.1, 0.5, -0.05}},
        {"weapon_l", "hand_l", {0.75, 1.35, 0}}}},
      {"Rigify",
       ".L",
       ".R",
       {{"hips", "DEF-spine"},
        {"spine", "DEF-spine.001"},
        {"chest", "DEF-spine.002"},
        {"upper_chest", "DEF-spine.003"},
        {"neck", "DEF-spine.004"},
        {"head", "DEF-spine.006"},
        {"left_shoulder", "DEF-shoulder.L"},
        {"left_upper_arm", "DEF-upper_arm.L"},
        {"left_lower_arm", "DEF-forearm.L"},
        {"left_hand", "DEF-hand.L"},
        {"left_upper_leg", "DEF-thigh.L"},
        {"left_lower_leg", "DEF-shin.L"},
        {"left_foot", "DEF-foot.L"},
        {"left_toes", "DEF-toe.L"}},
       {{"DEF-thigh.L.001", "DEF-thigh.L", {0.1, 0.7, 0}},
        {"MCH-foot_roll.L", "DEF-foot.L", {0.1, 0.1, 0}},
        {"DEF-pelvis.L", "DEF-spine", {0.05, 1.02, 0}},
        {"DEF-breast.L", "DEF-spine.003", {0.1, 1.3, 0.1}},
        {"thigh_ik.L", "DEF-spine", {0.1, 0.95, 0}},
        {"foot_ik.L", "thigh_ik.L", {0.1, 0.1, 0}}}},
      {"3ds Max",
       " L ",
       " R ",
       {{"root", "Bip01"},
        {"hips", "Bip01 Pelvis"},
        {"spine", "Bip01 Spine"},
        {"chest", "Bip01 Spine1"},
        {"upper_chest", "Bip01 Spine2"},
        {"neck", "Bip01 Neck"},
        {"head", "Bip01 Head"},
        {"left_shoulder", "Bip01 L Clavicle"},
        {"left_upper_arm", "Bip01 L UpperArm"},
        {"left_lower_arm", "Bip01 L Forearm"},
        {"left_hand", "Bip01 L Hand"},
        {"left_upper_leg", "Bip01 L Thigh"},
        {"left_lower_leg", "Bip01 L Calf"},
        {"left_foot", "Bip01 L Foot"},
        {"left_toes", "Bip01 L Toe0"}},
       {{"Bip01 HeadNub", "Bip01 Head", {0, 1.8, 0}},
        {"Bip01 L Toe0Nub", "Bip01 L Toe0", {0.1, 0.02, 0.2}},
        {"Bip01 Footsteps", "Bip01", {0, 0, 0}}}},
      {"MakeHuman",
       ".L",
       ".R",
       {{"hips", "root"},
        {"spine", "spine05"},
        {"chest", "spine02"},
        {"upper_chest", "spine01"},
        {"neck", "neck01"},
        {"head", "head"},
        {"left_shoulder", "clavicle.L"},
        {"left_upper_arm", "upperarm01.L"},
        {"left_lower_arm", "lowerarm01.L"},
        {"left_hand", "wrist.L"},
        {"left_upper_leg", "upperleg01.L"},
        {"left_lower_leg", "lowerleg01.L"},
        {"left_foot", "foot.L"}},
       {{"upperarm02.L", "upperarm01.L", {0.3, 1.42, 0}},
        {"toe1-1.L", "foot.L", {0.08, 0.02, 0.1}},
        {"toe2-1.L", "foot.L", {0.1, 0.02, 0.1}},
        {"pelvis.L", "root", {0.05, 1, 0}}}},
      {"CMU",
       "Left",
       "Right",
       {{"hips", "Hips"},
        {"spine", "LowerBack"},
        {"chest", "Spine"},
        {"upper_chest", "Spine1"},
        {"neck", "Neck"},
        {"head", "Head"},
        {"left_shoulder", "LeftShoulder"},
        {"left_upper_arm", "LeftArm"},
        {"left_lower_arm", "LeftForeArm"},
        {"left_hand", "LeftHand"},
        {"left_upper_leg", "LeftUpLeg"},
        {"left_lower_leg", "LeftLeg"},
        {"left_foot", "LeftFoot"},
        {"left_toes", "LeftToeBase"}},
       {{"LHipJoint", "Hips", {0.02, 1, 0}}, {"LeftFingerBase", "LeftHand", {0.75, 1.35, 0}}}},
      {"BVH",
       "Left",
       "Right",
       {{"hips", "Hips"},
        {"spine", "Chest"},
        {"chest", "Chest2"},
        {"neck", "Neck"},
        {"head", "Head"},
        {"left_shoulder", "LeftCollar"},
        {"left_upper_arm", "LeftShoulder"},
        {"left_lower_arm", "LeftElbow"},
        {"left_hand", "LeftWrist"},
        {"left_upper_leg", "LeftHip"},
        {"left_lower_leg", "LeftKnee"},
        {"left_foot", "LeftAnkle"},
        {"left_toes", "LeftToe"}}},
      {"DAZ",
       "l",
       "r",
       {{"hips", "hip"},
        {"spine", "abdomenLower"},
        {"chest", "chestLower"},
        {"upper_chest", "chestUpper"},
        {"neck", "neckLower"},
        {"head", "head"},
        {"left_shoulder", "lCollar"},
        {"left_upper_arm", "lShldrBend"},
        {"left_lower_arm", "lForearmBend"},
        {"left_hand", "lHand"},
        {"left_upper_leg", "lThighBend"},
        {"left_lower_leg", "lShin"},
        {"left_foot", "lFoot"},
        {"left_toes", "lToe"}},
       {{"lShldrTwist", "lShldrBend", {0.3, 1.42, 0}}, {"lBigToe", "lToe", {0.08, 0, 0.2}}}},
      {"VRoid",
       "_L_",
       "_R_",
       {{"root", "Root"},
        {"hips", "J_Bip_C_Hips"},
        {"spine", "J_Bip_C_Spine"},
        {"chest", "J_Bip_C_Chest"},
        {"upper_chest", "J_Bip_C_UpperChest"},
        {"neck", "J_Bip_C_Neck"},
        {"head", "J_Bip_C_Head"},
        {"left_shoulder", "J_Bip_L_Shoulder"},
        {"left_upper_arm", "J_Bip_L_UpperArm"},
        {"left_lower_arm", "J_Bip_L_LowerArm"},
        {"left_hand", "J_Bip_L_Hand"},
        {"left_upper_leg", "J_Bip_L_UpperLeg"},
        {"left_lower_leg", "J_Bip_L_LowerLeg"},
        {"left_foot", "J_Bip_L_Foot"},
        {"left_toes", "J_Bip_L_ToeBase"}}},
      {"in small letters",
       "left",
       "right",
       {{"hips", "hips"},
        {"spine", "spine"},
        {"chest", "chest"},
        {"neck", "neck"},
        {"head", "head"},
        {"left_shoulder", "leftshoulder"},
        {"left_upper_arm", "leftupperarm"},
        {"left_lower_arm", "leftforearm"},
        {"left_hand", "lefthand"},
        {"left_upper_leg", "leftupleg"},
        {"left_lower_leg", "leftleg"},
        {"left_foot", "leftfoot"},
        {"left_toes", "lefttoebase"}}},
      {"with a name before all",
       "L_",
       "R_",
       {{"hips", "Hero_Hips"},
        {"spine", "Hero_Spine"},
        {"chest", "Hero_Chest"},
        {"neck", "Hero_Neck"},
        {"head", "Hero_Head"},
        {"left_upper_arm", "Hero_L_UpperArm"},
        {"left_lower_arm", "Hero_L_Elbow"},
        {"left_hand", "Hero_L_Hand"},
        {"left_upper_leg", "Hero_L_Thigh"},
        {"left_lower_leg", "Hero_L_Knee"},
        {"left_foot", "Hero_L_Foot"}}},
  };
}

TEST(RoleNames, OfManyPrograms) {
  std::size_t tried = 0;
  for (const Convention& c : conventions()) {
    SCOPED_TRACE(c.name);
    const NamesOfRoles names = with_sides(c.names, c.left, c.right);
    std::vector<BodyJoint> joints = joints_of(names);
    joints.insert(joints.end(), c.more.begin(), c.more.end());
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
  static const NamesOfRoles names = with_sides(conventions()[0].names, "Left", "Right");
  return names;
}

FoundRoles find_with(std::vector<BodyJoint> more, const std::vector<RoleRule>& rules = {}, bool behind = true) {
  std::vector<BodyJoint> joints = joints_of(plain_names());
  joints.insert(behind ? joints.end() : joints.begin(), more.begin(), more.end());
  return find_roles_of(scene_of(joints), rules);
}

TEST(RoleNames, OfFingers) {
  const struct {
    const char* what;
    std::vector<std::string> chain;  // from the hand out
    std::string first;               // role of the first that gets one
    std::vector<std::string> expected;
  } fingers[] = {{"Mixamo",
                  {"LeftHandIndex1", "LeftHandIndex2", "LeftHandIndex3", "LeftHandIndex4"},
                  "left_index_proximal",
                  {"LeftHandIndex1", "LeftHandIndex2", "LeftHandIndex3"}},
                 {"Unreal 5",
                  {"ring_metacarpal_l", "ring_01_l", "ring_02_l", "ring_03_l"},
                  "left_ring_proximal",
                  {"ring_01_l", "ring_02_l", "ring_03_l"}},
                 {"Godot",
                  {"LeftLittleProximal", "LeftLittleIntermediate", "LeftLittleDistal"},
                  "left_little_proximal",
                  {"LeftLittleProximal", "LeftLittleIntermediate", "LeftLittleDistal"}},
                 {"a thumb",
                  {"LeftThumbMetacarpal", "LeftThumbProximal", "LeftThumbDistal"},
                  "left_thumb_metacarpal",
                  {"LeftThumbMetacarpal", "LeftThumbProximal", "LeftThumbDistal"}},
                 {"a thumb with an end",
                  {"Thumb.L", "Thumb1.L", "Thumb2.L", "Thumb3.L"},
                  "left_thumb_metacarpal",
                  {"Thumb.L", "Thumb1.L", "Thumb2.L"}},
                 {"3ds Max",
                  {"Bip01 L Finger0", "Bip01 L Finger01", "Bip01 L Finger02"},
                  "left_thumb_metacarpal",
                  {"Bip01 L Finger0", "Bip01 L Finger01", "Bip01 L Finger02"}},
                 {"MakeHuman",
                  {"metacarpal1.L", "finger2-1.L", "finger2-2.L", "finger2-3.L"},
                  "left_index_proximal",
                  {"finger2-1.L", "finger2-2.L", "finger2-3.L"}},
                 {"Rigify",
                  {"palm.02.L", "f_middle.01.L", "f_middle.02.L", "f_middle.03.L"},
                  "left_middle_proximal",
                  {"f_middle.01.L", "f_middle.02.L", "f_middle.03.L"}},
                 {"two joints", {"Index.L", "Index2.L"}, "left_index_proximal", {"Index.L", "Index2.L"}}};
  std::size_t tried = 0;
  for (const auto& f : fingers) {
    SCOPED_TRACE(f.what);
    std::vector<BodyJoint> more;
    for (std::size_t i = 0; i < f.chain.size(); ++i)
      more.push_back(
          {f.chain[i], i == 0 ? "LeftHand" : f.chain[i - 1], {0.75 + 0.03 * static_cast<double>(i), 1.35, 0}});
    RoleTable expected = table_of(plain_names());
    for (std::size_t i = 0; i < f.expected.size(); ++i) {
      const Role role = static_cast<Role>(static_cast<std::size_t>(find_role(f.first.c_str())) + i);
      expected[role_name(role)] = f.expected[i];
    }
    EXPECT_EQ(find_with(more).table, expected);
    ++tried;
  }
  EXPECT_EQ(tried, 9u);
}

TEST(RoleNames, OfFacesAndTails) {
  const FoundRoles found = find_with({{"eye_L", "Head", {0.03, 1.65, 0.08}},
                                      {"eye_R", "Head", {-0.03, 1.65, 0.08}},
                                      {"eyelid_L", "Head", {0.03, 1.66, 0.08}},
                                      {"eyebrow_L", "Head", {0.03, 1.68, 0.08}},
                                      {"jaw", "Head", {0, 1.58, 0.05}},
                                      {"jaw_end", "jaw", {0, 1.55, 0.1}},
                                      {"hair_tail", "Head", {0, 1.7, -0.1}},
                                      {"tail", "Hips", {0, 0.95, -0.1}},
                                      {"tail.001", "tail", {0, 0.9, -0.2}},
                                      {"tail_tip", "tail.001", {0, 0.85, -0.3}}});
  RoleTable expected = table_of(plain_names());
  expected["left_eye"] = "eye_L";
  expected["right_eye"] = "eye_R";
  expected["jaw"] = "jaw";
  expected["tail"] = "tail,tail.001";
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
  EXPECT_EQ(find_roles_of(scene).table, (RoleTable{{"root", "Root"},
                                                   {"hips", "Hips"},
                                                   {"spine", "Chest"},
                                                   {"left_upper_arm", "LeftUpperArm"},
                                                   {"left_thumb_metacarpal", "LeftHand"},
                                                   {"left_thumb_proximal", "RightHand"}}));
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
