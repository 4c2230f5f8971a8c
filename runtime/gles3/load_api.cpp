// The first step on the GPU: the driver's entry points and what the context can do.
#include "core/check.h"
#include "gles3/gl_constants.h"
#include "marrow/gles3.h"

namespace marrow::gles3 {
namespace {

template <class Function>
bool load_one(Entry<Function>& entry, void* (*load_proc)(const char*), const char* name) {
  entry = reinterpret_cast<Function*>(load_proc(name));
  return entry != nullptr;
}

bool is_digit(unsigned char c) {
  return c >= '0' && c <= '9';
}

// Reads "OpenGL ES 3.1 …" → 31; 0 for anything else. GL_MAJOR_VERSION is no use here: GLES 2 does not know it.
int es_version(const unsigned char* text) {
  const char* prefix = "OpenGL ES ";
  if (text == nullptr) return 0;
  for (; *prefix != '\0'; ++prefix, ++text) {
    if (*text != static_cast<unsigned char>(*prefix)) return 0;
  }
  if (!is_digit(text[0]) || text[1] != '.' || !is_digit(text[2])) return 0;
  return 10 * (text[0] - '0') + (text[2] - '0');
}

// Whether `text`, a list separated by spaces, contains `word`.
bool has_word(const unsigned char* text, const char* word) {
  while (text != nullptr && *text != '\0') {
    std::size_t i = 0;
    while (word[i] != '\0' && text[i] == static_cast<unsigned char>(word[i])) ++i;
    if (word[i] == '\0' && (text[i] == '\0' || text[i] == ' ')) return true;
    while (*text != '\0' && *text != ' ') ++text;
    while (*text == ' ') ++text;
  }
  return false;
}

// Loaders may return something for any name, so the context's version and extensions decide.
void load_extensions(Api& api, void* (*load_proc)(const char*)) {
  const int version = es_version(api.GetString(kGlVersion));
  if (version < 30) return;
  const auto has = [&](const char* name) { return has_word(api.GetString(kGlExtensions), name); };
  auto& label = api.ObjectLabel;
  if (has("GL_KHR_debug")) load_one(label, load_proc, "glObjectLabelKHR");
  if (label == nullptr && version >= 32) load_one(label, load_proc, "glObjectLabel");
  auto& reset = api.GetGraphicsResetStatus;
  if (has("GL_KHR_robustness")) load_one(reset, load_proc, "glGetGraphicsResetStatusKHR");
  if (reset == nullptr && has("GL_EXT_robustness")) load_one(reset, load_proc, "glGetGraphicsResetStatusEXT");
  if (reset == nullptr && version >= 32) load_one(reset, load_proc, "glGetGraphicsResetStatus");
}

}  // namespace

Status load_api(Api& api, void* (*load_proc)(const char* name), const char** missing) {
  MARROW_REQUIRE(load_proc != nullptr);
  Api loaded;
#define MARROW_LOAD(Result, Name, Parameters)          \
  if (!load_one(loaded.Name, load_proc, "gl" #Name)) { \
    if (missing != nullptr) *missing = "gl" #Name;     \
    return Status::unsupported;                        \
  }
  MARROW_GLES3_FUNCTIONS(MARROW_LOAD)
#undef MARROW_LOAD
  load_one(loaded.DispatchCompute, load_proc, "glDispatchCompute");
  load_one(loaded.MemoryBarrier, load_proc, "glMemoryBarrier");
  load_extensions(loaded, load_proc);
  api = loaded;
  return Status::ok;
}

bool context_was_reset(const Api& api) {
  return api.GetGraphicsResetStatus != nullptr && api.GetGraphicsResetStatus() != kGlNoError;
}

Status query_caps(const Api& api, Caps& caps) {
  const int version = es_version(api.GetString(kGlVersion));
  if (version < 30) return Status::unsupported;
  int block = 0;
  int alignment = 0;
  int attributes = 0;
  int texture = 0;
  api.GetIntegerv(kGlMaxUniformBlockSize, &block);
  api.GetIntegerv(kGlUniformBufferOffsetAlignment, &alignment);
  api.GetIntegerv(kGlMaxVertexAttribs, &attributes);
  api.GetIntegerv(kGlMaxTextureSize, &texture);
  if (block <= 0 || alignment <= 0 || attributes <= 0 || texture <= 0) return Status::gl_error;
  caps.uniform_block_bytes = static_cast<std::uint32_t>(block);
  caps.uniform_offset_alignment = static_cast<std::uint32_t>(alignment);
  caps.vertex_attributes = static_cast<std::uint32_t>(attributes);
  caps.texture_size = static_cast<std::uint32_t>(texture);
  caps.compute = version >= 31 && api.DispatchCompute != nullptr && api.MemoryBarrier != nullptr;
  return Status::ok;
}

}  // namespace marrow::gles3
