// The GPU's part: the self-test, and what each skinning path costs, nanoseconds a vertex of a frame with one pass.
#include <array>
#include <cstdio>
#include <fstream>

#include "gles3/self_test/self_test_key.h"
#include "marrow/egl.h"
#include "marrow/gles3_self_test.h"
#include "phone/phone.h"

namespace marrow::phone {
namespace {

using gles3::SkinningPath;

constexpr unsigned kRenderer = 0x1F01, kVersion = 0x1F02;
constexpr unsigned kTexture2d = 0x0DE1, kRgba = 0x1908, kUnsignedByte = 0x1401;
constexpr unsigned kFramebuffer = 0x8D40, kColour0 = 0x8CE0, kComplete = 0x8CD5;
constexpr int kRgba8 = 0x8058, kSide = 16;

constexpr std::uint32_t kCharacters = 16;
constexpr double kBatch_s = 0.03;
constexpr std::size_t kBatches = 9;

// Out of sight, but the driver cannot know that before it has skinned.
constexpr const char* kVertexText = R"(
out vec3 shade;
void main() {
  MarrowVertex v = marrow_skin();
  shade = v.normal + v.position - v.previous_position;
  gl_Position = vec4(v.position.xy, v.position.z + 100.0, 1.0);
}
)";
constexpr const char* kFragmentText = R"(
precision mediump float;
in vec3 shade;
out vec4 colour;
void main() { colour = vec4(shade, 1.0); }
)";

// A context with a few pixels to draw in.
class Screen {
 public:
  Screen() {
    // Compute shaders are in 3.1.
    if (context_.create(3, 1) != Status::ok && context_.create() != Status::ok) give_up("no EGL", context_.error());
    must(gles3::load_api(api, egl::load_proc), "the driver lacks functions of OpenGL ES 3.0");
    must(gles3::query_caps(api, caps), "query_caps");
    unsigned texture = 0, framebuffer = 0;
    api.GenTextures(1, &texture);
    api.BindTexture(kTexture2d, texture);
    api.TexImage2D(kTexture2d, 0, kRgba8, kSide, kSide, 0, kRgba, kUnsignedByte, nullptr);
    api.BindTexture(kTexture2d, 0);
    api.GenFramebuffers(1, &framebuffer);
    api.BindFramebuffer(kFramebuffer, framebuffer);
    api.FramebufferTexture2D(kFramebuffer, kColour0, kTexture2d, texture, 0);
    if (api.CheckFramebufferStatus(kFramebuffer) != kComplete) give_up("the driver", "its framebuffer is not complete");
    api.Viewport(0, 0, kSide, kSide);
  }
  std::string text(unsigned name) const {
    const auto* const found = reinterpret_cast<const char*>(api.GetString(name));
    return quoted(found != nullptr ? found : "");
  }

  gles3::Api api;
  gles3::Caps caps;

 private:
  egl::HeadlessContext context_;
};

struct RowKind {
  gles3::Deformer deformer;
  std::uint8_t features;
  const char* name;
};
constexpr std::uint8_t kWithMotion = gles3::kNormals | gles3::kMotion;
constexpr RowKind kKinds[] = {{gles3::Deformer::ssd, 0, "ssd/p"},
                              {gles3::Deformer::ssd, gles3::kNormals, "ssd/pn"},
                              {gles3::Deformer::ssd, kWithMotion, "ssd/pnm"},
                              {gles3::Deformer::as, 0, "as/p"},
                              {gles3::Deformer::as, gles3::kNormals, "as/pn"},
                              {gles3::Deformer::as, kWithMotion, "as/pnm"}};

