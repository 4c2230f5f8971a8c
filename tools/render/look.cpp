#include "render/look.h"

#include <algorithm>
#include <cstdio>

#include "common/failure.h"
#include "gles3/palettes.h"
#include "render/heat.h"
#include "render/performance.h"

namespace marrow::tools {
namespace {

constexpr int kLargestSide = 8192;

}  // namespace

std::pair<int, int> parse_size(const std::string& text) {
  int width = 0, height = 0, end = 0;
  const int fields = std::sscanf(text.c_str(), "%5dx%5d%n", &width, &height, &end);
  const bool whole = fields == 2 && static_cast<std::size_t>(end) == text.size();
  if (!whole || width < 1 || height < 1 || width > kLargestSide || height > kLargestSide) {
    throw Failure(Exit::usage, "--size", "", "\"" + text + "\" is not a size",
                  "give WIDTHxHEIGHT, each 1 to 8192, as in 960x720");
  }
  return {width, height};
}

std::optional<DeformerPair> parse_pair(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const std::size_t colon = text.find(':');
  const std::optional<Deformer> a = value_of(kDeformers, text.substr(0, colon));
  const std::optional<Deformer> b =
      colon == std::string::npos ? std::nullopt : value_of(kDeformers, text.substr(colon + 1));
  if (!a || !b) {
    throw Failure(Exit::usage, "--heatmap", "", "\"" + text + "\" is not a pair of deformers",
                  "give two of rigid, ssd, as, mwe and psd, as in ssd:as");
  }
  return DeformerPair{*a, *b};
}

std::vector<Drawable> drawables_of(const std::string& path, const File& file, const Character& character,
                                   Figure& figure, const Manner& manner, Shot& shot) {
  std::vector<PosedMesh> posed;
  if (manner.heat || manner.path == SkinPath::cpu || shot.box.empty())
    posed = skin_all(file, character, manner.heat ? manner.heat->first : manner.deformer);
  if (shot.box.empty()) shot.box = box_of(posed);
  if (manner.heat) {
    const std::vector<PosedMesh> other = skin_all(file, character, manner.heat->second);
    shot.shading = kHeatShading;
    return figure.from_cpu(posed, compare(posed, other, manner.heat_scale).colours);
  }
  if (manner.path == SkinPath::cpu) return figure.from_cpu(posed);
  if (manner.path == SkinPath::crowd) return figure.from_crowd(character, manner.deformer, *manner.baked);
  if (const std::optional<std::uint32_t> mesh = figure.too_large(); mesh && manner.path != SkinPath::texture) {
    throw Failure(Exit::unsupported, path, "mesh " + std::to_string(*mesh),
                  "more joints than one uniform block holds (" + std::to_string(gles3::kPaletteJoints) + ")",
                  "use --path cpu or texture, or cook it without --palette");
  }
  return figure.on_gpu(character, manner.deformer, manner.path);
}

}  // namespace marrow::tools
