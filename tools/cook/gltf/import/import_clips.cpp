// Imports animations as clips whose keys a sampler can stand on.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "asset/format.h"
#include "common/elementary.h"
#include "cook/gltf/import/import.h"

namespace marrow::cook::gltf {
namespace {

constexpr float kLongestClip_s = 86'400;  // a day; longer ones are mistakes that cost gigabytes when resampled
constexpr float kShortestStep_s = 1e-6F;  // keys nearer to one another are the two sides of a jump
constexpr float kLeastApart_s = 1e-9F;    // of the sides, where floats are finer: slopes stay far from infinite
constexpr double kKeySlack = 0.02;        // an 8-bit quaternion is off by about one part in 127
constexpr double kSmallestKey = 1e-6;

struct Key {
  std::size_t index;  // in the source
  float time_s;
};

class ChannelImporter {
 public:
  ChannelImporter(const Document& document, const tinygltf::Animation& animation, const std::string& where,
                  Budget& budget, Report& report)
      : document_(document), animation_(animation), where_(where), budget_(budget), report_(report) {}

  RawChannel import(const tinygltf::AnimationChannel& channel) {
    const tinygltf::AnimationSampler& sampler = sampler_of(channel);
    RawChannel raw;
    raw.node = channel.target_node;
    raw.path = channel.target_path == "translation" ? RawPath::translation
               : channel.target_path == "rotation"  ? RawPath::rotation
                                                    : RawPath::scale;
    raw.interpolation = interpolation_of(sampler);
    const std::vector<Key> keys = usable_keys(document_.accessor(sampler.input));
    for (const Key& key : keys) raw.times_s.push_back(key.time_s);
    raw.values = values_of(document_.accessor(sampler.output), keys, raw);
    return raw;
  }

  // One number a target of the mesh at `node`, or one of no node; a key holds those of all targets, for a spline first
  // their in-tangents, then their values, then their out-tangents (glTF 2.0, section 3.11).
  std::vector<RawScalar> import_scalars(const tinygltf::AnimationChannel& channel,
                                        const std::vector<RawTargetWeight>& targets, int node) {
    const tinygltf::AnimationSampler& sampler = sampler_of(channel);
    const std::vector<Key> keys = usable_keys(document_.accessor(sampler.input));
    const std::vector<float> all = read(document_.accessor(sampler.output), under(sampler_where_, "output"));
    std::vector<RawScalar> out;
    for (std::size_t t = 0; t < targets.size() && !keys.empty(); ++t) {
      RawScalar raw;
      raw.name = clean_name(targets[t].channel, where_, report_);
      raw.rest = targets[t].rest;
      raw.node = node;
      raw.interpolation = interpolation_of(sampler);
      const std::size_t parts = raw.interpolation == RawInterpolation::cubic_spline ? 3 : 1;
      for (const Key& key : keys) {
        raw.times_s.push_back(key.time_s);
        for (std::size_t part = 0; part < parts; ++part)
          raw.values.push_back(all[(key.index * parts + part) * targets.size() + t]);
      }
      out.push_back(std::move(raw));
    }
    return out;
  }

 private:
  const tinygltf::AnimationSampler& sampler_of(const tinygltf::AnimationChannel& channel) {
    const auto index = to_index(channel.sampler);
    sampler_where_ = under(where_, "samplers", index);
    return animation_.samplers[index];
  }

  static RawInterpolation interpolation_of(const tinygltf::AnimationSampler& sampler) {
    return sampler.interpolation == "STEP"          ? RawInterpolation::step
           : sampler.interpolation == "CUBICSPLINE" ? RawInterpolation::cubic_spline
                                                    : RawInterpolation::linear;
  }

  std::vector<float> read(const Accessor& accessor, const std::string& where,
                          float most = std::numeric_limits<float>::max()) {
    budget_.take(accessor.count * accessor.components() * 8, where, report_);
    std::vector<float> values = read_floats(accessor);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::abs(values[i]) <= most) continue;  // false for NaN too
      report_.invalid(where, std::isfinite(values[i]) ? "a number beyond 1e12" : "not a finite number",
                      "key " + std::to_string(i / accessor.components()) + "; export again");
    }
    return values;
  }

