#include "options/options.h"

#include <algorithm>

#include <fmt/format.h>

#include "options/option_lists.h"

namespace marrow::cook {
namespace {

// What is given of weights and of learning must have something to do.
void refuse_idle(const CookOptions& options, const Given& given) {
  const LearnOptions& learn = options.learn;
  const auto refuse_unless = [&](bool makes_sense, const char* name, const char* without, const char* advice) {
    const auto found = given.find(name);
    if (!makes_sense && found != given.end() && found->second.front().text != "false")
      refuse(found->second.front(), fmt::format("--{} without {}", name, without), advice);
  };
  refuse_unless(options.weights.make.has_value(), "rebind", "new weights", "give --auto-weights too");
  const bool fits = learn.animation_space == AnimationSpace::fit,
             beside = learn.multi_weights || learn.pose_examples > 0;
  const bool lifts = learn.animation_space == AnimationSpace::lift && learn.helpers != 0;
  const bool eigen = learn.eigen_targets > 0;
  refuse_unless(fits || beside || lifts || eigen, "truth", "a fit",
                "give --as fit, --helpers, --mwe, --psd or --eigenskin too");
  refuse_unless(!eigen || !(fits || beside || learn.animation_space == AnimationSpace::smooth || learn.helpers != 0),
                "eigenskin", "plain weights", "leave out --as, --helpers, --mwe and --psd: they mend the same twice");
  refuse_unless(!eigen || learn.truth != Truth::examples, "eigenskin", "a truth in every pose",
                "give another truth, such as cor");
  refuse_unless(learn.truth == Truth::examples, "examples", "their truth", "give --truth examples too");
  refuse_unless(learn.truth != Truth::examples || !learn.examples_file.empty(), "truth", "its examples",
                "give --examples FILE too");
  refuse_unless(learn.animation_space != AnimationSpace::lift, "influences", "a choice of them",
                "give --as fit or --as smooth too");
  refuse_unless(fits, "keep-bind-pose", "a fit", "give --as fit too");
  refuse_unless(fits || lifts, "helpers", "what may follow them", "leave out --as smooth, or give --as fit");
  refuse_unless(learn.animation_space != AnimationSpace::lift || ((beside || eigen) && smooths(learn.truth)),
                "delta-mush", "anything to smooth", "give --as smooth, or a fit and --truth delta-mush too");
  refuse_unless(learn.truth == Truth::elastic, "elastic", "its truth", "give --truth elastic too");
  refuse_unless((fits || beside) && learn.truth != Truth::examples, "wide-poses", "a fit to a deformer",
                "give --as fit, --mwe or --psd too, and a truth that is not examples");
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

// What belongs to meshes that are not cooked.
void refuse_for_packs(const CookOptions& options, const Given& given) {
  if (!options.clips_only) return;
  for (const char* const name : {"weights-over-time", "eigenskin"})
    if (const auto found = given.find(name); found != given.end())
      refuse(found->second.front(), fmt::format("--{} with --clips-only", name),
             "it is of the clips that are cooked with the meshes; leave out one");
}

// A skeleton is made for meshes, and not for what is for another.
void refuse_with_skeleton(const CookOptions& options, const Given& given) {
  if (options.auto_skeleton.empty()) return;
  const Value& value = given.at("auto-skeleton").front();
  if (options.clips_only) refuse(value, "--auto-skeleton with --clips-only", "clips have no mesh; leave out one");
  if (!options.skeleton_file.empty())
    refuse(value, "--auto-skeleton with --skeleton", "the skeleton is made or that of a character; leave out one");
}

}  // namespace

const std::vector<Option>& option_table() {
  static const std::vector<Option> table = [] {
    std::vector<Option> out;
    for (const std::span<const Option> part : {clip_options(), motion_options(), precision_options(), learn_options(),
                                               mesh_options(), weight_options(), scene_options()})
      out.insert(out.end(), part.begin(), part.end());
    return out;
  }();
  return table;
}

std::string replacement_of(std::string_view name) {
  return name == "half-joints" ? "helpers took their place, give --helpers N or --helpers auto" : "";
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
      if (!option.choices.empty() && std::ranges::find(option.choices, value.text) == option.choices.end())
        refuse(value, "\"" + value.text + "\" is no " + option.name,
               fmt::format("give {}", fmt::join(option.choices, " or ")));
      option.set(options, value);
    }
  }
  if (const auto shapes = given.find(kShapes); shapes != given.end())
    for (const Value& value : shapes->second) options.shapes.push_back(*value.shape);
  // Of what blends rotations; beside delta mush helpers do not pay.
  LearnOptions& learn = options.learn;
  if (learn.animation_space == AnimationSpace::fit && !given.contains("helpers") && blends_rotations(learn.truth))
    learn.helpers = kAutoHelpers;
  refuse_idle(options, given);
  refuse_with_subdivide(options, given);
  refuse_with_skeleton(options, given);
  refuse_for_packs(options, given);
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
