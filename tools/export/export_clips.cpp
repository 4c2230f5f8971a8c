// Clips become animations: raw tracks as they are, coded ones sampled by the runtime at the clip's own frames.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <set>

#include "common/failure.h"
#include "export/export_parts.h"
#include "export/weight_keys.h"
#include "marrow/morph.h"
#include "marrow/sample.h"

namespace marrow::tools {
namespace {

constexpr const char* kPaths[] = {"translation", "rotation", "scale"};
constexpr const char* kInterpolations[] = {"STEP", "LINEAR", "CUBICSPLINE"};

const float (*lanes_of(const SoaTransform& four, TrackPath path))[4] {
  return path == TrackPath::translation ? four.translation : path == TrackPath::rotation ? four.rotation : four.scale;
}

std::size_t components_of(TrackPath path) {
  return path == TrackPath::rotation ? 4 : 3;
}

class ClipExport {
 public:
  ClipExport(ExportScene& scene, const File& from, const ExportedClips::One& one)
      : scene_(scene),
        from_(from),
        clip_(from.clip(one.clip)),
        skeleton_(scene.file.skeleton(one.skeleton)),
        nodes_(scene.joint_nodes[one.skeleton]) {}

  // Adds to an animation, which the clips of several skeletons may share.
  void run(Json& animation) {
    add_tracks();
    if (clip_.coded.frame_count > 0) add_coded();
    add_weights();
    add_channels();
    if (longest_s_ < clip_.duration_s || channels_.empty()) add_end();
    if (*clip_.name != '\0') animation["name"] = clip_.name;
    const std::size_t before = animation["samplers"].size();
    for (Json& channel : channels_) {
      channel["sampler"] = channel["sampler"].get<std::size_t>() + before;
      animation["channels"].push_back(std::move(channel));
    }
    for (Json& sampler : samplers_) animation["samplers"].push_back(std::move(sampler));
    if (clip_.additive) animation["extras"] = {{"additive", reference()}};
  }

 private:
  std::size_t times(const std::vector<float>& seconds) {
    longest_s_ = std::max(longest_s_, seconds.back());
    const auto [at, is_new] = time_accessors_.try_emplace(seconds, 0u);
    if (is_new) at->second = scene_.glb.add_bounded(seconds, kScalar, Target::none);
    return at->second;
  }

  // A spline of one key, which glTF does not allow, is that key's value.
  void add_channel(Json target, const std::vector<float>& seconds, std::vector<float> values, AccessorType type,
                   Interpolation interpolation) {
    if (interpolation == Interpolation::cubic_spline && seconds.size() == 1) {
      const auto each = static_cast<std::ptrdiff_t>(values.size() / 3);
      values = {values.begin() + each, values.begin() + 2 * each};
      interpolation = Interpolation::step;
    }
    const std::size_t input = times(seconds);
    const std::size_t output = scene_.glb.add_accessor(values, Component::f32, type, Target::none);
    samplers_.push_back({{"input", input},
                         {"interpolation", kInterpolations[static_cast<std::size_t>(interpolation)]},
                         {"output", output}});
    channels_.push_back({{"sampler", samplers_.size() - 1}, {"target", std::move(target)}});
  }

  void add_path(std::uint32_t joint, TrackPath path, const std::vector<float>& seconds,
                const std::vector<float>& values, Interpolation interpolation) {
    add_channel({{"node", nodes_[joint]}, {"path", kPaths[static_cast<std::size_t>(path)]}}, seconds, values,
                path == TrackPath::rotation ? kVec4 : kVec3, interpolation);
  }

  // Keys as they stand. Of two tracks that move the same the last counts, as when sampled.
  void add_tracks() {
    for (const Track& track : clip_.tracks) last_[{track.joint, track.path}] = &track;
    for (const Track& track : clip_.tracks) {
      if (last_[{track.joint, track.path}] != &track) continue;
      const float* const t = clip_.times_s + track.first_time;
      const float* const v = clip_.values + track.first_value;
      const std::size_t each = components_of(track.path) * (track.interpolation == Interpolation::cubic_spline ? 3 : 1);
      add_path(track.joint, track.path, {t, t + track.key_count}, {v, v + track.key_count * each}, track.interpolation);
    }
  }

