// Typed, bounds-checked reading of accessors.
#include "cook/gltf/document/accessor.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace marrow::cook::gltf {
namespace {

struct Layout {
  std::size_t rows;
  std::size_t columns;
};

constexpr Layout layout_of(Shape shape) {
  switch (shape) {
    case Shape::scalar:
      return {1, 1};
    case Shape::vec2:
      return {2, 1};
    case Shape::vec3:
      return {3, 1};
    case Shape::vec4:
      return {4, 1};
    case Shape::mat2:
      return {2, 2};
    case Shape::mat3:
      return {3, 3};
    case Shape::mat4:
      return {4, 4};
    case Shape::unknown:
      break;
  }
  return {1, 1};
}

template <class T>
double load(const std::byte* from) {
  T value;
  std::memcpy(&value, from, sizeof value);  // both the files and every machine that cooks are little-endian
  return static_cast<double>(value);
}

double load_component(const std::byte* from, Component component) {
  switch (component) {
    case Component::i8:
      return load<std::int8_t>(from);
    case Component::u8:
      return load<std::uint8_t>(from);
    case Component::i16:
      return load<std::int16_t>(from);
    case Component::u16:
      return load<std::uint16_t>(from);
    case Component::u32:
      return load<std::uint32_t>(from);
    case Component::f32:
      return load<float>(from);
  }
  return 0;
}

constexpr std::size_t align4(std::size_t size) {
  return (size + 3) & ~std::size_t{3};
}

}  // namespace

std::size_t size_of(Component component) {
  switch (component) {
    case Component::i8:
    case Component::u8:
      return 1;
    case Component::i16:
    case Component::u16:
      return 2;
    case Component::u32:
    case Component::f32:
      break;
  }
  return 4;
}

std::size_t Accessor::components() const {
  const Layout layout = layout_of(shape);
  return layout.rows * layout.columns;
}

ElementReader::ElementReader(const Accessor& accessor)
    : accessor_(accessor),
      component_size_(size_of(accessor.component)),
      rows_(layout_of(accessor.shape).rows),
      columns_(layout_of(accessor.shape).columns),
      // Matrix columns start on four-byte boundaries.
      column_stride_(columns_ == 1 ? 0 : align4(rows_ * component_size_)) {}

const std::byte* ElementReader::element(std::uint64_t index) {
  const std::byte* found = accessor_.base == nullptr ? nullptr : accessor_.base + index * accessor_.stride;
  if (next_sparse_ < accessor_.sparse_count) {
    const std::size_t size = size_of(accessor_.sparse_component);
    const auto sparse_index = static_cast<std::uint64_t>(
        load_component(accessor_.sparse_indices + next_sparse_ * size, accessor_.sparse_component));
    if (sparse_index == index) {
      const std::size_t packed = columns_ == 1 ? rows_ * component_size_ : columns_ * column_stride_;
      found = accessor_.sparse_values + next_sparse_ * packed;
      ++next_sparse_;
    }
  }
  return found;
}

void ElementReader::read_raw(std::uint64_t index, double* out) {
  const std::byte* from = element(index);
  if (from == nullptr) {
    std::fill_n(out, rows_ * columns_, 0.0);
    return;
  }
  for (std::size_t column = 0; column < columns_; ++column) {
    for (std::size_t row = 0; row < rows_; ++row) {
      *out++ = load_component(from + column * column_stride_ + row * component_size_, accessor_.component);
    }
  }
}

double normalise(double raw, Component component) {
  switch (component) {
    case Component::i8:
      return std::max(raw / 127.0, -1.0);
    case Component::u8:
      return raw / 255.0;
    case Component::i16:
      return std::max(raw / 32767.0, -1.0);
    case Component::u16:
      return raw / 65535.0;
    case Component::u32:
      return raw / 4294967295.0;
    case Component::f32:
      break;
  }
  return raw;
}

std::vector<float> read_floats(const Accessor& accessor) {
  const std::size_t components = accessor.components();
  std::vector<float> values;
  values.reserve(accessor.count * components);
  ElementReader reader(accessor);
  std::array<double, 16> element{};
  for (std::uint64_t i = 0; i < accessor.count; ++i) {
    reader.read_raw(i, element.data());
    for (std::size_t c = 0; c < components; ++c) {
      const double value = accessor.normalised ? normalise(element[c], accessor.component) : element[c];
      values.push_back(static_cast<float>(value));
    }
  }
  return values;
}

std::vector<std::uint32_t> read_indices(const Accessor& accessor) {
  std::vector<std::uint32_t> indices;
  indices.reserve(accessor.count);
  ElementReader reader(accessor);
  std::array<double, 16> element{};
  for (std::uint64_t i = 0; i < accessor.count; ++i) {
    reader.read_raw(i, element.data());
    indices.push_back(static_cast<std::uint32_t>(element[0]));
  }
  return indices;
}

}  // namespace marrow::cook::gltf
