// A mesh for crowds: its palettes of all frames in a texture, and a texture to render those of the instances to.
#include <cstring>

#include "gles3/crowd.h"
#include "gles3/errors.h"
#include "gles3/gl_constants.h"
#include "gles3/label.h"
#include "gles3/texture.h"
#include "marrow/palette.h"

namespace marrow::gles3 {
namespace {

constexpr std::uint32_t kWidth = kPaletteTextureWidth;
// Three lines hold as many matrices as a line has texels.
constexpr std::uint32_t kChunk = kWidth;
constexpr std::uint32_t kChunkLines = 3;

std::uint32_t lines_of(std::uint64_t palettes, std::uint32_t joints) {
  return static_cast<std::uint32_t>((3 * palettes * joints + kWidth - 1) / kWidth);
}

void put_lines(const Api& api, std::uint32_t line, std::uint32_t lines, const Affine* matrices) {
  api.TexSubImage2D(kGlTexture2d, 0, 0, static_cast<int>(line), static_cast<int>(kWidth), static_cast<int>(lines),
                    kGlRgba, kGlFloat, matrices);
}

// Palettes of all frames into the texture that is bound, three lines at a time.
void put_frames(const Api& api, const Mesh& mesh, Span<const Affine> bind, const CrowdFrames& frames,
                Span<Affine> scratch) {
  const std::uint32_t size = mesh.palette_size();
  std::uint32_t filled = 0, line = 0;
  for (std::uint32_t frame = 0; frame < frames.frame_count; ++frame) {
    const Span<const Affine> joints(frames.character_from_joint.data + std::size_t{frame} * frames.joint_count,
                                    frames.joint_count);
    static_cast<void>(
        build_palette({mesh.joints, mesh.joint_count}, bind, joints, {scratch.data + filled, size}, mesh.half_joints));
    filled += size;
    for (; filled >= kChunk; filled -= kChunk, line += kChunkLines) {
      put_lines(api, line, kChunkLines, scratch.data);
      std::memmove(scratch.data, scratch.data + kChunk, (filled - kChunk) * sizeof(Affine));
    }
  }
  if (filled == 0) return;
  std::memset(scratch.data + filled, 0, (kChunk - filled) * sizeof(Affine));
  put_lines(api, line, lines_of(1, filled), scratch.data);
}

}  // namespace

std::uint32_t crowd_palettes_that_fit(const Caps& caps, std::uint32_t joints) {
  if (joints == 0 || caps.texture_size < kWidth) return 0;
  return static_cast<std::uint32_t>(std::uint64_t{kWidth} * caps.texture_size / (std::uint64_t{3} * joints));
}

std::size_t crowd_mesh_scratch_size(const Mesh& mesh) {
  return kChunk + mesh.palette_size();
}

Status create_crowd_mesh(const Api& api, const Caps& caps, const Mesh& mesh, Span<const Affine> bind,
                         const CrowdFrames& frames, std::uint32_t capacity, Span<Affine> scratch, CrowdMesh& out) {
  if (capacity == 0 || frames.frame_count == 0 || mesh.joint_count == 0) return Status::bad_argument;
  if (check_frames(frames) != Status::ok) return Status::bad_argument;
  if (bind.size < mesh.joint_count || scratch.size < crowd_mesh_scratch_size(mesh)) return Status::bad_argument;
  for (std::uint32_t i = 0; i < mesh.joint_count; ++i)
    if (mesh.joints[i] >= frames.joint_count) return Status::bad_argument;
  if (!mesh.geometry.targets.empty()) return Status::unsupported;
  CrowdMesh made;
  made.joints = mesh.palette_size();
  made.frame_count = frames.frame_count;
  made.capacity = capacity;
  const std::uint32_t fit = crowd_palettes_that_fit(caps, made.joints);
  if (made.frame_count > fit || capacity > fit) return Status::unsupported;

  forget_errors(api);
  made.frames_texture =
      make_texture(api, kGlRgba32f, kGlRgba, kGlFloat, kWidth, lines_of(made.frame_count, made.joints));
  put_frames(api, mesh, bind, frames, scratch);
  made.blended_texture =
      make_texture(api, kGlRgba32ui, kGlRgbaInteger, kGlUnsignedInt, kWidth, lines_of(capacity, made.joints));
  api.BindTexture(kGlTexture2d, 0);
  api.GenFramebuffers(1, &made.framebuffer);
  api.BindFramebuffer(kGlFramebuffer, made.framebuffer);
  api.FramebufferTexture2D(kGlFramebuffer, kGlColorAttachment0, kGlTexture2d, made.blended_texture, 0);
  const bool complete = api.CheckFramebufferStatus(kGlFramebuffer) == kGlFramebufferComplete;
  api.BindFramebuffer(kGlFramebuffer, 0);
  if (api.GetError() != kGlNoError || !complete) {
    destroy(api, made);
    return Status::gl_error;
  }
  label(api, kGlTexture, made.frames_texture, {label_of(mesh), ": frames"});
  label(api, kGlTexture, made.blended_texture, {label_of(mesh), ": blended palettes"});
  label(api, kGlFramebuffer, made.framebuffer, {label_of(mesh), ": blended palettes"});
  out = made;
  return Status::ok;
}

void destroy(const Api& api, CrowdMesh& mesh) {
  const std::uint32_t textures[] = {mesh.frames_texture, mesh.blended_texture};
  api.DeleteFramebuffers(1, &mesh.framebuffer);
  api.DeleteTextures(2, textures);
  mesh = {};
}

}  // namespace marrow::gles3
