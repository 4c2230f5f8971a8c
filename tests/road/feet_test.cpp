// Real rigs walk: the soles that stand on the ground do not slide, and nothing jumps.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <gtest/gtest.h>

#include "road/cooked.h"
#include "road/models.h"
#include "support/rig.h"

namespace marrow::test {
namespace {

// toe: lies above the point that stands on the ground. Joints between those of a leg are left as they are.
struct LegNames {
  const char *hip, *knee, *ankle, *toe;
};
struct Rig {
  const char* model;
  const char* clip;  // null: the only one
  const char* pelvis;
  std::vector<LegNames> legs;
};

std::vector<Rig> rigs() {
  return {{"Fox",
           "Walk",
           "b_Root_00",
           {{"b_LeftLeg01_015", "b_LeftLeg02_016", "b_LeftFoot02_018", "b_LeftFoot02_018"},
            {"b_RightLeg01_019", "b_RightLeg02_020", "b_RightFoot02_022", "b_RightFoot02_022"},
            {"b_LeftUpperArm_09", "b_LeftForeArm_010", "b_LeftHand_011", "b_LeftHand_011"},
            {"b_RightUpperArm_06", "b_RightForeArm_07", "b_RightHand_08", "b_RightHand_08"}}},
          {"CesiumMan",
           nullptr,
           "Skeleton_torso_joint_1",
           {{"leg_joint_L_1", "leg_joint_L_2", "leg_joint_L_3", "leg_joint_L_5"},
            {"leg_joint_R_1", "leg_joint_R_2", "leg_joint_R_3", "leg_joint_R_5"}}},
          {"pab",
           "pab_walk_raw",
           "Hips",
           {{"LeftUpLeg", "LeftLeg", "LeftFoot", "LeftFootThumb1"},
            {"RightUpLeg", "RightLeg", "RightFoot", "RightFootThumb1"}}},
          {"mannequiny",
           "run_root.001",
           "pelvis",
           {{"thigh.l", "calf.l", "foot.l", "ball.l"}, {"thigh.r", "calf.r", "foot.r", "ball.r"}}},
          {"m2m_dragon",
           "Walk",
           "root",
           {{"back_leg_hip_l", "back_leg_l", "back_foot_l", "back_toes_l"},
            {"back_leg_hip_r", "back_leg_r", "back_foot_r", "back_toes_r"},
            {"front_leg_l", "front_ankle_l", "front_foot_l", "front_toes_l"},
            {"front_leg_r", "front_ankle_r", "front_foot_r", "front_toes_r"}}}};
}

Vec3 origin_of(const Affine& a) {
  return {static_cast<double>(a.rows[0][3]), static_cast<double>(a.rows[1][3]), static_cast<double>(a.rows[2][3])};
}
Vec3 level(Vec3 v) {
  v[1] = 0;
  return v;
}
Vec3 inverse_point(const Map& m, const Vec3& p) {
  const Vec3 v = minus(p, {m.rows[0][3], m.rows[1][3], m.rows[2][3]});
  const Vec3 a = row(m, 0), b = row(m, 1), c = row(m, 2);
  const Vec3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const double d = determinant(m);
  Vec3 out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = (bc[i] * v[0] + ca[i] * v[1] + ab[i] * v[2]) / d;
  return out;
}

// A clip that walks on the spot, carried along at the speed with which its soles go back.
class Walk {
 public:
  Walk(const Cooked& cooked, const Rig& rig) : file_(cooked.file()) {
    for (std::uint32_t c = 0; c < file_.clip_count(); ++c) {
      if (rig.clip == nullptr || std::strcmp(file_.clip(c).name, rig.clip) == 0) clip = file_.clip(c);
    }
    skeleton = file_.skeleton(clip.skeleton);
    local.resize(skeleton.soa_size());
    scene.resize(skeleton.joint_count);
    feet.pelvis = joint(rig.pelvis);
    for (const LegNames& names : rig.legs) {
      legs.push_back({joint(names.hip), joint(names.knee), joint(names.ankle), {}, {}, 1});
      toes.push_back(joint(names.toe));
    }
    feet.feet = legs;
    find_soles();
    find_speed();
  }
  std::uint32_t joint(const char* name) const {
    for (std::uint32_t j = 0; j < skeleton.joint_count; ++j)
      if (std::strcmp(file_.text(skeleton.names[j]), name) == 0) return j;
    ADD_FAILURE() << "no joint " << name;
    return 0;
  }
  // In the clip; it goes on from its start.
  double round(double time_s) const { return std::floor(time_s / static_cast<double>(clip.duration_s)); }
  void pose(double time_s) {
    const double d = static_cast<double>(clip.duration_s);
    ASSERT_EQ(sample(skeleton, clip, static_cast<float>(time_s - d * round(time_s)), local), Status::ok);
    ASSERT_EQ(local_to_model(skeleton, local, scene), Status::ok);
  }
  // Where the character has got to.
  Vec3 way(double time_s) const {
    Vec3 out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = speed[i] * time_s + stride[i] * round(time_s);
    return out;
  }
  Vec3 place(std::size_t leg) const {
    const float(&s)[3] = legs[leg].sole;
    return point(to_map(scene[legs[leg].ankle]),
                 {static_cast<double>(s[0]), static_cast<double>(s[1]), static_cast<double>(s[2])});
  }
  // Sole's animated place over the ground, and its level velocity.
  Vec3 place_at(std::size_t leg, double time_s) {
    pose(time_s);
    const Vec3 at = place(leg), on = way(time_s);
    return {at[0] + on[0], at[1], at[2] + on[2]};
  }
  Vec3 velocity_at(std::size_t leg, double time_s) {
    const double e = 1.0 / 240;
    const Vec3 a = place_at(leg, time_s - e), b = place_at(leg, time_s + e);
    return level({(b[0] - a[0]) / (2 * e), 0, (b[2] - a[2]) / (2 * e)});
  }
  bool stands(std::size_t leg, double time_s, bool stood) {
    const double over = length(velocity_at(leg, time_s));
    return place_at(leg, time_s)[1] < lowest[leg] + (stood ? 0.3 : 0.2) * (highest[leg] - lowest[leg]) &&
           over < (stood ? 0.6 : 0.4) * pace();
  }
  double leg_m(std::size_t leg) const {
    const Vec3 hip = origin_of(scene[legs[leg].hip]), knee = origin_of(scene[legs[leg].knee]);
    return length(minus(hip, knee)) + length(minus(knee, origin_of(scene[legs[leg].ankle])));
  }

