// Events and moments as options and files write them.
#pragma once

#include <string>
#include <string_view>

namespace marrow::tools {

// Seconds in a clip, or a share of it.
struct ClipMoment {
  double value = 0;
  bool is_share = false;
};

// See ClipEvent.
struct EventText {
  std::string name;
  ClipMoment from, until;
  double number = 0;
};

// "0.35", "0.35s" or "50%" of the clip. False for anything else, and below 0 or beyond 100%.
bool read_moment(std::string_view text, ClipMoment& out);

// "hit@0.35", "swing@0.2..0.5", "hit@50%:2" with a number. False for anything else.
bool read_event(std::string_view text, EventText& out);

}  // namespace marrow::tools
