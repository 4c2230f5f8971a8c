// A driver of OpenGL ES that keeps what marrow::gles3 gives it: for an engine that draws by another API.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "gles3/program.h"
#include "marrow/gles3.h"

namespace marrow::test {

struct Recorder {
  std::vector<std::pair<unsigned, std::string>> texts;         // GL_VERTEX_SHADER …; complete, as compiled
  std::map<unsigned, std::vector<std::byte>> buffers;          // by name; zeros where GL was given none
  std::map<unsigned, unsigned> bindings;                       // binding → buffer, of the last that was not 0
  std::map<std::string, std::vector<std::uint32_t>> uniforms;  // 32-bit words
  unsigned groups = 0;                                         // of the last DispatchCompute
};

// What the functions of recording_api() write to; one for all, as GL has one context.
Recorder& recorder();
// Of OpenGL ES 3.1. Every call succeeds.
gles3::Api recording_api();

// How the files of a program's texts are called: "ubo-as-4-pnt-motion".
std::string name_of(const gles3::ProgramKey& key);

}  // namespace marrow::test
