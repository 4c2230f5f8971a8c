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

bool Cooked::fail_of(const Part& part, const std::string& what) {
  error_ = part.name + ": " + what;
  return false;
}

bool Cooked::open(const void* bytes, std::size_t size, const std::string& name, std::int64_t skeleton) {
  *this = Cooked();
  name_ = name;
  if (mrw_abi() != MRW_ABI)
    return fail("libmarrow_c is of another release than this library's headers: build both from one checkout");
  if (read(bytes, size, name, file_) && choose(skeleton)) return true;
  std::string error = std::move(error_);
  *this = Cooked();
  name_ = name;
  error_ = std::move(error);
  return false;
}

bool Cooked::read(const void* bytes, std::size_t size, const std::string& name, Part& out) {
  out.name = name;
  const bool is_packed = mrw_is_packed(bytes, size);
  mrw_data_error error;
  mrw_data_error_init(&error);
  mrw_bytes file{};
  mrw_unpack_sizes sizes{};
  mrw_status status = MRW_OK;
  if (is_packed) status = mrw_find_unpack_sizes(bytes, size, &sizes, &error);
  const std::size_t wanted = is_packed ? sizes.memory_bytes : size;
  if (status == MRW_OK && (wanted > kMostBytes || !out.block.make(wanted)))
    return fail_of(out, "wants " + std::to_string(wanted) + " bytes of memory: cook it with fewer meshes");
  if (status == MRW_OK && is_packed) {
    mrw_mesh_decoder known[2] = {};
    status = mrw_unpack(bytes, size, known, decoders(known), out.block.data(), wanted, &file, &error);
  } else if (status == MRW_OK) {
    if (size > 0) std::memcpy(out.block.data(), bytes, size);
    file = {out.block.data(), size};
  }
  if (status == MRW_OK) status = mrw_load(file.data, file.size, &out.file, &error);
  if (status == MRW_OK) return true;
  const std::string rule = error.rule == nullptr ? "" : std::string(", ") + error.rule;
  return fail_of(out, std::string(mrw_status_text(status)) + ", byte " + std::to_string(error.offset) + rule + ": " +
                          advice(status));
}

bool Cooked::choose(std::int64_t skeleton) {
  const std::int64_t there = mrw_file_skeleton_count(&file_.file);
  if (there == 0) return fail("has no skeleton, as clip packs have none: open a character, and add_clips() to it");
  if (skeleton < 0 || skeleton >= there)
    return fail("has no skeleton " + std::to_string(skeleton) + ": choose one of 0 … " + std::to_string(there - 1));
  chosen_ = std::uint32_t(skeleton);
  if (!make_room(2)) return false;
  skeleton_ = character_.skeletons[chosen_].pose.skeleton;
  if (!place() || !take_clips(file_)) return false;
  for (std::uint32_t i = 0; i < mrw_file_mesh_count(&file_.file); ++i) {
    mrw_mesh mesh;
    if (mrw_file_mesh(&file_.file, i, 0, &mesh) == MRW_OK && mesh.skeleton == chosen_) meshes_.push_back(mesh);
  }
  return true;
}

// A character that blends so many layers, at least.
bool Cooked::make_room(std::uint32_t layers) {
  if (character_.skeletons != nullptr && character_.options.layers >= layers) return true;
  mrw_character_options options;
  mrw_character_options_init(&options);
  options.layers = layers;
  options.skin = false;
  options.animation_space = false;
  Block block;
  if (!block.make(mrw_character_bytes(&file_.file, &options))) return fail("there is no memory to pose it");
  mrw_character made;
  const mrw_status status = mrw_make_character(&file_.file, &options, block.data(), block.size(), &made);
  if (status != MRW_OK) return fail(mrw_status_text(status));
  character_ = made;
  character_block_ = std::move(block);
  return true;
}

