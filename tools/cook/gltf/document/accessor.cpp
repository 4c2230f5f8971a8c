// Typed, bounds-checked reading of accessors, which are checked against glTF 2.0, sections 3.6.2 and 5.1, and against
// the bytes that are there.
#include "cook/gltf/document/accessor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

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

// Matrix columns start on four-byte boundaries.
Packing packing_of(Shape shape, Component component) {
  const Layout layout = layout_of(shape);
  const std::size_t column = layout.rows * size_of(component);
  const std::size_t stride = layout.columns == 1 ? column : (column + 3) / 4 * 4;
  return {layout.rows, layout.columns, stride, stride * layout.columns, stride * (layout.columns - 1) + column};
}

ElementReader::ElementReader(const Accessor& accessor)
    : accessor_(accessor),
      component_size_(size_of(accessor.component)),
      packing_(packing_of(accessor.shape, accessor.component)) {}

const std::byte* ElementReader::element(std::uint64_t index) {
  const std::byte* found = accessor_.base == nullptr ? nullptr : accessor_.base + index * accessor_.stride;
  if (next_sparse_ < accessor_.sparse_count) {
    const std::size_t size = size_of(accessor_.sparse_component);
    const auto sparse_index = static_cast<std::uint64_t>(
        load_component(accessor_.sparse_indices + next_sparse_ * size, accessor_.sparse_component));
    if (sparse_index == index) {
      found = accessor_.sparse_values + next_sparse_ * packing_.size;
      ++next_sparse_;
    }
  }
  return found;
}

