// Opens files that an untrusted scene names, and nothing that could block or never end.
#include "cook/gltf/document/regular_file.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "common/failure.h"
#include "common/files.h"
#include "common/hash.h"

namespace marrow::cook::gltf {
namespace {

// Asked before opening: to open a device may be to use it. RegularFile asks again what it has opened.
void expect_regular_file(const std::string& path, const std::string& where, const Report& report) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (error && status.type() != std::filesystem::file_type::not_found) {
    report.unreadable(where, "cannot read", error.message() + "; check the name and the permissions");
  }
  switch (status.type()) {
    case std::filesystem::file_type::regular:
      break;
    case std::filesystem::file_type::not_found:
      report.unreadable(where, "no such file", "check the name");
    case std::filesystem::file_type::directory:
      report.unreadable(where, "is a directory", "name a file in it");
    default:
      report.unreadable(where, "not a regular file", "devices, pipes and sockets are never read");
  }
}

}  // namespace

std::vector<std::byte> read_regular_file(const std::string& path, std::uint64_t at_most, const std::string& where,
                                         Report& report) {
  expect_regular_file(path, where, report);
  std::uint64_t size = 0;
  std::vector<std::byte> bytes;
  try {
    const tools::RegularFile file(path);
    size = std::min(file.size(), at_most);
    if (size <= kLargestFile) bytes.resize(size);
    file.read(bytes);
  } catch (const tools::Failure& failure) {
    report.unreadable(where, failure.rule(), failure.advice());
  }
  if (size > kLargestFile) report.unsupported(where, "file too large", "split the scene; 2 GiB is the limit");
  report.note_read({path, bytes.size(), tools::hash_of(bytes)});
  return bytes;
}

}  // namespace marrow::cook::gltf
