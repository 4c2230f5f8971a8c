// Once a context: the skinning text and a role's own text → a linked program.
#include "core/check.h"
#include "core/zone.h"
#include "gles3/compile.h"
#include "gles3/label.h"
#include "gles3/mesh/morph.h"
#include "gles3/palettes.h"
#include "gles3/self_test/self_test_key.h"

namespace marrow::embedded {
extern const unsigned char shader_skin[];
}

namespace marrow::gles3 {
namespace {

// Text in a fixed buffer; what does not fit would be a programming error here, so it is cut.
struct Text {
  char chars[704];
  std::size_t size = 0;

  Text() { chars[0] = '\0'; }
  void add(const char* text) {
    for (; *text != '\0' && size + 1 < sizeof(chars); ++text) chars[size++] = *text;
    chars[size] = '\0';
  }
  void define(const char* name, std::uint32_t value) {
    char digits[12];
    std::size_t first = sizeof(digits) - 1;
    digits[first] = '\0';
    do {
      digits[--first] = static_cast<char>('0' + value % 10);
      value /= 10;
    } while (value != 0);
    add("#define ");
    add(name);
    add(" ");
    add(digits + first);
    add("\n");
  }
};

Text preamble(const Api& api, const ProgramKey& key, bool compute) {
  Text text;
  text.add(compute ? "#version 310 es\n" : "#version 300 es\n");
  text.define("MARROW_COMPUTE", compute ? 1 : 0);
  const bool psd = key.deformer == Deformer::psd;
  text.define("MARROW_DEFORMER", static_cast<std::uint32_t>(psd ? Deformer::ssd : key.deformer));
  text.define("MARROW_POSE_SPACE", psd ? 1 : 0);
  text.define("MARROW_INFLUENCES", key.influences);
  text.define("MARROW_NORMAL", (key.features & kNormals) != 0 ? 1 : 0);
  text.define("MARROW_TANGENT", (key.features & kTangents) != 0 ? 1 : 0);
  text.define("MARROW_UV", (key.features & kUvs) != 0 ? 1 : 0);
  text.define("MARROW_COLOUR", (key.features & kColours) != 0 ? 1 : 0);
  text.define("MARROW_MORPH_TARGETS", (key.features & kMorphs) != 0 ? kMorphTargets : 0);
  const bool surface =
      key.deformer == Deformer::as && (key.features & kMorphs) == 0 && (key.features & kSurfaceNormals) != 0;
  text.define("MARROW_SURFACE_NORMALS", surface && (key.features & (kNormals | kTangents)) != 0 ? 1 : 0);
  const Words words = words_read(api, key.influences, surface);
  text.define("MARROW_WORDS", static_cast<std::uint32_t>(compute && words == Words::none ? Words::all : words));
  text.define("MARROW_GPU", static_cast<std::uint32_t>(family_of(api.GetString(kGlRenderer))));
  text.define("MARROW_PALETTES", static_cast<std::uint32_t>(key.palettes));
  text.define("MARROW_PALETTE_JOINTS", kPaletteJoints);
  text.define("MARROW_MOTION", (key.features & kMotion) != 0 ? 1 : 0);
  return text;
}

void put_log(Span<char> log, const char* text) {
  if (log.empty()) return;
  std::size_t i = 0;
  for (; text[i] != '\0' && i + 1 < log.size; ++i) log[i] = text[i];
  log[i] = '\0';
}

// 0 if the text does not compile.
std::uint32_t compile(const Api& api, GlEnum type, const char* const* texts, int count, Span<char> log) {
  const std::uint32_t shader = api.CreateShader(type);
  if (shader == 0) {
    put_log(log, "glCreateShader failed");
    return 0;
  }
  api.ShaderSource(shader, count, texts, nullptr);
  api.CompileShader(shader);
  int compiled = 0;
  api.GetShaderiv(shader, kGlCompileStatus, &compiled);
  if (compiled != 0) return shader;
  if (!log.empty()) api.GetShaderInfoLog(shader, static_cast<int>(log.size), nullptr, log.data);
  api.DeleteShader(shader);
  return 0;
}

// 0 if the shaders do not link.
std::uint32_t link(const Api& api, const std::uint32_t* shaders, std::size_t count, const ShaderTexts& texts,
                   Span<char> log) {
  const std::uint32_t program = api.CreateProgram();
  if (program == 0) {
    put_log(log, "glCreateProgram failed");
    return 0;
  }
  for (std::size_t i = 0; i < count; ++i) api.AttachShader(program, shaders[i]);
  if (!texts.feedback_varyings.empty()) {
    api.TransformFeedbackVaryings(program, static_cast<int>(texts.feedback_varyings.size), texts.feedback_varyings.data,
                                  texts.feedback_mode);
  }
  api.LinkProgram(program);
  int linked = 0;
  api.GetProgramiv(program, kGlLinkStatus, &linked);
  if (linked != 0) return program;
  if (!log.empty()) api.GetProgramInfoLog(program, static_cast<int>(log.size), nullptr, log.data);
  api.DeleteProgram(program);
  return 0;
}

void label_program(const Api& api, const ProgramKey& key, const char* role, std::uint32_t program) {
  constexpr const char* kDeformers[] = {"", ", rigid", ", ssd", ", as", ", psd"};
  constexpr const char* kInfluences[] = {"", ", 5 influences", ", 6 influences", ", 7 influences", ", 8 influences"};
  constexpr const char* kPlaces[] = {"", ", palettes in a texture", ", palettes of a crowd"};
  label(api, kGlProgram, program,
        {"marrow: ", role, kDeformers[static_cast<std::size_t>(key.deformer)], kInfluences[key.influences - 4],
         (key.features & kMorphs) != 0 ? ", morph targets" : "", (key.features & kMotion) != 0 ? ", motion" : "",
         kPlaces[static_cast<std::size_t>(key.palettes)]});
}

}  // namespace

void clear(Span<char> log) {
  put_log(log, "");
}

Words words_read(const Api& api, std::uint32_t influences, bool surface_normals) {
  const GpuFamily family = family_of(api.GetString(kGlRenderer));
  if (surface_normals && influences > 4) {
    const bool unpacking_costs = family == GpuFamily::adreno || family == GpuFamily::mali_t;
    return unpacking_costs && influences <= 6 ? Words::tangents_whole : Words::all_whole;
  }
  return family == GpuFamily::mali_g || family == GpuFamily::nvidia ? Words::all : Words::none;
}

bool reads_joint_pairs(const Api& api, std::uint32_t influences) {
  return influences > 4 && family_of(api.GetString(kGlRenderer)) == GpuFamily::mali_g;
}

void tell_of_vertices(const Api& api, const GpuMesh& mesh, const Program& program) {
  const ProgramState& at = state_of(program);
  if (at.coordinate_scale >= 0) api.Uniform1f(at.coordinate_scale, mesh.coordinate_scale);
  const int bits = 8 * static_cast<int>(mesh.layout.joint_bytes);
  if (at.joint_bits >= 0) api.Uniform2i(at.joint_bits, bits, (1 << bits) - 1);
}

Status compile_program(const Api& api, const ProgramKey& key, const ShaderTexts& texts, std::uint32_t palette_binding,
                       Program& out, Span<char> log) {
  const Text head = preamble(api, key, texts.compute != nullptr);
  const char* const skin = reinterpret_cast<const char*>(embedded::shader_skin);
  struct Stage {
    GlEnum type;
    const char* text;
    bool skins;
  };
  const Stage stages[] = {{kGlVertexShader, texts.vertex, true},
                          {kGlFragmentShader, texts.fragment, false},
                          {kGlComputeShader, texts.compute, true}};
  std::uint32_t shaders[3];
  std::size_t count = 0;
  bool compiled = true;
  for (const Stage& stage : stages) {
    if (stage.text == nullptr || !compiled) continue;
    const char* const parts[] = {head.chars, stage.skins ? skin : "", stage.text};
    shaders[count] = compile(api, stage.type, parts, 3, log);
    compiled = shaders[count] != 0;
    if (compiled) ++count;
  }
  Program made;
  if (compiled) made.id = link(api, shaders, count, texts, log);
  // The program keeps what it needs.
  for (std::size_t i = 0; i < count; ++i) api.DeleteShader(shaders[i]);
  if (made.id == 0) return Status::gl_error;

  ProgramState state;
  state.reads = key.palettes;
  state.motion = (key.features & kMotion) != 0;
  const auto tie = [&](const char* name, std::uint32_t binding) {
    const std::uint32_t block = api.GetUniformBlockIndex(made.id, name);
    if (block != kGlInvalidIndex) api.UniformBlockBinding(made.id, block, binding);
  };
  tie("MarrowPalette", palette_binding);
  if (state.motion) tie("MarrowPreviousPalette", palette_binding + 1);
  const auto find = [&](const char* name) { return api.GetUniformLocation(made.id, name); };
  state.coordinate_scale = find("marrow_coordinate_scale");
  state.joint_bits = find("marrow_joint_bits");
  state.palettes = find("marrow_palettes");
  state.first_row = find("marrow_first_row");
  state.instances = find("marrow_instances");
  state.crowd = find("marrow_crowd");
  state.vertex_layout = find("marrow_vertex_layout");
  state.morph_changes = find("marrow_morph_changes");
  state.morph_targets = find("marrow_morph_targets");
  state.morph_count = find("marrow_morph_count");
  state.morph_shift = find("marrow_morph_shift");
  state.morph_per_row = find("marrow_morph_per_row");
  state.previous_palettes = find("marrow_previous_palettes");
  state.previous_targets = find("marrow_previous_targets");
  state.previous_count = find("marrow_previous_count");
  state.examples = find("marrow_examples");
  state.example_step = find("marrow_example_step");
  state.distances = find("marrow_distances");
  state.distance_row = find("marrow_distance_row");
  state.previous_distances = find("marrow_previous_distances");
  set_state(made, state);
  label_program(api, key, texts.role, made.id);
  out = made;
  return Status::ok;
}

Status create_program(const Api& api, const ProgramKey& key, const ProgramSource& source, std::uint32_t palette_binding,
                      Program& out, Span<char> log) {
  MARROW_ZONE;
  MARROW_REQUIRE(holds(log));
  clear(log);
  MARROW_REQUIRE(source.vertex != nullptr && source.fragment != nullptr);
  MARROW_REQUIRE(key.influences >= 4 && key.influences <= kMaxInfluences);
  MARROW_REQUIRE(key.deformer <= Deformer::psd && key.palettes <= Palettes::crowd);
  MARROW_REQUIRE(holds(source.feedback_varyings));
  const bool crowd = key.palettes == Palettes::crowd;
  MARROW_REQUIRE(!crowd || (in_crowds(key.deformer) && (key.features & kMorphs) == 0));
  return compile_program(api, key, {source.vertex, source.fragment, nullptr, source.feedback_varyings}, palette_binding,
                         out, log);
}

void destroy(const Api& api, Program& program) {
  api.DeleteProgram(program.id);
  program = {};
}

}  // namespace marrow::gles3
