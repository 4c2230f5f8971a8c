#include "commands/graph/starter.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "behave/behaviour.h"
#include "behave/find_graph.h"
#include "commands/graph/clip_kinds.h"
#include "common/failure.h"
#include "marrow/roles.h"
#include "text/printable.h"

namespace marrow::tools {
namespace {

constexpr std::size_t kMostGaits = 4, kMostIdles = 4, kMostShots = 6, kMostAttacks = 3;
constexpr float kLeastRatio = 1.15f;  // of the speeds of two gaits
constexpr std::size_t kLineLength = 100;

// A TOML string.
std::string toml_string(const std::string& name) {
  std::string out = "\"";
  for (const char c : name) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      out += std::string("\\") + c;
    else if (code < 0x20 || code == 0x7F)
      out += fmt::format("\\u{:04X}", code);
    else
      out += c;
  }
  return out + '"';
}

// How gaits go together: as fast as is asked for and in step, in step, or each for itself.
enum class Together { at_speed, in_step, blended };

class StarterText {
 public:
  StarterText(const std::string& path, const File& hero, std::vector<KnownClip> clips, Together together)
      : path_(path), hero_(hero), clips_(std::move(clips)), together_(together) {
    for (const KnownClip& clip : clips_) nodes_.insert(clip.name);
    choose();
  }

  std::string text() {
    std::string nodes = write_rest() + write_move() + write_body() + write_shots();
    return head() + "output = " + toml_string(output_) + "\n" + parameters() + nodes + unused();
  }

 private:
  std::vector<const KnownClip*> of(ClipKind kind) const {
    std::vector<const KnownClip*> out;
    for (const KnownClip& clip : clips_)
      if (clip.kind == kind) out.push_back(&clip);
    std::ranges::stable_sort(out, {}, [](const KnownClip* c) { return std::pair(c->odd, c->words.size()); });
    return out;
  }
  void use(const KnownClip* clip) { used_.insert(clip->name); }

  void choose() {
    for (const KnownClip* const clip : of(ClipKind::idle))
      if (idles_.empty() || (clip->odd == idles_[0]->odd && idles_.size() < kMostIdles)) idles_.push_back(clip);
    std::vector<const KnownClip*> gaits = of(ClipKind::gait);
    // Those with a speed, of which the plainest comes first; a slower one and a faster one each.
    if (std::ranges::any_of(gaits, [](const auto* c) { return c->speed_m_s > 0; }))
      std::erase_if(gaits, [](const auto* c) { return !(c->speed_m_s > 0); });
    for (const KnownClip* const clip : gaits) {
      const bool is_like_another = std::ranges::any_of(gaits_, [&](const KnownClip* other) {
        const float slow = std::min(clip->speed_m_s, other->speed_m_s),
                    fast = std::max(clip->speed_m_s, other->speed_m_s);
        return clip->rank == other->rank || (fast > 0 && fast < kLeastRatio * slow);
      });
      if (!is_like_another && gaits_.size() < kMostGaits && clip->odd <= gaits.front()->odd) gaits_.push_back(clip);
    }
    std::ranges::stable_sort(gaits_, {}, [](const KnownClip* c) { return std::pair(c->speed_m_s, c->rank); });
    if (idles_.empty() && gaits_.empty()) choose_any();
    for (const auto* const list : {&idles_, &gaits_})
      for (const KnownClip* const clip : *list) use(clip);
    jump_ = first(ClipKind::jump_start);
    air_ = first(ClipKind::air);
    landing_ = first(ClipKind::landing);
    death_ = first(ClipKind::death);
  }
  // Something to stand with.
  void choose_any() {
    for (const ClipKind kind : {ClipKind::other, ClipKind::sideways, ClipKind::whole, ClipKind::arms, ClipKind::air,
                                ClipKind::jump_start, ClipKind::landing, ClipKind::death, ClipKind::pose})
      if (const std::vector<const KnownClip*> some = of(kind); !some.empty() && idles_.empty()) {
        idles_.push_back(some[0]);
        clips_[static_cast<std::size_t>(some[0] - clips_.data())].kind = ClipKind::idle;
      }
  }
  const KnownClip* first(ClipKind kind) {
    const std::vector<const KnownClip*> all = of(kind);
    if (all.empty()) return nullptr;
    use(all[0]);
    return all[0];
  }

