// The rows graph/…: an animator of thirty nodes, updated and posed once an iteration, at steps of 1/60 s; and the same
// poses by layers that a game fills by hand; and a frame of a crowd.
#include "bench/workload.h"
#include "common/check_status.h"
#include "cook/gltf/read.h"
#include "disk/cook_on_disk.h"
#include "marrow/blend_space.h"
#include "marrow/owned.h"
#include "marrow/phase.h"
#include "sample/embedded.h"

namespace marrow::tools {
namespace {

// Thirteen clips, two spaces, two machines and that of a one_shot, four layers, two of them additive, and its own.
constexpr const char* kThirtyNodes = R"(
output = "blow"
[parameters]
speed = { type = "number", range = [0, 6], half_life = 0.08 }
bend = { type = "number", range = [-1, 1], half_life = 0.08 }
lean = { type = "number", range = [0, 1] }
armed = { type = "flag", initial = true }
jump = { type = "trigger" }
strike = { type = "trigger" }
[node.slow]
type = "clip"
clip = "walk"
speed = 0.5
[node.move]
type = "space"
by = "speed"
points = [ { at = 0, pose = "idle" }, { at = 1, pose = "walk" }, { at = 3, pose = "twist" } ]
sync = true
[node.sneak]
type = "space"
by = "bend"
points = [ { at = -1, pose = "twist" }, { at = 0, pose = "slow" }, { at = 1, pose = "walk" } ]
[node.body]
type = "machine"
start = "ground"
state.ground = { pose = "move" }
state.low = { pose = "sneak" }
state.air = { pose = "reach" }
transition = [
  { from = "ground", to = "air", when = "jump", fade = 0.15 },
  { from = "air", to = "ground", at_end = 0.2, fade = 0.2 },
  { from = "ground", to = "low", when = "speed > 5.5", fade = 0.2 },
]
[node.hands]
type = "machine"
start = "open"
state.open = { pose = "reach" }
state.shut = { pose = "idle" }
transition = [ { from = "open", to = "shut", when = "not armed", fade = 0.1 } ]
[node.guard]
type = "layer"
base = "body"
pose = "hands"
mask = { role = "chest", falloff = 1 }
weight = "armed"
fade = 0.1
[node.leaning]
type = "add"
base = "guard"
pose = "lean_left"
weight = "lean"
[node.breathing]
type = "add"
base = "leaning"
pose = "breathe"
weight = 0.5
[node.blow]
type = "one_shot"
base = "breathing"
pose = "twist"
when = "strike"
mask = { role = "chest" }
)";

// Of the poses that can be compared: two clips in step, and one over them.
constexpr const char* kThreeClips = R"(
output = "guard"
[parameters]
speed = { type = "number", range = [0, 6] }
[node.move]
type = "space"
by = "speed"
points = [ { at = 0, pose = "idle" }, { at = 1, pose = "walk" } ]
sync = true
[node.guard]
type = "layer"
base = "move"
pose = "reach"
mask = { role = "chest", falloff = 1 }
)";

// The sample with a graph.
OwnedFile cooked(const char* text) {
  cook::RawScene scene = cook::read_gltf(kNewt.file, sample_glb());
  for (const auto& [name, of] : {std::pair("lean_left", "twist"), std::pair("breathe", "idle")})
    for (std::size_t i = 0; i < scene.clips.size(); ++i)
      if (scene.clips[i].name == of) {
        cook::RawClip clip = scene.clips[i];
        clip.name = name;
        scene.clips.push_back(clip);
        break;
      }
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  options.clips.additive = {{"lean_left", "first", {}}, {"breathe", "first", {}}};
  options.motion.roots = {{"*", cook::RootMotion::ground, {}}};
  options.graphs = {{"bench.anim.toml", text, {}}};
  OwnedFile out;
  const std::vector<std::byte> bytes = cook::cook_scene(std::move(scene), options).file;
  check(make_owned(Span<const std::byte>(bytes.data(), bytes.size()), out));
  return out;
}

class Behaving : public Workload {
 public:
  explicit Behaving(const char* text) : file_(cooked(text)) {
    check(make_owned(file_, {}, animator_));
    check(make_owned(file_, {.layers = 8, .skin = false}, character_));
    check(set_number(animator_, find_parameter(animator_.bound, "speed"), 0.6f));
    for (int i = 0; i < 600; ++i) check(update_animator(animator_, 1.0f / 60, step_));
  }
  std::uint64_t hash_output(std::uint64_t state) const override {
    const Span<SoaTransform> local = character_.skeletons[0].pose.local;
    return hash_of(Span<const SoaTransform>(local.data, local.size), hash_of(animator_.state, state));
  }

 protected:
  OwnedFile file_;
  OwnedAnimator animator_;
  OwnedCharacter character_;
  AnimatorStep step_;
};

