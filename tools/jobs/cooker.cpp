#include "jobs/cooker.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>

#include <fmt/format.h>

#include "common/failure.h"
#include "common/hash.h"
#include "disk/disk_files.h"
#include "disk/files.h"
#include "disk/thread_pool.h"
#include "text/printable.h"

namespace marrow::tools {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string named_file_text(const Order& order, const char* option, const std::string& file) {
  DiskFiles disk;
  const std::vector<std::byte> bytes = disk.read(file, cook::kMostBytes);
  return std::string("\n") + option + ' ' + relative_to_scene(order.job.in, disk.full_name(file)) + ' ' +
         hash_of(bytes);
}

// Masks and examples by where they are from the scene and by what they hold: their names in the options are from the
// working directory, which may be another the next time.
std::string named_files_text(const Order& order) {
  std::string out;
  const auto add = [&](const char* option, const std::string& file) { out += named_file_text(order, option, file); };
  for (const cook::PaintRule& rule : order.options.prepare.weights.paint) add("paint", rule.file);
  if (!order.options.learn.examples_file.empty()) add("examples", order.options.learn.examples_file);
  return out;
}

// The same of other rigs and of graphs, which packs have as well.
std::string files_of_clips_text(const Order& order) {
  std::string out;
  const auto add = [&](const char* option, const std::vector<cook::RetargetRule>& rules) {
    for (const cook::RetargetRule& rule : rules)
      for (const std::string& file : {rule.file, rule.map})
        if (!file.empty()) out += named_file_text(order, option, file);
  };
  add("retarget", order.options.retarget.clips);
  add("pose-map", order.options.retarget.poses);
  for (const cook::GraphRule& rule : order.options.graphs)
    if (rule.text.empty()) out += named_file_text(order, "graph", rule.file);
  const std::string& skeleton = order.options.skeleton_file;
  if (!skeleton.empty()) out += named_file_text(order, "skeleton", skeleton);
  return out;
}

// How much the cooker has read.
class CountingFiles : public DiskFiles {
 public:
  std::vector<std::byte> read(const std::string& path, std::uint64_t most) override {
    std::vector<std::byte> bytes = DiskFiles::read(path, most);
    bytes_ += bytes.size();
    return bytes;
  }
  std::uint64_t bytes() const { return bytes_; }

 private:
  std::uint64_t bytes_ = 0;
};

Outcome failed(const CookJob& job, Exit code, std::string text) {
  if (!text.starts_with(job.in)) text = job.in + ": " + text;
  Outcome outcome;
  outcome.code = code;
  outcome.failure = std::move(text);
  return outcome;
}

}  // namespace

std::uint64_t MemoryGate::half_of_memory() {
  return static_cast<std::uint64_t>(std::max(1L, ::sysconf(_SC_PHYS_PAGES))) *
         static_cast<std::uint64_t>(std::max(1L, ::sysconf(_SC_PAGESIZE))) / 2;
}

// Looked for once a folder; a link lies where it leads to.
std::string SettingsOf::nearest(const CookJob& job) {
  std::error_code ignored;
  if (fs::is_symlink(job.in, ignored)) return cook::find_settings(job.in, job.root).value_or("");
  const auto [at, is_new] = nearest_.try_emplace({fs::path(job.in).parent_path().string(), job.root});
  if (is_new) at->second = cook::find_settings(job.in, job.root).value_or("");
  return at->second;
}

Order SettingsOf::order(const CookJob& job, const cook::Options& command_line) {
  Order out{job, {}, {}, "", given_.empty() ? nearest(job) : given_};
  cook::Options given;
  if (!out.settings_file.empty()) {
    const auto [known, is_new] = known_.try_emplace(out.settings_file);
    if (is_new) known->second.settings = cook::read_settings(out.settings_file);
    given = cook::settings_for(known->second.settings, job.in, known->second.used);
  }
  cook::replace(given, command_line);
  out.options = cook::to_options(given);
  out.options_text = cook::canonical_text(given);
  out.given = std::move(given);
  return out;
}

void SettingsOf::warn_of_unused(const std::vector<std::string>& inputs) const {
  std::error_code ignored;
  for (const auto& [path, known] : known_) {
    const fs::path own = known.settings.folder;
    const bool all = std::ranges::any_of(inputs, [&](const std::string& input) {
      const fs::path folder = fs::weakly_canonical(fs::absolute(input), ignored);
      return fs::is_directory(folder, ignored) &&
             std::mismatch(folder.begin(), folder.end(), own.begin(), own.end()).first == folder.end();
    });
    for (std::size_t i = 0; all && i < known.settings.rules.size(); ++i)
      if (i >= known.used.size() || !known.used[i])
        fmt::print(stderr, "{}: {}: warning: no input is called \"{}\"\n", path, known.settings.rules[i].where,
                   printable(fmt::format("{}", fmt::join(known.settings.rules[i].match, "\" or \""))));
  }
}

