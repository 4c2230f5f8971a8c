#include "cook/clip/additive_references.h"

#include <algorithm>
#include <cmath>
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

// Scale is changed by a factor, and what has none cannot get one by it. As the runtime divides: see pose/additive.cpp.
void check_scales(const BuiltSkeleton& skeleton, const BuiltClip& clip, const std::vector<SoaTransform>& reference,
                  const AdditiveRule& rule) {
  const auto is_none = [](float scale) { return std::fabs(scale) <= 1e-20f; };
  for (const Track& track : clip.tracks) {
    if (track.path != TrackPath::scale) continue;
    const SoaTransform& four = (reference.empty() ? skeleton.rest : reference)[track.joint / 4];
    const std::uint32_t numbers = track.key_count * format::floats_per_key(track.path, track.interpolation);
    for (std::uint32_t i = 0; i < numbers; ++i) {
      if (!is_none(four.scale[i % 3][track.joint % 4]) || is_none(clip.values[track.first_value + i])) continue;
      throw tools::Failure(
          tools::Exit::usage, rule.origin.file, rule.origin.where,
          "clip \"" + clip.name + "\" scales joint \"" + skeleton.joint_names[track.joint] +
              "\", which has no scale in the reference \"" + rule.reference + "\"",
          "additive clips multiply scales, and nothing times 0 is more than 0; take another reference, "
          "such as \"rest\"");
    }
  }
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
      const BuiltSkeleton& skeleton = skeletons[clips[i].skeleton];
      out[i] = {rule.reference, reference_pose(skeleton, clips, clips[i], rule)};
      check_scales(skeleton, clips[i], out[i].pose, rule);
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
