// Imports nodes, skins and what draws what.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "asset/format.h"
#include "common/elementary.h"
#include "cook/gltf/import/import.h"
#include "cook/scene/matrices.h"
#include "text/safe_name.h"

namespace marrow::cook::gltf {

std::string clean_name(const std::string& name, const std::string& where, Report& report) {
  std::string clean = tools::safe_name(name);
  if (clean != name)
    report.warn(under(where, "name"), "name-cleaned", "unfit to print or to name a file; now \"" + clean + '"');
  return clean;
}

// Chains may be too long to recurse along.
std::vector<glm::dmat4> rest_matrices(const std::vector<RawNode>& nodes) {
  std::vector<glm::dmat4> matrices(nodes.size());
  std::vector<bool> known(nodes.size());
  std::vector<std::size_t> way;
  for (std::size_t start = 0; start < nodes.size(); ++start) {
    int at = static_cast<int>(start);
    while (at != kNone && !known[to_index(at)]) {
      way.push_back(to_index(at));
      at = nodes[to_index(at)].parent;
    }
    for (; !way.empty(); way.pop_back()) {
      const RawNode& node = nodes[way.back()];
      matrices[way.back()] = local_matrix(node);
      if (node.parent != kNone) matrices[way.back()] = matrices[to_index(node.parent)] * matrices[way.back()];
      known[way.back()] = true;
    }
  }
  return matrices;
}

namespace {

constexpr double kRotationSlack = 1e-3;  // exporters print few digits; below this a rotation is normalised in silence
constexpr double kShearSlack = 1e-3;     // cosine between two axes
constexpr double kSmallestScale = 1e-6;  // keeps matrices invertible, and still cannot be seen
constexpr double kSmallestAxis = 1e-12;
constexpr double kAffineSlack = 1e-4;
constexpr double kLargestInverseBind = 1e9;  // no length of a scene in metres comes near

glm::dvec3 vec3_or(const std::vector<double>& numbers, glm::dvec3 fallback) {
  return numbers.empty() ? fallback : glm::dvec3(numbers[0], numbers[1], numbers[2]);
}

glm::dmat4 matrix_of(const double* column_major) {
  glm::dmat4 matrix;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) matrix[column][row] = column_major[column * 4 + row];
  }
  return matrix;
}

bool has_affine_row(const glm::dmat4& matrix) {
  return std::abs(matrix[0][3]) <= kAffineSlack && std::abs(matrix[1][3]) <= kAffineSlack &&
         std::abs(matrix[2][3]) <= kAffineSlack && std::abs(matrix[3][3] - 1) <= kAffineSlack;
}

glm::dquat unit_rotation(const std::vector<double>& xyzw, const std::string& where, Report& report) {
  if (xyzw.empty()) return {1, 0, 0, 0};
  const glm::dquat rotation(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
  const double length = tools::length_of(xyzw[0], xyzw[1], xyzw[2], xyzw[3]);
  if (length < kSmallestAxis) {
    report.mend(under(where, "rotation"), "rotation-zero", "a quaternion of length zero; no rotation instead");
    return {1, 0, 0, 0};
  }
  if (std::abs(length - 1) > kRotationSlack) {
    report.mend(under(where, "rotation"), "rotation-not-unit", "normalised from length " + std::to_string(length));
  }
  return rotation / length;
}

// Gram–Schmidt on the columns: exact for a matrix that is translate · rotate · scale, the nearest by x, then y, for one
// that is not. A mirrored matrix gets a negative x scale.
void decompose(const std::vector<double>& numbers, RawNode& node, const std::string& where, Report& report) {
  const glm::dmat4 matrix = matrix_of(numbers.data());
  const std::string here = under(where, "matrix");
  if (!has_affine_row(matrix)) report.mend(here, "matrix-not-affine", "the last row must be 0 0 0 1; taken as such");
  std::array<glm::dvec3, 3> axis{};
  bool flat = false;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 column(matrix[i]);
    node.scale[i] = glm::length(column);
    flat = flat || node.scale[i] < kSmallestAxis;
    axis[to_index(i)] = flat ? column : column / node.scale[i];
  }
  node.translation = glm::dvec3(matrix[3]);
  if (flat) {
    report.mend(here, "matrix-singular", "an axis has no length, so no rotation can be read from it; none is applied");
    return;
  }
  auto& [x, y, z] = axis;
  const double shear = std::max({std::abs(glm::dot(x, y)), std::abs(glm::dot(y, z)), std::abs(glm::dot(z, x))});
  if (shear > kShearSlack) report.mend(here, "matrix-sheared", "shear cannot be carried; it is dropped");
  const double volume = glm::dot(glm::cross(x, y), z);
  y = y - x * glm::dot(x, y);
  if (glm::length(y) < kSmallestAxis || std::abs(volume) < kSmallestAxis) {
    report.mend(here, "matrix-singular", "two axes fall together, so no rotation can be read; none is applied");
    return;
  }
  y = glm::normalize(y);
  if (volume < 0) {
    node.scale.x = -node.scale.x;
    x = -x;
  }
  z = glm::cross(x, y);
  node.rotation = glm::normalize(glm::quat_cast(glm::dmat3(x, y, z)));
}

