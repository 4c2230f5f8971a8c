// Tangents of a surface as animation-space vectors.
#include "core/check.h"
#include "core/zone.h"
#include "math/linear.h"
#include "skin/as_stand_ins.h"

namespace marrow {
namespace {

// A cosine. Copies of a vertex whose normals are farther apart than this lie on two sides of a crease.
constexpr float kSmooth = 0.9f;
// Copies that are looked at, so that hostile meshes do not take for ever.
constexpr std::uint32_t kMostCopies = 256;
// Triangles whose area vectors sum to less than this share of their areas have no common normal.
constexpr float kFlat = 1e-3f;

Vector3 direction(const float* stream, std::uint32_t stride, std::uint32_t slot) {
  return {AsSurface::lane(stream, stride, slot, 0), AsSurface::lane(stream, stride, slot, 1),
          AsSurface::lane(stream, stride, slot, 2)};
}

// Calls visit(k, l) with the slots of each triangle (v, k, l) round the vertex at `slot`, this side of creases.
template <class Visit>
void for_each_triangle(const AsSurface& surface, std::uint32_t slot, Vector3 normal, const Visit& visit) {
  std::uint32_t copy = slot;
  for (std::uint32_t i = 0; i < kMostCopies; ++i) {
    const Vector3 other = direction(surface.geometry(copy).normals, 3, surface.local(copy));
    for (std::uint32_t corner = dot(normal, other) > kSmooth || copy == slot ? surface.first_corner(copy) : kNoNumber;
         corner != kNoNumber; corner = surface.next_corner(corner)) {
      std::uint32_t opposite[2];
      surface.opposite(copy, corner, opposite);
      visit(opposite[0], opposite[1]);
    }
    copy = surface.next_copy(copy);
    if (copy == slot) return;
  }
}

// Two perpendicular unit vectors with first × second the normal; the first along the texture's tangent, if there is
// one.
struct Frame {
  Vector3 normal, axis[2];
};

Frame frame_of(const Geometry& g, std::uint32_t slot) {
  const Vector3 normal = direction(g.normals, 3, slot);
  const Vector3 tangent = g.tangents != nullptr ? direction(g.tangents, 4, slot) : Vector3{};
  const Linear<float> axes = right_angles(normal, tangent, [&normal](const Vector3& along) {
    const Vector3 some = length(along) > 1e-3f ? along : across_least_axis(normal);
    const float l = length(some);
    return l > 0 ? some * (1 / l) : Vector3{};
  });
  return {axes.x, {axes.y, axes.z}};
}
// τ_aj of both tangents, of each influence of the run.
using Tangents = float[2][kMaxInfluences][4];

class Derivation {
 public:
  Derivation(const AsSurface& surface, std::uint32_t slot)
      : surface_(surface), slot_(slot), stand_ins_(surface, slot, vertex_) {
    surface_.read(slot, vertex_);
  }

  // Derivatives along the frame's axes on the bind pose's surface, triangles weighted by area. In the bind pose they
  // differ from the axes, as an artist's normal is not the triangles' normal and a ring of triangles is not flat. The
  // difference goes through the blended matrix. So residuals tilt normals, and a vertex without area has the blend's.
  void run(const Frame& frame, Tangents& out) {
    for (auto& tangent : out)
      for (auto& tau : tangent)
        for (float& c : tau) c = 0;
    const Vector3 v = position_of(slot_);
    Vector3 normal;
    float areas = 0;
    for_each_triangle(surface_, slot_, frame.normal, [&](std::uint32_t k, std::uint32_t l) {
      const Vector3 doubled = cross(position_of(k) - v, position_of(l) - v);
      normal = normal + doubled;
      areas += length(doubled);
    });
    Vector3 lacks[2] = {frame.axis[0], frame.axis[1]};
    const float area = length(normal);
    if (area > kFlat * areas) {
      const Vector3 across[2] = {cross(normal * (1 / area), frame.axis[0]), cross(normal * (1 / area), frame.axis[1])};
      for_each_triangle(surface_, slot_, frame.normal, [&](std::uint32_t k, std::uint32_t l) {
        const Vector3 to_k = position_of(k) - v, to_l = position_of(l) - v;
        const float of_k[2] = {dot(to_l, across[0]) / area, dot(to_l, across[1]) / area};
        const float of_l[2] = {-dot(to_k, across[0]) / area, -dot(to_k, across[1]) / area};
        for (int a = 0; a < 2; ++a) lacks[a] = lacks[a] - to_k * of_k[a] - to_l * of_l[a];
        add(k, of_k, out);
        add(l, of_l, out);
      });
    }
    for (int a = 0; a < 2; ++a) add_blend(lacks[a], out[a]);
  }

