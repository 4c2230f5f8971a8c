#include "pose/evaluate.h"

#include "math/affine.h"
#include "pose/worn.h"

namespace marrow::tools {

std::vector<std::vector<float>> tangents_of(const File& file, std::uint32_t level) {
  std::vector<Mesh> meshes;
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) meshes.push_back(file.mesh(i, level));
  std::vector<std::vector<float>> coordinates(meshes.size()), out(meshes.size());
  std::vector<AsPart> parts;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const Geometry& g = meshes[i].geometry;
    if (g.normals == nullptr || !g.targets.empty()) continue;
    coordinates[i].resize(as_coordinate_count(g));
    out[i].resize(as_tangent_count(g));
    check(as_coordinates(g, coordinates[i]));
    parts.push_back({&meshes[i], coordinates[i], out[i]});
  }
  std::vector<std::uint32_t> scratch(as_tangent_scratch_bytes(parts) / sizeof(std::uint32_t));
  check(as_tangents(parts, {reinterpret_cast<std::byte*>(scratch.data()), scratch.size() * sizeof(std::uint32_t)}));
  return out;
}

std::optional<Clip> Play::clip(std::uint32_t skeleton) const {
  if (empty() || clip_of_skeleton[skeleton] == kNoClip) return std::nullopt;
  return clips.clip(clip_of_skeleton[skeleton]);
}

std::vector<Play> plays_of(const File& file, const File& clips) {
  const auto memory = std::make_shared<AlignedBytes>(animations_bytes(file, clips));
  Animations animations;
  const Status status = make_animations(file, clips, *memory, animations);
  if (status == Status::mismatch) return std::vector<Play>(clips.clip_count());
  check(status);
  std::vector<Play> out;
  for (const Animation& animation : animations.all) out.push_back({animation, memory});
  return out;
}

Play play_together(const File& file, const File& clips, std::uint32_t clip) {
  return plays_of(file, clips)[clip];
}

std::optional<std::uint32_t> skeleton_of(const Play& play, std::uint32_t clip) {
  for (std::uint32_t s = 0; s < play.clip_of_skeleton.size; ++s)
    if (play.clip_of_skeleton[s] == clip) return s;
  return std::nullopt;
}

Play only(const File& file, const Play& play, std::uint32_t skeleton) {
  if (play.empty()) return {};
  const std::size_t skeletons = play.clip_of_skeleton.size;
  const auto memory = std::make_shared<std::vector<std::uint32_t>>(skeletons, kNoClip);
  memory->at(skeleton) = play.clip_of_skeleton[skeleton];
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m)
    for (std::size_t t = 0; t < file.mesh(m).targets.size; ++t)
      memory->push_back(file.mesh(m).skeleton == skeleton ? play.channels[memory->size() - skeletons] : kNoChannel);
  const std::optional<Clip> clip = play.clip(skeleton);
  Play out;
  out.clips = play.clips;
  out.duration_s = clip ? clip->duration_s : 0;
  out.clip_of_skeleton = {memory->data(), skeletons};
  out.channels = {memory->data() + skeletons, memory->size() - skeletons};
  out.memory = memory;
  return out;
}

Character::Character(const File& file, AsNormals normals, std::uint32_t level, std::uint32_t layers)
    : shapes_(file), tangents_(file.mesh_count()) {
  if (normals == AsNormals::tangents) tangents_ = tangents_of(file, level);
  const CharacterOptions options{.layers = layers, .level = level, .skin = true, .animation_space = true};
  memory_ = AlignedBytes(character_bytes(file, options));
  check(make_character(file, options, memory_, body_));
  no_clips_.assign(file.skeleton_count(), kNoClip);
  no_channels_.assign(body_.target_count, kNoChannel);
  rest_ = {"", file, 0, no_clips_, no_channels_};
}

void Character::pose(const Play& play, float time_s) {
  const PlayLayer layer{play, time_s, 1};
  pose({&layer, 1});
}

