// Every frame: palettes into one uniform buffer, at offsets that the driver accepts.
#include "core/check.h"
#include "core/zone.h"
#include "gles3/errors.h"
#include "gles3/gl_constants.h"
#include "gles3/gl_size.h"
#include "gles3/label.h"
#include "gles3/palettes.h"

namespace marrow::gles3 {
namespace {

std::uint32_t round_up(std::uint32_t value, std::uint32_t alignment) {
  return (value + alignment - 1) / alignment * alignment;
}

// The block that a program reads is always kPaletteBlockBytes long, so the last palette needs that much behind its
// start.
std::ptrdiff_t ring_bytes(const PaletteRing& ring) {
  return gl_size(std::uint64_t{ring.capacity} + kPaletteBlockBytes);
}

}  // namespace

Status create_palette_ring(const Api& api, const Caps& caps, std::uint32_t joints, std::uint32_t palettes,
                           PaletteRing& out) {
  MARROW_REQUIRE(joints > 0 && joints <= 0x02000000u);
  MARROW_REQUIRE(palettes > 0 && palettes <= 0x00200000u);
  MARROW_REQUIRE(caps.uniform_offset_alignment > 0);
  if (caps.uniform_block_bytes < kPaletteBlockBytes) return Status::unsupported;
  PaletteRing ring;
  ring.alignment = caps.uniform_offset_alignment;
  ring.capacity = 48 * joints + ring.alignment * palettes;
  forget_errors(api);
  api.GenBuffers(1, &ring.buffer);
  api.BindBuffer(kGlUniformBuffer, ring.buffer);
  api.BufferData(kGlUniformBuffer, ring_bytes(ring), nullptr, kGlStreamDraw);
  api.BindBuffer(kGlUniformBuffer, 0);
  if (api.GetError() != kGlNoError) {
    destroy(api, ring);
    return Status::gl_error;
  }
  label(api, kGlBuffer, ring.buffer, {"marrow: palettes"});
  out = ring;
  return Status::ok;
}

void destroy(const Api& api, PaletteRing& ring) {
  api.DeleteBuffers(1, &ring.buffer);
  ring = {};
}

void begin_frame(const Api& api, PaletteRing& ring) {
  ring.used = 0;
  api.BindBuffer(kGlUniformBuffer, ring.buffer);
  api.BufferData(kGlUniformBuffer, ring_bytes(ring), nullptr, kGlStreamDraw);
}

Status push_palette(const Api& api, PaletteRing& ring, Span<const Affine> palette, std::uint32_t& offset) {
  MARROW_ZONE;
  MARROW_REQUIRE(holds(palette, 1) && palette.size <= kPaletteJoints);
  MARROW_REQUIRE(ring.alignment > 0 && "a ring from create_palette_ring()");
  const std::uint32_t bytes = 48 * static_cast<std::uint32_t>(palette.size);
  const std::uint32_t start = round_up(ring.used, ring.alignment);
  if (start > ring.capacity || bytes > ring.capacity - start) return Status::unsupported;
  api.BindBuffer(kGlUniformBuffer, ring.buffer);
  api.BufferSubData(kGlUniformBuffer, gl_size(start), gl_size(bytes), palette.data);
  ring.used = start + bytes;
  offset = start;
  return Status::ok;
}

void bind_palette(const Api& api, const PaletteRing& ring, std::uint32_t offset, std::uint32_t binding) {
  api.BindBufferRange(kGlUniformBuffer, binding, ring.buffer, gl_size(offset), gl_size(kPaletteBlockBytes));
}

}  // namespace marrow::gles3
