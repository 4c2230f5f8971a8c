#include "commands/watch/folder_watch.h"

#include <sys/stat.h>
#include <unistd.h>
#ifdef __linux__
#include <poll.h>
#include <sys/inotify.h>
#endif

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <thread>
#include <utility>

#include <fmt/format.h>

namespace marrow::tools {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

constexpr milliseconds kBetweenLooks{250};

}  // namespace

void Changes::add(const Changes& more) {
  paths.insert(more.paths.begin(), more.paths.end());
  anything |= more.anything;
}

bool Changes::touch(const fs::path& path) const {
  if (anything) return true;
  for (fs::path at = path;; at = at.parent_path()) {
    if (paths.contains(at)) return true;
    if (at == at.parent_path()) return false;
  }
}

FolderWatch::~FolderWatch() {
  if (inotify_ >= 0) ::close(inotify_);
}

bool FolderWatch::add(const fs::path& folder, bool with_all_below) {
  bool is_new = add_one(folder);
  if (!with_all_below) return is_new;
  // Watched before it is listed: what comes in between is told.
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code gone;
    if (at->symlink_status(gone).type() == fs::file_type::directory) is_new |= add(at->path(), true);
  }
  return is_new;
}

FolderWatch::Stamps FolderWatch::look_into(const fs::path& folder) {
  Stamps out;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    struct stat info {};
    if (::stat(at->path().c_str(), &info) != 0) continue;
#ifdef __APPLE__
    const timespec& changed = info.st_mtimespec;
#else
    const timespec& changed = info.st_mtim;
#endif
    // What is in a folder is looked at by itself, if at all.
    const bool is_folder = S_ISDIR(info.st_mode);
    out[at->path()] = {is_folder ? 0 : std::int64_t{changed.tv_sec} * 1'000'000'000 + changed.tv_nsec,
                       is_folder ? 0 : static_cast<std::uint64_t>(info.st_size),
                       static_cast<std::uint64_t>(info.st_ino)};
  }
  return out;
}

Changes FolderWatch::look() {
  Changes out;
  for (auto& [folder, before] : looked_at_) {
    Stamps now = look_into(folder);
    for (const auto& [path, stamp] : now) {
      const auto old = before.find(path);
      if (old == before.end() || old->second != stamp) out.paths.insert(path);
    }
    for (const auto& [path, stamp] : before)
      if (!now.contains(path)) out.paths.insert(path);
    before = std::move(now);
  }
  return out;
}

void FolderWatch::go_over_to_looking(int error) {
  fmt::print(stderr, "inotify: warning: {}; looking every {} ms instead\n",
             error == ENOSPC ? "fs.inotify.max_user_watches is reached" : std::strerror(error), kBetweenLooks.count());
  if (inotify_ >= 0) ::close(std::exchange(inotify_, -1));
  folder_of_.clear();
  for (auto& [folder, stamps] : looked_at_) stamps = look_into(folder);
}

#ifdef __linux__

namespace {

// A file counts when whoever writes it closes it.
constexpr std::uint32_t kEvents =
    IN_CLOSE_WRITE | IN_CREATE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;

// A new name of a file that is whole already.
bool is_link(const fs::path& path) {
  struct stat info {};
  return ::lstat(path.c_str(), &info) == 0 && (S_ISLNK(info.st_mode) || info.st_nlink > 1);
}

}  // namespace

FolderWatch::FolderWatch(bool poll) {
  if (poll) return;
  inotify_ = ::inotify_init1(IN_CLOEXEC | IN_NONBLOCK);
  if (inotify_ < 0) go_over_to_looking(errno);
}

bool FolderWatch::add_one(const fs::path& folder) {
  const bool is_new = !looked_at_.contains(folder);
  if (inotify_ >= 0) {
    const int watch = ::inotify_add_watch(inotify_, folder.c_str(), kEvents);
    if (watch >= 0) {
      folder_of_[watch] = folder;
      looked_at_[folder];
      return is_new;
    }
    if (errno == ENOENT || errno == ENOTDIR || errno == EACCES) return false;
    go_over_to_looking(errno);
  }
  if (is_new) looked_at_[folder] = look_into(folder);
  return is_new;
}

void FolderWatch::note(const void* bytes, Changes& changes) {
  inotify_event event;
  std::memcpy(&event, bytes, sizeof event);
  if ((event.mask & IN_Q_OVERFLOW) != 0) changes.anything = true;
  const auto folder = folder_of_.find(event.wd);
  if (folder == folder_of_.end()) return;
  if ((event.mask & (IN_IGNORED | IN_DELETE_SELF | IN_MOVE_SELF)) != 0) {
    changes.paths.insert(folder->second);
    looked_at_.erase(folder->second);
    if ((event.mask & IN_IGNORED) != 0) folder_of_.erase(folder);
    return;
  }
  const fs::path path = folder->second / (static_cast<const char*>(bytes) + sizeof event);
  if ((event.mask & IN_CREATE) != 0 && (event.mask & IN_ISDIR) == 0 && !is_link(path)) return;  // closed later
  changes.paths.insert(path);
}

Changes FolderWatch::told() {
  Changes out;
  alignas(inotify_event) char bytes[16384];
  for (ssize_t n = 0; (n = ::read(inotify_, bytes, sizeof bytes)) > 0;) {
    for (std::size_t at = 0; at < static_cast<std::size_t>(n);) {
      note(bytes + at, out);
      inotify_event event;
      std::memcpy(&event, bytes + at, sizeof event);
      at += sizeof event + event.len;
    }
  }
  return out;
}

#else

FolderWatch::FolderWatch(bool) {}

bool FolderWatch::add_one(const fs::path& folder) {
  const bool is_new = !looked_at_.contains(folder);
  if (is_new) looked_at_[folder] = look_into(folder);
  return is_new;
}

#endif

Changes FolderWatch::wait(milliseconds most) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  for (;;) {
    const auto left = most - std::chrono::duration_cast<milliseconds>(Clock::now() - start);
    const bool for_ever = most.count() < 0;
#ifdef __linux__
    if (inotify_ >= 0) {
      pollfd ready{inotify_, POLLIN, 0};
      ::poll(&ready, 1, for_ever ? -1 : static_cast<int>(std::max<milliseconds::rep>(0, left.count())));
      if (Changes out = told(); !out.empty()) return out;
      if (!for_ever && Clock::now() - start >= most) return {};
      continue;
    }
#endif
    if (Changes out = look(); !out.empty()) return out;
    if (!for_ever && left.count() <= 0) return {};
    std::this_thread::sleep_for(for_ever ? kBetweenLooks : std::min(left, kBetweenLooks));
  }
}

}  // namespace marrow::tools