  // The last moment before a time that a key can have.
  static float before(float time_s) { return std::min(std::nextafter(time_s, -1.0F), time_s - kLeastApart_s); }

  // Keys at one time, or nearly, are a jump: the first is where the curve ends before it, the last where it goes on.
  std::vector<Key> usable_keys(const Accessor& input) {
    const std::string where = under(sampler_where_, "input");
    const std::vector<float> times = read(input, where);
    const auto count = static_cast<std::size_t>(
        std::find_if(times.begin(), times.end(), [](float t) { return t > kLongestClip_s; }) - times.begin());
    std::vector<Key> keys;
    std::size_t at_one_time = 0;
    for (std::size_t first = 0, last = 0; first < count; first = ++last) {
      while (last + 1 < count && times[last + 1] - times[first] < kShortestStep_s) ++last;
      const bool one_time = last > first && times[last] - times[first] < kLeastApart_s;
      const float time_s = one_time ? times[first] : times[last], side_s = one_time ? before(time_s) : times[first];
      const bool has_side = last > first && side_s >= 0 && (keys.empty() || keys.back().time_s < side_s);
      if (has_side) keys.push_back({first, side_s});
      keys.push_back({last, time_s});
      at_one_time += has_side && one_time;
    }
    if (count < times.size()) {
      report_.mend(where, "keys-too-late",
                   std::to_string(times.size() - count) + " keys are more than a day after the start; left out");
    }
    if (!input.has_data()) return keys;  // zeros stand for a buffer that is not there, and are no finding
    if (at_one_time > 0) {
      report_.mend(where, "keys-at-one-time",
                   std::to_string(at_one_time) + " keys are at the time of the next; both sides of the jump are kept");
    }
    if (keys.size() < count) {
      report_.mend(where, "keys-too-close",
                   std::to_string(count - keys.size()) + " keys are less than a microsecond from others; left out");
    }
    return keys;
  }

  std::vector<glm::vec4> values_of(const Accessor& output, const std::vector<Key>& keys, const RawChannel& raw) {
    const std::size_t per_key = raw.interpolation == RawInterpolation::cubic_spline ? 3 : 1;
    std::vector<float> all = read(output, under(sampler_where_, "output"), format::kFarthest);
    if (raw.path == RawPath::rotation && output.has_data()) mend_rotations(all, per_key);
    const std::size_t components = output.components();
    std::vector<glm::vec4> values;
    values.reserve(keys.size() * per_key);
    for (const Key& key : keys) {
      for (std::size_t part = 0; part < per_key; ++part) {
        glm::vec4 value(0);
        const float* from = &all[(key.index * per_key + part) * components];
        for (std::size_t c = 0; c < components; ++c) value[static_cast<int>(c)] = from[c];
        values.push_back(value);
      }
    }
    return values;
  }

  // Small drift is the sampler's to normalise. A quaternion far from unit length is a mistake, and would turn at the
  // wrong speed; a spline's tangents are in the same units and shrink with it.
  void mend_rotations(std::vector<float>& numbers, std::size_t per_key) {
    std::size_t mended = 0;
    for (std::size_t first = 0; first < numbers.size(); first += per_key * 4) {
      float* value = &numbers[first + per_key / 2 * 4];
      const auto part = [&](int c) { return static_cast<double>(value[c]); };
      const double length = tools::length_of(part(0), part(1), part(2), part(3));
      if (std::abs(length - 1) <= kKeySlack) continue;
      ++mended;
      if (length < kSmallestKey) {
        value[3] = 1;
        continue;
      }
      const auto scale = static_cast<float>(1 / length);
      std::for_each_n(&numbers[first], per_key * 4, [scale](float& number) { number *= scale; });
    }
    if (mended == 0) return;
    report_.mend(under(sampler_where_, "output"), "rotation-keys-not-unit",
                 std::to_string(mended) + " rotations were not of unit length; normalised");
  }

  const Document& document_;
  const tinygltf::Animation& animation_;
  std::string where_;
  Budget& budget_;
  Report& report_;
  std::string sampler_where_;
};

bool same_keys(const auto& a, const auto& b) {
  return a.interpolation == b.interpolation && a.times_s == b.times_s && a.values == b.values;
}

// What a property's channel before said is said once: the same again is left out, anything else refused.
class Said {
 public:
  Said(const std::string& where, Report& report) : where_(where), report_(report) {}

