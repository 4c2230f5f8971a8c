#include "cook/options/option_lists.h"
#include "marrow/clip_motion.h"

namespace marrow::cook {
namespace {

constexpr Named<RootMotion> kRoots[] = {
    {"none", RootMotion::none}, {"ground", RootMotion::ground}, {"full", RootMotion::full}};

// The clip's name in "CLIP=TEXT", divided at the first "="; `text` gets the rest.
std::string clip_of(const Value& given, const char* example, std::string& text) {
  const std::size_t divide = given.text.find('=');
  if (divide == std::string::npos || divide == 0)
    refuse(given, "\"" + given.text + "\" names no clip", std::string("as in ") + example);
  text = given.text.substr(divide + 1);
  return given.text.substr(0, divide);
}

void set_root(CookOptions& options, const Value& given) {
  RootRule rule;
  std::string how;
  rule.clips = clip_of(given, "walk=ground", how);
  const std::optional<RootMotion> root = value_of(kRoots, how);
  if (!root) refuse(given, "there is no root motion \"" + how + "\"", "give ground, full or none");
  rule.root = *root;
  rule.origin = given.origin;
  options.motion.roots.push_back(rule);
}

void set_event(CookOptions& options, const Value& given) {
  constexpr const char* kExample = "attack=hit@0.35, attack=swing@0.2..0.5 or attack=hit@50%:2";
  EventRule rule;
  std::string text;
  rule.clips = clip_of(given, kExample, text);
  if (!read_event(text, rule.event)) refuse(given, "\"" + text + "\" is no event", std::string("as in ") + kExample);
  rule.origin = given.origin;
  options.motion.events.push_back(rule);
}

void set_phase(CookOptions& options, const Value& given) {
  PhaseRule rule;
  std::string text;
  rule.clips = clip_of(given, "walk=0,0.5", text);
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    tools::ClipMoment& mark = rule.marks.emplace_back();
    if (!read_moment(text.substr(0, comma), mark) || comma + 1 == text.size())
      refuse(given, "\"" + text + "\" is no list of times", "as in walk=0,0.5 or walk=0%,50%");
    text = comma == std::string::npos ? "" : text.substr(comma + 1);
  }
  if (rule.marks.size() > kMaxMarks) refuse(given, "more than 64 phase marks", "leave some out");
  rule.origin = given.origin;
  options.motion.phases.push_back(rule);
}

void add_graph(CookOptions& options, const Value& given) {
  if (given.text.empty()) refuse(given, "no file", "as in hero.anim.toml");
  options.graphs.push_back({given.text, {}, given.origin});
}

constexpr Option kMotionOptions[] = {
    {"root",
     OptionKind::list,
     "CLIP=HOW",
     "take the motion of a clip's root out of its poses, for root_step(): ground, over the ground and with its "
     "heading; "
     "full, up and down too; none (the default); CLIP may have * and ?; repeatable, the last that fits counts",
     {},
     set_root},
    {"event",
     OptionKind::list,
     "CLIP=NAME@TIME",
     "an event of a clip, beside feet that come down: hit@0.35 in seconds, hit@50% of the clip, swing@0.2..0.5 from "
     "and "
     "until, hit@0.35:2 with a number; CLIP may have * and ?; repeatable",
     {},
     set_event},
    {"phase",
     OptionKind::list,
     "CLIP=TIMES",
     "where the steps of a clip begin, as 0,0.5 or 0%,50%, in place of where its feet come down; CLIP may have * and "
     "?; "
     "repeatable, the last that fits counts",
     {},
     set_phase},
    {"graph",
     OptionKind::list,
     "FILE",
     "a graph of behaviour, as hero.anim.toml, for update_animator() and pose_character(); repeatable",
     {},
     add_graph},
};

}  // namespace

std::span<const Option> motion_options() {
  return kMotionOptions;
}

}  // namespace marrow::cook
