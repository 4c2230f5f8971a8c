#include "behave/script.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "common/failure.h"
#include "disk/files.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::tools {
namespace {

constexpr std::size_t kLargestScript = std::size_t{1024} * 1024, kMostLines = 100000;
constexpr double kLatest_s = 86400;

struct Word {
  std::string text;
  std::size_t column = 0;
};

class ScriptReader {
 public:
  ScriptReader(const std::string& path, const File& names, const Graph& graph) : path_(path), graph_(graph) {
    for (const GraphParameter& p : graph.parameters) names_.emplace_back(names.text(p.name));
  }

  std::vector<ScriptLine> read(std::string_view text) {
    if (text.size() > kLargestScript) throw Failure(Exit::usage, path_, "", "too large", "1 MiB is the limit");
    std::vector<ScriptLine> out;
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      ++line_;
      const std::vector<Word> words = words_of(text.substr(0, end));
      if (!words.empty()) out.push_back(line_of(words));
      if (out.size() > kMostLines) fail(1, "more than 100000 lines", "leave some out");
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    std::ranges::stable_sort(out, {}, &ScriptLine::time_s);
    return out;
  }

 private:
  [[noreturn]] void fail(std::size_t column, const std::string& rule, const std::string& advice) const {
    throw Failure(Exit::usage, path_, fmt::format("{}:{}", line_, column), printable(rule), printable(advice));
  }

  std::vector<Word> words_of(std::string_view line) const {
    constexpr std::string_view kBlank = " \t\r";
    std::vector<Word> out;
    for (std::size_t at = line.find_first_not_of(kBlank); at < line.size() && line[at] != '#';
         at = line.find_first_not_of(kBlank, at)) {
      const bool is_quoted = line[at] == '"';
      const std::size_t begin = is_quoted ? at + 1 : at,
                        end =
                            is_quoted ? line.find('"', begin) : std::min(line.find_first_of(" \t\r#", at), line.size());
      if (end == std::string_view::npos) fail(at + 1, "a name without its second quote", "close it");
      out.push_back({std::string(line.substr(begin, end - begin)), at + 1});
      at = is_quoted ? end + 1 : end;
    }
    return out;
  }

  double number(const Word& word, const std::string& rule, const std::string& advice) const {
    double out = 0;
    const char* const end = word.text.data() + word.text.size();
    const auto [stop, error] = std::from_chars(word.text.data(), end, out);
    if (error != std::errc() || stop != end || !std::isfinite(out)) fail(word.column, rule, advice);
    return out;
  }

  ScriptLine line_of(const std::vector<Word>& words) const {
    ScriptLine out;
    out.time_s =
        number(words[0], fmt::format("\"{}\" is no time", words[0].text), "begin with seconds, as in 1.5 speed 2");
    if (!(0 <= out.time_s && out.time_s <= kLatest_s))
      fail(words[0].column, "a time before the start, or after a day", "give seconds from 0 on");
    if (words.size() < 2) fail(words[0].column, "a time alone", "say what is set then, as in 1.5 speed 2");
    const auto found = std::ranges::find(names_, words[1].text);
    if (found == names_.end())
      fail(words[1].column, fmt::format("there is no parameter \"{}\"", words[1].text),
           names_.empty() ? "the graph has none" : suggestion(words[1].text, names_));
    out.parameter = static_cast<std::uint32_t>(found - names_.begin());
    out.value = value_of(words, graph_.parameters[out.parameter]);
    return out;
  }

  float value_of(const std::vector<Word>& words, const GraphParameter& parameter) const {
    const std::string& name = words[1].text;
    const bool is_trigger = parameter.kind == ParameterKind::trigger;
    if (words.size() > (is_trigger ? 2u : 3u))
      fail(words[is_trigger ? 2 : 3].column,
           is_trigger ? fmt::format("\"{}\" is a trigger, without a value", name) : "too many words",
           "one line sets one parameter; # begins a comment");
    if (is_trigger) return 1;
    if (parameter.kind == ParameterKind::flag) {
      const std::string value = words.size() < 3 ? "" : words[2].text;
      if (value != "true" && value != "false")
        fail(words.back().column, fmt::format("\"{}\" is a flag", name), "give true or false");
      return value == "true" ? 1.0f : 0.0f;
    }
    const std::string advice = fmt::format("give a number from {:g} to {:g}", parameter.least, parameter.most);
    if (words.size() < 3) fail(words[1].column, fmt::format("\"{}\" without a value", name), advice);
    const double value = number(words[2], fmt::format("\"{}\" is no number", words[2].text), advice);
    if (!(static_cast<double>(parameter.least) <= value && value <= static_cast<double>(parameter.most)))
      fail(words[2].column, fmt::format("\"{}\" never is {}", name, words[2].text), advice);
    return static_cast<float>(value);
  }

  std::string path_;
  const Graph& graph_;
  std::vector<std::string> names_;
  std::size_t line_ = 0;
};

}  // namespace

std::vector<ScriptLine> parse_script(const std::string& path, std::string_view text, const File& names,
                                     const Graph& graph) {
  return ScriptReader(path, names, graph).read(text);
}

std::vector<ScriptLine> read_script(const std::string& path, const File& names, const Graph& graph) {
  const AlignedBytes bytes = read_file(path);
  return parse_script(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, names, graph);
}

}  // namespace marrow::tools
