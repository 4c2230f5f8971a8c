// Roles of joints where names, bodies or sizes are out of the ordinary.
#include <ctime>

#include <gtest/gtest.h>

#include "unit/cook/roles/bodies_with_roles.h"

namespace marrow::cook {
namespace {

// A trunk and arms; what else a test needs hangs on these.
std::vector<BodyJoint> upper_body() {
  return joints_of_text(
      "pelvis 0 1 0; spine < pelvis 0 1.2 0; neck < spine 0 1.5 0; head < neck 0 1.6 0; "
      "upper_arm.L < spine 0.2 1.4 0; forearm.L < upper_arm.L 0.45 1.4 0; hand.L < forearm.L 0.7 1.4 0; "
      "upper_arm.R < spine -0.2 1.4 0; forearm.R < upper_arm.R -0.45 1.4 0; hand.R < forearm.R -0.7 1.4 0");
}

void add_legs(const std::string& parent, std::vector<BodyJoint>& joints) {
  for (const auto& [side, x] : {std::pair<std::string, double>{".L", 1}, {".R", -1}}) {
    joints.push_back({"thigh" + side, parent, {0.1 * x, 0.95, 0}});
    joints.push_back({"shin" + side, "thigh" + side, {0.1 * x, 0.5, 0}});
    joints.push_back({"foot" + side, "shin" + side, {0.1 * x, 0.1, 0}});
  }
}

RoleTable expected_body() {
  return roles_of_text(
      "hips=pelvis spine=spine neck=neck head=head left_upper_arm=upper_arm.L left_lower_arm=forearm.L "
      "left_hand=hand.L "
      "right_upper_arm=upper_arm.R right_lower_arm=forearm.R right_hand=hand.R left_upper_leg=thigh.L "
      "left_lower_leg=shin.L "
      "left_foot=foot.L right_upper_leg=thigh.R right_lower_leg=shin.R right_foot=foot.R");
}

// Where the thumb has a name of its own, the first finger is the index.
TEST(RoleBodies, CountFingersBesideAThumb) {
  std::vector<BodyJoint> joints = upper_body();
  add_legs("pelvis", joints);
  RoleTable expected = expected_body();
  const char* const roles[] = {"index", "middle", "ring", "little"};
  for (const int first : {1, 0}) {
    std::vector<BodyJoint> with = joints;
    for (int f = 0; f < 4; ++f) {
      const std::string finger = "finger_" + std::to_string(first + f);
      with.push_back({finger + "_1.L", "hand.L", {0.8, 1.4, 0.05 - 0.03 * f}});
      with.push_back({finger + "_2.L", finger + "_1.L", {0.85, 1.4, 0.05 - 0.03 * f}});
      expected[std::string("left_") + roles[f] + "_proximal"] = finger + "_1.L";
      expected[std::string("left_") + roles[f] + "_intermediate"] = finger + "_2.L";
    }
    with.push_back({"thumb_1.L", "hand.L", {0.72, 1.4, 0.05}});
    with.push_back({"thumb_2.L", "thumb_1.L", {0.75, 1.4, 0.08}});
    expected["left_thumb_metacarpal"] = "thumb_1.L";
    expected["left_thumb_proximal"] = "thumb_2.L";
    EXPECT_EQ(find_roles_of(scene_of(with)).table, expected) << first;
  }
}

// Legs and a tail on nothing, or on a root on the ground. A pelvis that does not carry the legs has no role, and yet
// the trunk begins there.
TEST(RoleBodies, MayHaveLegsAndTailBesideTheHips) {
  for (const bool root : {false, true}) {
    std::vector<BodyJoint> joints = upper_body();
    const std::string above = root ? "root" : "";
    if (root) joints.insert(joints.begin(), {"root", "", {0, 0, 0}});
    joints[root ? 1 : 0].parent = above;
    add_legs(above, joints);
    joints.push_back({"tail_1", above, {0, 1, -0.1}});
    joints.push_back({"tail_2", "tail_1", {0, 0.9, -0.3}});
    RoleTable expected = expected_body();
    expected["tail"] = "tail_1,tail_2";
    expected.erase("hips");
    if (root) expected["root"] = "root";
    const FoundRoles found = find_roles_of(scene_of(joints));
    EXPECT_EQ(found.table, expected) << root;
    ASSERT_EQ(found.warnings.size(), 1u);
    EXPECT_NE(found.warnings[0].text.find("\"pelvis\""), std::string::npos) << found.warnings[0].text;
    // One so called elsewhere begins nothing.
    joints[root ? 1 : 0].place.y += 3;
    EXPECT_EQ(find_roles_of(scene_of(joints)).table.count("tail"), 0u) << root;
  }
}

std::vector<BodyJoint> horse(const std::vector<std::string>& corners) {
  std::vector<BodyJoint> out =
      joints_of_text("spine 0 2 -0.6; neck < spine 0 2.1 0.5; head < neck 0 2.9 1.4; tail < spine 0 2.1 -1.3");
  for (const std::string& corner : corners) {
    const double x = corner[1] == 'l' ? 0.4 : -0.4, z = corner[0] == 'f' ? 0.8 : -0.8;
    out.push_back({"up_" + corner, "spine", {x, 1.7, z}});
    out.push_back({"lo_" + corner, "up_" + corner, {x, 0.9, z}});
    out.push_back({"hoof_" + corner, "lo_" + corner, {x, 0.1, z}});
  }
  return out;
}

// "fl" is front and left if a skeleton has all four of them, and else only letters.
TEST(RoleBodies, MayNameLegsByTheirCorners) {
  for (const std::string back : {"h", "b"}) {
    const FoundRoles found = find_roles_of(scene_of(horse({"fl", "fr", back + "l", back + "r"})));
    std::string roles =
        "hips=spine neck=neck head=head tail=tail left_upper_arm=up_fl left_lower_arm=lo_fl left_hand=hoof_fl "
        "right_upper_arm=up_fr right_lower_arm=lo_fr right_hand=hoof_fr left_upper_leg=up_#l "
        "left_lower_leg=lo_#l left_foot=hoof_#l right_upper_leg=up_#r right_lower_leg=lo_#r right_foot=hoof_#r";
    std::ranges::replace(roles, '#', back[0]);
    EXPECT_EQ(found.table, roles_of_text(roles));
  }
  const RoleTable two = find_roles_of(scene_of(horse({"fl", "fr"}))).table;
  EXPECT_EQ(two.count("left_upper_arm"), 0u);
  EXPECT_EQ(two.count("left_upper_leg"), 0u);
}

// One body in the order: pelvis, spine, neck, head, then of each side upper arm, elbow, wrist, thigh, knee, ankle.
TEST(RoleBodies, MayBeNamedInOtherLanguages) {
  const struct {
    const char *language, *left, *right, *middle, *limbs;
  } all[] = {{"French", "_gauche", "_droite", "bassin colonne cou tete", "epaule coude poignet cuisse genou pied"},
             {"German", "_links", "_rechts", "Becken Wirbelsaeule Hals Kopf",
              "Oberarm Unterarm Handgelenk Oberschenkel Unterschenkel Fuss"},
             {"Spanish", ".L", ".R", "pelvis columna cuello cabeza", "brazo antebrazo mano muslo rodilla pie"},
             {"Italian", "_sinistra", "_destra", "bacino colonna collo testa",
              "braccio avambraccio mano coscia ginocchio piede"}};
  const char* const roles[] = {"upper_arm", "lower_arm", "hand", "upper_leg", "lower_leg", "foot"};
  for (const auto& body : all) {
    std::vector<BodyJoint> joints = upper_body();
    add_legs("pelvis", joints);
    std::map<std::string, std::string> called;
    const std::vector<std::string> middle = tokens(body.middle, " "), limbs = tokens(body.limbs, " ");
    for (std::size_t i = 0; i < 4; ++i) called[joints[i].name] = middle[i];
    RoleTable expected = {{"hips", middle[0]}, {"spine", middle[1]}, {"neck", middle[2]}, {"head", middle[3]}};
    for (const bool right : {false, true})
      for (std::size_t i = 0; i < 6; ++i) {
        const std::size_t at = i < 3 ? 4 + 3 * (right ? 1u : 0u) + i : 10 + 3 * (right ? 1u : 0u) + i - 3;
        const std::string name = limbs[i] + (right ? body.right : body.left);
        called[joints[at].name] = name;
        expected[std::string(right ? "right_" : "left_") + roles[i]] = name;
      }
    for (BodyJoint& j : joints) {
      j.name = called.at(j.name);
      if (!j.parent.empty()) j.parent = called.at(j.parent);
    }
    EXPECT_EQ(find_roles_of(scene_of(joints)).table, expected) << body.language;
  }
}

// A scene of nodes alone, each moved by the game.
class ManyJoints {
 public:
  int add(const std::string& name, int parent, glm::dvec3 place) {
    RawNode& node = scene_.nodes.emplace_back();
    node.name = name;
    node.parent = parent;
    node.translation = place;
    node.moved_by_game = true;
    return static_cast<int>(scene_.nodes.size()) - 1;
  }
  FoundRoles find() const {
    const std::clock_t start = std::clock();
    FoundRoles out = find_roles_of(scene_);
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 1.5);
    return out;
  }

