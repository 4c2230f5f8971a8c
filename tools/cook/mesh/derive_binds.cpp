#include "cook/mesh/derive_binds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "cook/scene/matrices.h"
#include "cook/skin/deform_source.h"
#include "unpack/structure.h"

namespace marrow::cook {
namespace {

constexpr std::size_t kTries = 4;  // joints whose bind pose may say where the mesh stands

// With 0, 1 and -1 for what is that but for the rounding of exporters: packed files have two bits for those.
Affine tidied(const Affine& map) {
  constexpr float kRounding = 1e-6f;
  Affine out = map;
  for (auto& row : out.rows)
    for (float& x : row)
      for (const float whole : {0.0f, 1.0f, -1.0f})
        if (std::fabs(x - whole) < kRounding) x = whole;
  return out;
}

// How far a corner of the box goes if one inverse bind takes the place of another, in the mesh's space. Infinite for
// what cannot be inverted.
double displacement(const Affine& given, const Affine& derived, const format::GeometryHeader& box) {
  const glm::dmat4 change = glm::inverse(to_matrix(given)) * to_matrix(derived);
  double most = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    glm::dvec4 v(0, 0, 0, 1);
    for (int axis = 0; axis < 3; ++axis)
      v[axis] = static_cast<double>((corner >> axis & 1) != 0 ? box.box_max[axis] : box.box_min[axis]);
    const double distance = glm::length(glm::dvec3(change * v - v));
    if (!std::isfinite(distance)) return HUGE_VAL;
    most = std::max(most, distance);
  }
  return most;
}

// The bind poses of a mesh, or of all parts of one, each joint once.
struct Binds {
  std::vector<std::uint16_t> joints;
  std::vector<Affine> inverse_bind;
};

// Where the mesh would stand for most of its inverse binds to follow from the rest pose, and which of them do not.
struct Derived {
  Affine place = kIdentityMap;
  std::vector<Affine> inverse_bind;
  std::vector<char> is_given;
  double moved_m = 0;
};

Derived derive(const std::vector<Affine>& model, double allowed_m, const format::GeometryHeader& box,
               const Binds& mesh) {
  std::vector<Affine> places = {kIdentityMap};
  for (std::size_t i = 0; i < std::min(mesh.joints.size(), kTries); ++i) {
    const Affine place = to_affine(to_matrix(model[mesh.joints[i]]) * to_matrix(mesh.inverse_bind[i]));
    places.push_back(tidied(place));
    places.push_back(place);
  }
  std::size_t fewest = mesh.joints.size() + 1;
  Derived best;
  for (const Affine& place : places) {
    Derived out;
    out.place = place;
    for (std::size_t i = 0; i < mesh.joints.size(); ++i) {
      out.inverse_bind.push_back(derived_inverse_bind(model[mesh.joints[i]], place));
      double moved = displacement(mesh.inverse_bind[i], out.inverse_bind.back(), box);
      out.is_given.push_back(moved > allowed_m);
      if (out.is_given.back() != 0) {
        out.inverse_bind.back() = tidied(mesh.inverse_bind[i]);
        moved = displacement(mesh.inverse_bind[i], out.inverse_bind.back(), box);
        if (moved > allowed_m) {
          out.inverse_bind.back() = mesh.inverse_bind[i];
          moved = 0;
        }
      }
      out.moved_m = std::max(out.moved_m, moved);
    }
    const auto count = static_cast<std::size_t>(std::count(out.is_given.begin(), out.is_given.end(), 1));
    if (count >= fewest) continue;
    fewest = count;
    best = std::move(out);
  }
  return best;
}

// Parts in a row, decided together, so that a joint is where it is in all of them.
void derive_parts(const std::vector<Affine>& model, std::span<BuiltMesh> parts,
                  const std::vector<BuiltGeometry>& geometries, std::vector<double>& moved_m) {
  Binds binds;
  std::map<std::uint16_t, std::size_t> at;
  format::GeometryHeader box = geometries[parts.front().geometry].header;
  for (const BuiltMesh& part : parts) {
    const format::GeometryHeader& h = geometries[part.geometry].header;
    for (int axis = 0; axis < 3; ++axis) {
      box.box_min[axis] = std::min(box.box_min[axis], h.box_min[axis]);
      box.box_max[axis] = std::max(box.box_max[axis], h.box_max[axis]);
    }
    for (std::size_t i = 0; i < part.joints.size(); ++i) {
      if (!at.try_emplace(part.joints[i], binds.joints.size()).second) continue;
      binds.joints.push_back(part.joints[i]);
      binds.inverse_bind.push_back(part.inverse_bind[i]);
    }
  }
  const Derived derived = derive(model, geometries[parts.front().geometry].position_step / 8, box, binds);
  for (BuiltMesh& part : parts) {
    part.model_from_mesh = derived.place;
    part.bind_is_given.clear();
    for (std::size_t i = 0; i < part.joints.size(); ++i) {
      const std::size_t joint = at.at(part.joints[i]);
      part.bind_is_given.push_back(derived.is_given[joint]);
      part.inverse_bind[i] = derived.inverse_bind[joint];
    }
    moved_m[part.geometry] = std::max(moved_m[part.geometry], derived.moved_m);
  }
}

}  // namespace

BuiltMeshes derive_inverse_binds(const std::vector<BuiltSkeleton>& skeletons, BuiltMeshes meshes) {
  std::vector<std::vector<Affine>> models;
  for (const BuiltSkeleton& skeleton : skeletons) models.push_back(model_pose(skeleton, skeleton.rest));
  std::vector<double> moved_m(meshes.geometries.size(), 0);
  std::vector<BuiltMesh>& all = meshes.meshes;
  for (std::size_t m = 0; m < all.size(); m += all[m].parts)
    derive_parts(models[all[m].skeleton], std::span(all).subspan(m, all[m].parts), meshes.geometries, moved_m);
  for (std::size_t i = 0; i < moved_m.size(); ++i) meshes.geometries[i].error.bind = moved_m[i];
  return meshes;
}

}  // namespace marrow::cook
