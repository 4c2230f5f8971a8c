#include "cook/clip/additive_references.h"

#include <algorithm>
#include <cstring>

#include "common/failure.h"
#include "cook/scene/views.h"
#include "marrow/sample.h"
#include "text/nearest.h"
#include "text/pattern.h"

namespace marrow::cook {
namespace {

[[noreturn]] void no_such_clip(const std::string& name, const std::vector<BuiltClip>& clips, const RuleOrigin& origin) {
  std::vector<std::string> names;
  for (const BuiltClip& clip : clips) names.push_back(clip.name);
  throw tools::Failure(tools::Exit::usage, origin.file, origin.where, "no clip is called \"" + name + "\"",
                       names.empty() ? "there are no clips" : tools::suggestion(name, names));
}

std::vector<SoaTransform> first_frame(const BuiltSkeleton& of, const BuiltClip& clip) {
  const Skeleton skeleton = view(of);
  std::vector<SoaTransform> pose(skeleton.soa_size());
  if (sample(skeleton, view(clip, skeleton), 0.0f, pose) != Status::ok)
    throw tools::Failure(tools::Exit::internal, "--additive", "", "no pose of \"" + clip.name + "\"",
                         "please report this");
  return pose;
}

// skeleton: the clip's.
std::vector<SoaTransform> reference_pose(const BuiltSkeleton& skeleton, const std::vector<BuiltClip>& clips,
                                         const BuiltClip& clip, const AdditiveRule& rule) {
  const std::string& reference = rule.reference;
  if (reference == "rest") return {};
  if (reference != "first" && std::ranges::find(clips, reference, &BuiltClip::name) == clips.end())
    no_such_clip(reference, clips, rule.origin);
  const auto other = std::ranges::find_if(
      clips, [&](const BuiltClip& c) { return c.name == reference && c.skeleton == clip.skeleton; });
  if (reference != "first" && other == clips.end()) return {};  // it leaves this skeleton at rest
  std::vector<SoaTransform> pose = first_frame(skeleton, reference == "first" ? clip : *other);
  if (std::memcmp(pose.data(), skeleton.rest.data(), pose.size() * sizeof(SoaTransform)) == 0) pose.clear();
  return pose;
}

}  // namespace

std::vector<AdditiveReference> additive_references(const std::vector<BuiltSkeleton>& skeletons,
                                                   const std::vector<BuiltClip>& clips,
                                                   const std::vector<AdditiveRule>& rules, Notes& notes) {
  std::vector<AdditiveReference> out(clips.size());
  for (const AdditiveRule& rule : rules) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < clips.size(); ++i) {
      if (rule.clips != clips[i].name && !tools::fits(rule.clips, clips[i].name)) continue;
      out[i] = {rule.reference, reference_pose(skeletons[clips[i].skeleton], clips, clips[i], rule)};
      ++found;
    }
    if (found == 0 && rule.origin.must_fit) no_such_clip(rule.clips, clips, rule.origin);
    if (found == 0)
      notes.warnings.push_back(
          {"/animations", "rule-fits-nothing", "additive: no clip is called \"" + rule.clips + "\""});
  }
  return out;
}

}  // namespace marrow::cook
