// Rules about meshes: attribute names, formats, counts and memory layout.
#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include "cook/gltf/rules/rules.h"

namespace marrow::cook::gltf {
namespace {

using tinygltf::Primitive;

// Component type and normalisation as one bit, so that a set of formats is a number.
enum Format : unsigned {
  f32 = 1,
  u32 = 2,
  u8 = 4,
  u16 = 8,
  i8 = 16,
  i16 = 32,
  u8n = 64,
  u16n = 128,
  i8n = 256,
  i16n = 512
};

unsigned format_of(const Accessor& accessor) {
  switch (accessor.component) {
    case Component::i8:
      return accessor.normalised ? i8n : i8;
    case Component::u8:
      return accessor.normalised ? u8n : u8;
    case Component::i16:
      return accessor.normalised ? i16n : i16;
    case Component::u16:
      return accessor.normalised ? u16n : u16;
    case Component::u32:
      return u32;
    case Component::f32:
      break;
  }
  return f32;
}

constexpr unsigned bit(Shape shape) {
  return 1U << static_cast<unsigned>(shape);
}

// glTF 2.0, section 3.7.2.1; the last column is what KHR_mesh_quantization adds.
struct Semantic {
  std::string_view name;
  bool numbered;
  unsigned shapes;
  unsigned formats;
  unsigned quantised;
};

constexpr std::array<Semantic, 7> kSemantics = {{
    {"POSITION", false, bit(Shape::vec3), f32, u8 | u16 | i8 | i16 | u8n | u16n | i8n | i16n},
    {"NORMAL", false, bit(Shape::vec3), f32, i8n | i16n},
    {"TANGENT", false, bit(Shape::vec4), f32, i8n | i16n},
    {"TEXCOORD", true, bit(Shape::vec2), f32 | u8n | u16n, u8 | u16 | i8 | i16 | i8n | i16n},
    {"COLOR", true, bit(Shape::vec3) | bit(Shape::vec4), f32 | u8n | u16n, 0},
    {"JOINTS", true, bit(Shape::vec4), u8 | u16, 0},
    {"WEIGHTS", true, bit(Shape::vec4), f32 | u8n | u16n, 0},
}};

// Splits "TEXCOORD_1"; numbers are plain decimal without leading zeros.
const Semantic* find_semantic(std::string_view name) {
  const std::size_t underscore = name.find('_');
  const bool numbered = underscore != std::string_view::npos;
  const auto found = std::ranges::find(kSemantics, name.substr(0, underscore), &Semantic::name);
  if (found == kSemantics.end() || found->numbered != numbered) return nullptr;
  if (!numbered) return &*found;
  const std::string_view digits = name.substr(underscore + 1);
  unsigned number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool plain = error == std::errc() && end == digits.data() + digits.size();
  return plain && (digits.size() == 1 || digits.front() != '0') ? &*found : nullptr;
}

enum Role : std::uint8_t { kVertexRole = 1, kIndexRole = 2 };

class MeshChecker {
 public:
  MeshChecker(const Document& document, Report& report)
      : document_(document),
        report_(report),
        role_(document.buffers.views.size()),
        vertex_accessor_(document.buffers.views.size(), -1) {}

  void check_mesh(std::size_t index) {
    const tinygltf::Mesh& mesh = document_.model.meshes[index];
    const std::size_t targets = target_count(mesh);
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const std::string where = pointer("meshes", index, "primitives", p);
      if (mesh.primitives[p].targets.size() != targets) {
        report_.mend(under(where, "targets"), "morph-targets-unequal",
                     "the mesh's primitives differ in their number; all get the first one's");
      }
      check_primitive(mesh.primitives[p], where);
    }
    if (!mesh.weights.empty() && mesh.weights.size() != targets) {
      report_.mend(pointer("meshes", index, "weights"), "morph-weights-wrong", "one a morph target is needed; ignored");
    }
  }

 private:
  const Accessor& accessor(int index) const { return document_.accessor(index); }

  void check_primitive(const Primitive& primitive, const std::string& where) {
    const std::string attributes = under(where, "attributes");
    const std::uint64_t count = accessor(primitive.attributes.begin()->second).count;
    if (count == 0) report_.invalid(attributes, "no vertices", "leave the primitive out; export again");
    for (const auto& [name, index] : primitive.attributes) {
      const std::string here = under(attributes, name);
      if (accessor(index).count != count) {
        report_.invalid(here, "differs in count",
                        std::to_string(accessor(index).count) + " elements where another attribute has " +
                            std::to_string(count) + "; export again");
      }
      check_attribute(name, index, here);
    }
    check_numbering(primitive, attributes);
    if (primitive.indices >= 0) check_indices(primitive.indices, under(where, "indices"));
    for (std::size_t t = 0; t < primitive.targets.size(); ++t) {
      check_target(primitive, primitive.targets[t], count, under(where, "targets", t));
    }
  }

  void check_attribute(const std::string& name, int index, const std::string& where) {
    const Accessor& data = accessor(index);
    const Semantic* semantic = find_semantic(name);
    if (semantic != nullptr) {
      check_format(*semantic, data, where);
    } else if (!name.starts_with('_')) {
      report_.mend(where, "unknown-attribute", "not an attribute of glTF 2.0; ignored");
    } else if (data.component == Component::u32) {
      report_.mend(where, "attribute-format", "32-bit integers are for indices only; ignored");
    }
    if (name == "POSITION" && !data.has_bounds) {
      report_.mend(where, "bounds-missing", "POSITION needs min and max; computed instead");
    }
    check_layout(index, kVertexRole, where);
  }

