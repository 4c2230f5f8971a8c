// Crowds in textures: instances when they change, palettes of all of them once a frame.
#include "gles3/crowd/crowd.h"
#include "gles3/program.h"

#include <cstring>

#include "core/zone.h"
#include "gles3/compile.h"
#include "gles3/errors.h"
#include "gles3/label.h"
#include "gles3/program_set.h"
#include "gles3/texture.h"

namespace marrow::embedded {
extern const unsigned char shader_crowd_vert[], shader_crowd_frag[];
}

namespace marrow::gles3 {
namespace {

constexpr std::uint32_t kTexels = 8;  // an instance
constexpr std::uint32_t kLine = kPaletteTextureWidth / kTexels;

bool is_there(std::uint32_t first, std::uint32_t count, const Crowd& crowd) {
  return first <= crowd.count && count <= crowd.count - first;
}

// Of the instances, into the texture that is bound: the rest of a line, whole lines, the start of one.
void put(const Api& api, const Crowd& crowd, std::uint32_t first, std::uint32_t count) {
  for (const std::uint32_t end = first + count; first < end; first += count) {
    const std::uint32_t to_line_end = kLine - first % kLine;
    count = end - first;
    std::uint32_t lines = 1;
    if (count > to_line_end) {
      lines = to_line_end < kLine ? 1 : count / kLine;
      count = to_line_end < kLine ? to_line_end : lines * kLine;
    }
    api.TexSubImage2D(kGlTexture2d, 0, static_cast<int>(first % kLine * kTexels), static_cast<int>(first / kLine),
                      static_cast<int>(count / lines * kTexels), static_cast<int>(lines), kGlRgbaInteger,
                      kGlUnsignedInt, crowd.records.data + std::size_t{first} * kCrowdInstanceBytes);
  }
}

Status make_object(const Api& api, const Caps& caps, Crowd& crowd) {
  if (caps.texture_size < kPaletteTextureWidth || (crowd.capacity - 1) / kLine >= caps.texture_size)
    return Status::unsupported;
  forget_errors(api);
  const std::uint32_t lines = (crowd.capacity - 1) / kLine + 1;
  crowd.texture = make_texture(api, kGlRgba32ui, kGlRgbaInteger, kGlUnsignedInt, kPaletteTextureWidth, lines);
  put(api, crowd, 0, crowd.count);
  api.BindTexture(kGlTexture2d, 0);
  if (api.GetError() != kGlNoError) {
    api.DeleteTextures(1, &crowd.texture);
    crowd.texture = 0;
    return Status::gl_error;
  }
  label(api, kGlTexture, crowd.texture, {"marrow: crowd"});
  return Status::ok;
}

// What both programs read: palettes or frames, and instances.
void bind_textures(const Api& api, const Program& program, std::uint32_t palettes, std::uint32_t instances,
                   std::uint32_t unit) {
  const ProgramState& at = state_of(program);
  api.ActiveTexture(kGlTexture0 + unit);
  api.BindTexture(kGlTexture2d, palettes);
  api.Uniform1i(at.palettes, static_cast<int>(unit));
  api.ActiveTexture(kGlTexture0 + unit + 1);
  api.BindTexture(kGlTexture2d, instances);
  if (at.instances >= 0) api.Uniform1i(at.instances, static_cast<int>(unit + 1));
}

BadCall check_blending(const Crowd& crowd, const CrowdMesh& mesh, std::uint32_t first, std::uint32_t count,
                       double time_s, const Program& program) {
  MARROW_CHECK(state_of(program).crowd >= 0 && "a program from create_crowd_program()");
  MARROW_CHECK(is_there(first, count, crowd) && state_of(mesh).joints > 0);
  MARROW_CHECK(has_ticks(time_s));
  MARROW_CHECK(count == 0 || crowd.frame_count == mesh.frames.frame_count);
  return {};
}

// Where palettes are written to, and whose.
struct Blending {
  std::uint32_t framebuffer;
  std::uint32_t first, count;   // lines with palettes of these are drawn to
  std::uint32_t least, behind;  // and in them those of instances from `least` on and before `behind` written
};

Status blend(const Api& api, const Crowd& crowd, const CrowdMesh& mesh, const Blending& to, double time_s,
             std::uint32_t texture_unit, const Program& program) {
  if (crowd.lost || mesh.lost) return Status::gl_error;
  if (to.first + to.count > mesh.capacity) return Status::unsupported;
  const std::uint32_t rows = 3 * state_of(mesh).joints;
  const auto line = static_cast<int>(std::uint64_t{rows} * to.first / kPaletteTextureWidth);
  const auto end = static_cast<int>((std::uint64_t{rows} * (to.first + to.count) - 1) / kPaletteTextureWidth + 1);
  bind_textures(api, program, state_of(mesh).frames_texture, crowd.texture, texture_unit);
  const int values[4] = {static_cast<int>(ticks_of(time_s)), static_cast<int>(rows), static_cast<int>(to.behind),
                         static_cast<int>(to.least)};
  api.Uniform1iv(state_of(program).crowd, 4, values);
  api.BindFramebuffer(kGlFramebuffer, to.framebuffer);
  api.Viewport(0, line, static_cast<int>(kPaletteTextureWidth), end - line);
  api.BindVertexArray(0);
  api.DrawArrays(kGlTriangles, 0, 3);
  api.BindFramebuffer(kGlFramebuffer, 0);
  return Status::ok;
}

ProgramKey drawing_key(const CrowdMesh& mesh, Deformer deformer, std::uint8_t features, const ProgramSet& programs,
                       std::uint32_t role) {
  return {deformer, state_of(mesh).gpu.influences,
          features_read(programs, role, state_of(mesh).gpu, deformer, features, mesh.motion), Palettes::crowd};
}

}  // namespace

Status create_crowd(const Api& api, const Caps& caps, std::uint32_t capacity, Span<std::byte> memory, Crowd& out) {
  MARROW_REQUIRE(capacity > 0 && memory.size / kCrowdInstanceBytes >= capacity && holds(memory));
  MARROW_REQUIRE(reinterpret_cast<std::uintptr_t>(memory.data) % alignof(std::uint32_t) == 0);
  Crowd made;
  made.capacity = capacity;
  made.records = {memory.data, std::size_t{capacity} * kCrowdInstanceBytes};
  const Status status = make_object(api, caps, made);
  if (status == Status::ok) out = made;
  return status;
}

void destroy(const Api& api, Crowd& crowd) {
  if (!crowd.lost) api.DeleteTextures(1, &crowd.texture);
  crowd = {};
}

void on_context_lost(Crowd& crowd) {
  crowd.texture = 0;
  crowd.lost = true;
}

Status on_context_restored(const Api& api, const Caps& caps, Crowd& crowd) {
  MARROW_REQUIRE(crowd.capacity > 0 && "a crowd from create_crowd()");
  const Status status = make_object(api, caps, crowd);
  crowd.lost = status != Status::ok;
  return status;
}

Status set_instances(const Api& api, Crowd& crowd, const CrowdFrames& frames, std::uint32_t first,
                     Span<const CrowdInstance> instances) {
  MARROW_ZONE;
  MARROW_REQUIRE(crowd.capacity > 0 && "a crowd from create_crowd()");
  MARROW_REQUIRE(holds(instances, 1) && first <= crowd.count);
  MARROW_REQUIRE(crowd.count == 0 || frames.frame_count == crowd.frame_count);
  if (first > crowd.capacity || instances.size > crowd.capacity - first) return Status::unsupported;
  MARROW_REQUIRE_GOOD(check_frames(frames));
  for (const CrowdInstance& instance : instances) MARROW_REQUIRE_GOOD(check_instance(frames, instance));
  for (std::size_t i = 0; i < instances.size; ++i) {
    const CrowdRecord record = record_of(frames, instances[i]);
    std::memcpy(crowd.records.data + (first + i) * sizeof(record), &record, sizeof(record));
  }
  const auto count = static_cast<std::uint32_t>(instances.size);
  if (crowd.count < first + count) crowd.count = first + count;
  crowd.frame_count = frames.frame_count;
  if (crowd.lost) return Status::ok;
  api.BindTexture(kGlTexture2d, crowd.texture);
  put(api, crowd, first, count);
  api.BindTexture(kGlTexture2d, 0);
  return Status::ok;
}

Status create_crowd_program(const Api& api, Program& out, Span<char> log) {
  MARROW_REQUIRE(holds(log));
  clear(log);
  const auto text = [](const unsigned char* embedded) { return reinterpret_cast<const char*>(embedded); };
  ShaderTexts texts{text(embedded::shader_crowd_vert), text(embedded::shader_crowd_frag), nullptr, {}};
  texts.role = "blending of crowds";
  return compile_program(api, kBlendingKey, texts, 0, out, log);
}

Status create_crowd_programs(const Api& api, const Caps& caps, const CrowdMesh& mesh, Deformer deformer,
                             std::uint8_t features, ProgramSet& programs) {
  MARROW_ZONE;
  MARROW_REQUIRE(state_of(mesh).joints > 0 && "a mesh from create_crowd_mesh()");
  MARROW_REQUIRE(in_crowds(deformer));
  MARROW_REQUIRE_GOOD(check_roles(programs));
  Status status = need_program(api, caps, programs, kBlendingKey, kBlendingRole);
  for (std::uint32_t role = 0; role < programs.role_count && status == Status::ok; ++role)
    status = need_program(api, caps, programs, drawing_key(mesh, deformer, features, programs, role), role);
  return status;
}

const Program& crowd_program_of(const CrowdMesh& mesh, Deformer deformer, std::uint8_t features,
                                const ProgramSet& programs, std::uint32_t role) {
  return program_or_none(find_program(programs, drawing_key(mesh, deformer, features, programs, role), role));
}

const Program& blending_program_of(const ProgramSet& programs) {
  return program_or_none(find_program(programs, kBlendingKey, kBlendingRole));
}

Status blend_crowd(const Api& api, const Crowd& crowd, const CrowdMesh& mesh, std::uint32_t first, std::uint32_t count,
                   double time_s, std::uint32_t texture_unit, const Program& program) {
  MARROW_ZONE;
  MARROW_REQUIRE_GOOD(check_blending(crowd, mesh, first, count, time_s, program));
  if (count == 0) return Status::ok;
  // Of all that there are: whole lines, so those of instances that share one with these too.
  const std::uint32_t known = crowd.count < mesh.capacity ? crowd.count : mesh.capacity;
  return blend(api, crowd, mesh, {state_of(mesh).framebuffer, first, count, 0, known}, time_s, texture_unit, program);
}

void begin_frame(CrowdMesh& mesh) {
  CrowdMeshState& own = state_of(mesh);
  if (!mesh.motion) return;
  const std::uint32_t texture = own.blended_texture, framebuffer = own.framebuffer;
  own.blended_texture = own.previous_texture;
  own.framebuffer = own.previous_framebuffer;
  own.previous_texture = texture;
  own.previous_framebuffer = framebuffer;
}

Status blend_previous_crowd(const Api& api, const Crowd& crowd, const CrowdMesh& mesh, std::uint32_t first,
                            std::uint32_t count, double time_s, std::uint32_t texture_unit, const Program& program) {
  MARROW_ZONE;
  MARROW_REQUIRE(mesh.motion);
  MARROW_REQUIRE_GOOD(check_blending(crowd, mesh, first, count, time_s, program));
  if (count == 0) return Status::ok;
  return blend(api, crowd, mesh, {state_of(mesh).previous_framebuffer, first, count, first, first + count}, time_s,
               texture_unit, program);
}

Status bind_crowd(const Api& api, const Crowd& crowd, const CrowdMesh& mesh, std::uint32_t first, std::uint32_t count,
                  std::uint32_t texture_unit, const Program& program) {
  const ProgramState& at = state_of(program);
  const CrowdMeshState& own = state_of(mesh);
  MARROW_REQUIRE(at.reads == Palettes::crowd);
  MARROW_REQUIRE(is_there(first, count, crowd) && own.joints > 0);
  MARROW_REQUIRE(crowd.frame_count == mesh.frames.frame_count);
  MARROW_REQUIRE(at.previous_palettes < 0 || mesh.motion);
  if (crowd.lost || mesh.lost) return Status::gl_error;
  if (first + count > mesh.capacity) return Status::unsupported;
  bind_textures(api, program, own.blended_texture, crowd.texture, texture_unit);
  if (at.previous_palettes >= 0) {
    api.ActiveTexture(kGlTexture0 + texture_unit + 2);
    api.BindTexture(kGlTexture2d, own.previous_texture);
    api.Uniform1i(at.previous_palettes, static_cast<int>(texture_unit + 2));
  }
  const std::uint32_t rows = 3 * own.joints;
  api.Uniform2i(at.first_row, static_cast<int>(rows * first), static_cast<int>(rows));
  return Status::ok;
}

Status draw(const Api& api, const CrowdMesh& mesh, Deformer deformer, const Program& program, std::uint32_t instances) {
  return draw(api, state_of(mesh).gpu, deformer, program, instances);
}

}  // namespace marrow::gles3
