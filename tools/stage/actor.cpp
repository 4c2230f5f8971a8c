#include "stage/actor.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "math/affine.h"
#include "render/heat.h"
#include "render/manner.h"
#include "stage/recording.h"

namespace marrow::tools {
namespace {

constexpr int kMostMoments = 1024;
constexpr float kUsualRate_hz = 30;
constexpr int kMomentsOfClip = 6, kMostMomentsOfAll = 120;  // of a graph

float milliseconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<float, std::milli>(std::chrono::steady_clock::now() - start).count();
}

std::vector<NamedJoint> all_joints(const File& file) {
  std::vector<NamedJoint> out;
  for (std::uint32_t s = 0; s < file.skeleton_count(); ++s) {
    const Skeleton skeleton = file.skeleton(s);
    for (std::uint32_t j = 0; j < skeleton.joint_count; ++j) {
      std::string name = file.text(skeleton.names[j]);
      if (name.empty()) name = "joint " + std::to_string(j);
      out.push_back({file.skeleton_count() > 1 ? std::string(skeleton.name) + ": " + name : name, s, j});
    }
  }
  return out;
}

}  // namespace

Actor::Actor(const Gl& gl, gles3::ProgramSet& programs, std::string path, LoadedFile loaded, Images& images)
    : gl_(gl),
      programs_(programs),
      path_(std::move(path)),
      loaded_(std::move(loaded)),
      joints_(all_joints(file())),
      textures_(gl, file(), images),
      rig_(file()),
      local_(file().skeleton_count()) {
  add_plays();
  for (std::uint32_t i = 0; i < file().mesh_count(); ++i)
    coarsest_lod_ = std::max(coarsest_lod_, static_cast<int>(file().mesh(i).lods.size));
}

void Actor::add_plays() {
  plays_.push_back({"rest pose", {}});
  for (std::uint32_t i = 0; i < file().clip_count(); ++i) {
    const std::string name = file().clip(i).name;
    // The others of a name play along with the first.
    if (!name.empty() && file().find_clip(name.c_str()) != i) continue;
    plays_.push_back({name.empty() ? "clip " + std::to_string(i) : name, play_together(file(), i)});
  }
}

std::size_t Actor::add_play(const std::string& name, Play play, std::optional<LoadedFile> pack) {
  const auto same = [&](const NamedPlay& named) {
    return std::ranges::equal(named.play.clip_of_skeleton, play.clip_of_skeleton);
  };
  const auto found = pack ? plays_.end() : std::ranges::find_if(plays_, same);
  const auto index = static_cast<std::size_t>(found - plays_.begin());
  if (index == plays_.size()) plays_.push_back({name, std::move(play)});
  if (pack) pack_ = std::move(pack);
  return index;
}

// The pose as the clip has it, kept for the panel, and what the rig makes of it.
void Actor::listen() {
  character_->set_change([this](std::uint32_t skeleton, const Pose& pose) {
    rig_.change(skeleton, pose);
    local_[skeleton].assign(pose.local.begin(), pose.local.end());
  });
  character_->set_weigh([this](std::uint32_t mesh, Span<float> weights) { rig_.weigh(mesh, weights); });
}

void Actor::make(const Made& wanted) {
  if (wanted == made_) return;
  if (wanted.lod != made_.lod || wanted.normals != made_.normals || wanted.layers != made_.layers) {
    const auto level = static_cast<std::uint32_t>(wanted.lod);
    character_.emplace(file(), wanted.normals, level, wanted.layers);
    figure_.emplace(gl_, programs_, file(), &textures_, wanted.normals, level);
  }
  // The camera is to hold what the clip does by itself.
  character_->set_change(nullptr);
  character_->set_weigh(nullptr);
  if (rehearsal_) {
    performance_.emplace(perform_graph());
  } else {
    performance_.emplace(file(), *character_, plays_[wanted.clip].play);
  }
  listen();
  heat_largest_ = 0;
  made_ = wanted;
}

void Actor::rehearse(FoundGraph found, const std::vector<std::string>& packs) {
  auto next = std::make_unique<Rehearsal>(path_, file(), std::move(found), packs);
  if (rehearsal_) next->take(rehearsal_->kept());
  rehearsal_ = std::move(next);
  made_ = {};
}

void Actor::stop_rehearsal() {
  rehearsal_.reset();
  made_ = {};
}

