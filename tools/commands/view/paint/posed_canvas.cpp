#include "commands/view/paint/posed_canvas.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "marrow/glm.h"

namespace marrow::tools {
namespace {

// Through the inverse transpose, but for its length.
glm::vec3 turn_normal(const glm::mat3& m, const glm::vec3& n) {
  const glm::vec3 first = glm::cross(m[1], m[2]);
  const glm::vec3 turned = n.x * first + n.y * glm::cross(m[2], m[0]) + n.z * glm::cross(m[0], m[1]);
  return glm::dot(m[0], first) < 0 ? -turned : turned;
}

}  // namespace

void pose_canvas(const Canvas& canvas, std::span<const std::vector<glm::mat4>> binds,
                 std::span<const std::vector<Affine>> model_from_joint, PosedCanvas& out) {
  std::vector<std::vector<glm::mat4>> palettes;
  for (std::size_t g = 0; g < canvas.groups.size(); ++g) {
    std::vector<glm::mat4>& palette = palettes.emplace_back();
    const std::vector<Affine>& joints = model_from_joint[canvas.groups[g].skeleton];
    for (std::size_t j = 0; j < joints.size(); ++j) palette.push_back(to_glm(joints[j]) * binds[g][j]);
  }
  out.places.resize(canvas.bind.size());
  out.matrices.resize(canvas.bind.size());
  for (std::size_t p = 0; p < canvas.bind.size(); ++p) {
    const std::vector<glm::mat4>& palette = palettes[canvas.group_of[p]];
    glm::mat4 blend(0);
    for (const deform::Influence& i : canvas.influences[p]) blend += static_cast<float>(i.weight) * palette[i.joint];
    out.matrices[p] = blend;
    out.places[p] = glm::vec3(blend * glm::vec4(canvas.bind[p], 1));
  }
}

PosedMesh posed_mesh(const Mesh& mesh, std::span<const std::uint32_t> place_of_slot, const PosedCanvas& posed) {
  PosedMesh out;
  for (const std::uint32_t place : place_of_slot) {
    const glm::vec3& at = posed.places[place];
    out.positions.insert(out.positions.end(), {at.x, at.y, at.z});
  }
  const float* const normals = mesh.geometry.normals;
  for (std::size_t slot = 0; normals != nullptr && slot < place_of_slot.size(); ++slot) {
    const float* const n = normals + slot / 4 * 12 + slot % 4;
    const glm::vec3 turned = turn_normal(posed.matrices[place_of_slot[slot]], {n[0], n[4], n[8]});
    const float length = glm::length(turned);
    const glm::vec3 unit = length > 0 ? turned / length : glm::vec3(0, 1, 0);
    out.normals.insert(out.normals.end(), {unit.x, unit.y, unit.z});
  }
  return out;
}

}  // namespace marrow::tools
