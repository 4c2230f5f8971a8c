#include <fmt/format.h>

#include "commands/report/merge.h"
#include "text/html.h"
#include "text/printable.h"

namespace marrow::tools {
namespace {

constexpr std::size_t kMostRows = 50;

constexpr const char* kHead = R"(<!doctype html>
<html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Cooked files</title>
<style>
:root { color-scheme: light dark; }
body { font: 15px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
table { border-collapse: collapse; width: 100%; margin-bottom: 1.5rem; }
th, td { text-align: left; padding: .25rem .75rem .25rem 0; border-bottom: 1px solid #8884; overflow-wrap: anywhere; }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.bad { border-left: 4px solid #c33; padding: .25rem .75rem; }
</style>
)";

std::string shown(const std::string& text) {
  return html_text(printable(text));
}

std::string bytes_text(std::uint64_t bytes) {
  return bytes < 10'000       ? fmt::format("{} B", bytes)
         : bytes < 10'000'000 ? fmt::format("{:.1f} kB", static_cast<double>(bytes) / 1e3)
                              : fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

// Rows of cells that are HTML already; the first column is words, the others numbers if `numbers`.
class Table {
 public:
  Table(const std::string& title, const std::vector<std::string>& head, bool numbers = true) : numbers_(numbers) {
    text_ = "<h2>" + title + "</h2>\n<table><tr>";
    for (std::size_t i = 0; i < head.size(); ++i) text_ += cell("th", i, head[i]);
    text_ += "</tr>\n";
  }
  void add(const std::vector<std::string>& cells) {
    if (++rows_ > kMostRows) return;
    text_ += "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i) text_ += cell("td", i, cells[i]);
    text_ += "</tr>\n";
  }
  // Nothing of a table without rows.
  std::string text() const {
    if (rows_ == 0) return "";
    return text_ + "</table>\n" +
           (rows_ > kMostRows ? fmt::format("<p>and {} more</p>\n", rows_ - kMostRows) : std::string());
  }

 private:
  std::string cell(const char* tag, std::size_t column, const std::string& html) const {
    return fmt::format("<{0}{1}>{2}</{0}>", tag, numbers_ && column > 0 ? " class=\"n\"" : "", html);
  }
  std::string text_;
  std::size_t rows_ = 0;
  bool numbers_;
};

std::string totals(const Summary& s, bool has_since) {
  Table table("Totals", {"", ""});
  table.add({"files", std::to_string(s.files)});
  table.add({"failed", std::to_string(s.failed)});
  table.add({"from the cache", std::to_string(s.from_cache)});
  table.add({"source", bytes_text(s.source_bytes)});
  table.add({"cooked", bytes_text(s.cooked_bytes)});
  if (has_since) table.add({"the same files before", bytes_text(s.before_bytes)});
  if (has_since) table.add({"new, gone", fmt::format("{}, {}", s.appeared.size(), s.gone.size())});
  table.add({"cooking now, all machines together", fmt::format("{:.1f} s", s.seconds)});
  return table.text();
}

}  // namespace

std::string page_of(const Merged& merged, const Summary& s, bool has_since) {
  std::string out = std::string(kHead) + "<h1>Cooked files</h1>\n";
  for (const std::string& problem : merged.problems) out += "<p class=\"bad\">" + shown(problem) + "</p>\n";
  out += totals(s, has_since);
  Table failures("Failures", {"file", "why"}, false);
  for (const auto& [name, why] : s.failures) failures.add({shown(name), shown(why)});
  Table grown("Grown", {"file", "before", "now", "more"});
  for (const Grown& g : s.grown)
    grown.add({shown(g.name), bytes_text(g.before), bytes_text(g.now), bytes_text(g.now - g.before)});
  Table slowest("Slowest", {"file", "cooking", ""});
  for (const Timed& t : s.slowest)
    slowest.add({shown(t.name), fmt::format("{:.2f} s", t.seconds), t.from_cache ? "from the cache" : ""});
  Table warnings("Warnings", {"rule", "times"});
  for (const auto& [rule, times] : s.warnings) warnings.add({shown(rule), std::to_string(times)});
  Table gone("Gone", {"file"});
  for (const std::string& name : s.gone) gone.add({shown(name)});
  return out + failures.text() + grown.text() + slowest.text() + warnings.text() + gone.text();
}

}  // namespace marrow::tools
