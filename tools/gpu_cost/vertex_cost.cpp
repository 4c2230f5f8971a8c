#include "gpu_cost/vertex_cost.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace marrow::embedded {
extern const unsigned char gpu_cost_table[];
extern const unsigned long long gpu_cost_table_size;
}  // namespace marrow::embedded

namespace marrow::tools {
namespace {

using nlohmann::json;

const json& table() {
  static const json parsed =
      json::parse(embedded::gpu_cost_table, embedded::gpu_cost_table + embedded::gpu_cost_table_size);
  return parsed;
}

// How programs are called in the table: of positions alone, with normals, with tangents too.
std::string attributes_of(const Geometry& g, bool surface) {
  std::string out = g.normals == nullptr ? "p" : g.tangents == nullptr ? "pn" : "pnt";
  if (surface) out += "-surface";
  if (!g.targets.empty()) out += "+morphs";
  return out;
}

std::uint32_t most_influences(const Geometry& g) {
  std::uint32_t out = 0;
  for (const Run& run : g.runs) out = std::max(out, run.influences);
  return out;
}

std::size_t index_of(const json& names, const char* name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

constexpr const char *kMali = "Mali-G57", *kAdreno = "Adreno 660", *kVideocore = "V3D 4.2";

// Whether the table has all three of them for a program.
bool is_told(const json& program) {
  const json& gpus = table().at("gpus");
  return std::ranges::none_of(std::initializer_list<const char*>{kMali, kAdreno, kVideocore},
                              [&](const char* gpu) { return program.at(index_of(gpus, gpu)).is_null(); });
}

// The program of the fewest influences that has as many; null: none.
const json* find_program(const char* path, GpuDeformer deformer, std::uint32_t influences,
                         const std::string& attributes) {
  constexpr const char* kNames[] = {"rigid", "ssd", "as", "psd"};
  for (std::uint32_t n = deformer == GpuDeformer::rigid ? 1 : std::max(influences, 4u); n <= 8; ++n) {
    const std::string name =
        fmt::format("{}/{}/{}/{}/colour", path, kNames[static_cast<std::size_t>(deformer)], n, attributes);
    const auto found = table().at("programs").find(name);
    if (found != table().at("programs").end() && is_told(*found)) return &*found;
  }
  return nullptr;
}

// Lowers `cost` to what the program costs on a GPU, and says of it whether it spills there.
void take_lower(const json& program, const char* gpu, const char* figure, double& cost, bool& spills) {
  const json& figures = program.at(index_of(table().at("gpus"), gpu));
  const double value = figures.at(index_of(table().at("figures"), figure)).get<double>();
  if (cost > 0 && value >= cost) return;
  cost = value;
  spills = figures.at(index_of(table().at("figures"), "spills")).get<double>() > 0;
}

}  // namespace

std::optional<VertexCost> vertex_cost(const Geometry& geometry, GpuDeformer deformer, bool surface_normals) {
  const std::uint32_t influences = most_influences(geometry);
  const bool surface =
      surface_normals && deformer == GpuDeformer::as && geometry.normals != nullptr && geometry.targets.empty();
  // Programs that morph are compiled with normals alone.
  std::string attributes = attributes_of(geometry, surface);
  if (attributes == "pnt+morphs" || attributes == "p+morphs") attributes = "pn+morphs";
  if (deformer == GpuDeformer::psd) {
    if (geometry.pose_space.examples.empty()) return std::nullopt;
    attributes = "pn";
  }
  VertexCost out;
  bool spills[3] = {};
  bool found = false;
  for (const char* const path : {"ubo", "texture"}) {
    const json* const program = find_program(path, deformer, influences, attributes);
    if (program == nullptr) continue;
    found = true;
    take_lower(*program, kMali, "cycles", out.mali_cycles, spills[0]);
    take_lower(*program, kAdreno, "instructions", out.adreno_instructions, spills[1]);
    take_lower(*program, kVideocore, "instructions", out.videocore_instructions, spills[2]);
  }
  out.spills = spills[0] || spills[1] || spills[2];
  return found ? std::optional(out) : std::nullopt;
}

}  // namespace marrow::tools