  // A node's name, which no clip has, and a parameter's.
  static std::string fresh(const std::string& wanted, std::set<std::string>& taken) {
    std::string out = wanted;
    for (int i = 2; taken.contains(out); ++i) out = wanted + "_" + std::to_string(i);
    taken.insert(out);
    return out;
  }
  std::string node(const std::string& wanted) { return fresh(wanted, nodes_); }
  std::string parameter(const std::string& wanted) { return fresh(wanted, names_); }
  static std::string key_of(const KnownClip& clip) {
    std::string out;
    for (const std::string& word : clip.words) {
      if (out.empty() && (word.size() == 1 || (word[0] >= '0' && word[0] <= '9'))) continue;
      std::string plain;
      for (const char c : word)
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) plain += c;
      if (!plain.empty()) out += (out.empty() ? "" : "_") + plain;
    }
    return out.empty() ? "play" : out;
  }
  static std::string section(const std::string& name, const std::string& comment, const std::string& type) {
    return "\n# " + comment + "\n[node." + name + "]\ntype = \"" + type + "\"\n";
  }

  std::string head() const {
    const std::string file = printable(std::filesystem::path(path_).filename().string());
    return "# A graph for " + file +
           " to begin with, by what its clips are called and do.\n"
           "# Into its file: marrow cook MODEL --graph THIS.anim.toml --root '*=ground' -o HERO.mrw\n"
           "# To look at:    marrow render " +
           file + " --graph THIS.anim.toml --script IN.txt --movie -o film.png\n\n";
  }

  std::string parameters() const { return parameters_.empty() ? "" : "\n[parameters]\n" + parameters_; }
  void add_parameter(const std::string& name, const std::string& what, const std::string& comment) {
    parameters_ += name + " = { " + what + " }  # " + comment + "\n";
  }

  // Several ways to stand.
  std::string write_rest() {
    if (!idles_.empty()) output_ = idles_[0]->name;
    if (idles_.size() < 2) return "";
    output_ = node("rest");
    std::string names;
    for (const KnownClip* const clip : idles_) names += (names.empty() ? "" : ", ") + toml_string(clip->name);
    return section(output_, "Stands about, now one way, now another.", "pick") + "poses = [ " + names + " ]\n";
  }

  std::string write_move() {
    if (gaits_.empty()) return "";
    const bool knows_speeds = gaits_[0]->speed_m_s > 0;
    const float fastest = knows_speeds ? gaits_.back()->speed_m_s : static_cast<float>(gaits_.size());
    speed_ = parameter("speed");
    add_parameter(speed_,
                  fmt::format("type = \"number\", range = [0, {:.3g}], half_life = 0.1", std::ceil(12 * fastest) / 10),
                  knows_speeds ? "metres a second" : "1 is the first gait, 2 the next: no speed is known");
    const bool stands_in_it = idles_.size() == 1;
    const std::string move = node("move");
    std::string out = section(move,
                              together_ == Together::at_speed && knows_speeds
                                  ? "Goes exactly as fast as `speed` says, its feet in step."
                              : together_ != Together::blended ? "Goes by `speed`, its feet in step."
                                                               : "Goes by `speed`.",
                              "space") +
                      "by = " + toml_string(speed_) + "\npoints = [\n";
    if (stands_in_it) out += "  { at = 0, pose = " + toml_string(idles_[0]->name) + " },\n";
    for (std::size_t i = 0; i < gaits_.size(); ++i)
      out += knows_speeds
                 ? fmt::format("  {{ pose = {} }},  # {:.3g} m/s\n", toml_string(gaits_[i]->name), gaits_[i]->speed_m_s)
                 : fmt::format("  {{ at = {}, pose = {} }},\n", i + 1, toml_string(gaits_[i]->name));
    out += "]\n";
    if (together_ == Together::at_speed && knows_speeds) out += "match_speed = true\n";
    if (together_ != Together::blended) out += "sync = true\n";
    if (!stands_in_it && !idles_.empty())
      return out + write_ground(move, knows_speeds ? 0.25f * gaits_[0]->speed_m_s : 0.5f);
    output_ = move;
    return out;
  }
  // Stands in one state, goes in another.
  std::string write_ground(const std::string& move, float slowest) {
    const std::string rest = output_;
    output_ = node("ground");
    return section(output_, "Stands, or goes.", "machine") +
           fmt::format(
               "start = \"still\"\nstate.still = {{ pose = {} }}\nstate.goes = {{ pose = {} }}\ntransition = [\n"
               "  {{ from = \"still\", to = \"goes\", when = \"{} > {:.2g}\", fade = 0.2 }},\n"
               "  {{ from = \"goes\", to = \"still\", when = \"{} <= {:.2g}\", fade = 0.3 }},\n]\n",
               toml_string(rest), toml_string(move), speed_, slowest, speed_, slowest);
  }

