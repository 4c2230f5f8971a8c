#include "gl/misuse/paper_driver.h"

#include <cstring>
#include <map>
#include <string>

#include "gles3/gl_constants.h"

namespace marrow::test {
namespace {

std::size_t calls = 0;

template <class Function>
struct Nothing;
template <class Result, class... Arguments>
struct Nothing<Result(Arguments...)> {
  static Result call(Arguments...) {
    ++calls;
    return Result();
  }
};

volatile unsigned read_so_far = 0;

void read(const void* data, std::size_t bytes) {
  ++calls;
  unsigned sum = 0;
  for (std::size_t i = 0; data != nullptr && i < bytes; ++i) sum += static_cast<const unsigned char*>(data)[i];
  read_so_far = read_so_far + sum;
}

// Of textures with four channels, as all are.
std::size_t texel_bytes(int width, int height, unsigned type) {
  const std::size_t channel = type == gles3::kGlShort ? 2 : type == gles3::kGlUnsignedByte ? 1 : 4;
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4 * channel;
}

void give_names(int count, unsigned* names) {
  ++calls;
  for (int i = 0; i < count; ++i) names[i] = static_cast<unsigned>(i + 1);
}

void give_integers(unsigned name, int* values) {
  ++calls;
  const bool four = name == gles3::kGlViewport || name == gles3::kGlColorWritemask;
  for (int i = 0; i < (four ? 4 : 1); ++i) values[i] = name == gles3::kGlUniformBufferOffsetAlignment ? 256 : 16384;
}

void set_reading(gles3::Api& api) {
  api.BufferData = [](unsigned, std::ptrdiff_t bytes, const void* data, unsigned) {
    read(data, static_cast<std::size_t>(bytes));
  };
  api.BufferSubData = [](unsigned, std::ptrdiff_t, std::ptrdiff_t bytes, const void* data) {
    read(data, static_cast<std::size_t>(bytes));
  };
  api.TexImage2D = [](unsigned, int, int, int width, int height, int, unsigned, unsigned type, const void* texels) {
    read(texels, texel_bytes(width, height, type));
  };
  api.TexSubImage2D = [](unsigned, int, int, int, int width, int height, unsigned, unsigned type, const void* texels) {
    read(texels, texel_bytes(width, height, type));
  };
  api.ReadPixels = [](int, int, int width, int height, unsigned, unsigned type, void* out) {
    std::memset(out, 0, texel_bytes(width, height, type));
  };
  api.ShaderSource = [](unsigned, int count, const char* const* texts, const int* lengths) {
    for (int i = 0; i < count; ++i)
      read(texts[i],
           lengths == nullptr || lengths[i] < 0 ? std::strlen(texts[i]) : static_cast<std::size_t>(lengths[i]));
  };
  api.TransformFeedbackVaryings = [](unsigned, int count, const char* const* names, unsigned) {
    for (int i = 0; i < count; ++i) read(names[i], std::strlen(names[i]));
  };
  api.Uniform1iv = [](int, int count, const int* values) { read(values, static_cast<std::size_t>(count) * 4); };
  api.Uniform1fv = [](int, int count, const float* values) { read(values, static_cast<std::size_t>(count) * 4); };
  api.Uniform4fv = [](int, int count, const float* values) { read(values, static_cast<std::size_t>(count) * 16); };
}

void set_giving(gles3::Api& api) {
  api.GetString = [](unsigned) {
    ++calls;
    return reinterpret_cast<const unsigned char*>("OpenGL ES 3.1 of paper");
  };
  api.GetIntegerv = give_integers;
  api.GenBuffers = api.GenVertexArrays = api.GenTextures = api.GenFramebuffers = give_names;
  api.CreateShader = [](unsigned) { return static_cast<unsigned>(++calls); };
  api.CreateProgram = [] { return static_cast<unsigned>(++calls); };
  api.GetShaderiv = [](unsigned, unsigned, int* value) { *value = 1; };
  api.GetProgramiv = [](unsigned, unsigned, int* value) { *value = 1; };
  api.CheckFramebufferStatus = [](unsigned) { return static_cast<unsigned>(gles3::kGlFramebufferComplete); };
}

}  // namespace

const std::size_t& paper_calls() {
  return calls;
}

gles3::Api paper_api() {
  gles3::Api api;
#define MARROW_NOTHING(Result, Name, Parameters) api.Name = Nothing<Result Parameters>::call;
  MARROW_GLES3_FUNCTIONS(MARROW_NOTHING)
  MARROW_GLES3_OPTIONAL_FUNCTIONS(MARROW_NOTHING)
#undef MARROW_NOTHING
  set_reading(api);
  set_giving(api);
  return api;
}

void* paper_proc(const char* name) {
  static const std::map<std::string, void*> all = [] {
    std::map<std::string, void*> out;
    const gles3::Api api = paper_api();
#define MARROW_NAMED(Result, Name, Parameters) out["gl" #Name] = reinterpret_cast<void*>(api.Name.function);
    MARROW_GLES3_FUNCTIONS(MARROW_NAMED)
    MARROW_GLES3_OPTIONAL_FUNCTIONS(MARROW_NAMED)
#undef MARROW_NAMED
    return out;
  }();
  const auto found = all.find(name);
  return found == all.end() ? nullptr : found->second;
}

}  // namespace marrow::test
