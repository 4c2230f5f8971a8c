// Where vertices can be skinned: the one list of it that `marrow render` and `marrow view` offer.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace marrow::tools {

enum class SkinPath : std::uint8_t { cpu, ubo };

struct NamedSkinPath {
  SkinPath path;
  const char* name;   // as on the command line
  const char* about;  // of --help
};
inline constexpr NamedSkinPath kSkinPaths[] = {
    {SkinPath::cpu, "cpu", "skinned by the processor"},
    {SkinPath::ubo, "ubo", "by the vertex shader"},
};

constexpr std::optional<SkinPath> parse_skin_path(std::string_view name) {
  for (const NamedSkinPath& named : kSkinPaths)
    if (name == named.name) return named.path;
  return std::nullopt;
}

}  // namespace marrow::tools
