// MOTN: what a game asks of a clip beside its poses, as clip_motion.h has it.
#pragma once

#include "asset/sections/fields.h"
#include "asset/sections/kind.h"
#include "marrow/clip_motion.h"

namespace marrow::format {

struct MotionHeader {
  std::uint32_t clip;
  float speed_m_s;
  float heading[3];
  std::uint32_t root_count;
  std::uint32_t event_count;
  std::uint32_t mark_count;
};
static_assert(sizeof(MotionHeader) == 32);

struct MotionLayout {
  Array<RootKey> root;
  Array<ClipEvent> events;
  Array<float> marks;
  std::uint64_t bytes;
};
template <>
struct LayoutOf<MotionHeader> {
  using Type = MotionLayout;
};

// find_fault() has the rules of numbers.
template <class V>
constexpr void fields(V& v, const RootKey& k) {
  v.any({"time_s", "0 … the clip's duration, ascending strictly"}, k.time_s);
  v.any({"rotation", "unit quaternion x, y, z, w; the first key is the identity"}, k.rotation);
  v.any({"translation", "metres; each within ±10¹²"}, k.translation);
}

template <class V>
constexpr void fields(V& v, const ClipEvent& e) {
  v.any({"time_s", "0 … the clip's duration, ascending"}, e.time_s);
  v.any({"until_s", "time_s … time_s and the clip's duration"}, e.until_s);
  v.name({"name", "offset into NAME"}, e.name);
  v.any({"number", "finite"}, e.number);
}

template <class V>
constexpr void fields(V& v, const MotionHeader& h, MotionLayout& l) {
  v.section({"clip", "which CLIP section"}, h.clip, kClips, "no such clip");
  v.any({"speed_m_s", "0 … 10¹²"}, h.speed_m_s);
  v.any({"heading", "of length 1, or 0"}, h.heading);
  v.any({"root_count"}, h.root_count);
  v.any({"event_count"}, h.event_count);
  v.any({"mark_count", "≤ 64"}, h.mark_count);
  v.records({"root", "see below", "root_count"}, l.root, h.root_count, [&](const RootKey& k) { fields(v, k); });
  v.records({"events", "see below", "event_count"}, l.events, h.event_count, [&](const ClipEvent& e) { fields(v, e); });
  v.array({"marks", "0 … below the clip's duration; each later than the one before, once round the clip at most",
           "mark_count"},
          l.marks, h.mark_count);
}

}  // namespace marrow::format