// Moments of all clips that the graph plays, each where the character stands.
Performance Actor::perform_graph() {
  const Span<const Animation> clips = rehearsal_->behaviour().binding().clips;
  const auto each = std::clamp(kMostMomentsOfAll / std::max(static_cast<int>(clips.size), 1), 1, kMomentsOfClip);
  std::vector<std::pair<Play, float>> moments;
  std::vector<float> heights;
  for (const Animation& clip : clips) {
    const Play play{clip, nullptr};
    for (int i = 0; i < each && static_cast<int>(moments.size()) < kMostMomentsOfAll; ++i)
      moments.emplace_back(play, clip.duration_s * static_cast<float>(i) / static_cast<float>(each));
    for (const float height : Footprints(file(), play).heights()) heights.push_back(height);
  }
  if (moments.empty()) moments.emplace_back();
  // As many as a performance looks at in that time.
  const float rate = Performance::kMomentsPerSecond;
  const auto pose = [&](float at_s) {
    const auto& [play, time_s] = moments[std::min(static_cast<std::size_t>(at_s * rate), moments.size() - 1)];
    character_->pose(play, time_s);
  };
  Performance out(file(), *character_, Moments{static_cast<float>(moments.size()) / rate, pose, true});
  if (!heights.empty()) {
    std::ranges::nth_element(heights, heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2));
    out.set_ground_height(heights[heights.size() / 2]);
  }
  return out;
}

float Actor::rate_hz(const Settings& settings) const {
  if (settings.rate_hz > 0) return settings.rate_hz;
  const float own = own_rate_hz(settings.clip);
  return own > 0 ? own : kUsualRate_hz;
}

float Actor::own_rate_hz(std::size_t play) const {
  for (std::uint32_t s = 0; s < file().skeleton_count(); ++s) {
    const std::optional<Clip> clip = plays_[play].play.clip(s);
    if (clip && clip->coded.frame_count > 0 && clip->coded.times_s == nullptr && clip->coded.frames_per_s >= 1)
      return std::min(std::round(clip->coded.frames_per_s), 240.0f);
  }
  return 0;
}

JointTransform Actor::local(std::size_t joint) const {
  const NamedJoint& named = joints_[joint];
  JointTransform out;
  check(get_joint(local_[named.skeleton], named.joint, out));
  return out;
}

const JointCurves* Actor::curves(const Settings& settings) {
  const Play& play = plays_[settings.clip].play;
  if (rehearsal_ || joints_.empty() || play.duration_s <= 0) return nullptr;
  const Recorded wanted{settings.clip, settings.joint, rate_hz(settings)};
  if (recorded_ != wanted) {
    const NamedJoint& joint = joints_[settings.joint];
    const int moments = std::clamp(last_frame(play.duration_s, wanted.rate_hz) + 1, 2, kMostMoments);
    curves_ = record_joint(file(), play, joint.skeleton, joint.joint, moments);
    recorded_ = wanted;
  }
  return &curves_;
}

const Footprints& Actor::footprints(const Settings& settings) {
  if (!footprints_ || footprints_of_ != settings.clip) footprints_.emplace(file(), plays_[settings.clip].play);
  footprints_of_ = settings.clip;
  return *footprints_;
}

std::vector<PosedMesh> Actor::ghost(const Settings& settings, float time_s) {
  if (!ghost_) ghost_.emplace(file(), AsNormals::blended, static_cast<std::uint32_t>(coarsest_lod_));
  ghost_->set_parameters(settings.parameters);
  ghost_->pose(plays_[settings.clip].play, time_s);
  return skin_all(file(), *ghost_, Deformer::ssd);
}

void Actor::pose(const Settings& settings, float dt_s) {
  const std::uint32_t graph_layers = rehearsal_ ? rehearsal_->behaviour().layers() : 0;
  make({settings.clip, settings.lod, settings.normals, std::max(Character::kMostLayers, graph_layers)});
  character_->set_parameters(settings.parameters);
  rig_.prepare(settings, joints_, dt_s, rehearsal_ ? rehearsal_->behaviour().world_from_model() : kIdentity);
  const float time_s = clip_time(settings.playback);
  const Play& first = plays_[settings.clip].play;
  times_.pose = milliseconds_of([&] {
    if (rehearsal_) return rehearsal_->pose(*character_);
    if (settings.second == 0) return character_->pose(first, time_s);
    // In step: at the same share of their lengths.
    const Play& second = plays_[settings.second].play;
    const float share = first.duration_s > 0 ? time_s / first.duration_s : 0;
    const PlayLayer layers[] = {{first, time_s, 1 - settings.second_weight},
                                {second, share * second.duration_s, settings.second_weight}};
    character_->pose(layers);
  });
}

