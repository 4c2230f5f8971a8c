#include "behave/find_graph.h"

#include <charconv>

#include "common/failure.h"
#include "common/formats.h"
#include "disk/cook_on_disk.h"
#include "disk/disk_files.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::tools {
namespace {

// Of one rule.
FoundGraph cook_rule(const cook::GraphRule& rule) {
  cook::CookOptions options;
  options.graphs = {rule};
  DiskFiles files;
  const cook::Result cooked = cook::cook_graphs(options, {files, nullptr, {}, nullptr});
  const auto memory =
      std::make_shared<LoadedFile>(load_mrw(rule.file, AlignedBytes(std::span<const std::byte>(cooked.file))));
  FoundGraph out{rule.file, memory->file, graphs_of(rule.file, memory->file).front(), {}, memory};
  for (const auto& w : cooked.report["warnings"])
    out.warnings.push_back(w["pointer"].get<std::string>() + ": warning: " + w["text"].get<std::string>());
  return out;
}

}  // namespace

std::vector<Graph> graphs_of(const std::string& path, const File& file) {
  std::vector<Graph> out(file.graph_count());
  DataError error;
  for (std::uint32_t i = 0; i < out.size(); ++i)
    if (file.graph(i, out[i], &error) != Status::ok)
      throw Failure(Exit::invalid, path, "@" + std::to_string(error.offset), to_string(error.status), error.rule);
  return out;
}

Graph named_graph(const std::string& path, const File& file, const std::string& wanted) {
  const std::vector<Graph> all = graphs_of(path, file);
  if (all.empty())
    throw Failure(Exit::usage, path, "", "no graph",
                  "cook it with --graph hero.anim.toml, or name such a text, or begin one with marrow graph new");
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const Graph& graph : all) names.emplace_back(graph.name);
  if (wanted.empty() && all.size() == 1) return all[0];
  if (wanted.empty()) throw Failure(Exit::usage, path, "", "several graphs", "name one of " + printable(listed(names)));
  for (std::size_t i = 0; i < all.size(); ++i)
    if (names[i] == wanted) return all[i];
  std::size_t number = 0;
  const char* const end = wanted.data() + wanted.size();
  const auto [stop, error] = std::from_chars(wanted.data(), end, number);
  if (error == std::errc() && stop == end && number < all.size()) return all[number];
  throw Failure(Exit::usage, path, "", "no graph \"" + printable(wanted) + "\"", printable(suggestion(wanted, names)));
}

FoundGraph cook_graph_text(const std::string& path, const std::string& text) {
  return cook_rule({path, text});
}

FoundGraph open_graph(const std::string& path, const std::string& wanted) {
  if (has_extension(path, ".toml")) return cook_rule({path});
  const auto memory = std::make_shared<LoadedFile>(load_mrw(path));
  return {path, memory->file, named_graph(path, memory->file, wanted), {}, memory};
}

FoundGraph find_graph(const std::string& path, const File& file, const std::string& wanted) {
  if (has_extension(wanted, ".toml")) return cook_rule({wanted});
  if (has_extension(wanted, ".mrw")) {
    const std::size_t at = wanted.find('@');
    return at == std::string::npos ? open_graph(wanted) : open_graph(wanted.substr(at + 1), wanted.substr(0, at));
  }
  return {path, file, named_graph(path, file, wanted), {}, nullptr};
}

}  // namespace marrow::tools
