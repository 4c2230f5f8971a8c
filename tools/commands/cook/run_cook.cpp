#include "commands/cook/run_cook.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "common/failure.h"
#include "common/formats.h"
#include "common/parallel.h"
#include "disk/disk_files.h"
#include "disk/files.h"
#include "disk/thread_pool.h"
#include "jobs/depfile.h"
#include "jobs/plan.h"
#include "jobs/program_hash.h"
#include "marrow/cook.h"
#include "terminal/progress.h"

namespace marrow::tools {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

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
  expect_cooked_name(a.out);
  expect_all_writable(written);
  SettingsOf settings(a.settings);
  const Order order = settings.order(plan_one(a.inputs[0], a.out), a.given);
  Cook cook(a);
  const Cook::Cooked cooked = [&] {
    Progress progress;
    progress.show(0, 0, fs::path(a.inputs[0]).filename().string());
    return cook.cook(order, [&](cook::Stage stage, std::size_t done, std::size_t count) {
      if (count > 0) progress.show(done, count, stage == cook::Stage::learn ? "fitting" : "clips");
    });
  }();
  const Outcome& outcome = cooked.outcome;
  print_warnings(order.job, outcome);
  const std::string report = report_text(outcome.report);
  std::vector<StagedFile> staged;
  if (!a.depfile.empty())
    staged.emplace_back(a.depfile, bytes_of(depfile_rule(order.job.out, cook.inputs_of(order, outcome))));
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

// What is to be cooked into where, and the options of each.
std::vector<Order> read_orders(const CookArguments& a) {
  if (!is_batch(a.inputs, a.out)) expect_cooked_name(a.out);
  const std::vector<CookJob> jobs =
      is_batch(a.inputs, a.out) ? plan_batch(a.inputs, a.out) : std::vector{plan_one(a.inputs[0], a.out)};
  std::vector<std::string> written = {a.report, a.depfile}, read;
  for (const CookJob& job : jobs) {
    written.push_back(job.out);
    read.push_back(job.in);
  }
  expect_distinct(written, read);
  const cook::Options given = for_many(a.given);
  SettingsOf settings(a.settings);
  std::vector<Order> orders;
  for (const CookJob& job : jobs) orders.push_back(settings.order(job, given));
  settings.warn_of_unused(a.inputs);
  return orders;
}

// Those of this process's share.
std::vector<Unit> own_units(const std::vector<Order>& orders, const ShareOfWork& part) {
  std::vector<Unit> all;
  if (part.fits) {
    all = fit_units(orders);
  } else {
    const KnownTimes history(part.history);
    for (std::size_t i = 0; i < orders.size(); ++i)
      all.push_back(part.shard.count > 1 ? file_unit(i, orders[i], history) : Unit{i, {}, 0, 0, false});
  }
  if (part.shard.count == 1) return all;
  const std::vector<unsigned> share = share_out(all, part.shard.count);
  std::vector<Unit> out;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (share[i] == part.shard.number) out.push_back(all[i]);
  return out;
}

int exit_code_of(const std::vector<Outcome>& outcomes) {
  std::fflush(stdout);
  for (const Outcome& outcome : outcomes)
    if (outcome.code != Exit::done) fmt::print(stderr, "{}\n", outcome.failure);
  const auto first = std::ranges::find_if(outcomes, [](const Outcome& o) { return o.code != Exit::done; });
  return first == outcomes.end() ? 0 : static_cast<int>(first->code);
}

// Of each unit what became of it.
std::vector<Outcome> do_units(Cook& cook, const std::vector<Order>& orders, const std::vector<Unit>& units) {
  std::vector<Outcome> outcomes(units.size());
  Progress progress;
  std::atomic<std::size_t> done{0};
  for_each_in_parallel(units.size(), [&](std::size_t i) {
    const Order& order = orders[units[i].order];
    progress.show(done, units.size(), fs::path(order.job.in).filename().string());
    outcomes[i] = units[i].fit ? cook.learn_fit(order, *units[i].fit) : cook.cook_into_folder(order);
    ++done;
  });
  cook.end();
  return outcomes;
}

int learn_fits(const CookArguments& a, const ShareOfWork& part) {
  const std::vector<Order> orders = read_orders(a);
  Cook cook(a);
  if (!cook.has_cache()) throw Failure(Exit::usage, "--fits", "", "no cache", "name one by --cache");
  const std::vector<Unit> units = own_units(orders, part);
  const std::vector<Outcome> outcomes = do_units(cook, orders, units);
  fmt::print("{} meshes learnt for\n", units.size());
  return exit_code_of(outcomes);
}

int cook_batch(const CookArguments& a, const ShareOfWork& part) {
  const auto start = Clock::now();
  const std::vector<Order> orders = read_orders(a);
  const std::vector<Unit> units = own_units(orders, part);
  if (is_batch(a.inputs, a.out)) create_folders(a.out);
  expect_all_writable({a.report, a.depfile});

  Cook cook(a);
  const std::vector<Outcome> outcomes = do_units(cook, orders, units);
  nlohmann::ordered_json reports = nlohmann::ordered_json::array();
  std::vector<CookJob> jobs;
  std::string rules;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const Order& order = orders[units[i].order];
    jobs.push_back(order.job);
    print_warnings(order.job, outcomes[i]);
    reports.push_back(report_of(order.job, outcomes[i], orders.size()));
    if (outcomes[i].code == Exit::done && !a.depfile.empty())
      rules += depfile_rule(order.job.out, cook.inputs_of(order, outcomes[i]));
  }
  if (!a.depfile.empty()) write_file_atomically(a.depfile, rules);
  if (!a.report.empty()) write_file_atomically(a.report, report_text(reports));
  if (a.json) {
    fmt::print("{}", report_text(reports));
  } else {
    print_table(jobs, outcomes, seconds_since(start));
  }
  return exit_code_of(outcomes);
}