  Clip clip;
  Skeleton skeleton;
  std::vector<Foot> legs;
  std::vector<std::uint32_t> toes;
  Feet feet;
  std::vector<SoaTransform> local;
  std::vector<Affine> scene;
  std::vector<double> lowest, highest;
  Vec3 speed{0, 0, 0};   // of a clip on the spot
  Vec3 stride{0, 0, 0};  // of one that walks on, from its start to its end
  double pace() const { return length(speed) + length(stride) / static_cast<double>(clip.duration_s); }

 private:
  double moment(int i) const { return static_cast<double>(clip.duration_s) * i / 200; }
  // Below the toe, at the height of the lowest toe of all, when that is lowest.
  void find_soles() {
    double ground = 1e9;
    for (const std::uint32_t toe : toes) {
      for (int i = 0; i < 200; ++i) {
        pose(moment(i));
        ground = std::min(ground, origin_of(scene[toe])[1]);
      }
    }
    for (std::size_t leg = 0; leg < legs.size(); ++leg) {
      double best = 1e9;
      for (int i = 0; i < 200; ++i) {
        pose(moment(i));
        Vec3 toe = origin_of(scene[toes[leg]]);
        if (toe[1] >= best) continue;
        best = toe[1];
        toe[1] = ground;
        const Vec3 sole = inverse_point(to_map(scene[legs[leg].ankle]), toe);
        for (int k = 0; k < 3; ++k) legs[leg].sole[k] = static_cast<float>(sole[static_cast<std::size_t>(k)]);
      }
    }
  }
  void find_speed() {
    pose(0);
    const Vec3 from = origin_of(scene[feet.pelvis]);
    pose(static_cast<double>(clip.duration_s) * 0.999999);
    const Vec3 gone = level(minus(origin_of(scene[feet.pelvis]), from));
    const bool walks_on = length(gone) > 0.5 * leg_m(0);
    if (walks_on) stride = gone;
    int count = 0;
    Vec3 sum{0, 0, 0};
    for (std::size_t leg = 0; leg < legs.size(); ++leg) {
      lowest.push_back(1e9);
      highest.push_back(-1e9);
      for (int i = 0; i < 200; ++i) {
        const double y = place_at(leg, moment(i))[1];
        lowest[leg] = std::min(lowest[leg], y);
        highest[leg] = std::max(highest[leg], y);
      }
      for (int i = 0; i < 200; ++i) {
        if (place_at(leg, moment(i))[1] > lowest[leg] + 0.1 * (highest[leg] - lowest[leg])) continue;
        const Vec3 v = velocity_at(leg, moment(i));
        sum = minus(sum, v);
        ++count;
      }
    }
    if (!walks_on) speed = {sum[0] / count, 0, sum[2] / count};
  }

