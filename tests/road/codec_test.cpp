// Every model through each mesh codec: posed, it strays from the reference evaluator by no more than the report says.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include <gtest/gtest.h>

#include "road/cooked.h"
#include "road/models.h"
#include "road/reference.h"

namespace marrow::test {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr int kMoments = 1;
#else
constexpr int kMoments = 3;
#endif
constexpr double kFloats = 1e-5;  // of the diagonal: what 32-bit floats cost

struct Stray {
  double position = 0, normal_deg = 0;
  std::size_t vertices = 0;
};

void compare(const Reference& reference, const ReferencePose& want, const CookedPose& got, Stray& worst) {
  ASSERT_EQ(got.positions.size(), want.positions.size());
  for (std::size_t v = 0; v < want.positions.size(); ++v) {
    if (!reference.comparable(v) || !got.used[v]) continue;
    const double off = length(minus(want.positions[v], got.positions[v])) / reference.diagonal();
    worst.position = std::max(worst.position, off < 1e300 ? off : 1e300);
    ++worst.vertices;
  }
}

// Draco drops triangles without an area. This model has vertices that no other triangle names.
bool has_corners_of_no_area(const std::string& model) {
  return std::filesystem::path(model).stem() == "raylib_robot";
}

class RoadCodecs : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
#if defined(__SANITIZE_ADDRESS__)
    if (std::filesystem::file_size(GetParam()) > 1'000'000) GTEST_SKIP() << "thinned under sanitizers";
#endif
  }
};

// In clips rounded weights move a vertex by at most their change times how far its joints carry it apart: the diagonal,
// at most.
TEST_P(RoadCodecs, StrayNoFurtherThanTheReportSays) {
  const Reference reference(GetParam());
  for (const cook::MeshCodec codec : {cook::MeshCodec::draco, cook::MeshCodec::meshopt}) {
    const Cooked cooked(GetParam(), codec);
    double position_m = 0, weight = 0;
    const bool by_draco = codec == cook::MeshCodec::draco;
    for (const auto& mesh : cooked.report()["meshes"]) {
      if (!by_draco || !has_corners_of_no_area(GetParam())) {
        EXPECT_EQ(mesh["codec"], by_draco ? "draco" : "meshopt");
      }
      position_m = std::max(position_m, mesh["max_position_error_m"].get<double>());
      weight = std::max(weight, mesh["max_weight_error"].get<double>() * (mesh["influences"].get<double>()));
    }
    Stray rest, worst;
    const std::uint32_t clips = cooked.file().clip_count();
    compare(reference, reference.rest(), cooked.pose(clips, 0, Deformer::ssd), rest);
    std::uint32_t clip = 0;
    for (std::size_t a = 0; a < reference.source().animations.size(); ++a) {
      const SourceAnimation& animation = reference.source().animations[a];
      if (animation.channels.empty() && animation.weights.empty()) continue;
      for (int i = 1; i <= kMoments && !animation.channels.empty(); ++i) {
        const auto time_s = static_cast<float>(reference.duration_s(a) * i / (kMoments + 1));
        compare(reference, reference.at(a, static_cast<double>(time_s)), cooked.pose(clip, time_s, Deformer::ssd),
                worst);
      }
      clip = next_animation(cooked.file(), clip);
    }
    EXPECT_EQ(clip, clips);
    EXPECT_GT(rest.vertices, 0u);
    EXPECT_LE(rest.position, kFloats + position_m / reference.diagonal()) << "all that is rounded counts";
    // Clips may scale.
    EXPECT_LE(worst.position, kFloats + weight + 2 * position_m / reference.diagonal());
    std::printf("%-28s %-7s %8zu B  rest %8.2e  posed %8.2e of the diagonal, weights %.4f\n",
                std::filesystem::path(GetParam()).stem().c_str(), codec == cook::MeshCodec::draco ? "draco" : "meshopt",
                cooked.bytes(), rest.position, worst.position, weight);
  }
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = std::filesystem::path(info.param).stem().string() + "_" + std::to_string(info.index);
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Models, RoadCodecs, ::testing::ValuesIn(models()), test_name);

}  // namespace
}  // namespace marrow::test
