#include "story/story.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "behave/behaviour.h"
#include "behave/find_graph.h"
#include "cook/gltf/read.h"
#include "disk/cook_on_disk.h"
#include "disk/files.h"
#include "sample/embedded.h"
#include "story/adjust.h"
#include "story/eight.h"

namespace marrow::tools {
namespace {

constexpr float kStep_s = 1.0f / kStoryFps, kGravity = 9.81f;
constexpr float kReach = 1.85f;               // of the eight, metres
constexpr float kBegin = 0.55f;               // where on it it begins and ends: behind the crossing
constexpr float kSlow = 0.38f, kFast = 1.5f;  // m/s
constexpr float kLeap = 1.9f;                 // m/s upwards
constexpr float kStoneWay = 0.46f;            // of the stone, behind the crossing
constexpr float kStoneRadius = 0.185f, kStoneHeight = 0.165f;
constexpr float kLeapsBefore = 1.02f;  // of the stone: from the leap's beginning to its middle
constexpr float kChaseWay = 0.85f;     // where it sees that the firefly gets away
constexpr float kDiveBefore = 1.65f;   // of the end, where the firefly turns round
constexpr float kStood_s = 0.6f;       // before it begins, as in the end: so it can be shown again and again
constexpr float kTouch = 0.20f;        // from the head's joint to the firefly that hits it
constexpr float kQuarterTurn = 0.5f * std::numbers::pi_v<float>;
const glm::vec3 kPerch{1.25f, 1.12f, 0.95f};  // where the firefly waits

float smooth(float from, float to, float x) {
  const float u = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return u * u * (3 - 2 * u);
}

// By a spring without overshoot; half_life: of what is missing, about.
struct Follower {
  glm::vec3 at{0}, velocity{0};
  void follow(const glm::vec3& target, float half_life_s) {
    const float rate = 1.6785f / half_life_s, decay = std::exp(-rate * kStep_s);
    const glm::vec3 off = at - target, slope = velocity + rate * off;
    at = target + (off + slope * kStep_s) * decay;
    velocity = (velocity - rate * slope * kStep_s) * decay;
  }
};

enum class Chapter { waits, turns, goes, chases, is_hurt, stops, turns_back };

class Teller {
 public:
  explicit Teller(const StoryFiles& files)
      : loaded_(load_mrw(files.character)),
        behaviour_(files.character, loaded_.file, open_graph(files.moves, "newt"), {files.moves}),
        character_(loaded_.file, AsNormals::blended, 0, behaviour_.layers()),
        adjuster_(loaded_.file) {
    const glm::vec2 begin = eight_.at(kBegin), along = eight_.along(kBegin);
    begin_ = {begin.x, 0, begin.y};
    begin_rad_ = std::atan2(along.x, along.y) - kQuarterTurn;
    place(begin_, begin_rad_);
    behaviour_.update(kStood_s);
    firefly_.at = kPerch;
    const glm::vec2 stone = eight_.at(0.5f * eight_.length() + kStoneWay);
    story_.stone = {stone.x, 0, stone.y};
    story_.stone_radius = kStoneRadius;
    story_.stone_height = kStoneHeight;
    character_.set_change([this](std::uint32_t skeleton, const Pose& pose) {
      if (skeleton == 0) change(pose);
    });
  }

  Story tell() {
    constexpr auto kMost = static_cast<std::size_t>(60 * kStoryFps);
    while (!over_ && story_.steps.size() < kMost) step();
    for (Print& print : story_.prints) print.until = std::min(print.until, story_.steps.size());
    return std::move(story_);
  }

 private:
  float now_s() const { return static_cast<float>(story_.steps.size()) * kStep_s; }
  float since_s() const { return now_s() - chapter_s_; }
  bool is_in(const char* state) const { return state_ == state; }
  void set(const char* parameter, float value) { behaviour_.set(behaviour_.parameter(parameter), value); }
  void begin(Chapter chapter) {
    chapter_ = chapter;
    chapter_s_ = now_s();
  }
  void happens(std::string what) { story_.happenings.push_back({std::move(what), story_.steps.size()}); }
  glm::vec3 root() const { return {world_.rows[0][3], world_.rows[1][3], world_.rows[2][3]}; }
  float heading() const { return std::atan2(world_.rows[0][2], world_.rows[2][2]); }