  // Appends what a channel came to, unless the clip has it.
  template <class T>
  void append(std::size_t channel, std::string property, int node, std::vector<T> all, std::vector<T>& to) {
    if (all.empty()) return;
    const auto [place, is_new] = first_.try_emplace({node, std::move(property)}, to.size());
    if (is_new) {
      std::ranges::move(all, std::back_inserter(to));
      return;
    }
    const std::string target = under(under(where_, "channels", channel), "target");
    if (!std::equal(all.begin(), all.end(), to.begin() + static_cast<std::ptrdiff_t>(place->second), same_keys<T, T>))
      report_.invalid(target, "target animated twice", "one channel a property; export again");
    report_.mend(target, "channel-twice", "it says what a channel before it says; left out");
  }

 private:
  std::string where_;
  Report& report_;
  std::map<std::pair<int, std::string>, std::size_t> first_;
};

constexpr std::size_t kMostEvents = 4096;

// A list of texts, or one text.
std::vector<tools::EventText> import_events(const Json& events, const std::string& where, Report& report) {
  std::vector<tools::EventText> out;
  const Json all = events.is_array() ? events : events.is_null() ? Json::array() : Json::array({events});
  for (std::size_t i = 0; i < all.size(); ++i) {
    tools::EventText event;
    if (out.size() == kMostEvents) {
      report.mend(where, "event-left-out", "a clip has at most " + std::to_string(kMostEvents) + " events");
      break;
    }
    if (all[i].is_string() && read_event(all[i].get<std::string>(), event)) {
      out.push_back(std::move(event));
    } else {
      report.mend(events.is_array() ? under(where, i) : where, "event-left-out",
                  "no event, as \"hit@0.35\" or \"swing@0.2..0.5\"");
    }
  }
  return out;
}

}  // namespace

std::vector<RawClip> import_clips(const Document& document, const NodeGraph& graph, const std::vector<RawNode>& nodes,
                                  Budget& budget, Report& report) {
  const std::vector<std::string> owners = weight_owners(document, nodes);
  std::size_t left_out = 0;
  std::vector<RawClip> clips;
  for (std::size_t a = 0; a < document.model.animations.size(); ++a) {
    const tinygltf::Animation& animation = document.model.animations[a];
    const std::string where = pointer("animations", a);
    RawClip clip;
    clip.name = clean_name(animation.name, where, report);
    if (a < document.clip_events.size())
      clip.events = import_events(document.clip_events[a], where + "/extras/marrow/events", report);
    ChannelImporter importer(document, animation, where, budget, report);
    Said said(where, report);
    for (std::size_t c = 0; c < animation.channels.size(); ++c) {
      const tinygltf::AnimationChannel& channel = animation.channels[c];
      if (channel.target_path.empty()) continue;
      const auto number = document.user_numbers.find({a, c});
      const bool is_number = number != document.user_numbers.end(),
                 is_weights = !is_number && channel.target_path == "weights";
      const auto node = to_index(channel.target_node);
      if (!is_number && !(is_weights ? graph.drawn : graph.in_scene)[node]) {
        ++left_out;
        continue;
      }
      if (is_number || is_weights) {
        std::vector<RawScalar> scalars = importer.import_scalars(
            channel,
            is_weights ? node_weights(document, owners, channel.target_node, where, report)
                       : std::vector<RawTargetWeight>{{"", number->second.name, number->second.rest}},
            is_weights ? channel.target_node : kNone);
        said.append(c, is_number ? number->second.pointer : channel.target_path,
                    is_number ? kNone : channel.target_node, std::move(scalars), clip.scalars);
        continue;
      }
      RawChannel raw = importer.import(channel);
      if (!raw.times_s.empty())
        said.append(c, channel.target_path, channel.target_node, std::vector{std::move(raw)}, clip.channels);
    }
    if (clip.channels.empty() && clip.scalars.empty()) {
      report.warn(where, "clip-dropped", "no channel is left that moves a node or a number");
      continue;
    }
    clips.push_back(std::move(clip));
  }
  if (left_out > 0)
    report.warn("/animations", "channels-left-out",
                std::to_string(left_out) + " channels move what is left out of the scene");
  return clips;
}

}  // namespace marrow::cook::gltf
