#include "jobs/cache.h"

#include <fcntl.h>
#include <link.h>
#include <sys/stat.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>
#include <vector>

#include "common/failure.h"
#include "common/hash.h"
#include "disk/files.h"

namespace marrow::tools {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::size_t kHashDigits = 32;
constexpr const char *kInputs = ".inputs", *kCooked = ".cooked";

std::string_view text_of(const AlignedBytes& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

std::optional<AlignedBytes> try_read(const std::string& path) {
  try {
    return read_file(path);
  } catch (const Failure&) {
    return std::nullopt;
  }
}

// The program and the libraries that it runs with: another build may cook other bytes.
const std::string& build_identity() {
  static const std::string identity = [] {
    std::vector<std::string> files = {"/proc/self/exe"};
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* out) {
          if (info->dlpi_name != nullptr && info->dlpi_name[0] == '/')
            static_cast<std::vector<std::string>*>(out)->push_back(info->dlpi_name);
          return 0;
        },
        &files);
    Hasher hasher;
    for (const std::string& file : files) {
      const std::optional<AlignedBytes> bytes = try_read(file);
      hasher.add(bytes ? hash_of({bytes->data(), bytes->size()}) : file);
    }
    return hasher.hex();
  }();
  return identity;
}

std::string scene_key(const std::string& scene_hash, const std::string& options) {
  Hasher hasher;
  hasher.add(build_identity());
  hasher.add(options);
  hasher.add(scene_hash);
  return hasher.hex();
}

struct Input {
  std::string path;  // relative to the scene's folder
  std::uint64_t bytes;
  std::string hash;
};

std::string cooked_key(const std::string& scene, const std::vector<Input>& inputs) {
  Hasher hasher;
  hasher.add(scene);
  for (const Input& input : inputs) {
    hasher.add(input.path);
    hasher.add(std::to_string(input.bytes));
    hasher.add(input.hash);
  }
  return hasher.hex();
}

// Of an entry by its name as well: another one's, copied over it, is none.
std::string entry_hash(const std::string& path, std::string_view body) {
  Hasher hasher;
  hasher.add(fs::path(path).filename().string());
  hasher.add(body);
  return hasher.hex();
}

// A file of the cache without the hash in front.
std::optional<std::string> read_checked(const std::string& path) {
  const std::optional<AlignedBytes> bytes = try_read(path);
  if (!bytes || bytes->size() < kHashDigits) return std::nullopt;
  const std::string_view text = text_of(*bytes);
  if (entry_hash(path, text.substr(kHashDigits)) != text.substr(0, kHashDigits)) return std::nullopt;
  return std::string(text.substr(kHashDigits));
}

void write_checked(const std::string& path, const std::string& body) {
  create_folders(fs::path(path).parent_path().string());
  write_file_atomically(path, entry_hash(path, body) + body);
}

// Inputs as "BYTES PATH" a line.
std::string to_text(const std::vector<Input>& inputs) {
  std::string out;
  for (const Input& input : inputs) out += std::to_string(input.bytes) + ' ' + input.path + '\n';
  return out;
}

// With the hashes that the files have now; nothing if one cannot be read that far.
std::optional<std::vector<Input>> read_inputs(const std::string& text, const fs::path& folder) {
  std::vector<Input> out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    Input input;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), input.bytes);
    if (error != std::errc() || end == line.data() + line.size()) return std::nullopt;
    input.path = line.substr(static_cast<std::size_t>(end - line.data()) + 1);
    const std::optional<AlignedBytes> bytes = try_read((folder / input.path).string());
    if (!bytes || bytes->size() < input.bytes) return std::nullopt;
    input.hash = hash_of({bytes->data(), static_cast<std::size_t>(input.bytes)});
    out.push_back(std::move(input));
  }
  return out;
}

bool is_own(const fs::path& path) {
  std::string name = path.filename().string();
  if (name.starts_with('.') && name.ends_with(".tmp")) name = name.substr(1, name.size() - 5);
  return name.size() > kHashDigits && name.find_first_not_of("0123456789abcdef") == kHashDigits &&
         path.parent_path().filename() == name.substr(0, 2) &&
         (name.substr(kHashDigits) == kInputs || name.substr(kHashDigits) == kCooked);
}

}  // namespace

