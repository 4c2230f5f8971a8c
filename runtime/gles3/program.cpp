// Once a context: the skinning text and a role's own text → a linked program.
#include "gles3/gl_constants.h"
#include "marrow/gles3.h"

namespace marrow::embedded {
extern const unsigned char shader_skin[];
}

namespace marrow::gles3 {
namespace {

// Text in a fixed buffer; what does not fit would be a programming error here, so it is cut.
struct Text {
  char chars[512];
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

Text preamble(const ProgramKey& key) {
  Text text;
  text.add("#version 300 es\n");
  text.define("MARROW_DEFORMER", static_cast<std::uint32_t>(key.deformer));
  text.define("MARROW_INFLUENCES", key.influences);
  text.define("MARROW_NORMAL", (key.features & kNormals) != 0 ? 1 : 0);
  text.define("MARROW_TANGENT", (key.features & kTangents) != 0 ? 1 : 0);
  text.define("MARROW_UV", (key.features & kUvs) != 0 ? 1 : 0);
  text.define("MARROW_COLOUR", (key.features & kColours) != 0 ? 1 : 0);
  text.define("MARROW_MORPH_TARGETS", (key.features & kMorphs) != 0 ? kMorphTargets : 0);
  const bool can = key.deformer == Deformer::as && key.influences == 4 && (key.features & kMorphs) == 0;
  text.define("MARROW_SURFACE_NORMALS", can && (key.features & kSurfaceNormals) != 0 ? 1 : 0);
  text.define("MARROW_PALETTE_JOINTS", kPaletteJoints);
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
std::uint32_t link(const Api& api, std::uint32_t vertex, std::uint32_t fragment, const ProgramSource& source,
                   Span<char> log) {
  const std::uint32_t program = api.CreateProgram();
  if (program == 0) {
    put_log(log, "glCreateProgram failed");
    return 0;
  }
  api.AttachShader(program, vertex);
  api.AttachShader(program, fragment);
  if (!source.feedback_varyings.empty()) {
    api.TransformFeedbackVaryings(program, static_cast<int>(source.feedback_varyings.size),
                                  source.feedback_varyings.data, kGlInterleavedAttribs);
  }
  api.LinkProgram(program);
  int linked = 0;
  api.GetProgramiv(program, kGlLinkStatus, &linked);
  if (linked != 0) return program;
  if (!log.empty()) api.GetProgramInfoLog(program, static_cast<int>(log.size), nullptr, log.data);
  api.DeleteProgram(program);
  return 0;
}

}  // namespace

Status build_program(const Api& api, const ProgramKey& key, const ProgramSource& source, std::uint32_t palette_binding,
                     Program& out, Span<char> log) {
  put_log(log, "");
  if (source.vertex == nullptr || source.fragment == nullptr) return Status::bad_argument;
  if (key.influences != 4 && key.influences != 8) return Status::bad_argument;
  const Text head = preamble(key);
  const char* skin = reinterpret_cast<const char*>(embedded::shader_skin);
  const char* vertex_texts[] = {head.chars, skin, source.vertex};
  const char* fragment_texts[] = {head.chars, source.fragment};

  const std::uint32_t vertex = compile(api, kGlVertexShader, vertex_texts, 3, log);
  if (vertex == 0) return Status::gl_error;
  const std::uint32_t fragment = compile(api, kGlFragmentShader, fragment_texts, 2, log);
  Program made;
  if (fragment != 0) made.id = link(api, vertex, fragment, source, log);
  // The program keeps what it needs.
  api.DeleteShader(vertex);
  if (fragment != 0) api.DeleteShader(fragment);
  if (made.id == 0) return Status::gl_error;

  const std::uint32_t block = api.GetUniformBlockIndex(made.id, "MarrowPalette");
  if (block != kGlInvalidIndex) api.UniformBlockBinding(made.id, block, palette_binding);
  made.coordinate_scale = api.GetUniformLocation(made.id, "marrow_coordinate_scale");
  made.morph_changes = api.GetUniformLocation(made.id, "marrow_morph_changes");
  made.morph_targets = api.GetUniformLocation(made.id, "marrow_morph_targets");
  made.morph_count = api.GetUniformLocation(made.id, "marrow_morph_count");
  made.morph_shift = api.GetUniformLocation(made.id, "marrow_morph_shift");
  made.morph_per_row = api.GetUniformLocation(made.id, "marrow_morph_per_row");
  out = made;
  return Status::ok;
}

void destroy(const Api& api, Program& program) {
  api.DeleteProgram(program.id);
  program = {};
}

}  // namespace marrow::gles3
