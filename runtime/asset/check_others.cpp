// What is asked of the other sections beyond their descriptions.
#include <cstring>

#include "asset/checker.h"

namespace marrow {
namespace {

// In breadth-first order, parents before children.
void check_joints(Checker& c, Span<const std::uint16_t> parents, Span<const std::uint32_t> names,
                  std::uint32_t root_count) {
  for (std::uint32_t j = 0; j < parents.size && c.good(); ++j) {
    if (j < root_count ? parents[j] != kNoJoint : parents[j] >= j) c.fail(&parents[j], "parents come before children");
    if (j > root_count && parents[j] < parents[j - 1]) c.fail(&parents[j], "joints are breadth-first");
    c.name({}, names[j]);
  }
}

// An image that every decoder knows, so that it needs none itself. It may stand behind this one, unchecked as yet.
bool check_fallback(Checker& c, const format::ImageHeader& h) {
  if (h.format <= ImageFormat::jpeg) return c.fail(&h.fallback, "a fallback of a PNG or JPEG image");
  if (h.fallback > c.count_of(format::kImages)) return c.fail(&h.fallback, "no such image");
  const std::uint32_t image = h.fallback - 1u;
  return (c.bytes_of(format::kImages, image) >= sizeof h &&
          c.nth<format::ImageHeader>(format::kImages, image).format <= ImageFormat::jpeg) ||
         c.fail(&h.fallback, "a fallback that is no PNG or JPEG image");
}

// A text's number is short; else it is finite, and 0 or 1 of a truth.
bool check_property(Checker& c, const Property& p) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &p.number, sizeof bits);
  if (p.type == PropertyType::text) {
    if (bits >> 32 != 0) return c.fail(&p.number, "reserved must be 0");
    c.text({}, p.text);
    return c.good();
  }
  constexpr std::uint64_t kInfinite = 0x7FF0000000000000;
  if ((bits & ~(std::uint64_t{1} << 63)) >= kInfinite) return c.fail(&p.number, kNotFinite);
  return p.type == PropertyType::number || bits == 0 || bits == bit_cast<std::uint64_t>(1.0) ||
         c.fail(&p.number, "a boolean is 0 or 1");
}

bool is_box(const format::BoundsCodes& codes) {
  if (codes.exponent < format::kLeastBoundsExponent || codes.exponent > format::kMostBoundsExponent) return false;
  for (int axis = 0; axis < 3; ++axis)
    if (codes.box_min[axis] > codes.box_max[axis]) return false;
  return true;
}

}  // namespace

void check(Checker& c, const format::SkeletonHeader& h) {
  format::SkeletonLayout l;
  if (check_fields(c, h, l)) check_joints(c, c.in(l.parents), c.in(l.names), h.root_count);
}

void check(Checker& c, const format::ReferenceHeader& h) {
  if (c.count_of(format::kSkeletons) != 0) c.fail(&h, "skeletons or references, not both");
  format::ReferenceLayout l;
  if (!check_fields(c, h, l)) return;
  const Span<const std::uint16_t> parents = c.in(l.parents);
  std::uint32_t roots = 0;
  while (roots < h.joint_count && parents[roots] == kNoJoint) ++roots;
  if (roots == 0) c.fail(parents.data, "the first joint has no parent");
  check_joints(c, parents, c.in(l.names), roots);
}

void check(Checker& c, const format::MaterialHeader& h) {
  format::MaterialLayout l;
  if (!check_fields(c, h, l)) return;
  std::uint32_t roles = 0;
  for (const Texture& t : c.in(l.textures)) {
    const std::uint32_t role = 1u << static_cast<std::uint32_t>(t.role);
    if ((roles & role) != 0) c.fail(&t.role, "a role twice in one material");
    roles |= role;
  }
}

void check(Checker& c, const format::ImageHeader& h) {
  format::ImageLayout l;
  if (!check_fields(c, h, l)) return;
  if (h.byte_count != 0 && h.format == ImageFormat::unknown) c.fail(&h.format, "bytes of an unknown format");
  if (h.fallback != 0) check_fallback(c, h);
}

void check(Checker& c, const format::NodeHeader& h) {
  format::NodeLayout l;
  if (!check_fields(c, h, l)) return;
  for (const Property& p : c.in(l.properties))
    if (!check_property(c, p)) return;
}

void check(Checker& c, const format::LimitHeader& h) {
  format::LimitLayout l;
  if (!check_fields(c, h, l)) return;
  const Span<const JointLimit> limits = c.in(l.limits);
  for (const JointLimit* limit = limits.begin(); limit != limits.end() && c.good(); ++limit) {
    if (limit != limits.begin() && limit->joint <= limit[-1].joint) c.fail(limit, "limits ascend by joint");
    if (!is_valid(*limit)) c.fail(limit, "no limit of a joint");
  }
}

void check(Checker& c, const format::BoundsHeader& h) {
  format::BoundsLayout l;
  if (!check_fields(c, h, l)) return;
  for (const format::BoundsCodes& codes : c.in(l.codes))
    if (!is_box(codes)) {
      c.fail(&codes, "no box");
      return;
    }
}

}  // namespace marrow
