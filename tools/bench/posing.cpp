// The rows from local poses to a palette: blend/…, local_to_model, palette, frame and character, on one skeleton.
#include "bench/workload.h"
#include "common/aligned_bytes.h"
#include "marrow/character.h"
#include "pose/evaluate.h"

namespace marrow::tools {
namespace {

constexpr std::size_t kMostLayers = 4;

// Two clips of one skeleton; the second only for frame.
struct Stage {
  const ModelSource* model;
  const char* clips[2];
};
constexpr Stage kPabStage = {&kPab, {"pab_walk_raw", "pab_jog_raw"}};
constexpr Stage kNewtStage = {&kNewt, {"walk", "idle"}};

std::vector<SoaTransform> pose_at(const ClipOfModel& source, float time_s) {
  std::vector<SoaTransform> pose(source.skeleton.soa_size());
  check(sample(source.skeleton, source.clip, time_s, pose));
  return pose;
}

std::vector<Affine> joints_of(const Skeleton& skeleton, const std::vector<SoaTransform>& pose) {
  std::vector<Affine> joints(skeleton.joint_count);
  check(local_to_model(skeleton, pose, joints));
  return joints;
}

struct BlendShape {
  const char* name;
  std::size_t layers;
  bool masked;    // every layer, each by a mask of its own
  bool additive;  // one change on top
};
constexpr BlendShape kBlends[] = {{"2", 2, false, false},
                                  {"4", 4, false, false},
                                  {"2_masked", 2, true, false},
                                  {"4_masked", 4, true, false},
                                  {"2_additive1", 2, false, true}};

// Moments of one clip, weighed 0.4, 0.3, 0.2 and 0.1.
class Blending : public Workload {
 public:
  Blending(const ClipOfModel& source, const BlendShape& shape)
      : skeleton_(source.skeleton), additive_(shape.additive), out_(source.skeleton.soa_size()) {
    Noise noise;
    for (std::size_t i = 0; i < kMostLayers; ++i) {
      poses_.push_back(pose_at(source, source.clip.duration_s * static_cast<float>(i) / kMostLayers));
      masks_.emplace_back(4 * skeleton_.soa_size());
      for (float& factor : masks_.back()) factor = noise.next();
    }
    for (std::size_t i = 0; i < shape.layers; ++i) {
      layers_.push_back({poses_[i], 0.1f * static_cast<float>(kMostLayers - i), {}});
      if (shape.masked) layers_.back().mask = masks_[i];
    }
    change_.resize(skeleton_.soa_size());
    check(make_additive(skeleton_, poses_[3], poses_[2], change_));
  }
  std::uint32_t items() const override { return skeleton_.joint_count; }
  std::uint64_t hash_output(std::uint64_t state) const override { return hash_of(out_, state); }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) {
      check(blend(skeleton_, layers_, out_));
      if (additive_) check(add(skeleton_, {change_, 0.5f, {}}, out_));
    }
  }

 private:
  Skeleton skeleton_;
  bool additive_;
  std::vector<std::vector<SoaTransform>> poses_;
  std::vector<std::vector<float>> masks_;
  std::vector<BlendLayer> layers_;
  std::vector<AdditiveTransform> change_;
  std::vector<SoaTransform> out_;
};

class LocalToModel : public Workload {
 public:
  explicit LocalToModel(const ClipOfModel& source)
      : skeleton_(source.skeleton), pose_(pose_at(source, source.clip.duration_s / 2)), out_(skeleton_.joint_count) {}
  std::uint32_t items() const override { return skeleton_.joint_count; }
  std::uint64_t hash_output(std::uint64_t state) const override { return hash_of(out_, state); }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) check(local_to_model(skeleton_, pose_, out_));
  }

 private:
  Skeleton skeleton_;
  std::vector<SoaTransform> pose_;
  std::vector<Affine> out_;
};

// A palette with one entry a joint; what its bind matrices are costs nothing.
struct FullPalette {
  explicit FullPalette(const Skeleton& skeleton) : bind(noise_palette(skeleton.joint_count)), out(bind.size()) {
    for (std::uint32_t i = 0; i < skeleton.joint_count; ++i) joints.push_back(static_cast<std::uint16_t>(i));
  }
  void build(const std::vector<Affine>& model_from_joint) { check(build_palette(joints, bind, model_from_joint, out)); }

