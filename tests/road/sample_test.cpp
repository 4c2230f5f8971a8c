// What the sample is for: enough of everything to show skinning, and clips that loop.
#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "road/cooked.h"
#include "support/places.h"

namespace marrow::test {
namespace {

const std::string kSample = newt_glb();

nlohmann::json read_json() {
  std::ifstream in(kSample, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  // Header of 12 bytes, chunk header of 8, then the JSON chunk, whose padding is white space.
  const auto length = static_cast<std::size_t>(static_cast<unsigned char>(bytes.at(12))) |
                      static_cast<std::size_t>(static_cast<unsigned char>(bytes.at(13))) << 8 |
                      static_cast<std::size_t>(static_cast<unsigned char>(bytes.at(14))) << 16;
  return nlohmann::json::parse(bytes.substr(20, length));
}

TEST(Sample, HasEveryKindOfChannelAndEnoughJoints) {
  const nlohmann::json json = read_json();
  EXPECT_GE(json.at("skins").at(0).at("joints").size(), 25u);
  std::set<std::string> kinds, names;
  for (const auto& animation : json.at("animations")) {
    names.insert(animation.at("name").get<std::string>());
    for (const auto& sampler : animation.at("samplers"))
      kinds.insert(sampler.value("interpolation", std::string("LINEAR")));
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"CUBICSPLINE", "LINEAR", "STEP"}));
  for (const char* name : {"walk", "twist", "reach"}) EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Sample, HasSmoothWeights) {
  const Cooked cooked(kSample);
  std::size_t vertices = 0, shared = 0;
  const marrow::Mesh skin = cooked.file().mesh(0);
  for (const marrow::Run& run : skin.geometry.runs) {
    vertices += run.vertex_count;
    if (run.influences > 1) shared += run.vertex_count;
  }
  EXPECT_GE(vertices, 3000u);
  EXPECT_GE(shared, vertices / 2);
}

TEST(Sample, LoopsWithoutASeam) {
  const Cooked cooked(kSample);
  int clips = 0;
  for (const char* name : {"walk", "twist", "reach"}) {
    const std::uint32_t clip = cooked.file().find_clip(name);
    ASSERT_LT(clip, cooked.file().clip_count()) << name;
    const CookedPose first = cooked.pose(clip, 0, Deformer::ssd);
    const CookedPose last = cooked.pose(clip, cooked.file().clip(clip).duration_s, Deformer::ssd);
    const CookedPose middle = cooked.pose(clip, 0.4F * cooked.file().clip(clip).duration_s, Deformer::ssd);
    double seam = 0, moved = 0;
    for (std::size_t v = 0; v < first.positions.size(); ++v) {
      seam = std::max(seam, length(minus(first.positions[v], last.positions[v])));
      moved = std::max(moved, length(minus(first.positions[v], middle.positions[v])));
    }
    EXPECT_LT(seam, 1e-5) << name;
    EXPECT_GT(moved, 0.05) << name;
    ++clips;
  }
  EXPECT_EQ(clips, 3);
}

}  // namespace
}  // namespace marrow::test
