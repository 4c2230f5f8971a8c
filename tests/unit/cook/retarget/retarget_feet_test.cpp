// Motion capture put onto rigs of other legs and hands: where feet stand, and how palms lie.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cook/scene/matrices.h"
#include "unit/cook/retarget/retarget_bodies.h"

namespace marrow::cook::mocap {
namespace {

TEST(Retarget, HipsAreCarriedInTheRigsSize) {
  const Onto onto;
  const double file_leg = 2 * std::hypot(40, 1);
  const double rig_leg = glm::length(glm::dvec3(0.01, -0.45, 0.03)) + glm::length(glm::dvec3(0.01, -0.5, -0.03));
  std::size_t moves = 0;
  for (const Track& track : onto.built.clips[0].tracks)
    if (track.path == TrackPath::translation) moves += track.joint == onto.joint("rig:hips") ? 1u : 100u;
  EXPECT_EQ(moves, 1u) << "hips, and nothing else";
  const auto lowest_foot = [](const std::vector<Map>& pose) {
    return std::min(place_of(pose[body_joint("left_foot")])[1], place_of(pose[body_joint("right_foot")])[1]);
  };
  struct Case {
    double rest, up, ground;
  };
  // Its feet rest 5 above y = 0; the clip's lowest is 8; up in the air an ankle's height is guessed.
  const Case cases[] = {{90, 0, 5}, {90, 200, 5}, {0, 0, -1}, {0, 200, file_leg / 10}};
  for (auto [rest, up, ground] : cases) {
    const Motion motion = [up = up](int frame, std::size_t joint, std::size_t channel, char kind) {
      return number_of(frame, joint, channel, kind) + (joint == 0 && kind == 'y' ? up : 0);
    };
    std::vector<Joint> body = kBody;
    body[0].offset[1] = rest;
    const Onto moved({}, body, motion);
    double lowest = 1e9;
    for (int f = 0; f < kFrames; ++f) lowest = std::min(lowest, lowest_foot(posed(kBody, f, motion)));
    ASSERT_EQ(lowest > file_leg / 4, up > 0);
    if (ground < 0) ground = lowest;
    for (int f = 0; f < kFrames; ++f) {
      const std::vector<Map> file = posed(kBody, f, motion), rig = moved.at(f);
      const auto middle = [](const std::vector<Map>& pose, std::size_t left, std::size_t right, std::size_t axis) {
        return (place_of(pose[left])[axis] + place_of(pose[right])[axis]) / 2;
      };
      for (const std::size_t axis : {0U, 2U})
        EXPECT_NEAR(middle(rig, onto.joint("rig:left_leg"), onto.joint("rig:right_leg"), axis),
                    (axis == 0 ? 3 : -2) +
                        middle(file, body_joint("left_leg"), body_joint("right_leg"), axis) * rig_leg / file_leg,
                    1e-5)
            << f;
      const double rig_lowest =
          std::min(place_of(rig[onto.joint("rig:left_foot")])[1], place_of(rig[onto.joint("rig:right_foot")])[1]);
      EXPECT_NEAR(rig_lowest - 0.1, (lowest_foot(file) - ground) * rig_leg / file_leg, 1e-5) << f;
    }
  }
}

// In the order of the file, which goes down first.
void insert(std::vector<Joint>& body, std::size_t at, const Joint& joint) {
  for (Joint& other : body)
    if (other.parent >= static_cast<int>(at)) ++other.parent;
  body.insert(body.begin() + static_cast<std::ptrdiff_t>(at), joint);
}

// A body with toes that stands, crouches, lifts its right foot, stands elsewhere and leaps. Where it stands its ankles
// are 10 above the ground, and toes 3.
std::vector<Joint> walker() {
  std::vector<Joint> body = kBody;
  body[0] = {"Hips", -1, {0, 95, 0}, "xyzZXY"};
  for (const std::size_t leg : {1U, 4U}) {
    body[leg].channels = body[leg + 1].channels = body[leg + 2].channels = "XYZ";
    body[leg + 1].offset = body[leg + 2].offset = {0, -40, 0};
  }
  insert(body, 4, {"LeftToe", 3, {0, -7, 14}, "X"});
  insert(body, 8, {"RightToe", 7, {0, -7, 14}, "X"});
  return body;
}

double stand(int frame, std::size_t joint, std::size_t, char kind) {
  constexpr double kBent = 30;
  if (joint == 0) {
    if (kind == 'z') return 12.0 * frame;
    return kind != 'y' ? 0 : frame == 1 ? 95 - 80 * (1 - std::cos(kBent / 57.29577951308232)) : frame == 4 ? 125 : 95;
  }
  const bool is_leg = joint <= 8 && joint % 4 != 0, is_right = joint > 4;
  if (kind != 'X' || !is_leg || !(frame == 1 || (frame == 2 && is_right))) return 0;
  return joint % 4 == 2 ? 2 * kBent : -kBent;  // thigh forwards, shin back, the foot level
}

// Legs of the file rest 17 degrees aslant, feet with them; the clip puts them upright.
std::vector<Joint> splayed_walker() {
  std::vector<Joint> body = walker();
  for (const std::size_t j : {2U, 3U, 4U, 6U, 7U, 8U})
    body[j].offset = test::direction(turn('Z', j < 5 ? 17 : -17), body[j].offset);
  return body;
}
double stand_splayed(int frame, std::size_t joint, std::size_t channel, char kind) {
  if (joint == 0) return stand(frame == 1 ? 0 : frame, joint, channel, kind);
  return kind != 'Z' ? 0 : joint == 1 ? -17 : joint == 5 ? 17 : 0;
}

Rig with_toes() {
  Rig rig;
  rig.bones.push_back({"rig:left_toe", 3, {0.16, 0.02, 0.15}});
  rig.bones.push_back({"rig:right_toe", 6, {-0.16, 0.02, 0.15}});
  return rig;
}
// Hips below the leg joints, short legs, and feet nearly half as long as those.
Rig knight() {
  Rig rig = with_toes();
  const glm::dvec3 left[] = {{0.17, 0.52, 0}, {0.17, 0.29, 0.008}, {0.17, 0.145, -0.019}};
  rig.bones[0].place = {0, 0.406, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    rig.bones[1 + i].place = left[i];
    rig.bones[4 + i].place = glm::dvec3(-1, 1, 1) * left[i];
  }
  rig.bones[16].place = {0.17, 0.026, 0.096};
  rig.bones[17].place = {-0.17, 0.026, 0.096};
  return rig;
}

TEST(Retarget, FeetStandWhereTheFilesDo) {
  struct Source {
    std::vector<Joint> body;
    Motion motion;
  };
  const Source sources[] = {{walker(), stand}, {splayed_walker(), stand_splayed}};
  int compared = 0;
  for (const Rig& rig : {with_toes(), knight()})
    for (const Source& source : sources) {
      const Onto onto(rig, source.body, source.motion);
      const double leg = (glm::length(rig.bones[2].place - rig.bones[1].place) +
                          glm::length(rig.bones[3].place - rig.bones[2].place)) /
                         80;
      for (int f = 0; f < kFrames; ++f) {
        const std::vector<Map> file = posed(source.body, f, source.motion), pose = onto.at(f);
        const std::pair<std::size_t, std::size_t> feet[] = {{3, 3}, {6, 7}, {16, 4}, {17, 8}};
        for (const auto& [bone, joint] : feet) {
          const double height = place_of(file[joint])[1] - (bone < 16 ? 10 : 3);
          const double expected = rig.bones[bone].place.y + height * leg;
          // Knees bent: shares of thigh and shin differ between the two, not by more than 6 % of a leg.
          ++compared;
          const Map& now = pose[onto.joint(rig.bones[bone].name)];
          EXPECT_NEAR(place_of(now)[1], expected, f == 0 || f == 3 ? 1e-4 : 0.015) << f << ' ' << bone;
          // What is upwards in the foot at rest is so on the ground.
          const glm::dvec3 up = glm::conjugate(rig.turn_of(bone)) * glm::dvec3(0, 1, 0);
          if (f != 0) continue;
          EXPECT_NEAR(test::direction(now, {up.x, up.y, up.z})[1], 0.01, 1e-6) << "of columns 0.01 long";
        }
      }
    }
  EXPECT_EQ(compared, 2 * 2 * kFrames * 4);
}

// Both feet of the walker on their toes; then the left one; then that with its toes, and the other foot, in the air.
constexpr double kHeelsUp = 40;
double tiptoe(int frame, std::size_t joint, std::size_t, char kind) {
  const double up = 7 * std::cos(kHeelsUp / 57.29577951308232) + 14 * std::sin(kHeelsUp / 57.29577951308232) - 7;
  const double bent = std::acos(1 - up / 80) * 57.29577951308232;
  if (joint == 0) return kind == 'z' ? 12.0 * frame : kind != 'y' ? 0 : 95 + (frame == 1 ? up : frame == 3 ? 2 : 0);
  if (kind != 'X' || frame == 0 || frame == 4 || joint > 8 || joint % 4 == 0) return 0;
  if (frame == 1) return joint % 4 == 3 ? kHeelsUp : 0;
  if (joint > 4) return 0;
  return joint == 1 ? -bent : joint == 2 ? 2 * bent : kHeelsUp - bent;
}

// Long boots on a rig's ankles and toes: corners, where the tip bends up, and what both joints carry halfway.
class Boots {
 public:
  Boots(const Rig& rig, Character& character) : rig_(rig) {
    const Skeleton skeleton = view(character.skeletons[0]);
    names_ = character.skeletons[0].joint_names;
    std::vector<Affine> rest(skeleton.joint_count);
    EXPECT_EQ(local_to_model(skeleton, {skeleton.rest, skeleton.soa_size()}, rest), Status::ok);
    for (std::size_t j = 0; j < rest.size(); ++j) {
      joints_.push_back(static_cast<std::uint16_t>(j));
      inverse_bind_.push_back(to_affine(glm::inverse(to_matrix(rest[j]))));
    }
    for (const bool left : {true, false}) add_boot(left);
    Mesh& mesh = character.meshes.emplace_back();
    mesh.joint_count = skeleton.joint_count;
    mesh.joints = joints_.data();
    mesh.inverse_bind = inverse_bind_.data();
    mesh.geometry.runs = {runs_.data(), static_cast<std::uint32_t>(runs_.size())};
    mesh.geometry.sets = sets_.data();
    mesh.geometry.skin = skin_.data();
    mesh.geometry.vertex_count = static_cast<std::uint32_t>(runs_.size());
    mesh.geometry.slot_count = 4 * mesh.geometry.vertex_count;
  }
  // The lowest y of a boot.
  double lowest(bool left, const std::vector<Map>& pose) const {
    double out = 1e9;
    for (std::size_t v = left ? 0 : runs_.size() / 2; v < (left ? runs_.size() / 2 : runs_.size()); ++v) {
      double y = 0;
      for (std::size_t k = 0; k < 2; ++k) {
        const glm::dmat4 bind = to_matrix(inverse_bind_[sets_[2 * v + k]]);
        const glm::dvec3 at(bind * glm::dvec4(skin_[16 * v], skin_[16 * v + 4], skin_[16 * v + 8], 1));
        const auto& row = pose[sets_[2 * v + k]].rows[1];
        const double weight = static_cast<double>(skin_[16 * v + 12]);
        y += (k == 0 ? weight : 1 - weight) * (row[0] * at.x + row[1] * at.y + row[2] * at.z + row[3]);
      }
      out = std::min(out, y);
    }
    return out;
  }

