// The one file of the tests that is compiled with the names of folders, so that all others compile alike everywhere.
#include "support/places.h"

#include <cstdlib>
#include <filesystem>

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

std::string corpus_folder() {
  const char* const given = std::getenv("MARROW_CORPUS");
  return given != nullptr ? given : in_source("../shared/corpus");
}

bool in_long_form() {
  const char* const form = std::getenv("MARROW_TESTS");
  return form != nullptr && std::string(form) == "all";
}

bool takes_part(const std::string& model) {
  return in_long_form() || std::filesystem::file_size(model) < 800'000;
}

std::string program() {
  return MARROW_PROGRAM;
}

std::string reset_shim() {
  return MARROW_RESET_SHIM;
}

std::string hand_shim() {
  return MARROW_HAND_SHIM;
}

std::string last_bit_shim() {
  return MARROW_LAST_BIT_SHIM;
}

std::string fault_shim() {
  return MARROW_FAULT_SHIM;
}

}  // namespace marrow::test
