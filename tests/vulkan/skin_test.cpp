// Skins meshes by Vulkan, by the compute shader of marrow::gles3, and compares every vertex with the CPU's.
//
// usage: marrow_vulkan_skin FOLDER     with the SPIR-V that tools/check/spirv.sh makes of the texts
// Exit 0: all are as near as OpenGL ES is; 1: one is not; 77: there is no driver of Vulkan.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "core/memory.h"
#include "gles3/mesh/gpu_mesh.h"
#include "gles3/mesh/prepare.h"
#include "gles3/palettes.h"
#include "gles3/program.h"
#include "gles3/self_test/self_test_mesh.h"
#include "gles3/skinned.h"
#include "marrow/gles3_skinner.h"
#include "marrow/palette.h"
#include "marrow/skin.h"
#include "vulkan/recorder.h"
#include "vulkan/uniform_block.h"
#include "vulkan/vulkan_compute.h"

namespace marrow::test {
namespace {

using gles3::Deformer;

// Of OpenGL ES: docs/performance.md.
constexpr double kMostPosition = 2e-4;  // of the diagonal
constexpr double kMostNormalDeg = 1;

constexpr Run kFourInfluences[] = {{801, 1}, {802, 2}, {803, 3}, {804, 4}};
constexpr Run kEightInfluences[] = {{401, 1}, {402, 2}, {403, 3}, {404, 4}, {405, 5}, {406, 6}, {407, 7}, {409, 8}};

// The blocks of an engine's vertex buffer, mapped: positions of every slot, then normals, then tangents.
SkinOutput blocks_in(float* mapped, const Geometry& g) {
  const std::size_t n = g.slot_count;
  SkinOutput out{.positions = {mapped, 3 * n}};
  if (g.normals != nullptr) out.normals = {mapped + 3 * n, 3 * n};
  if (g.tangents != nullptr) out.tangents = {mapped + 6 * n, 4 * n};
  return out;
}

// Noise in memory that lasts as long as this.
struct ProbeMesh {
  std::vector<std::byte> memory;
  Mesh mesh;
  ProbeMesh(Span<const Run> runs, std::uint32_t joints, int features) {
    Memory pieces;
    gles3::make_probe_mesh({runs, joints}, pieces);
    memory.resize(pieces.used + 16);
    pieces = {memory.data() + (16 - reinterpret_cast<std::uintptr_t>(memory.data()) % 16) % 16};
    mesh = gles3::make_probe_mesh({runs, joints}, pieces);
    if ((features & gles3::kNormals) == 0) mesh.geometry.normals = nullptr;
    if ((features & gles3::kTangents) == 0) mesh.geometry.tangents = nullptr;
  }
  ProbeMesh(const ProbeMesh&) = delete;
  ProbeMesh& operator=(const ProbeMesh&) = delete;
};

struct Worst {
  double position = 0, normal_deg = 0, tangent_deg = 0;
  std::size_t vertices = 0, wrong_signs = 0;
};

double distance(const float* a, const float* b) {
  double squared = 0;
  for (int c = 0; c < 3; ++c) {
    const double d = static_cast<double>(a[c]) - static_cast<double>(b[c]);
    squared += d * d;
  }
  return std::sqrt(squared);
}

double diagonal_of(Span<float> positions) {
  float low[3] = {1e30f, 1e30f, 1e30f}, high[3] = {-1e30f, -1e30f, -1e30f};
  for (std::size_t i = 0; i < positions.size; ++i) {
    low[i % 3] = std::min(low[i % 3], positions[i]);
    high[i % 3] = std::max(high[i % 3], positions[i]);
  }
  return distance(low, high);
}

// A NaN must not pass for a small one.
void raise(double& worst, double value) {
  worst = value >= 0 ? std::max(worst, value) : 1e30;
}

Worst compare(const SkinOutput& got, const SkinOutput& want) {
  Worst out;
  constexpr double kDegrees = 57.29577951308232;
  const double diagonal = diagonal_of(want.positions);
  out.vertices = want.positions.size / 3;
  for (std::size_t slot = 0; slot < out.vertices; ++slot) {
    raise(out.position, distance(&got.positions[3 * slot], &want.positions[3 * slot]) / diagonal);
    // Unit vectors: the chord, as good as the angle where it is small.
    if (!want.normals.empty())
      raise(out.normal_deg, kDegrees * distance(&got.normals[3 * slot], &want.normals[3 * slot]));
    if (want.tangents.empty()) continue;
    raise(out.tangent_deg, kDegrees * distance(&got.tangents[4 * slot], &want.tangents[4 * slot]));
    if (!(got.tangents[4 * slot + 3] * want.tangents[4 * slot + 3] > 0)) ++out.wrong_signs;
  }
  return out;
}

bool skin_by_cpu(const Mesh& mesh, Deformer deformer, Span<const Affine> palette, const SkinOutput& out) {
  if (deformer == Deformer::rigid) return skin_rigid(mesh, palette, out) == Status::ok;
  if (deformer == Deformer::ssd) return skin_ssd(mesh, palette, out) == Status::ok;
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry));  // a game makes them once a mesh
  return as_coordinates(mesh.geometry, coordinates) == Status::ok &&
         skin_as(mesh, coordinates, palette, out) == Status::ok;
}