 private:
  std::uint16_t joint(const std::string& name) const {
    return static_cast<std::uint16_t>(std::ranges::find(names_, name) - names_.begin());
  }
  void add_boot(bool left) {
    const std::string side = left ? "rig:left_" : "rig:right_";
    const std::uint16_t ankle = joint(side + "foot");
    const std::uint16_t toe = joint(side + "toe") < names_.size() ? joint(side + "toe") : ankle;
    const double x = rig_.bones[left ? 3 : 6].place.x;
    const glm::dvec3 corners[] = {
        {-0.04, 0, -0.06}, {0, 0.05, -0.07}, {-0.05, 0, 0.08}, {-0.03, 0, 0.2}, {0, 0.04, 0.22}};
    for (const glm::dvec3& corner : corners)
      for (const double across : {-1.0, 1.0}) {
        const double share = corner.z < 0 ? 1 : corner.z < 0.1 ? 0.5 : 0;
        runs_.push_back({1, 2});
        sets_.insert(sets_.end(), {ankle, toe});
        skin_.resize(skin_.size() + 16);
        float* const block = skin_.data() + skin_.size() - 16;
        block[0] = static_cast<float>(3 + x + across * corner.x);
        block[4] = static_cast<float>(corner.y);
        block[8] = static_cast<float>(-2 + corner.z);
        block[12] = static_cast<float>(share);
      }
  }

