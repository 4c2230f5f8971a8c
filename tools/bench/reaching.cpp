// The rows ik/two_bone, ik/two_bone_x4 and ik/aim: the kernels, a leg and a head and 1024 targets in turn.
#include "bench/workload.h"
#include "marrow/ik.h"
#include "pose/evaluate.h"

namespace marrow::tools {
namespace {

constexpr std::uint32_t kTargets = 1024;

std::uint64_t hash_of_floats(const float* values, std::size_t count, std::uint64_t state) {
  const std::uint64_t both[2] = {state,
                                 format::checksum(reinterpret_cast<const std::byte*>(values), count * sizeof(float))};
  return format::checksum(reinterpret_cast<const std::byte*>(both), sizeof both);
}

// A rotation by a fixed quaternion of that direction, at a place.
Affine matrix(float x, float y, float z, float w, float px, float py, float pz) {
  const float s = 2 / (x * x + y * y + z * z + w * w);
  return {{{1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w), px},
           {s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w), py},
           {s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y), pz}}};
}

// A leg of 0.8 m whose knee is bent forward by some 20 degrees, and targets round its foot, a fifth of them out of
// reach.
struct Leg {
  Leg() : goals(kTargets) {
    Noise noise;
    for (TwoBone& goal : goals) {
      goal.target[0] = noise.between(-0.2f, 0.4f);
      goal.target[1] = noise.between(0.05f, 0.5f);
      goal.target[2] = noise.between(-0.4f, 0.4f);
      goal.pole[2] = 1;
      goal.bend_axis[0] = 0.94f, goal.bend_axis[1] = 0.03f, goal.bend_axis[2] = 0.34f;  // as it is bent
    }
  }
  Affine hip = matrix(0.1f, 0.2f, 0.05f, 0.97f, 0.1f, 0.9f, 0);
  Affine knee = matrix(0.3f, 0.2f, 0.05f, 0.9f, 0.12f, 0.5f, 0.05f);
  Affine ankle = matrix(0, 0.2f, 0.05f, 0.97f, 0.13f, 0.1f, -0.05f);
  TwoBoneJoints joints = {&hip, &knee, &ankle};
  std::vector<TwoBone> goals;
};

class Reaching : public Workload {
 public:
  explicit Reaching(bool four) : four_(four), out_(4) {}
  std::uint32_t items() const override { return four_ ? 4 : 1; }
  std::uint32_t period() const override { return kTargets / items(); }
  std::uint64_t hash_output(std::uint64_t state) const override {
    for (std::uint32_t i = 0; i < items(); ++i) {
      const TwoBoneTurns& t = out_[i];
      const float tail[] = {t.stretch, t.reached ? 1.0f : 0.0f};
      state = hash_of_floats(tail, 2, hash_of_floats(t.mid, 4, hash_of_floats(t.start, 4, state)));
    }
    return state;
  }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) {
      const TwoBone* const goals = &leg_.goals[next_];
      if (four_) {
        check(two_bone_x4(limbs_, *reinterpret_cast<const TwoBone(*)[4]>(goals),
                          *reinterpret_cast<TwoBoneTurns(*)[4]>(out_.data())));
      } else {
        check(two_bone(leg_.joints, *goals, out_[0]));
      }
      next_ = (next_ + items()) % kTargets;
    }
  }

 private:
  Leg leg_;
  TwoBoneJoints limbs_[4] = {leg_.joints, leg_.joints, leg_.joints, leg_.joints};
  bool four_;
  std::vector<TwoBoneTurns> out_;
  std::size_t next_ = 0;
};

// Targets before a head, to the sides and above.
class Aiming : public Workload {
 public:
  Aiming() : goals_(kTargets) {
    Noise noise;
    for (Aim& goal : goals_) {
      goal.target[0] = noise.between(-1, 1);
      goal.target[1] = noise.between(0, 1);
      goal.target[2] = noise.between(0.2f, 2);
      goal.pole[1] = 1;
    }
  }
  std::uint32_t items() const override { return 1; }
  std::uint32_t period() const override { return kTargets; }
  std::uint64_t hash_output(std::uint64_t state) const override { return hash_of_floats(out_.turn, 4, state); }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) {
      check(aim(head_, goals_[next_], out_));
      next_ = (next_ + 1) % kTargets;
    }
  }

 private:
  Affine head_ = matrix(0.3f, 0.2f, 0.05f, 0.9f, 0.12f, 0.5f, 0.05f);
  std::vector<Aim> goals_;
  AimTurn out_;
  std::size_t next_ = 0;
};

}  // namespace

RowGroup reaching_rows() {
  RowGroup group;
  const auto add_row = [&](const char* name, auto make) { group.rows.push_back({name, nullptr, {}, make}); };
  add_row("ik/two_bone", [](Models&) { return std::make_unique<Reaching>(false); });
  add_row("ik/two_bone_x4", [](Models&) { return std::make_unique<Reaching>(true); });
  add_row("ik/aim", [](Models&) { return std::make_unique<Aiming>(); });
  group.names = "ik/{two_bone,two_bone_x4,aim}\n";
  return group;
}

}  // namespace marrow::tools
