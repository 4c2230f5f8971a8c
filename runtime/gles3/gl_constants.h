// The few OpenGL ES 3.0 enumerants that marrow::gles3 names, from the specification's tables.
#pragma once

namespace marrow::gles3 {

enum GlEnum : unsigned {
  kGlNoError = 0,
  kGlTriangles = 0x0004,
  kGlByte = 0x1400,
  kGlUnsignedByte = 0x1401,
  kGlShort = 0x1402,
  kGlUnsignedShort = 0x1403,
  kGlUnsignedInt = 0x1405,
  kGlFloat = 0x1406,
  kGlTexture2d = 0x0DE1,
  kGlNearest = 0x2600,
  kGlTextureMagFilter = 0x2800,
  kGlTextureMinFilter = 0x2801,
  kGlTexture0 = 0x84C0,
  kGlRgba16i = 0x8D88,
  kGlRgbaInteger = 0x8D99,
  kGlVersion = 0x1F02,
  kGlMajorVersion = 0x821B,
  kGlMaxVertexAttribs = 0x8869,
  kGlArrayBuffer = 0x8892,
  kGlElementArrayBuffer = 0x8893,
  kGlStaticDraw = 0x88E4,
  kGlStreamDraw = 0x88E0,
  kGlUniformBuffer = 0x8A11,
  kGlMaxUniformBlockSize = 0x8A30,
  kGlUniformBufferOffsetAlignment = 0x8A34,
  kGlInvalidIndex = 0xFFFFFFFFu,
  kGlFragmentShader = 0x8B30,
  kGlVertexShader = 0x8B31,
  kGlCompileStatus = 0x8B81,
  kGlLinkStatus = 0x8B82,
  kGlInterleavedAttribs = 0x8C8C,
};

}  // namespace marrow::gles3
