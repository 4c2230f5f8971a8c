#include "behave/graphs.h"

#include <charconv>

#include "common/failure.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::tools {

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

}  // namespace marrow::tools
