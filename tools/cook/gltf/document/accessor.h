// Typed, bounds-checked reading of accessors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cook/gltf/document/buffers.h"
#include "cook/gltf/document/findings.h"
#include "cook/gltf/document/json.h"

namespace marrow::cook::gltf {

enum class Component : std::uint16_t { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

std::size_t size_of(Component component);

enum class Shape : std::uint8_t { scalar, vec2, vec3, vec4, mat2, mat3, mat4, unknown };

// How an element's components lie, in bytes.
struct Packing {
  std::size_t rows, columns, column_stride;
  std::size_t size;  // from one to the next where nothing lies between
  std::size_t used;  // to the last component's end
};
Packing packing_of(Shape shape, Component component);

// Where an accessor's elements lie. Everything in it has been checked against the bytes that are there.
struct Accessor {
  Component component = Component::f32;
  Shape shape = Shape::unknown;
  bool normalised = false;
  std::uint64_t count = 0;          // 0: without data
  int view = -1;                    // index of the base data's buffer view
  std::uint64_t offset = 0;         // in the view
  const std::byte* base = nullptr;  // nullptr: zeros
  std::size_t stride = 0;
  std::uint64_t sparse_count = 0;
  Component sparse_component = Component::u16;
  const std::byte* sparse_indices = nullptr;  // strictly increasing, each below `count`
  const std::byte* sparse_values = nullptr;
  bool has_bounds = false;       // both min and max are given
  std::vector<double> min, max;  // as in the file: of the raw, not of the normalised values

  std::size_t components() const;  // 1 to 16
  bool has_data() const { return base != nullptr || sparse_values != nullptr; }
};

// One entry an accessor of the document. Checks types, alignment, strides, lengths, sparse indices and, where there
// are bytes, that the declared bounds hold.
std::vector<Accessor> build_accessors(const Json& root, const Buffers& buffers, Report& report);

// Reads elements one after another, in increasing order.
class ElementReader {
 public:
  explicit ElementReader(const Accessor& accessor);

  // The element's components as stored, columns one after another; `out` has room for components(). For a sparse
  // accessor the calls must come with increasing `index`.
  void read_raw(std::uint64_t index, double* out);

 private:
  const std::byte* element(std::uint64_t index);

  const Accessor& accessor_;
  std::size_t component_size_;
  Packing packing_;
  std::uint64_t next_sparse_ = 0;
};

// Stored integer to the number it stands for (glTF 2.0, section 3.11, animations); floats pass.
double normalise(double raw, Component component);

// All elements, normalised where the accessor says so.
std::vector<float> read_floats(const Accessor& accessor);

// All elements of a scalar integer accessor.
std::vector<std::uint32_t> read_indices(const Accessor& accessor);

}  // namespace marrow::cook::gltf
