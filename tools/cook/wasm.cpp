// The cooker for WebAssembly: what JavaScript calls, and what it is asked. See docs/cooking/library.md.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "common/failure.h"
#include "marrow/cook.h"
#include "text/printable.h"
#include "wasm/throw.h"

extern "C" {
// How many bytes the file of this name has; less than 0: there is no such file.
MARROW_IMPORT("size") double marrow_size(const char* name, std::size_t length);
// Its first bytes.
MARROW_IMPORT("read") void marrow_read(const char* name, std::size_t length, std::byte* to, std::size_t count);
MARROW_IMPORT("progress") void marrow_progress(int stage, std::size_t done, std::size_t count);
}

namespace marrow::cook {
namespace {

class PageFiles : public Files {
 public:
  std::vector<std::byte> read(const std::string& name, std::uint64_t most) override {
    const double size = marrow_size(name.data(), name.size());
    if (size < 0)
      throw tools::Failure(tools::Exit::io, name, "", kNoSuchFile,
                           "drop " + tools::printable(name) + " together with the model");
    if (std::min(size, static_cast<double>(most)) > static_cast<double>(kMostBytes)) throw too_large(name);
    std::vector<std::byte> out(static_cast<std::size_t>(std::min(size, static_cast<double>(most))));
    marrow_read(name.data(), name.size(), out.data(), out.size());
    return out;
  }
};

Result cooked;
std::string report;

[[noreturn]] void end_without_memory() {
  constexpr std::string_view kText = "out of memory";
  marrow_failed(kText.data(), kText.size(), static_cast<int>(tools::Exit::internal));
}

}  // namespace
}  // namespace marrow::cook

MARROW_EXPORT("take_memory") void* take_memory(std::size_t size) {
  return std::malloc(size);
}

// Cooks the file of this name by options as marrow.toml has them.
MARROW_EXPORT("cook")
void cook_in_page(const char* name, std::size_t name_length, const char* options, std::size_t options_length) {
  using namespace marrow::cook;
  std::set_new_handler(end_without_memory);
  PageFiles files;
  const Host host{
      files, nullptr,
      [](Stage stage, std::size_t done, std::size_t count) { marrow_progress(static_cast<int>(stage), done, count); },
      nullptr};
  cooked = cook({name, name_length}, read_options("options", {options, options_length}), host);
  report = cooked.report.dump();
}

MARROW_EXPORT("file") const std::byte* cooked_file() {
  return marrow::cook::cooked.file.data();
}
MARROW_EXPORT("file_size") std::size_t cooked_file_size() {
  return marrow::cook::cooked.file.size();
}
MARROW_EXPORT("report") const char* cooked_report() {
  return marrow::cook::report.data();
}
MARROW_EXPORT("report_size") std::size_t cooked_report_size() {
  return marrow::cook::report.size();
}