double ns_per_vertex(const Screen& screen, const Newt& newt, SkinningPath path, const RowKind& kind) {
  const gles3::Api& api = screen.api;
  std::array<char, 1024> log = {};
  gles3::ProgramSet programs;
  programs.roles[0] = {kVertexText, kFragmentText, {}};
  programs.log = log;
  gles3::SkinnerOptions options;
  options.path = path;
  options.deformer = kind.deformer;
  options.instances = kCharacters;
  options.features = kind.features;
  options.motion = (kind.features & gles3::kMotion) != 0;
  tools::AlignedBytes memory(gles3::skinner_bytes(newt.body, options));
  gles3::Skinner skinner;
  const Status created =
      gles3::create_skinner(api, screen.caps, newt.body, options, programs, {memory.data(), memory.size()}, skinner);
  if (created != Status::ok) give_up(kind.name, std::string(to_string(created)) + " " + log.data());
  std::vector<SoaTransform> pose(newt.skeleton.soa_size());
  std::vector<Affine> joints(newt.skeleton.joint_count);
  for (std::uint32_t i = 0; i < kCharacters; ++i) {
    must(sample(newt.skeleton, newt.walk, newt.walk.duration_s * float(i) / kCharacters, pose), "sample");
    must(local_to_model(newt.skeleton, pose, joints), "local_to_model");
    must(gles3::pose(skinner, i, joints), "pose");
  }
  const auto frames = [&](std::uint64_t count) {
    const Clock::time_point start = Clock::now();
    for (std::uint64_t i = 0; i < count; ++i) {
      must(gles3::update(api, skinner, programs, kCharacters), "update");
      const gles3::Program& program = gles3::program_of(skinner, programs, 0);
      api.UseProgram(program.id);
      must(gles3::draw(api, skinner, programs, program, 0, kCharacters), "draw");
    }
    std::uint8_t pixel[4];
    api.ReadPixels(0, 0, 1, 1, kRgba, kUnsignedByte, pixel);
    return seconds_since(start);
  };
  frames(2);  // drivers compile at the first draw
  const double frame_s = median_seconds(kBatch_s, kBatches, frames);
  if (const unsigned error = api.GetError(); error != 0)
    give_up(kind.name, "the driver reports the GL error " + std::to_string(error));
  gles3::destroy(api, skinner);
  gles3::destroy(api, programs);
  return 1e9 * frame_s / (double(kCharacters) * newt.body.geometry.slot_count);
}

// What SelfTestOptions::user points to.
struct Trying {
  const char* file;
  std::uint32_t crashed;
};

void about_to_try(void* user, SkinningPath path) {
  const Trying& trying = *static_cast<const Trying*>(user);
  std::ofstream(trying.file) << (trying.crashed | gles3::bit_of(path));
}

double now_s(void*) {
  return seconds_since({});
}

std::string row_of(const gles3::SelfTest& test, std::uint32_t index) {
  const gles3::PathResult& result = test.paths[index];
  return "  {\"path\": " + quoted(to_string(static_cast<SkinningPath>(index))) +
         ", \"verdict\": " + quoted(to_string(result.verdict)) +
         ", \"position_error\": " + number(double(result.position_error)) +
         ", \"normal_error\": " + number(double(result.normal_error)) +
         ", \"ns\": " + number(double(result.ns_per_vertex)) +
         ", \"ns_per_pass\": " + number(double(result.ns_per_pass)) + "}";
}

}  // namespace

void self_test(const char* file) {
  Trying trying{file, 0};
  std::ifstream(file) >> trying.crashed;
  const Screen screen;
  gles3::SelfTestOptions options;
  options.crashed = trying.crashed & ((1u << gles3::kPathCount) - 1);
  options.seconds = now_s;
  options.about_to_try = about_to_try;
  options.user = &trying;
  tools::AlignedBytes memory(gles3::self_test_bytes(options));
  gles3::SelfTest test;
  must(gles3::self_test(screen.api, screen.caps, options, {memory.data(), memory.size()}, test), "self_test");
  std::printf("{\"renderer\": %s, \"version\": %s, \"paths\": [\n", screen.text(kRenderer).c_str(),
              screen.text(kVersion).c_str());
  for (std::uint32_t i = 0; i < gles3::kPathCount; ++i)
    std::printf("%s%s\n", row_of(test, i).c_str(), i + 1 < gles3::kPathCount ? "," : "");
  std::printf("], \"choice\": [");
  const char* comma = "";
  for (const std::uint32_t passes : {1u, 3u})
    for (const std::uint32_t characters : {1u, gles3::kManyCharacters}) {
      SkinningPath path = SkinningPath::cpu;
      const bool any = choose(test, {passes, characters, 44}, path) == Status::ok;
      std::printf("%s\n  {\"passes\": %u, \"characters\": %u, \"path\": %s}", comma, unsigned(passes),
                  unsigned(characters), quoted(any ? to_string(path) : "none").c_str());
      comma = ",";
    }
  std::printf("\n]}\n");
}

void bench_gpu(const Newt& newt, const std::string& name) {
  std::uint32_t path = 0;
  while (path < gles3::kPathCount && name != to_string(static_cast<SkinningPath>(path))) ++path;
  if (path == gles3::kPathCount) give_up(name, "there is no such path");
  const Screen screen;
  std::string rows;
  for (const RowKind& kind : kKinds)
    rows += (rows.empty() ? "\n  {\"name\": " : ",\n  {\"name\": ") + quoted(kind.name) +
            ", \"ns\": " + number(ns_per_vertex(screen, newt, static_cast<SkinningPath>(path), kind)) + "}";
  std::printf("{\"rows\": [%s\n]}\n", rows.c_str());
}

}  // namespace marrow::phone
