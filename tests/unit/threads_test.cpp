// Stages share their inputs between threads and write only to their outputs; the thread sanitizer looks on.
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "support/pose_file.h"
#include "support/rig.h"

namespace marrow {
namespace {

// One character's instance state and the hash of what it looked like over some frames.
struct Worker {
  explicit Worker(const test::TestCharacter& character) : c(character) {}
  void run() {
    const Skeleton skeleton = c.skeleton.view();
    const Clip clip = c.clip.view();
    const Mesh mesh = c.mesh.view();
    std::vector<SoaTransform> local(skeleton.soa_size());
    std::vector<Affine> model(skeleton.joint_count), palette(mesh.joint_count);
    std::vector<float> coordinates(as_coordinate_count(mesh.geometry)), positions(mesh.geometry.slot_count * 3);
    std::vector<float> normals(positions.size()), tangents(mesh.geometry.slot_count * 4);
    const SkinOutput out{positions, normals, tangents};
    ok = as_coordinates(mesh.geometry, coordinates) == Status::ok;
    for (int frame = 0; frame < 50; ++frame) {
      ok = ok && sample(skeleton, clip, static_cast<float>(frame) * 0.03125f, local) == Status::ok &&
           local_to_model(skeleton, local, model) == Status::ok && build_palette(mesh, model, palette) == Status::ok;
      ok = ok && skin_rigid(mesh, palette, out) == Status::ok;
      hash = test::hash(hash, positions.data(), positions.size() * sizeof(float));
      ok = ok && skin_ssd(mesh, palette, out) == Status::ok;
      hash = test::hash(hash, normals.data(), normals.size() * sizeof(float));
      ok = ok && skin_as(mesh, coordinates, palette, out) == Status::ok;
      hash = test::hash(hash, positions.data(), positions.size() * sizeof(float));
      hash = test::hash(hash, tangents.data(), tangents.size() * sizeof(float));
    }
  }
  const test::TestCharacter& c;
  std::uint64_t hash = test::kHashStart;
  bool ok = false;
};

TEST(Threads, FourOnTheSameAssetsGetTheSameBits) {
  const test::TestCharacter character = test::make_character(31, 29, 11, true);
  Worker alone(character);
  alone.run();
  ASSERT_TRUE(alone.ok);
  std::vector<Worker> workers(4, Worker(character));
  std::vector<std::thread> threads;
  for (Worker& worker : workers) threads.emplace_back([&worker] { worker.run(); });
  for (std::thread& thread : threads) thread.join();
  for (const Worker& worker : workers) {
    EXPECT_TRUE(worker.ok);
    EXPECT_EQ(worker.hash, alone.hash);
  }
}

}  // namespace
}  // namespace marrow
