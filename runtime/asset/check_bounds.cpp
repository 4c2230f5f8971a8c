// Rules of BNDS sections.
#include "asset/checker.h"

namespace marrow {
namespace {

bool is_box(const format::BoundsCodes& codes) {
  if (codes.exponent < format::kLeastBoundsExponent || codes.exponent > format::kMostBoundsExponent) return false;
  for (int c = 0; c < 3; ++c)
    if (codes.box_min[c] > codes.box_max[c]) return false;
  return true;
}

}  // namespace

bool Checker::bounds(const File::Section& s) {
  const auto* h = header<format::BoundsHeader>(s);
  if (h == nullptr || only_of_skeleton(s, "one section of bounds a skeleton, in their order") == nullptr) return false;
  // Small enough, too, for their product.
  if (h->clip_count == 0 || h->clip_count > counts_[format::kClips])
    return fail(&h->clip_count, "1 to as many as clips");
  if (h->mesh_count == 0 || h->mesh_count > counts_[format::kMeshes])
    return fail(&h->mesh_count, "1 to as many as meshes");
  const auto* codes = at<format::BoundsCodes>(h, format::layout(*h).codes);
  for (std::uint64_t i = 0; i < std::uint64_t{h->clip_count} * h->mesh_count; ++i)
    if (!is_box(codes[i])) return fail(codes + i, "no box");
  return true;
}

}  // namespace marrow