  void check_format(const Semantic& semantic, const Accessor& data, const std::string& where) {
    if ((semantic.shapes & bit(data.shape)) == 0) {
      report_.invalid(where, "wrong accessor type", "see glTF 2.0, section 3.7.2.1; export again");
    }
    const unsigned format = format_of(data);
    if ((semantic.formats & format) != 0) return;
    if ((semantic.quantised & format) == 0) {
      report_.invalid(where, "wrong component type", "see glTF 2.0, section 3.7.2.1; export again");
    }
    const std::vector<std::string>& used = document_.model.extensionsUsed;
    if (std::ranges::find(used, "KHR_mesh_quantization") == used.end()) {
      report_.mend(where, "attribute-format", "quantised without declaring KHR_mesh_quantization; read all the same");
    }
  }

  // Sets are numbered from zero without gaps, and joints and weights come in pairs.
  void check_numbering(const Primitive& primitive, const std::string& where) {
    for (const auto& [name, index] : primitive.attributes) {
      const Semantic* semantic = find_semantic(name);
      if (semantic == nullptr || !semantic->numbered) continue;
      const std::size_t underscore = name.find('_');
      const std::string number = name.substr(underscore + 1);
      if (semantic->name == "JOINTS" || semantic->name == "WEIGHTS") {
        const std::string other = (semantic->name == "JOINTS" ? "WEIGHTS_" : "JOINTS_") + number;
        if (!primitive.attributes.contains(other)) {
          report_.invalid(under(where, name), "joints and weights must come in pairs", "there is no " + other);
        }
      }
      if (number == "0") continue;
      const std::string previous = name.substr(0, underscore + 1) + std::to_string(std::stoul(number) - 1);
      if (!primitive.attributes.contains(previous)) {
        report_.mend(under(where, name), "attribute-sets-not-continuous", "there is no " + previous);
      }
    }
  }

  void check_indices(int index, const std::string& where) {
    const Accessor& data = accessor(index);
    const unsigned format = format_of(data);
    if (data.shape != Shape::scalar || (format & (u8 | u16 | u32)) == 0) {
      report_.invalid(where, "wrong accessor", "indices are unsigned integer scalars; export again");
    }
    if (data.view >= 0 && document_.view(data.view).stride != 0) {
      report_.invalid(where, "stride not allowed", "only vertex data may have a byteStride; export again");
    }
    check_layout(index, kIndexRole, where);
  }

  void check_target(const Primitive& primitive, const std::map<std::string, int>& target, std::uint64_t count,
                    const std::string& where) {
    for (const auto& [name, index] : target) {
      const std::string here = under(where, name);
      const Accessor& data = accessor(index);
      const Semantic* semantic = find_semantic(name);
      if (semantic == nullptr && !name.starts_with('_')) {
        report_.mend(here, "morph-target-wrong", "not an attribute of glTF 2.0; ignored");
      }
      if (data.count != count) report_.mend(here, "morph-target-wrong", "it differs from the base in count; ignored");
      if (!primitive.attributes.contains(name)) {
        report_.mend(here, "morph-target-wrong", "the base has no such attribute; ignored");
      } else if (name == "POSITION" || name == "NORMAL" || name == "TANGENT") {
        if (data.shape != Shape::vec3) report_.mend(here, "morph-target-wrong", "not three components; ignored");
      } else if (semantic != nullptr) {
        report_.warn(here, "morph-attribute-dropped", "targets move positions, normals and tangents only");
      }
      if (name == "POSITION" && !data.has_bounds) report_.mend(here, "bounds-missing", "POSITION needs min and max");
      check_layout(index, kVertexRole, here);
    }
  }

  // What a graphics API would trip over; reading byte by byte, we do not.
  void check_layout(int index, Role role, const std::string& where) {
    const Accessor& data = accessor(index);
    if (data.view < 0) return;
    const auto view_index = to_index(data.view);
    const View& view = document_.buffers.views[view_index];
    constexpr std::int64_t kTargetOfRole[] = {0, 34962, 34963};
    if (view.target != 0 && view.target != kTargetOfRole[role]) {
      report_.mend(where, "buffer-target-wrong", "the bufferView's target says otherwise; ignored");
    }
    if (role_[view_index] != 0 && role_[view_index] != role) {
      report_.mend(where, "buffer-view-shared", "vertices and indices share a bufferView; read all the same");
    }
    role_[view_index] = role;
    if (role != kVertexRole) return;
    if (data.offset % 4 != 0 || data.stride % 4 != 0) {
      report_.mend(where, "attribute-misaligned", "vertices start on four-byte boundaries; read all the same");
    }
    int& user = vertex_accessor_[view_index];
    if (view.stride == 0 && user >= 0 && user != index) {
      report_.mend(where, "stride-missing", "accessors that share a bufferView need a byteStride; taken as packed");
    }
    user = index;
  }

  const Document& document_;
  Report& report_;
  std::vector<std::uint8_t> role_;    // by buffer view
  std::vector<int> vertex_accessor_;  // the last one seen in a buffer view
};

}  // namespace

void check_meshes(const Document& document, Report& report) {
  MeshChecker checker(document, report);
  for (std::size_t i = 0; i < document.model.meshes.size(); ++i) checker.check_mesh(i);
}

}  // namespace marrow::cook::gltf