int write_plan(const CookArguments& a, const ShareOfWork& part) {
  expect_writable(part.plan);
  const nlohmann::ordered_json plan = plan_of(read_orders(a), part.history);
  write_file_atomically(part.plan, report_text(plan));
  fmt::print("{} files, about {:.0f} s on one thread, the longest {:.1f} s, at most {} MB\n", plan.at("units").size(),
             plan.at("seconds").get<double>(), plan.at("longest_s").get<double>(),
             plan.at("memory_bytes").get<std::uint64_t>() / 1'000'000);
  return 0;
}

}  // namespace

int run_cook(const CookArguments& a, const ShareOfWork& part) {
  if (a.jobs > 0) set_thread_count(a.jobs);
  if (!part.program.empty() && part.program != program_hash())
    throw Failure(Exit::usage, "--program", "", "another program", "this one is " + program_hash() + "; plan again");
  if (!part.plan.empty()) return write_plan(a, part);
  if (part.fits) return learn_fits(a, part);
  return part.is_given || is_batch(a.inputs, a.out) ? cook_batch(a, part) : cook_one(a);
}

int cook_graph_pack(const CookArguments& a) {
  const cook::CookOptions options = cook::to_graph_options(a.given);
  const std::vector<std::string> written = {a.out, a.report, a.depfile};
  std::vector<std::string> read;
  for (const cook::GraphRule& rule : options.graphs) read.push_back(rule.file);
  expect_distinct(written, read);
  expect_cooked_name(a.out);
  expect_all_writable(written);
  DiskFiles files;
  cook::Result result = cook::cook_graphs(a.given, {files, &all_cores(), {}, nullptr});
  result.report["output"]["file"] = a.out;
  Outcome outcome;
  outcome.report = std::move(result.report);
  const CookJob job = plan_one(read[0], a.out);
  print_warnings(job, outcome);
  const std::string report = report_text(outcome.report);
  std::vector<StagedFile> staged;
  if (!a.depfile.empty()) staged.emplace_back(a.depfile, bytes_of(depfile_rule(a.out, read)));
  if (!a.report.empty()) staged.emplace_back(a.report, bytes_of(report));
  staged.emplace_back(a.out, result.file);
  StagedFile::commit_all(staged);
  if (a.json)
    fmt::print("{}", report);
  else
    fmt::print("{}: {} bytes; {} graph{}\n", a.out, result.file.size(), read.size(), read.size() == 1 ? "" : "s");
  return 0;
}

}  // namespace marrow::tools
