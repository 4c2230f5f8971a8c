// Compiles every program of marrow::gles3 on the driver at hand, and prints what the driver's compiler says of each.
//
// Standard output: a line `program NAME` each, then the driver's messages about it as they come. NAME is
// path/deformer/influences/attributes/pass, as tools/gpu_cost.sh prints it. What the driver cannot do is left out.
// usage: marrow_gpu_cost 3.0|3.1 [PATTERN]     the OpenGL ES context, 3.1 for compute shaders; what names must fit
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <regex>
#include <string>

#include "gles3/crowd/crowd.h"
#include "gles3/program.h"
#include "gles3/skinned.h"
#include "marrow/egl.h"
#include "marrow/gles3_crowd.h"
#include "marrow/gles3_skinner.h"

namespace marrow::embedded {
extern const unsigned char shader_surface_vert[], shader_depth_vert[], shader_depth_frag[];
}

namespace marrow::gles3 {
namespace {

constexpr unsigned kDebugOutput = 0x92E0, kDebugSynchronous = 0x8242;

// What surface.vert does not hand on, and a game's vertex text does: goes before its main(), and to the end of that.
constexpr const char* kBefore = R"(#if MARROW_TANGENT
out vec4 tangent_scene;
#endif
#if MARROW_MOTION
out vec3 previous_scene;
#endif
)";
constexpr const char* kAtEnd = R"(#if MARROW_TANGENT
  tangent_scene = v.tangent;
#endif
#if MARROW_MOTION
  previous_scene = v.previous_position;
#endif
}
)";

// Reads all that surface.vert may write, and nothing else: the vertex stage alone is looked at.
constexpr const char* kFragment = R"(precision highp float;
in vec3 position_scene;
#if MARROW_NORMAL
in vec3 normal_scene;
#endif
#if MARROW_TANGENT
in vec4 tangent_scene;
#endif
#if MARROW_MOTION
in vec3 previous_scene;
#endif
#if MARROW_PALETTES == 2
in vec4 vertex_colour;
#endif
out vec4 colour;
void main() {
  colour = vec4(position_scene, 1.0);
#if MARROW_NORMAL
  colour.xyz += normal_scene;
#endif
#if MARROW_TANGENT
  colour += tangent_scene;
#endif
#if MARROW_MOTION
  colour.xyz += previous_scene;
#endif
#if MARROW_PALETTES == 2
  colour += vertex_colour;
#endif
}
)";

struct Attributes {
  const char* name;
  int features;
  bool as_only = false;
};
constexpr Attributes kAttributes[] = {
    {"p", 0},
    {"pn", kNormals},
    {"pnt", kNormals | kTangents},
    {"pn+motion", kNormals | kMotion},
    {"pn-surface", kNormals | kSurfaceNormals, true},
    {"pnt-surface", kNormals | kTangents | kSurfaceNormals, true},
};

[[noreturn]] void give_up(const char* what, const char* why) {
  std::fprintf(stderr, "marrow_gpu_cost: %s: %s\n", what, why);
  std::exit(2);
}

const char* text(const unsigned char* embedded) {
  return reinterpret_cast<const char*>(embedded);
}

void on_message(unsigned, unsigned, unsigned, unsigned, int, const char* message, const void*) {
  std::printf("%s\n", message);
}

void listen() {
  using Callback = void (*)(unsigned, unsigned, unsigned, unsigned, int, const char*, const void*);
  auto* set = reinterpret_cast<void (*)(Callback, const void*)>(egl::load_proc("glDebugMessageCallbackKHR"));
  auto* enable = reinterpret_cast<void (*)(unsigned)>(egl::load_proc("glEnable"));
  if (set == nullptr || enable == nullptr) give_up("the driver", "it has no GL_KHR_debug");
  enable(kDebugOutput);
  enable(kDebugSynchronous);
  set(on_message, nullptr);
}

class Costs {
 public:
  Costs(const Api& api, const Caps& caps, const char* pattern)
      : api_(api), caps_(caps), wanted_(pattern, std::regex::extended) {
    const std::string surface = text(embedded::shader_surface_vert);
    surface_ = kBefore + surface.substr(0, surface.rfind('}')) + kAtEnd;
  }

  void all() {
    for (const Attributes& attributes : kAttributes) {
      if (!attributes.as_only) draw("skinned", "none", {Deformer::none, 4}, attributes);
      of_deformer("rigid", Deformer::rigid, 4, attributes);
      for (const auto influences : {std::uint8_t{4}, std::uint8_t{5}, std::uint8_t{6}, std::uint8_t{8}}) {
        // What motion and positions alone cost lies between their figures with four influences and with eight.
        const bool between = influences == 5 || influences == 6;
        if (between && (attributes.features == 0 || (attributes.features & kMotion) != 0)) continue;
        of_deformer("ssd", Deformer::ssd, influences, attributes);
        of_deformer("as", Deformer::as, influences, attributes);
        of_deformer("psd", Deformer::psd, influences, attributes);
      }
    }
    Program program;
    if (begin("crowd/none/0/blend")) end(create_crowd_program(api_, program, log_), program);
  }

