#include "marrow/cook_host.h"

namespace marrow::cook {

std::string Files::beside(const std::string& document, const std::string& relative) {
  const std::size_t folder = document.rfind('/');
  return folder == std::string::npos ? relative : document.substr(0, folder + 1) + relative;
}

tools::Failure too_large(const std::string& name) {
  return {tools::Exit::unsupported, name, "", "file too large", "split the scene; 2 GiB is the limit"};
}

const char* name_of(Stage stage) {
  constexpr const char* kNames[] = {"read", "prepare", "clip", "mesh", "learn", "write"};
  return kNames[static_cast<int>(stage)];
}

}  // namespace marrow::cook
