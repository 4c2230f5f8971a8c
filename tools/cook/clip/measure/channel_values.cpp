#include "cook/clip/measure/channel_values.h"

#include <algorithm>

#include "common/check_status.h"
#include "cook/scene/views.h"
#include "marrow/sample.h"

namespace marrow::cook {

ChannelValues::ChannelValues(const BuiltClip& clip)
    : names_(clip.channel_names), clip_(view(clip, Skeleton{})), values_(clip.channel_names.size()) {}

void ChannelValues::go_to(float time_s) {
  if (!values_.empty()) tools::check(sample_channels(clip_, time_s, values_));
}

int ChannelValues::find(const std::string& name) const {
  const auto found = std::ranges::find(names_, name);
  return found == names_.end() ? kNone : static_cast<int>(found - names_.begin());
}

}  // namespace marrow::cook
