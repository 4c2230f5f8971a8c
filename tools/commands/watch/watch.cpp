#include "commands/watch/watch.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "commands/watch/folder_watch.h"
#include "common/failure.h"
#include "common/hash.h"
#include "common/parallel.h"
#include "disk/files.h"
#include "disk/thread_pool.h"
#include "terminal/progress.h"

namespace marrow::tools {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

// A save is often several steps, and an export several files: cooking begins when it has been quiet for so long, or
// after the longest wait.
constexpr milliseconds kQuiet{20}, kLongestWait{60};
constexpr milliseconds kForEver{-1};

fs::path true_path(const fs::path& path) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(path), ignored);
}

// Where the name itself is, which may be a link's.
fs::path named(const fs::path& path) {
  fs::path plain = fs::absolute(path).lexically_normal();
  if (!plain.has_filename()) plain = plain.parent_path();  // behind the last /
  return true_path(plain.parent_path()) / plain.filename();
}

bool is_there(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

bool is_below(const fs::path& path, const fs::path& folder) {
  return std::mismatch(path.begin(), path.end(), folder.begin(), folder.end()).second == folder.end();
}

bool holds(const cook::Read& read) {
  try {
    const AlignedBytes bytes = read_file(read.name);
    return bytes.size() >= read.bytes && hash_of({bytes.data(), static_cast<std::size_t>(read.bytes)}) == read.hash;
  } catch (const Failure&) {
    return false;
  }
}

// An input and what became of it.
struct Known {
  Order order;
  Outcome outcome;
  std::set<fs::path> inputs;  // canonical: what it came from when it last was good

  bool good() const { return outcome.code == Exit::done; }

  // A good one whose inputs hold what they held has nothing to gain. A bad one is tried again when anything near it
  // changes, since nobody knows what it lacks.
  bool may_differ(const Changes& changes) const {
    const auto touched = [&](const fs::path& path) { return changes.touch(path); };
    const bool any =
        std::ranges::any_of(inputs, touched) || touched(true_path(order.job.in)) || touched(named(order.job.in));
    if (!good()) {
      const fs::path folders[] = {true_path(order.job.in).parent_path(), named(order.job.in).parent_path()};
      return any || std::ranges::any_of(changes.paths, [&](const fs::path& path) {
               return (is_below(path, folders[0]) || is_below(path, folders[1])) && path.extension() != ".mrw" &&
                      path.extension() != ".tmp";
             });
    }
    if (!any) return false;
    if (!order.options.skeleton_file.empty() && touched(true_path(order.options.skeleton_file))) return true;
    return !std::ranges::all_of(outcome.reads, holds);
  }
};

class Watch {
 public:
  explicit Watch(const WatchArguments& arguments)
      : a_(arguments),
        is_batch_(is_batch(a_.inputs, a_.out)),
        given_(is_batch_ ? for_many(a_.given) : a_.given),
        folders_(a_.poll),
        cook_(a_) {}

  // Throws Failure for what is wrong with the whole of it.
  void begin() {
    const auto start = Clock::now();
    for (const std::string& input : a_.inputs)
      if (!is_there(input)) throw Failure(Exit::io, input, "", "cannot open", "there is no such file or folder");
    if (is_batch_) {
      create_folders(a_.out);
    } else {
      expect_cooked_name(a_.out);
      expect_writable(a_.out);
    }
    watch_folders();
    const std::vector<Order> orders = plan(true);
    cook_all(orders);
    std::vector<CookJob> jobs;
    std::vector<Outcome> outcomes;
    for (const auto& [in, known] : known_) {
      jobs.push_back(known.order.job);
      outcomes.push_back(known.outcome);
      print_warnings(known.order.job, known.outcome);
    }
    if (!jobs.empty()) print_table(jobs, outcomes, std::chrono::duration<double>(Clock::now() - start).count());
    std::fflush(stdout);
    for (const Outcome& outcome : outcomes)
      if (outcome.code != Exit::done) fmt::print(stderr, "{}\n", outcome.failure);
    if (wrong() > 0) say_how_many();
    fmt::print(stderr, "marrow: watching {}; Ctrl-C ends it\n", files(known_.size()));
    late_ = watch_folders();
  }

  void wait_and_cook() {
    const Changes changes = wait();
    late_ = watch_folders();
    pending_.add(changes);
    std::vector<Order> orders;
    try {
      orders = plan(false);
    } catch (const Failure& failure) {
      if (trouble_ != failure.what()) fmt::print(stderr, "{}\n", failure.what());
      trouble_ = failure.what();
      return;
    }
    if (!std::exchange(trouble_, "").empty()) fmt::print(stderr, "marrow: the settings are good again\n");
    const std::size_t wrong_before = wrong();
    const bool gone = forget_what_is_gone(orders);
    std::erase_if(orders, [&](const Order& order) {
      const auto known = known_.find(order.job.in);
      return known != known_.end() && known->second.order.options_text == order.options_text &&
             !known->second.may_differ(pending_);
    });
    const Changes why = std::exchange(pending_, {});
    const std::map<std::string, Known> before = known_;
    cook_all(orders);
    for (const Order& order : orders) tell(order.job.in, before, why);
    if (wrong() > 0 ? !orders.empty() || gone : wrong_before > 0) say_how_many();
    late_ = watch_folders() || late_;
  }

 private:
  static std::string files(std::size_t count) { return count == 1 ? "1 file" : fmt::format("{} files", count); }

  std::size_t wrong() const {
    return static_cast<std::size_t>(std::ranges::count_if(known_, [](const auto& k) { return !k.second.good(); }));
  }

  void say_how_many() const {
    const std::size_t bad = wrong();
    const std::string of = files(known_.size());
    fmt::print(stderr, "{}\n", bad == 0 ? of + ", none wrong" : fmt::format("{}, {} wrong", of, bad));
  }

  // With what stands at the end of a terminal meanwhile.
  Changes wait() {
    Progress status;
    const std::size_t bad = wrong();
    status.show(0, 0,
                fmt::format("watching {}{}", files(known_.size()), bad == 0 ? "" : fmt::format(", {} wrong", bad)));
    Changes changes;
    changes.anything = late_;  // folders that were not watched while their files were read
    if (late_) return changes;
    changes = folders_.wait(kForEver);
    const Clock::time_point start = Clock::now();
    while (Clock::now() - start < kLongestWait) {
      const Changes more = folders_.wait(kQuiet);
      if (more.empty()) break;
      changes.add(more);
    }
    return changes;
  }

  // Settings may come in any folder up to the working directory. Returns whether a folder is new.
  bool watch_folders() {
    bool is_new = false;
    const fs::path working = true_path(".");
    for (const std::string& input : a_.inputs) {
      std::error_code ignored;
      const bool is_folder = fs::is_directory(input, ignored);
      const fs::path own = is_folder ? true_path(input) : true_path(input).parent_path();
      is_new |= folders_.add(own, is_folder);
      is_new |= folders_.add(named(input).parent_path(), false);
      for (fs::path at = own; is_below(at, working) && at != working;) {
        at = at.parent_path();
        is_new |= folders_.add(at, false);
      }
    }
    if (!a_.settings.empty()) is_new |= folders_.add(true_path(a_.settings).parent_path(), false);
    for (const auto& [in, known] : known_) {
      is_new |= folders_.add(true_path(in).parent_path(), false);
      for (const fs::path& path : known.inputs) is_new |= folders_.add(path.parent_path(), false);
    }
    return is_new;
  }

  std::vector<Order> plan(bool first) const {
    const std::vector<CookJob> jobs =
        is_batch_ ? plan_batch(existing_inputs(), a_.out, true) : std::vector{plan_one(a_.inputs[0], a_.out)};
    std::vector<std::string> written, read;
    for (const CookJob& job : jobs) {
      written.push_back(job.out);
      read.push_back(job.in);
    }
    expect_distinct(written, read);
    SettingsOf settings(a_.settings);
    std::vector<Order> orders;
    for (const CookJob& job : jobs) orders.push_back(settings.order(job, given_));
    if (first) settings.warn_of_unused(a_.inputs);
    return orders;
  }

  // A folder that was named may be gone for a while.
  std::vector<std::string> existing_inputs() const {
    std::vector<std::string> out = a_.inputs;
    std::erase_if(out, [](const std::string& input) { return !is_there(input); });
    return out;
  }

  void cook_all(const std::vector<Order>& orders) {
    if (orders.empty()) return;
    std::vector<Outcome> outcomes(orders.size());
    {
      Progress progress;
      std::atomic<std::size_t> done{0};
      for_each_in_parallel(orders.size(), [&](std::size_t i) {
        progress.show(done, orders.size(), fs::path(orders[i].job.in).filename().string());
        outcomes[i] = cook_.cook_into_folder(orders[i]);
        ++done;
      });
    }
    cook_.end();
    for (std::size_t i = 0; i < orders.size(); ++i) {
      Known& known = known_[orders[i].job.in];
      known.order = orders[i];
      known.outcome = std::move(outcomes[i]);
      if (!known.good()) continue;
      known.inputs.clear();
      for (const std::string& path : cook_.inputs_of(known.order, known.outcome)) {
        known.inputs.insert(true_path(path));
        known.inputs.insert(named(path));  // a link that another takes the place of
      }
    }
  }

  bool forget_what_is_gone(const std::vector<Order>& orders) {
    return std::erase_if(known_, [&](const auto& known) {
             if (std::ranges::any_of(orders, [&](const Order& o) { return o.job.in == known.first; })) return false;
             const std::string& out = known.second.order.job.out;
             fmt::print(stderr, "{}: is gone{}\n", known.first, is_there(out) ? "; " + out + " stays" : "");
             return true;
           }) > 0;
  }

  // What came of an input that was cooked again. An error that is known already is worth a line if the file was saved.
  void tell(const std::string& in, const std::map<std::string, Known>& before, const Changes& why) const {
    const Known& known = known_.at(in);
    const auto old = before.find(in);
    const bool was_bad = old != before.end() && !old->second.good();
    if (known.good()) {
      if (was_bad) fmt::print(stderr, "{}: good again\n", in);
      print_warnings(known.order.job, known.outcome);
      print_summary(known.order.job, known.outcome);
      std::fflush(stdout);
    } else if (!was_bad || old->second.outcome.failure != known.outcome.failure || why.touch(true_path(in))) {
      fmt::print(stderr, "{}\n", known.outcome.failure);
    }
  }

  const WatchArguments& a_;
  const bool is_batch_;
  const cook::Options given_;
  FolderWatch folders_;
  Cook cook_;
  std::map<std::string, Known> known_;  // by input
  Changes pending_;                     // that nothing was done about yet
  std::string trouble_;                 // with the settings or the outputs' names
  bool late_ = false;
};

}  // namespace

void run_watch(const WatchArguments& arguments) {
  if (arguments.jobs > 0) set_thread_count(arguments.jobs);
  Watch watch(arguments);
  watch.begin();
  for (;;) watch.wait_and_cook();
}

}  // namespace marrow::tools
