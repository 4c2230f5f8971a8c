// Rules of the other sections that are code.
#include "asset/checker.h"

namespace marrow {

using format::layout;

// In breadth-first order, parents before children. names: which array they are; parents stand before the end.
bool Checker::joints(const std::uint16_t* parents, const std::uint32_t* joint_names, std::uint32_t root_count) {
  const std::uint32_t count = header<format::SkeletonHeader>().joint_count;  // a reference's, too
  for (std::uint32_t j = 0; j < count; ++j) {
    if (j < root_count ? parents[j] != kNoParent : parents[j] >= j)
      return fail(parents + j, "parents come before children");
    if (j > root_count && parents[j] < parents[j - 1]) return fail(parents + j, "joints are breadth-first");
    if (!name(joint_names[j])) return false;
  }
  return true;
}

bool Checker::reference_joints() {
  const auto* const parents = array<std::uint16_t>(MARROW_PLACE(ReferenceLayout, parents));
  std::uint32_t roots = 0;
  while (roots < header<format::ReferenceHeader>().joint_count && parents[roots] == kNoParent) ++roots;
  if (roots == 0) return fail(parents, "the first joint has no parent");
  return joints(parents, array<std::uint32_t>(MARROW_PLACE(ReferenceLayout, names)), roots);
}

// An image that every decoder knows, so that it needs none itself. It may stand behind this one, unchecked as yet.
bool Checker::fallback() {
  const auto& h = header<format::ImageHeader>();
  if (h.format <= ImageFormat::jpeg) return fail(&h.fallback, "a fallback of a PNG or JPEG image");
  if (h.fallback > counts_[format::kImages]) return fail(&h.fallback, "no such image");
  const File::Section& s = nth(format::kImages, h.fallback - 1u);
  return s.bytes >= sizeof h && at<format::ImageHeader>(start_of(s), 0)->format <= ImageFormat::jpeg;
}

// Of a section that begins with the number of a skeleton, which has one section of this type.
bool Checker::only_of_owner() {
  const auto& number = header<std::uint32_t>();
  if (!find_owner(number, false)) return fail(&number, "no such skeleton");
  const File::Section& before = section_[-1];  // of a skeleton, if of no other
  return before.type != section_->type || *at<std::uint32_t>(start_of(before), 0) < number;
}

bool Checker::box() const {
  const auto& codes = record<format::BoundsCodes>();
  if (codes.exponent < format::kLeastBoundsExponent || codes.exponent > format::kMostBoundsExponent) return false;
  for (int c = 0; c < 3; ++c)
    if (codes.box_min[c] > codes.box_max[c]) return false;
  return true;
}

}  // namespace marrow