class Updated : public Behaving {
 public:
  Updated() : Behaving(kThirtyNodes) {}
  std::uint32_t items() const override { return static_cast<std::uint32_t>(animator_.bound.graph.nodes.size); }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) check(update_animator(animator_, 1.0f / 60, step_));
  }
};

class PosedByGraph : public Behaving {
 public:
  PosedByGraph() : Behaving(kThreeClips) {}
  std::uint32_t items() const override { return character_.skeletons[0].pose.skeleton.joint_count; }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) check(sample_character(character_, animator_));
  }
};

// The same pose, bit for bit, of layers that are timed as the graph's nodes are.
class PosedByHand : public PosedByGraph {
 public:
  PosedByHand() {
    const auto clip = [&](const char* name) { return find_animation(file_.animations, name); };
    const Animation *const idle = clip("idle"), *const walk = clip("walk"), *const reach = clip("reach");
    const float at[] = {0, 1};
    float weights[2];
    check(line_weights(at, 0.6f, weights));
    const PhaseClip in_step[] = {{&idle->motion, weights[0]}, {&walk->motion, weights[1]}};
    Phase phase;
    Playback idles, walks, reaches;
    for (int i = 0; i < 600; ++i) {
      check(advance_phase(in_step, 1.0f / 60, phase));
      check(advance(reaches, reach->duration_s, 1.0f / 60));
    }
    check(follow_phase(idle->motion, phase, phase, idles, idles));
    check(follow_phase(walk->motion, phase, phase, walks, walks));
    mask_.resize(4 * character_.skeletons[0].pose.skeleton.soa_size());
    check(mask_below(character_.skeletons[0].pose.skeleton, joint_of(file_.roles(0), Role::chest), 1, mask_));
    layers_[0] = {idle, clip_time(idles), weights[0]};
    layers_[1] = {walk, clip_time(walks), weights[1]};
    layers_[2] = {reach, clip_time(reaches), 1, mask_};
  }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) check(sample_character(character_, layers_));
  }

 private:
  std::vector<float> mask_;
  AnimationLayer layers_[3];
};

// A frame of a thousand characters of thirty nodes, in all weathers: each changes its mind every two seconds and
// strikes every five. All are updated; a hundred are posed each frame, two hundred every second one, three hundred
// every fourth, the rest every eighth. One character's memory serves all poses.
class Crowd : public Behaving {
 public:
  static constexpr std::uint32_t kCount = 1000;

  Crowd() : Behaving(kThirtyNodes), memory_(kCount), crowd_(kCount) {
    const std::size_t bytes = animator_bytes(animator_.bound, {.poses = false});
    for (std::uint32_t i = 0; i < kCount; ++i) {
      memory_[i] = OwnedBlock(bytes);
      check(make_animator(animator_.bound, {.poses = false, .seed = i + 1}, memory_[i].span(), crowd_[i]));
    }
    speed_ = find_parameter(animator_.bound, "speed");
    strike_ = find_parameter(animator_.bound, "strike");
  }
  std::uint32_t items() const override { return kCount; }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i, ++frame_)
      for (std::uint32_t who = 0; who < kCount; ++who) go(who, frame_ + 7 * who);
  }
  std::uint64_t hash_output(std::uint64_t state) const override {
    for (const Animator& a : crowd_) state = hash_of(a.state, state);
    return state;
  }

 private:
  static std::uint64_t period_of(std::uint32_t who) { return who < 100 ? 1 : who < 300 ? 2 : who < 600 ? 4 : 8; }

  void go(std::uint32_t who, std::uint64_t moment) {
    Animator& a = crowd_[who];
    if (moment % 120 == 0) check(set_number(a, speed_, float(moment / 120 % 4)));
    if (moment % 300 == 0) check(fire(a, strike_));
    AnimatorStep step;
    check(update_animator(a, 1.0f / 60, step));
    if (moment % period_of(who) == 0) check(pose_character(character_, a));
  }

  std::vector<OwnedBlock> memory_;
  std::vector<Animator> crowd_;
  std::uint32_t speed_ = 0, strike_ = 0;
  std::uint64_t frame_ = 0;
};

}  // namespace

RowGroup behaving_rows() {
  RowGroup group;
  const auto row = [&](const char* name, auto make) { group.rows.push_back({name, nullptr, {}, make}); };
  row("graph/update", [](Models&) { return std::make_unique<Updated>(); });
  row("graph/pose", [](Models&) { return std::make_unique<PosedByGraph>(); });
  row("graph/by_hand", [](Models&) { return std::make_unique<PosedByHand>(); });
  row("graph/crowd", [](Models&) { return std::make_unique<Crowd>(); });
  group.names = "graph/{update,pose,by_hand,crowd}\n";
  return group;
}

}  // namespace marrow::tools
