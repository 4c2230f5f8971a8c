// `marrow diff`: in what two cooked files differ, for people.
#include <cstring>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "commands/command.h"
#include "commands/diff/differences.h"
#include "open/open_model.h"

namespace marrow::tools {
namespace {

// The exit code beside failure.h's for files that differ: 1 would be a mistake in usage.
inline constexpr int kFilesDiffer = 6;

struct DiffArguments {
  std::string a, b;
  std::string skeleton;  // the character of two clip packs; may be empty
  bool json = false;
};

// Of two packs that move it.
std::optional<LoadedFile> character_of(const DiffArguments& arguments, const LoadedFile& a, const LoadedFile& b) {
  if (arguments.skeleton.empty()) return std::nullopt;
  LoadedFile out = open_model(arguments.skeleton).loaded;
  expect_joints(arguments.skeleton, out.file);
  plays_of_pack(arguments.a, a.file, arguments.skeleton, out.file);
  plays_of_pack(arguments.b, b.file, arguments.skeleton, out.file);
  return out;
}

// Whether both are the same byte by byte. Throws Failure.
bool run_diff(const DiffArguments& arguments) {
  const LoadedFile a = open_model(arguments.a).loaded, b = open_model(arguments.b).loaded;
  const bool equal =
      a.bytes.size() == b.bytes.size() && std::memcmp(a.bytes.data(), b.bytes.data(), a.bytes.size()) == 0;
  const std::optional<LoadedFile> character = character_of(arguments, a, b);
  const nlohmann::ordered_json differences = compare(a, b, character ? &*character : nullptr);
  if (arguments.json) {
    const nlohmann::ordered_json r = {
        {"a", arguments.a},          {"b", arguments.b},          {"equal", equal},
        {"a_bytes", a.bytes.size()}, {"b_bytes", b.bytes.size()}, {"differences", differences}};
    fmt::print("{}\n", r.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    return equal;
  }
  if (!equal) fmt::print("bytes: {}, now {}\n", a.bytes.size(), b.bytes.size());
  for (const auto& d : differences) fmt::print("{}: {}\n", d["in"].get<std::string>(), d["text"].get<std::string>());
  return equal;
}

}  // namespace

void add_diff(CLI::App& app, int& exit_code) {
  static DiffArguments a;  // as long as the options that point at it
  CLI::App* const command = app.add_subcommand("diff", "Say in what two cooked files differ");
  command->add_option("a", a.a, "a cooked file")->required()->type_name("A.mrw");
  command->add_option("b", a.b, "another")->required()->type_name("B.mrw");
  command
      ->add_option("--skeleton", a.skeleton, "of two clip packs: the character that they move, to measure poses on it")
      ->type_name("CHARACTER.mrw");
  command->add_flag("--json", a.json, "as JSON: {equal, differences: [{kind, in, text, ...}]}");
  command->footer("Exit codes: 0 the same bytes, 6 they differ, others as ever.");
  command->callback([&exit_code] { exit_code = run_diff(a) ? 0 : kFilesDiffer; });
}

}  // namespace marrow::tools
