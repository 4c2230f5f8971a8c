// Feet on stairs, and a seat of another height. See docs/ik/cookbook.md.
#include "newt.h"

marrow::Foot leg(const Newt& newt, const char* side) {
  const auto joint = [&](const char* name) { return newt.joint((std::string(name) + side).c_str()); };
  marrow::Foot foot;
  foot.hip = joint("thigh");
  foot.knee = joint("shin");
  foot.ankle = joint("foot");
  foot.sole[1] = 0.119f;  // the joint of the toes, about which the foot rolls
  return foot;
}

// Stairs along z. Their edges are ramps 4 cm deep: a ray meets a slope there, and a foot goes up without a jump.
constexpr float kDepth_m = 0.3f, kRise_m = 0.06f, kEdge_m = 0.04f;
marrow::FootGround stairs(const float (&sole)[3]) {
  const float step = std::floor(sole[2] / kDepth_m), edge = kDepth_m * (step + 1) - sole[2];
  const float up = edge < kEdge_m ? 1 - edge / kEdge_m : 0;
  return {true, {sole[0], kRise_m * (step + up), sole[2]}, {0, 1, 0}};  // treads are level
}

void climb(Newt& newt, const char* folder) {
  const float ball_m = 0.03f;  // as high as the toes' joint stands
  const marrow::Foot legs[2] = {leg(newt, ".L"), leg(newt, ".R")};
  marrow::Feet feet;
  feet.feet = legs;
  feet.pelvis = newt.joint("pelvis");
  feet.ease_s = 0.12f;  // stairs want quicker feet than hills
  marrow::FootMotion motion[2] = {};
  marrow::FeetFrame frame;
  frame.dt_s = 1.0f / 60;
  float through_m = 0;
  for (int i = 0; i < 240; ++i) {
    const float time_s = float(i) / 60;
    newt.play("walk", std::fmod(time_s, newt.clip("walk")->duration_s));
    frame.world_from_model.rows[2][3] = 0.375f * time_s;  // the speed that the clip was made for
    marrow::FootGround ground[2];
    for (int side = 0; side < 2; ++side) {
      float sole[3];
      must(foot_sole(legs[side], frame.world_from_model, newt.pose.model_from_joint, sole));
      ground[side] = stairs(sole);
      ground[side].planted = sole[1] < ball_m + 0.002f;
    }
    must(place_feet(newt.pose, feet, frame, ground, motion));
    for (int side = 0; side < 2; ++side)
      if (ground[side].planted)
        through_m = std::fmax(through_m, stairs(motion[side].place).point[1] + ball_m - motion[side].place[1]);
    if (i == 118) newt.save(folder, "stairs");
  }
  std::printf("stairs: %.2f m up, a standing foot at most %.1f mm through a step\n",
              double(newt.at(feet.pelvis, 1) - 0.48f), double(1000 * through_m));
}

// The pelvis goes to the seat, and the feet stay on the ground.
void sit(Newt& newt, const char* folder) {
  for (const float seat_m : {0.25f, 0.32f}) {
    newt.play("idle", 0);
    const marrow::Foot legs[2] = {leg(newt, ".L"), leg(newt, ".R")};
    const std::uint32_t toes[2] = {newt.joint("toes.L"), newt.joint("toes.R")};
    float ankles[2][3];
    marrow::Aim points[2];  // of the feet: along their y, at where the toes are
    for (int side = 0; side < 2; ++side) {
      points[side].forward[1] = 1, points[side].forward[2] = 0;
      for (int i = 0; i < 3; ++i) {
        ankles[side][i] = newt.at(legs[side].ankle, i);
        points[side].target[i] = newt.at(toes[side], i);
      }
    }

    // The pelvis down and back by as much as the seat asks for. Its parent is the scene itself.
    const std::uint32_t pelvis = newt.joint("pelvis");
    marrow::JointTransform root;
    must(get_joint(newt.pose.local, pelvis, root));
    root.translation[1] = seat_m + 0.06f;
    root.translation[2] -= 0.2f;
    must(set_joint(newt.pose.local, pelvis, root));
    must(local_to_model_below(newt.pose.skeleton, newt.pose.local, pelvis, newt.pose.model_from_joint));

    float worst_mm = 0;
    for (int side = 0; side < 2; ++side) {
      marrow::TwoBone reach;
      for (int i = 0; i < 3; ++i) reach.target[i] = ankles[side][i];
      reach.pole[1] = 0.3f, reach.pole[2] = 1;  // knees forwards
      reach.pole[0] = side == 0 ? 0.3f : -0.3f;
      must(solve_two_bone(newt.pose, {legs[side].hip, legs[side].knee, legs[side].ankle}, reach));
      must(solve_aim(newt.pose, legs[side].ankle, points[side]));
      worst_mm = std::fmax(worst_mm, newt.millimetres(legs[side].ankle, ankles[side]));
      worst_mm = std::fmax(worst_mm, newt.millimetres(toes[side], points[side].target));
    }
    std::printf("seat of %.2f m: ankles and toes at most %.2f mm off\n", double(seat_m), double(worst_mm));
    newt.save(folder, seat_m < 0.3f ? "seat-low" : "seat-high");
  }
}

int main(int argc, char** argv) {
  if (argc < 2) return 1;
  const char* const folder = argc > 2 ? argv[2] : nullptr;
  Newt newt(argv[1]);
  climb(newt, folder);
  sit(newt, folder);
}
