// A mesh for crowds: its palettes of all frames in a texture, and a texture to render those of the instances to.
#include <cstring>

#include "core/check.h"
#include "core/memory.h"
#include "core/off_boundary.h"
#include "gles3/crowd/crowd.h"
#include "gles3/errors.h"
#include "gles3/gl_constants.h"
#include "gles3/label.h"
#include "gles3/mesh/prepare.h"
#include "gles3/texture.h"
#include "marrow/palette.h"

namespace marrow::gles3 {
namespace {

// Three lines hold as many matrices as a line has texels.
constexpr std::uint32_t kChunk = kPaletteTextureWidth;
constexpr std::uint32_t kChunkLines = 3;

std::uint32_t lines_of(std::uint64_t palettes, std::uint32_t joints) {
  return static_cast<std::uint32_t>((3 * palettes * joints + kPaletteTextureWidth - 1) / kPaletteTextureWidth);
}

void put_lines(const Api& api, std::uint32_t line, std::uint32_t lines, const Affine* matrices) {
  api.TexSubImage2D(kGlTexture2d, 0, 0, static_cast<int>(line), static_cast<int>(kPaletteTextureWidth),
                    static_cast<int>(lines), kGlRgba, kGlFloat, matrices);
}

std::size_t room_for_palettes(const Mesh& mesh) {
  return kChunk + mesh.palette_size();
}

PrepareOptions prepare_options(const CrowdMeshOptions& options) {
  return {options.ssd, options.as, options.as_tangents, false};
}

void lay_out(Memory& memory, const Mesh& mesh, const CrowdMeshOptions& options, CrowdMesh& out) {
  state_of(out).bind = memory.take<Affine>(mesh.joint_count);
  const std::size_t palettes = room_for_palettes(mesh) * sizeof(Affine);
  const std::size_t vertices = prepare_scratch_bytes(mesh, prepare_options(options));
  state_of(out).scratch = memory.take<std::byte>(palettes > vertices ? palettes : vertices);
}

// Palettes of all frames into the texture that is bound, three lines at a time.
void put_frames(const Api& api, const CrowdMesh& crowd_mesh) {
  const Mesh& mesh = crowd_mesh.mesh;
  const CrowdFrames& frames = crowd_mesh.frames;
  const Span<Affine> scratch(reinterpret_cast<Affine*>(state_of(crowd_mesh).scratch.data), room_for_palettes(mesh));
  const std::uint32_t size = mesh.palette_size();
  std::uint32_t filled = 0, line = 0;
  for (std::uint32_t frame = 0; frame < frames.frame_count; ++frame) {
    const Span<const Affine> joints(frames.character_from_joint.data + std::size_t{frame} * frames.joint_count,
                                    frames.joint_count);
    static_cast<void>(build_palette({mesh.joints, mesh.joint_count}, state_of(crowd_mesh).bind, joints,
                                    {scratch.data + filled, size}, mesh.helpers, mesh.helper_centres));
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

void forget_objects(CrowdMesh& mesh) {
  CrowdMeshState& own = state_of(mesh);
  own.gpu = {};
  own.frames_texture = own.blended_texture = own.previous_texture = 0;
  own.framebuffer = own.previous_framebuffer = 0;
}

void destroy_objects(const Api& api, CrowdMesh& mesh) {
  CrowdMeshState& own = state_of(mesh);
  const std::uint32_t textures[] = {own.frames_texture, own.blended_texture, own.previous_texture};
  const std::uint32_t framebuffers[] = {own.framebuffer, own.previous_framebuffer};
  api.DeleteFramebuffers(2, framebuffers);
  api.DeleteTextures(3, textures);
  destroy(api, own.gpu);
  forget_objects(mesh);
}

// A texture of the palettes of all instances, and a framebuffer around it. Gives whether it can be drawn to.
bool make_blended(const Api& api, const CrowdMesh& mesh, std::uint32_t& texture, std::uint32_t& framebuffer) {
  texture = make_texture(api, kGlRgba32ui, kGlRgbaInteger, kGlUnsignedInt, kPaletteTextureWidth,
                         lines_of(mesh.capacity, state_of(mesh).joints));
  api.BindTexture(kGlTexture2d, 0);
  api.GenFramebuffers(1, &framebuffer);
  api.BindFramebuffer(kGlFramebuffer, framebuffer);
  api.FramebufferTexture2D(kGlFramebuffer, kGlColorAttachment0, kGlTexture2d, texture, 0);
  const bool complete = api.CheckFramebufferStatus(kGlFramebuffer) == kGlFramebufferComplete;
  api.BindFramebuffer(kGlFramebuffer, 0);
  label(api, kGlTexture, texture, {label_of(mesh.mesh), ": blended palettes"});
  label(api, kGlFramebuffer, framebuffer, {label_of(mesh.mesh), ": blended palettes"});
  return complete;
}

// The textures, and the framebuffers. Errors are GL's to tell, but for the result: whether they can be drawn to.
bool make_textures(const Api& api, CrowdMesh& mesh) {
  CrowdMeshState& own = state_of(mesh);
  own.frames_texture = make_texture(api, kGlRgba32f, kGlRgba, kGlFloat, kPaletteTextureWidth,
                                    lines_of(mesh.frames.frame_count, own.joints));
  put_frames(api, mesh);
  const bool complete = make_blended(api, mesh, own.blended_texture, own.framebuffer);
  return complete && (!mesh.motion || make_blended(api, mesh, own.previous_texture, own.previous_framebuffer));
}

// Of a mesh that has none; all of them, or none.
Status make_objects(const Api& api, const Caps& caps, CrowdMesh& mesh) {
  CrowdMeshState& own = state_of(mesh);
  const std::uint32_t fit = crowd_palettes_that_fit(caps, own.joints);
  if (mesh.frames.frame_count > fit || mesh.capacity > fit) return Status::unsupported;
  const Status status = prepare(api, caps, mesh.mesh, prepare_options(mesh.options), own.scratch, own.bind, own.gpu);
  if (status != Status::ok) return status;
  forget_errors(api);
  const bool complete = make_textures(api, mesh);
  if (api.GetError() != kGlNoError || !complete) {
    destroy_objects(api, mesh);
    return Status::gl_error;
  }
  label(api, kGlTexture, own.frames_texture, {label_of(mesh.mesh), ": frames"});
  return Status::ok;
}

}  // namespace

std::uint32_t crowd_palettes_that_fit(const Caps& caps, std::uint32_t joints) {
  if (joints == 0 || caps.texture_size < kPaletteTextureWidth) return 0;
  return static_cast<std::uint32_t>(std::uint64_t{kPaletteTextureWidth} * caps.texture_size /
                                    (std::uint64_t{3} * joints));
}

std::size_t crowd_mesh_bytes(const Mesh& mesh, const CrowdMeshOptions& options) {
  CrowdMesh counted;
  Memory memory;
  lay_out(memory, mesh, options, counted);
  return memory.used;
}

Status create_crowd_mesh(const Api& api, const Caps& caps, const Mesh& mesh, const CrowdMeshOptions& options,
                         const CrowdFrames& frames, std::uint32_t capacity, Span<std::byte> memory, CrowdMesh& out,
                         bool motion) {
  MARROW_REQUIRE(capacity > 0 && frames.frame_count > 0);
  MARROW_REQUIRE_GOOD(check_mesh(mesh, prepare_options(options)));
  MARROW_REQUIRE_GOOD(check_frames(frames));
  MARROW_REQUIRE(holds(memory, crowd_mesh_bytes(mesh, options)));
  MARROW_REQUIRE_GOOD(check_boundary(memory.data));
  for (std::uint32_t i = 0; i < mesh.joint_count; ++i) MARROW_REQUIRE(mesh.joints[i] < frames.joint_count);
  if (!mesh.geometry.targets.empty()) return Status::unsupported;
  CrowdMesh made;
  state_of(made).joints = mesh.palette_size();
  made.capacity = capacity;
  made.motion = motion;
  made.mesh = mesh;
  made.options = options;
  made.frames = frames;
  Memory pieces{memory.data};
  lay_out(pieces, mesh, options, made);
  const Status status = make_objects(api, caps, made);
  if (status == Status::ok) out = made;
  return status;
}

void destroy(const Api& api, CrowdMesh& mesh) {
  if (!mesh.lost) destroy_objects(api, mesh);
  mesh = {};
}

void on_context_lost(CrowdMesh& mesh) {
  forget_objects(mesh);
  mesh.lost = true;
}

Status on_context_restored(const Api& api, const Caps& caps, CrowdMesh& mesh) {
  MARROW_REQUIRE(state_of(mesh).joints > 0 && "a mesh from create_crowd_mesh()");
  const Status status = make_objects(api, caps, mesh);
  mesh.lost = status != Status::ok;
  return status;
}

}  // namespace marrow::gles3
