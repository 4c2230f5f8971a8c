// What a file's spaces of example shapes make of a character's morph weights.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/check_status.h"
#include "marrow/character.h"
#include "marrow/example_space.h"
#include "marrow/sample.h"

namespace marrow::tools {

class ShapeWeights {
 public:
  // `file` is copied. Throws Failure (invalid) if a space of it is bad.
  explicit ShapeWeights(const File& file) : file_(file), spaces_(file.example_space_count()), values_(spaces_.size()) {
    DataError error;
    for (std::uint32_t i = 0; i < spaces_.size(); ++i)
      if (file.example_space(i, spaces_[i], &error) != Status::ok)
        throw Failure(Exit::invalid, "", "@" + std::to_string(error.offset), to_string(error.status), error.rule);
  }

  const std::vector<ExampleSpace>& spaces() const { return spaces_; }

  // Parameters by name, in place of what clips say.
  void set(std::map<std::string, float> parameters) { set_ = std::move(parameters); }

  // A parameter of a space as it was set, or as the layers have it: channels of their clips, blended as morph weights
  // are.
  float parameter(std::size_t space, std::size_t index, std::span<const AnimationLayer> layers) const {
    const ExampleParameter& p = spaces_[space].parameters[index];
    if (const auto set = set_.find(file_.text(p.name)); set != set_.end()) return set->second;
    float total = 0;
    for (const AnimationLayer& layer : layers) total += layer.weight;
    const float rest = std::max(kRestThreshold - total, 0.0f);
    float out = rest / (total + rest) * p.rest;
    for (const AnimationLayer& layer : layers)
      if (layer.weight > 0) out += layer.weight / (total + rest) * sampled(layer, file_.text(p.name), p.rest);
    return out;
  }

  // Writes the weights of each mesh of each space, for between pose_character() and finish_character().
  void write(std::span<const AnimationLayer> layers, marrow::Character& character) {
    for (std::size_t s = 0; s < spaces_.size(); ++s) {
      const ExampleSpace& space = spaces_[s];
      for (std::size_t i = 0; i < space.parameters.size; ++i) values_[s][i] = parameter(s, i, layers);
      for (const std::uint32_t mesh : space.meshes)
        check(evaluate_examples(space, {values_[s].data(), space.parameters.size}, character.meshes[mesh].weights));
    }
  }

  // A parameter as the last write() had it.
  float value(std::size_t space, std::size_t index) const { return values_[space][index]; }

 private:
  // Of the first of the animation's clips that has a channel of this name; else `rest`.
  static float sampled(const AnimationLayer& layer, const char* name, float rest) {
    for (const std::uint32_t index : layer.animation->clip_of_skeleton) {
      if (index == kNoClip) continue;
      Clip clip = layer.animation->clips.clip(index);
      const std::uint32_t channel = layer.animation->clips.find_channel(clip, name);
      if (channel == clip.channels.size) continue;
      clip.channels = {clip.channels.data + channel, 1};
      float value = 0;
      check(sample_channels(clip, layer.time_s, {&value, 1}));
      return value;
    }
    return rest;
  }

  File file_;
  std::vector<ExampleSpace> spaces_;
  std::vector<std::array<float, kMaxExampleParameters>> values_;
  std::map<std::string, float> set_;
};

}  // namespace marrow::tools