 private:
  void of_deformer(const char* name, Deformer deformer, std::uint8_t influences, const Attributes& attributes) {
    if (attributes.as_only && deformer != Deformer::as) return;
    const bool psd = deformer == Deformer::psd;  // SSD and a loop: one row of each path says what that adds
    if (psd && attributes.features != kNormals) return;
    for (const int morphs : {0, int{kMorphs}}) {
      if (psd && morphs != 0) continue;
      // Their cost is the same beside other attributes, and with five or six influences.
      if (morphs != 0 && (attributes.features != kNormals || influences == 5 || influences == 6)) continue;
      const ProgramKey key{deformer, influences, static_cast<std::uint8_t>(morphs)};
      draw("ubo", name, key, attributes);
      draw("texture", name, {deformer, influences, key.features, Palettes::texture}, attributes);
      if (morphs == 0 && !psd) draw("crowd", name, {deformer, influences, 0, Palettes::crowd}, attributes);
      if ((attributes.features & kMotion) != 0) continue;  // skinned ahead, the frame before is there
      preskin("feedback", Preskin::feedback, name, key, attributes);
      if (caps_.compute) preskin("compute", Preskin::compute, name, key, attributes);
    }
  }

  // Both passes; that for depth reads nothing but positions.
  void draw(const char* path, const char* deformer, ProgramKey key, const Attributes& attributes) {
    const bool morphs = (key.features & kMorphs) != 0;
    key.features = static_cast<std::uint8_t>(key.features | attributes.features);
    Program program;
    if (begin(name(path, deformer, key, attributes, morphs) + "/colour"))
      end(create_program(api_, key, {surface_.c_str(), kFragment, {}}, 0, program, log_), program);
    const ProgramSource depth{text(embedded::shader_depth_vert), text(embedded::shader_depth_frag), {}};
    if (attributes.features == 0 && begin(name(path, deformer, key, attributes, morphs) + "/depth"))
      end(create_program(api_, key, depth, 0, program, log_), program);
  }

  void preskin(const char* path, Preskin method, const char* deformer, ProgramKey key, const Attributes& attributes) {
    const bool morphs = (key.features & kMorphs) != 0;
    key.features = static_cast<std::uint8_t>(key.features | attributes.features);
    Program program;
    if (begin(name(path, deformer, key, attributes, morphs) + "/skin"))
      end(create_preskin(api_, caps_, key, method, 0, program, log_), program);
  }

  static std::string name(const char* path, const char* deformer, const ProgramKey& key, const Attributes& attributes,
                          bool morphs) {
    const int influences = key.deformer == Deformer::none ? 0 : key.deformer == Deformer::rigid ? 1 : key.influences;
    return std::string(path) + "/" + deformer + "/" + std::to_string(influences) + "/" + attributes.name +
           (morphs ? "+morphs" : "");
  }

  // Whether the program is wanted.
  bool begin(const std::string& name) {
    name_ = name;
    const bool fits = std::regex_search(name, wanted_);
    if (fits) std::printf("program %s\n", name.c_str());
    return fits;
  }
  void end(Status status, Program& program) {
    if (status != Status::ok) give_up(name_.c_str(), chars_);
    destroy(api_, program);
  }

  const Api& api_;
  const Caps& caps_;
  std::regex wanted_;
  std::string surface_, name_;
  char chars_[4096] = {};
  Span<char> log_{chars_, sizeof(chars_)};
};

int run(bool compute, const char* pattern) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // some drivers write to stderr
  egl::HeadlessContext context;
  if (context.create(3, compute ? 1 : 0) != Status::ok) give_up("no context", context.error());
  Api api;
  Caps caps;
  if (load_api(api, egl::load_proc) != Status::ok || query_caps(api, caps) != Status::ok)
    give_up("the driver", "it is none of OpenGL ES 3.0");
  for (const unsigned what : {0x1F01u, 0x1F02u})  // renderer, version
    std::printf("driver %s\n", reinterpret_cast<const char*>(api.GetString(what)));
  listen();
  api.ObjectLabel = nullptr;
  Costs(api, caps, pattern).all();
  return 0;
}

}  // namespace
}  // namespace marrow::gles3

int main(int count, char** arguments) {
  return marrow::gles3::run(count > 1 && std::strcmp(arguments[1], "3.1") == 0, count > 2 ? arguments[2] : ".");
}
