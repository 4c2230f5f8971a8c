// The one file of the tests that is compiled with the names of folders, so that all others compile alike everywhere.
#include "support/places.h"

#include <cstdlib>

namespace marrow::test {

std::string in_source(const std::string& path) {
  return MARROW_SOURCE_DIR "/" + path;
}

std::string in_golden(const std::string& name) {
  return in_source("tests/golden/" + name);
}

std::string newt_glb() {
  return in_source("tools/sample/newt.glb");
}

std::string assets_folder() {
  const char* const given = std::getenv("MARROW_ASSETS");
  return given != nullptr ? given : in_source("../shared/assets");
}

std::string program() {
  return MARROW_PROGRAM;
}

std::string reset_shim() {
  return MARROW_RESET_SHIM;
}

}  // namespace marrow::test
