#include "road/scenes/scene_measure.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>

#include "common/failure.h"
#include "common/unpack_mrw.h"
#include "cook/gltf/read.h"
#include "cook/prepare/match_skeletons.h"
#include "disk/cook_on_disk.h"
#include "marrow/marrow.h"
#include "road/reference.h"
#include "support/aligned.h"
#include "support/rig.h"

namespace marrow::test {
namespace {

using cook::CookOptions;
using cook::MeshCodec;

constexpr double kLossless = 2e-5;
constexpr std::size_t kLooks = 6;
constexpr std::size_t kKeys = 2;  // of the looks, at a key and just before one

cook::RawScene read(const std::string& text) {
  return cook::read_gltf("scene.gltf", std::as_bytes(std::span(text.data(), text.size())));
}

void require(Status status) {
  if (status != Status::ok) throw std::runtime_error("the runtime refuses what was cooked");
}

// A cooked file as a game has it, and what was said about it.
struct Loaded {
  explicit Loaded(cook::Result result) : report(std::move(result.report)) {
    std::vector<std::byte> bytes = std::move(result.file);
    if (is_packed({bytes.data(), bytes.size()})) {
      const tools::AlignedBytes unpacked = tools::unpacked(bytes, "scene.mrw");
      block = std::make_unique<AlignedBlock>(unpacked.data(), unpacked.size());
    } else {
      block = std::make_unique<AlignedBlock>(bytes.data(), bytes.size());
    }
    require(load(*block, file));
  }
  nlohmann::ordered_json report;
  std::unique_ptr<AlignedBlock> block;
  File file;
};

// What a moment should look like.
struct Moment {
  std::size_t animation = 0;
  std::string clip;  // empty: at rest
  float time_s = 0;
  std::vector<float> cycle;  // if not empty, weights of all meshes' targets in turn
  ReferencePose want;
  std::vector<Map> nodes;
  std::vector<double> node_noise;
};

// Each target alone.
std::vector<std::vector<float>> cycles_of(const Source& source) {
  std::vector<std::vector<float>> out;
  for (const SourceNode& node : source.nodes)
    while (out.size() < node.weights.size()) out.emplace_back();
  for (std::size_t t = 0; t < out.size(); ++t) {
    out[t].assign(out.size(), 0);
    out[t][t] = 1;
  }
  return out;
}

// The first key that some channel has after that, or what is just before it: most jumps are at keys.
float key_beside(const SourceAnimation& animation, float time_s, bool before) {
  double out = 1e9;
  for (const SourceChannel& c : animation.channels) {
    const auto after = std::ranges::upper_bound(c.times_s, static_cast<double>(time_s));
    if (after != c.times_s.end()) out = std::min(out, *after);
  }
  const auto key_s = static_cast<float>(out < 1e9 ? out : static_cast<double>(time_s));
  return before ? key_s * (1 - 0x1p-21F) : key_s;
}

std::vector<Moment> moments_of(const Reference& reference, std::uint32_t seed) {
  Random random(seed);
  std::vector<Moment> out;
  out.push_back({0, "", 0, {}, reference.rest(), {}, {}});
  for (const std::vector<float>& cycle : cycles_of(reference.source()))
    out.push_back({0, "", 0, cycle, reference.rest(cycle), {}, {}});
  for (std::size_t a = 0; a < reference.source().animations.size(); ++a) {
    const SourceAnimation& animation = reference.source().animations[a];
    double first_s = 1e9;
    for (const SourceChannel& c : animation.channels) first_s = std::min(first_s, c.times_s.front());
    const double last_s = reference.duration_s(a);
    for (std::size_t m = 0; m < kLooks; ++m) {
      const double share = m == 0 ? 0 : m == 1 ? 1 : random.between(0, 1);
      auto time_s = static_cast<float>(first_s + share * (last_s - first_s));
      if (m + kKeys >= kLooks) time_s = key_beside(animation, time_s, m + 1 < kLooks);
      const auto at_s = static_cast<double>(time_s);
      out.push_back({a,
                     animation.name,
                     time_s,
                     {},
                     reference.at(a, at_s),
                     reference.nodes_at(a, at_s),
                     reference.node_noise_at(a, at_s)});
    }
  }
  return out;
}

// A clip of a name that moves a skeleton of the character, in its own file or in a pack.
struct Played {
  const Loaded* of = nullptr;  // null: the skeleton rests
  std::uint32_t clip = 0;
  Clip view() const { return of->file.clip(clip); }
  double stated(const char* what) const { return of == nullptr ? 0 : of->report["clips"][clip][what].get<double>(); }
};

Played find(const Loaded& character, const Loaded* pack, const std::string& name, std::uint32_t skeleton) {
  for (std::uint32_t c = 0; c < character.file.clip_count(); ++c)
    if (character.file.clip(c).skeleton == skeleton && character.file.clip(c).name == name) return {&character, c};
  for (std::uint32_t c = 0; pack != nullptr && c < pack->file.clip_count(); ++c)
    if (pack->file.clip(c).name == name &&
        bind_clips(pack->file, pack->file.clip(c).skeleton, character.file, skeleton) == Status::ok)
      return {pack, c};
  return {};
}

class Game {
 public:
  Game(const RandomScene& scene, const Loaded& character, const Loaded* pack)
      : scene_(scene), character_(character), pack_(pack) {}

