// VRM's spring settings as ours: how near our springs come to the specification's algorithm, which stands here in
// double precision (VRMC_springBone 1.0, "SpringBone Algorithm", inertia calculation and length constraint).
#include "cook/gltf/vrm/vrm.h"

#include <cmath>
#include <cstdio>
#include <vector>

#include "unit/ik/springs_support.h"

namespace marrow::cook {
namespace {

using test::Vec3;

constexpr double kStep_s = 1.0 / 60;

// A chain along x at rest, whose first joint is where `step` is told.
class VrmChain {
 public:
  VrmChain(std::size_t bones, double length_m, const gltf::VrmSpring& s) : length_m_(length_m), s_(s) {
    for (std::size_t i = 0; i < bones; ++i) {
      now_.push_back({length_m * static_cast<double>(i + 1), 0, 0});
      axis_.push_back({1, 0, 0});
    }
    before_ = now_;
  }
  // Where the bone above turns its rest direction, each bone of the chain is turned with it: fromToQuaternion.
  void step(const Vec3& joint) {
    Vec3 head = joint;
    Vec3 rest = {1, 0, 0};
    for (std::size_t i = 0; i < now_.size(); ++i) {
      Vec3 next = now_[i];
      for (std::size_t k = 0; k < 3; ++k)
        next[k] += (now_[i][k] - before_[i][k]) * (1 - s_.drag_force) + kStep_s * rest[k] * s_.stiffness +
                   kStep_s * s_.gravity_direction[static_cast<int>(k)] * s_.gravity_power;
      axis_[i] = test::normalised(test::minus(next, head));
      before_[i] = now_[i];
      now_[i] = test::plus(head, axis_[i], length_m_);
      head = now_[i];
      rest = axis_[i];  // the rest direction of all bones is one, so the next one's target is where this one points
    }
  }
  // Turned aside, at rest.
  void turn(double angle_rad) {
    Vec3 head = {0, 0, 0};
    for (std::size_t i = 0; i < now_.size(); ++i)
      now_[i] = before_[i] = head = test::plus(head, {std::cos(angle_rad), 0, std::sin(angle_rad)}, length_m_);
  }
  const Vec3& direction(std::size_t bone) const { return axis_[bone]; }