  const Rig& rig_;
  std::vector<std::string> names_;
  std::vector<std::uint16_t> joints_, sets_;
  std::vector<Affine> inverse_bind_;
  std::vector<Run> runs_;
  std::vector<float> skin_;
};

// With long toes that bend, with some that the file does not know, and with stiff boots.
TEST(Retarget, SolesTouchTheGroundWhereTheFilesFeetDo) {
  std::vector<Joint> strange = walker();
  strange[4].name = "Nobody";
  strange[8].name = "Noone";
  struct Case {
    Rig rig;
    std::vector<Joint> body;
  };
  for (const auto& [rig, body] :
       {Case{with_toes(), walker()}, Case{knight(), walker()}, Case{knight(), strange}, Case{Rig(), walker()}}) {
    Onto onto(rig, body, tiptoe, [&rig = rig](Character& c) { return std::make_shared<Boots>(rig, c); });
    const double leg =
        (glm::length(rig.bones[2].place - rig.bones[1].place) + glm::length(rig.bones[3].place - rig.bones[2].place)) /
        80;
    const Boots boots(rig, onto.character);
    for (int f = 0; f < kFrames; ++f) {
      const std::vector<Map> file = posed(body, f, tiptoe), pose = onto.at(f);
      for (const bool left : {true, false}) {
        const std::size_t ankle = left ? 3 : 7;
        const double heel = place_of(file[ankle])[1] - 10, ball = place_of(file[ankle + 1])[1] - 3;
        EXPECT_NEAR(boots.lowest(left, pose), leg * std::min(heel, ball), 1e-4) << f << left;
        // The heel is as high as the file's.
        EXPECT_NEAR(place_of(pose[onto.joint(left ? "rig:left_foot" : "rig:right_foot")])[1],
                    rig.bones[left ? 3 : 6].place.y + leg * heel, 0.015)
            << f << left;
      }
    }
  }
}

// The file rests with its palms forwards, the rig with them down: a quarter turn about the fingers' mean.
TEST(Retarget, PalmsLieAsTheFiles) {
  Rig rig;
  std::vector<Joint> body = kBody;
  insert(body, 12, {"LeftFinger", 11, {9, 0, 1}, "XYZ"});
  insert(body, 13, {"LeftThumb", 11, {3, 4, 0}, "ZXY"});
  // The rig's left arm lies along the file's.
  for (const std::size_t bone : {11U, 12U})
    rig.bones[bone].place = rig.bones[10].place + glm::dvec3(bone == 11 ? 0.2 : 0.4, 0, 0);
  const glm::dvec3 finger = glm::normalize(glm::dvec3(9, 0, 1)), thumb = glm::normalize(glm::dvec3(3, 4, 0));
  const glm::dquat back = glm::angleAxis(-glm::half_pi<double>(), glm::normalize(finger + thumb));
  rig.bones.push_back({"rig:left_finger", 12, rig.bones[12].place + 0.1 * (back * finger)});
  rig.bones.push_back({"rig:left_thumb", 12, rig.bones[12].place + 0.05 * (back * thumb)});
  std::vector<Joint> body_without = body;  // the same motion of the arm, fingers that nobody knows
  body_without[12].name = "Nobody";
  body_without[13].name = "Noone";
  const Onto onto(rig, body), without(rig, body_without);
  for (int f = 0; f < kFrames; ++f) {
    const std::vector<Map> file = posed(body, f), pose = onto.at(f), plain = without.at(f);
    const auto angle = [&](const char* name, std::size_t joint) {
      const Vec3 bone = test::minus(place_of(pose[onto.joint(name)]), place_of(pose[onto.joint("rig:left_hand")]));
      return test::angle_deg(bone, test::minus(place_of(file[joint]), place_of(file[11])));
    };
    EXPECT_LE(angle("rig:left_finger", 12), 1e-3) << f;
    EXPECT_LE(angle("rig:left_thumb", 13), 1e-3) << f;
    // Of the turn the forearm takes 45 degrees: the trace of what lies between is 1 + 2 cos 45°.
    double trace = 0;
    const std::size_t elbow = onto.joint("rig:left_elbow");
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) trace += pose[elbow].rows[r][c] * plain[elbow].rows[r][c] * 1e4;
    EXPECT_NEAR(trace, 1 + std::sqrt(2.0), 1e-5) << "of columns 0.01 long";
  }
}

// The rig's thumb hangs 50 degrees below the palm, the file's lies in its plane; three fingers lie alike.
TEST(Retarget, ThumbsDoNotTwistPalms) {
  Rig rig;
  std::vector<Joint> body = kBody;
  const glm::dvec3 fingers[] = {{9, 0, 3}, {9, 0, 0}, {9, 0, -3}}, thumb(4, 0, 4);
  const char* const names[] = {"LeftIndex", "LeftMiddle", "LeftRing"};
  const char* const bones[] = {"rig:left_index", "rig:left_middle", "rig:left_ring"};
  for (const std::size_t bone : {11U, 12U})
    rig.bones[bone].place = rig.bones[10].place + glm::dvec3(bone == 11 ? 0.2 : 0.4, 0, 0);
  for (std::size_t i = 0; i < 3; ++i) {
    insert(body, 12 + i, {names[i], 11, {fingers[i].x, fingers[i].y, fingers[i].z}, ""});
    rig.bones.push_back({bones[i], 12, rig.bones[12].place + 0.01 * fingers[i]});
  }
  insert(body, 15, {"LeftThumb", 11, {thumb.x, thumb.y, thumb.z}, ""});
  const glm::dquat hanging = glm::angleAxis(glm::radians(50.0), glm::dvec3(1, 0, 0));
  rig.bones.push_back({"rig:left_thumb", 12, rig.bones[12].place + 0.01 * (hanging * thumb)});
  const Onto onto(rig, body);
  for (int f = 0; f < kFrames; ++f) {
    const std::vector<Map> file = posed(body, f), pose = onto.at(f);
    const Vec3 across = test::minus(place_of(file[12]), place_of(file[14]));
    const Vec3 own = test::minus(place_of(pose[onto.joint(bones[0])]), place_of(pose[onto.joint(bones[2])]));
    EXPECT_LE(test::angle_deg(across, own), 1e-3) << f;
  }
}

}  // namespace
}  // namespace marrow::cook::mocap
