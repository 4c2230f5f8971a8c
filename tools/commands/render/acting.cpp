#include "commands/render/acting.h"

#include <algorithm>
#include <cmath>

#include "common/failure.h"

namespace marrow::tools {
namespace {

constexpr double kStepsPerSecond = 60;
constexpr float kAfterScript_s = 2;

}  // namespace

Acting::Acting(const std::string& path, const File& file, const ActingArguments& arguments)
    : behaviour_(path, file, arguments.behaviour), feet_(file) {
  const FoundGraph& found = behaviour_.found();
  if (!arguments.script.empty()) lines_ = read_script(arguments.script, found.file, found.graph);
  const float last_s = lines_.empty() ? 0 : static_cast<float>(lines_.back().time_s);
  duration_s_ = arguments.seconds.value_or(last_s + kAfterScript_s);
}

std::vector<Acting::Met> Acting::play_to(double time_s, const OnStep& on_step) {
  std::vector<Met> met;
  if (now_s_ < 0 || time_s < now_s_) {
    behaviour_.restart();
    prints_.clear();
    next_line_ = 0;
    now_s_ = 0;
    set_what_is_due();
    step(0, on_step, met);
  }
  while (now_s_ < time_s) {
    set_what_is_due();
    double next_s = std::min((std::floor(now_s_ * kStepsPerSecond + 1e-6) + 1) / kStepsPerSecond, time_s);
    if (next_line_ < lines_.size()) next_s = std::min(next_s, lines_[next_line_].time_s);
    const auto dt_s = static_cast<float>(next_s - now_s_);
    now_s_ = next_s;
    step(dt_s, on_step, met);
  }
  return met;
}

void Acting::set_what_is_due() {
  for (; next_line_ < lines_.size() && lines_[next_line_].time_s <= now_s_; ++next_line_)
    behaviour_.set(lines_[next_line_].parameter, lines_[next_line_].value);
}

void Acting::step(float dt_s, const OnStep& on_step, std::vector<Met>& met) {
  for (const AnimatorEvent& e : behaviour_.update(dt_s).events)
    for (std::uint32_t i = 0; i < e.count; ++i) met.push_back({now_s_, e.name, e.animation->name, e.time_s, e.number});
  if (on_step) on_step(dt_s);
}

void Acting::leave_prints(const Character& character) {
  for (const GroundPrint& print : feet_.prints(behaviour_.last_step(), character)) prints_.push_back({print, now_s_});
}

std::optional<float> Acting::ground_height() const {
  std::vector<float> heights;
  for (const Print& p : prints_) heights.push_back(p.print.at.y);
  if (heights.empty()) return std::nullopt;
  std::ranges::sort(heights);
  return heights[heights.size() / 2];
}

}  // namespace marrow::tools
