// How long the GPU was at it, where its driver says so.
#pragma once

#include <cstdint>
#include <string>

#include "marrow/egl.h"
#include "render/gl.h"

namespace marrow::tools {

// EXT_disjoint_timer_query: how long the GPU was at it.
class GpuTimer {
 public:
  explicit GpuTimer(const Gl& gl) {
    const auto* const all = reinterpret_cast<const char*>(gl.GetString(GL_EXTENSIONS));
    if (all == nullptr || std::string(all).find("GL_EXT_disjoint_timer_query") == std::string::npos) return;
    load(generate_, "glGenQueriesEXT");
    load(begin_, "glBeginQueryEXT");
    load(end_, "glEndQueryEXT");
    load(get_, "glGetQueryObjectui64vEXT");
    if (generate_ == nullptr || begin_ == nullptr || end_ == nullptr || get_ == nullptr) return;
    generate_(1, &query_);
  }
  bool can() const { return query_ != 0; }
  void begin() const {
    if (can()) begin_(kTimeElapsed, query_);
  }
  void end() const {
    if (can()) end_(kTimeElapsed);
  }
  double elapsed_ns() const {
    std::uint64_t out = 0;
    get_(query_, kQueryResult, &out);
    return static_cast<double>(out);
  }

 private:
  static constexpr GLenum kTimeElapsed = 0x88BF, kQueryResult = 0x8866;
  template <class Function>
  static void load(Function& function, const char* name) {
    function = reinterpret_cast<Function>(egl::load_proc(name));
  }

  void (*generate_)(GLsizei, GLuint*) = nullptr;
  void (*begin_)(GLenum, GLuint) = nullptr;
  void (*end_)(GLenum) = nullptr;
  void (*get_)(GLuint, GLenum, std::uint64_t*) = nullptr;
  GLuint query_ = 0;
};

}  // namespace marrow::tools