  // Additive clips are whole poses too; what makes them changes is their reference.
  std::vector<SoaTransform> pose(float time_s) const {
    Clip poses = clip_;
    poses.additive = false;
    std::vector<SoaTransform> out(skeleton_.soa_size());
    if (sample(skeleton_, poses, time_s, out) != Status::ok)
      throw Failure(Exit::internal, scene_.name, "", "a clip that was loaded cannot be sampled", "please report this");
    return out;
  }

  std::vector<float> frame_times() const {
    const CodedTracks& coded = clip_.coded;
    std::vector<float> out;
    for (std::uint32_t f = 0; f < coded.frame_count; ++f) {
      const double time_s =
          static_cast<double>(coded.start_s) + static_cast<double>(f) / static_cast<double>(coded.frames_per_s);
      const float rounded = coded.times_s != nullptr ? coded.times_s[f] : static_cast<float>(time_s);
      if (!std::isfinite(rounded) || (f > 0 && !(rounded > out.back())))
        throw Failure(Exit::unsupported, scene_.name, "",
                      "clip \"" + std::string(clip_.name) + "\": frames too near to each other",
                      "glTF wants ascending finite times");
      out.push_back(rounded);
    }
    // But for rounding the last frame is the end.
    const double step_s = 1 / static_cast<double>(coded.frames_per_s);
    if (std::fabs(static_cast<double>(out.back()) - static_cast<double>(clip_.duration_s)) < 1e-3 * step_s)
      out.back() = clip_.duration_s;
    return out;
  }

  // One value a frame; neighbouring rotations in one hemisphere.
  static void append(const SoaTransform& four, std::size_t lane, TrackPath path, std::vector<float>& values) {
    const auto lanes = lanes_of(four, path);
    float sign = 1, dot = 0;
    if (path == TrackPath::rotation && !values.empty()) {
      for (std::size_t c = 0; c < 4; ++c) dot += lanes[c][lane] * values[values.size() - 4 + c];
      sign = dot < 0 ? -1.0f : 1.0f;
    }
    for (std::size_t c = 0; c < components_of(path); ++c) values.push_back(sign * lanes[c][lane]);
  }

  void add_coded() {
    const std::vector<float> seconds = frame_times();
    std::vector<std::vector<SoaTransform>> frames;
    for (const float time_s : seconds) frames.push_back(pose(time_s));
    // Bits of the masks: rotations first.
    constexpr std::array kOrder = {TrackPath::rotation, TrackPath::translation, TrackPath::scale};
    for (std::uint32_t j = 0; j < skeleton_.joint_count; ++j) {
      const GroupMasks& masks = clip_.coded.masks[j / 4];
      for (std::uint32_t p = 0; p < 3; ++p) {
        const std::uint32_t bit = 4 * p + j % 4;
        const bool moving = (std::uint32_t{masks.moving} >> bit & 1u) != 0;
        const bool constant = (std::uint32_t{masks.constant} >> bit & 1u) != 0;
        if ((!moving && !constant) || last_.contains({static_cast<std::uint16_t>(j), kOrder[p]})) continue;
        std::vector<float> values;
        for (std::size_t f = 0; f < (moving ? frames.size() : 1); ++f)
          append(frames[f][j / 4], j % 4, kOrder[p], values);
        add_path(j, kOrder[p], moving ? seconds : std::vector<float>{seconds.front()}, values, Interpolation::linear);
      }
    }
  }

  // Numbers that drive morph targets: all weights of a node together.
  void add_weights() {
    for (const MorphedNode& morphed : scene_.morphed) {
      std::vector<std::uint32_t> driving;
      bool any = false;
      for (const std::string& name : morphed.channels) {
        const std::uint32_t found = from_.find_channel(clip_, name.c_str());
        driving.push_back(found < clip_.channels.size ? found : kNoChannel);
        if (driving.back() == kNoChannel) continue;
        any = true;
        drives_target_.insert(found);
      }
      if (!any) continue;
      const WeightKeys keys = weight_keys(clip_, driving, morphed.weights);
      add_channel({{"node", morphed.node}, {"path", "weights"}}, keys.times_s, keys.values, kScalar,
                  keys.interpolation);
    }
  }

