// Where vertices can be skinned: the one list of it that `marrow render` and `marrow view` offer.
#pragma once

#include <optional>
#include <string_view>

#include "marrow/gles3_skinner.h"

namespace marrow::tools {

using SkinPath = gles3::Path;

struct NamedSkinPath {
  SkinPath path;
  const char* name;   // as on the command line
  const char* about;  // of --help
};
inline constexpr NamedSkinPath kSkinPaths[] = {
    {SkinPath::cpu, "cpu", "skinned by the processor"},
    {SkinPath::ubo, "ubo", "by the vertex shader, palettes in a uniform block"},
    {SkinPath::texture, "texture", "the same, palettes in a texture"},
    {SkinPath::feedback, "feedback", "once, by transform feedback"},
    {SkinPath::compute, "compute", "once, by a compute shader (OpenGL ES 3.1)"},
};

constexpr std::optional<SkinPath> parse_skin_path(std::string_view name) {
  for (const NamedSkinPath& named : kSkinPaths)
    if (name == named.name) return named.path;
  return std::nullopt;
}

}  // namespace marrow::tools
