#include "options/options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "common/failure.h"
#include "common/printable.h"
#include "deform/weights/auto_weights.h"
#include "deform/weights/smooth_weights.h"
#include "marrow/file.h"

namespace marrow::cook {
namespace {

[[noreturn]] void refuse(const Value& value, const std::string& rule, const std::string& advice) {
  throw tools::Failure(tools::Exit::usage, value.origin.file, value.origin.where, tools::printable(rule), advice);
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
void set_clip_error(CookOptions& options, const Value& given) {
  const std::string& text = given.text;
  const std::size_t divide = text.rfind('=');
  ClipErrorRule rule;
  if (divide != std::string::npos) rule.joints = text.substr(0, divide);
  Amount amount;
  if (!read_amount(std::string_view(text).substr(divide == std::string::npos ? 0 : divide + 1), amount) || divide == 0)
    refuse(given, "\"" + text + "\" is not an error",
           "give a length or a share of the skeleton, as in 0.1mm, 0.0001m, 0.05% or hand*=0.02mm");
  rule.error = amount.value;
  rule.is_share = amount.is_share;
  rule.origin = given.origin;
  options.clip_error.push_back(rule);
}

void set_position_error(CookOptions& options, const Value& given) {
  Amount amount;
  if (!read_amount(given.text, amount))
    refuse(given, "\"" + given.text + "\" is not an error",
           "give a length or a share of the mesh's longest side, as in 0.1mm, 0.0001m or 0.01%");
  options.position_error = amount.value;
  options.position_error_is_share = amount.is_share;
}

double number_between(const Value& given, double least, double most) {
  double value = 0;
  const char* const end = given.text.data() + given.text.size();
  const auto [stop, error] = std::from_chars(given.text.data(), end, value);
  if (error != std::errc() || stop != end || !(value >= least && value <= most))
    refuse(given, "\"" + given.text + "\" is out of range",
           "give a number from " + fmt::format("{}", least) + " to " + fmt::format("{}", most));
  return value;
}

int whole_number(const Value& given, int least, int most) {
  const double value = number_between(given, least, most);
  if (value != std::floor(value)) refuse(given, "\"" + given.text + "\" is no whole number", "give one, as in 4");
  return static_cast<int>(value);
}

void set_mesh_codec(CookOptions& options, const Value& given) {
  options.mesh_codec = given.text == "draco"     ? MeshCodec::draco
                       : given.text == "meshopt" ? MeshCodec::meshopt
                                                 : MeshCodec::none;
}

void set_images(CookOptions& options, const Value& given) {
  options.images = given.text == "embed" ? Images::embed : given.text == "none" ? Images::none : Images::reference;
}

void set_animation_space(CookOptions& options, const Value& given) {
  options.learn.animation_space = given.text == "fit"      ? AnimationSpace::fit
                                  : given.text == "smooth" ? AnimationSpace::smooth
                                                           : AnimationSpace::lift;
}

void set_truth(CookOptions& options, const Value& given) {
  options.learn.truth = given.text == "dqs"        ? Truth::dual_quaternions
                        : given.text == "cor"      ? Truth::centres_of_rotation
                        : given.text == "examples" ? Truth::examples
                                                   : Truth::delta_mush;
}

// "N", "N,STEP" or "N,STEP,cotangent".
void set_delta_mush(CookOptions& options, const Value& given) {
  deform::DeltaMushOptions& mush = options.learn.delta_mush;
  const char* at = given.text.data();
  const char* const end = at + given.text.size();
  auto read = std::from_chars(at, end, mush.iterations);
  bool good = read.ec == std::errc() && mush.iterations >= 1 && mush.iterations <= 1000;
  if (good && read.ptr != end && *read.ptr == ',') {
    read = std::from_chars(read.ptr + 1, end, mush.step);
    good = read.ec == std::errc() && mush.step > 0 && mush.step <= 1;
  }
  const std::string_view rest(read.ptr, static_cast<std::size_t>(end - read.ptr));
  if (rest == ",cotangent") mush.weights = deform::EdgeWeights::cotangent;
  if (!good || !(rest.empty() || rest == ",cotangent"))
    refuse(given, "\"" + given.text + "\" does not say how to smooth",
           "give iterations, 1 to 1000, and a step up to 1, as in 10,0.5 or 30,1,cotangent");
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

// "RATIO[:INFLUENCES]", ever coarser, between commas.
void set_lod(CookOptions& options, const Value& given) {
  options.lod.clear();
  const char* at = given.text.data();
  const char* const end = at + given.text.size();
  for (bool good = true; good;) {
    LodRule rule;
    auto read = std::from_chars(at, end, rule.ratio);
    good =
        read.ec == std::errc() && rule.ratio > 0 && rule.ratio < (options.lod.empty() ? 1 : options.lod.back().ratio);
    if (good && read.ptr != end && *read.ptr == ':') {
      read = std::from_chars(read.ptr + 1, end, rule.influences);
      good = read.ec == std::errc() && rule.influences >= 1 && rule.influences <= kMaxInfluences;
    }
    good = good && options.lod.size() < kMostLods;
    if (good) options.lod.push_back(rule);
    if (good && read.ptr == end) return;
    good = good && *read.ptr == ',';
    at = read.ptr + 1;
  }
  refuse(
      given, "\"" + given.text + "\" are no levels of detail",
      "give up to 15 shares of the triangles below 1, descending, each with an influence count from 1 to 8 or without, "
      "as in 0.5,0.25:2");
}

void set_auto_weights(CookOptions& options, const Value& given) {
  using deform::WeightMethod;
  options.weights.make_origin = given.origin;
  options.weights.make.reset();
  if (given.text == "geodesic") options.weights.make = WeightMethod::geodesic;
  if (given.text == "gaussian") options.weights.make = WeightMethod::gaussian;
  if (given.text == "nearest") options.weights.make = WeightMethod::nearest;
}

void set_pose_space(CookOptions& options, const Value& given) {
  options.learn.pose_examples = whole_number(given, 0, kMaxPoseExamples);
}

// At least what a triangle can follow.
void set_palette(CookOptions& options, const Value& given) {
  options.most_entries = static_cast<std::size_t>(whole_number(given, 3 * kMaxInfluences, kMaxJoints));
}

void set_smooth_weights(CookOptions& options, const Value& given) {
  options.weights.smooth_steps = whole_number(given, 0, deform::kMostSmoothSteps);
  options.weights.smooth_origin = given.origin;
}

// "JOINT=MASK.png", divided at the last "=".
void set_paint(CookOptions& options, const Value& given) {
  const std::size_t divide = given.text.rfind('=');
  if (divide == std::string::npos || divide == 0 || divide + 1 == given.text.size())
    refuse(given, "\"" + given.text + "\" names no joint or no mask", "give JOINT=MASK.png, as in head=head.png");
  options.weights.paint.push_back({given.text.substr(0, divide), given.text.substr(divide + 1), given.origin});
}

// What is given of learning must have something to do.
void refuse_idle(const LearnOptions& learn, const Given& given) {
  const auto refuse_unless = [&](bool makes_sense, const char* name, const char* without, const char* advice) {
    const auto found = given.find(name);
    if (!makes_sense && found != given.end() && found->second.front().text != "false")
      refuse(found->second.front(), fmt::format("--{} without {}", name, without), advice);
  };
  const bool fits = learn.animation_space == AnimationSpace::fit,
             beside = learn.multi_weights || learn.pose_examples > 0;
  refuse_unless(fits || beside, "truth", "a fit", "give --as fit, --mwe or --psd too");
  refuse_unless(learn.truth == Truth::examples, "examples", "their truth", "give --truth examples too");
  refuse_unless(learn.truth != Truth::examples || !learn.examples_file.empty(), "truth", "its examples",
                "give --examples FILE too");
  refuse_unless(learn.animation_space != AnimationSpace::lift, "influences", "a choice of them",
                "give --as fit or --as smooth too");
  for (const char* const name : {"half-joints", "keep-bind-pose"})
    refuse_unless(fits, name, "a fit", "give --as fit too");
  refuse_unless(learn.animation_space != AnimationSpace::lift || (beside && learn.truth == Truth::delta_mush),
                "delta-mush", "anything to smooth", "give --as smooth, or a fit and --truth delta-mush too");
  const bool has_truth = fits || given.contains("truth");
  refuse_unless(has_truth, "mwe", "a truth", "give --truth too");
  refuse_unless(has_truth || learn.pose_examples == 0, "psd", "a truth", "give --truth too");
}

// What a finer mesh cannot have: what is not linear in vertices, and the source's order of those.
void refuse_with_subdivide(const CookOptions& options, const Given& given) {
  if (options.subdivide == 0) return;
  const Value& value = given.at("subdivide").front();
  const auto refuse_if = [&](bool is_given, const char* name) {
    if (is_given)
      refuse(value, fmt::format("--subdivide with --{}", name),
             fmt::format("leave out one of them; --{} is of the "
                         "source's own vertices",
                         name));
  };
  refuse_if(options.learn.multi_weights, "mwe");
  refuse_if(options.learn.pose_examples > 0, "psd");
  refuse_if(options.keep_vertex_order, "keep-vertex-order");
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
      {"mesh-codec",
       OptionKind::text,
       "TEXT",
       "draco: the smallest; meshopt: the fastest to unpack; none: not packed, floats as they are",
       {"draco", "meshopt", "none"},
       set_mesh_codec},
      {"position-error",
       OptionKind::text,
       "E",
       "how far quantisation may move vertices: 0.1mm, 0.0001m or 0.01% of the mesh's longest side; the default is 14 "
       "bits on the longest side, 0.0053%",
       {},
       set_position_error},
      {"normal-error",
       OptionKind::text,
       "DEGREES",
       "how far it may turn normals and tangents; the default is 0.2",
       {},
       [](CookOptions& o, const Value& v) { o.precision.normal_error_deg = number_between(v, 0.002, 45); }},
      {"uv-error",
       OptionKind::text,
       "SHARE",
       "how far it may move UVs, in widths of the texture; the default is 0.000122",
       {},
       [](CookOptions& o, const Value& v) { o.precision.uv_error = number_between(v, 1e-7, 1); }},
      {"weight-error",
       OptionKind::text,
       "SHARE",
       "how far it may change weights; the default is 0.00025",
       {},
       [](CookOptions& o, const Value& v) { o.precision.weight_error = number_between(v, 2e-5, 0.5); }},
      {"as",
       OptionKind::text,
       "TEXT",
       "animation space, what `skin_as` deforms by: lift: the same as linear blend skinning; smooth: delta mush in "
       "closed form; fit: learnt from --truth in the poses of all clips (docs/deformers.md)",
       {"lift", "smooth", "fit"},
       set_animation_space},
      {"truth",
       OptionKind::text,
       "TEXT",
       "what --as fit, --mwe and --psd learn from: cor: optimised centres of rotation; dqs: dual quaternions; "
       "delta-mush; examples: what an artist has shown, --examples",
       {"cor", "dqs", "delta-mush", "examples"},
       set_truth},
      {"examples",
       OptionKind::text,
       "FILE",
       "glTF of --truth examples: the character with corrective morph targets that clips drive, or posed meshes "
       "(docs/deformers.md)",
       {},
       [](CookOptions& o, const Value& v) { o.learn.examples_file = v.text; }},
      {"delta-mush",
       OptionKind::text,
       "N[,STEP[,cotangent]]",
       "how --truth delta-mush and --as smooth smooth: iterations, how far each goes, edges by cotangents instead of "
       "all alike; the default is 10,0.5",
       {},
       set_delta_mush},
      {"half-joints",
       OptionKind::text,
       "N",
       "helpers that --as fit may put between a joint and its parent",
       {"0", "1", "2"},
       [](CookOptions& o, const Value& v) { o.learn.half_joints = v.text[0] - '0'; }},
      {"influences",
       OptionKind::text,
       "N",
       "joints that a vertex may follow in animation space, 1 to 8, the most important ones; those that it has weights "
       "of it follows anyway; the default is 4, with half-joints 5",
       {},
       [](CookOptions& o, const Value& v) { o.learn.influences = whole_number(v, 1, kMaxInfluences); }},
      {"keep-bind-pose",
       OptionKind::flag,
       "",
       "--as fit leaves the bind pose exactly as it is",
       {},
       [](CookOptions& o, const Value&) { o.learn.keep_bind_pose = true; }},
      {"mwe",
       OptionKind::flag,
       "",
       "also multi-weight enveloping, what `skin_mwe` deforms by, learnt from --truth as --as fit is",
       {},
       [](CookOptions& o, const Value&) { o.learn.multi_weights = true; }},
      {"psd",
       OptionKind::text,
       "EXAMPLES",
       "also pose-space deformation, what `skin_psd` deforms by, learnt from --truth: how many examples it may have, "
       "up to 32; 8 is a good start; 0: none",
       {},
       set_pose_space},
      {"subdivide",
       OptionKind::text,
       "N",
       "four times the triangles, N times, by Loop's scheme, which rounds the mesh off; what `skin_as` deforms by is "
       "exactly the posed mesh subdivided where --as learns it (docs/deformers.md); 0: none",
       {"0", "1", "2", "3"},
       [](CookOptions& o, const Value& v) { o.subdivide = v.text[0] - '0'; }},
      {"lod",
       OptionKind::text,
       "R[:N][,R[:N]...]",
       "levels of detail with these shares of the triangles, descending, as 0.5,0.25; with :N at most so many "
       "influences a vertex",
       {},
       set_lod},
      {"palette",
       OptionKind::text,
       "ENTRIES",
       "joints and half-joints that a mesh may have, 24 to 32767; what has more is split into several meshes; the "
       "default, 341, is what the GPU paths take",
       {},
       set_palette},
      {"auto-weights",
       OptionKind::text,
       "TEXT",
       "skin weights for meshes that come without; geodesic: by the way to the bones through the mesh, which is "
       "recommended; gaussian and nearest: straight through the air",
       {"none", "geodesic", "gaussian", "nearest"},
       set_auto_weights},
      {"smooth-weights",
       OptionKind::text,
       "STEPS",
       "even out skin weights over the surface, those of the file too, in so many Laplacian steps",
       {},
       set_smooth_weights},
      {"paint",
       OptionKind::list,
       "JOINT=MASK.png",
       "a joint's weight from a grey-scale picture, read at the UVs, white for 1; other joints share what is left; "
       "repeatable",
       {},
       set_paint},
      {"images",
       OptionKind::text,
       "TEXT",
       "reference: materials name their images as the source does; embed: the PNG or JPEG files as they are; none: "
       "neither",
       {"reference", "embed", "none"},
       set_images},
      {"keep",
       OptionKind::list,
       "GLOB",
       "keep nodes by name, as sockets, and their extras; GLOB may have * and ?; repeatable",
       {},
       [](CookOptions& options, const Value& value) { options.keep.push_back(value.text); }},
      {"clips-only",
       OptionKind::flag,
       "",
       "a clip pack: only the clips, for the skeletons of this file or of --skeleton",
       {},
       [](CookOptions& options, const Value&) { options.clips_only = true; }},
      {"skeleton",
       OptionKind::text,
       "CHARACTER",
       "the character, cooked or glTF, that a clip pack is for; nodes are matched with its joints by name",
       {},
       [](CookOptions& options, const Value& value) { options.skeleton_file = value.text; }},
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
  refuse_idle(options.learn, given);
  refuse_with_subdivide(options, given);
  if (!options.skeleton_file.empty() && !options.clips_only)
    refuse(given.at("skeleton").front(), "no clip pack", "give --clips-only too");
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
