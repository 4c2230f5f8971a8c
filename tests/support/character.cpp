// The creature of noise that the tests on bits, allocations and threads pose.
#include "support/rig.h"

namespace marrow::test {
namespace {

// Breadth-first by construction: parents never decrease.
std::vector<TestJoint> make_joints(Random& random, std::size_t count) {
  std::vector<TestJoint> joints(count);
  for (std::size_t j = 0; j < count; ++j) {
    joints[j].parent = j < 2 ? -1 : static_cast<int>((j - 2) * 2 / 3);
    for (double& t : joints[j].translation) t = random.between(-0.5, 0.5);
    joints[j].rotation = random.rotation();
    for (double& s : joints[j].scale) s = random.between(0.75, 1.25);
    if (j % 7 == 3) joints[j].scale[1] = -joints[j].scale[1];
  }
  return joints;
}

void add_track(Random& random, TestClip& clip, std::uint16_t joint, TrackPath path, Interpolation interpolation) {
  std::vector<float> times, values;
  const std::size_t keys = 1 + random.below(9);
  double time = random.between(0, 0.125);
  for (std::size_t k = 0; k < keys; ++k, time += random.between(0.03125, 0.25)) {
    times.push_back(static_cast<float>(time));
    const Quat rotation = random.rotation();
    for (int part = 0; part < (interpolation == Interpolation::cubic_spline ? 3 : 1); ++part) {
      const bool tangent = interpolation == Interpolation::cubic_spline && part != 1;
      for (std::size_t i = 0; i < (path == TrackPath::rotation ? 4u : 3u); ++i) {
        const double value = path == TrackPath::rotation ? rotation[i] : random.between(0.5, 1.5);
        values.push_back(static_cast<float>(tangent ? random.between(-2, 2) : value));
      }
    }
  }
  clip.add(joint, path, interpolation, times, values);
}

TestClip make_clip(Random& random, std::size_t joint_count) {
  TestClip clip;
  for (std::size_t j = 0; j < joint_count; ++j) {
    for (const TrackPath path : {TrackPath::translation, TrackPath::rotation, TrackPath::scale}) {
      if (random.below(8) == 0) continue;  // stays at rest
      add_track(random, clip, static_cast<std::uint16_t>(j), path, static_cast<Interpolation>(random.below(3)));
    }
  }
  return clip;
}

TestVertex make_vertex(Random& random, std::size_t influences, bool residual) {
  TestVertex v;
  for (double& p : v.position) p = random.between(-2, 2);
  const Quat n = random.rotation(), t = random.rotation();
  v.normal = normalised(Vec3{n[0], n[1], n[2] + 0.01});
  v.tangent = normalised(Vec3{t[0], t[1] + 0.01, t[2]});
  v.sign = random.below(2) == 0 ? 1 : -1;
  double left = 1;
  for (std::size_t k = 0; k + 1 < influences; ++k) {
    v.weights.push_back(random.between(0, 2.0 / static_cast<double>(influences)) * left);
    left -= v.weights.back();
  }
  v.weights.push_back(left);
  for (std::size_t k = 0; residual && k < influences; ++k) {
    const double d = k % 2 == 0 ? 0.125 : -0.125;  // δ sums to 0, up to the odd one out
    v.residual.push_back({random.between(-0.1, 0.1), random.between(-0.1, 0.1), random.between(-0.1, 0.1),
                          k + 1 == influences && influences % 2 == 1 ? 0 : d});
  }
  return v;
}

}  // namespace

TestCharacter make_character(std::uint64_t seed, std::size_t joint_count, std::size_t vertices_a_run, bool residuals) {
  Random random(seed);
  const std::vector<TestJoint> joints = make_joints(random, joint_count);
  std::vector<Map> above(2), inverse_bind(joint_count);
  for (Map& m : above) {
    const Vec3 t{random.between(-1, 1), 0, 0};  // a statement of its own: arguments have no order
    m = from_trs(t, random.rotation(), {1, 1, 1});
  }
  const TestClip clip = make_clip(random, joint_count);
  for (Map& m : inverse_bind) {
    const Vec3 t{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    m = from_trs(t, random.rotation(), {1, 1, 1});
  }
  std::vector<TestRun> runs;
  for (std::size_t influences = 1; influences <= kMaxInfluences; ++influences) {
    TestRun run;
    for (std::size_t k = 0; k < influences; ++k) {
      run.set.push_back(static_cast<std::uint16_t>((influences * 5 + k) % joint_count));
    }
    for (std::size_t v = 0; v < vertices_a_run + influences % 4; ++v) {
      run.vertices.push_back(make_vertex(random, influences, residuals));
    }
    runs.push_back(run);
  }
  return {TestSkeleton(joints, above), clip, TestMesh(runs, inverse_bind, residuals)};
}

}  // namespace marrow::test
