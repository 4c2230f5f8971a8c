// The rows motion/FUNCTION: what a game asks of clips beside poses, once an iteration, at steps of 1/60 s and longer.
#include "bench/workload.h"
#include "common/check_status.h"
#include "marrow/blend_space.h"
#include "marrow/events.h"
#include "marrow/phase.h"
#include "marrow/pose_map.h"
#include "marrow/root_motion.h"

namespace marrow::tools {
namespace {

constexpr std::uint32_t kSteps = 256;  // different ones
constexpr int kGaits = 4, kEvents = 8, kKeys = 16;

// Four gaits: eight events, two marks and sixteen keys of a root that turns a little, each.
struct Gait {
  explicit Gait(Noise& noise) {
    const float duration_s = noise.between(0.5f, 1.5f);
    for (int i = 0; i < kEvents; ++i) {
      const float time_s = duration_s * static_cast<float>(i) / kEvents;
      events.push_back({time_s, time_s, static_cast<std::uint32_t>(i), 0});
    }
    marks = {0.1f * duration_s, 0.6f * duration_s};
    for (int i = 0; i < kKeys; ++i) {
      const float share = static_cast<float>(i) / (kKeys - 1), half = 0.1f * share;
      // Nearly of length 1, as keys of a file are.
      root.push_back({share * duration_s, {0, half, 0, 1 - 0.5f * half * half}, {0, 0, share * noise.between(1, 2)}});
    }
    root[0].translation[2] = 0;
    motion.duration_s = duration_s;
    motion.speed_m_s = noise.between(1, 5);
    motion.heading[2] = 1;
    motion.events = events;
    motion.phase_marks = marks;
    motion.root = root;
  }
  std::vector<ClipEvent> events;
  std::vector<float> marks;
  std::vector<RootKey> root;
  ClipMotion motion;
};

class Moving : public Workload {
 public:
  Moving() {
    Noise noise;
    for (int g = 0; g < kGaits; ++g) gaits_.emplace_back(noise);
    for (std::uint32_t i = 0; i < kSteps; ++i) {
      steps_s_.push_back(i % 8 == 0 ? noise.between(0.1f, 3) : 1.0f / 60);
      asked_.push_back(noise.between(0, 6));
    }
    for (int g = 0; g < kGaits; ++g)
      speeds_[g] = {static_cast<float>(g + 1), gaits_[static_cast<std::size_t>(g)].motion.duration_s};
  }
  std::uint32_t period() const override { return kSteps; }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) {
      step(next_);
      next_ = (next_ + 1) % kSteps;
    }
  }

 protected:
  virtual void step(std::uint32_t number) = 0;
  // Moves the playback of a gait on.
  Playback advanced(std::uint32_t number, const Gait& gait) {
    const Playback before = playback_;
    check(advance(playback_, gait.motion.duration_s, steps_s_[number]));
    playback_.turns = 1;  // as after one step, and never more than a few
    return before;
  }

  std::vector<Gait> gaits_;
  std::vector<float> steps_s_, asked_;
  SpeedPoint speeds_[kGaits];
  Playback playback_;

 private:
  std::uint32_t next_ = 0;
};

class Events : public Moving {
 public:
  std::uint32_t items() const override { return kEvents; }
  std::uint64_t hash_output(std::uint64_t state) const override {
    return hash_of(Span<const EventHit>(hits_, met_), state);
  }

 private:
  void step(std::uint32_t number) override {
    const Playback before = advanced(number, gaits_[0]);
    check(events_between(gaits_[0].motion, before, playback_, false, hits_, met_));
  }
  EventHit hits_[kEvents];
  std::size_t met_ = 0;
};

class Roots : public Moving {
 public:
  std::uint32_t items() const override { return 1; }
  std::uint64_t hash_output(std::uint64_t state) const override {
    return hash_of(Span<const RigidStep>(&out_, 1), state);
  }

 private:
  void step(std::uint32_t number) override {
    const Playback before = advanced(number, gaits_[0]);
    check(root_step(gaits_[0].motion, before, playback_, out_));
  }
  RigidStep out_;
};

class Blended : public Moving {
 public:
  std::uint32_t items() const override { return kGaits; }
  std::uint64_t hash_output(std::uint64_t state) const override {
    return hash_of(Span<const RigidStep>(&out_, 1), state);
  }

 private:
  void step(std::uint32_t number) override {
    RigidStep steps[kGaits];
    float weights[kGaits];
    for (int g = 0; g < kGaits; ++g) {
      steps[g].translation[2] = steps_s_[number] * static_cast<float>(g + 1);
      weights[g] = asked_[(number + static_cast<std::uint32_t>(g)) % kSteps];
    }
    check(blend_root_steps(steps, weights, out_));
  }
  RigidStep out_;
};

