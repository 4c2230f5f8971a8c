#include "jobs/cache.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>

#include "common/failure.h"
#include "common/hash.h"
#include "disk/files.h"
#include "jobs/program_hash.h"

namespace marrow::tools {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::size_t kHashDigits = 32;
constexpr const char *kInputs = ".inputs", *kCooked = ".cooked", *kFit = ".fit";

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

std::string scene_key(const std::string& scene_hash, const std::string& options) {
  Hasher hasher;
  hasher.add(program_hash());
  hasher.add(options);
  hasher.add(scene_hash);
  return hasher.hex();
}

std::string fit_key(const std::string& of) {
  Hasher hasher;
  hasher.add(program_hash());
  hasher.add(of);
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
std::string entry_hash(const std::string& name, std::string_view body) {
  Hasher hasher;
  hasher.add(name);
  hasher.add(body);
  return hasher.hex();
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

// The report's size and what cooking took, each with a blank behind it, the report, the cooked file.
std::string kept_text(const cook::Result& result, double cooking_s) {
  const std::string report = result.report.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  std::string out = fmt::format("{} {:.3f} ", report.size(), cooking_s) + report;
  out.append(reinterpret_cast<const char*>(result.file.data()), result.file.size());
  return out;
}

std::optional<Cache::Kept> read_kept(std::string_view text) {
  Cache::Kept out;
  std::size_t report_bytes = 0;
  const char* const end = text.data() + text.size();
  const auto [first, wrong] = std::from_chars(text.data(), end, report_bytes);
  if (wrong != std::errc() || first == end) return std::nullopt;
  const auto [second, wrong_time] = std::from_chars(first + 1, end, out.cooking_s);
  if (wrong_time != std::errc() || second == end) return std::nullopt;
  const std::string_view rest(second + 1, end);
  if (report_bytes > rest.size()) return std::nullopt;
  out.result.report = ordered_json::parse(rest.substr(0, report_bytes), nullptr, false);
  if (out.result.report.is_discarded()) return std::nullopt;
  const auto cooked = bytes_of(rest.substr(report_bytes));
  out.result.file.assign(cooked.begin(), cooked.end());
  return out;
}

}  // namespace

bool is_entry(const std::string& name) {
  if (name.size() <= kHashDigits || name.find_first_not_of("0123456789abcdef") != kHashDigits) return false;
  const std::string_view kind = std::string_view(name).substr(kHashDigits);
  return kind == kInputs || kind == kCooked || kind == kFit;
}

std::string relative_to_scene(const std::string& scene, const std::string& path) {
  std::error_code ignored;
  const fs::path folder = fs::weakly_canonical(fs::absolute(scene).parent_path(), ignored);
  return fs::path(path).lexically_relative(folder).string();
}

Cache::Cache(const CacheArguments& arguments) {
  for (const std::string& place : arguments.places)
    if (!place.empty())
      stores_.push_back(is_http(place) ? http_store(place, arguments) : folder_store(place, arguments.folder_bytes));
}

// An entry without the hash in front. Places before the one that has it get it as well.
std::optional<std::string> Cache::get(const std::string& name) const {
  for (std::size_t i = 0; i < stores_.size(); ++i) {
    std::optional<std::string> entry = stores_[i]->get(name);
    if (!entry) continue;
    const std::string_view text = *entry;
    if (text.size() < kHashDigits || entry_hash(name, text.substr(kHashDigits)) != text.substr(0, kHashDigits)) {
      stores_[i]->reject(name);
      continue;
    }
    for (std::size_t before = 0; before < i; ++before) stores_[before]->put(name, text);
    return entry->substr(kHashDigits);
  }
  return std::nullopt;
}

void Cache::put(const std::string& name, const std::string& body) const {
  const std::string entry = entry_hash(name, body) + body;
  for (const std::unique_ptr<Store>& store : stores_) store->put(name, entry);
}

std::optional<Cache::Kept> Cache::find(const std::string& path, const std::string& options) const {
  const std::optional<AlignedBytes> scene = try_read(path);
  if (!scene) return std::nullopt;
  const std::string scene_hash = hash_of({scene->data(), scene->size()});
  const std::string key = scene_key(scene_hash, options);
  const std::optional<std::string> listed = get(key + kInputs);
  if (!listed) return std::nullopt;
  const fs::path folder = fs::path(path).parent_path();
  const std::optional<std::vector<Input>> inputs = read_inputs(*listed, folder);
  if (!inputs) return std::nullopt;
  const std::optional<std::string> body = get(cooked_key(key, *inputs) + kCooked);
  if (!body) return std::nullopt;
  std::optional<Kept> kept = read_kept(*body);
  if (!kept) return std::nullopt;
  cook::Result& result = kept->result;
  result.reads.push_back({path, scene->size(), scene_hash});
  for (const Input& input : *inputs) {
    std::error_code ignored;
    result.reads.push_back(
        {fs::weakly_canonical(fs::absolute(folder / input.path), ignored).string(), input.bytes, input.hash});
  }
  return kept;
}

void Cache::store(const cook::Result& result, double cooking_s, const std::string& options) const {
  if (result.reads.empty()) return;
  std::vector<Input> inputs;
  for (std::size_t i = 1; i < result.reads.size(); ++i) {
    const cook::Read& read = result.reads[i];
    inputs.push_back({relative_to_scene(result.reads[0].name, read.name), read.bytes, read.hash});
  }
  const std::string key = scene_key(result.reads[0].hash, options);
  put(cooked_key(key, inputs) + kCooked, kept_text(result, cooking_s));
  put(key + kInputs, to_text(inputs));
}

std::optional<std::string> Cache::find(const std::string& key) {
  return get(fit_key(key) + kFit);
}

void Cache::keep(const std::string& key, const std::string& bytes) {
  put(fit_key(key) + kFit, bytes);
}

void Cache::end() {
  for (const std::unique_ptr<Store>& store : stores_) {
    store->end();
    if (const std::string trouble = store->trouble(); !trouble.empty())
      fmt::print(stderr, "{}: warning: {}\n", store->place(), trouble);
  }
}

}  // namespace marrow::tools
