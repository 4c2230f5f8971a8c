#include "cli/support/cookings.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/places.h"

namespace marrow::test {
namespace {

// The sleeve without its weights.
std::string bare_elbow(const TemporaryFolder& folder) {
  std::string text = read_text(in_golden("elbow.gltf"));
  const std::string weights = R"(, "JOINTS_0": 1, "WEIGHTS_0": 2)";
  const std::size_t at = text.find(weights);
  EXPECT_NE(at, std::string::npos);
  if (at != std::string::npos) text.erase(at, weights.size());
  write_text(folder / "bare.gltf", text);
  return folder / "bare.gltf";
}

}  // namespace

std::vector<Cooking> cookings(const TemporaryFolder& folder) {
  const std::string newt = newt_glb(), elbow = in_golden("elbow.gltf"), bare = bare_elbow(folder);
  std::vector<Cooking> all = {
      {"newt-raw", newt, {"--mesh-codec", "none", "--clip-codec", "raw", "--position-error", "0.05mm"}},
      {"dance", in_golden("dance.gltf"), {"--mesh-codec", "none"}},
      {"looks", in_golden("looks.gltf"), {"--images", "embed", "--keep", "*"}},
      {"half", elbow, {"--as", "fit", "--truth", "dqs", "--helpers", "3"}},
      {"gaussian", bare, {"--auto-weights", "gaussian", "--mesh-codec", "none"}},
  };
#if defined(__SANITIZE_ADDRESS__)
  return all;  // the others take minutes
#endif
  if (!in_long_form()) return all;
  const std::vector<Cooking> slow = {
      {"newt", newt, {"--clip-error", "0.25mm", "--clip-error", "hand*=0.125mm"}},
      {"newt-lod", newt, {"--mesh-codec", "meshopt", "--clip-codec", "raw", "--lod", "0.5,0.25:2"}},
      {"face", in_golden("face.gltf"), {"--mesh-codec", "none", "--additive", "speak"}},
      {"limits", in_golden("limits.gltf"), {"--mesh-codec", "none"}},
      {"learnt", elbow, {"--as", "fit", "--mwe", "--psd", "4", "--mesh-codec", "none"}},
      {"mush", elbow, {"--as", "smooth", "--delta-mush", "5,0.25,cotangent", "--subdivide", "1"}},
      {"geodesic", bare, {"--auto-weights", "geodesic", "--smooth-weights", "2"}},
      {"rigged", newt, {"--auto-skeleton", "humanoid", "--mesh-codec", "none"}},
      {"glow", bare, {"--auto-weights", "glow", "--mesh-codec", "none"}},
  };
  all.insert(all.end(), slow.begin(), slow.end());
  return all;
}

std::vector<std::string> cook_command(const Cooking& cooking, const std::string& output,
                                      const std::vector<std::string>& settings) {
  std::vector<std::string> all = {"env"};
  all.insert(all.end(), settings.begin(), settings.end());
  all.insert(all.end(), {program(), "cook", cooking.source, "-o", output});
  all.insert(all.end(), cooking.options.begin(), cooking.options.end());
  return all;
}

std::string shining_gltf(const TemporaryFolder& folder) {
  nlohmann::json scene = nlohmann::json::parse(read_text(in_golden("looks.gltf")));
  nlohmann::json& plain = scene["materials"][2];
  plain["emissiveFactor"] = {1, 0.5, 0};
  plain["extensions"] = {{"KHR_materials_unlit", nlohmann::json::object()},
                         {"KHR_materials_emissive_strength", {{"emissiveStrength", 6}}}};
  scene["images"].push_back({{"name", "small"}, {"uri", "small.webp"}});
  scene["textures"][0]["extensions"] = {{"EXT_texture_webp", {{"source", 2}}}};
  for (const char* const used : {"KHR_materials_unlit", "KHR_materials_emissive_strength", "EXT_texture_webp"})
    scene["extensionsUsed"].push_back(used);
  write_text(folder / "shining.gltf", scene.dump());
  return folder / "shining.gltf";
}

}  // namespace marrow::test
