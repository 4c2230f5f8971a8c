#include "commands/view/files/opening.h"

#include <chrono>
#include <exception>
#include <utility>

namespace marrow::tools {

void Opening::watch(std::vector<std::string> reads) {
  reads_ = std::move(reads);
  std::vector<std::string> all = reads_;
  all.insert(all.end(), also_.begin(), also_.end());
  watch_.set(std::move(all), began_);
}

Source Opening::open(const std::string& path) {
  began_ = Watch::now();
  Source source = open_source(path, how_);
  path_ = path;
  watch(source.reads);
  return source;
}

void Opening::begin(const std::string& path) {
  busy_with_ = path;
  began_ = Watch::now();
  coming_ = std::async(std::launch::async, open_source, path, how_);
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

}  // namespace marrow::tools
