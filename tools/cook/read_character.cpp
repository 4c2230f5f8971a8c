#include <memory>
#include <span>
#include <utility>

#include "common/hash.h"
#include "common/load_mrw.h"
#include "cook/prepare/match_skeletons.h"
#include "cook/road.h"
#include "marrow/file.h"

namespace marrow::cook {
namespace {

// All that packs and outfits look at, cooked fast.
std::vector<std::byte> cooked_plainly(const std::string& name, const Host& host, std::vector<Read>& reads) {
  CookOptions plain;
  plain.mesh.codec = MeshCodec::none;
  plain.source.images = Images::none;
  plain.clips.raw = true;
  Result cooked = cook_source(name, plain, host);
  reads.insert(reads.end(), cooked.reads.begin(), cooked.reads.end());
  return std::move(cooked.file);
}

std::vector<std::byte> cooked_already(const std::string& name, Files& files, std::vector<Read>& reads) {
  std::vector<std::byte> bytes = files.read(name, kMostBytes);
  reads.push_back({name, bytes.size(), tools::hash_of(bytes)});
  return bytes;
}

}  // namespace

Character read_character(const std::string& name, const Host& host, std::vector<Read>& reads) {
  const bool is_cooked = name.ends_with(".mrw");
  const std::size_t first = reads.size();
  const std::vector<std::byte> bytes =
      is_cooked ? cooked_already(name, host.files, reads) : cooked_plainly(name, host, reads);
  if (first < reads.size()) reads[first].name = host.files.full_name(name);
  const auto loaded = std::make_shared<tools::LoadedFile>(
      tools::load_mrw(name, tools::AlignedBytes(std::span<const std::byte>(bytes))));
  Character out = view_character(name, loaded->file);
  out.holds = loaded;
  return out;
}

}  // namespace marrow::cook
