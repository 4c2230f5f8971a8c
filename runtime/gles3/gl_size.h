// Sizes and offsets of buffers as GL takes them: signed, and of 32 bits where addresses are.
#pragma once

#include <cstddef>
#include <cstdint>

namespace marrow::gles3 {

// bytes: what is too much for the type becomes negative, which GL refuses with an error.
constexpr std::ptrdiff_t gl_size(std::uint64_t bytes) {
  return static_cast<std::ptrdiff_t>(bytes);
}

}  // namespace marrow::gles3
