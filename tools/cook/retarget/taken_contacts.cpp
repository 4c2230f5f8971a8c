#include "cook/retarget/taken_contacts.h"

#include <algorithm>

#include "cook/clip/build_tracks.h"
#include "cook/motion/find_contacts.h"
#include "cook/motion/foot_points.h"
#include "cook/motion/trace_clip.h"

namespace marrow::cook {

std::vector<FootSpans> taken_contacts(const BuiltSkeleton& rig, const RawClip& clip) {
  int last = kNone;
  for (const int node : rig.node_of_joint) last = std::max(last, node);
  for (const RawChannel& channel : clip.channels) last = std::max(last, channel.node);
  std::vector<int> joint_of_node(to_index(last + 1), kNone);
  for (std::size_t j = 0; j < rig.node_of_joint.size(); ++j)
    joint_of_node[to_index(rig.node_of_joint[j])] = static_cast<int>(j);
  const ClipTrace trace = trace_clip(build_tracks(clip, joint_of_node), rig, find_foot_points(rig, {}));
  if (!(trace.frame_s > 0)) return {};
  const Contacts contacts = find_contacts(trace);
  std::vector<FootSpans> out;
  for (std::size_t foot = 0; foot < trace.feet.size(); ++foot) {
    FootSpans& of = out.emplace_back();
    of.foot = trace.feet[foot].role;
    for (const Contact& span : contacts.spans) {
      if (span.foot != foot) continue;
      const double from = static_cast<double>(span.from) * trace.frame_s;
      const double to = static_cast<double>(span.to) * trace.frame_s;
      of.spans_s.emplace_back(from, std::min(to, trace.duration_s()));
      if (to > trace.duration_s()) of.spans_s.emplace_back(0, to - trace.duration_s());
    }
    std::ranges::sort(of.spans_s);
  }
  return out;
}

}  // namespace marrow::cook