// Legal, and used to hide things, but no inverse exists for what hangs below.
void keep_invertible(RawNode& node, const std::string& where, Report& report) {
  bool mended = false;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(node.scale[i]) >= kSmallestScale) continue;
    node.scale[i] = std::copysign(kSmallestScale, node.scale[i]);
    mended = true;
  }
  if (mended) report.warn(under(where, "scale"), "scale-zero", "a scale of zero cannot be inverted; now a millionth");
}

RawNode import_node(const tinygltf::Node& node, std::size_t index, Report& report) {
  const std::string where = pointer("nodes", index);
  RawNode raw;
  raw.name = clean_name(node.name, where, report);
  if (!node.matrix.empty()) {
    decompose(node.matrix, raw, where, report);
  } else {
    raw.translation = vec3_or(node.translation, raw.translation);
    raw.rotation = unit_rotation(node.rotation, where, report);
    raw.scale = vec3_or(node.scale, raw.scale);
  }
  keep_invertible(raw, where, report);
  return raw;
}

void refuse_huge(const std::vector<RawNode>& nodes, const Report& report) {
  const auto fits = [](double number) { return std::abs(number) <= double{format::kFarthest}; };  // false for NaN too
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!fits(nodes[i].translation[c]) || !fits(nodes[i].scale[c]))
        report.invalid(pointer("nodes", i), "a number beyond 1e12", "export again, in metres");
  const std::vector<glm::dmat4> rest = rest_matrices(nodes);
  for (std::size_t i = 0; i < rest.size(); ++i)
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 3; ++row)
        if (!fits(rest[i][column][row]))
          report.invalid(pointer("nodes", i), "a number beyond 1e12, with the nodes above it",
                         "export again, in metres");
}

bool is_usable(const glm::dmat4& matrix) {
  double lengths = 1;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!(std::abs(matrix[column][row]) <= kLargestInverseBind)) return false;
    }
    if (column < 3) lengths *= glm::length(glm::dvec3(matrix[column]));
  }
  return lengths > 0 && std::abs(glm::determinant(glm::dmat3(matrix))) > kSmallestAxis * lengths;
}

class SkinImporter {
 public:
  SkinImporter(const Document& document, const std::vector<RawNode>& nodes, Report& report)
      : document_(document), nodes_(nodes), report_(report) {}

  RawSkin import(std::size_t index) {
    const tinygltf::Skin& skin = document_.model.skins[index];
    RawSkin raw;
    raw.name = clean_name(skin.name, pointer("skins", index), report_);
    raw.joints = skin.joints;
    raw.inverse_bind.assign(raw.joints.size(), glm::dmat4(1));
    if (skin.inverseBindMatrices < 0) return raw;
    const std::string where = pointer("skins", index, "inverseBindMatrices");
    const Accessor& accessor = document_.accessor(skin.inverseBindMatrices);
    ElementReader reader(accessor);
    std::array<double, 16> numbers{};
    for (std::size_t j = 0; j < raw.joints.size(); ++j) {
      reader.read_raw(j, numbers.data());
      if (accessor.has_data()) raw.inverse_bind[j] = checked(numbers, j, raw.joints[j], where);
    }
    return raw;
  }

