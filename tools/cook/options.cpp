#include "cook/options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "common/failure.h"
#include "cook/gltf/text.h"

namespace marrow::cook {
namespace {

[[noreturn]] void refuse(const Value& value, const std::string& rule, const std::string& advice) {
  throw tools::Failure(tools::Exit::usage, value.origin.file, value.origin.where, gltf::printable(rule), advice);
}

// "0.1mm", "0.0001m", or "0.05%" of the skeleton's diagonal; in front "JOINT=", or for all joints.
void set_clip_error(CookOptions& options, const Value& given) {
  const std::string& text = given.text;
  const std::size_t divide = text.rfind('=');
  ClipErrorRule rule;
  if (divide != std::string::npos) rule.joints = text.substr(0, divide);
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + (divide == std::string::npos ? 0 : divide + 1), end, value);
  const std::string_view unit(stop, static_cast<std::size_t>(end - stop));
  const double scale = unit == "m" ? 1.0 : unit == "mm" ? 1e-3 : unit == "%" ? 1e-2 : 0.0;
  if (error != std::errc() || !(value * scale > 0) || !std::isfinite(value) || divide == 0)
    refuse(given, "\"" + text + "\" is not an error",
           "give a length or a share of the skeleton, as in 0.1mm, 0.0001m, 0.05% or hand*=0.02mm");
  rule.error = value * scale;
  rule.is_share = unit == "%";
  rule.origin = given.origin;
  options.clip_error.push_back(rule);
}

// "CLIP" or "CLIP=REFERENCE", divided at the last "=".
void set_additive(CookOptions& options, const Value& given) {
  const std::size_t divide = given.text.rfind('=');
  AdditiveRule rule;
  rule.clips = given.text.substr(0, divide);
  if (divide != std::string::npos) rule.reference = given.text.substr(divide + 1);
  if (rule.clips.empty() || rule.reference.empty())
    refuse(given, "\"" + given.text + "\" names no clip or no reference",
           "give CLIP or CLIP=REFERENCE, as in aim=rest");
  rule.origin = given.origin;
  options.additive.push_back(rule);
}

}  // namespace

const std::vector<Option>& option_table() {
  static const std::vector<Option> table = {
      {"clip-error",
       OptionKind::list,
       "[JOINT=]E",
       "how far clips may stray, on a shell of 3 cm round each joint: 0.1mm (the default), 0.0001m or 0.05% of the "
       "skeleton; with JOINT= for some joints only, JOINT may have * and ?; repeatable, the last that fits counts",
       {},
       set_clip_error},
      {"clip-codec",
       OptionKind::text,
       "TEXT",
       "segments: compressed within --clip-error; raw: without loss",
       {"segments", "raw"},
       [](CookOptions& options, const Value& value) { options.raw_clips = value.text == "raw"; }},
      {"additive",
       OptionKind::list,
       "CLIP[=REFERENCE]",
       "make clips additive, as changes from a reference: first (their first frame, the default), rest, or another "
       "clip's first frame; CLIP may have * and ?; repeatable",
       {},
       set_additive},
      {"keep-vertex-order",
       OptionKind::flag,
       "",
       "remember the source's vertex order, for `marrow pose` and for comparing with other evaluators",
       {},
       [](CookOptions& options, const Value&) { options.keep_vertex_order = true; }},
  };
  return table;
}

void replace(Given& given, const Given& with) {
  for (const auto& [name, values] : with) given[name] = values;
}

CookOptions to_options(const Given& given) {
  CookOptions options;
  for (const Option& option : option_table()) {
    const auto found = given.find(option.name);
    if (found == given.end()) continue;
    for (const Value& value : found->second) {
      if (option.kind == OptionKind::flag && value.text != "true") continue;
      if (!option.choices.empty() && std::ranges::find(option.choices, value.text) == option.choices.end()) {
        std::string choices;
        for (const std::string& choice : option.choices) choices += (choices.empty() ? "" : " or ") + choice;
        refuse(value, "\"" + value.text + "\" is no " + option.name, "give " + choices);
      }
      option.set(options, value);
    }
  }
  return options;
}

std::string canonical_text(const Given& given) {
  std::string out;
  for (const auto& [name, values] : given) {
    for (const Value& value : values)
      out +=
          name + " " + std::to_string(value.text.size()) + " " + value.text + (value.origin.must_fit ? " !\n" : "\n");
  }
  return out;
}

}  // namespace marrow::cook
