#include "cook/options/exclusions.h"

#include "common/failure.h"

namespace marrow::cook {
namespace {

// `option`, where it is given and not "false", is refused if this holds.
struct Exclusion {
  const char* option;
  const char* rule;
  const char* advice;
  bool (*holds)(const CookOptions& options, const Options& given);
};

bool fits(const CookOptions& o) {
  return o.learn.animation_space == AnimationSpace::fit;
}
bool lifts(const CookOptions& o) {
  return o.learn.animation_space == AnimationSpace::lift;
}
bool learns_beside(const CookOptions& o) {
  return o.learn.multi_weights || o.learn.pose_examples > 0;
}
bool has_eigen(const CookOptions& o) {
  return o.learn.eigen_targets > 0;
}
bool has_truth(const CookOptions& o, const Options& given) {
  return fits(o) || given.contains("truth");
}

using Asked = const CookOptions&;
using Names = const Options&;
constexpr const char* kClipsWithMeshes = "it is of the clips that are cooked with the meshes; leave out one";

// The first that holds is said.
constexpr Exclusion kExclusions[] = {
    {"rebind", "--rebind without new weights", "give --auto-weights too",
     [](Asked o, Names) { return !o.prepare.weights.make.has_value(); }},
    {"truth", "--truth without a fit", "give --as fit, --helpers, --mwe, --psd or --eigenskin too",
     [](Asked o, Names) {
       return !fits(o) && !learns_beside(o) && !(lifts(o) && o.learn.helpers != 0) && !has_eigen(o);
     }},
    {"eigenskin", "--eigenskin without plain weights",
     "leave out --as, --helpers, --mwe and --psd: they mend the same twice",
     [](Asked o, Names) { return has_eigen(o) && (!lifts(o) || learns_beside(o) || o.learn.helpers != 0); }},
    {"eigenskin", "--eigenskin without a truth in every pose", "give another truth, such as cor",
     [](Asked o, Names) { return has_eigen(o) && o.learn.truth == Truth::examples; }},
    {"examples", "--examples without their truth", "give --truth examples too",
     [](Asked o, Names) { return o.learn.truth != Truth::examples; }},
    {"truth", "--truth without its examples", "give --examples FILE too",
     [](Asked o, Names) { return o.learn.truth == Truth::examples && o.learn.examples_file.empty(); }},
    {"influences", "--influences without a choice of them", "give --as fit or --as smooth too",
     [](Asked o, Names) { return lifts(o); }},
    {"keep-bind-pose", "--keep-bind-pose without a fit", "give --as fit too", [](Asked o, Names) { return !fits(o); }},
    {"helpers", "--helpers without what may follow them", "leave out --as smooth, or give --as fit",
     [](Asked o, Names) { return !fits(o) && !(lifts(o) && o.learn.helpers != 0); }},
    {"delta-mush", "--delta-mush without anything to smooth", "give --as smooth, or a fit and --truth delta-mush too",
     [](Asked o, Names) { return lifts(o) && !((learns_beside(o) || has_eigen(o)) && smooths(o.learn.truth)); }},
    {"elastic", "--elastic without its truth", "give --truth elastic too",
     [](Asked o, Names) { return o.learn.truth != Truth::elastic; }},
    {"wide-poses", "--wide-poses without a fit to a deformer",
     "give --as fit, --mwe or --psd too, and a truth that is not examples",
     [](Asked o, Names) { return !(fits(o) || learns_beside(o)) || o.learn.truth == Truth::examples; }},
    {"mwe", "--mwe without a truth", "give --truth too", [](Asked o, Names n) { return !has_truth(o, n); }},
    {"psd", "--psd without a truth", "give --truth too",
     [](Asked o, Names n) { return o.learn.pose_examples > 0 && !has_truth(o, n); }},
    {"subdivide", "--subdivide with --mwe", "leave out one of them; --mwe is of the source's own vertices",
     [](Asked o, Names) { return o.mesh.subdivide > 0 && o.learn.multi_weights; }},
    {"subdivide", "--subdivide with --psd", "leave out one of them; --psd is of the source's own vertices",
     [](Asked o, Names) { return o.mesh.subdivide > 0 && o.learn.pose_examples > 0; }},
    {"subdivide", "--subdivide with --keep-vertex-order",
     "leave out one of them; --keep-vertex-order is of the source's own vertices",
     [](Asked o, Names) { return o.mesh.subdivide > 0 && o.mesh.keep_vertex_order; }},
    {"auto-skeleton", "--auto-skeleton with --clips-only", "clips have no mesh; leave out one",
     [](Asked o, Names) { return !o.prepare.auto_skeleton.empty() && o.clips_only; }},
    {"auto-skeleton", "--auto-skeleton with --skeleton", "the skeleton is made or that of a character; leave out one",
     [](Asked o, Names) { return !o.prepare.auto_skeleton.empty() && !o.skeleton_file.empty(); }},
    {"weights-over-time", "--weights-over-time with --clips-only", kClipsWithMeshes,
     [](Asked o, Names) { return o.clips_only; }},
    {"eigenskin", "--eigenskin with --clips-only", kClipsWithMeshes, [](Asked o, Names) { return o.clips_only; }},
};

// What a product cannot have: where the option was given, or null.
struct NotFor {
  Product product;
  const char* rule;
  const char* advice;
  const RuleOrigin* (*given)(const CookOptions& options);
};

template <class Rule>
const RuleOrigin* first_of(const std::vector<Rule>& rules) {
  return rules.empty() ? nullptr : &rules[0].origin;
}
constexpr const char* kForTheBody = "give it for the body, or --clips-only for a clip pack";

constexpr NotFor kNotFor[] = {
    // In marrow.toml it may stand for all files, of which some are packs.
    {Product::pack, "--pose-map for a clip pack", "give it for the character",
     [](Asked o) {
       const RuleOrigin* const origin = first_of(o.retarget.poses);
       return origin != nullptr && origin->must_fit ? origin : nullptr;
     }},
    // The body plays the clips, and the clothes follow.
    {Product::outfit, "--retarget for an outfit", kForTheBody, [](Asked o) { return first_of(o.retarget.clips); }},
    {Product::outfit, "--mirror for an outfit", kForTheBody, [](Asked o) { return first_of(o.retarget.mirror); }},
    {Product::outfit, "--pose-map for an outfit", "give it for the body, which poses it",
     [](Asked o) { return first_of(o.retarget.poses); }},
};

[[noreturn]] void refuse(const RuleOrigin& origin, const char* rule, const char* advice) {
  throw tools::Failure(tools::Exit::usage, origin.file, origin.where, rule, advice);
}

}  // namespace

void check_together(const CookOptions& options, const Options& given) {
  for (const Exclusion& exclusion : kExclusions) {
    const auto found = given.find(exclusion.option);
    if (found == given.end() || found->second.empty() || found->second.front().text == "false") continue;
    if (exclusion.holds(options, given)) refuse(found->second.front().origin, exclusion.rule, exclusion.advice);
  }
}

void check_for(Product product, const CookOptions& options) {
  for (const NotFor& row : kNotFor)
    if (row.product == product)
      if (const RuleOrigin* const origin = row.given(options)) refuse(*origin, row.rule, row.advice);
}

}  // namespace marrow::cook
