#include "commands/cook/run_cook.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <filesystem>
#include <map>
#include <mutex>
#include <new>
#include <optional>

#include <fmt/format.h>

#include "commands/cook/batch.h"
#include "commands/cook/cache.h"
#include "commands/cook/depfile.h"
#include "commands/cook/outcome.h"
#include "common/failure.h"
#include "common/files.h"
#include "common/formats.h"
#include "common/hash.h"
#include "common/load_mrw.h"
#include "common/parallel.h"
#include "cook/cook.h"
#include "cook/gltf/read.h"
#include "cook/prepare/match_skeletons.h"
#include "cook/prepare/paint_weights.h"
#include "options/settings.h"
#include "terminal/progress.h"
#include "text/printable.h"

namespace marrow::tools {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Lets scenes be built at the same time as long as what they need fits half the machine's memory; one always.
class MemoryGate {
 public:
  class Pass {
   public:
    Pass(MemoryGate& gate, std::uint64_t source_bytes) : gate_(gate), need_(kLeast + kTimes * source_bytes) {
      std::unique_lock lock(gate_.mutex_);
      gate_.changed_.wait(lock, [&] { return gate_.used_ == 0 || gate_.used_ + need_ <= gate_.most_; });
      gate_.used_ += need_;
    }
    ~Pass() {
      const std::lock_guard lock(gate_.mutex_);
      gate_.used_ -= need_;
      gate_.changed_.notify_all();
    }
    Pass(const Pass&) = delete;
    Pass& operator=(const Pass&) = delete;

   private:
    // The largest clip that is compressed takes 80 MB; all else stayed below 10 times the source on our models.
    static constexpr std::uint64_t kLeast = 100'000'000, kTimes = 20;
    MemoryGate& gate_;
    std::uint64_t need_;
  };

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t used_ = 0;
  const std::uint64_t most_ = static_cast<std::uint64_t>(std::max(1L, ::sysconf(_SC_PHYS_PAGES))) *
                              static_cast<std::uint64_t>(std::max(1L, ::sysconf(_SC_PAGESIZE))) / 2;
};

// What is to be done with one input, all of it known before the first is read.
struct Order {
  CookJob job;
  cook::CookOptions options;
  std::string options_text;   // canonical
  std::string settings_file;  // empty: none
};

// Settings files, each read once, and which of their rules found an input.
class SettingsOf {
 public:
  explicit SettingsOf(const std::string& given) : given_(given) {}

  Order order(const CookJob& job, const cook::Given& command_line) {
    Order out{job, {}, "", given_.empty() ? cook::find_settings(job.in, job.root).value_or("") : given_};
    cook::Given given;
    if (!out.settings_file.empty()) {
      const auto [known, is_new] = known_.try_emplace(out.settings_file);
      if (is_new) known->second.settings = cook::read_settings(out.settings_file);
      given = cook::settings_for(known->second.settings, job.in, known->second.used);
    }
    cook::replace(given, command_line);
    out.options = cook::to_options(given);
    out.options_text = cook::canonical_text(given);
    return out;
  }

  // Where everything below the settings' folder was cooked, a rule that found nothing is a mistake.
  void warn_of_unused(const std::vector<std::string>& inputs) const {
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

 private:
  struct Known {
    cook::Settings settings;
    std::vector<bool> used;
  };
  std::string given_;
  std::map<std::string, Known> known_;
};

// The character that a clip pack is for.
cook::Character read_character(const std::string& path) {
  if (!path.ends_with(".mrw")) return cook::read_character(path);
  const auto loaded = std::make_shared<LoadedFile>(load_mrw(path));
  cook::Character out = cook::view_character(path, loaded->file);
  out.holds = loaded;
  out.hash = hash_of({loaded->bytes.data(), loaded->bytes.size()});
  return out;
}

// Masks and examples by where they are from the scene and by what they hold: their names in the options are from the
// working directory, which may be another the next time.
std::string named_files_text(const Order& order) {
  std::string out;
  const auto add = [&](const char* option, const std::string& file) {
    const cook::RawRead read = cook::read_of_mask(file);
    out += std::string("\n") + option + ' ' + relative_to_scene(order.job.in, read.path) + ' ' + read.hash;
  };
  for (const cook::PaintRule& rule : order.options.weights.paint) add("paint", rule.file);
  if (!order.options.learn.examples_file.empty()) add("examples", order.options.learn.examples_file);
  return out;
}

class Cook {
 public:
  explicit Cook(const CookArguments& arguments) : a_(arguments) {
    if (!a_.cache.empty()) cache_.emplace(a_.cache);
  }

