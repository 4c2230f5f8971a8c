#include "commands/info/clip_motions.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "text/quantity.h"

namespace marrow::tools {
namespace {

using nlohmann::ordered_json;

constexpr double kDegree = 3.14159265358979323846 / 180;

// Where the root is at the end, from where it was at the start.
ordered_json describe_root(const ClipMotion& motion) {
  if (motion.root.empty()) return nullptr;
  const RootKey& end = motion.root[motion.root.size - 1];
  const auto turn = 2 * std::atan2(static_cast<double>(end.rotation[1]), static_cast<double>(end.rotation[3]));
  return {{"keys", motion.root.size},
          {"end_m", {end.translation[0], end.translation[1], end.translation[2]}},
          {"end_turn_deg", std::remainder(turn / kDegree, 360.0)}};
}

// To a millimetre, and 0 without a sign.
std::string place(const ordered_json& at) {
  const auto number = [&](std::size_t axis) { return std::round(at[axis].get<double>() * 1000) / 1000 + 0.0; };
  return fmt::format("{:.3f} {:.3f} {:.3f}", number(0), number(1), number(2));
}

std::string seconds(const ordered_json& time) {
  return fmt::format("{:.3f}", time.get<double>());
}

void print_events(const ordered_json& events) {
  std::size_t width = 0;
  for (const ordered_json& e : events) width = std::max(width, e["name"].get<std::string>().size());
  for (const ordered_json& e : events) {
    const bool is_moment = e["from_s"] == e["until_s"];
    const std::string number = e["number"] == 0.0 ? "" : ", " + plain_number(e["number"].get<double>());
    fmt::print("  {:<{}}  {}{} s{}\n", e["name"].get<std::string>(), width, seconds(e["from_s"]),
               is_moment ? "" : " … " + seconds(e["until_s"]), number);
  }
}

void print_motion(const ordered_json& clip) {
  const ordered_json& motion = clip["motion"];
  fmt::print("clip \"{}\": {} s{}\n", clip["name"].get<std::string>(), seconds(clip["duration_s"]),
             summary_of_motion(motion));
  if (!motion["heading"].is_null()) fmt::print("  heads for {}\n", place(motion["heading"]));
  if (!motion["root"].is_null())
    fmt::print("  root: {} keys, ends at {} m, turned by {:.1f}°\n", motion["root"]["keys"].get<std::size_t>(),
               place(motion["root"]["end_m"]), motion["root"]["end_turn_deg"].get<double>());
  if (!motion["phase_marks"].empty()) {
    std::vector<std::string> marks;
    for (const ordered_json& mark : motion["phase_marks"]) marks.push_back(seconds(mark));
    fmt::print("  phase marks: {} s\n", fmt::join(marks, ", "));
  }
  print_events(motion["events"]);
}

}  // namespace

ordered_json describe_motion(const File& file, const ClipMotion& motion) {
  ordered_json events = ordered_json::array(), marks = ordered_json::array(), speed, heading;
  for (const ClipEvent& e : motion.events)
    events.push_back({{"name", file.text(e.name)}, {"from_s", e.time_s}, {"until_s", e.until_s}, {"number", e.number}});
  for (const float mark : motion.phase_marks) marks.push_back(mark);
  if (motion.speed_m_s > 0) {
    speed = motion.speed_m_s;
    heading = {motion.heading[0], motion.heading[1], motion.heading[2]};
  }
  return {{"speed_m_s", speed},
          {"heading", heading},
          {"events", events},
          {"phase_marks", marks},
          {"root", describe_root(motion)}};
}

std::string summary_of_motion(const ordered_json& motion) {
  std::string out;
  if (!motion["speed_m_s"].is_null()) out = fmt::format(", moves at {:.3g} m/s", motion["speed_m_s"].get<double>());
  const std::size_t count = motion["events"].size();
  if (count > 0) out += fmt::format(", {} event{}", count, count == 1 ? "" : "s");
  return out;
}

void print_motions(const ordered_json& description) {
  for (const ordered_json& clip : description["clips"]) print_motion(clip);
}

}  // namespace marrow::tools
