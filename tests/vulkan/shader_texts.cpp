// Writes every distinct text of marrow::gles3 to a folder, as a driver gets it: for tools/check/spirv.sh.
//
// usage: marrow_shader_texts FOLDER     files are called WAY-PALETTES-DEFORMER-INFLUENCES-ATTRIBUTES.vert, .frag, .comp
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>
#include <string>

#include "gles3/crowd/crowd.h"
#include "gles3/program.h"
#include "gles3/skinned.h"
#include "marrow/gles3_crowd.h"
#include "marrow/gles3_skinner.h"
#include "vulkan/recorder.h"

namespace marrow::embedded {
extern const unsigned char shader_self_test_vert[], shader_self_test_frag[];
}

namespace marrow::test {
namespace {

using gles3::Deformer;
using gles3::Palettes;

// All that a game's texts may ask of the skinning text, handed on.
constexpr const char* kVertex = R"(
uniform mat4 clip_from_model;
out vec3 position;
out vec3 previous_position;
#if MARROW_NORMAL
out vec3 normal;
#endif
#if MARROW_TANGENT
out vec4 tangent;
#endif
#if MARROW_UV
out vec2 uv;
#endif
out vec4 vertex_colour;
void main() {
  MarrowVertex v = marrow_skin();
  position = v.position;
  previous_position = v.previous_position;
#if MARROW_NORMAL
  normal = v.normal;
#endif
#if MARROW_TANGENT
  tangent = v.tangent;
#endif
#if MARROW_UV
  uv = in_uv;
#endif
  vertex_colour = marrow_instance_colour();
#if MARROW_COLOUR
  vertex_colour *= in_colour;
#endif
  gl_Position = clip_from_model * vec4(v.position, 1.0);
}
)";
constexpr const char* kFragment = R"(precision highp float;
in vec3 position;
in vec3 previous_position;
#if MARROW_NORMAL
in vec3 normal;
#endif
#if MARROW_TANGENT
in vec4 tangent;
#endif
#if MARROW_UV
in vec2 uv;
#endif
in vec4 vertex_colour;
out vec4 colour;
void main() {
  colour = vertex_colour + vec4(position - previous_position, 0.0);
#if MARROW_NORMAL
  colour.xyz += normal;
#endif
#if MARROW_TANGENT
  colour += tangent;
#endif
#if MARROW_UV
  colour.xy += uv;
#endif
}
)";

constexpr int kAttributes[] = {0, gles3::kNormals, gles3::kNormals | gles3::kTangents,
                               gles3::kNormals | gles3::kTangents | gles3::kUvs | gles3::kColours};

const char* text(const unsigned char* embedded) {
  return reinterpret_cast<const char*>(embedded);
}

class Texts {
 public:
  explicit Texts(const char* folder) : folder_(folder) {}

  void all() {
    for (const auto deformer : {Deformer::none, Deformer::rigid, Deformer::ssd, Deformer::as})
      for (std::uint8_t influences = 4; influences <= kMaxInfluences; ++influences)
        for (const auto palettes : {Palettes::uniform_block, Palettes::texture, Palettes::crowd})
          of_features({deformer, influences, 0, palettes});
    gles3::Program program;
    write("blend", gles3::create_crowd_program(api_, program));
    std::printf("%zu texts\n", seen_.size());
  }

 private:
  void of_features(gles3::ProgramKey key) {
    for (const int attributes : kAttributes)
      for (const int morphs : {0, int{gles3::kMorphs}})
        for (const int surface : {0, int{gles3::kSurfaceNormals}})
          for (const int motion : {0, int{gles3::kMotion}}) {
            key.features = static_cast<std::uint8_t>(attributes | morphs | surface | motion);
            if (is_program(key)) of_key(key);
          }
  }

  // What create_program() takes, and what differs from programs without the feature.
  static bool is_program(const gles3::ProgramKey& key) {
    if ((key.features & gles3::kMorphs) != 0 && (key.palettes == Palettes::crowd || key.deformer == Deformer::none))
      return false;
    if (key.deformer == Deformer::none && (key.palettes != Palettes::uniform_block || key.influences != 4))
      return false;
    return (key.features & gles3::kSurfaceNormals) == 0 ||
           (key.deformer == Deformer::as && (key.influences > 4 || (key.features & gles3::kNormals) != 0) &&
            (key.features & gles3::kMorphs) == 0);
  }

  void of_key(const gles3::ProgramKey& key) {
    const std::string name = name_of(key);
    gles3::Program program;
    write("draw-" + name, gles3::create_program(api_, key, {kVertex, kFragment}, 0, program));
    if ((key.features & (gles3::kMotion | gles3::kUvs)) != 0) return;
    const gles3::ProgramSource probe{text(embedded::shader_self_test_vert), text(embedded::shader_self_test_frag)};
    write("probe-" + name, gles3::create_program(api_, key, probe, 0, program));
    if (key.deformer == Deformer::none || key.palettes == Palettes::crowd) return;
    gles3::Caps caps;
    caps.compute = true;
    for (const auto& [way, method] :
         {std::pair{"feedback-", gles3::Preskin::feedback}, std::pair{"compute-", gles3::Preskin::compute}})
      write(way + name, gles3::create_preskin(api_, caps, key, method, 0, program));
  }

  // What was compiled since the last call, but for texts that another name has.
  void write(const std::string& name, Status status) {
    if (status != Status::ok) give_up(name);
    for (const auto& [type, whole] : recorder().texts) {
      const char* const ending = type == 0x8B31 ? ".vert" : type == 0x8B30 ? ".frag" : ".comp";
      // A text that asks for nothing is the same whatever is defined before it.
      const std::size_t from = whole.find("#if") == std::string::npos ? whole.rfind("#define") : 0;
      if (!seen_.insert(ending + whole.substr(from)).second) continue;
      std::ofstream file(folder_ + "/" + name + ending, std::ios::binary);
      if (!(file << whole).flush()) give_up(name);
    }
    recorder().texts.clear();
  }

  [[noreturn]] static void give_up(const std::string& name) {
    std::fprintf(stderr, "marrow_shader_texts: %s: cannot be built or written\n", name.c_str());
    std::exit(2);
  }

  std::string folder_;
  gles3::Api api_ = recording_api();
  std::set<std::string> seen_;
};

}  // namespace
}  // namespace marrow::test

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: marrow_shader_texts FOLDER\n");
    return 1;
  }
  marrow::test::Texts(arguments[1]).all();
  return 0;
}
