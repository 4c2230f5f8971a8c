#include "jobs/store.h"

namespace marrow::tools {

std::string Store::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

void Store::note(const std::string& trouble) {
  const std::lock_guard lock(mutex_);
  trouble_ = trouble;
}

bool is_http(const std::string& place) {
  return place.starts_with("http://") || place.starts_with("https://");
}

}  // namespace marrow::tools
