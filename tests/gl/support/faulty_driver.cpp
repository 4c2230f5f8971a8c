#include "gl/support/faulty_driver.h"

#include <type_traits>
#include <utility>

namespace marrow::test {
namespace {

constexpr unsigned kOutOfMemory = 0x0505;
constexpr unsigned kContextLost = 0x0507;

// Counts the call; whether it goes on to the real driver.
bool passes(const char* name) {
  FaultyDriver& d = driver();
  ++d.calls;
  ++d.count[name];
  return !d.is_lost();
}

// Each function of the API as a template argument of its own.
template <auto Member, class Function>
struct Through;
template <auto Member, class Result, class... Arguments>
struct Through<Member, gles3::Entry<Result(Arguments...)>> {
  static inline const char* name = "";
  static Result call(Arguments... arguments) {
    if (!passes(name)) return Result();
    return (driver().real.*Member)(arguments...);
  }
};

// Objects: a name each of `count`, or none after a loss.
template <auto Member>
void generate(int count, unsigned* names) {
  for (int i = 0; i < count; ++i) names[i] = 0;
  if (!passes("Gen")) return;
  (driver().real.*Member)(count, names);
  driver().live += count;
  driver().made += count;
}
template <auto Member>
void remove(int count, const unsigned* names) {
  if (!passes("Delete")) return;
  (driver().real.*Member)(count, names);
  for (int i = 0; i < count; ++i) driver().live -= names[i] != 0;
}
template <auto Member>
void remove_one(unsigned name) {
  if (!passes("Delete")) return;
  (driver().real.*Member)(name);
  driver().live -= name != 0;
}

bool has_room() {
  FaultyDriver& d = driver();
  if (d.full_after < 0 || ++d.allocations <= d.full_after) return true;
  d.error = kOutOfMemory;
  return false;
}

void catch_objects(gles3::Api& api) {
  using gles3::Api;
  api.GenBuffers = generate<&Api::GenBuffers>;
  api.GenFramebuffers = generate<&Api::GenFramebuffers>;
  api.GenTextures = generate<&Api::GenTextures>;
  api.GenVertexArrays = generate<&Api::GenVertexArrays>;
  api.DeleteBuffers = remove<&Api::DeleteBuffers>;
  api.DeleteFramebuffers = remove<&Api::DeleteFramebuffers>;
  api.DeleteTextures = remove<&Api::DeleteTextures>;
  api.DeleteVertexArrays = remove<&Api::DeleteVertexArrays>;
  api.DeleteShader = remove_one<&Api::DeleteShader>;
  api.DeleteProgram = remove_one<&Api::DeleteProgram>;
  api.CreateShader = [](unsigned type) {
    const unsigned name = passes("CreateShader") ? driver().real.CreateShader(type) : 0;
    driver().live += name != 0;
    return name;
  };
  api.CreateProgram = [] {
    const unsigned name = passes("CreateProgram") ? driver().real.CreateProgram() : 0;
    driver().live += name != 0;
    driver().made += name != 0;
    return name;
  };
}

// Told once, then the reset is over.
void catch_resets(gles3::Api& api) {
  api.GetGraphicsResetStatus = [] { return std::exchange(driver().reset, 0u); };
}

void catch_memory(gles3::Api& api) {
  api.GetError = [] {
    if (driver().is_lost()) return kContextLost;
    const unsigned own = driver().error;
    driver().error = 0;
    return own != 0 ? own : driver().real.GetError();
  };
  api.BufferData = [](unsigned target, std::ptrdiff_t bytes, const void* data, unsigned usage) {
    if (!passes("BufferData") || !has_room()) return;
    if (data != nullptr) driver().uploaded_bytes += bytes;
    driver().real.BufferData(target, bytes, data, usage);
  };
  api.BufferSubData = [](unsigned target, std::ptrdiff_t offset, std::ptrdiff_t bytes, const void* data) {
    if (!passes("BufferSubData")) return;
    driver().uploaded_bytes += bytes;
    driver().real.BufferSubData(target, offset, bytes, data);
  };
  api.TexImage2D = [](unsigned target, int level, int internal, int width, int height, int border, unsigned format,
                      unsigned type, const void* texels) {
    if (!passes("TexImage2D") || !has_room()) return;
    driver().real.TexImage2D(target, level, internal, width, height, border, format, type, texels);
  };
  api.TexSubImage2D = [](unsigned target, int level, int x, int y, int width, int height, unsigned format,
                         unsigned type, const void* texels) {
    if (!passes("TexSubImage2D")) return;
    driver().uploaded_bytes += std::ptrdiff_t{16} * width * height;  // of RGBA32F
    driver().real.TexSubImage2D(target, level, x, y, width, height, format, type, texels);
  };
}

}  // namespace

FaultyDriver& driver() {
  static FaultyDriver one;
  return one;
}

void record_labels(gles3::Api& api) {
  api.ObjectLabel = [](unsigned kind, unsigned name, int size, const char* text) {
    if (!passes("ObjectLabel")) return;
    FaultyDriver::Label& label = driver().labels[{kind, name}];
    label.text.assign(text, text + size);
    ++label.count;
    ++driver().label_count;
  };
}

gles3::Api faulty_api(const gles3::Api& real) {
  driver() = {};
  driver().real = real;
  gles3::Api api;
#define MARROW_THROUGH(Result, Name, Parameters)                        \
  Through<&gles3::Api::Name, decltype(gles3::Api::Name)>::name = #Name; \
  if (real.Name != nullptr) api.Name = Through<&gles3::Api::Name, decltype(gles3::Api::Name)>::call;
  MARROW_GLES3_FUNCTIONS(MARROW_THROUGH)
  MARROW_GLES3_OPTIONAL_FUNCTIONS(MARROW_THROUGH)
#undef MARROW_THROUGH
  catch_objects(api);
  catch_memory(api);
  catch_resets(api);
  return api;
}

}  // namespace marrow::test
