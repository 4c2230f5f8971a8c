#include <fmt/format.h>

#include "commands/command.h"
#include "commands/report/merge.h"
#include "common/failure.h"
#include "common/formats.h"
#include "disk/files.h"
#include "jobs/outcome.h"

namespace marrow::tools {
namespace {

struct Arguments {
  std::vector<std::string> reports;
  std::string out, since;
};

int run(const Arguments& a) {
  const bool is_page = has_extension(a.out, ".html");
  if (!is_page && !has_extension(a.out, ".json"))
    throw Failure(Exit::usage, a.out, "", "unknown format", "its name ends with .html or .json");
  expect_writable(a.out);
  const Merged merged = merge(a.reports), since = a.since.empty() ? Merged() : merge({a.since});
  const Summary summary = [&] {
    try {
      return summary_of(merged, since);
    } catch (const nlohmann::json::exception& e) {
      throw Failure(Exit::invalid, a.reports.front(), "", "no reports, as marrow cook --report writes them", e.what());
    }
  }();
  if (is_page) {
    write_file_atomically(a.out, page_of(merged, summary, !a.since.empty()));
  } else {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const auto& [name, report] : merged.files) list.push_back(report);
    write_file_atomically(a.out, report_text(list));
  }
  fmt::print("{}: {} files, {} failed, {} from the cache; {} bytes", a.out, summary.files, summary.failed,
             summary.from_cache, summary.cooked_bytes);
  if (!a.since.empty()) fmt::print("; {} files grew", summary.grown.size());
  fmt::print("\n");
  std::fflush(stdout);
  for (const std::string& problem : merged.problems) fmt::print(stderr, "{}: {}\n", a.out, problem);
  for (const auto& [name, why] : summary.failures) fmt::print(stderr, "{}\n", why);
  if (!merged.problems.empty()) return static_cast<int>(Exit::invalid);
  return summary.code;
}

}  // namespace

void add_report(CLI::App& app, int& exit_code) {
  static Arguments a;
  CLI::App* const command =
      app.add_subcommand("report", "Merge reports of marrow cook: totals, failures, what grew, what is slow");
  command->add_option("--merge", a.reports, "reports of several inputs each, as of shards")
      ->required()
      ->type_name("R.json");
  command->add_option("-o,--output", a.out, "a page for people, or one report of all")
      ->required()
      ->type_name("OUT.html|OUT.json");
  command->add_option("--since", a.since, "an earlier merged report: says what grew")->type_name("R.json");
  command->callback([&exit_code] { exit_code = run(a); });
}

}  // namespace marrow::tools
