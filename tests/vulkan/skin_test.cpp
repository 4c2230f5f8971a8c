// Skins meshes by Vulkan, by the compute shader of marrow::gles3, and compares every vertex with the CPU's.
//
// usage: marrow_vulkan_skin FOLDER     with the SPIR-V that tools/check_spirv.sh makes of the texts
// Exit 0: all are as near as OpenGL ES is; 1: one is not; 77: there is no driver of Vulkan.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "core/memory.h"
#include "gles3/self_test_mesh.h"
#include "marrow/gles3_skinned.h"
#include "marrow/palette.h"
#include "marrow/skin.h"
#include "vulkan/recorder.h"
#include "vulkan/uniform_block.h"
#include "vulkan/vulkan_compute.h"

namespace marrow::test {
namespace {

using gles3::Deformer;

// Of OpenGL ES: docs/architecture.md.
constexpr double kMostPosition = 2e-4;  // of the diagonal
constexpr double kMostNormalDeg = 1;

constexpr Run kFourInfluences[] = {{801, 1}, {802, 2}, {803, 3}, {804, 4}};
constexpr Run kEightInfluences[] = {{401, 1}, {402, 2}, {403, 3}, {404, 4}, {405, 5}, {406, 6}, {407, 7}, {409, 8}};

struct Vertices {
  std::vector<float> positions, normals, tangents;
  explicit Vertices(const Geometry& g)
      : positions(std::size_t{3} * g.slot_count),
        normals(g.normals != nullptr ? positions.size() : 0),
        tangents(g.tangents != nullptr ? std::size_t{4} * g.slot_count : 0) {}
  SkinOutput output() { return {positions, normals, tangents}; }
};

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

double diagonal_of(const std::vector<float>& positions) {
  float low[3] = {1e30f, 1e30f, 1e30f}, high[3] = {-1e30f, -1e30f, -1e30f};
  for (std::size_t i = 0; i < positions.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], positions[i]);
    high[i % 3] = std::max(high[i % 3], positions[i]);
  }
  return distance(low, high);
}

// A NaN must not pass for a small one.
void raise(double& worst, double value) {
  worst = value >= 0 ? std::max(worst, value) : 1e30;
}

Worst compare(const Vertices& got, const Vertices& want) {
  Worst out;
  constexpr double kDegrees = 57.29577951308232;
  const double diagonal = diagonal_of(want.positions);
  out.vertices = want.positions.size() / 3;
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
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry));
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

// What Marrow has recorded for OpenGL ES, by Vulkan.
bool skin_by_vulkan(VulkanCompute& vulkan, const std::vector<std::uint32_t>& spirv, Span<const Affine> palette,
                    Vertices& out) {
  Recorder& from = recorder();
  std::vector<ComputeBuffer> buffers(6);
  for (unsigned i = 0; i < 4; ++i) buffers[i].bytes = from.buffers[from.bindings[i]];
  buffers[4] = {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, std::vector<std::byte>(gles3::kPaletteBlockBytes)};
  std::memcpy(buffers[4].bytes.data(), palette.data, palette.size * sizeof(Affine));
  buffers[5] = {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, pack_uniforms(find_uniform_block(spirv), from.uniforms)};
  if (!vulkan.run(spirv, from.groups, buffers)) return false;
  const std::byte* at = buffers[3].bytes.data();
  for (std::vector<float>* block : {&out.positions, &out.normals, &out.tangents}) {
    std::memcpy(block->data(), at, 4 * block->size());
    at += 4 * block->size();
  }
  return true;
}

// One mesh in one pose, by one deformer.
bool run_one(VulkanCompute& vulkan, const std::string& folder, const Mesh& mesh, Deformer deformer, int features,
             std::uint32_t frame, Worst& worst) {
  recorder() = {};
  const gles3::Api api = recording_api();
  gles3::Caps caps;
  caps.compute = true;
  std::vector<std::byte> scratch(gles3::prepare_scratch_bytes(mesh));
  std::vector<Affine> bind(mesh.joint_count), scene(mesh.joint_count), palette(mesh.palette_size());
  gles3::GpuMesh gpu;
  gles3::SkinnedMesh skinned;
  gles3::Program program;
  if (prepare(api, caps, mesh, {}, scratch, bind, gpu) != Status::ok) return false;
  const gles3::ProgramKey key{deformer, gpu.influences, static_cast<std::uint8_t>(features)};
  gles3::pose_probe(frame, 0, scene);
  const Span<const std::uint16_t> joints(mesh.joints, mesh.joint_count);
  if (create_skinned(api, gpu, skinned) != Status::ok ||
      build_preskin(api, caps, key, gles3::Preskin::compute, 0, program) != Status::ok ||
      build_palette(joints, bind, scene, palette) != Status::ok ||
      preskin(api, gpu, deformer, program, skinned) != Status::ok)
    return false;
  const std::vector<std::uint32_t> spirv = read_spirv(folder + "/compute-" + name_of(key) + ".comp.spv");
  Vertices got(mesh.geometry), want(mesh.geometry);
  if (spirv.empty() || !skin_by_vulkan(vulkan, spirv, palette, got)) return false;
  if (build_palette(mesh, scene, palette) != Status::ok || !skin_by_cpu(mesh, deformer, palette, want.output()))
    return false;
  const Worst one = compare(got, want);
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
      const ProbeMesh probe(runs, runs.size == 4 ? 9 : gles3::kPaletteJoints, features);
      for (std::uint32_t frame = 0; frame < 3; ++frame)
        if (!run_one(vulkan, folder, probe.mesh, deformer, features, frame, worst)) {
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