  // Other numbers that move no joint drive the document's own extras, where cooking finds them again under the same
  // names.
  void add_channels() {
    for (std::uint32_t i = 0; i < clip_.channels.size; ++i) {
      if (drives_target_.contains(i)) continue;
      const Channel& channel = clip_.channels[i];
      const std::string name = from_.text(channel.name);
      scene_.glb.json["extras"].emplace(name, number(channel.rest));
      std::string escaped;
      for (const char c : name) escaped += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
      const float* const t = clip_.times_s + channel.first_time;
      const float* const v = clip_.values + channel.first_value;
      const std::size_t each = channel.interpolation == Interpolation::cubic_spline ? 3 : 1;
      add_channel(
          {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", "/extras/" + escaped}}}}}},
          {t, t + channel.key_count}, {v, v + channel.key_count * each}, kScalar, channel.interpolation);
      scene_.glb.use_extension("KHR_animation_pointer");
    }
  }

  // A clip is as long as its last key, and glTF wants one: the first joint's rest.
  void add_end() {
    std::uint32_t joint = 0;
    while (joint < skeleton_.joint_count && moves(joint)) ++joint;
    if (joint == skeleton_.joint_count) return;  // every translation moves, and has its own end
    std::vector<float> values;
    append(skeleton_.rest[joint / 4], joint % 4, TrackPath::translation, values);
    add_path(joint, TrackPath::translation, {clip_.duration_s}, values, Interpolation::linear);
  }
  bool moves(std::uint32_t joint) const {
    const std::string path = kPaths[0];
    const std::size_t node = nodes_[joint];
    return std::any_of(channels_.begin(), channels_.end(), [&](const Json& channel) {
      return channel["target"].value("node", SIZE_MAX) == node && channel["target"]["path"] == path;
    });
  }

  // "rest", or the pose that changes are taken from: translation, rotation and scale of each node.
  Json reference() const {
    if (clip_.reference == nullptr) return "rest";
    Json out = Json::array();
    for (std::uint32_t j = 0; j < skeleton_.joint_count; ++j) {
      Json joint = {{"node", nodes_[j]}};
      for (const TrackPath path : {TrackPath::translation, TrackPath::rotation, TrackPath::scale}) {
        std::vector<float> values;
        append(clip_.reference[j / 4], j % 4, path, values);
        joint[kPaths[static_cast<std::size_t>(path)]] = numbers(values);
      }
      out.push_back(joint);
    }
    return out;
  }

  ExportScene& scene_;
  const File& from_;
  Clip clip_;
  Skeleton skeleton_;
  const std::vector<std::size_t>& nodes_;  // of its joints
  Json channels_ = Json::array(), samplers_ = Json::array();
  std::map<std::pair<std::uint16_t, TrackPath>, const Track*> last_;
  std::map<std::vector<float>, std::size_t> time_accessors_;
  std::set<std::uint32_t> drives_target_;  // channels
  float longest_s_ = 0;
};

}  // namespace

// The cooker makes a clip a skeleton of an animation, one after the other, as long as each other.
void export_clips(ExportScene& scene, const ExportedClips& clips) {
  for (std::size_t i = 0; i < clips.clips.size();) {
    Json animation = {{"samplers", Json::array()}, {"channels", Json::array()}};
    const Clip first = clips.from.clip(clips.clips[i].clip);
    std::uint32_t last = first.skeleton;
    ClipExport(scene, clips.from, clips.clips[i]).run(animation);
    for (++i; i < clips.clips.size(); ++i) {
      const Clip next = clips.from.clip(clips.clips[i].clip);
      if (std::strcmp(next.name, first.name) != 0 || next.skeleton <= last || next.additive != first.additive ||
          next.duration_s != first.duration_s)
        break;
      last = next.skeleton;
      ClipExport(scene, clips.from, clips.clips[i]).run(animation);
    }
    scene.glb.add("animations", animation);
  }
}

}  // namespace marrow::tools
