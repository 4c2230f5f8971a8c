// Rules about animations: samplers, channels and the formats of their accessors.
#include <cmath>

#include "cook/gltf/rules/rules.h"

namespace marrow::cook::gltf {
namespace {

class AnimationChecker {
 public:
  AnimationChecker(const Document& document, std::size_t index, std::vector<bool>& times_checked, Report& report)
      : document_(document),
        animation_(document.model.animations[index]),
        index_(index),
        where_(pointer("animations", index)),
        times_checked_(times_checked),
        report_(report) {}

  void check() {
    for (std::size_t s = 0; s < animation_.samplers.size(); ++s) check_sampler(s);
    for (std::size_t c = 0; c < animation_.channels.size(); ++c) {
      const tinygltf::AnimationChannel& channel = animation_.channels[c];
      if (channel.target_path.empty()) continue;  // left out already
      const std::string where = under(where_, "channels", c);
      if (channel.sampler < 0 || static_cast<std::size_t>(channel.sampler) >= animation_.samplers.size()) {
        report_.invalid(under(where, "sampler"), "reference to nothing",
                        "the animation has " + std::to_string(animation_.samplers.size()) + " samplers; export again");
      }
      const auto number = document_.user_numbers.find({index_, c});
      const bool is_number = number != document_.user_numbers.end();
      is_number ? check_number(channel, where) : check_channel(channel, where);
      if (accessor(animation_.samplers[static_cast<std::size_t>(channel.sampler)].input).count == 0)
        report_.mend(under(where, "sampler"), "channel-without-keys", "it moves nothing; left out");
    }
  }

 private:
  const Accessor& accessor(int index) const { return document_.accessors[static_cast<std::size_t>(index)]; }

  void refuse_stride(const Accessor& data, const std::string& where) {
    if (data.view < 0 || document_.buffers.views[static_cast<std::size_t>(data.view)].stride == 0) return;
    report_.mend(where, "stride-not-allowed", "only vertex data may have a byteStride; honoured all the same");
  }

  void check_sampler(std::size_t index) {
    const tinygltf::AnimationSampler& sampler = animation_.samplers[index];
    const std::string where = under(where_, "samplers", index);
    const Accessor& input = accessor(sampler.input);
    const std::string input_where = under(where, "input");
    if (input.shape != Shape::scalar || input.component != Component::f32) {
      report_.invalid(input_where, "wrong accessor", "times are float scalars; export again");
    }
    if (input.count == 0) return;
    if (!input.has_bounds) report_.mend(input_where, "bounds-missing", "times need min and max; computed instead");
    if (sampler.interpolation == "CUBICSPLINE" && input.count < 2) {
      report_.mend(input_where, "too-few-keys", "a cubic spline needs two keys; held at the one there is");
    }
    check_times(sampler.input, input_where);
    refuse_stride(input, input_where);
    refuse_stride(accessor(sampler.output), under(where, "output"));
  }

  // Equal times are left to the import, which can mend them.
  void check_times(int index, const std::string& where) {
    if (times_checked_[static_cast<std::size_t>(index)]) return;
    times_checked_[static_cast<std::size_t>(index)] = true;
    const Accessor& input = accessor(index);
    if (!input.has_data()) return;
    ElementReader reader(input);
    double previous = 0;
    for (std::uint64_t i = 0; i < input.count; ++i) {
      double time = 0;
      reader.read_raw(i, &time);
      const std::string which = "key " + std::to_string(i);
      if (!std::isfinite(time)) report_.invalid(where, "not a finite number", which + "; export again");
      if (time < 0) report_.invalid(where, "negative time", which + "; export again");
      if (time < previous) report_.invalid(where, "times must increase", which + "; export again");
      previous = time;
    }
  }

  void check_channel(const tinygltf::AnimationChannel& channel, const std::string& where) {
    const tinygltf::AnimationSampler& sampler = animation_.samplers[static_cast<std::size_t>(channel.sampler)];
    const tinygltf::Node& node = document_.model.nodes[static_cast<std::size_t>(channel.target_node)];
    const Accessor& output = accessor(sampler.output);
    const std::string sampler_where = under(where, "sampler");
    const bool is_weights = channel.target_path == "weights";
    const bool is_rotation = channel.target_path == "rotation";
    const Shape shape = is_weights ? Shape::scalar : is_rotation ? Shape::vec4 : Shape::vec3;
    const bool integer_allowed = is_weights || is_rotation;
    if (output.shape != shape || (output.component != Component::f32 && !(integer_allowed && output.normalised))) {
      report_.invalid(sampler_where, "wrong output accessor", "see glTF 2.0, section 3.11; export again");
    }
    std::uint64_t factor = sampler.interpolation == "CUBICSPLINE" ? 3 : 1;
    if (is_weights) factor *= check_morph_target(node, under(where, "target"));
    if (factor != 0) check_count(sampler, factor, sampler_where);
    if (!is_weights && !node.matrix.empty()) {
      report_.mend(under(where, "target"), "animated-matrix", "an animated node has no matrix; it is decomposed");
    }
  }

  // Whole numbers stand for themselves, as KHR_animation_pointer has it.
  void check_number(const tinygltf::AnimationChannel& channel, const std::string& where) {
    const tinygltf::AnimationSampler& sampler = animation_.samplers[static_cast<std::size_t>(channel.sampler)];
    const std::string sampler_where = under(where, "sampler");
    if (accessor(sampler.output).shape != Shape::scalar) {
      report_.invalid(sampler_where, "wrong output accessor", "a number needs scalars; export again");
    }
    check_count(sampler, sampler.interpolation == "CUBICSPLINE" ? 3 : 1, sampler_where);
  }

  void check_count(const tinygltf::AnimationSampler& sampler, std::uint64_t values_a_key, const std::string& where) {
    const std::uint64_t count = accessor(sampler.output).count, needed = accessor(sampler.input).count * values_a_key;
    if (count == needed) return;
    report_.invalid(where, "times and values differ in count",
                    std::to_string(count) + " values where " + std::to_string(needed) + " are needed; export again");
  }

  // How many weights a key has.
  std::size_t check_morph_target(const tinygltf::Node& node, const std::string& where) {
    const std::size_t count =
        node.mesh < 0 ? 0 : target_count(document_.model.meshes[static_cast<std::size_t>(node.mesh)]);
    if (count == 0) report_.mend(where, "no-morph-targets", "the node has no morph targets to animate; left out");
    return count;
  }

  const Document& document_;
  const tinygltf::Animation& animation_;
  std::size_t index_;
  std::string where_;
  std::vector<bool>& times_checked_;  // by accessor: samplers share them by the hundred
  Report& report_;
};

}  // namespace

void check_animations(const Document& document, Report& report) {
  std::vector<bool> times_checked(document.accessors.size());
  for (std::size_t i = 0; i < document.model.animations.size(); ++i) {
    AnimationChecker(document, i, times_checked, report).check();
  }
}

}  // namespace marrow::cook::gltf
