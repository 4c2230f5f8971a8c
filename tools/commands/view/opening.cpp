#include "commands/view/opening.h"

#include <chrono>
#include <exception>
#include <utility>

#include "common/formats.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::tools {

Source open_source(const std::string& path, const std::string& images_from, Opens opens) {
  Source source;
  // A skeleton that is made takes the place of skins.
  static_cast<OpenedModel&>(source) =
      open_model(path, opens, [&](const cook::RawScene& scene, const cook::CookOptions& by) {
        if (by.prepare.auto_skeleton.empty()) source.skins = skin_joints(scene);
      });
  source.images = places_of(path, images_from);
  return source;
}

void Opening::watch(std::vector<std::string> reads) {
  reads_ = std::move(reads);
  std::vector<std::string> all = reads_;
  all.insert(all.end(), also_.begin(), also_.end());
  watch_.set(std::move(all), began_);
}

Source Opening::open(const std::string& path) {
  began_ = Watch::now();
  Source source = open_source(path, images_from_, opens_);
  path_ = path;
  watch(source.reads);
  return source;
}

void Opening::begin(const std::string& path) {
  busy_with_ = path;
  began_ = Watch::now();
  coming_ = std::async(std::launch::async, open_source, path, images_from_, opens_);
}

std::optional<Source> Opening::poll() {
  if (!coming_.valid()) {
    if (!next_.empty()) {
      begin(std::exchange(next_, ""));
    } else if ((at_once_ || watch_.is_due()) && watch_.changed()) {
      begin(path_);
    }
  }
  if (!coming_.valid()) return std::nullopt;
  if (!at_once_ && coming_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  const std::string path = std::exchange(busy_with_, "");
  try {
    Source source = coming_.get();
    error_.clear();
    path_ = path;
    watch(source.reads);
    return source;
  } catch (const std::exception& why) {
    error_ = why.what();
    // What it was made from the last time may mend it.
    if (path == path_) watch(reads_);
    return std::nullopt;
  }
}

GraphOnDisk::GraphOnDisk(std::string wanted, bool at_once) : wanted_(std::move(wanted)), at_once_(at_once) {
  if (has_extension(wanted_, ".toml")) reads_ = wanted_;
  if (has_extension(wanted_, ".mrw")) reads_ = wanted_.substr(wanted_.find('@') + 1);  // NAME@PACK.mrw or PACK.mrw
}

FoundGraph GraphOnDisk::read(const std::string& path, const File& file) {
  const std::timespec began = Watch::now();
  if (!reads_.empty()) watch_.set({reads_}, began);
  return find_graph(path, file, wanted_);
}

std::optional<FoundGraph> GraphOnDisk::poll(const std::string& path, const File& file) {
  if (reads_.empty() || (!at_once_ && !watch_.is_due()) || !watch_.changed()) return std::nullopt;
  try {
    FoundGraph out = read(path, file);
    error_.clear();
    return out;
  } catch (const std::exception& why) {
    error_ = why.what();
    return std::nullopt;
  }
}

}  // namespace marrow::tools
