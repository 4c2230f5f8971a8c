// A clip's channels by name, at any time.
#pragma once

#include <string>
#include <vector>

#include "cook/scene/built.h"
#include "marrow/file.h"

namespace marrow::cook {

// clip: outlives this.
class ChannelValues {
 public:
  explicit ChannelValues(const BuiltClip& clip);
  void go_to(float time_s);
  // kNone: no channel is called so.
  int find(const std::string& name) const;
  double value(int channel, double rest) const {
    return channel == kNone ? rest : static_cast<double>(values_[to_index(channel)]);
  }

 private:
  const std::vector<std::string>& names_;
  Clip clip_;
  std::vector<float> values_;
};

}  // namespace marrow::cook