 private:
  Vector3 position_of(std::uint32_t slot) const {
    const float* p = surface_.position(slot);
    return {p[0], p[4], p[8]};
  }

  // Adds a neighbour's coordinates less the vertex's, expressed in the vertex's entries, times one factor per tangent.
  void add(std::uint32_t neighbour, const float (&factors)[2], Tangents& out) {
    float q[kMaxInfluences][4];
    for (std::uint32_t j = 0; j < vertex_.influences; ++j)
      for (int c = 0; c < 4; ++c) q[j][c] = -vertex_.q[j][c];
    stand_ins_.add(neighbour, q);
    for (std::uint32_t j = 0; j < vertex_.influences; ++j)
      for (int c = 0; c < 4; ++c) {
        out[0][vertex_.place[j]][c] += factors[0] * q[j][c];
        out[1][vertex_.place[j]][c] += factors[1] * q[j][c];
      }
  }

  // A direction through the blended matrix.
  void add_blend(Vector3 direction, float (&tau)[kMaxInfluences][4]) const {
    for (std::uint32_t j = 0; j < vertex_.influences; ++j) {
      float(&to)[4] = tau[vertex_.place[j]];
      to[0] += vertex_.q[j][3] * direction.x;
      to[1] += vertex_.q[j][3] * direction.y;
      to[2] += vertex_.q[j][3] * direction.z;
    }
  }

  const AsSurface& surface_;
  std::uint32_t slot_;
  AsVertex vertex_;
  StandIns stand_ins_;
};

// Writes one lane of a block. The block holds Σ_j of both tangents, x[4] y[4] z[4] each, then for each influence but
// the last both tangents, x[4] y[4] z[4] w[4] each.
void write(const Tangents& tangents, std::uint32_t influences, float* to) {
  for (int a = 0; a < 2; ++a, to += 12) {
    for (std::size_t c = 0; c < 3; ++c) {
      float sum = 0;
      for (std::uint32_t j = 0; j < influences; ++j) sum += tangents[a][j][c];
      to[4 * c] = sum;
    }
  }
  for (std::uint32_t j = 0; j + 1 < influences; ++j)
    for (int a = 0; a < 2; ++a, to += 16)
      for (std::size_t c = 0; c < 4; ++c) to[4 * c] = tangents[a][j][c];
}

}  // namespace

std::size_t as_tangent_count(const Geometry& geometry) {
  return 2 * as_coordinate_count(geometry);
}

std::size_t as_tangent_scratch_bytes(Span<const AsPart> parts) {
  return AsSurface::bytes(parts);
}

Status as_tangents(Span<const AsPart> parts, Span<std::byte> scratch) {
  MARROW_ZONE;
  MARROW_REQUIRE(holds(parts));
  for (const AsPart& part : parts) {
    MARROW_REQUIRE(part.mesh != nullptr && part.mesh->geometry.normals != nullptr);
    MARROW_REQUIRE(part.mesh->geometry.joint_count <= part.mesh->palette_size() && "the mesh's own geometry");
    MARROW_REQUIRE(holds(part.coordinates, as_coordinate_count(part.mesh->geometry)));
    MARROW_REQUIRE(holds(part.tangents, as_tangent_count(part.mesh->geometry)));
  }
  MARROW_REQUIRE(holds(scratch, as_tangent_scratch_bytes(parts)));
  MARROW_REQUIRE(reinterpret_cast<std::uintptr_t>(scratch.data) % alignof(std::uint32_t) == 0);
  const AsSurface surface(parts, scratch);
  for (std::uint32_t slot = 0; slot < surface.slot_count(); ++slot) {
    const Frame frame = frame_of(surface.geometry(slot), surface.local(slot));
    Tangents tangents;
    Derivation(surface, slot).run(frame, tangents);
    const AsSurface::Block& block = surface.block(slot);
    write(tangents, block.influences, surface.part(slot).tangents.data + 2 * std::size_t{block.coordinates} + slot % 4);
  }
  return Status::ok;
}

}  // namespace marrow
