#include "commands/diff/diff.h"

#include <cstring>

#include <fmt/format.h>

#include "commands/diff/differences.h"

namespace marrow::tools {

bool run_diff(const DiffArguments& arguments) {
  const LoadedFile a = load_mrw(arguments.a), b = load_mrw(arguments.b);
  const bool equal =
      a.bytes.size() == b.bytes.size() && std::memcmp(a.bytes.data(), b.bytes.data(), a.bytes.size()) == 0;
  const nlohmann::ordered_json differences = compare(a, b);
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
