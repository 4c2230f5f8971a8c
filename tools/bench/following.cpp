// The rows of what follows a character's motion: ik/springs, ik/feet. Their skeletons are made of plain numbers.
#include <cstring>

#include "bench/workload.h"
#include "pose/evaluate.h"

#include "marrow/feet.h"
#include "marrow/springs.h"

namespace marrow::tools {
namespace {

constexpr std::uint32_t kMoments = 1024;

// A skeleton with one root, joints given parents first, unturned.
class PlainSkeleton {
 public:
  void add(std::uint16_t parent, float x, float y, float z) {
    const std::size_t joint = parents_.size();
    parents_.push_back(parent);
    if (joint % 4 == 0) rest_.push_back({});
    SoaTransform& group = rest_.back();
    const float at[3] = {x, y, z};
    for (std::size_t lane = joint % 4; lane < 4; ++lane) {
      for (std::size_t i = 0; i < 3; ++i) {
        group.translation[i][lane] = lane == joint % 4 ? at[i] : 0;
        group.scale[i][lane] = 1;
      }
      group.rotation[3][lane] = 1;
    }
  }
  Skeleton view() const {
    Skeleton s;
    s.joint_count = static_cast<std::uint32_t>(parents_.size());
    s.root_count = 1;
    s.model_from_root = &root_;
    s.rest = rest_.data();
    s.parents = parents_.data();
    return s;
  }
  const std::vector<SoaTransform>& rest() const { return rest_; }

 private:
  Affine root_ = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  std::vector<SoaTransform> rest_;
  std::vector<std::uint16_t> parents_;
};

// The animated pose of every iteration, and what it is changed to.
class Posed {
 protected:
  void pose() {
    skeleton_ = plain_.view();
    local_ = plain_.rest();
    scene_.resize(skeleton_.joint_count);
    check(local_to_model(skeleton_, local_, scene_));
    animated_ = scene_;
  }
  void again() {
    std::memcpy(local_.data(), plain_.rest().data(), local_.size() * sizeof(SoaTransform));
    std::memcpy(scene_.data(), animated_.data(), scene_.size() * sizeof(Affine));
  }

  PlainSkeleton plain_;
  Skeleton skeleton_;
  std::vector<SoaTransform> local_;
  std::vector<Affine> scene_, animated_;
};

// Twelve strands of five bones below one joint, that walks to and fro on an arc and turns with it, at 60 Hz.
class Hair : public Workload, Posed {
 public:
  Hair() {
    constexpr std::uint16_t kStrands = 12, kBones = 5;
    plain_.add(kNoJoint, 0, 1.6f, 0);
    for (std::uint16_t i = 0; i <= kBones; ++i) {
      for (std::uint16_t s = 0; s < kStrands; ++s) {
        const auto parent = static_cast<std::uint16_t>(i == 0 ? 0 : 1 + kStrands * (i - 1) + s);
        plain_.add(parent, i == 0 ? 0.01f * s : 0.0f, i == 0 ? 0.1f : -0.08f, -0.02f);
      }
    }
    pose();
    std::vector<SpringChain> chains(kStrands);
    std::vector<SpringJoint> joints(std::size_t{kStrands} * (kBones + 1));
    for (std::size_t s = 0; s < kStrands; ++s) {
      for (std::size_t i = 0; i <= kBones; ++i) {
        SpringJoint& j = joints[s * (kBones + 1) + i];
        j.joint = static_cast<std::uint16_t>(1 + kStrands * i + s);
        j.drag = 1;
      }
      chains[s].joints = {joints.data() + s * (kBones + 1), kBones + 1};
    }
    memory_.resize(springs_bytes(skeleton_, chains) / sizeof(Affine) + 1);
    check(make_springs(skeleton_, chains,
                       {reinterpret_cast<std::byte*>(memory_.data()), memory_.size() * sizeof(Affine)}, springs_));
    for (std::uint32_t i = 0; i < kMoments; ++i) {
      // Tangent of half the angle, up and down again.
      const float t = static_cast<float>(i < kMoments / 2 ? i : kMoments - i) * (2.0f / kMoments);
      const float c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
      worlds_.push_back({{{c, 0, s, 3 * s}, {0, 1, 0, 0}, {-s, 0, c, 3 * c}}});
    }
    frame_.dt_s = 1.0f / 60;
  }
  std::uint32_t items() const override { return 60; }
  std::uint32_t period() const override { return kMoments; }
  std::uint64_t hash_output(std::uint64_t state) const override { return hash_of(scene_, state); }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) {
      again();
      frame_.world_from_model = worlds_[next_++ % kMoments];
      check(simulate_springs({skeleton_, local_, scene_}, frame_, springs_));
    }
  }

