#include "behave/find_graph.h"

#include "common/formats.h"
#include "disk/cook_on_disk.h"
#include "disk/disk_files.h"
#include "disk/files.h"

namespace marrow::tools {
namespace {

FoundGraph cook_rule(const cook::GraphRule& rule) {
  cook::CookOptions options;
  options.graphs = {rule};
  DiskFiles files;
  const cook::Result cooked = cook::cook_graphs(options, {files, nullptr, {}, nullptr});
  const auto memory =
      std::make_shared<LoadedFile>(load_mrw(rule.file, AlignedBytes(std::span<const std::byte>(cooked.file))));
  FoundGraph out{rule.file, memory->file, graphs_of(rule.file, memory->file).front(), {}, memory, rule.text};
  for (const auto& w : cooked.report["warnings"])
    out.warnings.push_back(w["pointer"].get<std::string>() + ": warning: " + w["text"].get<std::string>());
  return out;
}

FoundGraph cook_text_file(const std::string& path) {
  FoundGraph out = cook_rule({path});
  const AlignedBytes bytes = read_file(path);
  out.text.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return out;
}

}  // namespace

FoundGraph cook_graph_text(const std::string& path, const std::string& text) {
  return cook_rule({path, text});
}

FoundGraph open_graph(const std::string& path, const std::string& wanted) {
  if (has_extension(path, ".toml")) return cook_text_file(path);
  const auto memory = std::make_shared<LoadedFile>(load_mrw(path));
  return {path, memory->file, named_graph(path, memory->file, wanted), {}, memory, {}};
}

FoundGraph find_graph(const std::string& path, const File& file, const std::string& wanted) {
  if (has_extension(wanted, ".toml")) return cook_text_file(wanted);
  if (has_extension(wanted, ".mrw")) {
    const std::size_t at = wanted.find('@');
    return at == std::string::npos ? open_graph(wanted) : open_graph(wanted.substr(at + 1), wanted.substr(0, at));
  }
  return {path, file, named_graph(path, file, wanted)};
}

}  // namespace marrow::tools