  std::string write_body() {
    if (jump_ == nullptr && air_ == nullptr && death_ == nullptr) {
      if (landing_ != nullptr) used_.erase(landing_->name);
      return "";
    }
    const std::string base = output_;
    output_ = node("body");
    std::string states = fmt::format("start = \"ground\"\nstate.ground = {{ pose = {} }}\n", toml_string(base)),
                transitions, before;
    if (death_ != nullptr) {
      const std::string dying = node("dying"), dead = parameter("dead");
      before = section(dying, "Falls, and stays where it is.", "clip") + "clip = " + toml_string(death_->name) +
               "\nplay = \"once\"\n";
      states += fmt::format("state.dead = {{ pose = {} }}\n", toml_string(dying));
      transitions += fmt::format("  {{ from = \"*\", to = \"dead\", when = \"{}\", fade = 0.15 }},\n", dead);
      transitions += fmt::format("  {{ from = \"dead\", to = \"ground\", when = \"not {}\", fade = 0.3 }},\n", dead);
      add_parameter(dead, "type = \"flag\"", "while it is, it lies");
    }
    if (jump_ != nullptr || air_ != nullptr) add_jump(states, transitions);
    const std::string comment = jump_ == nullptr && air_ == nullptr ? "Lives and dies."
                                : death_ == nullptr                 ? "On the ground, or in the air."
                                                                    : "On the ground, in the air, or dead.";
    return before + section(output_, comment, "machine") + states + "transition = [\n" + transitions + "]\n";
  }
  void add_jump(std::string& states, std::string& transitions) {
    const auto state = [&](const char* name, const KnownClip* clip) {
      if (clip != nullptr) states += fmt::format("state.{} = {{ pose = {} }}\n", name, toml_string(clip->name));
    };
    const auto go = [&](const std::string& how) { transitions += "  { " + how + " },\n"; };
    state("jump", jump_);
    state("air", air_);
    if (air_ == nullptr && landing_ != nullptr) used_.erase(landing_->name);
    if (air_ != nullptr) state("land", landing_);
    const std::string jump = parameter("jump");
    add_parameter(jump, "type = \"trigger\", hold = 0.15", "waits 0.15 s for its moment");
    go(fmt::format(R"(from = "ground", to = "{}", when = "{}", fade = 0.1, kind = "inertial")",
                   jump_ != nullptr ? "jump" : "air", jump));
    if (air_ == nullptr) return go(R"(from = "jump", to = "ground", at_end = 0.15, fade = 0.15)");
    const std::string grounded = parameter("grounded");
    add_parameter(grounded, "type = \"flag\", initial = true", "set it while the character stands on something");
    go(fmt::format(R"(from = "ground", to = "air", when = "not {}", after = 0.1, fade = 0.2)", grounded));
    if (jump_ != nullptr) go(R"(from = "jump", to = "air", at_end = 0.1, fade = 0.1)");
    go(fmt::format(R"(from = "air", to = "{}", when = "{}", after = 0.1, fade = 0.1, kind = "inertial")",
                   landing_ != nullptr ? "land" : "ground", grounded));
    if (landing_ != nullptr) go(R"(from = "land", to = "ground", at_end = 0.15, fade = 0.15)");
  }

  // What a rig has to mask the upper body by.
  std::string upper_body() const {
    for (const Role role : {Role::spine, Role::chest, Role::upper_chest})
      for (std::uint32_t s = 0; s < hero_.skeleton_count(); ++s)
        if (joint_of(hero_.roles(s), role) != kNoJoint)
          return fmt::format("mask = {{ role = \"{}\", falloff = {} }}\n", role_name(role),
                             role == Role::spine ? 2 : 1);
    return "";
  }