  // Sets the pose of a skeleton. Returns what is said of its vertices and of its joints.
  struct Stated {
    double vertices = 0, joints = 0;
    double base = 0;           // of vertices of what an additive clip is laid on, which is part of both
    bool is_lossless = false;  // keys that stay as they are
  };
  Stated pose(std::uint32_t skeleton, const Moment& moment);
  const std::vector<Affine>& joints() const { return model_; }
  // Of a mesh that the pose is of; three a slot.
  std::vector<float> skin(const Mesh& mesh, const Moment& moment) const;

 private:
  void lay_on(const Skeleton& skeleton, std::uint32_t index, const Played& played, float time_s, Stated& stated);

  const RandomScene& scene_;
  const Loaded& character_;
  const Loaded* pack_;
  std::vector<SoaTransform> local_;
  std::vector<Affine> model_;
};

// On what the option names, as decoded: its error counts, too.
void Game::lay_on(const Skeleton& skeleton, std::uint32_t index, const Played& played, float time_s, Stated& stated) {
  std::string over;
  for (const auto& [clip, reference] : scene_.additive)
    if (clip == played.view().name) over = reference;
  const Clip clip = played.view();
  std::vector<AdditiveTransform> change(skeleton.soa_size());
  require(sample_additive(skeleton, clip, time_s, change));
  if (over == "first" && clip.reference != nullptr) std::copy_n(clip.reference, skeleton.soa_size(), local_.begin());
  const Played base = over == "first" || over == "rest" ? Played{} : find(character_, pack_, over, index);
  if (base.of != nullptr) require(sample(skeleton, base.view(), 0, local_));
  stated.base = base.stated("max_vertex_error_m");
  stated.vertices += stated.base;
  stated.joints += base.stated("max_error_m");
  require(add(skeleton, {change, 1, {}}, local_));
}

Game::Stated Game::pose(std::uint32_t index, const Moment& moment) {
  const Skeleton skeleton = character_.file.skeleton(index);
  local_.assign(skeleton.rest, skeleton.rest + skeleton.soa_size());
  model_.resize(skeleton.joint_count);
  const Played played = find(character_, pack_, moment.clip, index);
  Stated stated{played.stated("max_vertex_error_m"), played.stated("max_error_m"), 0};
  stated.is_lossless = stated.vertices == 0 && stated.joints == 0;
  if (played.of != nullptr && played.view().additive)
    lay_on(skeleton, index, played, moment.time_s, stated);
  else if (played.of != nullptr)
    require(sample(skeleton, played.view(), moment.time_s, local_));
  require(local_to_model(skeleton, local_, model_));
  return stated;
}

std::vector<float> Game::skin(const Mesh& mesh, const Moment& moment) const {
  std::vector<float> weights(mesh.targets.size);
  const Played played = find(character_, pack_, moment.clip, mesh.skeleton);
  std::vector<std::uint32_t> channels(mesh.targets.size, kNoChannel);
  std::vector<float> values;
  if (played.of != nullptr) {
    values.resize(played.view().channels.size);
    require(find_weight_channels(character_.file, mesh, played.of->file, played.view(), channels));
    require(sample_channels(played.view(), moment.time_s, values));
  }
  require(morph_weights(mesh, channels, values, weights));
  for (std::size_t t = 0; t < weights.size() && !moment.cycle.empty(); ++t)
    weights[t] = moment.cycle[t % moment.cycle.size()];
  AlignedBlock memory(morphed_bytes(mesh.geometry));
  MorphedGeometry morphed;
  require(make_morphed(mesh.geometry, {memory.data(), memory.size()}, morphed));
  require(morph(weights, morphed));
  Mesh moved = mesh;
  moved.geometry = morphed.geometry;
  std::vector<Affine> palette(mesh.palette_size());
  require(build_palette(mesh, model_, palette));
  std::vector<float> out(std::size_t{3} * mesh.geometry.slot_count);
  require(skin_ssd(moved, palette, {out, {}, {}}));
  return out;
}

// What is compared, and with what.
enum class Cooking { lossless, clips, packed, packed_clips };
constexpr const char* kCookings[] = {"lossless", "clips", "packed", "packed clips"};

class Comparison {
 public:
  Comparison(const RandomScene& scene, const Reference& reference, const std::vector<Moment>& moments, SceneErrors& out)
      : scene_(scene), reference_(reference), moments_(moments), out_(out) {}