  std::vector<std::uint16_t> joints;
  std::vector<Affine> bind, out;
};

class BuildPalette : public Workload {
 public:
  explicit BuildPalette(const ClipOfModel& source)
      : joints_(joints_of(source.skeleton, pose_at(source, source.clip.duration_s / 2))), palette_(source.skeleton) {}
  std::uint32_t items() const override { return static_cast<std::uint32_t>(joints_.size()); }
  std::uint64_t hash_output(std::uint64_t state) const override { return hash_of(palette_.out, state); }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) palette_.build(joints_);
  }

 private:
  std::vector<Affine> joints_;
  FullPalette palette_;
};

// A palette of all joints in whose frames the mesh stands, and a helper between each and its parent.
class BuildHelpers : public Workload {
 public:
  BuildHelpers(const ClipOfModel& source, bool about_centres)
      : joints_(joints_of(source.skeleton, pose_at(source, source.clip.duration_s / 2))), palette_(source.skeleton) {
    palette_.bind.assign(joints_.size(), Affine{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
    for (std::uint32_t i = source.skeleton.root_count; i < source.skeleton.joint_count; ++i)
      helpers_.push_back({source.skeleton.parents[i], static_cast<std::uint16_t>(i), 0.5f});
    if (about_centres) centres_.assign(3 * helpers_.size(), 0.01f);
    palette_.out.resize(joints_.size() + helpers_.size());
  }
  std::uint32_t items() const override { return static_cast<std::uint32_t>(joints_.size()); }
  std::uint64_t hash_output(std::uint64_t state) const override { return hash_of(palette_.out, state); }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i)
      check(build_palette(palette_.joints, palette_.bind, joints_, palette_.out, helpers_, centres_));
  }

 private:
  std::vector<Affine> joints_;
  FullPalette palette_;
  std::vector<Helper> helpers_;
  std::vector<float> centres_;
};

// Of a palette whose every entry holds a box; what the boxes are costs nothing.
class PaletteBounds : public Workload {
 public:
  explicit PaletteBounds(const ClipOfModel& source)
      : joints_(source.skeleton.joint_count, {{0.1f, 0.2f, 0.3f}, {0.1f, 0.1f, 0.1f}}),
        palette_(noise_palette(source.skeleton.joint_count)) {}
  std::uint32_t items() const override { return static_cast<std::uint32_t>(joints_.size()); }
  std::uint64_t hash_output(std::uint64_t state) const override {
    return hash_of(Span<const Bounds>(&bounds_, 1), state);
  }
  void run(std::uint64_t iterations) override {
    MeshExtents extents;
    extents.joints = joints_;
    for (std::uint64_t i = 0; i < iterations; ++i) check(palette_bounds(extents, palette_, {}, bounds_));
  }

 private:
  std::vector<JointExtent> joints_;
  std::vector<Affine> palette_;
  Bounds bounds_;
};

// A character's frame: two clips, each into a pose of its own that it keeps, half of each, to a palette.
class Frame : public Workload {
 public:
  Frame(const ClipOfModel& a, const ClipOfModel& b)
      : skeleton_(a.skeleton), clips_{a.clip, b.clip}, joints_(skeleton_.joint_count), palette_(skeleton_) {
    for (int c = 0; c < 2; ++c) {
      poses_[c].resize(skeleton_.soa_size());
      frames_[c].resize(sample_cache_bytes(clips_[c]));
      caches_[c].memory = frames_[c];
    }
    blended_.resize(skeleton_.soa_size());
  }
  std::uint32_t items() const override { return skeleton_.joint_count; }
  std::uint32_t period() const override { return 512; }
  std::uint64_t hash_output(std::uint64_t state) const override { return hash_of(palette_.out, state); }
  void run(std::uint64_t iterations) override {
    const BlendLayer layers[2] = {{poses_[0], 0.5f, {}}, {poses_[1], 0.5f, {}}};
    for (std::uint64_t i = 0; i < iterations; ++i) {
      for (int c = 0; c < 2; ++c) {
        times_s_[c] += 1.0f / 60;
        if (times_s_[c] >= clips_[c].duration_s) times_s_[c] -= clips_[c].duration_s;
        check(sample_cached(skeleton_, clips_[c], times_s_[c], poses_[c], caches_[c]));
      }
      check(blend(skeleton_, {layers, 2}, blended_));
      check(local_to_model(skeleton_, blended_, joints_));
      palette_.build(joints_);
    }
  }

