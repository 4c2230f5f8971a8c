#include "pose/named_clip.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "common/failure.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::tools {
namespace {

std::uint32_t number_in(const std::string& text, std::uint32_t count) {
  std::uint32_t index = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, index);
  return error == std::errc() && stop == end ? std::min(index, count) : count;
}

// What clips move: skeletons, or the references of a pack.
struct Owners {
  explicit Owners(const File& of) : file(of), pack(of.reference_count() > 0) {}
  std::uint32_t count() const { return pack ? file.reference_count() : file.skeleton_count(); }
  std::string name(std::uint32_t owner) const { return pack ? file.reference(owner).name : file.skeleton(owner).name; }
  std::uint32_t find(const std::string& wanted) const {
    std::uint32_t owner = 0;
    while (owner < count() && name(owner) != wanted) ++owner;
    return owner < count() ? owner : number_in(wanted, count());
  }
  const File& file;
  bool pack;
};

std::uint32_t clip_called(const File& file, const std::string& wanted) {
  const std::uint32_t by_name = file.find_clip(wanted.c_str());
  return by_name < file.clip_count() ? by_name : number_in(wanted, file.clip_count());
}

std::uint32_t clip_called(const File& file, const std::string& wanted, std::uint32_t owner) {
  const std::uint32_t by_name = file.find_clip(wanted.c_str(), owner);
  if (by_name < file.clip_count()) return by_name;
  const std::uint32_t by_number = number_in(wanted, file.clip_count());
  return by_number < file.clip_count() && file.clip(by_number).skeleton == owner ? by_number : file.clip_count();
}

[[noreturn]] void refuse(const std::string& path, const File& file, const Owners& owners, const std::string& wanted) {
  std::vector<std::string> names, numbered;
  for (std::uint32_t i = 0; i < file.clip_count(); ++i) {
    const Clip clip = file.clip(i);
    const std::string full = clip.name + (owners.count() > 1 ? "@" + owners.name(clip.skeleton) : std::string());
    names.emplace_back(wanted.find('@') == std::string::npos ? clip.name : full);
    numbered.push_back(std::to_string(i) + " \"" + printable(full) + "\"");
  }
  const std::string question = did_you_mean(wanted, names);
  throw Failure(Exit::usage, path, "", "no clip \"" + printable(wanted) + "\"",
                names.empty() ? "the file has no clips"
                              : question + (question.empty() ? "" : " ") + "there are " + listed(numbered));
}

}  // namespace

NamedClip find_clip(const std::string& path, const File& file, const std::string& wanted) {
  const std::uint32_t whole = clip_called(file, wanted);
  if (whole < file.clip_count()) return {whole, false};
  const Owners owners(file);
  // Names may have an @ of their own.
  for (std::size_t at = wanted.find('@'); at != std::string::npos; at = wanted.find('@', at + 1)) {
    const std::uint32_t owner = owners.find(wanted.substr(at + 1));
    if (owner == owners.count()) continue;
    const std::uint32_t clip = clip_called(file, wanted.substr(0, at), owner);
    if (clip < file.clip_count()) return {clip, true};
  }
  refuse(path, file, owners, wanted);
}

}  // namespace marrow::tools
