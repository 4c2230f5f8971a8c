#include "cooked.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace marrow_godot {
namespace {

// What a file of a stranger may claim to unpack to.
constexpr std::size_t kMostBytes = std::size_t(1) << 30;

const char* advice(mrw_status status) {
  switch (status) {
    case MRW_BAD_MAGIC:
      return "make one with `marrow cook hero.glb -o hero.mrw`";
    case MRW_BAD_VERSION:
      return "cook it again with the `marrow` of this library's release";
    case MRW_UNSUPPORTED:
      return "build the library with that codec (-DMARROW_DRACO=ON, -DMARROW_MESHOPT=ON), or cook "
             "with --mesh-codec none --clip-codec raw";
    case MRW_OUT_OF_MEMORY:
      return "free some memory";
    default:
      return "copy it again from where it was cooked, or cook it again";
  }
}

void read_joint(const mrw_soa_transform* local, std::size_t joint, float* out) {
  const mrw_soa_transform& group = local[joint / 4];
  const std::size_t lane = joint % 4;
  for (int i = 0; i < 3; ++i) out[i] = group.translation[i][lane];
  for (int i = 0; i < 4; ++i) out[3 + i] = group.rotation[i][lane];
  for (int i = 0; i < 3; ++i) out[7 + i] = group.scale[i][lane];
}

std::size_t decoders(mrw_mesh_decoder* out) {
  std::size_t count = 0;
#ifdef MARROW_GODOT_DRACO
  if (mrw_draco_decoder(&out[count]) == MRW_OK) ++count;
#endif
#ifdef MARROW_GODOT_MESHOPT
  if (mrw_meshopt_decoder(&out[count]) == MRW_OK) ++count;
#endif
  (void)out;
  return count;
}

}  // namespace

bool Block::make(std::size_t bytes) {
  const std::size_t enough = mrw_block_bytes(bytes);
  memory_.reset(enough < bytes ? nullptr : std::malloc(enough));
  block_ = {};
  if (memory_ == nullptr || mrw_block_in(memory_.get(), enough, &block_) != MRW_OK) return false;
  block_.size = bytes;
  return true;
}

bool Cooked::fail(const std::string& what) {
  error_ = (name_.empty() ? "marrow" : name_) + ": " + what;
  return false;
}

bool Cooked::refuse(mrw_status status, const mrw_data_error& error) {
  const std::string rule = error.rule == nullptr ? "" : std::string(", ") + error.rule;
  return fail(std::string(mrw_status_text(status)) + ", byte " + std::to_string(error.offset) + rule + ": " +
              advice(status));
}

bool Cooked::open(const void* bytes, std::size_t size, const std::string& name, std::int64_t skeleton) {
  *this = Cooked();
  name_ = name;
  if (mrw_abi() != MRW_ABI)
    return fail("libmarrow_c is of another release than this library's headers: build both from one checkout");
  const bool is_open = (mrw_is_packed(bytes, size) ? unpack(bytes, size) : load(bytes, size)) && choose(skeleton);
  if (is_open) return true;
  std::string error = std::move(error_);
  *this = Cooked();
  name_ = name;
  error_ = std::move(error);
  return false;
}

bool Cooked::unpack(const void* bytes, std::size_t size) {
  mrw_data_error error;
  mrw_data_error_init(&error);
  mrw_unpack_sizes sizes{};
  mrw_status status = mrw_find_unpack_sizes(bytes, size, &sizes, &error);
  if (status != MRW_OK) return refuse(status, error);
  if (sizes.memory_bytes > kMostBytes || !file_block_.make(sizes.memory_bytes))
    return fail("would unpack to " + std::to_string(sizes.memory_bytes) + " bytes: cook it with fewer meshes");
  mrw_mesh_decoder known[2] = {};
  mrw_bytes file{};
  status = mrw_unpack(bytes, size, known, decoders(known), file_block_.data(), file_block_.size(), &file, &error);
  if (status == MRW_OK) status = mrw_load(file.data, file.size, &file_, &error);
  return status == MRW_OK || refuse(status, error);
}

bool Cooked::load(const void* bytes, std::size_t size) {
  if (!file_block_.make(size)) return fail("there is no memory for " + std::to_string(size) + " bytes");
  if (size > 0) std::memcpy(file_block_.data(), bytes, size);
  mrw_data_error error;
  mrw_data_error_init(&error);
  const mrw_status status = mrw_load(file_block_.data(), size, &file_, &error);
  return status == MRW_OK || refuse(status, error);
}

