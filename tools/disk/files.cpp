#include "disk/files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <set>
#include <utility>

#include "common/failure.h"

namespace marrow::tools {
namespace {

[[noreturn]] void fail(const std::string& path, const char* rule, int error) {
  throw Failure(Exit::io, path, "", rule, std::strerror(error));
}

// Closes on every way out.
struct Descriptor {
  int fd;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
};

void write_all(int fd, std::span<const std::byte> bytes, const std::string& path) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = ::write(fd, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path, "cannot write", errno);
    done += static_cast<std::size_t>(n);
  }
}

}  // namespace

RegularFile::RegularFile(std::string path) : path_(std::move(path)) {
  Descriptor file{::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
  if (file.fd < 0) fail(path_, "cannot open", errno);
  struct stat info {};
  if (::fstat(file.fd, &info) != 0) fail(path_, "cannot read", errno);
  if (S_ISDIR(info.st_mode)) fail(path_, "cannot read", EISDIR);
  if (!S_ISREG(info.st_mode)) throw Failure(Exit::io, path_, "", "cannot read", "not a regular file");
  size_ = static_cast<std::uint64_t>(info.st_size);
  fd_ = std::exchange(file.fd, -1);
}

RegularFile::~RegularFile() {
  ::close(fd_);
}

void RegularFile::read(std::span<std::byte> out) const {
  for (std::size_t done = 0; done < out.size();) {
    const ssize_t n = ::read(fd_, out.data() + done, out.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path_, "cannot read", errno);
    if (n == 0) throw Failure(Exit::io, path_, "", "cannot read", "the file ended early; was it being written?");
    done += static_cast<std::size_t>(n);
  }
}

AlignedBytes read_file(const std::string& path) {
  const RegularFile file(path);
  if (file.size() > UINT32_MAX) fail(path, "cannot read", EFBIG);
  AlignedBytes bytes(static_cast<std::size_t>(file.size()));
  file.read({bytes.data(), bytes.size()});
  return bytes;
}

namespace {

// Temporary files that are there. Whoever makes, renames or removes one holds the mutex.
struct Unfinished {
  std::mutex mutex;
  std::set<std::string> paths;
};
Unfinished& unfinished() {
  static auto* const all = new Unfinished;  // for threads that outlive main()
  return *all;
}

// Opens the temporary file and locks it. Another process may have renamed it away before the lock was ours: then its
// name belongs to no file or to a new one.
int open_locked(const std::string& temporary, const std::string& path) {
  for (;;) {
    std::unique_lock guard(unfinished().mutex);
    Descriptor file{::open(temporary.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666)};
    if (file.fd < 0) fail(path, "cannot write", errno);
    // File systems without locks exist; there, nothing but a race between two cooks is lost.
    while (::flock(file.fd, LOCK_EX | LOCK_NB) != 0 && (errno == EINTR || errno == EWOULDBLOCK)) {
      guard.unlock();  // another process may take its time
      while (::flock(file.fd, LOCK_EX) != 0 && errno == EINTR) {
      }
      guard.lock();
    }
    struct stat ours {
    }, named{};
    if (::fstat(file.fd, &ours) != 0) fail(path, "cannot write", errno);
    if (!S_ISREG(ours.st_mode)) throw Failure(Exit::io, path, "", "cannot write", temporary + " is in the way");
    if (::lstat(temporary.c_str(), &named) != 0 || named.st_ino != ours.st_ino || named.st_dev != ours.st_dev) continue;
    unfinished().paths.insert(temporary);
    return std::exchange(file.fd, -1);
  }
}

// What has the name already is a regular file, or nothing.
void expect_free_name(const std::string& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) == 0 && S_ISDIR(info.st_mode))
    throw Failure(Exit::io, path, "", "cannot write", "it is a directory; name a file in it");
  if (::stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode))
    throw Failure(Exit::io, path, "", "cannot write", "there is something that is not a regular file");
  if (!std::filesystem::path(path).has_filename()) fail(path, "cannot write", ENOENT);
}

void expect_usable_folder(const std::string& path, const std::string& folder) {
  struct stat info {};
  if (::stat(folder.c_str(), &info) != 0)
    throw Failure(Exit::io, path, "", "cannot write", "there is no folder " + folder + "; make it, or name another");
  if (!S_ISDIR(info.st_mode)) throw Failure(Exit::io, path, "", "cannot write", folder + " is no folder");
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throw Failure(Exit::io, path, "", "cannot write into the folder " + folder, std::strerror(errno));
}

// The renaming itself reaches the disk. Not every file system can be asked to, and the file is whole either way.
void flush_folder(const std::filesystem::path& folder) {
  const Descriptor directory{::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
  if (directory.fd >= 0) ::fsync(directory.fd);
}

}  // namespace

StagedFile::StagedFile(std::string path, std::span<const std::byte> bytes) : path_(std::move(path)) {
  expect_free_name(path_);
  const std::filesystem::path target(path_);
  temporary_ = (target.parent_path() / ("." + target.filename().string() + ".tmp")).string();
  fd_ = open_locked(temporary_, path_);
  try {
    if (::ftruncate(fd_, 0) != 0) fail(path_, "cannot write", errno);
    write_all(fd_, bytes, path_);
    if (::fsync(fd_) != 0) fail(path_, "cannot write", errno);
  } catch (...) {
    discard();
    throw;
  }
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : path_(std::move(other.path_)), temporary_(std::move(other.temporary_)), fd_(std::exchange(other.fd_, -1)) {}

StagedFile::~StagedFile() {
  discard();
}

void StagedFile::commit() {
  commit_all({this, 1});
}

void StagedFile::commit_all(std::span<StagedFile> files) {
  {
    const std::lock_guard guard(unfinished().mutex);
    for (const StagedFile& file : files) file.rename();
  }
  for (StagedFile& file : files) file.finish();
}

void StagedFile::rename() const {
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail(path_, "cannot write", errno);
  unfinished().paths.erase(temporary_);
}

void StagedFile::finish() {
  if (::close(std::exchange(fd_, -1)) != 0 && errno != EINTR) fail(path_, "cannot write", errno);
  flush_folder(std::filesystem::path(path_).parent_path());
}

void StagedFile::discard() {
  if (fd_ < 0) return;
  const std::lock_guard guard(unfinished().mutex);
  if (unfinished().paths.erase(temporary_) > 0) ::unlink(temporary_.c_str());  // while the lock is ours
  ::close(std::exchange(fd_, -1));
}

void abandon_unfinished_files() {
  unfinished().mutex.lock();
  for (const std::string& path : unfinished().paths) ::unlink(path.c_str());
}

void write_file_atomically(const std::string& path, std::span<const std::byte> bytes) {
  StagedFile(path, bytes).commit();
}

void write_file_atomically(const std::string& path, std::string_view text) {
  write_file_atomically(path, std::as_bytes(std::span(text.data(), text.size())));
}

void expect_writable(const std::string& path) {
  expect_free_name(path);
  const std::string folder = std::filesystem::path(path).parent_path().string();
  expect_usable_folder(path, folder.empty() ? "." : folder);
}

void expect_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::path made = std::filesystem::absolute(path, error);
  while (made.has_relative_path() && !std::filesystem::exists(made, error)) made = made.parent_path();
  expect_usable_folder(path, made.string());
}

void create_folders(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw Failure(Exit::io, path, "", "cannot make the folder", error.message());
}

}  // namespace marrow::tools