void Character::pose(std::span<const PlayLayer> layers) {
  std::vector<AnimationLayer> all;
  for (const PlayLayer& layer : layers)
    all.push_back({layer.play.empty() ? &rest_ : &layer.play, layer.time_s, layer.weight});
  check(pose_character(body_, all));
  shapes_.write(all, body_);
  change_pose();
  check(finish_character(body_));
  for (const std::shared_ptr<Worn>& worn : worn_)
    worn->character->follow(worn->outfit, *this, layers.front().play.empty() ? Play{} : worn->play,
                            layers.front().time_s);
}

void Character::change_pose() {
  for (std::uint32_t i = 0; i < body_.skeletons.size && change_; ++i) change_(i, body_.skeletons[i].pose);
  for (std::uint32_t i = 0; i < body_.meshes.size && weigh_; ++i)
    if (!body_.meshes[i].weights.empty()) weigh_(i, body_.meshes[i].weights);
}

void Character::pose(Animator& animator, const Affine& world_from_model, std::span<const AnimationLayer> shown) {
  check(pose_character(body_, animator));
  shapes_.write(shown, body_);
  change_pose();
  for (const CharacterSkeleton& skeleton : body_.skeletons)
    for (Affine& joint : skeleton.pose.model_from_joint) {
      const Affine model_from_joint = joint;
      multiply(world_from_model, model_from_joint, joint);
    }
  check(finish_character(body_));
  for (const std::shared_ptr<Worn>& worn : worn_) worn->character->follow(worn->outfit, *this, {}, 0);
}

void Character::follow(const Outfit& outfit, const Character& body, const Play& play, float time_s) {
  const AnimationLayer layer{play.empty() ? &rest_ : &play, time_s};
  check(sample_character(body_, {&layer, 1}));
  shapes_.write({&layer, 1}, body_);
  check(follow_body(outfit, body.body_, body_));
  check(finish_character(body_));
}

void Character::skin(std::uint32_t mesh, Deformer deformer, PosedMesh& out) const {
  const CharacterMesh& m = body_.meshes[mesh];
  const Geometry& g = m.mesh.geometry;
  const std::size_t slots = g.slot_count;
  out.positions.resize(slots * 3);
  out.normals.resize(g.normals != nullptr ? slots * 3 : 0);
  out.tangents.resize(g.tangents != nullptr && g.normals != nullptr ? slots * 4 : 0);
  out.inside_out = turns_inside_out(m.palette);
  const SkinOutput output{out.positions, out.normals, out.tangents};
  switch (deformer) {
    case Deformer::rigid:
      return check(skin_rigid(m.mesh, m.palette, output));
    case Deformer::ssd:
      return check(skin_ssd(m.mesh, m.palette, output));
    case Deformer::as:
      return check(skin_as(m.mesh, m.coordinates, m.palette, output, tangents_[mesh]));
    case Deformer::mwe:
      return check(g.mwe_residual == nullptr ? skin_ssd(m.mesh, m.palette, output)
                                             : skin_mwe(m.mesh, m.palette, output));
    case Deformer::psd: {
      std::vector<float> distances(psd_distance_count(g));
      check(psd_distances(g, m.palette, distances));
      return check(skin_psd(m.mesh, distances, m.palette, output));
    }
  }
}

void expect_deformer(const std::string& path, const File& file, Deformer deformer) {
  if (deformer != Deformer::mwe && deformer != Deformer::psd) return;
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) {
    const Geometry g = file.mesh(i).geometry;
    if (deformer == Deformer::mwe ? g.mwe_residual != nullptr : !g.pose_space.examples.empty()) return;
  }
  if (deformer == Deformer::mwe)
    throw Failure(Exit::unsupported, path, "", "no mesh has multi-weights", "cook it with --mwe");
  throw Failure(Exit::unsupported, path, "", "no mesh has a pose space", "cook it with --psd 8");
}

}  // namespace marrow::tools