 private:
  double length_m_;
  gltf::VrmSpring s_;
  std::vector<Vec3> now_, before_, axis_;
};

struct Case {
  double stiffness, drag, length_m, gravity_power;
};

std::vector<Case> typical() {
  std::vector<Case> out;
  for (const double stiffness : {0.5, 1.0, 2.0})
    for (const double drag : {0.2, 0.4, 0.6})
      for (const double length : {0.05, 0.1, 0.2})
        for (const double gravity : {0.0, 0.3}) out.push_back({stiffness, drag, length, gravity});
  return out;
}

gltf::VrmSpring vrm_of(const Case& c) {
  gltf::VrmSpring s;
  s.stiffness = c.stiffness;
  s.drag_force = c.drag;
  s.gravity_power = c.gravity_power;
  return s;
}

test::Rod rod_of(std::size_t bones, const Case& c) {
  test::Rod rod(bones, gltf::spring_settings(vrm_of(c), c.length_m, {1, 0, 0}), c.length_m);
  rod.frame.teleport_m = 100;
  return rod;
}

// How far two histories are apart, as a share of the larger of what is in the second.
struct Apart {
  double off = 0, most = 0, our_most = 0;
  void add(const Vec3& ours, const Vec3& theirs, const Vec3& rest) {
    off = std::max(off, test::angle_deg(ours, theirs));
    most = std::max(most, test::angle_deg(theirs, rest));
    our_most = std::max(our_most, test::angle_deg(ours, rest));
  }
  double share() const { return off / most; }
};

// A bone that is let go aside.
TEST(VrmSettings, SwingsFreelyAsTheSpecification) {
  double worst = 0, sum = 0;
  int cases = 0;
  for (const Case& c : typical()) {
    if (c.gravity_power > 0) continue;
    // Gravity from aside holds our bone there; it ends when the swing begins.
    const double angle = 0.2;
    test::Rod rod = rod_of(1, c);
    const double omega = 2 * 3.14159265358979 * double{rod.settings()[0].frequency_hz};
    rod.settings()[0].gravity = 1;
    ASSERT_EQ(set_springs(rod.skeleton, {&rod.chain(), 1}, rod.springs), Status::ok);
    rod.frame.gravity[1] = 0;
    rod.frame.gravity[2] = static_cast<float>(std::tan(angle) * omega * omega * c.length_m);
    const auto step = [&] {
      rod.pose();
      ASSERT_EQ(rod.step(static_cast<float>(kStep_s)), Status::ok);
    };
    for (int i = 0; i < 600; ++i) step();
    ASSERT_NEAR(test::angle_deg(rod.direction(0), {1, 0, 0}), angle * 57.2957795, 0.01);
    rod.frame.gravity[2] = 0;
    VrmChain vrm(1, c.length_m, vrm_of(c));
    vrm.turn(angle);
    Apart apart;
    apart.most = angle * 57.2957795;
    // The algorithm's bone, whose last step was none, was at rest half a step ago.
    const auto half_step = [&] {
      rod.pose();
      ASSERT_EQ(rod.step(static_cast<float>(kStep_s / 2)), Status::ok);
    };
    half_step();
    for (int i = 0; i < 60; ++i) {
      half_step();
      half_step();
      vrm.step({0, 0, 0});
      apart.add(rod.direction(0), vrm.direction(0), {1, 0, 0});
    }
    worst = std::max(worst, apart.share());
    sum += apart.share();
    ++cases;
  }
  EXPECT_EQ(cases, 27);
  std::printf("let go: apart by at most %.3f of the swing, %.3f in the mean\n", worst, sum / cases);
  EXPECT_LT(worst, 0.04);
}

// The first joint is moved aside and back, in half a second each: what a step or a turn of the head does.
Vec3 way(double t) {
  const auto smooth = [](double u) { return u <= 0 ? 0.0 : u >= 1 ? 1.0 : u * u * (3 - 2 * u); };
  return {0, 0, 0.2 * (smooth(t / 0.5) - smooth((t - 1) / 0.5))};
}

Apart riding(std::size_t bones, const Case& c) {
  VrmChain vrm(bones, c.length_m, vrm_of(c));
  test::Rod rod = rod_of(bones, c);
  for (int i = 0; i < 300; ++i) {
    rod.pose();
    EXPECT_EQ(rod.step(static_cast<float>(kStep_s)), Status::ok);
    vrm.step({0, 0, 0});
  }
  std::vector<Vec3> rest;
  for (std::size_t b = 0; b < bones; ++b) rest.push_back(vrm.direction(b));
  Apart apart;
  for (int i = 1; i <= 150; ++i) {
    const Vec3 at = way(i * kStep_s);
    rod.pose(at);
    EXPECT_EQ(rod.step(static_cast<float>(kStep_s)), Status::ok);
    vrm.step(at);
    for (std::size_t b = 0; b < bones; ++b) apart.add(rod.direction(b), vrm.direction(b), rest[b]);
  }
  return apart;
}

TEST(VrmSettings, ABoneRidesAlongAsTheSpecification) {
  double worst = 0, sum = 0;
  for (const Case& c : typical()) {
    const double share = riding(1, c).share();
    worst = std::max(worst, share);
    sum += share;
  }
  const double mean = sum / static_cast<double>(typical().size());
  std::printf("riding along: apart by at most %.3f of the swing, %.3f in the mean\n", worst, mean);
  EXPECT_LT(worst, 0.2);
  EXPECT_LT(mean, 0.04);
}

// Down a chain the specification's bones start later, as each is carried by those above it, which ours do not feel. So
// only how far they swing is compared.
TEST(VrmSettings, ChainsSwingAboutAsFarAsTheSpecifications) {
  double least = 1e9, most = 0;
  for (const Case& c : typical()) {
    const Apart apart = riding(4, c);
    least = std::min(least, apart.our_most / apart.most);
    most = std::max(most, apart.our_most / apart.most);
  }
  std::printf("four bones: %.2f to %.2f of the specification's largest angle\n", least, most);
  EXPECT_GT(least, 0.55);
  EXPECT_LT(most, 1.4);
}

// Where stiffness and gravity balance.
TEST(VrmSettings, RestsWhereTheSpecificationDoes) {
  for (const Case& c : typical()) {
    VrmChain vrm(1, c.length_m, vrm_of(c));
    test::Rod rod = rod_of(1, c);
    for (int i = 0; i < 600; ++i) {
      rod.pose();
      ASSERT_EQ(rod.step(static_cast<float>(kStep_s)), Status::ok);
      vrm.step({0, 0, 0});
    }
    EXPECT_LT(test::angle_deg(rod.direction(0), vrm.direction(0)), 0.1)
        << c.stiffness << ' ' << c.drag << ' ' << c.length_m << ' ' << c.gravity_power;
  }
}

}  // namespace
}  // namespace marrow::cook
