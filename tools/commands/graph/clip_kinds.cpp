#include "commands/graph/clip_kinds.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

namespace marrow::tools {
namespace {

using Words = std::set<std::string>;

const Words kPose = {"tpose", "apose", "bind", "bindpose", "rest", "restpose", "reset", "ref", "reference"};
const Words kDeath = {"death", "die", "dies", "dying", "dead", "defeat", "defeated"};
const Words kAir = {"fall", "falling", "air", "airborne", "midair", "glide"};
const Words kLanding = {"land", "landing"};
const Words kJump = {"jump", "jumping", "leap", "hop"};
const Words kIdle = {"idle", "stand", "standing", "survey", "breathe", "breathing", "wait", "waiting", "still"};
const Words kSideways = {"strafe", "left", "right", "back", "backward", "backwards", "backpedal", "side"};
// From slow to fast.
const std::vector<Words> kGaits = {{"walk", "walking", "walkcycle", "move", "moving", "swim"},
                                   {"jog", "jogging", "trot"},
                                   {"run", "running", "canter"},
                                   {"sprint", "sprinting", "gallop", "dash"}};
const Words kAttack = {"attack", "punch", "slash", "chop",  "stab",  "slice", "strike", "shoot",
                       "throw",  "cast",  "fire",  "swing", "spell", "bite",  "claw"};
const Words kHit = {"hit", "hurt", "damage", "impact", "react", "recieve", "receive"};
const Words kArms = {"wave",     "waving", "clap",     "clapping", "salute",   "interact", "use",
                     "pickup",   "take",   "block",    "emote",    "yes",      "no",       "thumbs",
                     "thumbsup", "point",  "pointing", "cheer",    "cheering", "reload"};
const Words kWhole = {"kick",  "dodge", "roll", "rolling",  "backflip", "flip",
                      "dance", "bow",   "spin", "headbutt", "victory",  "taunt"};
const Words kTakeOff = {"start", "begin", "anticipation", "takeoff", "up"};
// Which of a kind it is, or for whom; no other manner.
const Words kPlain = {"loop",   "cycle", "anim",  "animation", "action",  "forward", "forwards", "fwd",
                      "normal", "base",  "basic", "start",     "begin",   "end",     "up",       "full",
                      "short",  "long",  "in",    "place",     "inplace", "the",     "a",        "b",
                      "c",      "d",     "alt",   "variant",   "look",    "looking", "around",   "bored",
                      "break",  "happy", "rm",    "rootmotion"};
const Words kStill = {"sit", "sitting", "lie", "lying", "sleep", "seated"};

bool has(const KnownClip& clip, const Words& words) {
  return std::ranges::any_of(clip.words, [&](const std::string& word) { return words.contains(word); });
}

// From 1 on; 0: none.
int gait_of(const KnownClip& clip) {
  for (std::size_t i = kGaits.size(); i-- > 0;)
    if (has(clip, kGaits[i])) return static_cast<int>(i) + 1;
  return 0;
}

bool is_number(const std::string& word) {
  return std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
}

ClipKind kind_of(const KnownClip& clip, const ClipMotion& motion, const float (&ahead)[3]) {
  if (has(clip, kPose) || (clip.words == std::vector<std::string>{"t"}) ||
      (std::ranges::find(clip.words, "pose") != clip.words.end() && clip.words.size() <= 2) || clip.duration_s <= 0)
    return ClipKind::pose;
  if (has(clip, kDeath)) return ClipKind::death;
  const bool jumps = has(clip, kJump);
  if (has(clip, kLanding) || (jumps && has(clip, {"end"}))) return ClipKind::landing;
  if (jumps && has(clip, kTakeOff)) return ClipKind::jump_start;
  if (has(clip, kAir) || (jumps && has(clip, {"loop", "idle", "hang"}))) return ClipKind::air;
  if (has(clip, kWhole)) return ClipKind::whole;
  if (has(clip, kAttack) || has(clip, kHit) || has(clip, kArms)) return ClipKind::arms;
  if (jumps) return ClipKind::jump_start;
  if (gait_of(clip) > 0) {
    const float along = motion.heading[0] * ahead[0] + motion.heading[1] * ahead[1] + motion.heading[2] * ahead[2];
    const bool is_ahead = clip.speed_m_s > 0 ? along > 0.7f : !has(clip, kSideways);
    return is_ahead ? ClipKind::gait : ClipKind::sideways;
  }
  return has(clip, kIdle) ? ClipKind::idle : ClipKind::other;
}

std::size_t odd_words(const KnownClip& clip) {
  std::size_t out = 0;
  for (const std::string& word : clip.words) {
    bool is_known =
        kPlain.contains(word) || is_number(word) || word.size() == 1 || (word == "melee" && has(clip, kAttack));
    for (const Words* const words :
         {&kDeath, &kAir, &kLanding, &kJump, &kIdle, &kAttack, &kHit, &kArms, &kWhole, &kTakeOff})
      is_known = is_known || words->contains(word);
    for (const Words& words : kGaits) is_known = is_known || words.contains(word);
    out += is_known ? 0 : 1;
  }
  std::size_t actions = 0;  // a blow out of a guard is two
  for (const Words* const words : {&kAttack, &kHit, &kArms, &kWhole})
    if (has(clip, *words)) ++actions;
  return out + (actions > 1 ? actions - 1 : 0) + (has(clip, kStill) ? 2 : 0);
}

// Words that every clip begins or ends with, as a rig's name.
void drop_common_words(std::vector<KnownClip>& clips) {
  const auto at = [](const KnownClip& c, bool at_end) { return at_end ? c.words.back() : c.words.front(); };
  const auto all_have = [&](bool at_end) {
    return clips.size() > 1 && std::ranges::all_of(clips, [&](const KnownClip& c) {
             return c.words.size() > 1 && at(c, at_end) == at(clips[0], at_end);
           });
  };
  for (const bool at_end : {false, true})
    while (all_have(at_end))
      for (KnownClip& clip : clips) clip.words.erase(at_end ? clip.words.end() - 1 : clip.words.begin());
}

// Of what is done once.
void note_action(KnownClip& clip) {
  const std::vector<const Words*> kinds = {&kAttack, &kHit, &kArms, &kWhole};
  for (std::size_t i = 0; i < kinds.size() && clip.action.empty(); ++i)
    for (const std::string& word : clip.words)
      if (kinds[i]->contains(word)) {
        clip.action = word;
        clip.rank = std::min(static_cast<int>(i), 2);
        if (word == "kick" || word == "headbutt") clip.rank = 0;
        break;
      }
}

// Where most of what goes by gaits' names heads for.
void find_ahead(Span<const Animation> animations, float (&out)[3]) {
  float sum[3] = {};
  for (const Animation& a : animations) {
    KnownClip clip;
    clip.words = words_of_clip(a.name);
    const bool goes = gait_of(clip) > 0 && !has(clip, kSideways);
    for (int axis = 0; axis < 3 && goes; ++axis) sum[axis] += a.motion.heading[axis];
  }
  const float length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  for (int axis = 0; axis < 3; ++axis) out[axis] = length > 0 ? sum[axis] / length : (axis == 2 ? 1.0f : 0.0f);
}

bool is_additive(const Animation& animation) {
  for (const std::uint32_t clip : animation.clip_of_skeleton)
    if (clip != kNoClip && animation.clips.clip(clip).additive) return true;
  return false;
}

}  // namespace

std::vector<std::string> words_of_clip(const std::string& name) {
  const std::size_t bar = name.find_last_of("|/:");
  const std::string own = bar == std::string::npos || bar + 1 == name.size() ? name : name.substr(bar + 1);
  std::vector<std::string> out;
  const auto is = [](char c, int (*test)(int)) { return test(static_cast<unsigned char>(c)) != 0; };
  char before = ' ';
  for (std::size_t i = 0; i < own.size(); ++i) {
    const char c = own[i];
    const bool is_inside = is(c, std::isalnum) || (static_cast<unsigned char>(c) & 0x80) != 0;
    const bool was_inside = is(before, std::isalnum) || (static_cast<unsigned char>(before) & 0x80) != 0;
    const bool next_is_small = i + 1 < own.size() && is(own[i + 1], std::islower);
    const bool begins = is_inside && (!was_inside || is(c, std::isdigit) != is(before, std::isdigit) ||
                                      (is(c, std::isupper) && (is(before, std::islower) || next_is_small)));
    if (begins) out.emplace_back();
    if (is_inside) out.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    before = c;
  }
  return out;
}

std::vector<KnownClip> know_clips(Span<const Animation> animations) {
  std::vector<KnownClip> out;
  std::vector<const Animation*> of;
  std::set<std::string> known;
  for (const Animation& a : animations) {
    if (*a.name == '\0' || !known.insert(a.name).second) continue;
    of.push_back(&a);
    out.push_back({a.name, words_of_clip(a.name), ClipKind::other, a.duration_s, a.motion.speed_m_s,
                   a.motion.phase_marks.size, 0, 0, ""});
  }
  drop_common_words(out);
  float ahead[3];
  find_ahead(animations, ahead);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i].kind = is_additive(*of[i]) ? ClipKind::added : kind_of(out[i], of[i]->motion, ahead);
    out[i].odd = odd_words(out[i]);
    if (out[i].kind == ClipKind::gait) out[i].rank = gait_of(out[i]);
    if (out[i].kind == ClipKind::arms || out[i].kind == ClipKind::whole) note_action(out[i]);
  }
  return out;
}

}  // namespace marrow::tools