class InStep : public Moving {
 public:
  std::uint32_t items() const override { return kGaits; }
  std::uint64_t hash_output(std::uint64_t state) const override {
    return hash_of(Span<const Phase>(&phase_, 1), state);
  }

 private:
  void step(std::uint32_t number) override {
    float weights[kGaits], rate = 1;
    check(match_speed(speeds_, asked_[number], weights, rate));
    PhaseClip group[kGaits];
    for (int g = 0; g < kGaits; ++g) group[g] = {&gaits_[static_cast<std::size_t>(g)].motion, weights[g]};
    const Phase before = phase_;
    check(advance_phase(group, steps_s_[number] * rate, phase_));
    Playback was, now;
    for (const PhaseClip& clip : group) check(follow_phase(*clip.motion, before, phase_, was, now));
  }
  Phase phase_;
};

// A pose of a rig of 67 joints on a skeleton of as many: each turns as one of the rig, but three of the spine that are
// between two, and two go from their places.
class Retargeted : public Workload {
 public:
  Retargeted() : out_(soa_count(kJoints)), rest_(soa_count(kJoints)), groups_(soa_count(kJoints)) {
    Noise noise;
    for (SoaTransform& four : rest_) fill(noise, four);
    for (std::uint32_t i = 0; i < kSteps; ++i) {
      rigs_.emplace_back(soa_count(kJoints));
      for (SoaTransform& four : rigs_.back()) fill(noise, four);
    }
    for (std::size_t j = 0; j < 4 * groups_.size(); ++j) {
      groups_[j / 4].before[3][j % 4] = groups_[j / 4].after[3][j % 4] = 1;
      groups_[j / 4].rig_joints[j % 4] = j < kJoints ? static_cast<std::uint16_t>(j) : kNoJoint;
    }
    for (std::uint16_t i = 0; i < 6; ++i) {
      MappedTurn turn;
      turn.joint = 1 + i / 2;
      turn.step_count = 1;
      turn.weight = 0.5f;
      turns_.push_back(turn);
      steps_.push_back({static_cast<std::uint16_t>(1 + i), 0, 0});
    }
    for (std::uint16_t j = 0; j < 2; ++j) {
      places_.emplace_back().joint = j;
      steps_.push_back({j, 0, 0});
    }
    map_.rig_joint_count = kJoints;
    map_.groups = groups_;
    map_.turns = turns_;
    map_.places = places_;
    map_.steps = steps_;
    skeleton_.joint_count = kJoints;
    skeleton_.rest = rest_.data();
  }
  std::uint32_t items() const override { return kJoints; }
  std::uint32_t period() const override { return kSteps; }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) {
      check(retarget_pose(map_, rigs_[next_], skeleton_, out_));
      next_ = (next_ + 1) % kSteps;
    }
  }
  std::uint64_t hash_output(std::uint64_t state) const override { return hash_of(out_, state); }

 private:
  static constexpr std::uint32_t kJoints = 67;
  static void fill(Noise& noise, SoaTransform& four) {
    for (int lane = 0; lane < 4; ++lane) {
      const float half = noise.between(-0.6f, 0.6f);
      for (int c = 0; c < 3; ++c) {
        four.translation[c][lane] = noise.between(-1, 1);
        four.rotation[c][lane] = c == lane % 3 ? half : 0.0f;
        four.scale[c][lane] = 1;
      }
      four.rotation[3][lane] = 1 - 0.5f * half * half;
    }
  }

  std::vector<std::vector<SoaTransform>> rigs_;
  std::vector<SoaTransform> out_, rest_;
  std::vector<MappedGroup> groups_;
  std::vector<MappedTurn> turns_;
  std::vector<MappedPlace> places_;
  std::vector<RigStep> steps_;
  PoseMap map_;
  Skeleton skeleton_;
  std::uint32_t next_ = 0;
};

}  // namespace

RowGroup moving_rows() {
  RowGroup group;
  const auto row = [&](const char* name, auto make) { group.rows.push_back({name, nullptr, {}, make}); };
  row("motion/events", [](Models&) { return std::make_unique<Events>(); });
  row("motion/root", [](Models&) { return std::make_unique<Roots>(); });
  row("motion/blend", [](Models&) { return std::make_unique<Blended>(); });
  row("motion/phase", [](Models&) { return std::make_unique<InStep>(); });
  row("motion/retarget_pose", [](Models&) { return std::make_unique<Retargeted>(); });
  group.names = "motion/{events,root,blend,phase,retarget_pose}\n";
  return group;
}

}  // namespace marrow::tools