  void place(const glm::vec3& at, float heading_rad) {
    const glm::mat4 turned = glm::rotate(glm::mat4(1), heading_rad, glm::vec3(0, 1, 0));
    world_ = from_glm(glm::translate(glm::mat4(1), at) * turned);
  }

  void step() {
    decide();
    const AnimatorStep& step = behaviour_.update(kStep_s);
    const float height = world_.rows[1][3], heading_before = heading();
    const glm::vec3 before_at = root();
    world_ = move_root(world_, step.root);
    world_.rows[1][3] = height;
    passes_ = false;
    for (const AnimatorEvent& event : step.events) {
      passes_ = passes_ || event.id == event_id("passing");
      if (event.id == event_id("left_foot")) comes_down_[0] = true;
      if (event.id == event_id("right_foot")) comes_down_[1] = true;
    }
    const std::string before = state_;
    for (const MachineNow& machine : behaviour_.machines())
      if (machine.machine == "body") state_ = machine.state;
    if (state_ != before) happens(state_);
    if (state_ != before && is_in("air")) rise_ = kLeap;
    steer();
    speed_m_s_ = std::hypot(root().x - before_at.x, root().z - before_at.z) / kStep_s;
    turn_rad_s_ = is_in("move") ? std::remainder(heading() - heading_before, 4 * kQuarterTurn) / kStep_s : 0;
    fly();
    move_firefly();
    record();
  }

  // What a player would press.
  void decide() {
    const float left = eight_.length() + kBegin - way_;
    switch (chapter_) {
      case Chapter::waits:
        if (since_s() < 0.45f) return;
        set("turn_left", 1);
        return begin(Chapter::turns);
      case Chapter::turns:
        if (since_s() < 1.25f || !is_in("stand")) return;
        set("going", 1);
        set("speed", 0.45f);
        return begin(Chapter::goes);
      case Chapter::goes:
        if (way_ < kBegin + kChaseWay) return;
        set("speed", kFast);
        return begin(Chapter::chases);
      case Chapter::chases:
        if (passes_ && !has_jumped_ && 0.5f * eight_.length() + kStoneWay - way_ < kLeapsBefore) jump();
        if (!(glm::distance(firefly_.at, head_) < kTouch) || left > kDiveBefore) return;
        set("hit", 1);
        happens("hit");
        set("speed", kSlow);
        return begin(Chapter::is_hurt);
      case Chapter::is_hurt:
        if (!passes_ || left > 0.4f) return;
        set("going", 0);
        return begin(Chapter::stops);
      case Chapter::stops:
        if (since_s() < 1.35f || !is_in("stand")) return;
        set("turn_right", 1);
        return begin(Chapter::turns_back);
      case Chapter::turns_back:
        over_ = since_s() > 1.75f;
    }
  }

  void jump() {
    has_jumped_ = true;
    set("jump", 1);
    set("grounded", 0);
    set("rise", kLeap);
  }

  // A small turn a step, towards the eight and along it; in the end some millimetres to where it began.
  void steer() {
    if (chapter_ == Chapter::stops || chapter_ == Chapter::turns_back) {
      const float share = 1 - std::exp(-kStep_s / 0.35f);
      const float wished = begin_rad_ + (chapter_ == Chapter::stops ? kQuarterTurn : 0);
      const bool turns = chapter_ == Chapter::stops || since_s() > 1.0f;
      return place(glm::mix(root(), begin_, since_s() > 0.5f || chapter_ == Chapter::turns_back ? share : 0.0f),
                   heading() + (turns ? share * (wished - heading()) : 0.0f));
    }
    const glm::vec2 at{root().x, root().z};
    if (chapter_ > Chapter::turns) way_ = eight_.nearest(at, way_);
    if (!is_in("start") && !is_in("move") && !is_in("land")) return;
    const float ahead = 0.10f * behaviour_.value(behaviour_.parameter("speed"));
    const glm::vec2 wished = eight_.along(way_ + ahead) + 1.6f * (eight_.at(way_) - at);
    const float off = std::remainder(std::atan2(wished.x, wished.y) - heading(), 4 * kQuarterTurn);
    const float turn = std::clamp(off * (1 - std::exp(-kStep_s / 0.14f)), -4 * kStep_s, 4 * kStep_s);
    place(root(), heading() + turn);
  }