// Where bones rest.
bool Cooked::place() {
  if (skeleton_.root_count == 0) return fail("its skeleton has no joints: cook it again");
  const float* const rows = &skeleton_.model_from_root[0].rows[0][0];
  for (std::uint32_t i = 1; i < skeleton_.root_count; ++i)
    if (!std::equal(rows, rows + 12, &skeleton_.model_from_root[i].rows[0][0]))
      return fail(
          "its root joints stand below different nodes, for which Godot's skeleton has no place: give them one "
          "parent joint in the source");
  above_.assign(rows, rows + 12);
  rests_.resize(kReals * std::size_t(skeleton_.joint_count));
  for (std::size_t j = 0; j < bone_count(); ++j) {
    float* const rest = &rests_[kReals * j];
    read_joint(skeleton_.rest, j, rest);
    for (int i = 7; i < kReals; ++i) rest[i] = rest[i] == 0 ? 1 : rest[i];
  }
  pose_.resize(rests_.size());
  return true;
}

// Those clips of a part that move the skeleton.
bool Cooked::take_clips(Part& from) {
  mrw_animations& animations = from.clips;
  if (!from.animations.make(mrw_animations_bytes(&file_.file, &from.file)))
    return fail_of(from, "there is no memory to play it");
  const mrw_status status =
      mrw_make_animations(&file_.file, &from.file, from.animations.data(), from.animations.size(), &animations);
  if (status == MRW_MISMATCH)
    return fail_of(from, "has no clips for " + name_ + ": cook it with --clips-only --skeleton " +
                             name_.substr(name_.rfind('/') + 1));
  if (status != MRW_OK) return fail_of(from, mrw_status_text(status));
  for (std::size_t i = 0; i < animations.all_count; ++i) {
    const mrw_animation& animation = animations.all[i];
    if (animation.clip_of_skeleton[chosen_] != i) continue;
    mrw_clip clip;
    if (mrw_file_clip(&from.file, std::uint32_t(i), &clip) != MRW_OK) continue;
    clips_.push_back(&animation);
    clip_names_.emplace_back(clip.name);
  }
  return true;
}

bool Cooked::add_clips(const void* bytes, std::size_t size, const std::string& name) {
  if (character_.skeletons == nullptr) return fail("nothing is open: call open() first");
  auto part = std::make_unique<Part>();
  if (!read(bytes, size, name, *part) || !take_clips(*part)) return false;
  packs_.push_back(std::move(part));
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
  const bool is_there = clip >= 0 && clip < std::int64_t(clips_.size());
  return is_there ? double(clips_[std::size_t(clip)]->duration_s) : 0;
}

// Godot refuses bones without a name, with ':' or '/' in it, and a second one of the same name.
std::vector<std::string> Cooked::bones() const {
  std::vector<std::string> out;
  for (std::uint32_t j = 0; j < skeleton_.joint_count; ++j) {
    std::string name = mrw_file_text(&file_.file, skeleton_.names[j]);
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
    out.push_back(skeleton_.parents[j] == MRW_NO_JOINT ? -1 : skeleton_.parents[j]);
  return out;
}

bool Cooked::layer(std::int64_t clip, double time_s, double weight, mrw_animation_layer& out) {
  if (clip < 0 || clip >= std::int64_t(clips_.size()))
    return fail("there is no clip " + std::to_string(clip) + ": it has " + std::to_string(clips_.size()) +
                ", counted from 0");
  if (!std::isfinite(time_s)) return fail("the time of a clip is not a number");
  if (!(weight >= 0 && weight <= 1)) return fail("the share of a clip is not within 0 … 1");
  mrw_animation_layer_init(&out);
  out.animation = clips_[std::size_t(clip)];
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
  return take_pose();
}

const float* Cooked::take_pose() {
  const mrw_soa_transform* const local = character_.skeletons[chosen_].pose.local;
  for (std::size_t j = 0; j < bone_count(); ++j) read_joint(local, j, &pose_[kReals * j]);
  return pose_.data();
}

}  // namespace marrow_godot
