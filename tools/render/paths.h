// Where vertices can be skinned: the one list of it that `marrow render` and `marrow view` offer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>

namespace marrow::tools {

enum class SkinPath : std::uint8_t { cpu, ubo, texture, feedback, compute, crowd };

struct NamedSkinPath {
  SkinPath path;
  const char* name;   // as on the command line
  const char* about;  // of --help
};
inline constexpr NamedSkinPath kSkinPaths[] = {
    {SkinPath::cpu, "cpu", "by the processor"},
    {SkinPath::ubo, "ubo", "vertex shader, uniforms"},
    {SkinPath::texture, "texture", "the same, a texture"},
    {SkinPath::feedback, "feedback", "once, by feedback"},
    {SkinPath::compute, "compute", "once, GLES 3.1"},
    {SkinPath::crowd, "crowd", "as crowds are, baked"},
};
// Those that take any pose, as a window's blends want it: all but the last.
inline constexpr std::span<const NamedSkinPath> kPosedPaths(kSkinPaths, std::size(kSkinPaths) - 1);

constexpr std::optional<SkinPath> parse_skin_path(std::string_view name) {
  for (const NamedSkinPath& named : kSkinPaths)
    if (name == named.name) return named.path;
  return std::nullopt;
}

}  // namespace marrow::tools
