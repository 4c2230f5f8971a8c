// Crowds in textures: instances when they change, palettes of all of them once a frame.
#include "gles3/crowd.h"

#include <cstring>

#include "gles3/compile.h"
#include "gles3/errors.h"
#include "gles3/label.h"
#include "gles3/texture.h"

namespace marrow::embedded {
extern const unsigned char shader_crowd_vert[], shader_crowd_frag[];
}

namespace marrow::gles3 {
namespace {

constexpr std::uint32_t kWidth = kPaletteTextureWidth;
constexpr std::uint32_t kTexels = 8;  // an instance
constexpr std::uint32_t kLine = kWidth / kTexels;

bool is_there(std::uint32_t first, std::uint32_t count, const Crowd& crowd) {
  return first <= crowd.count && count <= crowd.count - first;
}

// Instances of one line from `first` on, or whole lines of them.
void put(const Api& api, std::uint32_t first, std::uint32_t count, const std::byte* records) {
  const std::uint32_t lines = count <= kLine ? 1 : count / kLine;
  api.TexSubImage2D(kGlTexture2d, 0, static_cast<int>(first % kLine * kTexels), static_cast<int>(first / kLine),
                    static_cast<int>(count / lines * kTexels), static_cast<int>(lines), kGlRgbaInteger, kGlUnsignedInt,
                    records);
}

// What both programs read: palettes or frames, and instances.
void bind_textures(const Api& api, const Program& program, std::uint32_t palettes, std::uint32_t instances,
                   std::uint32_t unit) {
  api.ActiveTexture(kGlTexture0 + unit);
  api.BindTexture(kGlTexture2d, palettes);
  api.Uniform1i(program.palettes, static_cast<int>(unit));
  api.ActiveTexture(kGlTexture0 + unit + 1);
  api.BindTexture(kGlTexture2d, instances);
  if (program.instances >= 0) api.Uniform1i(program.instances, static_cast<int>(unit + 1));
}

}  // namespace

Status create_crowd(const Api& api, const Caps& caps, std::uint32_t capacity, Crowd& out) {
  if (capacity == 0) return Status::bad_argument;
  if (caps.texture_size < kWidth || (capacity - 1) / kLine >= caps.texture_size) return Status::unsupported;
  Crowd made;
  made.capacity = capacity;
  forget_errors(api);
  made.texture = make_texture(api, kGlRgba32ui, kGlRgbaInteger, kGlUnsignedInt, kWidth, (capacity - 1) / kLine + 1);
  api.BindTexture(kGlTexture2d, 0);
  if (api.GetError() != kGlNoError) {
    destroy(api, made);
    return Status::gl_error;
  }
  label(api, kGlTexture, made.texture, {"marrow: crowd"});
  out = made;
  return Status::ok;
}

void destroy(const Api& api, Crowd& crowd) {
  api.DeleteTextures(1, &crowd.texture);
  crowd = {};
}

Status set_instances(const Api& api, Crowd& crowd, const CrowdFrames& frames, std::uint32_t first,
                     Span<const CrowdInstance> instances, Span<std::byte> scratch) {
  if (instances.empty() || first > crowd.count || scratch.size < kCrowdInstanceBytes) return Status::bad_argument;
  if (crowd.count != 0 && frames.frame_count != crowd.frame_count) return Status::bad_argument;
  if (first > crowd.capacity || instances.size > crowd.capacity - first) return Status::unsupported;
  Status status = check_frames(frames);
  for (std::size_t i = 0; status == Status::ok && i < instances.size; ++i)
    status = check_instance(frames, instances[i]);
  if (status != Status::ok) return status;
  const std::size_t room = scratch.size / kCrowdInstanceBytes;
  api.BindTexture(kGlTexture2d, crowd.texture);
  for (std::size_t done = 0; done < instances.size;) {
    const auto at = first + static_cast<std::uint32_t>(done);
    const std::size_t to_line_end = kLine - at % kLine;
    std::size_t count = instances.size - done < room ? instances.size - done : room;
    if (count > to_line_end) count = to_line_end < kLine ? to_line_end : count / kLine * kLine;
    for (std::size_t i = 0; i < count; ++i) {
      const CrowdRecord record = record_of(frames, instances[done + i]);
      std::memcpy(scratch.data + i * sizeof(record), &record, sizeof(record));
    }
    put(api, at, static_cast<std::uint32_t>(count), scratch.data);
    done += count;
  }
  api.BindTexture(kGlTexture2d, 0);
  const std::uint32_t end = first + static_cast<std::uint32_t>(instances.size);
  if (crowd.count < end) crowd.count = end;
  crowd.frame_count = frames.frame_count;
  return Status::ok;
}

Status build_crowd_program(const Api& api, Program& out, Span<char> log) {
  clear(log);
  ProgramKey key;
  key.deformer = Deformer::none;
  key.features = 0;
  const auto text = [](const unsigned char* embedded) { return reinterpret_cast<const char*>(embedded); };
  ShaderTexts texts{text(embedded::shader_crowd_vert), text(embedded::shader_crowd_frag), nullptr, {}};
  texts.role = "blending of crowds";
  return compile_program(api, key, texts, 0, out, log);
}

Status blend_crowd(const Api& api, const Crowd& crowd, const CrowdMesh& mesh, std::uint32_t first, std::uint32_t count,
                   double time_s, std::uint32_t texture_unit, const Program& program) {
  if (program.crowd < 0 || !is_there(first, count, crowd) || mesh.joints == 0) return Status::bad_argument;
  std::uint32_t now;
  const Status status = to_ticks(time_s, now);
  if (status != Status::ok || count == 0) return status;
  if (crowd.frame_count != mesh.frame_count) return Status::bad_argument;
  if (first + count > mesh.capacity) return Status::unsupported;
  // Whole lines: of instances that share one with these too.
  const std::uint32_t rows = 3 * mesh.joints;
  const auto line = static_cast<int>(std::uint64_t{rows} * first / kWidth);
  const auto end = static_cast<int>((std::uint64_t{rows} * (first + count) - 1) / kWidth + 1);
  const std::uint32_t known = crowd.count < mesh.capacity ? crowd.count : mesh.capacity;
  bind_textures(api, program, mesh.frames_texture, crowd.texture, texture_unit);
  const int values[3] = {static_cast<int>(now), static_cast<int>(rows), static_cast<int>(known)};
  api.Uniform1iv(program.crowd, 3, values);
  api.BindFramebuffer(kGlFramebuffer, mesh.framebuffer);
  api.Viewport(0, line, static_cast<int>(kWidth), end - line);
  api.BindVertexArray(0);
  api.DrawArrays(kGlTriangles, 0, 3);
  api.BindFramebuffer(kGlFramebuffer, 0);
  return Status::ok;
}

Status bind_crowd(const Api& api, const Crowd& crowd, const CrowdMesh& mesh, std::uint32_t first, std::uint32_t count,
                  std::uint32_t texture_unit, const Program& program) {
  if (program.reads != Palettes::crowd || mesh.joints == 0 || !is_there(first, count, crowd))
    return Status::bad_argument;
  if (crowd.frame_count != mesh.frame_count) return Status::bad_argument;
  if (first + count > mesh.capacity) return Status::unsupported;
  bind_textures(api, program, mesh.blended_texture, crowd.texture, texture_unit);
  const std::uint32_t rows = 3 * mesh.joints;
  api.Uniform2i(program.first_row, static_cast<int>(rows * first), static_cast<int>(rows));
  return Status::ok;
}

}  // namespace marrow::gles3
