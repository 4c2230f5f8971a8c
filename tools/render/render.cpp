#include "render/render.h"

#include <cstdio>
#include <filesystem>

#include "common/failure.h"
#include "common/load_mrw.h"
#include "render/figure.h"
#include "render/heat.h"
#include "render/performance.h"

namespace marrow::tools {
namespace {

constexpr int kLargestSide = 8192;
constexpr float kMargin = 0.09f;

struct Size {
  int width, height;
};

Size parse_size(const std::string& text) {
  int width = 0, height = 0, end = 0;
  const int fields = std::sscanf(text.c_str(), "%5dx%5d%n", &width, &height, &end);
  const bool whole = fields == 2 && static_cast<std::size_t>(end) == text.size();
  if (!whole || width < 1 || height < 1 || width > kLargestSide || height > kLargestSide) {
    throw Failure(Exit::usage, "--size", "", "\"" + text + "\" is not a size",
                  "give WIDTHxHEIGHT, each 1 to 8192, as in 960x720");
  }
  return {width, height};
}

// "ssd:as" → the two deformers.
std::pair<Deformer, Deformer> parse_pair(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::optional<Deformer> a = parse_deformer(text.substr(0, colon));
  const std::optional<Deformer> b = colon == std::string::npos ? std::nullopt : parse_deformer(text.substr(colon + 1));
  if (!a || !b) {
    throw Failure(Exit::usage, "--heatmap", "", "\"" + text + "\" is not a pair of deformers",
                  "give two of rigid, ssd and as, as in ssd:as");
  }
  return {*a, *b};
}

std::vector<Drawable> make_drawables(const RenderArguments& arguments, const File& file, const Character& character,
                                     Figure& figure) {
  const Deformer deformer = *parse_deformer(arguments.deformer);
  if (arguments.path == "cpu") return figure.from_cpu(skin_all(file, character, deformer));
  if (const std::optional<std::uint32_t> mesh = figure.too_large()) {
    throw Failure(Exit::unsupported, arguments.file, "mesh " + std::to_string(*mesh),
                  "more joints than one uniform block holds (" + std::to_string(gles3::kPaletteJoints) + ")",
                  "use --path cpu");
  }
  return figure.on_gpu(character, deformer);
}

}  // namespace

void run_render(const RenderArguments& arguments) {
  const Size size = parse_size(arguments.size);
  std::optional<std::pair<Deformer, Deformer>> pair;
  if (!arguments.heatmap.empty()) pair = parse_pair(arguments.heatmap);
  const LoadedFile loaded = load_mrw(arguments.file);
  const File& file = loaded.file;
  const Chosen chosen = choose(arguments.file, file, arguments.choice);

  const AsNormals normals = *parse_as_normals(arguments.normals);
  Character character(file, normals, arguments.lod);
  const Performance performance(file, character, chosen.play);
  character.pose(chosen.play, arguments.choice.time_s);
  const Gl gl;
  const std::string beside = std::filesystem::path(arguments.file).parent_path().string();
  const Textures textures(gl, arguments.file, file, arguments.images_from.empty() ? beside : arguments.images_from);
  Figure figure(gl, file, &textures, normals, arguments.lod);
  Studio studio(gl, size.width, size.height);
  Shot shot = performance.shot(character, static_cast<float>(size.width) / static_cast<float>(size.height), kMargin);
  shot.palettes = &figure.palettes();
  shot.box = box_of(skin_all(file, character, pair ? pair->first : *parse_deformer(arguments.deformer)));

  std::vector<Drawable> drawables;
  if (pair) {
    const std::vector<PosedMesh> a = skin_all(file, character, pair->first);
    const std::vector<PosedMesh> b = skin_all(file, character, pair->second);
    const HeatMap map = compare(a, b, sensible_scale(largest_distance(a, b), performance.diagonal()));
    drawables = figure.from_cpu(a, map.colours);
    shot.shading = 0.25f;
    std::printf("%s: largest distance %.6g mm (%.3g of the diagonal); the hottest colour is %.6g mm\n",
                arguments.heatmap.c_str(), 1e3 * static_cast<double>(map.largest),
                static_cast<double>(map.largest / performance.diagonal()), 1e3 * static_cast<double>(map.full_scale));
  } else {
    drawables = make_drawables(arguments, file, character, figure);
  }
  write_png(arguments.output, studio.shoot(shot, drawables));
  std::fprintf(stderr, "%s: %dx%d, %s\n", arguments.output.c_str(), size.width, size.height, gl.driver().c_str());
}

}  // namespace marrow::tools
