// The panel of `marrow view`, at the window's left; by Dear ImGui.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "commands/view/view_actor.h"

namespace marrow::tools {

// Of Dear ImGui's context, before its fonts are used.
void set_panel_style(float scale);

// Points.
float panel_width(float scale);

// How long the last frames took.
class FrameTimes {
 public:
  static constexpr int kFrames = 120;

  void add(float milliseconds) {
    times_[static_cast<std::size_t>(next_)] = milliseconds;
    next_ = (next_ + 1) % kFrames;
    count_ = std::min(count_ + 1, kFrames);
  }
  // As a ring that begins at first().
  const std::array<float, kFrames>& ring() const { return times_; }
  int first() const { return count_ < kFrames ? 0 : next_; }
  int count() const { return count_; }
  // 0 before the first.
  float median() const {
    if (count_ == 0) return 0;
    std::vector<float> sorted(times_.begin(), times_.begin() + count_);
    std::nth_element(sorted.begin(), sorted.begin() + count_ / 2, sorted.end());
    return sorted[static_cast<std::size_t>(count_ / 2)];
  }
  float largest() const { return *std::max_element(times_.begin(), times_.end()); }

 private:
  std::array<float, kFrames> times_ = {};
  int next_ = 0, count_ = 0;
};

struct PanelState {
  const FrameTimes& times;
  float scale;
};

// Widgets for all settings; it scrolls where the window is low.
void show_panel(const PanelState& state, ViewActor& actor, ViewSettings& settings);

// Over the picture, which begins at `left`: what is being opened, and why the last file could not be.
void show_notes(const std::string& busy_with, const std::string& error, float left, float scale);

}  // namespace marrow::tools
