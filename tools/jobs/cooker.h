// Cooks the inputs of one command, alone or at the same time, through the cache if there is one.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cook/options/options.h"
#include "cook/scene/cook_options.h"
#include "disk/settings.h"
#include "jobs/batch.h"
#include "jobs/cache.h"
#include "jobs/outcome.h"

namespace marrow::tools {

struct CookArguments {
  std::vector<std::string> inputs;
  std::string out, report, depfile, settings;
  CacheArguments cache;
  unsigned jobs = 0;  // 0: one a core
  bool json = false;
  cook::Options given;  // on the command line
};

// What is to be done with one input, all of it known before the first is read.
struct Order {
  CookJob job;
  cook::Options given;
  cook::CookOptions options;  // as they are read
  std::string options_text;   // canonical
  std::string settings_file;  // empty: none
};

// Settings files, each read once, and which of their rules found an input.
class SettingsOf {
 public:
  explicit SettingsOf(const std::string& given) : given_(given) {}

  // Throws what read_settings() and to_options() throw.
  Order order(const CookJob& job, const cook::Options& command_line);

  // Where everything below the settings' folder was cooked, a rule that found nothing is a mistake; on stderr.
  void warn_of_unused(const std::vector<std::string>& inputs) const;

 private:
  struct Known {
    cook::Settings settings;
    std::vector<bool> used;
  };
  std::string nearest(const CookJob& job);
  std::string given_;
  std::map<std::string, Known> known_;
  std::map<std::pair<std::string, std::string>, std::string> nearest_;  // by folder and root
};

// The same options for many files, of which each need not fit every one.
cook::Options for_many(cook::Options given);

// Lets scenes be built at the same time as long as what they need fits half the machine's memory; one always.
class MemoryGate {
 public:
  class Pass {
   public:
    Pass(MemoryGate& gate, std::uint64_t source_bytes) : gate_(gate), need_(need(source_bytes)) {
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
    MemoryGate& gate_;
    std::uint64_t need_;
  };

  static std::uint64_t need(std::uint64_t source_bytes) {
    // The largest clip that is compressed takes 80 MB; all else stayed below 10 times the source on our models.
    constexpr std::uint64_t kLeast = 100'000'000, kTimes = 20;
    return kLeast + kTimes * source_bytes;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t used_ = 0;
  const std::uint64_t most_ = half_of_memory();
  static std::uint64_t half_of_memory();
};

class Cook {
 public:
  // `arguments` live as long as this.
  explicit Cook(const CookArguments& arguments);

  struct Cooked {
    Outcome outcome;
    std::vector<std::byte> file;
  };
  // As cook::Host::progress.
  using Show = std::function<void(cook::Stage stage, std::size_t done, std::size_t count)>;
  // Throws Failure. From any thread, like what follows but end().
  Cooked cook(const Order& order, const Show& show = {});
  // Writes the output and makes its folder. Throws nothing: what went wrong is in the outcome.
  Outcome cook_into_folder(const Order& order);
  bool has_cache() const { return cache_.has_value(); }
  // Learns for one mesh of cook::look() into the cache, which there must be. Throws nothing.
  Outcome learn_fit(const Order& order, std::size_t which);

  // With a cache, files that need not change keep their time of change.
  bool is_there(const std::string& path, std::span<const std::byte> bytes) const;
  // All files that a successful cook came from, the scene first.
  std::vector<std::string> inputs_of(const Order& order, const Outcome& outcome) const;

  // As Cache::end().
  void end();

 private:
  void expect_not_read(const Order& order, const std::vector<cook::Read>& reads) const;
  Outcome told(const Order& order, const std::function<Outcome()>& work);
  void with_host(const Order& order, const Show& show, const std::function<void(const cook::Host&)>& work);

  const CookArguments& a_;
  std::optional<Cache> cache_;
  MemoryGate memory_;
};

}  // namespace marrow::tools
