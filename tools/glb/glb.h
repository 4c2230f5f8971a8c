// A glTF document and its one buffer in the making, and the GLB container round both.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace marrow::tools {

using Json = nlohmann::ordered_json;

enum class Component { u8 = 5121, u16 = 5123, u32 = 5125, f32 = 5126 };
enum class Target { none = 0, vertices = 34962, indices = 34963 };

struct AccessorType {
  const char* name;  // as glTF writes it
  std::size_t parts;
};
inline constexpr AccessorType kScalar{"SCALAR", 1}, kVec2{"VEC2", 2}, kVec3{"VEC3", 3}, kVec4{"VEC4", 4},
    kMat4{"MAT4", 16};

class Glb {
 public:
  // generator: the program, as "asset" has it.
  explicit Glb(const char* generator);

  // Appends to a list of the document, making it if it is not there yet, and returns the new element's number.
  std::size_t add(const char* list, Json element);

  // Lists an extension as used, once.
  void use_extension(const char* name);

  // An accessor with a buffer view of its own, on a boundary of four bytes. values: of `component`, type.parts an
  // element, one or several a T; elements of vertices must fill four bytes.
  template <class T>
  std::size_t add_accessor(const std::vector<T>& values, Component component, AccessorType type, Target target,
                           bool normalised = false) {
    return add_bytes(values.data(), values.size() * sizeof(T), component, type, target, normalised);
  }
  // Floats with the smallest and largest of each part, where glTF wants them: positions and key times.
  std::size_t add_bounded(const std::vector<float>& values, AccessorType type, Target target);

  // Floats that are zero but in some elements, `at` ascending, with the smallest and largest of each part.
  std::size_t add_sparse(std::size_t count, const std::vector<std::uint32_t>& at, const std::vector<float>& values,
                         AccessorType type);
  // A buffer view on a boundary of four bytes.
  std::size_t add_view(const void* data, std::size_t bytes, Target target);

  // The container. Throws Failure (unsupported) naming `file` above 4 GiB.
  std::string finish(const std::string& file);

  Json json;

 private:
  std::size_t add_bytes(const void* data, std::size_t bytes, Component component, AccessorType type, Target target,
                        bool normalised);
  std::string data_;
};

// A float in the fewest digits that give it back.
Json number(float value);
Json numbers(const std::vector<float>& values);

}  // namespace marrow::tools
