// A rod of joints that swings, and the same in double precision by Runge and Kutta.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/local_to_model.h"
#include "marrow/springs.h"
#include "support/aligned.h"
#include "support/rig.h"

namespace marrow::test {

inline Vec3 plus(const Vec3& a, const Vec3& b, double s = 1) {
  return {a[0] + b[0] * s, a[1] + b[1] * s, a[2] + b[2] * s};
}
inline Vec3 times(const Vec3& a, double s) {
  return {a[0] * s, a[1] * s, a[2] * s};
}

inline double distance(const Vec3& a, const Vec3& b) {
  return length(minus(a, b));
}

// Settings of most tests.
inline SpringJoint soft() {
  SpringJoint s;
  s.frequency_hz = 1.5f;
  s.damping_ratio = 0.3f;
  s.drag = 1;
  return s;
}

// Joint 0 carries joints 1 … n, each `length_m` along the x axis of the one before it; bones are 1 → 2, 2 → 3 … and the
// last one's tip.
class Rod {
 public:
  Rod(std::size_t bones, const SpringJoint& settings, double length_m = 0.25)
      : bones_(bones), length_m_(length_m), settings_(bones, settings) {
    std::vector<TestJoint> joints(bones + 1);
    for (std::size_t i = 1; i <= bones; ++i) {
      joints[i].parent = static_cast<int>(i) - 1;
      joints[i].translation = {i == 1 ? 0 : length_m, 0, 0};
      settings_[i - 1].joint = static_cast<std::uint16_t>(i);
    }
    rest_ = std::make_unique<TestSkeleton>(joints);
    skeleton = rest_->view();
    local.resize(skeleton.soa_size());
    scene.resize(skeleton.joint_count);
    memory_ = std::make_unique<AlignedBlock>(springs_bytes(skeleton, {&chain(), 1}));
    EXPECT_EQ(make_springs(skeleton, {&chain(), 1}, {memory_->data(), memory_->size()}, springs), Status::ok);
    pose();
  }

  const SpringChain& chain() {
    chain_.joints = settings_;
    chain_.tip[0] = static_cast<float>(length_m_);
    return chain_;
  }

  // The animated pose: the first joint at a place, turned.
  void pose(const Vec3& at = {0, 0, 0}, const Quat& turn = {0, 0, 0, 1}) {
    local = rest_->rest;
    for (std::size_t i = 0; i < 3; ++i) local[0].translation[i][0] = static_cast<float>(at[i]);
    for (std::size_t i = 0; i < 4; ++i) local[0].rotation[i][0] = static_cast<float>(turn[i]);
    EXPECT_EQ(local_to_model(skeleton, local, scene), Status::ok);
  }
  Status step(float dt_s) {
    frame.dt_s = dt_s;
    return simulate_springs({skeleton, local, scene}, frame, springs);
  }

  Vec3 place(std::size_t joint) const {
    const Affine& m = scene[joint];
    return {static_cast<double>(m.rows[0][3]), static_cast<double>(m.rows[1][3]), static_cast<double>(m.rows[2][3])};
  }
  Vec3 end(std::size_t bone) const {
    if (bone + 1 < bones_) return place(bone + 2);
    return point(to_map(scene[bones_]), {length_m_, 0, 0});
  }
  Vec3 direction(std::size_t bone) const { return normalised(minus(end(bone), place(bone + 1))); }
  std::vector<Vec3> directions() const {
    std::vector<Vec3> out;
    for (std::size_t i = 0; i < bones_; ++i) out.push_back(direction(i));
    return out;
  }

  Skeleton skeleton;
  Springs springs;
  SpringFrame frame;
  std::vector<SoaTransform> local;
  std::vector<Affine> scene;
  std::size_t bones() const { return bones_; }
  double length_m() const { return length_m_; }
  std::vector<SpringJoint>& settings() { return settings_; }
  AlignedBlock& memory() { return *memory_; }

 private:
  std::size_t bones_;
  double length_m_;
  std::vector<SpringJoint> settings_;
  SpringChain chain_;
  std::unique_ptr<TestSkeleton> rest_;
  std::unique_ptr<AlignedBlock> memory_;
};

// A pendulum as springs.h states it: of a bone whose animated direction and whose joint move as they please.
struct Pendulum {
  double frequency_hz = 2, damping_ratio = 0.5, drag = 0, length_m = 0.25;
  double most_pull = 0;  // 1/s²; 0: without a limit
  std::function<Vec3(double)> animated = [](double) { return Vec3{1, 0, 0}; };
  std::function<Vec3(double)> joint = [](double) { return Vec3{0, 0, 0}; };
  Vec3 gravity{0, 0, 0}, wind{0, 0, 0};
  Vec3 d{1, 0, 0}, u{0, 0, 0};

  Vec3 derivative(const std::function<Vec3(double)>& f, double t) const {
    const double e = 1e-5;
    return times(minus(f(t + e), f(t - e)), 1 / (2 * e));
  }
  Vec3 second(const std::function<Vec3(double)>& f, double t) const {
    const double e = 1e-4;
    return times(plus(minus(f(t + e), times(f(t), 2)), f(t - e)), 1 / (e * e));
  }
  Vec3 pull(double t, const Vec3& at) const {
    const double omega = 2 * M_PI * frequency_hz;
    Vec3 f = plus(times(animated(t), omega * omega), derivative(animated, t), 2 * damping_ratio * omega);
    const double across = length(minus(f, times(at, dot(f, at))));
    if (most_pull > 0 && across > most_pull) f = times(f, most_pull / across);
    const Vec3 air = minus(wind, derivative(joint, t));
    return plus(f, plus(minus(gravity, second(joint, t)), air, drag), 1 / length_m);
  }
  Vec3 acceleration(double t, const Vec3& at, const Vec3& v) const {
    const double omega = 2 * M_PI * frequency_hz;
    const Vec3 f = pull(t, at);
    const Vec3 across = minus(f, times(at, dot(f, at)));
    return plus(plus(across, v, -(2 * damping_ratio * omega + drag)), at, -dot(v, v));
  }
  // From t to t + dt in steps of at most 0.1 ms.
  void advance(double t, double dt) {
    const int n = static_cast<int>(dt / 1e-4) + 1;
    const double h = dt / n;
    for (int i = 0; i < n; ++i, t += h) {
      const Vec3 a1 = acceleration(t, d, u), u1 = u;
      const Vec3 u2 = plus(u, a1, h / 2), a2 = acceleration(t + h / 2, plus(d, u1, h / 2), u2);
      const Vec3 u3 = plus(u, a2, h / 2), a3 = acceleration(t + h / 2, plus(d, u2, h / 2), u3);
      const Vec3 u4 = plus(u, a3, h), a4 = acceleration(t + h, plus(d, u3, h), u4);
      for (std::size_t k = 0; k < 3; ++k) {
        d[k] += h / 6 * (u1[k] + 2 * u2[k] + 2 * u3[k] + u4[k]);
        u[k] += h / 6 * (a1[k] + 2 * a2[k] + 2 * a3[k] + a4[k]);
      }
      d = normalised(d);
    }
  }
};

}  // namespace marrow::test
