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
    {SkinPath::cpu, "cpu", "by the processor"},
    {SkinPath::ubo, "ubo", "vertex shader, uniforms"},
    {SkinPath::texture, "texture", "the same, a texture"},
    {SkinPath::feedback, "feedback", "once, by feedback"},
    {SkinPath::compute, "compute", "once, GLES 3.1"},
};

constexpr std::optional<SkinPath> parse_skin_path(std::string_view name) {
  for (const NamedSkinPath& named : kSkinPaths)
    if (name == named.name) return named.path;
  return std::nullopt;
}

}  // namespace marrow::tools
