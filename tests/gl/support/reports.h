// GL errors that a watch was told of.
#pragma once

#include <string>
#include <vector>

#include "marrow/gles3.h"

namespace marrow::test {

struct Report {
  std::string call;
  unsigned error;
  bool operator==(const Report&) const = default;
};

inline gles3::ErrorWatch watch_into(std::vector<Report>& reports) {
  gles3::ErrorWatch watch;
  watch.user = &reports;
  watch.report = [](void* user, const char* call, unsigned error) {
    static_cast<std::vector<Report>*>(user)->push_back({call, error});
  };
  return watch;
}

}  // namespace marrow::test
