#include "vulkan/recorder.h"
#include "gles3/program.h"

#include <cstring>

namespace marrow::test {
namespace {

template <class Function>
struct Nothing;
template <class Result, class... Arguments>
struct Nothing<Result(Arguments...)> {
  static Result call(Arguments...) { return Result(); }
};

unsigned bound = 0, names = 0;
std::vector<std::string> uniform_names;

void make_names(int count, unsigned* out) {
  for (int i = 0; i < count; ++i) out[i] = ++names;
}

int location_of(unsigned, const char* name) {
  uniform_names.emplace_back(name);
  return static_cast<int>(uniform_names.size()) - 1;
}

void keep(int location, const void* values, std::size_t words) {
  if (location < 0) return;
  std::vector<std::uint32_t>& to = recorder().uniforms[uniform_names[static_cast<std::size_t>(location)]];
  to.resize(words);
  std::memcpy(to.data(), values, 4 * words);
}

void set_uniforms(gles3::Api& api) {
  api.GetUniformLocation = location_of;
  api.Uniform1f = [](int location, float value) { keep(location, &value, 1); };
  api.Uniform1i = [](int location, int value) { keep(location, &value, 1); };
  api.Uniform1iv = [](int location, int count, const int* values) {
    keep(location, values, static_cast<std::size_t>(count));
  };
  api.Uniform4fv = [](int location, int count, const float* values) {
    keep(location, values, 4 * static_cast<std::size_t>(count));
  };
}

void set_buffers(gles3::Api& api) {
  api.GenBuffers = api.GenVertexArrays = api.GenTextures = make_names;
  api.BindBuffer = [](unsigned, unsigned buffer) { bound = buffer; };
  api.BufferData = [](unsigned, std::ptrdiff_t bytes, const void* data, unsigned) {
    std::vector<std::byte>& to = recorder().buffers[bound];
    to.assign(static_cast<std::size_t>(bytes), std::byte{0});
    if (data != nullptr) std::memcpy(to.data(), data, to.size());
  };
  api.BindBufferBase = [](unsigned, unsigned binding, unsigned buffer) {
    if (buffer != 0) recorder().bindings[binding] = buffer;
  };
  api.DispatchCompute = [](unsigned x, unsigned, unsigned) { recorder().groups = x; };
}

void set_texts(gles3::Api& api) {
  api.CreateShader = [](unsigned type) { return type; };  // its name says what it is
  api.ShaderSource = [](unsigned shader, int count, const char* const* texts, const int*) {
    std::string whole;
    for (int i = 0; i < count; ++i) whole += texts[i];
    recorder().texts.emplace_back(shader, whole);
  };
  api.CreateProgram = [] { return 1u; };
  api.GetShaderiv = api.GetProgramiv = [](unsigned, unsigned, int* value) { *value = 1; };
}

}  // namespace

Recorder& recorder() {
  static Recorder one;
  return one;
}

gles3::Api recording_api() {
  gles3::Api api;
#define MARROW_NOTHING(Result, Name, Parameters) api.Name = Nothing<Result Parameters>::call;
  MARROW_GLES3_FUNCTIONS(MARROW_NOTHING)
  MARROW_GLES3_OPTIONAL_FUNCTIONS(MARROW_NOTHING)
#undef MARROW_NOTHING
  set_uniforms(api);
  set_buffers(api);
  set_texts(api);
  return api;
}

std::string name_of(const gles3::ProgramKey& key) {
  constexpr const char* kPlaces[] = {"ubo", "texture", "crowd"};
  constexpr const char* kDeformers[] = {"none", "rigid", "ssd", "as"};
  constexpr std::pair<int, const char*> kFeatures[] = {
      {gles3::kNormals, "n"},      {gles3::kTangents, "t"},     {gles3::kUvs, "u"},
      {gles3::kColours, "c"},      {gles3::kMorphs, "-morphs"}, {gles3::kSurfaceNormals, "-surface"},
      {gles3::kMotion, "-motion"},
  };
  std::string name = std::string(kPlaces[static_cast<std::size_t>(key.palettes)]) + "-" +
                     kDeformers[static_cast<std::size_t>(key.deformer)] + "-" + std::to_string(key.influences) + "-p";
  for (const auto& [feature, letters] : kFeatures)
    if ((key.features & feature) != 0) name += letters;
  return name;
}

}  // namespace marrow::test
