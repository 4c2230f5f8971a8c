#include "cook/options/option_lists.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "marrow/file.h"
#include "text/number.h"

namespace marrow::cook {
namespace {

constexpr Named<AnimationSpace> kAnimationSpaces[] = {
    {"lift", AnimationSpace::lift}, {"smooth", AnimationSpace::smooth}, {"fit", AnimationSpace::fit}};
constexpr Named<Truth> kTruths[] = {{"cor", Truth::centres_of_rotation}, {"dqs", Truth::dual_quaternions},
                                    {"delta-mush", Truth::delta_mush},   {"delta-mush-dqs", Truth::delta_mush_over_dqs},
                                    {"elastic", Truth::elastic},         {"examples", Truth::examples}};

// "N", "N,STEP" or "N,STEP,cotangent".
void set_delta_mush(CookOptions& options, const Value& given) {
  deform::DeltaMushOptions& mush = options.learn.delta_mush;
  const char* at = given.text.data();
  const char* const end = at + given.text.size();
  auto read = std::from_chars(at, end, mush.iterations);
  bool good = read.ec == std::errc() && mush.iterations >= 1 && mush.iterations <= 1000;
  if (good && read.ptr != end && *read.ptr == ',') {
    read = tools::read_double(read.ptr + 1, end, mush.step);
    good = read.ec == std::errc() && mush.step > 0 && mush.step <= 1;
  }
  const std::string_view rest(read.ptr, static_cast<std::size_t>(end - read.ptr));
  if (rest == ",cotangent") mush.weights = deform::EdgeWeights::cotangent;
  if (!good || !(rest.empty() || rest == ",cotangent"))
    refuse(given, "\"" + given.text + "\" does not say how to smooth",
           "give iterations, 1 to 1000, and a step up to 1, as in 10,0.5 or 30,1,cotangent");
}

// "volume=15", "keep=0.1" or both with a comma between.
void set_elastic(CookOptions& options, const Value& given) {
  deform::ElasticOptions& elastic = options.learn.elastic;
  std::string_view left = given.text;
  for (bool more = true; more;) {
    const std::string_view part = left.substr(0, left.find(','));
    more = part.size() < left.size();
    left.remove_prefix(part.size() + (more ? 1 : 0));
    const std::string_view name = part.substr(0, part.find('='));
    double* const dial = name == "volume" ? &elastic.volume : name == "keep" ? &elastic.keep : nullptr;
    const std::string_view number = part.substr(std::min(part.size(), name.size() + 1));
    double value = -1;
    const auto read = tools::read_double(number.data(), number.data() + number.size(), value);
    const bool good = read.ec == std::errc() && read.ptr == number.data() + number.size();
    const double least = name == "volume" ? 0 : 0.001, most = name == "volume" ? 100 : 10;
    if (dial == nullptr || !good || !(value >= least && value <= most))
      refuse(given, "\"" + given.text + "\" does not say how elastic",
             "give volume, 0 to 100, or keep, 0.001 to 10, or both, as in volume=15,keep=0.1");
    *dial = value;
  }
}

void set_pose_space(CookOptions& options, const Value& given) {
  options.learn.pose_examples = whole_number(given, 0, kMaxPoseExamples);
}

constexpr Option kLearnOptions[] = {
    {"as", OptionKind::text, "TEXT",
     "animation space, what `skin_as` deforms by: lift: the same as linear blend skinning; smooth: delta mush in "
     "closed form; fit: learnt from --truth in the poses of all clips (docs/deformers.md)",
     names_in<kAnimationSpaces>,
     [](CookOptions& o, const Value& v) { o.learn.animation_space = *value_of(kAnimationSpaces, v.text); }},
    {"truth", OptionKind::text, "TEXT",
     "what --as fit, --mwe and --psd learn from: cor: optimised centres of rotation; dqs: dual quaternions; "
     "delta-mush, over linear blend skinning; delta-mush-dqs: over dual quaternions; elastic: a body that does not "
     "fold; "
     "examples: what an artist has shown, --examples",
     names_in<kTruths>, [](CookOptions& o, const Value& v) { o.learn.truth = *value_of(kTruths, v.text); }},
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
    {"elastic",
     OptionKind::text,
     "volume=V[,keep=K]",
     "how --truth elastic gives way: how dearly it keeps its volume, 15 for what twists far, and how dearly it keeps "
     "to the joints; the default is volume=6,keep=0.1",
     {},
     set_elastic},
    {"helpers",
     OptionKind::text,
     "N|auto",
     "matrices between those of joints that vertices share, at most so many a mesh, for --as lift and --as fit: "
     "elbows keep their shape, wrists their volume; auto: as many as the mesh is worth, the default of --as fit "
     "to a truth that blends rotations; else the default is 0",
     {},
     [](CookOptions& o, const Value& v) {
       o.learn.helpers = v.text == "auto" ? kAutoHelpers : whole_number(v, 0, kMostHelpers);
     }},
    {"influences",
     OptionKind::text,
     "N",
     "joints that a vertex may follow in animation space, 1 to 8, the most important ones; those that it has weights "
     "of it follows anyway; the default is 4, with helpers 5",
     {},
     [](CookOptions& o, const Value& v) { o.learn.influences = whole_number(v, 1, kMaxInfluences); }},
    {"keep-bind-pose",
     OptionKind::flag,
     "",
     "--as fit leaves the bind pose exactly as it is",
     {},
     [](CookOptions& o, const Value&) { o.learn.keep_bind_pose = true; }},
    {"wide-poses",
     OptionKind::flag,
     "",
     "learn from 100 poses more, in which every joint turns by up to 150°, within its limit if it has one: better "
     "where code poses joints far beyond the clips, worse in the clips' own frames (docs/deformers.md)",
     {},
     [](CookOptions& o, const Value&) { o.learn.wide_poses = true; }},
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
    {"eigenskin",
     OptionKind::text,
     "FIELDS",
     "what linear blend skinning misses of --truth, as so many morph targets, up to 32, whose weights each clip "
     "drives: "
     "better in the clips, the same elsewhere; 8 is a good start; 0: none",
     {},
     [](CookOptions& o, const Value& v) { o.learn.eigen_targets = whole_number(v, 0, kMostEigenTargets); }},
};

}  // namespace

std::span<const Option> learn_options() {
  return kLearnOptions;
}

}  // namespace marrow::cook