std::vector<std::uint32_t> read_spirv(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  std::vector<std::uint32_t> words(file ? static_cast<std::size_t>(file.tellg()) / 4 : 0);
  file.seekg(0);
  file.read(reinterpret_cast<char*>(words.data()), static_cast<std::streamsize>(4 * words.size()));
  return words;
}

// What an engine keeps of a mesh.
struct EngineMesh {
  std::vector<Affine> bind;      // for its palettes, in the place of Mesh::inverse_bind
  std::vector<std::byte> in[3];  // storage buffers, bindings 0 … 2
  std::size_t out_bytes = 0;     // of the storage buffer at binding 3
  std::map<std::string, std::vector<std::uint32_t>> uniforms;
  unsigned groups = 0;  // to dispatch
};

// Once a mesh: marrow::gles3 over a driver that only keeps what it is given.
bool make_engine_mesh(const Mesh& mesh, const gles3::ProgramKey& key, EngineMesh& out) {
  recorder() = {};
  const gles3::Api api = recording_api();
  gles3::Caps caps;
  caps.compute = true;
  std::vector<std::byte> scratch(gles3::prepare_scratch_bytes(mesh));
  out.bind.resize(mesh.joint_count);
  gles3::GpuMesh gpu;
  gles3::SkinnedMesh skinned;
  gles3::Program program;
  if (prepare(api, caps, mesh, {}, scratch, out.bind, gpu) != Status::ok ||
      create_skinned(api, gpu, skinned) != Status::ok ||
      create_preskin(api, caps, key, gles3::Preskin::compute, 0, program) != Status::ok ||
      preskin(api, gpu, key.deformer, program, skinned) != Status::ok)
    return false;
  Recorder& from = recorder();
  for (unsigned i = 0; i < 3; ++i) out.in[i] = from.buffers[from.bindings[i]];
  out.out_bytes = from.buffers[from.bindings[3]].size();
  out.uniforms = from.uniforms;
  out.groups = from.groups;
  return true;
}

// Every frame.
bool skin_by_vulkan(VulkanCompute& vulkan, const std::vector<std::uint32_t>& spirv, const EngineMesh& mesh,
                    Span<const Affine> palette, std::vector<float>& out) {
  std::vector<ComputeBuffer> buffers(6);
  for (std::size_t i = 0; i < 3; ++i) buffers[i].bytes = mesh.in[i];
  buffers[3].bytes.resize(mesh.out_bytes);
  buffers[4] = {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, std::vector<std::byte>(gles3::kPaletteBlockBytes)};
  std::memcpy(buffers[4].bytes.data(), palette.data, palette.size * sizeof(Affine));
  buffers[5] = {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, pack_uniforms(find_uniform_block(spirv), mesh.uniforms)};
  if (mesh.out_bytes != 4 * out.size() || !vulkan.run(spirv, mesh.groups, buffers)) return false;
  std::memcpy(out.data(), buffers[3].bytes.data(), mesh.out_bytes);
  return true;
}

