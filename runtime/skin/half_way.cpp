#include "skin/half_way.h"

#include "math/rotation.h"

namespace marrow {
namespace {

// What bind takes to the origin: the joint in the bind pose. False if nothing, or much.
bool bind_place(const Affine& bind, Vector3& out) {
  const Linear<float> m = linear(bind), cofactor = cofactors(m);
  const float volume = dot(m.x, cofactor.x);
  out = transposed_times(cofactor, origin(bind)) * (-1.0f / volume);
  return volume != 0.0f && dot(out, out) < 1e30f;
}

}  // namespace

Affine half_way(const Affine& parent, const Affine& joint, const Affine& bind, float share) {
  Linear<float> a, b;
  Vector3 centre;
  const Linear<float> from_parent = linear(parent), from_joint = linear(joint);
  if (!rotation_of(from_parent, a) || !rotation_of(from_joint, b) || !bind_place(bind, centre)) return joint;
  const Linear<float> p = transposed_times(a, from_parent), j = transposed_times(b, from_joint);
  const float rest = 1.0f - share;
  const Linear<float> stretch = {p.x * rest + j.x * share, p.y * rest + j.y * share, p.z * rest + j.z * share};
  const Linear<float> m = a * slerp_share_of(transposed_times(a, b), share) * stretch;
  const Vector3 moved = transform(parent, centre) * rest + transform(joint, centre) * share;
  return affine(m, moved - m * centre);
}

}  // namespace marrow