std::string relative_to_scene(const std::string& scene, const std::string& path) {
  std::error_code ignored;
  const fs::path folder = fs::weakly_canonical(fs::absolute(scene).parent_path(), ignored);
  return fs::path(path).lexically_relative(folder).string();
}

std::string Cache::file_of(const std::string& key, const char* extension) const {
  return (fs::path(folder_) / key.substr(0, 2) / (key + extension)).string();
}

std::optional<cook::Result> Cache::find(const std::string& path, const std::string& options) const {
  const std::optional<AlignedBytes> scene = try_read(path);
  if (!scene) return std::nullopt;
  const std::string scene_hash = hash_of({scene->data(), scene->size()});
  const std::string key = scene_key(scene_hash, options);
  const std::optional<std::string> listed = read_checked(file_of(key, kInputs));
  if (!listed) return std::nullopt;
  const fs::path folder = fs::path(path).parent_path();
  const std::optional<std::vector<Input>> inputs = read_inputs(*listed, folder);
  if (!inputs) return std::nullopt;
  const std::string file = file_of(cooked_key(key, *inputs), kCooked);
  const std::optional<std::string> body = read_checked(file);
  if (!body) return std::nullopt;
  // The report's size, a blank, the report, the cooked file.
  std::size_t report_bytes = 0;
  const auto [end, error] = std::from_chars(body->data(), body->data() + body->size(), report_bytes);
  const std::size_t start = static_cast<std::size_t>(end - body->data()) + 1;
  if (error != std::errc() || start > body->size() || report_bytes > body->size() - start) return std::nullopt;
  cook::Result result;
  result.report = ordered_json::parse(body->substr(start, report_bytes), nullptr, false);
  if (result.report.is_discarded()) return std::nullopt;
  const auto cooked = bytes_of(std::string_view(*body).substr(start + report_bytes));
  result.file.assign(cooked.begin(), cooked.end());
  result.reads.push_back({path, scene->size(), scene_hash});
  for (const Input& input : *inputs) {
    std::error_code ignored;
    result.reads.push_back(
        {fs::weakly_canonical(fs::absolute(folder / input.path), ignored).string(), input.bytes, input.hash});
  }
  for (const std::string& used : {file, file_of(key, kInputs)}) ::utimensat(AT_FDCWD, used.c_str(), nullptr, 0);
  return result;
}

std::string Cache::store(const cook::Result& result, const std::string& options) const {
  if (result.reads.empty()) return "";
  std::vector<Input> inputs;
  for (std::size_t i = 1; i < result.reads.size(); ++i) {
    const cook::Read& read = result.reads[i];
    inputs.push_back({relative_to_scene(result.reads[0].name, read.name), read.bytes, read.hash});
  }
  const std::string report = result.report.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  std::string body = std::to_string(report.size()) + ' ' + report;
  body.append(reinterpret_cast<const char*>(result.file.data()), result.file.size());
  const std::string key = scene_key(result.reads[0].hash, options);
  try {
    write_checked(file_of(cooked_key(key, inputs), kCooked), body);
    write_checked(file_of(key, kInputs), to_text(inputs));
  } catch (const Failure& failure) {
    return failure.what();
  }
  return "";
}

void Cache::shrink(std::uint64_t most_bytes) const {
  struct Entry {
    fs::file_time_type used;
    std::uint64_t bytes;
    fs::path path;
  };
  std::vector<Entry> entries;
  std::uint64_t sum = 0;
  std::error_code error;
  // Another process may remove what is listed here.
  for (fs::recursive_directory_iterator at(folder_, error), end; !error && at != end; at.increment(error)) {
    if (at.depth() > 1) at.disable_recursion_pending();
    std::error_code gone;
    if (at.depth() != 1 || !is_own(at->path()) || !at->is_regular_file(gone)) continue;
    const Entry entry{at->last_write_time(gone), at->file_size(gone), at->path()};
    if (gone) continue;
    sum += entry.bytes;
    entries.push_back(entry);
  }
  std::ranges::sort(entries, [](const Entry& a, const Entry& b) { return a.used < b.used; });
  for (const Entry& entry : entries) {
    if (sum <= most_bytes) break;
    std::error_code ignored;
    fs::remove(entry.path, ignored);
    sum -= entry.bytes;
  }
}

}  // namespace marrow::tools