  std::string write_shots() {
    std::vector<const KnownClip*> shots = of(ClipKind::arms);
    const std::vector<const KnownClip*> whole = of(ClipKind::whole);
    shots.insert(shots.end(), whole.begin(), whole.end());
    std::ranges::stable_sort(shots, {}, [](const KnownClip* c) { return std::pair(c->rank, c->odd); });
    std::string out;
    std::set<std::string> actions;  // one of each before a second of any
    std::size_t count = 0, attacks = 0;
    for (const bool is_second : {false, true})
      for (const KnownClip* const clip : shots) {
        if (count >= kMostShots || used_.contains(clip->name)) continue;
        if (!is_second && (clip->rank == 0 && attacks >= kMostAttacks)) continue;
        if (!is_second && !actions.insert(clip->action).second) continue;
        attacks += clip->rank == 0 ? 1 : 0;
        out += write_shot(*clip);
        ++count;
      }
    return out;
  }
  std::string write_shot(const KnownClip& clip) {
    use(&clip);
    const std::string base = output_, trigger = parameter(key_of(clip));
    output_ = node("with_" + key_of(clip));
    add_parameter(trigger, "type = \"trigger\"", "plays " + printable(clip.name) + " once");
    const bool is_whole = clip.kind == ClipKind::whole;
    const std::string mask = is_whole ? "" : upper_body();
    return section(output_, "`" + trigger + "`: once, with " + (mask.empty() ? "all of the body." : "the upper body."),
                   "one_shot") +
           fmt::format("base = {}\npose = {}\nwhen = {}\n", toml_string(base), toml_string(clip.name),
                       toml_string(trigger)) +
           mask;
  }

  // What is left, for the author.
  std::string unused() const {
    std::string out, line;
    for (const KnownClip& clip : clips_) {
      if (used_.contains(clip.name)) continue;
      const std::string item =
          printable(clip.name) + (clip.speed_m_s > 0 ? fmt::format(" ({:.3g} m/s)", clip.speed_m_s) : "");
      if (!line.empty() && line.size() + item.size() > kLineLength) {
        out += line + ",\n";
        line.clear();
      }
      line += line.empty() ? "#   " + item : ", " + item;
    }
    return line.empty() ? "" : "\n# Clips that are not in it yet:\n" + out + line + "\n";
  }

  const std::string& path_;
  const File& hero_;
  std::vector<KnownClip> clips_;
  Together together_;
  std::vector<const KnownClip*> idles_, gaits_;
  const KnownClip *jump_ = nullptr, *air_ = nullptr, *landing_ = nullptr, *death_ = nullptr;
  std::set<std::string> used_, nodes_, names_;
  std::string output_, parameters_, speed_;
};

// All clips: the hero's, then the packs'.
std::vector<KnownClip> clips_of(const File& hero, const std::vector<std::string>& packs,
                                std::vector<LoadedFile>& loaded, std::vector<AlignedBytes>& memory) {
  std::vector<Animation> all;
  const auto add = [&](const File& clips) {
    Animations made;
    memory.emplace_back(animations_bytes(hero, clips));
    if (make_animations(hero, clips, memory.back(), made) != Status::ok) return;
    all.insert(all.end(), made.all.begin(), made.all.end());
  };
  add(hero);
  loaded.reserve(packs.size());
  for (const std::string& pack : packs) {
    loaded.push_back(load_mrw(pack));
    add(loaded.back().file);
  }
  return know_clips({all.data(), all.size()});
}

}  // namespace

std::string starter_graph(const std::string& path, const File& hero, const std::vector<std::string>& packs) {
  std::vector<LoadedFile> loaded;
  std::vector<AlignedBytes> memory;
  const std::vector<KnownClip> clips = clips_of(hero, packs, loaded, memory);
  if (clips.empty())
    throw Failure(Exit::invalid, path, "", "no clip with a name", "a graph names clips: name a file that has some");
  for (const Together together : {Together::at_speed, Together::in_step, Together::blended}) {
    const std::string text = StarterText(path, hero, clips, together).text();
    try {
      const Behaviour plays(path, hero, cook_graph_text(path, text), packs);
      return text;
    } catch (const Failure&) {
      if (together == Together::blended) throw;
    }
  }
  return {};
}

}  // namespace marrow::tools
