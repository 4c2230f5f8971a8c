// Checks accessors against glTF 2.0, sections 3.6.2 and 5.1, and against the bytes that are there.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "cook/gltf/document/accessor.h"

namespace marrow::cook::gltf {
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
  std::uint64_t count_or_zero(const Json& object, const char* name) const {
    const auto member = object.find(name);
    return member == object.end() ? 0 : member->get<std::uint64_t>();
  }

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

  std::size_t rows() const { return is_matrix() ? 2 + (static_cast<std::size_t>(accessor_.shape) - 4) : 1; }

  // The distance of tightly packed elements, and where the last component of one ends.
  std::pair<std::size_t, std::size_t> packed_and_used() const {
    const std::size_t component = size_of(accessor_.component);
    if (!is_matrix()) return {component * accessor_.components(), component * accessor_.components()};
    const std::size_t column = (rows() * component + 3) / 4 * 4;
    return {column * rows(), column * (rows() - 1) + rows() * component};
  }

  void read_base() {
    const std::uint64_t offset = count_or_zero(json_, "byteOffset");
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
    const View& view = buffers_.views[static_cast<std::size_t>(accessor_.view)];
    const auto [packed, used] = packed_and_used();
    accessor_.stride = view.stride == 0 ? packed : view.stride;
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
    const std::uint64_t index_offset = count_or_zero(indices, "byteOffset");
    check_alignment(index_offset, index_view, size_of(component), indices_where);
    check_fits(index_offset, size_of(component), size_of(component), count, index_view.length, indices_where);

    const Json& values = sparse.at("values");
    const std::string values_where = under(where, "values");
    const View& value_view = plain_view(values, values_where);
    const std::uint64_t value_offset = count_or_zero(values, "byteOffset");
    const auto [packed, used] = packed_and_used();
    check_alignment(value_offset, value_view, size_of(accessor_.component), values_where);
    check_fits(value_offset, packed, used, count, value_view.length, values_where);
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
    values.stride = packed_and_used().first;
    values.count = accessor_.sparse_count;
    values.sparse_count = 0;
    return values;
  }

  void scan() {
    const Accessor part = scanned_part();
    const std::uint64_t size = part.count * packed_and_used().second;
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
