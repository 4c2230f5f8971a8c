#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <filesystem>

#include "common/failure.h"
#include "disk/files.h"
#include "jobs/cache.h"
#include "jobs/store.h"

namespace marrow::tools {
namespace {

namespace fs = std::filesystem;

bool is_own(const fs::path& path) {
  std::string name = path.filename().string();
  if (name.starts_with('.') && name.ends_with(".tmp")) name = name.substr(1, name.size() - 5);
  return is_entry(name) && path.parent_path().filename() == name.substr(0, 2);
}

// DIR/ab/abcdef….cooked
class FolderStore final : public Store {
 public:
  FolderStore(const std::string& folder, std::uint64_t most_bytes) : Store(folder), most_bytes_(most_bytes) {}

  std::optional<std::string> get(const std::string& name) override {
    const std::string path = file_of(name);
    try {
      const AlignedBytes bytes = read_file(path);
      ::utimensat(AT_FDCWD, path.c_str(), nullptr, 0);  // it was just used
      return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    } catch (const Failure&) {
      return std::nullopt;
    }
  }

  void put(const std::string& name, std::string_view bytes) override {
    try {
      const std::string path = file_of(name);
      create_folders(fs::path(path).parent_path().string());
      write_file_atomically(path, bytes);
      has_grown_ = true;
    } catch (const Failure& failure) {
      note(std::string("the cache is not kept: ") + failure.what());
    }
  }

  void reject(const std::string&) override {}  // it is replaced

  void end() override {
    if (!has_grown_) return;
    struct Entry {
      fs::file_time_type used;
      std::uint64_t bytes;
      fs::path path;
    };
    std::vector<Entry> entries;
    std::uint64_t sum = 0;
    std::error_code error;
    // Another process may remove what is listed here.
    for (fs::recursive_directory_iterator at(place(), error), end; !error && at != end; at.increment(error)) {
      if (at.depth() > 1) at.disable_recursion_pending();
      std::error_code gone;
      if (at.depth() != 1 || !is_own(at->path()) || !at->is_regular_file(gone)) continue;
      const Entry entry{at->last_write_time(gone), at->file_size(gone), at->path()};
      if (gone) continue;
      sum += entry.bytes;
      entries.push_back(entry);
    }
    std::ranges::sort(entries, {}, &Entry::used);
    for (const Entry& entry : entries) {
      if (sum <= most_bytes_) break;
      std::error_code ignored;
      fs::remove(entry.path, ignored);
      sum -= entry.bytes;
    }
  }

 private:
  std::string file_of(const std::string& name) const { return (fs::path(place()) / name.substr(0, 2) / name).string(); }
  std::uint64_t most_bytes_;
  std::atomic<bool> has_grown_{false};
};

}  // namespace

std::unique_ptr<Store> folder_store(const std::string& folder, std::uint64_t most_bytes) {
  return std::make_unique<FolderStore>(folder, most_bytes);
}

}  // namespace marrow::tools
