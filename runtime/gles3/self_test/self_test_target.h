// Where the self-test draws to and reads back from, and the GL state that it puts back.
#pragma once

#include "marrow/gles3.h"

namespace marrow::gles3 {

struct ProbeTarget {
  std::uint32_t texture = 0, framebuffer = 0;  // RGBA32UI, which every OpenGL ES 3.0 can draw to
  std::uint32_t width = 0, height = 0;

  std::size_t words() const { return std::size_t{4} * width * height; }
};

// Makes it and leaves it bound, its texture unit 0 active.
// Errors: gl_error (nothing is left allocated).
Status make_probe_target(const Api& api, std::uint32_t width, std::uint32_t height, ProbeTarget& out);
void destroy(const Api& api, ProbeTarget& target);

// Every word of it.
void clear_probe(const Api& api, std::uint32_t word);

// words: of the whole target, row by row; all ones where GL writes nothing.
void read_probe(const Api& api, const ProbeTarget& target, Span<std::uint32_t> words);

// Whether what is cleared can be read: not so without a context.
bool can_read_probe(const Api& api, const ProbeTarget& target, Span<std::uint32_t> words);

struct ProbeState {
  int draw_framebuffer = 0, read_framebuffer = 0, viewport[4] = {}, program = 0, array = 0;
  int unit = 0, texture = 0, buffers[4] = {}, colour_mask[4] = {}, switches[2] = {};
};

// Notes it, and makes it fit for drawing points.
void take_state(const Api& api, ProbeState& out);
void put_back(const Api& api, const ProbeState& state);

}  // namespace marrow::gles3
