#include "commands/diff/diff.h"

#include <cstring>
#include <optional>

#include <fmt/format.h>

#include "commands/diff/differences.h"
#include "pose/choose.h"

namespace marrow::tools {

namespace {

// Of two packs that move it.
std::optional<LoadedFile> character_of(const DiffArguments& arguments, const LoadedFile& a, const LoadedFile& b) {
  if (arguments.skeleton.empty()) return std::nullopt;
  LoadedFile out = load_mrw(arguments.skeleton);
  expect_joints(arguments.skeleton, out.file);
  plays_of_pack(arguments.a, a.file, arguments.skeleton, out.file);
  plays_of_pack(arguments.b, b.file, arguments.skeleton, out.file);
  return out;
}

}  // namespace

bool run_diff(const DiffArguments& arguments) {
  const LoadedFile a = load_mrw(arguments.a), b = load_mrw(arguments.b);
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

}  // namespace marrow::tools
