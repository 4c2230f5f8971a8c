// Whole files in and out, with Failures that name the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "common/aligned_bytes.h"

namespace marrow::tools {

// A regular file, open for reading. What else the name may stand for by now (a pipe, a device) is refused and not
// waited for. Everything throws Failure (io).
class RegularFile {
 public:
  explicit RegularFile(std::string path);
  RegularFile(const RegularFile&) = delete;
  RegularFile& operator=(const RegularFile&) = delete;
  ~RegularFile();
  std::uint64_t size() const { return size_; }
  // The next bytes, all of them.
  void read(std::span<std::byte> out) const;

 private:
  std::string path_;
  int fd_;
  std::uint64_t size_ = 0;
};

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
  // All of them, and an interrupt comes before the first or after the last.
  static void commit_all(std::span<StagedFile> files);

 private:
  void rename() const;  // under the lock of unfinished files
  void finish();
  void discard();
  std::string path_, temporary_;
  int fd_ = -1;
};

// Removes the temporary files of this process. No file is begun and none takes its place from here on: who would, waits
// for ever. For the end of a process that is interrupted.
void abandon_unfinished_files();

// Both steps at once.
void write_file_atomically(const std::string& path, std::span<const std::byte> bytes);
void write_file_atomically(const std::string& path, std::string_view text);

// What can be known before the work about writing `path`. Throws Failure (io): its folder is not there or cannot be
// written, or something that is no regular file has its name.
void expect_writable(const std::string& path);
// The same of a folder that create_folders() is to make.
void expect_folder(const std::string& path);

// Throws Failure (io).
void create_folders(const std::string& path);

}  // namespace marrow::tools
