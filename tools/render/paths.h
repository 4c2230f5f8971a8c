// Where vertices can be skinned: the one list of it that `marrow render` and `marrow view` offer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>

namespace marrow::tools {

enum class SkinPath : std::uint8_t { cpu, ubo, texture, feedback, compute, crowd };

struct NamedSkinPath {
  const char* name;  // as on the command line
  SkinPath value;
  const char* about;  // of --help
};
inline constexpr NamedSkinPath kSkinPaths[] = {
    {"cpu", SkinPath::cpu, "by the processor"},
    {"ubo", SkinPath::ubo, "vertex shader, uniforms"},
    {"texture", SkinPath::texture, "the same, a texture"},
    {"feedback", SkinPath::feedback, "once, by feedback"},
    {"compute", SkinPath::compute, "once, GLES 3.1"},
    {"crowd", SkinPath::crowd, "as crowds are, baked"},
};
// Those that take any pose, as a window's blends want it: all but the last.
inline constexpr std::span<const NamedSkinPath> kPosedPaths(kSkinPaths, std::size(kSkinPaths) - 1);

}  // namespace marrow::tools
