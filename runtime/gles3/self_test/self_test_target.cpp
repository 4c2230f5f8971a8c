// At start-up: a texture of integers to draw points into, and reading it back.
#include "gles3/self_test/self_test_target.h"

#include <cstring>

#include "gles3/errors.h"
#include "gles3/gl_constants.h"
#include "gles3/label.h"
#include "gles3/texture.h"

namespace marrow::gles3 {
namespace {

constexpr GlEnum kProbeBuffers[4][2] = {{kGlArrayBuffer, kGlArrayBufferBinding},
                                        {kGlUniformBuffer, kGlUniformBufferBinding},
                                        {kGlPixelPackBuffer, kGlPixelPackBufferBinding},
                                        {kGlPixelUnpackBuffer, kGlPixelUnpackBufferBinding}};
constexpr GlEnum kProbeSwitches[2] = {kGlScissorTest, kGlRasterizerDiscard};

unsigned name_of(int value) {
  return static_cast<unsigned>(value);
}

unsigned char flag(int value) {
  return value != 0 ? 1 : 0;
}

}  // namespace

Status make_probe_target(const Api& api, std::uint32_t width, std::uint32_t height, ProbeTarget& out) {
  ProbeTarget made;
  made.width = width;
  made.height = height;
  forget_errors(api);
  made.texture = make_texture(api, kGlRgba32ui, kGlRgbaInteger, kGlUnsignedInt, width, height);
  api.BindTexture(kGlTexture2d, 0);
  api.GenFramebuffers(1, &made.framebuffer);
  api.BindFramebuffer(kGlFramebuffer, made.framebuffer);
  api.FramebufferTexture2D(kGlFramebuffer, kGlColorAttachment0, kGlTexture2d, made.texture, 0);
  const bool complete = api.CheckFramebufferStatus(kGlFramebuffer) == kGlFramebufferComplete;
  if (!complete || api.GetError() != kGlNoError) {
    destroy(api, made);
    return Status::gl_error;
  }
  api.Viewport(0, 0, static_cast<int>(width), static_cast<int>(height));
  label(api, kGlTexture, made.texture, {"marrow: self-test"});
  label(api, kGlFramebuffer, made.framebuffer, {"marrow: self-test"});
  out = made;
  return Status::ok;
}

void destroy(const Api& api, ProbeTarget& target) {
  api.DeleteFramebuffers(1, &target.framebuffer);
  api.DeleteTextures(1, &target.texture);
  target = {};
}

void clear_probe(const Api& api, std::uint32_t word) {
  const unsigned words[4] = {word, word, word, word};
  api.ClearBufferuiv(kGlColor, 0, words);
}

void read_probe(const Api& api, const ProbeTarget& target, Span<std::uint32_t> words) {
  std::memset(words.data, 0xFF, target.words() * sizeof(std::uint32_t));
  api.ReadPixels(0, 0, static_cast<int>(target.width), static_cast<int>(target.height), kGlRgbaInteger, kGlUnsignedInt,
                 words.data);
}

bool can_read_probe(const Api& api, const ProbeTarget& target, Span<std::uint32_t> words) {
  constexpr std::uint32_t kWord = 0x12345678;
  forget_errors(api);
  clear_probe(api, kWord);
  read_probe(api, target, words);
  bool all = api.GetError() == kGlNoError;
  for (std::size_t i = 0; i < target.words(); ++i) all = all && words[i] == kWord;
  return all;
}

void take_state(const Api& api, ProbeState& out) {
  api.GetIntegerv(kGlDrawFramebufferBinding, &out.draw_framebuffer);
  api.GetIntegerv(kGlReadFramebufferBinding, &out.read_framebuffer);
  api.GetIntegerv(kGlViewport, out.viewport);
  api.GetIntegerv(kGlCurrentProgram, &out.program);
  api.GetIntegerv(kGlVertexArrayBinding, &out.array);
  api.GetIntegerv(kGlActiveTexture, &out.unit);
  api.GetIntegerv(kGlColorWritemask, out.colour_mask);
  api.ActiveTexture(kGlTexture0);
  api.GetIntegerv(kGlTextureBinding2d, &out.texture);
  for (std::size_t i = 0; i < 4; ++i) {
    api.GetIntegerv(kProbeBuffers[i][1], &out.buffers[i]);
    api.BindBuffer(kProbeBuffers[i][0], 0);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    api.GetIntegerv(kProbeSwitches[i], &out.switches[i]);
    api.Disable(kProbeSwitches[i]);
  }
  api.ColorMask(1, 1, 1, 1);
}

void put_back(const Api& api, const ProbeState& state) {
  api.BindFramebuffer(kGlDrawFramebuffer, name_of(state.draw_framebuffer));
  api.BindFramebuffer(kGlReadFramebuffer, name_of(state.read_framebuffer));
  api.Viewport(state.viewport[0], state.viewport[1], state.viewport[2], state.viewport[3]);
  api.UseProgram(name_of(state.program));
  api.BindVertexArray(name_of(state.array));
  api.ActiveTexture(kGlTexture0);
  api.BindTexture(kGlTexture2d, name_of(state.texture));
  api.ActiveTexture(name_of(state.unit));
  for (std::size_t i = 0; i < 4; ++i) api.BindBuffer(kProbeBuffers[i][0], name_of(state.buffers[i]));
  for (std::size_t i = 0; i < 2; ++i) {
    if (state.switches[i] != 0) api.Enable(kProbeSwitches[i]);
  }
  const int* const mask = state.colour_mask;
  api.ColorMask(flag(mask[0]), flag(mask[1]), flag(mask[2]), flag(mask[3]));
}

}  // namespace marrow::gles3
