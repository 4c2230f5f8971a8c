#include "jobs/outcome.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "jobs/program_hash.h"
#include "terminal/warnings.h"

namespace marrow::tools {
namespace {

using nlohmann::ordered_json;

struct Counts {
  std::uint64_t source = 0, cooked = 0, joints = 0, meshes = 0, vertices = 0, triangles = 0, clips = 0, warnings = 0;
  double seconds = 0;
};

Counts counts_of(const ordered_json& r) {
  Counts c;
  c.source = r.at("source").at("bytes").get<std::uint64_t>();
  c.cooked = r.at("output").at("bytes").get<std::uint64_t>();
  for (const auto& skeleton : r.at("skeletons")) c.joints += skeleton.at("joints").get<std::uint64_t>();
  c.meshes = r.at("meshes").size();
  for (const auto& mesh : r.at("meshes")) {
    c.vertices += mesh.at("vertices").get<std::uint64_t>();
    c.triangles += mesh.at("triangles").get<std::uint64_t>();
  }
  c.clips = r.at("clips").size();
  c.warnings = r.at("warnings").size();
  return c;
}

constexpr std::size_t kColumns = 9;
using TableRow = std::array<std::string, kColumns>;

TableRow row_of(const std::string& name, const Counts& c, const std::string& seconds) {
  const double ratio = static_cast<double>(c.cooked) / static_cast<double>(std::max<std::uint64_t>(1, c.source));
  return {name,
          std::to_string(c.source),
          std::to_string(c.cooked),
          fmt::format("{:.3f}", ratio),
          std::to_string(c.joints),
          std::to_string(c.vertices),
          std::to_string(c.clips),
          seconds,
          std::to_string(c.warnings)};
}

void print_rows(const std::vector<TableRow>& rows) {
  std::array<std::size_t, kColumns> widths{};
  for (const TableRow& row : rows)
    for (std::size_t i = 0; i < kColumns; ++i) widths[i] = std::max(widths[i], row[i].size());
  for (const TableRow& row : rows) {
    std::string line = fmt::format("{:<{}}", row[0], widths[0]);
    for (std::size_t i = 1; i < kColumns; ++i) line += fmt::format("  {:>{}}", row[i], widths[i]);
    fmt::print("{}\n", line);
  }
}

}  // namespace

std::string report_text(const ordered_json& report) {
  return report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

ordered_json report_of(const CookJob& job, const Outcome& outcome, std::size_t files) {
  ordered_json out = outcome.report;
  if (outcome.code != Exit::done)
    out = {{"source", {{"file", job.in}}},
           {"error", {{"code", static_cast<int>(outcome.code)}, {"text", outcome.failure}}}};
  out["run"] = {{"program", program_hash()},
                {"files", files},
                {"from_cache", outcome.from_cache},
                {"seconds", outcome.seconds},
                {"cooking_s", outcome.code == Exit::done ? outcome.cooking_s : outcome.seconds}};
  return out;
}

void print_warnings(const CookJob& job, const Outcome& outcome) {
  if (outcome.code != Exit::done) return;
  std::vector<Warning> warnings;
  for (const auto& w : outcome.report.at("warnings"))
    warnings.push_back(
        {w.at("pointer").get<std::string>(), w.at("rule").get<std::string>(), w.at("text").get<std::string>()});
  for (const std::string& line : warning_lines(job.in, warnings, "; --report lists all"))
    fmt::print(stderr, "{}\n", line);
}

void print_summary(const CookJob& job, const Outcome& outcome) {
  const Counts c = counts_of(outcome.report);
  fmt::print("{}: {} bytes from {}; {} joints, {} meshes, {} vertices, {} triangles, {} clips{}\n", job.out, c.cooked,
             c.source, c.joints, c.meshes, c.vertices, c.triangles, c.clips,
             outcome.from_cache ? "; from the cache" : "");
}

void print_table(const std::vector<CookJob>& jobs, const std::vector<Outcome>& outcomes, double seconds) {
  std::vector<TableRow> rows = {
      {"file", "source B", "cooked B", "ratio", "joints", "vertices", "clips", "seconds", "warnings"}};
  Counts sum;
  std::size_t from_cache = 0, failed = 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const Outcome& outcome = outcomes[i];
    if (outcome.code != Exit::done) {
      ++failed;
      rows.push_back({jobs[i].in, "-", "failed", "-", "-", "-", "-", fmt::format("{:.2f}", outcome.seconds), "-"});
      continue;
    }
    const Counts c = counts_of(outcome.report);
    rows.push_back(row_of(jobs[i].in, c, outcome.from_cache ? "cache" : fmt::format("{:.2f}", outcome.seconds)));
    from_cache += outcome.from_cache ? 1 : 0;
    sum.source += c.source;
    sum.cooked += c.cooked;
    sum.joints += c.joints;
    sum.vertices += c.vertices;
    sum.clips += c.clips;
    sum.warnings += c.warnings;
  }
  rows.push_back(row_of("total", sum, fmt::format("{:.2f}", seconds)));
  print_rows(rows);
  fmt::print("{} files: {} cooked, {} from the cache, {} failed\n", jobs.size(), jobs.size() - from_cache - failed,
             from_cache, failed);
}

}  // namespace marrow::tools