 private:
  Skeleton skeleton_;
  Clip clips_[2];
  float times_s_[2] = {0, 0};
  std::vector<SoaTransform> poses_[2], blended_;
  std::vector<std::byte> frames_[2];
  SampleCache caches_[2];
  std::vector<Affine> joints_;
  FullPalette palette_;
};

// The same frame through marrow/character.h: of all skeletons and meshes of the file, each mesh with its own palette.
class CharacterFrame : public Workload {
 public:
  CharacterFrame(const File& file, const Stage& stage)
      : shared_(animations_bytes(file, file)), own_(character_bytes(file, {})) {
    check(make_animations(file, file, {shared_.data(), shared_.size()}, animations_));
    check(make_character(file, {}, {own_.data(), own_.size()}, character_));
    for (int c = 0; c < 2; ++c) layers_[c] = {find_animation(animations_, stage.clips[c]), 0, 0.5f};
  }
  std::uint32_t items() const override { return character_.skeletons[0].pose.skeleton.joint_count; }
  std::uint32_t period() const override { return 512; }
  std::uint64_t hash_output(std::uint64_t state) const override {
    for (const CharacterMesh& mesh : character_.meshes) state = hash_of(mesh.palette, state);
    return state;
  }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) {
      for (AnimationLayer& layer : layers_) {
        layer.time_s += 1.0f / 60;
        if (layer.time_s >= layer.animation->duration_s) layer.time_s -= layer.animation->duration_s;
      }
      check(pose_character(character_, layers_));
      check(finish_character(character_));
    }
  }

 private:
  AlignedBytes shared_, own_;
  Animations animations_;
  marrow::Character character_;
  AnimationLayer layers_[2];
};

}  // namespace

RowGroup pose_rows(const Models& models) {
  const Stage stage = models.has(kPab) ? kPabStage : kNewtStage;
  const auto clip = [stage](Models& from, int which) {
    return find_clip(*stage.model, from.get(*stage.model), stage.clips[which]);
  };
  RowGroup group;
  std::vector<std::string> blends;
  const auto add_row = [&](const std::string& name, auto make) {
    group.rows.push_back({name, stage.model, {stage.clips[0]}, make, stage.model != &kPab});
  };
  for (const BlendShape& shape : kBlends) {
    blends.emplace_back(shape.name);
    add_row(fmt::format("blend/{}", shape.name),
            [clip, shape](Models& from) { return std::make_unique<Blending>(clip(from, 0), shape); });
  }
  add_row("local_to_model", [clip](Models& from) { return std::make_unique<LocalToModel>(clip(from, 0)); });
  add_row("palette", [clip](Models& from) { return std::make_unique<BuildPalette>(clip(from, 0)); });
  add_row("palette_helpers", [clip](Models& from) { return std::make_unique<BuildHelpers>(clip(from, 0), false); });
  add_row("palette_centres", [clip](Models& from) { return std::make_unique<BuildHelpers>(clip(from, 0), true); });
  add_row("bounds", [clip](Models& from) { return std::make_unique<PaletteBounds>(clip(from, 0)); });
  add_row("frame", [clip](Models& from) { return std::make_unique<Frame>(clip(from, 0), clip(from, 1)); });
  group.rows.back().clips.emplace_back(stage.clips[1]);
  add_row("character",
          [stage](Models& from) { return std::make_unique<CharacterFrame>(from.get(*stage.model), stage); });
  group.rows.back().clips.emplace_back(stage.clips[1]);
  group.names =
      fmt::format("blend/{}\nlocal_to_model\npalette\npalette_helpers\npalette_centres\nbounds\nframe\ncharacter\n",
                  choice(blends));
  return group;
}

}  // namespace marrow::tools
