#include "render/look.h"

#include <algorithm>
#include <cstdio>

#include "common/failure.h"

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

}  // namespace marrow::tools