void ElementReader::read_raw(std::uint64_t index, double* out) {
  const std::byte* from = element(index);
  if (from == nullptr) {
    std::fill_n(out, packing_.rows * packing_.columns, 0.0);
    return;
  }
  for (std::size_t column = 0; column < packing_.columns; ++column) {
    for (std::size_t row = 0; row < packing_.rows; ++row) {
      *out++ = load_component(from + column * packing_.column_stride + row * component_size_, accessor_.component);
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

namespace {

constexpr std::array<std::pair<std::string_view, Shape>, 7> kShapes = {{{"SCALAR", Shape::scalar},
                                                                        {"VEC2", Shape::vec2},
                                                                        {"VEC3", Shape::vec3},
                                                                        {"VEC4", Shape::vec4},
                                                                        {"MAT2", Shape::mat2},
                                                                        {"MAT3", Shape::mat3},
                                                                        {"MAT4", Shape::mat4}}};

// Far below this the count times any stride cannot wrap 64 bits.
constexpr std::uint64_t kMostElements = std::uint64_t{1} << 32;

// An accessor without a bufferView costs its file nothing, so its size needs a limit of its own.
constexpr std::uint64_t kMostZeros = std::uint64_t{1} << 24;

// Accessors may overlap, but a file that makes us read its bytes this often over is an attack. In bytes, and times.
constexpr std::uint64_t kFreeScan = std::uint64_t{1} << 26;
constexpr std::uint64_t kMostOverlap = 16;

// Declared bounds are often printed with fewer digits than a float has.
constexpr double kBoundSlack = 1e-5;

class Checker {
 public:
  Checker(const Json& json, std::size_t index, const Buffers& buffers, std::uint64_t& scan_budget, Report& report)
      : json_(json), where_(pointer("accessors", index)), buffers_(buffers), budget_(scan_budget), report_(report) {}

  Accessor check() {
    read_type();
    if (accessor_.shape == Shape::unknown) return accessor_;
    if (accessor_.count == 0) {
      report_.mend(under(where_, "count"), "empty-accessor", "glTF 2.0 demands an element");
      return accessor_;
    }
    read_base();
    if (json_.contains("sparse")) read_sparse(json_.at("sparse"));
    read_bounds();
    if (accessor_.has_data()) scan();
    return accessor_;
  }

 private:
  Component component_at(const Json& object, const std::string& where) const {
    const auto code = object.at("componentType").get<std::uint64_t>();
    switch (code) {
      case 5120:
      case 5121:
      case 5122:
      case 5123:
      case 5125:
      case 5126:
        return static_cast<Component>(code);
      default:
        report_.invalid(under(where, "componentType"), "unknown component type", "export again");
    }
  }

  void read_type() {
    accessor_.component = component_at(json_, where_);
    accessor_.count = json_.at("count").get<std::uint64_t>();
    if (accessor_.count > kMostElements) {
      report_.invalid(under(where_, "count"), "count too large", "no buffer holds that much; export again");
    }
    const auto& type = json_.at("type").get_ref<const std::string&>();
    for (const auto& [name, shape] : kShapes) {
      if (type == name) accessor_.shape = shape;
    }
    if (accessor_.shape == Shape::unknown) {
      report_.warn(under(where_, "type"), "unknown-accessor-type", "the accessor cannot be read and must stay unused");
    }
    accessor_.normalised = json_.value("normalized", false);
    const bool wide = accessor_.component == Component::f32 || accessor_.component == Component::u32;
    if (accessor_.normalised && wide) {
      report_.invalid(under(where_, "normalized"), "floats and 32-bit integers cannot be normalised", "export again");
    }
  }

  bool is_matrix() const { return accessor_.shape >= Shape::mat2 && accessor_.shape <= Shape::mat4; }

  Packing packing() const { return packing_of(accessor_.shape, accessor_.component); }

  void read_base() {
    const std::uint64_t offset = count_or(json_, "byteOffset", 0);
    if (!json_.contains("bufferView")) {
      if (accessor_.count > kMostZeros) {
        report_.unsupported(under(where_, "count"), "too many zeros",
                            "without a bufferView at most " + std::to_string(kMostZeros) + " elements are made");
      }
      if (json_.contains("byteOffset")) {
        report_.invalid(under(where_, "byteOffset"), "without a bufferView", "export again");
      }
      return;
    }
    accessor_.view = json_.at("bufferView").get<int>();
    accessor_.offset = offset;
    const View& view = buffers_.views[to_index(accessor_.view)];
    const std::size_t used = packing().used;
    accessor_.stride = view.stride == 0 ? packing().size : view.stride;
    if (accessor_.stride < used) {
      report_.invalid(where_, "elements overlap", "the view's byteStride is smaller than an element; export again");
    }
    check_alignment(offset, view, size_of(accessor_.component), where_);
    if (is_matrix() && offset % 4 != 0) {
      report_.invalid(under(where_, "byteOffset"), "misaligned",
                      "a matrix starts on a four-byte boundary; export again");
    }
    check_fits(offset, accessor_.stride, used, accessor_.count, view.length, where_);
    if (view.present) accessor_.base = view.bytes.data() + offset;
  }

  // Both the offset in the view and the one in the buffer count.
  void check_alignment(std::uint64_t offset, const View& view, std::size_t component, const std::string& where) {
    if (offset % component == 0 && (view.offset + offset) % component == 0) return;
    report_.invalid(under(where, "byteOffset"), "misaligned",
                    "the data must start on a multiple of " + std::to_string(component) + " bytes; export again");
  }

  void check_fits(std::uint64_t offset, std::uint64_t stride, std::uint64_t used, std::uint64_t count,
                  std::uint64_t length, const std::string& where) {
    // count ≤ 2^32 and stride ≤ 252 keep the product far from wrapping.
    const std::uint64_t size = stride * (count - 1) + used;
    if (offset <= length && size <= length - offset) return;
    report_.invalid(where, "beyond the bufferView's end",
                    "it needs " + std::to_string(size) + " bytes from " + std::to_string(offset) +
                        " but the view has " + std::to_string(length) + "; export again");
  }

  const View& plain_view(const Json& object, const std::string& where) {
    const View& view = buffers_.views[object.at("bufferView").get<std::size_t>()];
    if (view.stride != 0) report_.invalid(under(where, "bufferView"), "must not have a byteStride", "export again");
    return view;
  }

  void read_sparse(const Json& sparse) {
    const std::string where = under(where_, "sparse");
    const auto count = sparse.at("count").get<std::uint64_t>();
    if (count > accessor_.count) report_.invalid(under(where, "count"), "more than the accessor has", "export again");

    const Json& indices = sparse.at("indices");
    const std::string indices_where = under(where, "indices");
    accessor_.sparse_component = component_at(indices, indices_where);
    const Component component = accessor_.sparse_component;
    if (component != Component::u8 && component != Component::u16 && component != Component::u32) {
      report_.invalid(under(indices_where, "componentType"), "not an unsigned integer", "export again");
    }
    const View& index_view = plain_view(indices, indices_where);
    const std::uint64_t index_offset = count_or(indices, "byteOffset", 0);
    check_alignment(index_offset, index_view, size_of(component), indices_where);
    check_fits(index_offset, size_of(component), size_of(component), count, index_view.length, indices_where);

    const Json& values = sparse.at("values");
    const std::string values_where = under(where, "values");
    const View& value_view = plain_view(values, values_where);
    const std::uint64_t value_offset = count_or(values, "byteOffset", 0);
    check_alignment(value_offset, value_view, size_of(accessor_.component), values_where);
    check_fits(value_offset, packing().size, packing().used, count, value_view.length, values_where);
    if (!index_view.present || !value_view.present) return;
    accessor_.sparse_indices = index_view.bytes.data() + index_offset;
    accessor_.sparse_values = value_view.bytes.data() + value_offset;
    accessor_.sparse_count = count;
    check_sparse_order(indices_where);
  }

  void check_sparse_order(const std::string& where) {
    Accessor indices;
    indices.component = accessor_.sparse_component;
    indices.shape = Shape::scalar;
    indices.count = accessor_.sparse_count;
    indices.base = accessor_.sparse_indices;
    indices.stride = size_of(indices.component);
    ElementReader reader(indices);
    double previous = -1;
    for (std::uint64_t i = 0; i < indices.count; ++i) {
      double index = 0;
      reader.read_raw(i, &index);
      if (index <= previous) report_.invalid(where, "sparse indices must increase", "export again");
      if (index >= static_cast<double>(accessor_.count)) {
        report_.invalid(where, "sparse index beyond the accessor's end", "export again");
      }
      previous = index;
    }
  }

  void read_bounds() {
    const auto read = [&](const char* name, std::vector<double>& into) {
      const auto member = json_.find(name);
      if (member == json_.end()) return;
      if (member->size() != accessor_.components()) {
        report_.mend(under(where_, name), "bounds-wrong", "one number a component is needed; the bounds are ignored");
        return;
      }
      into = member->get<std::vector<double>>();
      if (accessor_.component != Component::f32) return;
      for (double& bound : into) bound = static_cast<double>(static_cast<float>(bound));
    };
    read("min", accessor_.min);
    read("max", accessor_.max);
    accessor_.has_bounds = !accessor_.min.empty() && !accessor_.max.empty();
  }

  // Zeros under a sparse accessor need no reading.
  Accessor scanned_part() const {
    if (accessor_.base != nullptr) return accessor_;
    Accessor values = accessor_;
    values.base = accessor_.sparse_values;
    values.stride = packing().size;
    values.count = accessor_.sparse_count;
    values.sparse_count = 0;
    return values;
  }

  void scan() {
    const Accessor part = scanned_part();
    const std::uint64_t size = part.count * packing().used;
    if (size > budget_) report_.unsupported(where_, "accessors overlap too much", "export again without shared data");
    budget_ -= size;
    ElementReader reader(part);
    const std::size_t components = accessor_.components();
    std::array<double, 16> lowest{};
    std::array<double, 16> highest{};
    if (accessor_.base != nullptr) {
      lowest.fill(HUGE_VAL);
      highest.fill(-HUGE_VAL);
    }
    bool all_finite = true;
    std::array<double, 16> element{};
    for (std::uint64_t i = 0; i < part.count; ++i) {
      reader.read_raw(i, element.data());
      for (std::size_t c = 0; c < components; ++c) {
        if (!std::isfinite(element[c])) {
          all_finite = false;
          continue;
        }
        lowest[c] = std::min(lowest[c], element[c]);
        highest[c] = std::max(highest[c], element[c]);
      }
    }
    // Elsewhere it depends on the use: a broken normal can be made anew, a broken position cannot.
    if (!all_finite && !report_.mends()) report_.invalid(where_, "not a finite number", "export again");
    check_bounds(lowest.data(), highest.data());
  }

  void check_bounds(const double* lowest, const double* highest) {
    for (std::size_t c = 0; c < accessor_.components(); ++c) {
      const double slack = kBoundSlack * std::max(std::abs(lowest[c]), std::abs(highest[c]));
      const bool below = !accessor_.min.empty() && lowest[c] < accessor_.min[c] - slack;
      const bool above = !accessor_.max.empty() && highest[c] > accessor_.max[c] + slack;
      if (!below && !above) continue;
      report_.mend(under(where_, below ? "min" : "max", c), "bounds-wrong",
                   "a value lies outside of the declared bounds; the bounds are ignored");
      return;
    }
  }

  const Json& json_;
  std::string where_;
  const Buffers& buffers_;
  std::uint64_t& budget_;  // bytes that may still be scanned
  Report& report_;
  Accessor accessor_;
};

}  // namespace

std::vector<Accessor> build_accessors(const Json& root, const Buffers& buffers, Report& report) {
  std::vector<Accessor> accessors;
  const auto list = root.find("accessors");
  if (list == root.end()) return accessors;
  std::uint64_t buffer_bytes = 0;
  for (const auto& buffer : buffers.buffers) buffer_bytes += buffer ? buffer->size() : 0;
  std::uint64_t budget = kFreeScan + kMostOverlap * buffer_bytes;
  accessors.reserve(list->size());
  for (std::size_t i = 0; i < list->size(); ++i) {
    accessors.push_back(Checker((*list)[i], i, buffers, budget, report).check());
  }
  return accessors;
}

}  // namespace marrow::cook::gltf
