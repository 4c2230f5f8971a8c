#include "cook/command.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <string_view>

#include <fmt/format.h>

#include "common/failure.h"
#include "common/files.h"
#include "cook/cook.h"

namespace marrow::tools {
namespace {

void summarise(const CookArguments& a, const nlohmann::ordered_json& r) {
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

// "0.1mm", "0.0001m", or "0.05%" of the skeleton's diagonal; in front "JOINT=", or for all joints.
cook::ClipErrorRule read_clip_error(const std::string& text) {
  const std::size_t divide = text.rfind('=');
  cook::ClipErrorRule rule;
  if (divide != std::string::npos) rule.joints = text.substr(0, divide);
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + (divide == std::string::npos ? 0 : divide + 1), end, value);
  const std::string_view unit(stop, static_cast<std::size_t>(end - stop));
  const double scale = unit == "m" ? 1.0 : unit == "mm" ? 1e-3 : unit == "%" ? 1e-2 : 0.0;
  if (error != std::errc() || !(value * scale > 0) || !std::isfinite(value) || divide == 0)
    throw Failure(Exit::usage, "--clip-error", "", "\"" + text + "\" is not an error",
                  "give a length or a share of the skeleton, as in 0.1mm, 0.0001m, 0.05% or hand*=0.02mm");
  rule.error = value * scale;
  rule.is_share = unit == "%";
  return rule;
}

// "CLIP" or "CLIP=REFERENCE", divided at the last "=".
cook::AdditiveRule read_additive(const std::string& text) {
  const std::size_t divide = text.rfind('=');
  cook::AdditiveRule rule;
  rule.clips = text.substr(0, divide);
  if (divide != std::string::npos) rule.reference = text.substr(divide + 1);
  if (rule.clips.empty() || rule.reference.empty())
    throw Failure(Exit::usage, "--additive", "", "\"" + text + "\" names no clip or no reference",
                  "give CLIP or CLIP=REFERENCE, as in aim=rest");
  return rule;
}

}  // namespace

void run_cook(const CookArguments& a) {
  cook::CookOptions options = a.options;
  options.raw_clips = a.clip_codec == "raw";
  options.images = a.images == "embed"  ? cook::Images::embed
                   : a.images == "none" ? cook::Images::none
                                        : cook::Images::reference;
  for (const std::string& text : a.clip_error) options.clip_error.push_back(read_clip_error(text));
  for (const std::string& text : a.additive) options.additive.push_back(read_additive(text));
  const cook::CookResult result = cook::cook_file(a.in, options);
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

}  // namespace marrow::tools
