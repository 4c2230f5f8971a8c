// Which files changed: told by the kernel (inotify), or found by looking again and again.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace marrow::tools {

struct Changes {
  std::set<std::filesystem::path> paths;  // of files and folders, below the folders as they were named
  bool anything = false;                  // more may have changed than is listed

  bool empty() const { return paths.empty() && !anything; }
  void add(const Changes& more);
  // Whether `path` or a folder that it is in may have changed.
  bool touch(const std::filesystem::path& path) const;
};

class FolderWatch {
 public:
  // poll: look every 250 ms, as for drives on a network. Elsewhere than on Linux it always does.
  explicit FolderWatch(bool poll);
  ~FolderWatch();
  FolderWatch(const FolderWatch&) = delete;
  FolderWatch& operator=(const FolderWatch&) = delete;

  // Watches these too: canonical folders, alone or with all below them, links not followed. To be called again when
  // folders may have come. Returns whether one is new. Where the kernel has no watches left it goes over to looking,
  // and says so on stderr.
  bool add(const std::filesystem::path& folder, bool with_all_below);

  // Waits until something changes, at most `most` (0: does not wait; negative: for ever). A file that is written counts
  // when it is closed, one that is renamed when it has its name. Changes since the last call are not lost.
  Changes wait(std::chrono::milliseconds most);

 private:
  // What a file was when it was looked at.
  struct Stamp {
    std::int64_t changed_ns;
    std::uint64_t bytes, number;
    auto operator<=>(const Stamp&) const = default;
  };
  using Stamps = std::map<std::filesystem::path, Stamp>;

  bool add_one(const std::filesystem::path& folder);
  void go_over_to_looking(int error);
  static Stamps look_into(const std::filesystem::path& folder);
  Changes look();
  Changes told();
  void note(const void* event, Changes& changes);

  int inotify_ = -1;  // -1: looks
  std::map<int, std::filesystem::path> folder_of_;
  std::map<std::filesystem::path, Stamps> looked_at_;  // by folder; without stamps where the kernel tells
};

}  // namespace marrow::tools