  const File& file_;
};

struct Slides {
  double animated = 0, shown = 0;  // the farthest of a step, of the leg's length
  double lowered = 0;              // the pelvis, of the leg's length
  int steps = 0, frames = 0, unreached = 0;
};

void walk(Walk& w, double hz, Slides& out) {
  std::vector<FootGround> ground(w.legs.size());
  std::vector<FootMotion> motion(w.legs.size());
  std::vector<Vec3> at(w.legs.size()), was(w.legs.size());
  FeetFrame frame;
  frame.dt_s = static_cast<float>(1 / hz);
  const int frames = static_cast<int>(hz * 4 * static_cast<double>(w.clip.duration_s));
  for (int i = 0; i < frames; ++i) {
    const double t = i / hz;
    std::vector<bool> stands;
    for (std::size_t leg = 0; leg < w.legs.size(); ++leg) stands.push_back(w.stands(leg, t, ground[leg].planted));
    w.pose(t);
    for (std::size_t r = 0; r < 3; ++r) frame.world_from_model.rows[r][3] = static_cast<float>(w.way(t)[r]);
    const Map world = to_map(frame.world_from_model);
    const double pelvis = origin_of(w.scene[w.feet.pelvis])[1];
    std::vector<Vec3> animated;
    for (std::size_t leg = 0; leg < w.legs.size(); ++leg) animated.push_back(point(world, w.place(leg)));
    std::vector<bool> stood;
    for (std::size_t leg = 0; leg < w.legs.size(); ++leg) {
      stood.push_back(ground[leg].planted);
      ground[leg].planted = stands[leg];
    }
    ASSERT_EQ(place_feet({w.skeleton, w.local, w.scene}, w.feet, frame, ground, motion), Status::ok);
    out.lowered = std::max(out.lowered, (pelvis - origin_of(w.scene[w.feet.pelvis])[1]) / w.leg_m(0));
    for (std::size_t leg = 0; leg < w.legs.size(); ++leg, ++out.frames) {
      const Vec3 shown = point(world, w.place(leg));
      const double size = w.leg_m(leg);
      if (stands[leg] && !stood[leg]) {
        at[leg] = shown;
        was[leg] = animated[leg];
        ++out.steps;
      }
      if (!stands[leg]) continue;
      out.shown = std::max(out.shown, length(level(minus(shown, at[leg]))) / size);
      out.animated = std::max(out.animated, length(level(minus(animated[leg], was[leg]))) / size);
      out.unreached += !motion[leg].reached;
    }
  }
}

class WalkingFeet : public ::testing::TestWithParam<std::size_t> {};

TEST_P(WalkingFeet, DoNotSlide) {
  const Rig rig = rigs()[GetParam()];
  const std::string path = (assets() / (std::string(rig.model) + ".glb")).string();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << rig.model;
  const Cooked cooked(path);
  Walk w(cooked, rig);
  w.feet.lower_m = static_cast<float>(0.3 * w.leg_m(0));
  ASSERT_GT(w.clip.duration_s, 0);
  for (const double hz : {30.0, 60.0, 120.0}) {
    Slides s;
    walk(w, hz, s);
    std::printf(
        "%-12s %3.0f Hz: %.3f legs/s, %d steps, slide %.4f of the leg as animated, %.6f with feet placed;"
        " pelvis down by %.4f; %d out of reach\n",
        rig.model, hz, w.pace() / w.leg_m(0), s.steps, s.animated, s.shown, s.lowered, s.unreached);
    EXPECT_GE(s.steps, static_cast<int>(w.legs.size()) * 3);
    EXPECT_LE(s.shown, 1e-3) << "1 mm at a leg of a metre";
    EXPECT_GT(s.animated, 1e-3) << "else this tests nothing";
    EXPECT_LT(s.lowered, 0.1);
    EXPECT_EQ(s.unreached, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Rigs, WalkingFeet, ::testing::Range(std::size_t{0}, std::size_t{5}),
                         [](const auto& of) { return std::string(rigs()[of.param].model); });

}  // namespace
}  // namespace marrow::test
