// Which clips become additive, and the poses that their changes are taken from.
#include <algorithm>
#include <cstring>

#include "common/failure.h"
#include "common/pattern.h"
#include "cook/build.h"
#include "cook/clip/compress/pack_tracks.h"
#include "marrow/sample.h"

namespace marrow::cook {
namespace {

[[noreturn]] void no_such_clip(const std::string& name, const RuleOrigin& origin) {
  throw tools::Failure(tools::Exit::usage, origin.file, origin.where, "no clip is called \"" + name + "\"",
                       "give CLIP or CLIP=REFERENCE with names as `marrow info` lists them");
}

std::vector<SoaTransform> first_frame(const BuiltScene& scene, const BuiltClip& clip) {
  const Skeleton skeleton = view(scene.skeletons[clip.skeleton]);
  std::vector<SoaTransform> pose(skeleton.soa_size());
  if (sample(skeleton, view(clip, skeleton), 0.0f, pose) != Status::ok)
    throw tools::Failure(tools::Exit::internal, "--additive", "", "no pose of \"" + clip.name + "\"",
                         "please report this");
  return pose;
}

std::vector<SoaTransform> reference_pose(const BuiltScene& scene, const BuiltClip& clip, const AdditiveRule& rule) {
  const std::string& reference = rule.reference;
  if (reference == "rest") return {};
  if (reference != "first" && std::ranges::find(scene.clips, reference, &BuiltClip::name) == scene.clips.end())
    no_such_clip(reference, rule.origin);
  const auto other = std::ranges::find_if(
      scene.clips, [&](const BuiltClip& c) { return c.name == reference && c.skeleton == clip.skeleton; });
  if (reference != "first" && other == scene.clips.end()) return {};  // it leaves this skeleton at rest
  std::vector<SoaTransform> pose = first_frame(scene, reference == "first" ? clip : *other);
  const std::vector<SoaTransform>& rest = scene.skeletons[clip.skeleton].rest;
  if (std::memcmp(pose.data(), rest.data(), pose.size() * sizeof(SoaTransform)) == 0) pose.clear();
  return pose;
}

}  // namespace

std::vector<AdditiveReference> additive_references(const BuiltScene& scene, const std::vector<AdditiveRule>& rules,
                                                   std::vector<RawWarning>& warnings) {
  std::vector<AdditiveReference> out(scene.clips.size());
  for (const AdditiveRule& rule : rules) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < scene.clips.size(); ++i) {
      if (rule.clips != scene.clips[i].name && !tools::fits(rule.clips, scene.clips[i].name)) continue;
      out[i] = {rule.reference, reference_pose(scene, scene.clips[i], rule)};
      ++found;
    }
    if (found == 0 && rule.origin.must_fit) no_such_clip(rule.clips, rule.origin);
    if (found == 0)
      warnings.push_back({"/animations", "rule-fits-nothing", "additive: no clip is called \"" + rule.clips + "\""});
  }
  return out;
}

}  // namespace marrow::cook
