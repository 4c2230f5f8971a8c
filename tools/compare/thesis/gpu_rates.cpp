#include "compare/thesis/rates.h"
#include "gpu_bench/gpu_rows.h"

namespace marrow::tools {
namespace {

using gles3::SkinningPath;

struct Algorithm {
  const char* name;
  gles3::Deformer deformer;
  bool has_helpers;
};
constexpr Algorithm kAlgorithms[] = {{"ssd", gles3::Deformer::ssd, false},
                                     {"as", gles3::Deformer::as, false},
                                     {"as_helpers", gles3::Deformer::as, true}};
constexpr SkinningPath kGpuPaths[] = {SkinningPath::ubo, SkinningPath::texture, SkinningPath::feedback,
                                      SkinningPath::compute, SkinningPath::cpu};

}  // namespace

std::vector<FrameRate> gpu_rates(bool full, std::string& driver) {
  const Gl gl;
  driver = gl.driver();
  std::vector<GpuCase> plain, helped;
  for (const ThesisSize& size : kThesisSizes) {
    plain.push_back({size.name, size.vertices, size.joints, 1, nullptr, false});
    helped.push_back({size.name, size.vertices, 2 * size.joints, 1, nullptr, false, 5});
  }
  std::vector<FrameRate> out;
  for (const SkinningPath path : kGpuPaths)
    for (const bool normals : {false, true}) {
      if ((normals && !full) || (path == SkinningPath::compute && !gl.caps().compute)) continue;
      // What is compared is measured in turn, so that whatever else the machine does meets all alike.
      std::vector<GpuRow> rows;
      for (std::size_t i = 0; i < plain.size(); ++i)
        for (const Algorithm& algorithm : kAlgorithms) {
          GpuRow row;
          row.of = algorithm.has_helpers ? &helped[i] : &plain[i];
          row.name = std::string(algorithm.name) + ", " + path_name(path) + ", " + row.of->name;
          row.path = path;
          row.deformer = algorithm.deformer;
          row.features = normals ? gles3::kNormals : 0;
          rows.push_back(std::move(row));
        }
      measure_gpu(gl, rows);
      for (std::size_t a = 0; a < std::size(kAlgorithms); ++a) {
        FrameRate& rate = out.emplace_back(FrameRate{kAlgorithms[a].name, path_name(path), normals, {}});
        for (std::size_t i = a; i < rows.size(); i += std::size(kAlgorithms))
          rate.frames_per_s.push_back(rows[i].frames_per_s);
      }
    }
  return out;
}

}  // namespace marrow::tools
