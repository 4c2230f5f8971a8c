// docs/report.schema.json against reports of everything that `marrow cook` can do.
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/support/cookings.h"
#include "cli/support/process.h"
#include "support/json_schema.h"
#include "support/places.h"

namespace marrow::test {
namespace {

using nlohmann::json;

json schema_file() {
  return json::parse(std::ifstream(in_source("docs/report.schema.json")));
}

// Reports that have, all together, every property at least once.
std::vector<json> reports() {
  const TemporaryFolder folder;
  std::vector<json> out;
  const auto cook = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "cook");
    arguments.push_back("--json");
    out.push_back(json::parse(run_marrow(arguments).out));
  };
  const std::string one = folder / "t.mrw", tiny = in_golden("tiny.gltf"), broken = folder / "broken.gltf";
  cook({tiny, "-o", one, "--as", "fit", "--mwe", "--psd", "2", "--lod", "0.5", "--keep", "*", "--additive", "*"});
  cook({tiny, "-o", one, "--subdivide", "1", "--clip-codec", "raw"});
  cook({in_golden("looks.gltf"), "-o", one, "--images", "embed"});
  cook({shining_gltf(folder), "-o", one});
  cook({in_golden("face.gltf"), "-o", one});
  cook({newt_glb(), "-o", one, "--palette", "24", "--clip-codec", "raw"});
  cook({tiny, "-o", one, "--clips-only"});
  write_text(broken, "{");
  cook({tiny, broken, "-o", folder / "many/"});
  return out;
}

// Names of properties in a schema and in the values that it is for.
void collect(const json& schema, std::set<std::string>& names) {
  if (schema.contains("items")) collect(schema["items"], names);
  for (const char* const of_schemas : {"properties", "anyOf", "$defs"})
    if (schema.contains(of_schemas))
      for (const json& part : schema[of_schemas]) collect(part, names);
  if (schema.contains("properties"))
    for (const auto& [name, property] : schema["properties"].items()) names.insert(name);
}
void collect_keys(const json& value, std::set<std::string>& names) {
  if (!value.is_structured()) return;
  if (value.is_object())
    for (const auto& [name, member] : value.items()) names.insert(name);
  for (const json& part : value) collect_keys(part, names);
}

// Counts changes to any part of a report that are accepted: a property too many, and a value of another type.
std::size_t accepted_changes(const Schema& schema, const json& report, std::size_t& changes) {
  std::size_t accepted = 0;
  const auto attempt = [&](const json::json_pointer& where, const json& with) {
    json changed = report;
    changed[where] = with;
    ++changes;
    if (!schema.accepts(changed)) return;
    ++accepted;
    ADD_FAILURE() << where << " may be " << with;
  };
  const json leaves = report.flatten();
  for (const auto& [path, value] : leaves.items()) {
    const json::json_pointer where(path);
    attempt(where, value.is_string() ? json(1) : json::object({{"odd", 1}}));
    if (!where.parent_pointer().empty() && report[where.parent_pointer()].is_object())
      attempt(where.parent_pointer() / "odd", 1);
  }
  return accepted;
}

TEST(ReportSchema, FitsEveryReport) {
  const json file = schema_file();
  const Schema schema(file);
  std::set<std::string> known, met;
  collect(file, known);
  for (const json& report : reports()) {
    EXPECT_TRUE(schema.accepts(report)) << report.dump(1).substr(0, 4000);
    collect_keys(report, met);
  }
  EXPECT_EQ(known, met) << "nothing is in the schema alone";
}

TEST(ReportSchema, RefusesEverythingElse) {
  const Schema schema(schema_file());
  const TemporaryFolder folder;
  const json report =
      json::parse(run_marrow({"cook", in_golden("tiny.gltf"), "-o", folder / "t.mrw", "--keep", "*", "--json"}).out);
  ASSERT_TRUE(schema.accepts(report));
  std::size_t changes = 0;
  EXPECT_EQ(accepted_changes(schema, report, changes), 0u);
  EXPECT_GT(changes, 200u);
  for (const auto& [name, value] : report.items()) {
    json less = report;
    less.erase(name);
    EXPECT_FALSE(schema.accepts(less)) << name;
  }
}

}  // namespace
}  // namespace marrow::test
