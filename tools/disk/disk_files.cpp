#include "disk/disk_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "common/failure.h"
#include "disk/files.h"

namespace marrow::tools {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const char* rule, const std::string& advice) {
  throw Failure(Exit::io, path, "", rule, advice);
}

// Asked before opening: to open a device may be to use it. RegularFile asks again what it has opened.
void expect_regular_file(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (error && status.type() != fs::file_type::not_found)
    fail(path, "cannot read", error.message() + "; check the name and the permissions");
  switch (status.type()) {
    case fs::file_type::regular:
      return;
    case fs::file_type::not_found:
      fail(path, cook::kNoSuchFile, "check the name");
    case fs::file_type::directory:
      fail(path, "is a directory", "name a file in it");
    default:
      fail(path, "not a regular file", "devices, pipes and sockets are never read");
  }
}

}  // namespace

std::vector<std::byte> DiskFiles::read(const std::string& path, std::uint64_t most) {
  expect_regular_file(path);
  const RegularFile file(path);
  const std::uint64_t size = std::min(file.size(), most);
  if (size > cook::kMostBytes) throw cook::too_large(path);
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  file.read(bytes);
  return bytes;
}

std::string DiskFiles::beside(const std::string& document, const std::string& relative) {
  std::error_code error;
  const fs::path folder = fs::path(document).parent_path();
  const fs::path base = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, error);
  if (error) fail(document, "cannot read the scene's folder", error.message());
  const fs::path target = fs::weakly_canonical(base / relative, error);
  if (error) fail(document, "cannot read", error.message() + "; check the name");
  if (std::mismatch(base.begin(), base.end(), target.begin(), target.end()).first != base.end())
    throw Failure(Exit::invalid, document, "", "URI not allowed",
                  "a link leads out of the scene's folder; put the file beside the scene");
  return target.string();
}

std::string DiskFiles::full_name(const std::string& path) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(path), ignored).string();
}

}  // namespace marrow::tools
