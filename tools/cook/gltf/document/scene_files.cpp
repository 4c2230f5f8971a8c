#include "cook/gltf/document/scene_files.h"

#include "common/failure.h"
#include "common/hash.h"
#include "cook/gltf/document/uri.h"

namespace marrow::cook::gltf {
namespace {

// What the caller's files say, at the place in the scene.
template <class Ask>
auto located(const std::string& where, const Report& report, const Ask& ask) {
  try {
    return ask();
  } catch (const tools::Failure& failure) {
    report.fail(failure.code(), where, failure.rule(), failure.advice());
  }
}

}  // namespace

std::vector<std::byte> read_scene_file(Files& files, const std::string& name, std::uint64_t at_most,
                                       const std::string& where, Report& report) {
  std::vector<std::byte> bytes = located(where, report, [&] {
    std::vector<std::byte> read = files.read(name, at_most);
    if (read.size() > kMostBytes) throw too_large(name);
    return read;
  });
  report.note_read({name, bytes.size(), tools::hash_of(bytes)});
  return bytes;
}

std::string name_beside(Files* files, const std::string& scene, const std::string& uri, const char* what,
                        const std::string& where, const Report& report) {
  const std::string relative = decode_relative_uri(uri, where, report);
  if (files == nullptr)
    report.unreadable(where, "cannot read", std::string("a scene in memory has no folder; embed the ") + what);
  return located(where, report, [&] { return files->beside(scene, relative); });
}

}  // namespace marrow::cook::gltf
