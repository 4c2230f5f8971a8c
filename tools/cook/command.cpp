#include "cook/command.h"

#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "common/failure.h"
#include "common/files.h"
#include "cook/cook.h"

namespace marrow::tools {
namespace {

struct Arguments {
  std::string in, out, report;
  bool json = false;
  cook::CookOptions options;
};

void summarise(const Arguments& a, const nlohmann::ordered_json& r) {
  std::size_t vertices = 0, triangles = 0, joints = 0;
  for (const auto& mesh : r["meshes"]) {
    vertices += mesh["vertices"].get<std::size_t>();
    triangles += mesh["triangles"].get<std::size_t>();
  }
  for (const auto& skeleton : r["skeletons"]) joints += skeleton["joints"].get<std::size_t>();
  fmt::print("{}: {} bytes from {}; {} joints, {} meshes, {} vertices, {} triangles, {} clips\n", a.out,
             r["output"]["bytes"].get<std::size_t>(), r["source"]["bytes"].get<std::size_t>(), joints,
             r["meshes"].size(), vertices, triangles, r["clips"].size());
}

void run(const Arguments& a) {
  const cook::CookResult result = cook::cook_file(a.in, a.options);
  for (const auto& w : result.report["warnings"])
    fmt::print(stderr, "{}: {}: warning: {}: {}\n", a.in, w["pointer"].get<std::string>(), w["rule"].get<std::string>(),
               w["text"].get<std::string>());
  // Names need not be UTF-8 once cooked from memory; the report says what it can.
  const std::string report = result.report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  write_file_atomically(a.out, result.file);
  if (!a.report.empty()) {
    try {
      write_file_atomically(a.report, report);
    } catch (const Failure&) {
      std::remove(a.out.c_str());
      throw;
    }
  }
  if (a.json) {
    fmt::print("{}", report);
  } else {
    summarise(a, result.report);
  }
}

}  // namespace

void add_cook(CLI::App& app) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* const command = app.add_subcommand("cook", "Cook a .gltf or .glb file into a .mrw file");
  command->add_option("input", a->in, "the .gltf or .glb file")->required()->type_name("IN");
  command->add_option("-o,--output", a->out, "the cooked file to write")->required()->type_name("OUT.mrw");
  command->add_option("--report", a->report, "also write a report as JSON")->type_name("R.json");
  command->add_flag("--json", a->json, "print the report on stdout instead of a summary");
  command->add_flag("--keep-vertex-order", a->options.keep_vertex_order,
                    "remember the source's vertex order, for `marrow pose` and for comparing with other evaluators");
  command->callback([a] { run(*a); });
}

}  // namespace marrow::tools
