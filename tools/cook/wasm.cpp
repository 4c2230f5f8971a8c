// The cooker for WebAssembly: what JavaScript calls, and what it is asked. See docs/cooking/library.md.
//
// WebAssembly has no exceptions here: the first that is thrown is told to JavaScript, whose function throws, and ends
// the instance.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

#include "common/failure.h"
#include "marrow/cook.h"

#define MARROW_IMPORT(name) __attribute__((import_module("marrow"), import_name(name)))
#define MARROW_EXPORT(name) extern "C" __attribute__((export_name(name)))

extern "C" {
// The bytes of a file, at most `most`, in memory of take_memory(); their number to *size. Null: there is no such file.
MARROW_IMPORT("read") std::byte* marrow_read(const char* name, std::size_t length, double most, std::size_t* size);
MARROW_IMPORT("progress") void marrow_progress(int stage, std::size_t done, std::size_t count);
// Throws in JavaScript.
MARROW_IMPORT("failed") void marrow_failed(const char* text, std::size_t length, int code);
}

namespace marrow::cook {
namespace {

class PageFiles : public Files {
 public:
  std::vector<std::byte> read(const std::string& name, std::uint64_t most) override {
    std::size_t size = 0;
    std::byte* const bytes = marrow_read(name.data(), name.size(), static_cast<double>(most), &size);
    if (bytes == nullptr)
      throw tools::Failure(tools::Exit::io, name, "", kNoSuchFile, "drop it together with the model");
    std::vector<std::byte> out(bytes, bytes + size);
    std::free(bytes);
    return out;
  }
};

Result cooked;
std::string report;

}  // namespace
}  // namespace marrow::cook

// Called in place of a throw.
extern "C" void* __cxa_allocate_exception(std::size_t size) {
  return std::malloc(size);
}

extern "C" [[noreturn]] void __cxa_throw(void* thrown, std::type_info* type, void (*)(void*)) {
  using marrow::tools::Failure;
  if (*type == typeid(Failure)) {
    const auto& failure = *static_cast<const Failure*>(thrown);
    marrow_failed(failure.what(), std::strlen(failure.what()), static_cast<int>(failure.code()));
  }
  marrow_failed(type->name(), std::strlen(type->name()), static_cast<int>(marrow::tools::Exit::internal));
  std::abort();
}

MARROW_EXPORT("take_memory") void* take_memory(std::size_t size) {
  return std::malloc(size);
}

// Cooks the file of this name by options as marrow.toml has them.
MARROW_EXPORT("cook")
void cook_in_page(const char* name, std::size_t name_length, const char* options, std::size_t options_length) {
  using namespace marrow::cook;
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
