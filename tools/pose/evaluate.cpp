#include "pose/evaluate.h"

#include <algorithm>

#include "common/failure.h"

namespace marrow::tools {

namespace {

// The pose of a clip; of an additive one its changes, laid on their reference.
void sample_either(const Skeleton& skeleton, const Clip& clip, float time_s, Span<SoaTransform> out) {
  if (!clip.additive) return check(sample(skeleton, clip, time_s, out));
  std::vector<AdditiveTransform> change(skeleton.soa_size());
  check(sample_additive(skeleton, clip, time_s, change));
  std::copy_n(clip.reference != nullptr ? clip.reference : skeleton.rest, skeleton.soa_size(), out.data);
  check(add(skeleton, {change, 1.0f, {}}, out));
}

}  // namespace

void check(Status status) {
  if (status != Status::ok) throw Failure(Exit::internal, "marrow", "", to_string(status), "please report this");
}

std::optional<Deformer> parse_deformer(const std::string& name) {
  if (name == "rigid") return Deformer::rigid;
  if (name == "ssd") return Deformer::ssd;
  if (name == "as") return Deformer::as;
  return std::nullopt;
}

std::optional<AsNormals> parse_as_normals(const std::string& name) {
  if (name == "blended") return AsNormals::blended;
  if (name == "tangents") return AsNormals::tangents;
  return std::nullopt;
}

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

Play play_alone(const File& clips, const Clip& clip, std::uint32_t skeleton) {
  return {{{skeleton, clip, clips}}, clip.duration_s};
}

Play play_together(const File& file, std::uint32_t clip) {
  const Clip first = file.clip(clip);
  Play play = play_alone(file, first, first.skeleton);
  if (*first.name == '\0') return play;  // clips without a name have nothing to do with one another
  for (std::uint32_t i = 0; i < file.skeleton_count(); ++i) {
    const std::uint32_t other = file.find_clip(first.name, i);
    if (i == first.skeleton || other == file.clip_count()) continue;
    play.parts.push_back({i, file.clip(other), file});
    play.duration_s = std::max(play.duration_s, play.parts.back().clip.duration_s);
  }
  return play;
}

Character::Character(const File& file, AsNormals normals, std::uint32_t level)
    : file_(file), level_(level), tangents_(file.mesh_count()) {
  if (normals == AsNormals::tangents) tangents_ = tangents_of(file, level);
  for (std::uint32_t i = 0; i < file_.skeleton_count(); ++i) {
    local_.emplace_back(file_.skeleton(i).soa_size());
    model_.emplace_back(file_.skeleton(i).joint_count);
  }
  for (std::uint32_t i = 0; i < file_.mesh_count(); ++i) {
    const Mesh mesh = file_.mesh(i, level_);
    palettes_.emplace_back(mesh.palette_size());
    coordinates_.emplace_back(as_coordinate_count(mesh.geometry));
    check(as_coordinates(mesh.geometry, coordinates_.back()));
    weights_.emplace_back(mesh.targets.size);
    std::vector<SoaTransform>& memory =
        memory_.emplace_back((morphed_bytes(mesh.geometry) + sizeof(SoaTransform) - 1) / sizeof(SoaTransform));
    check(make_morphed(mesh.geometry,
                       {reinterpret_cast<std::byte*>(memory.data()), memory.size() * sizeof(SoaTransform)},
                       morphed_.emplace_back()));
  }
  pose({}, 0);
}

void Character::pose(const Play& play, float time_s) {
  const PlayLayer layer{play, time_s, 1};
  pose({&layer, 1});
}

void Character::pose(std::span<const PlayLayer> layers) {
  for (std::uint32_t i = 0; i < file_.skeleton_count(); ++i) {
    pose_skeleton(i, layers);
    check(local_to_model(file_.skeleton(i), local_[i], model_[i]));
    if (change_) change_(i, local_[i], model_[i]);
  }
  for (std::uint32_t i = 0; i < file_.mesh_count(); ++i) {
    const Mesh mesh = file_.mesh(i, level_);
    check(build_palette(mesh, model_[mesh.skeleton], palettes_[i]));
  }
  morph_all(layers);
}

void Character::pose_skeleton(std::uint32_t index, std::span<const PlayLayer> layers) {
  const Skeleton skeleton = file_.skeleton(index);
  const std::size_t size = skeleton.soa_size();
  blended_.resize(std::max(blended_.size(), size * layers.size()));
  std::vector<BlendLayer> poses;
  for (const PlayLayer& layer : layers) {
    const Span<SoaTransform> out(blended_.data() + size * poses.size(), size);
    const auto part = std::ranges::find(layer.play.parts, index, &Play::Part::skeleton);
    if (part != layer.play.parts.end()) {
      sample_either(skeleton, part->clip, layer.time_s, out);
    } else {
      std::copy_n(skeleton.rest, size, out.data);
    }
    poses.push_back({out, layer.weight, {}});
  }
  check(blend(skeleton, poses, local_[index]));
}

void Character::morph_all(std::span<const PlayLayer> layers) {
  for (std::uint32_t i = 0; i < file_.mesh_count(); ++i) {
    if (file_.mesh(i, level_).targets.empty()) continue;
    std::ranges::fill(weights_[i], 0.0f);
    for (const PlayLayer& layer : layers) add_morph_weights(i, layer);
    check(morph(weights_[i], morphed_[i]));
    check(morph_coordinates(morphed_[i], coordinates_[i]));
  }
}

void Character::add_morph_weights(std::uint32_t index, const PlayLayer& layer) {
  const Mesh mesh = file_.mesh(index, level_);
  std::vector<std::uint32_t> channels(mesh.targets.size, kNoChannel);
  std::vector<float> values, weights(mesh.targets.size);
  const auto part = std::ranges::find(layer.play.parts, mesh.skeleton, &Play::Part::skeleton);
  if (part != layer.play.parts.end()) {
    values.resize(part->clip.channels.size);
    check(sample_channels(part->clip, layer.time_s, values));
    check(find_weight_channels(file_, mesh, part->clips, part->clip, channels));
  }
  check(morph_weights(mesh, channels, values, weights));
  for (std::size_t t = 0; t < weights.size(); ++t) weights_[index][t] += layer.weight * weights[t];
}

void Character::skin(std::uint32_t mesh_index, Deformer deformer, PosedMesh& out) const {
  Mesh mesh = file_.mesh(mesh_index, level_);
  mesh.geometry = morphed_[mesh_index].geometry;
  const std::size_t slots = mesh.geometry.slot_count;
  out.positions.resize(slots * 3);
  out.normals.resize(mesh.geometry.normals != nullptr ? slots * 3 : 0);
  out.tangents.resize(mesh.geometry.tangents != nullptr && mesh.geometry.normals != nullptr ? slots * 4 : 0);
  const SkinOutput output{out.positions, out.normals, out.tangents};
  const std::vector<Affine>& palette = palettes_[mesh_index];
  switch (deformer) {
    case Deformer::rigid:
      return check(skin_rigid(mesh, palette, output));
    case Deformer::ssd:
      return check(skin_ssd(mesh, palette, output));
    case Deformer::as:
      return check(skin_as(mesh, coordinates_[mesh_index], palette, output, tangents_[mesh_index]));
  }
}

}  // namespace marrow::tools