  // Height is the game's; the graph hears of it.
  void fly() {
    if (!is_in("air")) return;
    world_.rows[1][3] += rise_ * kStep_s - 0.5f * kGravity * kStep_s * kStep_s;
    rise_ -= kGravity * kStep_s;
    set("rise", rise_);
    if (world_.rows[1][3] > 0) return;
    world_.rows[1][3] = 0;
    set("grounded", 1);
  }

  void move_firefly() {
    const float t = now_s();
    const float swift = smooth(0, 0.8f, t) * (1 - smooth(0.5f, 1.2f, ends_s()));
    const glm::vec3 flutter =
        swift * glm::vec3(0.07f * std::sin(5.1f * t), 0.06f * std::sin(7.7f * t + 1), 0.07f * std::sin(6.3f * t + 2));
    const float left = eight_.length() + kBegin - way_;
    if (chapter_ <= Chapter::turns) return firefly_.follow(kPerch + flutter, 0.2f);
    if (chapter_ == Chapter::goes) {
      // It lets the newt come near.
      const glm::vec2 next = eight_.at(way_ + 1.35f);
      return firefly_.follow(
          glm::mix(kPerch, glm::vec3(next.x, 1.05f, next.y), smooth(kBegin, kBegin + 0.6f, way_)) + flutter, 0.25f);
    }
    if (chapter_ == Chapter::chases && left > kDiveBefore) {
      const glm::vec2 next = eight_.at(way_ + 1.05f);
      return firefly_.follow(glm::vec3(next.x, 1.08f, next.y) + flutter, 0.16f);
    }
    if (chapter_ == Chapter::chases) return firefly_.follow(head_ + glm::vec3(0, 0.17f, 0), 0.09f);
    if (circles()) return circle(0.30f);
    firefly_.follow(kPerch + flutter, 0.28f);
  }

  void circle(float radius) {
    const float angle = 6.5f * now_s();
    firefly_.follow(
        head_ + glm::vec3(radius * std::sin(angle), 0.34f + 0.04f * std::sin(2.3f * angle), radius * std::cos(angle)),
        0.07f);
  }

  // The game's own hands on the pose.
  void change(const Pose& pose) {
    const bool dizzy = circles();
    const float sees = dizzy ? 0.12f : smooth(0.25f, 0.65f, now_s()) * (1 - smooth(0.7f, 1.0f, ends_s()));
    looks_ += (sees - looks_) * (1 - std::exp(-kStep_s / 0.12f));
    // As a runner does, if less: by what the curve asks for at this speed.
    const float asked = std::atan(speed_m_s_ * turn_rad_s_ / kGravity);
    leans_ += (std::clamp(0.8f * asked, -0.32f, 0.32f) - leans_) * (1 - std::exp(-kStep_s / 0.18f));
    adjuster_.lean(pose, leans_);
    adjuster_.look(pose, world_, firefly_.at, 0.8f * looks_, dizzy ? 0.45f : 0.35f * looks_);
    const bool goes = is_in("start") || is_in("move") || is_in("jump") || is_in("air") || is_in("land");
    trails_ += ((goes ? 0.6f : 0.0f) - trails_) * (1 - std::exp(-kStep_s / 0.22f));
    adjuster_.trail(pose, world_, behind(1.0f), trails_);
    // What no leg can do, the whole newt does.
    if (!is_in("air")) world_.rows[1][3] = adjuster_.sunk(pose);
    adjuster_.place(pose, world_, kStep_s);
  }