  struct Cooked {
    Outcome outcome;
    std::vector<std::byte> file;
  };
  Cooked cook(const Order& order) {
    const auto start = Clock::now();
    Cooked out;
    std::optional<cook::CookResult> result;
    cook::CookOptions options = order.options;
    std::string options_text = order.options_text;
    if (!options.skeleton_file.empty()) {
      options.onto = std::make_shared<cook::Character>(read_character(options.skeleton_file));
      options_text += "\nskeleton " + options.onto->file + ' ' + options.onto->hash;
    }
    if (cache_ && !options.clips_only) options_text += named_files_text(order);
    if (cache_) result = cache_->find(order.job.in, options_text);
    out.outcome.from_cache = result.has_value();
    if (!result) {
      cook::RawScene scene = cook::read_gltf(order.job.in, {.image_bytes = options.images == cook::Images::embed});
      const MemoryGate::Pass pass(memory_, scene.source_bytes << (2 * options.subdivide));
      result = cook::cook_scene(std::move(scene), options);
      if (cache_) note_trouble(cache_->store(*result, options_text));
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

  // With a cache, files that need not change keep their time of change.
  bool is_there(const std::string& path, std::span<const std::byte> bytes) const {
    std::error_code error;
    if (!cache_ || fs::file_size(path, error) != bytes.size() || error || !fs::is_regular_file(path, error))
      return false;
    const AlignedBytes old = read_file(path);
    return old.size() == bytes.size() && std::equal(bytes.begin(), bytes.end(), old.data());
  }

  std::string dependencies(const Order& order, const Outcome& outcome) const {
    std::vector<std::string> inputs;
    for (const cook::RawRead& read : outcome.reads) {
      if (inputs.empty()) {
        inputs.push_back(read.path);
        continue;
      }
      const fs::path path = fs::path(order.job.in).parent_path() / relative_to_scene(order.job.in, read.path);
      if (std::ranges::find(inputs, path.string()) == inputs.end()) inputs.push_back(path.string());
    }
    if (!order.options.skeleton_file.empty()) inputs.push_back(order.options.skeleton_file);
    if (!order.settings_file.empty()) inputs.push_back(order.settings_file);
    return depfile_rule(order.job.out, inputs);
  }

  void end() {
    if (cache_) cache_->shrink(a_.cache_bytes);
    if (!cache_trouble_.empty())
      fmt::print(stderr, "{}: warning: the cache is not kept: {}\n", a_.cache, cache_trouble_);
  }

 private:
  // -o scene.bin is a slip of the hand that would cost an artist's file.
  void expect_not_read(const Order& order, const std::vector<cook::RawRead>& reads) const {
    for (const std::string& target : {order.job.out, a_.report, a_.depfile}) {
      std::error_code ignored;
      for (const cook::RawRead& read : reads)
        if (!target.empty() && fs::equivalent(target, read.path, ignored) && !ignored)
          throw Failure(Exit::usage, target, "", "is an input", "it belongs to the scene; name another file to write");
    }
  }

  void note_trouble(const std::string& text) {
    const std::lock_guard lock(mutex_);
    if (cache_trouble_.empty()) cache_trouble_ = text;
  }

  const CookArguments& a_;
  std::optional<Cache> cache_;
  MemoryGate memory_;
  std::mutex mutex_;
  std::string cache_trouble_;  // the first
};

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

// Empty names do not count.
void expect_all_writable(const std::vector<std::string>& paths) {
  for (const std::string& path : paths)
    if (!path.empty()) expect_writable(path);
}

// All files are on the disk before the first takes its place; the output comes last, so that what is new has its
// report and dependencies beside it.
int cook_one(const CookArguments& a) {
  const std::vector<std::string> written = {a.out, a.report, a.depfile};
  expect_distinct(written, a.inputs);
  expect_all_writable(written);
  if (is_named_gltf(a.out))
    throw Failure(Exit::usage, a.out, "", "unknown format", "a cooked file is no glTF; its name ends with .mrw");
  SettingsOf settings(a.settings);
  const std::string root = fs::path(a.inputs[0]).parent_path().string();
  Order order = settings.order({a.inputs[0], a.out, root.empty() ? "." : root}, a.given);
  Cook cook(a);
  const Cook::Cooked cooked = [&] {
    Progress progress;
    progress.show(0, 0, fs::path(a.inputs[0]).filename().string());
    order.options.learn.progress = [&](std::size_t done, std::size_t count) { progress.show(done, count, "fitting"); };
    order.options.clip_progress = [&](std::size_t done, std::size_t count) { progress.show(done, count, "clips"); };
    return cook.cook(order);
  }();
  const Outcome& outcome = cooked.outcome;
  print_warnings(order.job, outcome);
  const std::string report = report_text(outcome.report);
  std::vector<StagedFile> staged;
  if (!a.depfile.empty()) staged.emplace_back(a.depfile, bytes_of(cook.dependencies(order, outcome)));
  if (!a.report.empty()) staged.emplace_back(a.report, bytes_of(report));
  if (!cook.is_there(a.out, cooked.file)) staged.emplace_back(a.out, cooked.file);
  StagedFile::commit_all(staged);
  cook.end();
  if (a.json) {
    fmt::print("{}", report);
  } else {
    print_summary(order.job, outcome);
  }
  return 0;
}

Outcome failed(const CookJob& job, Exit code, std::string text) {
  if (!text.starts_with(job.in)) text = job.in + ": " + text;
  Outcome outcome;
  outcome.code = code;
  outcome.failure = std::move(text);
  return outcome;
}

Outcome cook_into_folder(Cook& cook, const Order& order) {
  const auto start = Clock::now();
  Outcome outcome;
  try {
    Cook::Cooked cooked = cook.cook(order);
    create_folders(fs::path(order.job.out).parent_path().string());
    if (!cook.is_there(order.job.out, cooked.file)) write_file_atomically(order.job.out, cooked.file);
    outcome = std::move(cooked.outcome);
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

int cook_batch(const CookArguments& a) {
  const auto start = Clock::now();
  const std::vector<CookJob> jobs = plan_batch(a.inputs, a.out);
  std::vector<std::string> written = {a.report, a.depfile}, read;
  for (const CookJob& job : jobs) {
    written.push_back(job.out);
    read.push_back(job.in);
  }
  expect_distinct(written, read);
  cook::Given given = a.given;
  for (auto& [name, values] : given)
    for (cook::Value& value : values) value.origin.must_fit = false;
  SettingsOf settings(a.settings);
  std::vector<Order> orders;
  for (const CookJob& job : jobs) orders.push_back(settings.order(job, given));
  settings.warn_of_unused(a.inputs);
  create_folders(a.out);
  expect_all_writable({a.report, a.depfile});

  Cook cook(a);
  std::vector<Outcome> outcomes(jobs.size());
  {
    Progress progress;
    std::atomic<std::size_t> done{0};
    for_each_in_parallel(jobs.size(), [&](std::size_t i) {
      progress.show(done, jobs.size(), fs::path(jobs[i].in).filename().string());
      outcomes[i] = cook_into_folder(cook, orders[i]);
      ++done;
    });
  }
  cook.end();
  nlohmann::ordered_json reports = nlohmann::ordered_json::array();
  std::string rules;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    print_warnings(jobs[i], outcomes[i]);
    reports.push_back(report_of(jobs[i], outcomes[i]));
    if (outcomes[i].code == Exit::done && !a.depfile.empty()) rules += cook.dependencies(orders[i], outcomes[i]);
  }
  if (!a.depfile.empty()) write_file_atomically(a.depfile, rules);
  if (!a.report.empty()) write_file_atomically(a.report, report_text(reports));
  if (a.json) {
    fmt::print("{}", report_text(reports));
  } else {
    print_table(jobs, outcomes, seconds_since(start));
  }
  std::fflush(stdout);
  for (const Outcome& outcome : outcomes)
    if (outcome.code != Exit::done) fmt::print(stderr, "{}\n", outcome.failure);
  const auto first = std::ranges::find_if(outcomes, [](const Outcome& o) { return o.code != Exit::done; });
  return first == outcomes.end() ? 0 : static_cast<int>(first->code);
}

}  // namespace

int run_cook(const CookArguments& arguments) {
  if (arguments.jobs > 0) set_thread_count(arguments.jobs);
  return is_batch(arguments.inputs, arguments.out) ? cook_batch(arguments) : cook_one(arguments);
}

}  // namespace marrow::tools
