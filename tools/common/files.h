// Whole files in and out, with Failures that name the file.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "common/aligned_bytes.h"

namespace marrow::tools {

// Reads a regular file of at most 4 GiB. Throws Failure (io).
AlignedBytes read_file(const std::string& path);

// A file in the making: its bytes are on the disk in `.NAME.tmp` beside `path`, which commit() renames. Whatever
// happens, `path` is the old file or the new one, never a part. A temporary file that a killed process left is used by
// the next that writes the same path; two processes that write it at once wait for one another.
class StagedFile {
 public:
  // Throws Failure (io), leaving nothing behind.
  StagedFile(std::string path, std::span<const std::byte> bytes);
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile();  // without commit(): `path` stays as it was
  // Throws Failure (io).
  void commit();

 private:
  void discard();
  std::string path_, temporary_;
  int fd_ = -1;
};

// Both steps at once.
void write_file_atomically(const std::string& path, std::span<const std::byte> bytes);
void write_file_atomically(const std::string& path, std::string_view text);

// Throws Failure (io).
void create_folders(const std::string& path);

}  // namespace marrow::tools
