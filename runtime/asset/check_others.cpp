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

bool Checker::keeps_of_others(Check check) {
  using namespace format;
  switch (check) {
    case Check::joints:
      return joints(array<std::uint16_t>(MARROW_PLACE(SkeletonLayout, parents)),
                    array<std::uint32_t>(MARROW_PLACE(SkeletonLayout, names)), header<SkeletonHeader>().root_count);
    case Check::reference_joints:
      return reference_joints();
    case Check::rotations:
      for (const float& x : record<SoaTransform>().rotation[0])
        if (!(dot_of_rotations(&x, &x, 4) >= kShortestSquare)) return false;
      return true;
    case Check::role: {
      const std::uint32_t role = 1u << static_cast<std::uint32_t>(record<Texture>().role), before = so_far_.roles;
      so_far_.roles |= role;
      return (before & role) == 0;
    }
    case Check::fallback:
      return fallback();
    case Check::truth: {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &record<Property>().number, sizeof bits);
      return bits == 0 || bits == bit_cast<std::uint64_t>(1.0);
    }
    case Check::only_of_owner:
      return only_of_owner();
    case Check::ascends:
      return base(From::record) == array<JointLimit>(MARROW_PLACE(LimitLayout, limits)) ||
             record<JointLimit>().joint > (&record<JointLimit>() - 1)->joint;
    case Check::limit:
      return is_valid(record<JointLimit>());
    case Check::box:
      return box();
    case Check::chain_order: {
      const auto& chain = record<SpringRecord>();
      return chain.first_joint == so_far_.next_joint && chain.joint_count != 0 &&
             chain.joint_count <= header<SpringHeader>().joint_count - so_far_.next_joint;
    }
    case Check::chain_colliders: {
      const std::uint32_t count = header<SpringHeader>().collider_count;
      return count == kMaxSpringColliders || record<SpringRecord>().colliders >> count == 0;
    }
    case Check::bone: {
      const auto& chain = record<SpringRecord>();
      return chain.joint_count != 1 || chain.tip[0] != 0 || chain.tip[1] != 0 || chain.tip[2] != 0;
    }
    case Check::chain_joints:
      return chain_joints();
    default:
      return so_far_.next_joint == header<SpringHeader>().joint_count;
  }
}

}  // namespace marrow
