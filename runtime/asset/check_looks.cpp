// Rules of MATL, IMAG and NODE sections.
#include "asset/checker.h"

namespace marrow {

using format::layout;

bool Checker::texture(const Texture& t, std::uint32_t& roles) {
  if (t.image >= counts_[format::kImages]) return fail(&t, "no such image");
  if (t.role > TextureRole::specular_glossiness) return fail(&t.role, "unknown role of a texture");
  if (t.wrap_u > Wrap::mirrored_repeat || t.wrap_v > Wrap::mirrored_repeat) return fail(&t.wrap_u, "unknown wrap mode");
  if (t.mag > MagFilter::linear || t.min > MinFilter::linear_mipmap_linear) return fail(&t.mag, "unknown filter");
  if (t.reserved != 0) return fail(&t.reserved, "reserved must be 0");
  const std::uint32_t role = 1u << static_cast<std::uint32_t>(t.role);
  if ((roles & role) != 0) return fail(&t.role, "a role twice in one material");
  roles |= role;
  return true;
}

bool Checker::material(const File::Section& s) {
  const auto* h = header<format::MaterialHeader>(s);
  if (h == nullptr) return false;
  if (h->flags > format::kAllMaterialFlags) return fail(&h->flags, "unknown flags of a material");
  if (h->alpha > AlphaMode::blend) return fail(&h->alpha, "unknown alpha mode");
  if (!name(h->name) || !finite(&h->alpha_cutoff, 4)) return false;
  if (!(h->alpha_cutoff >= 0)) return fail(&h->alpha_cutoff, "a cutoff is not negative");
  const format::MaterialLayout l = layout(*h);
  if ((h->flags & format::kEmits) != 0) {
    const auto* emissive = at<float>(h, l.emissive);
    if (!finite(emissive, 12)) return false;
    for (int c = 0; c < 3; ++c)
      if (!(emissive[c] >= 0)) return fail(emissive + c, "light that is emitted is not negative");
  }
  std::uint32_t roles = 0;
  for (const Texture& t : Span<const Texture>{at<Texture>(h, l.textures), h->texture_count})
    if (!texture(t, roles)) return false;
  return true;
}

bool Checker::image(const File::Section& s) {
  const auto* h = header<format::ImageHeader>(s);
  if (h == nullptr) return false;
  if (h->reserved != 0) return fail(&h->reserved, "reserved must be 0");
  if (h->format > ImageFormat::dds) return fail(&h->format, "unknown format of an image");
  if (h->byte_count > 0 && h->format == ImageFormat::unknown) return fail(&h->format, "bytes of an unknown format");
  return fallback(*h) && name(h->name) && text(h->uri);
}

// An image that every decoder knows, so that it needs none itself. It may stand behind this one, unchecked as yet.
bool Checker::fallback(const format::ImageHeader& h) {
  if (h.fallback == 0) return true;
  if (h.format <= ImageFormat::jpeg) return fail(&h.fallback, "a fallback of a PNG or JPEG image");
  if (h.fallback > counts_[format::kImages]) return fail(&h.fallback, "no such image");
  const File::Section& s = nth(format::kImages, h.fallback - 1u);
  if (s.bytes < sizeof h || at<format::ImageHeader>(s, 0)->format > ImageFormat::jpeg)
    return fail(&h.fallback, "a fallback that is no PNG or JPEG image");
  return true;
}

bool Checker::property(const Property& p) {
  if ((p.reserved[0] | p.reserved[1] | p.reserved[2]) != 0) return fail(p.reserved, "reserved must be 0");
  if (p.type > PropertyType::text) return fail(&p.type, "unknown type of a property");
  if (!text(p.name)) return false;
  std::uint64_t bits = 0;
  std::memcpy(&bits, &p.number, sizeof bits);
  if (p.type == PropertyType::text) return bits >> 32 != 0 ? fail(&p.number, "reserved must be 0") : text(p.text);
  if ((bits >> 52 & 0x7FF) == 0x7FF) return fail(&p.number, "a number that is not finite");
  const bool truth = p.type == PropertyType::boolean;
  return !truth || bits == 0 || p.number == 1 || fail(&p.number, "a boolean is 0 or 1");
}

bool Checker::node(const File::Section& s) {
  const auto* h = header<format::NodeHeader>(s);
  if (h == nullptr) return false;
  if (h->reserved != 0) return fail(&h->reserved, "reserved must be 0");
  const auto* skeleton = skeleton_of(h->skeleton);
  if (skeleton == nullptr) return false;
  if (h->joint != kNoJoint && h->joint >= skeleton->joint_count) return fail(&h->joint, "a joint outside the skeleton");
  if (!name(h->name) || !bounded(&h->joint_from_node, sizeof h->joint_from_node)) return false;
  for (const Property& p : Span<const Property>{at<Property>(h, layout(*h).properties), h->property_count})
    if (!property(p)) return false;
  return true;
}

}  // namespace marrow