  double clip_error_m() const { return scene_.clip_error * reference_.diagonal(); }
  void run(Cooking how);

 private:
  CookOptions options(Cooking how) const;
  void moment(Cooking how, const Loaded& character, const Loaded* pack, const Moment& moment);
  void mesh(Cooking how, const Game& game, std::uint32_t index, const Loaded& character, const Moment& moment,
            std::size_t first, const Game::Stated& stated);
  void joints(const Skeleton& skeleton, const File& file, const Game& game, const Moment& moment, double stated);
  void hold_promise(Cooking how, const nlohmann::ordered_json& clips);
  void note(double& worst, double real, double stated, double floor, const char* what, const Moment& moment);

  const RandomScene& scene_;
  const Reference& reference_;
  const std::vector<Moment>& moments_;
  SceneErrors& out_;
  Cooking how_ = Cooking::lossless;
};

CookOptions Comparison::options(Cooking how) const {
  CookOptions out;
  out.clips.effort = cook::Effort::fast;
  out.mesh.keep_vertex_order = true;
  if (how == Cooking::lossless || how == Cooking::clips) out.mesh.codec = MeshCodec::none;
  out.clips.raw = how == Cooking::lossless || how == Cooking::packed;
  out.clips.error = {{"", clip_error_m(), false}};
  return out;
}

// floor: what floats may do.
void Comparison::note(double& worst, double real, double stated, double floor, const char* what, const Moment& moment) {
  const double most = stated + floor / kMostRatio;
  // NaN, and an error where there can be none, are as wrong as can be.
  const double ratio = most > 0 && real < 1e30 ? real / most : real == 0 ? 0 : 1e30;
  if (ratio > out_.largest())
    out_.worst = std::string(kCookings[static_cast<std::size_t>(how_)]) + ": " + what + " of \"" + moment.clip +
                 "\" at " + std::to_string(moment.time_s) + " s: " + std::to_string(real * 1000) + " mm real, " +
                 std::to_string(stated * 1000) + " said, " + std::to_string(floor * 1000) + " of floats";
  worst = std::max(worst, ratio);
}

void Comparison::joints(const Skeleton& skeleton, const File& file, const Game& game, const Moment& moment,
                        double stated) {
  const std::vector<SourceNode>& nodes = reference_.source().nodes;
  for (std::uint32_t j = 0; j < skeleton.joint_count; ++j) {
    const auto node = std::ranges::find(nodes, file.text(skeleton.names[j]), &SourceNode::name);
    if (node == nodes.end()) throw std::runtime_error("a joint that is no node");
    const auto n = static_cast<std::size_t>(node - nodes.begin());
    Vec3 apart{};
    for (std::size_t r = 0; r < 3; ++r)
      apart[r] = static_cast<double>(game.joints()[j].rows[r][3]) - moment.nodes[n].rows[r][3];
    note(out_.joints, length(apart), stated, moment.node_noise[n], "a joint", moment);
  }
}

void Comparison::mesh(Cooking how, const Game& game, std::uint32_t index, const Loaded& character, const Moment& moment,
                      std::size_t first, const Game::Stated& stated) {
  const Mesh mesh = character.file.mesh(index);
  const std::vector<float> got = game.skin(mesh, moment);
  const nlohmann::ordered_json& said = character.report["meshes"][index];
  const double at_rest = said["max_position_error_m"].get<double>() +
                         (moment.cycle.empty() ? 0 : said["max_target_error_m"].get<double>());
  for (std::size_t v = 0; v < mesh.geometry.source_slots.size; ++v) {
    const std::size_t slot = mesh.geometry.source_slots[v];
    if (slot == kNoSlot) continue;
    Vec3 apart{};
    for (std::size_t i = 0; i < 3; ++i)
      apart[i] = static_cast<double>(got[slot * 3 + i]) - moment.want.positions[first + v][i];
    const double real = length(apart), floor = moment.want.float_noise[first + v];
    ++out_.compared;
    if (how == Cooking::lossless) {
      // Morph targets are 16 bits all the same, which is said.
      const double of_targets = mesh.targets.empty() ? 0 : moment.clip.empty() ? at_rest : stated.vertices;
      note(out_.lossless, real, kLossless / kMostRatio * reference_.diagonal() + of_targets, floor, "lossless", moment);
    } else if (moment.clip.empty()) {
      note(out_.rest, real, at_rest, floor, "at rest", moment);
    } else if (how == Cooking::clips && stated.is_lossless) {
      note(out_.lossless, real, kLossless / kMostRatio * reference_.diagonal() + stated.vertices, floor, "a raw clip",
           moment);
    } else if (how == Cooking::clips) {
      note(out_.vertices, real, stated.vertices, floor, "a vertex", moment);
      // What the rounding of morph targets and of their weights does is said, not promised.
      if (mesh.targets.empty()) note(out_.promise, real, clip_error_m() + stated.base, floor, "the promise", moment);
    }
  }
}

void Comparison::moment(Cooking how, const Loaded& character, const Loaded* pack, const Moment& moment) {
  Game game(scene_, character, pack);
  for (std::uint32_t s = 0; s < character.file.skeleton_count(); ++s) {
    const Game::Stated stated = game.pose(s, moment);
    if ((how == Cooking::clips || how == Cooking::packed_clips) && !moment.clip.empty() && !stated.is_lossless)
      joints(character.file.skeleton(s), character.file, game, moment, stated.joints);
    std::size_t first = 0;
    for (std::uint32_t m = 0; m < character.file.mesh_count(); ++m) {
      const Mesh one = character.file.mesh(m);
      if (one.skeleton == s) mesh(how, game, m, character, moment, first, stated);
      first += one.geometry.source_slots.size;
    }
  }
}

// What is said is within the promise by itself, to the last digits.
void Comparison::hold_promise(Cooking how, const nlohmann::ordered_json& clips) {
  for (const nlohmann::ordered_json& said : clips) {
    out_.coded += said["codec"] == "segments";
    if (how == Cooking::lossless || how == Cooking::packed) continue;
    const Moment any{0, said["name"].get<std::string>(), 0, {}, {}, {}, {}};
    const auto hold = [&](const char* what) {
      note(out_.promise, said[what].get<double>() * kMostRatio * (1 - 1e-9), clip_error_m(), 0, what, any);
    };
    hold("max_error_m");
    if (!scene_.has[static_cast<std::size_t>(SceneKind::morphed)]) hold("max_vertex_error_m");
  }
}

void Comparison::run(Cooking how) {
  how_ = how;
  CookOptions plain = options(how), with_changes = plain;
  for (const auto& [clip, over] : scene_.additive) with_changes.clips.additive.push_back({clip, over});
  const Loaded character(cook::cook_scene(read(scene_.character), with_changes));
  std::optional<Loaded> pack;
  if (!scene_.pack.empty()) {
    plain.clips_only = true;
    plain.onto = std::make_shared<const cook::Character>(cook::view_character("character.mrw", character.file));
    pack.emplace(cook::cook_scene(read(scene_.pack), plain));
  }
  const Loaded* const clips = pack ? &*pack : nullptr;
  for (const Loaded* const of : {&character, clips})
    if (of != nullptr) hold_promise(how, of->report["clips"]);
  for (const Moment& one : moments_) moment(how, character, clips, one);
}

}  // namespace

double SceneErrors::largest() const {
  return std::max({lossless, vertices, joints, promise, rest});
}

SceneErrors measure(const RandomScene& scene) {
  SceneErrors out;
  const Reference reference(read_source_text(scene.together));
  const std::vector<Moment> moments = moments_of(reference, scene.number);
  try {
    Comparison comparison(scene, reference, moments, out);
    const Cooking packed = scene.number % 3 == 0 ? Cooking::packed_clips : Cooking::packed;  // it is slow
    for (const Cooking how : {Cooking::lossless, Cooking::clips, packed}) comparison.run(how);
  } catch (const tools::Failure& failure) {
    out.refused = failure.what();
    if (scene.additive.empty()) return out;
    // A change that cannot be had: the clips are looked at as they are.
    RandomScene plain = scene;
    plain.additive.clear();
    SceneErrors again = measure(plain);
    if (again.refused.empty()) again.refused = out.refused;
    return again;
  }
  return out;
}

}  // namespace marrow::test
