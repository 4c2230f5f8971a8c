#include "render/sitting.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "common/failure.h"
#include "common/load_mrw.h"
#include "render/heat.h"

namespace marrow::tools {
namespace {

constexpr int kLargestSide = 8192;
constexpr float kFrameMargin = 0.09f;

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

// "ssd:as" → the two deformers; "" → none.
std::optional<std::pair<Deformer, Deformer>> parse_pair(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const std::size_t colon = text.find(':');
  const std::optional<Deformer> a = parse_deformer(text.substr(0, colon));
  const std::optional<Deformer> b = colon == std::string::npos ? std::nullopt : parse_deformer(text.substr(colon + 1));
  if (!a || !b) {
    throw Failure(Exit::usage, "--heatmap", "", "\"" + text + "\" is not a pair of deformers",
                  "give two of rigid, ssd and as, as in ssd:as");
  }
  return std::pair{*a, *b};
}

std::string folder_of_images(const RenderArguments& arguments) {
  if (!arguments.images_from.empty()) return arguments.images_from;
  return std::filesystem::path(arguments.file).parent_path().string();
}

}  // namespace

Sitting::Sitting(const RenderArguments& arguments)
    : arguments_(arguments),
      size_(parse_size(arguments.size)),
      heat_(parse_pair(arguments.heatmap)),
      path_(*parse_skin_path(arguments.path)),
      deformer_(*parse_deformer(arguments.deformer)),
      normals_(*parse_as_normals(arguments.normals)),
      loaded_(load_mrw(arguments.file)),
      chosen_(choose(arguments.file, loaded_.file, arguments.choice)),
      character_(loaded_.file, normals_, arguments.lod),
      performance_(loaded_.file, character_, chosen_.play),
      textures_(gl_, arguments.file, loaded_.file, folder_of_images(arguments)),
      figure_(gl_, loaded_.file, &textures_, normals_, arguments.lod),
      studio_(gl_, size_.first, size_.second) {}

void Sitting::agree_on_heat(std::span<const Instant> instants) {
  if (!heat_) return;
  float largest = 0;
  for (const Instant& instant : instants) {
    character_.pose(chosen_.play, instant.time_s);
    largest = std::max(largest, largest_distance(skin_all(loaded_.file, character_, heat_->first),
                                                 skin_all(loaded_.file, character_, heat_->second)));
  }
  heat_scale_ = sensible_scale(largest, performance_.diagonal());
  std::printf("%s: largest distance %.6g mm (%.3g of the diagonal); the hottest colour is %.6g mm\n",
              arguments_.heatmap.c_str(), 1e3 * static_cast<double>(largest),
              static_cast<double>(largest / performance_.diagonal()), 1e3 * static_cast<double>(heat_scale_));
}

Image Sitting::shoot(const Instant& instant) {
  character_.pose(chosen_.play, instant.time_s);
  const float aspect = static_cast<float>(width()) / static_cast<float>(height());
  Shot shot = instant.turn_rad ? performance_.turned_shot(character_, aspect, kFrameMargin, *instant.turn_rad)
                               : performance_.shot(character_, aspect, kFrameMargin);
  shot.palettes = &figure_.palettes();
  const std::vector<Drawable> drawn = drawables(shot);
  return studio_.shoot(shot, drawn);
}

std::vector<Drawable> Sitting::drawables(Shot& shot) {
  const std::vector<PosedMesh> posed = skin_all(loaded_.file, character_, heat_ ? heat_->first : deformer_);
  shot.box = box_of(posed);
  if (heat_) {
    const std::vector<PosedMesh> other = skin_all(loaded_.file, character_, heat_->second);
    shot.shading = 0.25f;
    return figure_.from_cpu(posed, compare(posed, other, heat_scale_).colours);
  }
  if (path_ == SkinPath::cpu) return figure_.from_cpu(posed);
  if (const std::optional<std::uint32_t> mesh = figure_.too_large()) {
    throw Failure(Exit::unsupported, arguments_.file, "mesh " + std::to_string(*mesh),
                  "more joints than one uniform block holds (" + std::to_string(gles3::kPaletteJoints) + ")",
                  "use --path cpu");
  }
  return figure_.on_gpu(character_, deformer_);
}

}  // namespace marrow::tools
