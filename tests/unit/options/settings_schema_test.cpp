// docs/settings.schema.json, by which editors know marrow.toml: it has the options, and accepts what the reader
// accepts.
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "disk/settings.h"
#include "support/json_schema.h"
#include "support/places.h"

namespace marrow::cook {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson schema_of(const Option& option) {
  OrderedJson out = {{"description", option.help}};
  if (option.kind == OptionKind::list) {
    out["$ref"] = "#/$defs/strings";
  } else if (option.kind == OptionKind::table) {  // [roles] alone
    out["type"] = "object";
    for (std::uint32_t r = 1; r < kRoleCount; ++r)
      out["properties"][role_name(static_cast<Role>(r))] = {{"type", "string"}};
    out["additionalProperties"] = false;
  } else if (!option.choices.empty()) {
    out["enum"] = option.choices;
  } else {
    out["type"] = option.kind == OptionKind::flag ? "boolean" : "string";
  }
  return out;
}

// An object of these members alone.
OrderedJson object_of(const OrderedJson& properties, const OrderedJson& required) {
  return {{"type", "object"}, {"properties", properties}, {"required", required}, {"additionalProperties", false}};
}

OrderedJson list_of(const OrderedJson& items, int least, int most) {
  return {{"type", "array"}, {"items", items}, {"minItems", least}, {"maxItems", most}};
}

// Of [[shapes]].
OrderedJson schema_of_shapes() {
  const OrderedJson name = {{"type", "string"}}, number = {{"type", "number"}, {"minimum", -1e6}, {"maximum", 1e6}};
  const OrderedJson parameter = object_of({{"name", name}, {"default", number}}, OrderedJson::array({"name"}));
  const OrderedJson any = {{"anyOf", OrderedJson::array({name, parameter})}};
  const OrderedJson example = object_of({{"target", name}, {"at", list_of(number, 1, 8)}}, OrderedJson::array({"at"}));
  const OrderedJson shape = object_of(
      {{"name", name}, {"mesh", name}, {"parameters", list_of(any, 1, 8)}, {"examples", list_of(example, 2, 64)}},
      {"name", "parameters", "examples"});
  return {{"description", "Morph targets at points of a space of parameters, which weigh them."},
          {"type", "array"},
          {"items", shape}};
}

// What the file should be.
OrderedJson expected() {
  OrderedJson options;
  for (const Option& option : option_table()) options[option.name] = schema_of(option);
  options[kShapes] = schema_of_shapes();
  OrderedJson rule = options;
  rule["match"] = {{"description", "Names of inputs relative to this file's folder; * stands for any characters."},
                   {"$ref", "#/$defs/strings"}};
  OrderedJson root = options;
  root["file"] = {
      {"description", "Options of some inputs. Of rules that fit, the last that gives an option counts."},
      {"type", "array"},
      {"items", {{"type", "object"}, {"properties", rule}, {"required", {"match"}}, {"additionalProperties", false}}}};
  const OrderedJson string = {{"type", "string"}};
  return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
          {"title", "marrow.toml: options of `marrow cook`"},
          {"type", "object"},
          {"properties", root},
          {"additionalProperties", false},
          {"$defs", {{"strings", {{"anyOf", {string, {{"type", "array"}, {"items", string}}}}}}}}};
}

std::string schema_text() {
  std::ifstream stream(test::in_source("docs/settings.schema.json"));
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

bool reads(const std::string& text) {
  try {
    parse_settings("/project/marrow.toml", text);
    return true;
  } catch (const tools::Failure&) {
    return false;
  }
}

TEST(SettingsSchema, HasTheOptions) {
  const std::string text = expected().dump(2) + "\n";
  // After a change to the options: this is what the file should be.
  if (schema_text() != text) std::ofstream("settings.schema.json") << text;
  EXPECT_TRUE(schema_text() == text) << "copy settings.schema.json from the working directory to docs/";
}

TEST(SettingsSchema, AcceptsWhatIsReadAndRefusesWhatIsNot) {
  const test::Schema schema(nlohmann::json::parse(schema_text()));
  // The same as TOML and as JSON.
  const struct {
    const char *toml, *json;
  } good[] = {{"", "{}"},
              {"clip-error = '0.1mm'", R"({"clip-error": "0.1mm"})"},
              {"clip-error = ['0.1mm', 'hand*=1mm']", R"({"clip-error": ["0.1mm", "hand*=1mm"]})"},
              {"keep-vertex-order = true", R"({"keep-vertex-order": true})"},
              {"mesh-codec = 'meshopt'", R"({"mesh-codec": "meshopt"})"},
              {"[[shapes]]\nname = 'n'\nparameters = ['p', {name = 'q', default = 0.5}]\n"
               "examples = [{at = [0, 0]}, {at = [1, 0], target = 't'}]",
               R"({"shapes": [{"name": "n", "parameters": ["p", {"name": "q", "default": 0.5}],
                   "examples": [{"at": [0, 0]}, {"at": [1, 0], "target": "t"}]}]})"},
              {"[roles]\nhips = 'pelvis'\njaw = ''", R"({"roles": {"hips": "pelvis", "jaw": ""}})"},
              {"[[file]]\nmatch = 'a*'\nclip-codec = 'raw'", R"({"file": [{"match": "a*", "clip-codec": "raw"}]})"},
              {"[[file]]\nmatch = ['a', 'b']\nlod = '0.5'", R"({"file": [{"match": ["a", "b"], "lod": "0.5"}]})"}},
    bad[] = {{"clip-eror = '0.1mm'", R"({"clip-eror": "0.1mm"})"},
             {"clip-error = 1", R"({"clip-error": 1})"},
             {"clip-error = [1]", R"({"clip-error": [1]})"},
             {"roles = ['hips=pelvis']", R"({"roles": ["hips=pelvis"]})"},
             {"[roles]\nhip = 'pelvis'", R"({"roles": {"hip": "pelvis"}})"},
             {"[roles]\nhips = 1", R"({"roles": {"hips": 1}})"},
             {"mwe = 'true'", R"({"mwe": "true"})"},
             {"mesh-codec = 'zip'", R"({"mesh-codec": "zip"})"},
             {"[[file]]\nclip-codec = 'raw'", R"({"file": [{"clip-codec": "raw"}]})"},
             {"[[file]]\nmatch = 3", R"({"file": [{"match": 3}]})"},
             {"shapes = 'a'", R"({"shapes": "a"})"},
             {"[[shapes]]\nname = 'n'\nparameters = ['p']\nexamples = [{at = [0]}]",
              R"({"shapes": [{"name": "n", "parameters": ["p"], "examples": [{"at": [0]}]}]})"},
             {"[[shapes]]\nname = 'n'\nparameters = ['p']\nexamples = [{}, {at = [1], target = 't'}]",
              R"({"shapes": [{"name": "n", "parameters": ["p"], "examples": [{}, {"at": [1], "target": "t"}]}]})"},
             {"file = 'a'", R"({"file": "a"})"},
             {"match = 'a'", R"({"match": "a"})"},
             {"lod = ['0.5']", R"({"lod": ["0.5"]})"}};
  for (const auto& text : good) {
    EXPECT_TRUE(reads(text.toml)) << text.toml;
    EXPECT_TRUE(schema.accepts(nlohmann::json::parse(text.json))) << text.json;
  }
  for (const auto& text : bad) {
    EXPECT_FALSE(reads(text.toml)) << text.toml;
    EXPECT_FALSE(schema.accepts(nlohmann::json::parse(text.json))) << text.json;
  }
}

}  // namespace
}  // namespace marrow::cook
