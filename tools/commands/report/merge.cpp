#include "commands/report/merge.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "common/failure.h"
#include "disk/files.h"

namespace marrow::tools {
namespace {

using nlohmann::ordered_json;

std::uint64_t cooked_bytes(const ordered_json& report) {
  return report.at("output").at("bytes").get<std::uint64_t>();
}

bool failed(const ordered_json& report) {
  return report.contains("error");
}

}  // namespace

Merged merge(const std::vector<std::string>& reports) {
  Merged out;
  std::set<std::string> programs;
  std::size_t files = 0;
  for (const std::string& path : reports) {
    const AlignedBytes bytes = read_file(path);
    const char* const text = reinterpret_cast<const char*>(bytes.data());
    try {
      ordered_json list = ordered_json::parse(text, text + bytes.size());
      if (list.is_object()) list = ordered_json::array({list});  // of a single input, which does not tell how it ran
      for (const ordered_json& report : list) {
        if (report.contains("run")) {
          programs.insert(report.at("run").at("program").get<std::string>());
          files = std::max(files, report.at("run").at("files").get<std::size_t>());
        }
        if (!failed(report)) cooked_bytes(report);
        ordered_json& at = out.files[report.at("source").at("file").get<std::string>()];
        if (at.is_null() || failed(at) || !failed(report)) at = report;
      }
    } catch (const nlohmann::json::exception& e) {
      throw Failure(Exit::invalid, path, "", "no reports, as marrow cook --report writes them", e.what());
    }
  }
  if (programs.size() > 1) out.problems.push_back(fmt::format("{} programs have cooked these files", programs.size()));
  if (out.files.size() < files)
    out.problems.push_back(
        fmt::format("{} of {} files are in no report: a share is missing", files - out.files.size(), files));
  return out;
}

Summary summary_of(const Merged& merged, const Merged& since) {
  Summary out;
  out.files = merged.files.size();
  for (const auto& [name, report] : merged.files) {
    if (report.contains("run")) {
      const ordered_json& run = report.at("run");
      const bool cached = run.at("from_cache").get<bool>();
      out.slowest.push_back({name, run.at("cooking_s").get<double>(), cached});
      if (cached) ++out.from_cache;
      if (!cached) out.seconds += run.at("seconds").get<double>();
    }
    if (failed(report)) {
      ++out.failed;
      out.failures.emplace_back(name, report.at("error").at("text").get<std::string>());
      if (out.code == 0) out.code = report.at("error").at("code").get<int>();
      continue;
    }
    out.source_bytes += report.at("source").at("bytes").get<std::uint64_t>();
    out.cooked_bytes += cooked_bytes(report);
    for (const ordered_json& warning : report.at("warnings")) ++out.warnings[warning.at("rule").get<std::string>()];
    const auto before = since.files.find(name);
    if (before == since.files.end()) {
      out.appeared.push_back(name);
    } else if (!failed(before->second)) {
      out.before_bytes += cooked_bytes(before->second);
      if (cooked_bytes(report) > cooked_bytes(before->second))
        out.grown.push_back({name, cooked_bytes(before->second), cooked_bytes(report)});
    }
  }
  for (const auto& [name, report] : since.files)
    if (!merged.files.contains(name)) out.gone.push_back(name);
  std::ranges::stable_sort(out.grown, std::greater(), [](const Grown& g) { return g.now - g.before; });
  std::ranges::stable_sort(out.slowest, std::greater(), &Timed::seconds);
  return out;
}

}  // namespace marrow::tools