 private:
  std::vector<Affine> memory_, worlds_;
  Springs springs_;
  SpringFrame frame_;
  std::uint32_t next_ = 0;
};

// Two legs below a pelvis with twenty joints more, on steps and slopes, each foot planted half of the time.
class Standing : public Workload, Posed {
 public:
  Standing() {
    plain_.add(kNoJoint, 0, 0.95f, 0);
    for (const float side : {0.1f, -0.1f}) plain_.add(0, side, 0, 0);
    for (int i = 0; i < 20; ++i) plain_.add(0, 0.05f * static_cast<float>(i), 0.5f, 0);
    for (std::uint16_t leg = 0; leg < 2; ++leg) plain_.add(static_cast<std::uint16_t>(1 + leg), 0, -0.44f, 0.04f);
    for (std::uint16_t leg = 0; leg < 2; ++leg) plain_.add(static_cast<std::uint16_t>(23 + leg), 0, -0.43f, -0.04f);
    pose();
    for (std::uint32_t leg = 0; leg < 2; ++leg) {
      legs_[leg].hip = 1 + leg;
      legs_[leg].knee = 23 + leg;
      legs_[leg].ankle = 25 + leg;
      legs_[leg].sole[1] = -0.08f;
    }
    feet_.feet = {legs_, 2};
    feet_.pelvis = 0;
    Noise noise;
    grounds_.resize(std::size_t{2} * kMoments);
    for (std::size_t i = 0; i < grounds_.size(); ++i) {
      FootGround& g = grounds_[i];
      if (i % 64 >= 2) {
        g = grounds_[i - 2];
      } else {
        g.hit = true;
        g.point[1] = noise.between(-0.1f, 0.1f);
        for (const int axis : {0, 2}) g.normal[axis] = noise.between(-0.3f, 0.3f);
      }
      g.planted = (i / 2 % 32 < 16) == (i % 2 == 0);
    }
    frame_.dt_s = 1.0f / 60;
  }
  std::uint32_t items() const override { return 2; }
  std::uint32_t period() const override { return kMoments; }
  std::uint64_t hash_output(std::uint64_t state) const override { return hash_of(scene_, state); }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i, ++next_) {
      again();
      const std::size_t moment = next_ % kMoments;
      frame_.world_from_model.rows[2][3] = 0.005f * static_cast<float>(moment % 64);
      check(place_feet({skeleton_, local_, scene_}, feet_, frame_, {grounds_.data() + 2 * moment, 2}, {motion_, 2}));
    }
  }

 private:
  Foot legs_[2];
  Feet feet_;
  std::vector<FootGround> grounds_;
  FootMotion motion_[2] = {};
  FeetFrame frame_;
  std::uint32_t next_ = 0;
};

}  // namespace

RowGroup following_rows() {
  RowGroup group;
  group.names = "ik/{springs,feet}\n";
  group.rows.push_back({"ik/springs", nullptr, {}, [](Models&) { return std::make_unique<Hair>(); }});
  group.rows.push_back({"ik/feet", nullptr, {}, [](Models&) { return std::make_unique<Standing>(); }});
  return group;
}

}  // namespace marrow::tools
