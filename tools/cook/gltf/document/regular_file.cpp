// Opens files that an untrusted scene names, and nothing that could block or never end.
#include "cook/gltf/document/regular_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "common/hash.h"

namespace marrow::cook::gltf {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

// Asked before opening: opening a pipe would wait for its other end for ever.
std::uint64_t size_of_regular_file(const std::string& path, const std::string& where, const Report& report) {
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
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) report.unreadable(where, "cannot read", error.message());
  return size;
}

}  // namespace

std::vector<std::byte> read_regular_file(const std::string& path, std::uint64_t at_most, const std::string& where,
                                         Report& report) {
  const std::uint64_t size = std::min(size_of_regular_file(path, where, report), at_most);
  if (size > kLargestFile) report.unsupported(where, "file too large", "split the scene; 2 GiB is the limit");
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file) report.unreadable(where, "cannot open", std::string(std::strerror(errno)));
  std::vector<std::byte> bytes(size);
  const std::size_t read = size == 0 ? 0 : std::fread(bytes.data(), 1, bytes.size(), file.get());
  if (read != bytes.size()) report.unreadable(where, "cannot read", "the file ended early; was it being written?");
  report.note_read({path, bytes.size(), tools::hash_of(bytes)});
  return bytes;
}

}  // namespace marrow::cook::gltf