cook::Options for_many(cook::Options given) {
  for (auto& [name, values] : given)
    for (cook::Value& value : values) value.origin.must_fit = false;
  return given;
}

Cook::Cook(const CookArguments& arguments) : a_(arguments) {
  const auto is_named = [](const std::string& place) { return !place.empty(); };
  if (std::ranges::any_of(a_.cache.places, is_named)) cache_.emplace(a_.cache);
}

// Within the bounds of memory once it is known how much has been read.
void Cook::with_host(const Order& order, const Show& show, const std::function<void(const cook::Host&)>& work) {
  CountingFiles files;
  std::optional<MemoryGate::Pass> pass;
  work({files, &all_cores(),
        [&](cook::Stage stage, std::size_t done, std::size_t count) {
          if (stage == cook::Stage::prepare && !pass)
            pass.emplace(memory_, files.bytes() << (2 * order.options.mesh.subdivide));
          if (show) show(stage, done, count);
        },
        nullptr, cache_ ? &*cache_ : nullptr});
}

Cook::Cooked Cook::cook(const Order& order, const Show& show) {
  const auto start = Clock::now();
  Cooked out;
  std::optional<cook::Result> result;
  std::string options_text = order.options_text;
  if (cache_ && !order.options.clips_only) options_text += named_files_text(order);
  if (cache_) options_text += files_of_clips_text(order);
  if (cache_) {
    if (std::optional<Cache::Kept> kept = cache_->find(order.job.in, options_text)) {
      result = std::move(kept->result);
      out.outcome.cooking_s = kept->cooking_s;
      out.outcome.from_cache = true;
    }
  }
  if (!result) {
    with_host(order, show, [&](const cook::Host& host) { result = cook::cook(order.job.in, order.given, host); });
    out.outcome.cooking_s = seconds_since(start);
    if (cache_) cache_->store(*result, out.outcome.cooking_s, options_text);
  }
  result->report["source"]["file"] = order.job.in;
  result->report["output"]["file"] = order.job.out;
  out.file = std::move(result->file);
  out.outcome.report = std::move(result->report);
  out.outcome.reads = std::move(result->reads);
  out.outcome.seconds = seconds_since(start);
  expect_not_read(order, out.outcome.reads);
  return out;
}

Outcome Cook::cook_into_folder(const Order& order) {
  return told(order, [&] {
    Cooked cooked = cook(order);
    create_folders(fs::path(order.job.out).parent_path().string());
    if (!is_there(order.job.out, cooked.file)) write_file_atomically(order.job.out, cooked.file);
    return std::move(cooked.outcome);
  });
}

Outcome Cook::learn_fit(const Order& order, std::size_t which) {
  return told(order, [&] {
    with_host(order, {}, [&](const cook::Host& host) { cook::learn_fit(order.job.in, which, order.given, host); });
    return Outcome{};
  });
}

// What went wrong is in the outcome, and how long it took.
Outcome Cook::told(const Order& order, const std::function<Outcome()>& work) {
  const auto start = Clock::now();
  Outcome outcome;
  try {
    outcome = work();
  } catch (const Failure& failure) {
    outcome = failed(order.job, failure.code(), failure.what());
  } catch (const std::bad_alloc&) {
    outcome = failed(order.job, Exit::internal, "out of memory");
  } catch (const std::exception& e) {
    outcome = failed(order.job, Exit::internal, std::string("internal error: ") + e.what());
  }
  outcome.seconds = seconds_since(start);
  return outcome;
}

bool Cook::is_there(const std::string& path, std::span<const std::byte> bytes) const {
  std::error_code error;
  if (!cache_ || fs::file_size(path, error) != bytes.size() || error || !fs::is_regular_file(path, error)) return false;
  const AlignedBytes old = read_file(path);
  return old.size() == bytes.size() && std::equal(bytes.begin(), bytes.end(), old.data());
}

std::vector<std::string> Cook::inputs_of(const Order& order, const Outcome& outcome) const {
  std::vector<std::string> inputs;
  for (const cook::Read& read : outcome.reads) {
    if (inputs.empty()) {
      inputs.push_back(read.name);
      continue;
    }
    const fs::path path = fs::path(order.job.in).parent_path() / relative_to_scene(order.job.in, read.name);
    if (std::ranges::find(inputs, path.string()) == inputs.end()) inputs.push_back(path.string());
  }
  if (!order.settings_file.empty()) inputs.push_back(order.settings_file);
  return inputs;
}

void Cook::end() {
  if (cache_) cache_->end();
}

// -o scene.bin is a slip of the hand that would cost an artist's file.
void Cook::expect_not_read(const Order& order, const std::vector<cook::Read>& reads) const {
  for (const std::string& target : {order.job.out, a_.report, a_.depfile}) {
    std::error_code ignored;
    for (const cook::Read& read : reads)
      if (!target.empty() && fs::equivalent(target, read.name, ignored) && !ignored)
        throw Failure(Exit::usage, target, "", "is an input", "it belongs to the scene; name another file to write");
  }
}

}  // namespace marrow::tools