 private:
  glm::dmat4 checked(const std::array<double, 16>& numbers, std::size_t index, int joint, const std::string& where) {
    const std::string which = "matrix " + std::to_string(index);
    if (!std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); })) {
      report_.invalid(where, "not a finite number", which + " is damaged; export again");
    }
    glm::dmat4 matrix = matrix_of(numbers.data());
    if (!has_affine_row(matrix)) {
      report_.mend(where, "matrix-not-affine", which + " must have 0 0 0 1 as its last row; taken as such");
    }
    for (int column = 0; column < 4; ++column) matrix[column][3] = column == 3 ? 1 : 0;
    if (is_usable(matrix)) return matrix;
    report_.mend(where, "inverse-bind-unusable", which + " has no inverse; made anew from the joint's rest pose");
    if (rest_.empty()) rest_ = rest_matrices(nodes_);
    const glm::dmat4& rest = rest_[to_index(joint)];
    const glm::dmat4 inverse = is_usable(rest) ? glm::inverse(rest) : glm::dmat4(1);
    return is_usable(inverse) ? inverse : glm::dmat4(1);
  }

  const Document& document_;
  const std::vector<RawNode>& nodes_;
  Report& report_;
  std::vector<glm::dmat4> rest_;
};

struct HighestJoint {
  std::int64_t joint = -1;  // -1: the mesh has no influences
  std::size_t primitive = 0;
};

HighestJoint highest_joint(const RawMesh& mesh) {
  HighestJoint highest;
  for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
    for (const std::vector<RawInfluence>& vertex : mesh.primitives[p].influences) {
      for (const RawInfluence& influence : vertex) {
        if (std::int64_t{influence.joint} > highest.joint) highest = {std::int64_t{influence.joint}, p};
      }
    }
  }
  return highest;
}

}  // namespace

std::vector<RawNode> import_nodes(const Document& document, const NodeGraph& graph, Report& report) {
  std::vector<RawNode> nodes;
  nodes.reserve(document.model.nodes.size());
  for (std::size_t i = 0; i < document.model.nodes.size(); ++i) {
    nodes.push_back(import_node(document.model.nodes[i], i, report));
    nodes.back().parent = graph.parent[i];
    nodes.back().is_view = document.node_is_view[i];
    nodes.back().in_scene = graph.in_scene[i];
  }
  refuse_huge(nodes, report);
  return nodes;
}

std::vector<RawSkin> import_skins(const Document& document, const std::vector<RawNode>& nodes, Report& report) {
  SkinImporter importer(document, nodes, report);
  std::vector<RawSkin> skins;
  for (std::size_t i = 0; i < document.model.skins.size(); ++i) skins.push_back(importer.import(i));
  return skins;
}

std::vector<RawInstance> import_instances(const Document& document, const NodeGraph& graph,
                                          const std::vector<RawNode>& nodes, std::vector<RawMesh>& meshes,
                                          const std::vector<RawSkin>& skins, Report& report) {
  std::vector<HighestJoint> highest;
  for (const RawMesh& mesh : meshes) highest.push_back(highest_joint(mesh));
  const std::vector<std::string> owners = weight_owners(document, nodes);
  std::vector<bool> skinned(meshes.size());
  std::vector<RawInstance> instances;
  for (std::size_t i = 0; i < document.model.nodes.size(); ++i) {
    const tinygltf::Node& node = document.model.nodes[i];
    if (node.mesh < 0 || !graph.drawn[i]) continue;
    const auto mesh = to_index(node.mesh);
    RawInstance instance{static_cast<int>(i), node.mesh, node.skin < 0 ? kNone : node.skin, {}, kNone};
    instance.weights = node_weights(document, owners, instance.node, pointer("nodes", i), report);
    const HighestJoint& used = highest[mesh];
    if (instance.skin != kNone && used.joint < 0) {
      if (!meshes[mesh].primitives.empty()) {
        report.mend(pointer("nodes", i, "skin"), "skin-without-weights",
                    "the mesh has no joints or weights; drawn rigidly");
      }
      instance.unused_skin = instance.skin;
      instance.skin = kNone;
    } else if (instance.skin == kNone && used.joint >= 0) {
      report.warn(pointer("nodes", i), "weights-without-skin", "the mesh has joints and weights; drawn rigidly");
    } else if (instance.skin != kNone) {
      const std::size_t joints = skins[to_index(instance.skin)].joints.size();
      if (static_cast<std::size_t>(used.joint) >= joints) {
        report.invalid(under(meshes[mesh].primitives[used.primitive].pointer, "attributes", "JOINTS_0"),
                       "joint that the skin lacks",
                       std::to_string(used.joint) + " of " + std::to_string(joints) + "; export again");
      }
      skinned[mesh] = true;
    }
    instances.push_back(instance);
  }
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    if (skinned[m]) continue;
    for (RawPrimitive& primitive : meshes[m].primitives) primitive.influences.clear();
  }
  return instances;
}

}  // namespace marrow::cook::gltf