  // Since its last turn began.
  float ends_s() const { return chapter_ == Chapter::turns_back ? since_s() : 0; }

  // The firefly, about the newt's head.
  bool circles() const { return chapter_ == Chapter::is_hurt || (chapter_ == Chapter::stops && since_s() < 0.9f); }

  // Where the root was so many metres ago.
  glm::vec3 behind(float metres) const {
    glm::vec3 last = root();
    for (auto m = story_.steps.rbegin(); m != story_.steps.rend(); ++m) {
      const glm::vec3 at{m->root.x, last.y, m->root.z};
      const float piece = glm::distance(at, last);
      if (piece > metres) return last;
      metres -= piece;
      last = at;
    }
    return last - metres * glm::vec3(std::sin(heading()), 0, std::cos(heading()));
  }

  void record() {
    const std::size_t here = story_.steps.size();
    for (std::size_t foot = 0; foot < 2; ++foot) {
      if (comes_down_[foot]) adjuster_.come_down(foot);
      comes_down_[foot] = false;
    }
    character_.pose(behaviour_.animator(), world_, {});
    const std::span<const Affine> joints = character_.model_from_joint(0);
    const Span<const Affine> posed{joints.data(), joints.size()};
    StoryStep now;
    now.world_from_joint.assign(joints.begin(), joints.end());
    now.root = root();
    now.heading_rad = heading();
    now.firefly = firefly_.at;
    for (std::size_t foot = 0; foot < 2; ++foot) {
      const bool stands = adjuster_.is_planted(foot);
      if (!stands && open_[foot] != kNoPrint) {
        story_.prints[open_[foot]].until = here;
        open_[foot] = kNoPrint;
      }
      if (!stands || open_[foot] != kNoPrint) continue;
      open_[foot] = story_.prints.size();
      story_.prints.push_back({foot, adjuster_.ball(foot, posed), adjuster_.heading(foot, posed), here, SIZE_MAX});
    }
    head_ = adjuster_.head(posed);
    story_.steps.push_back(std::move(now));
  }

  static constexpr std::size_t kNoPrint = SIZE_MAX;

  LoadedFile loaded_;
  Behaviour behaviour_;
  Character character_;
  Adjuster adjuster_;
  Eight eight_{kReach};
  Story story_;
  Affine world_ = {};
  glm::vec3 begin_{0};
  float begin_rad_ = 0;
  float way_ = kBegin;  // along the eight
  Chapter chapter_ = Chapter::waits;
  float chapter_s_ = 0;  // when it began
  std::string state_;
  bool passes_ = false, has_jumped_ = false, over_ = false;
  bool comes_down_[2] = {true, true};
  std::size_t open_[2] = {kNoPrint, kNoPrint};  // of a foot: the print that it stands on
  float rise_ = 0, speed_m_s_ = 0, turn_rad_s_ = 0;
  float looks_ = 0, trails_ = 0, leans_ = 0;
  Follower firefly_;
  glm::vec3 head_{0, 1, 0};
};

}  // namespace

StoryFiles cook_story(const std::string& character) {
  cook::CookOptions options;
  options.clips_only = true;
  options.onto = std::make_shared<cook::Character>(cook::read_character(character));
  options.retarget.mirror = {{"turn_right", "turn_left"}};
  options.motion.roots = {{"*", cook::RootMotion::ground}};
  const std::span<const std::byte> graph = sample_graph();
  options.graphs = {{"newt.anim.toml", {reinterpret_cast<const char*>(graph.data()), graph.size()}}};
  const cook::Result cooked = cook::cook_scene(cook::read_gltf("newt_moves.glb", sample_moves_glb()), options);
  const std::filesystem::path path = std::filesystem::path(character).replace_filename("newt_moves.mrw");
  write_file_atomically(path.string(), cooked.file);
  return {character, path.string()};
}

Story tell_story(const StoryFiles& files) {
  return Teller(files).tell();
}

}  // namespace marrow::tools