// One mesh in one pose, by one deformer.
bool run_one(VulkanCompute& vulkan, const std::string& folder, const Mesh& mesh, const gles3::ProgramKey& key,
             std::uint32_t frame, Worst& worst) {
  const Geometry& g = mesh.geometry;
  const std::size_t floats = (g.normals != nullptr ? 6u : 3u) + (g.tangents != nullptr ? 4u : 0u);
  std::vector<float> got(floats * g.slot_count), want(floats * g.slot_count);
  std::vector<Affine> scene(mesh.joint_count), palette(mesh.palette_size());
  const std::vector<std::uint32_t> spirv = read_spirv(folder + "/compute-" + name_of(key) + ".comp.spv");
  EngineMesh engine;
  gles3::pose_probe(frame, 0, scene);
  if (spirv.empty() || !make_engine_mesh(mesh, key, engine) ||
      build_palette({mesh.joints, mesh.joint_count}, engine.bind, scene, palette) != Status::ok ||
      !skin_by_vulkan(vulkan, spirv, engine, palette, got) || build_palette(mesh, scene, palette) != Status::ok ||
      !skin_by_cpu(mesh, key.deformer, palette, blocks_in(want.data(), g)))
    return false;
  const Worst one = compare(blocks_in(got.data(), g), blocks_in(want.data(), g));
  worst.position = std::max(worst.position, one.position);
  worst.normal_deg = std::max(worst.normal_deg, one.normal_deg);
  worst.tangent_deg = std::max(worst.tangent_deg, one.tangent_deg);
  worst.vertices += one.vertices;
  worst.wrong_signs += one.wrong_signs;
  return true;
}

bool run_deformer(VulkanCompute& vulkan, const std::string& folder, Deformer deformer, const char* name) {
  Worst worst;
  for (const Span<const Run> runs : {Span<const Run>(kFourInfluences), Span<const Run>(kEightInfluences)})
    for (const int features : {0, int{gles3::kNormals}, gles3::kNormals | gles3::kTangents}) {
      // Joints in a byte each, and in two.
      const bool four = runs.size == 4;
      const ProbeMesh probe(runs, four ? 9 : gles3::kPaletteJoints, features);
      const gles3::ProgramKey key{deformer, static_cast<std::uint8_t>(four ? 4 : 8),
                                  static_cast<std::uint8_t>(features)};
      for (std::uint32_t frame = 0; frame < 3; ++frame)
        if (!run_one(vulkan, folder, probe.mesh, key, frame, worst)) {
          std::fprintf(stderr, "marrow_vulkan_skin: %s: a call has failed, or SPIR-V is missing\n", name);
          return false;
        }
    }
  std::printf("%-6s %6zu vertices  position %.1e of the diagonal  normal %.3f deg  tangent %.3f deg\n", name,
              worst.vertices, worst.position, worst.normal_deg, worst.tangent_deg);
  return worst.vertices > 0 && worst.position <= kMostPosition && worst.normal_deg <= kMostNormalDeg &&
         worst.tangent_deg <= kMostNormalDeg && worst.wrong_signs == 0;
}

int run(const std::string& folder) {
  VulkanCompute vulkan;
  if (!vulkan.open()) {
    std::fprintf(stderr, "marrow_vulkan_skin: there is no driver of Vulkan\n");
    return 77;
  }
  std::printf("%s, %s\n", vulkan.device_name().c_str(), vulkan.validated() ? "validated" : "not validated");
  bool right = true;
  constexpr const char* kNames[] = {"rigid", "ssd", "as"};
  for (const auto deformer : {Deformer::rigid, Deformer::ssd, Deformer::as})
    right = run_deformer(vulkan, folder, deformer, kNames[static_cast<std::size_t>(deformer) - 1]) && right;
  if (vulkan.complaints() != 0)
    std::fprintf(stderr, "marrow_vulkan_skin: %u complaints of the validation layer\n", vulkan.complaints());
  return right && vulkan.complaints() == 0 ? 0 : 1;
}

}  // namespace
}  // namespace marrow::test

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: marrow_vulkan_skin FOLDER\n");
    return 1;
  }
  return marrow::test::run(arguments[1]);
}
