#include "cook/command.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <string_view>

#include <fmt/format.h>

#include "common/failure.h"
#include "common/files.h"
#include "common/load_mrw.h"
#include "cook/cook.h"
#include "cook/match_skeletons.h"

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

// "0.1mm", "0.0001m", or a share as in "0.05%".
struct Amount {
  double value = 0;
  bool is_share = false;
};

bool read_amount(std::string_view text, Amount& out) {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, out.value);
  const std::string_view unit(stop, static_cast<std::size_t>(end - stop));
  const double scale = unit == "m" ? 1.0 : unit == "mm" ? 1e-3 : unit == "%" ? 1e-2 : 0.0;
  out.is_share = unit == "%";
  out.value *= scale;
  return error == std::errc() && out.value > 0 && std::isfinite(out.value);
}

// An amount; in front "JOINT=", or for all joints.
cook::ClipErrorRule read_clip_error(const std::string& text) {
  const std::size_t divide = text.rfind('=');
  cook::ClipErrorRule rule;
  if (divide != std::string::npos) rule.joints = text.substr(0, divide);
  Amount amount;
  if (!read_amount(std::string_view(text).substr(divide == std::string::npos ? 0 : divide + 1), amount) || divide == 0)
    throw Failure(Exit::usage, "--clip-error", "", "\"" + text + "\" is not an error",
                  "give a length or a share of the skeleton, as in 0.1mm, 0.0001m, 0.05% or hand*=0.02mm");
  rule.error = amount.value;
  rule.is_share = amount.is_share;
  return rule;
}

void read_position_error(const std::string& text, cook::CookOptions& options) {
  if (text.empty()) return;
  Amount amount;
  if (!read_amount(text, amount))
    throw Failure(Exit::usage, "--position-error", "", "\"" + text + "\" is not an error",
                  "give a length or a share of the mesh's longest side, as in 0.1mm, 0.0001m or 0.01%");
  options.position_error = amount.value;
  options.position_error_is_share = amount.is_share;
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

cook::Character read_character(const std::string& path) {
  if (!path.ends_with(".mrw")) return cook::read_character(path);
  const LoadedFile loaded = load_mrw(path);
  return cook::view_character(path, loaded.file);
}

}  // namespace

void run_cook(const CookArguments& a) {
  cook::CookOptions options = a.options;
  options.raw_clips = a.clip_codec == "raw";
  options.mesh_codec = a.mesh_codec == "draco"     ? cook::MeshCodec::draco
                       : a.mesh_codec == "meshopt" ? cook::MeshCodec::meshopt
                                                   : cook::MeshCodec::none;
  read_position_error(a.position_error, options);
  options.images = a.images == "embed"  ? cook::Images::embed
                   : a.images == "none" ? cook::Images::none
                                        : cook::Images::reference;
  for (const std::string& text : a.clip_error) options.clip_error.push_back(read_clip_error(text));
  for (const std::string& text : a.additive) options.additive.push_back(read_additive(text));
  if (!a.skeleton.empty() && !options.clips_only)
    throw Failure(Exit::usage, "--skeleton", "", "no clip pack", "give --clips-only too");
  if (!a.skeleton.empty()) options.onto = std::make_shared<cook::Character>(read_character(a.skeleton));
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