bool Cooked::choose(std::int64_t skeleton) {
  const std::int64_t there = mrw_file_skeleton_count(&file_);
  if (there == 0) return fail("has no skeleton, as clip packs have none: open a character");
  if (skeleton < 0 || skeleton >= there)
    return fail("has no skeleton " + std::to_string(skeleton) + ": choose one of 0 … " + std::to_string(there - 1));
  chosen_ = std::uint32_t(skeleton);
  mrw_character_options options;
  mrw_character_options_init(&options);
  options.layers = 2;
  options.skin = false;
  options.animation_space = false;
  if (!animations_block_.make(mrw_animations_bytes(&file_, &file_)) ||
      !character_block_.make(mrw_character_bytes(&file_, &options)))
    return fail("there is no memory to pose it");
  mrw_status status =
      mrw_make_animations(&file_, &file_, animations_block_.data(), animations_block_.size(), &animations_);
  if (status == MRW_OK)
    status = mrw_make_character(&file_, &options, character_block_.data(), character_block_.size(), &character_);
  if (status != MRW_OK) return fail(mrw_status_text(status));
  skeleton_ = character_.skeletons[chosen_].skeleton;
  rests_.resize(kReals * std::size_t(skeleton_.joint_count));
  for (std::size_t j = 0; j < bone_count(); ++j) {
    float* const rest = &rests_[kReals * j];
    read_joint(skeleton_.rest, j, rest);
    for (int i = 7; i < kReals; ++i) rest[i] = rest[i] == 0 ? 1 : rest[i];
  }
  const float* const rows = &skeleton_.scene_from_root[0].rows[0][0];
  for (std::uint32_t i = 1; i < skeleton_.root_count; ++i)
    if (!std::equal(rows, rows + 12, &skeleton_.scene_from_root[i].rows[0][0]))
      return fail(
          "its root joints stand below different nodes, for which Godot's skeleton has no place: give them one "
          "parent joint in the source");
  above_.assign(rows, rows + 12);
  for (std::uint32_t i = 0; i < mrw_file_clip_count(&file_); ++i) {
    mrw_clip clip;
    if (mrw_file_clip(&file_, i, &clip) != MRW_OK || clip.skeleton != chosen_) continue;
    clips_.push_back(i);
    clip_names_.emplace_back(clip.name);
  }
  for (std::uint32_t i = 0; i < mrw_file_mesh_count(&file_); ++i) {
    mrw_mesh mesh;
    if (mrw_file_mesh(&file_, i, 0, &mesh) == MRW_OK && mesh.skeleton == chosen_) meshes_.push_back(mesh);
  }
  pose_.resize(rests_.size());
  return true;
}

std::int64_t Cooked::find_clip(const std::string& name) {
  std::string there;
  for (std::size_t i = 0; i < clip_names_.size(); ++i) {
    if (clip_names_[i] == name) return std::int64_t(i);
    there += (i == 0 ? "" : ", ") + clip_names_[i];
  }
  fail("there is no clip \"" + name + "\": " + (there.empty() ? "it has none" : "it has " + there));
  return -1;
}

double Cooked::duration(std::int64_t clip) const {
  return clip < 0 || clip >= std::int64_t(clips_.size())
             ? 0.0
             : double(animations_.all[clips_[std::size_t(clip)]].duration_s);
}

// Godot refuses bones without a name, with ':' or '/' in it, and a second one of the same name.
std::vector<std::string> Cooked::bones() const {
  std::vector<std::string> out;
  for (std::uint32_t j = 0; j < skeleton_.joint_count; ++j) {
    std::string name = mrw_file_text(&file_, skeleton_.names[j]);
    for (char& each : name)
      if (each == ':' || each == '/') each = '_';
    if (name.empty()) name = "bone";
    while (std::find(out.begin(), out.end(), name) != out.end()) (name += "_") += std::to_string(j);
    out.push_back(name);
  }
  return out;
}

std::vector<std::int32_t> Cooked::parents() const {
  std::vector<std::int32_t> out;
  for (std::uint32_t j = 0; j < skeleton_.joint_count; ++j)
    out.push_back(skeleton_.parents[j] == MRW_NO_PARENT ? -1 : skeleton_.parents[j]);
  return out;
}

bool Cooked::layer(std::int64_t clip, double time_s, double weight, mrw_animation_layer& out) {
  if (clip < 0 || clip >= std::int64_t(clips_.size()))
    return fail("there is no clip " + std::to_string(clip) + ": it has " + std::to_string(clips_.size()) +
                ", counted from 0");
  if (!std::isfinite(time_s)) return fail("the time of a clip is not a number");
  if (!(weight >= 0 && weight <= 1)) return fail("the share of a clip is not within 0 … 1");
  mrw_animation_layer_init(&out);
  out.animation = &animations_.all[clips_[std::size_t(clip)]];
  out.time_s = float(time_s);
  out.weight = float(weight);
  return true;
}

const float* Cooked::pose(std::int64_t clip, double time_s, std::int64_t other, double other_s, double share) {
  if (character_.skeletons == nullptr) return fail("nothing is open: call open() first"), nullptr;
  mrw_animation_layer layers[2];
  const std::size_t count = other < 0 ? 1 : 2;
  if (!layer(clip, time_s, count == 1 ? 1 : share, layers[0])) return nullptr;
  if (count == 2 && !layer(other, other_s, 1 - share, layers[1])) return nullptr;
  const mrw_status status = mrw_sample_character(&character_, layers, count);
  if (status != MRW_OK) return fail(mrw_status_text(status)), nullptr;
  const mrw_soa_transform* const local = character_.skeletons[chosen_].local;
  for (std::size_t j = 0; j < bone_count(); ++j) read_joint(local, j, &pose_[kReals * j]);
  return pose_.data();
}

}  // namespace marrow_godot
