#include "common/formats.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>

#include "asset/format.h"
#include "common/failure.h"

namespace marrow::tools {
namespace {

struct Format {
  const char *extension, *name;
};

// What other programs keep characters in.
constexpr Format kForeign[] = {
    {".3ds", "3D Studio"},
    {".abc", "Alembic"},
    {".blend", "Blender's own file"},
    {".c4d", "Cinema 4D"},
    {".dae", "COLLADA"},
    {".fbx", "Autodesk FBX"},
    {".ma", "Maya's own file"},
    {".max", "3ds Max's own file"},
    {".mb", "Maya's own file"},
    {".obj", "Wavefront OBJ"},
    {".ply", "PLY"},
    {".pmx", "MikuMikuDance"},
    {".stl", "STL"},
    {".usd", "Universal Scene Description"},
    {".usda", "Universal Scene Description"},
    {".usdc", "Universal Scene Description"},
    {".usdz", "Universal Scene Description"},
    {".x", "DirectX"},
};
// What often has a model's name and is none, by its first bytes.
constexpr LooksLike kTaken[] = {
    {"Kaydara FBX Binary", "Autodesk FBX", "turn it into glTF by tools/fbx_to_glb.sh (docs/cooking/from_dcc.md)"},
    {"; FBX", "Autodesk FBX", "turn it into glTF by tools/fbx_to_glb.sh (docs/cooking/from_dcc.md)"},
    {"BLENDER", "Blender's own file", "export glTF from it (docs/cooking/from_dcc.md)"},
    {"PK\x03\x04", "a zip archive", "unpack it"},
    {"\x1F\x8B", "packed by gzip", "unpack it"},
    {"\x28\xB5\x2F\xFD", "packed by Zstandard", "unpack it; where Blender saved it, export glTF from there"},
    {"\x89PNG", "a PNG picture", "name the model"},
    {"\xFF\xD8\xFF", "a JPEG picture", "name the model"},
    {"version https://git-lfs", "a pointer of Git LFS", "fetch the file: git lfs pull"},
    {"<", "XML or a web page", "download or export the file again"},
};
// Files that are glTF inside.
constexpr const char* kGltf[] = {".gltf", ".glb", ".vrm"};

bool starts_with(std::span<const std::byte> bytes, const void* magic, std::size_t size) {
  return bytes.size() >= size && std::memcmp(bytes.data(), magic, size) == 0;
}

bool is_cooked(std::span<const std::byte> bytes) {
  return starts_with(bytes, &format::kMagic, sizeof format::kMagic) ||
         starts_with(bytes, &format::kPackedMagic, sizeof format::kPackedMagic);
}

bool is_binary_gltf(std::span<const std::byte> bytes) {
  return starts_with(bytes, "glTF", 4);
}

// As JSON begins, behind blanks and a byte-order mark.
bool may_be_json(std::span<const std::byte> bytes) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

const Format* foreign_format(const std::string& path) {
  const auto found =
      std::ranges::find_if(kForeign, [&](const Format& format) { return has_extension(path, format.extension); });
  return found == std::end(kForeign) ? nullptr : found;
}

[[noreturn]] void refuse_foreign(const std::string& path, const Format* format, const std::string& then) {
  const std::string extension = std::filesystem::path(path).extension().string();
  const std::string name = format == nullptr ? "the format " + extension + " is unknown" : format->name;
  const std::string by_blender = has_extension(path, ".fbx") ? ", or turn it into that by tools/fbx_to_glb.sh" : "";
  throw Failure(Exit::unsupported, path, "", name + (format == nullptr ? "" : ", which is not read"),
                "export glTF (.glb) from the program that made it" + by_blender + then);
}

}  // namespace

bool has_extension(std::string_view path, std::string_view extension) {
  return path.size() > extension.size() &&
         std::ranges::equal(path.substr(path.size() - extension.size()), extension,
                            [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

const LooksLike* looks_like(std::span<const std::byte> bytes) {
  const auto found = std::ranges::find_if(
      kTaken, [&](const LooksLike& other) { return starts_with(bytes, other.begins.data(), other.begins.size()); });
  return found == std::end(kTaken) ? nullptr : found;
}

bool is_named_gltf(const std::string& path) {
  return std::ranges::any_of(kGltf, [&](const char* extension) { return has_extension(path, extension); });
}

bool is_named_bvh(const std::string& path) {
  return has_extension(path, ".bvh");
}

bool is_named_source(const std::string& path) {
  return is_named_gltf(path) || is_named_bvh(path);
}

void expect_extension(const std::string& path, std::initializer_list<const char*> extensions) {
  std::string list;
  for (const char* const extension : extensions) {
    if (has_extension(path, extension)) return;
    list.append(list.empty() ? "" : " or ").append(extension);
  }
  throw Failure(Exit::usage, path, "", "unknown format", "the output's name ends with " + list);
}

void expect_cooked(const std::string& path, std::span<const std::byte> bytes) {
  if (is_cooked(bytes)) return;
  if (is_binary_gltf(bytes) || is_named_source(path)) {
    const std::string cooked = std::filesystem::path(path).replace_extension(".mrw").string();
    const std::string kind = is_named_bvh(path) ? "BVH" : "glTF";
    throw Failure(Exit::invalid, path, "", "this is " + kind + ", not a cooked file",
                  "cook it first: marrow cook " + path + " -o " + cooked);
  }
  if (const Format* const format = foreign_format(path)) refuse_foreign(path, format, ", and cook that");
}

void expect_gltf(const std::string& path, std::span<const std::byte> bytes) {
  if (is_cooked(bytes)) {
    const std::string exported = std::filesystem::path(path).replace_extension(".glb").string();
    throw Failure(
        Exit::invalid, path, "", "this is a cooked file, not glTF",
        "name the glTF file that it was cooked from, or write one: marrow export " + path + " -o " + exported);
  }
  if (bytes.empty() || is_binary_gltf(bytes) || may_be_json(bytes) || is_named_gltf(path)) return;
  if (is_named_bvh(path))
    throw Failure(Exit::invalid, path, "", "this is motion capture (BVH), which has no mesh", "name a glTF file");
  const Format* const format = foreign_format(path);
  if (format != nullptr || std::filesystem::path(path).has_extension()) refuse_foreign(path, format, "");
}

}  // namespace marrow::tools
