// Every frame: palettes to the GPU, in a uniform buffer or in a texture.
#pragma once

#include "marrow/gles3.h"

namespace marrow::gles3 {

// Matrices in the uniform block of the programs: as many as fit the smallest block that GLES 3.0 allows.
inline constexpr std::uint32_t kPaletteJoints = 341;
// Bytes of that block.
inline constexpr std::uint32_t kPaletteBlockBytes = kPaletteJoints * 48;

// One buffer that holds all palettes of a frame, each at an offset that the driver accepts. Every frame the old
// contents are orphaned, so the CPU never waits for the GPU.
struct PaletteRing {
  std::uint32_t buffer = 0;       // a uniform buffer; 0: none
  std::uint32_t alignment = 256;  // of offsets, bytes
  std::uint32_t capacity = 0;     // bytes that palettes may use
  std::uint32_t used = 0;         // bytes, since begin_frame()
};

// Room for palettes of `joints` matrices altogether in `palettes` pieces.
// Errors: bad_argument (zero); unsupported (caps of less than OpenGL ES 3.0); gl_error. Leaves GL_UNIFORM_BUFFER at 0.
Status create_palette_ring(const Api& api, const Caps& caps, std::uint32_t joints, std::uint32_t palettes,
                           PaletteRing& out);
// Deletes the buffer and clears the struct.
void destroy(const Api& api, PaletteRing& ring);

// Drops the last frame's palettes. Leaves GL_UNIFORM_BUFFER bound to the ring.
void begin_frame(const Api& api, PaletteRing& ring);

// Uploads one palette (48 bytes a matrix, nothing else) and says where it lies. Leaves GL_UNIFORM_BUFFER bound to the
// ring. Errors: bad_argument (empty, or more than kPaletteJoints); unsupported (the ring is full until begin_frame).
Status push_palette(const Api& api, PaletteRing& ring, Span<const Affine> palette, std::uint32_t& offset);

// Ties the palette at `offset` to uniform buffer binding `binding`.
void bind_palette(const Api& api, const PaletteRing& ring, std::uint32_t offset, std::uint32_t binding);

// Texels a row of the texture: what GLES 3.0 promises.
inline constexpr std::uint32_t kPaletteTextureWidth = 2048;

// All palettes of a frame in an RGBA32F texture, a texel a row of a matrix. Three textures take turns, each written
// every third frame, so that the driver need not wait for a texture that it still draws from, or copy it.
struct PaletteTexture {
  std::uint32_t textures[3] = {};    // 0: none
  std::uint32_t current = 0;         // which was written last
  std::uint32_t capacity = 0;        // matrices
  std::uint32_t count = 0;           // matrices in the current texture
  std::uint32_t previous_count = 0;  // matrices in the previous frame's texture
};

// Room for `joints` matrices: 48 B each, three times.
// Errors: bad_argument (zero); unsupported (more than a texture of the caps' size holds: 1.39 million in 2048²);
// gl_error. Leaves the active unit's 2D texture at 0.
Status create_palette_texture(const Api& api, const Caps& caps, std::uint32_t joints, PaletteTexture& out);
// Deletes the textures and clears the struct.
void destroy(const Api& api, PaletteTexture& texture);

// Once a frame: uploads all palettes, one after the other, those of one mesh's instances together. build_palette() may
// write straight into such an array. 48 bytes a matrix go up, and nothing else. Errors: bad_argument (empty);
// unsupported (more than there is room for). Leaves the active unit's 2D texture at 0, GL_PIXEL_UNPACK_BUFFER must be
// 0.
Status upload_palettes(const Api& api, PaletteTexture& texture, Span<const Affine> palettes);

// Lets `program` draw with uploaded palettes: instance i takes the one that begins at matrix first + joints · i. The
// program must be in use and read palettes from a texture. Leaves `texture_unit` active and the texture bound to it.
// Errors: bad_argument (a program of another kind, a palette that reaches beyond what was uploaded).
Status bind_palette(const Api& api, const PaletteTexture& texture, std::uint32_t first, std::uint32_t joints,
                    std::uint32_t texture_unit, const Program& program);

// Binds the palettes of the previous frame, which are still there, for a program with kMotion. Pass the same arguments
// as to bind_palette(). kept: false for characters that the previous frame did not have; this frame's palettes are then
// bound in place of the previous ones, and nothing moves. Leaves `texture_unit` active and the texture bound to it.
// Nothing is bound for a program whose text does not read previous_position. Errors: bad_argument (a program of another
// kind, a palette that reaches beyond what was uploaded in that frame).
Status bind_previous_palette(const Api& api, const PaletteTexture& texture, std::uint32_t first, std::uint32_t joints,
                             bool kept, std::uint32_t texture_unit, const Program& program);

// create_palette_texture() of some joints, with a name for labels.
Status make_palette_texture(const Api& api, const Caps& caps, std::uint32_t joints, const char* name,
                            PaletteTexture& out);

}  // namespace marrow::gles3