 private:
  RawScene scene_;
};

// Each took seconds while work grew with the square of the joints, and now takes a moment.
TEST(RoleBodies, OfManyJointsTakeAMoment) {
  constexpr int kMany = 32000;  // nearly as many as a skeleton may have
  ManyJoints feet;              // that hang beside their legs
  const int root = feet.add("hips", kNone, {0, 1, 0});
  for (const std::string side : {"left_", "right_"}) {
    const double x = side == "left_" ? 0.1 : -0.1;
    const int thigh = feet.add(side + "thigh", root, {x, 0, 0});
    feet.add(side + "shin", thigh, {0, -0.5, 0});
  }
  for (int i = 0; i < kMany; ++i) feet.add((i % 2 == 0 ? "left_foot_" : "right_foot_") + std::to_string(i), root, {});
  const FoundRoles found = feet.find();
  EXPECT_EQ(found.table.size(), 5u);
  EXPECT_EQ(found.warnings.size(), 2u) << "one a role";

  ManyJoints chains;  // two that mirror each other, of joints without words
  int a = chains.add("x", kNone, {}), b = a;
  for (int i = 0; i < kMany / 2; ++i) {
    a = chains.add("x", a, {i == 0 ? 0.1 : 0, 1e-4, 0});
    b = chains.add("x", b, {i == 0 ? -0.1 : 0, 1e-4, 0});
  }
  EXPECT_TRUE(chains.find().table.empty());

  ManyJoints things;  // at mirrored places of one joint
  const int hips = things.add("hips", kNone, {0, 1, 0});
  for (const std::string side : {"left_", "right_"}) {
    const double x = side == "left_" ? 0.1 : -0.1;
    const int thigh = things.add(side + "thigh", hips, {x, 0, 0});
    things.add(side + "shin", thigh, {0, -0.5, 0});
  }
  for (int i = 0; i < kMany; ++i)
    things.add("thing_" + std::to_string(i), hips, {(i % 2 == 0 ? 1 : -1) * (0.1 + 1e-5 * (i / 2)), 0.5, 0});
  EXPECT_EQ(things.find().roles.pairs.size(), 2u);
}

}  // namespace
}  // namespace marrow::cook
