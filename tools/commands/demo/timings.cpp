#include "commands/demo/timings.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include "pose/evaluate.h"

namespace marrow::tools {
namespace {

constexpr int kRuns = 65;
constexpr double kPatienceUs = 150e3;  // a stage; large meshes get fewer runs

double now_us() {
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Median of the times of run(0), run(1), …, after one that does not count.
template <class Run>
double median_us(const Run& run) {
  run(0);
  std::vector<double> times;
  double spent = 0;
  for (int i = 0; i < kRuns && (i < 5 || spent < kPatienceUs); ++i) {
    const double start = now_us();
    run(i);
    times.push_back(now_us() - start);
    spent += times.back();
  }
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  return times[times.size() / 2];
}

// Everything that skinning all meshes reads and writes, made once.
struct Bench {
  std::vector<Mesh> meshes;
  std::vector<std::vector<float>> coordinates, positions, normals;

  explicit Bench(const File& file) {
    for (std::uint32_t i = 0; i < file.mesh_count(); ++i) {
      const Mesh mesh = file.mesh(i);
      const Geometry& g = mesh.geometry;
      meshes.push_back(mesh);
      coordinates.emplace_back(as_coordinate_count(g));
      check(as_coordinates(g, coordinates.back()));
      positions.emplace_back(std::size_t{3} * g.slot_count);
      normals.emplace_back(g.normals != nullptr ? std::size_t{3} * g.slot_count : 0);
    }
  }
  SkinOutput output(std::size_t mesh) { return {positions[mesh], normals[mesh], {}}; }
};

Span<const Affine> palette(const Character& character, std::size_t mesh) {
  return character.palette(static_cast<std::uint32_t>(mesh));
}

}  // namespace

Timings measure(const File& file, std::optional<std::uint32_t> clip_index, PlainSkin& plain) {
  Timings timings;
  Character character(file);
  const Play play = clip_index ? play_together(file, *clip_index) : Play{};
  const auto moment = [&](int run) { return play.duration_s * static_cast<float>(run) / kRuns; };
  std::vector<std::vector<SoaTransform>> local;
  for (std::uint32_t i = 0; i < file.skeleton_count(); ++i) local.emplace_back(file.skeleton(i).soa_size());
  if (clip_index)
    timings.sample_us = median_us([&](int run) {
      for (std::uint32_t i = 0; i < local.size(); ++i)
        if (const std::optional<Clip> clip = play.clip(i))
          check(sample(file.skeleton(i), *clip, moment(run), local[i]));
    });
  character.pose(play, moment(kRuns / 3));
  plain.skin(character);
  Bench of_plain(plain.file()), of_as(file);
  timings.plain_us = median_us([&](int) {
    for (std::size_t i = 0; i < of_plain.meshes.size(); ++i)
      check(skin_ssd(of_plain.meshes[i], palette(plain.character(), i), of_plain.output(i)));
  });
  timings.as_us = median_us([&](int) {
    for (std::size_t i = 0; i < of_as.meshes.size(); ++i)
      check(skin_as(of_as.meshes[i], of_as.coordinates[i], palette(character, i), of_as.output(i)));
  });
  return timings;
}

}  // namespace marrow::tools