std::vector<Drawable> Actor::drawables(const Settings& settings, Shot& shot) {
  if (shot.box.empty()) shot.box = performance_->box(*character_);
  std::vector<Drawable> out;
  times_.skin = milliseconds_of([&] {
    if (settings.colours == Colours::distance) {
      out = heat(settings, shot);
    } else if (settings.colours == Colours::weights && !joints_.empty()) {
      out = weighted(settings, shot);
    } else if (settings.colours == Colours::uv) {
      out = checkered(settings);
    } else {
      const SkinPath path = cpu_only() ? SkinPath::cpu : settings.path;
      out = drawables_of(path_, file(), *character_, *figure_, {settings.deformer, path, std::nullopt}, shot);
    }
  });
  return out;
}

std::vector<Drawable> Actor::weighted(const Settings& settings, Shot& shot) {
  const NamedJoint& joint = joints_[settings.joint];
  std::vector<std::vector<float>> colours;
  for (std::uint32_t i = 0; i < file().mesh_count(); ++i) {
    const Mesh mesh = file().mesh(i, static_cast<std::uint32_t>(settings.lod));
    const bool is_its = mesh.skeleton == joint.skeleton;
    colours.push_back(
        ramp_colours(is_its ? joint_weights(mesh, joint.joint) : std::vector<float>(mesh.geometry.slot_count, 0.0f)));
  }
  shot.shading = kHeatShading;
  return figure_->from_cpu(skin_all(file(), *character_, settings.deformer), colours);
}

// Eight squares of two greys a unit each way; where u grows they redden, where v does they turn blue.
void Actor::make_checker() {
  constexpr int kPixels = 256, kSquares = 8;
  std::vector<std::uint8_t> rgba;
  for (int y = 0; y < kPixels; ++y) {
    for (int x = 0; x < kPixels; ++x) {
      const bool light = (x * kSquares / kPixels + y * kSquares / kPixels) % 2 == 0;
      const int base = light ? 150 : 70;
      const auto shade = [&](int more) { return static_cast<std::uint8_t>(base + 80 * more / kPixels); };
      rgba.insert(rgba.end(), {shade(x), static_cast<std::uint8_t>(base), shade(y), 255});
    }
  }
  checker_ = GlTexture(gl_);
  gl_.BindTexture(GL_TEXTURE_2D, checker_);
  gl_.TexStorage2D(GL_TEXTURE_2D, 9, GL_SRGB8_ALPHA8, kPixels, kPixels);
  gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kPixels, kPixels, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  gl_.GenerateMipmap(GL_TEXTURE_2D);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
  checker_sampler_ = GlSampler(gl_);
  gl_.SamplerParameteri(checker_sampler_, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl_.SamplerParameteri(checker_sampler_, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

// Meshes without texture coordinates stay white.
std::vector<Drawable> Actor::checkered(const Settings& settings) {
  if (checker_ == 0) make_checker();
  std::vector<std::vector<float>> white;
  for (std::uint32_t i = 0; i < file().mesh_count(); ++i)
    white.emplace_back(std::size_t{4} * file().mesh(i, static_cast<std::uint32_t>(settings.lod)).geometry.slot_count,
                       1.0f);
  std::vector<Drawable> out = figure_->from_cpu(skin_all(file(), *character_, settings.deformer), white);
  for (std::uint32_t i = 0; i < out.size(); ++i) {
    if (file().mesh(i, static_cast<std::uint32_t>(settings.lod)).geometry.uvs == nullptr) continue;
    out[i].features |= gles3::kUvs;
    out[i].look.texture = checker_;
    out[i].look.sampler = checker_sampler_;
  }
  return out;
}

std::vector<Drawable> Actor::heat(const Settings& settings, Shot& shot) {
  if (settings.pair != heat_pair_) heat_largest_ = 0;
  heat_pair_ = settings.pair;
  const std::vector<PosedMesh> a = skin_all(file(), *character_, settings.pair.first);
  const std::vector<PosedMesh> b = skin_all(file(), *character_, settings.pair.second);
  heat_largest_ = std::max(heat_largest_, largest_distance(a, b));
  heat_scale_ = sensible_scale(heat_largest_, performance_->diagonal());
  shot.shading = kHeatShading;
  return figure_->from_cpu(a, compare(a, b, heat_scale_).colours);
}

}  // namespace marrow::tools
