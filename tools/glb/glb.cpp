#include "glb/glb.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <limits>

#include "common/failure.h"

namespace marrow::tools {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian");

void append(std::string& to, std::uint32_t word) {
  to.append(reinterpret_cast<const char*>(&word), 4);
}

void append_chunk(std::string& to, std::uint32_t type, const std::string& data, char padding) {
  const std::size_t padded = (data.size() + 3) / 4 * 4;
  append(to, static_cast<std::uint32_t>(padded));
  append(to, type);
  to += data;
  to.append(padded - data.size(), padding);
}

std::size_t bytes_of(Component component) {
  return component == Component::u8 ? 1 : component == Component::u16 ? 2 : 4;
}

}  // namespace

Json number(float value) {
  char text[32];
  const auto written = std::to_chars(text, text + sizeof text, value);
  double shortest = 0;
  std::from_chars(text, written.ptr, shortest);
  return shortest;
}

Json numbers(const std::vector<float>& values) {
  Json out = Json::array();
  for (const float value : values) out.push_back(number(value));
  return out;
}

Glb::Glb(const char* generator) {
  json["asset"] = {{"version", "2.0"}, {"generator", generator}};
}

void Glb::use_extension(const char* name) {
  Json& used = json["extensionsUsed"];
  if (std::find(used.begin(), used.end(), name) == used.end()) used.push_back(name);
}

std::size_t Glb::add(const char* list, Json element) {
  Json& elements = json[list];
  elements.push_back(std::move(element));
  return elements.size() - 1;
}

std::size_t Glb::add_view(const void* data, std::size_t bytes, Target target) {
  data_.append((4 - data_.size() % 4) % 4, '\0');
  Json view = {{"buffer", 0}, {"byteOffset", data_.size()}, {"byteLength", bytes}};
  if (target != Target::none) view["target"] = static_cast<int>(target);
  data_.append(static_cast<const char*>(data), bytes);
  return add("bufferViews", view);
}

std::size_t Glb::add_bytes(const void* data, std::size_t bytes, Component component, AccessorType type, Target target,
                           bool normalised) {
  Json accessor = {{"bufferView", add_view(data, bytes, target)},
                   {"componentType", static_cast<int>(component)},
                   {"count", bytes / (bytes_of(component) * type.parts)},
                   {"type", type.name}};
  if (normalised) accessor["normalized"] = true;
  return add("accessors", accessor);
}

std::size_t Glb::add_bounded(const std::vector<float>& values, AccessorType type, Target target) {
  std::vector<float> low(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(type.parts)), high = low;
  for (std::size_t i = 0; i < values.size(); ++i) {
    low[i % type.parts] = std::min(low[i % type.parts], values[i]);
    high[i % type.parts] = std::max(high[i % type.parts], values[i]);
  }
  const std::size_t accessor = add_accessor(values, Component::f32, type, target);
  json["accessors"][accessor]["min"] = numbers(low);
  json["accessors"][accessor]["max"] = numbers(high);
  return accessor;
}

std::size_t Glb::add_sparse(std::size_t count, const std::vector<std::uint32_t>& at, const std::vector<float>& values,
                            AccessorType type) {
  const float start = at.size() < count ? 0.0f : std::numeric_limits<float>::infinity();
  std::vector<float> low(type.parts, start), high(type.parts, -start);
  for (std::size_t i = 0; i < values.size(); ++i) {
    low[i % type.parts] = std::min(low[i % type.parts], values[i]);
    high[i % type.parts] = std::max(high[i % type.parts], values[i]);
  }
  for (float& h : high) h += 0.0f;  // no negative zero
  const Json indices = {{"bufferView", add_view(at.data(), at.size() * 4, Target::none)},
                        {"componentType", static_cast<int>(Component::u32)}};
  const Json changes = {{"bufferView", add_view(values.data(), values.size() * 4, Target::none)}};
  return add("accessors", {{"componentType", static_cast<int>(Component::f32)},
                           {"count", count},
                           {"type", type.name},
                           {"min", numbers(low)},
                           {"max", numbers(high)},
                           {"sparse", {{"count", at.size()}, {"indices", indices}, {"values", changes}}}});
}

std::string Glb::finish(const std::string& file) {
  if (!data_.empty()) json["buffers"] = Json::array({{{"byteLength", data_.size()}}});
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  const std::size_t total = 12 + 8 + (text.size() + 3) / 4 * 4 + (data_.empty() ? 0 : 8 + (data_.size() + 3) / 4 * 4);
  if (total > UINT32_MAX)
    throw Failure(Exit::unsupported, file, "", "too large for glTF", "a GLB file holds at most 4 GiB");
  std::string out;
  out.reserve(total);
  append(out, 0x46546C67);  // "glTF"
  append(out, 2);
  append(out, static_cast<std::uint32_t>(total));
  append_chunk(out, 0x4E4F534A, text, ' ');                        // "JSON"
  if (!data_.empty()) append_chunk(out, 0x004E4942, data_, '\0');  // "BIN"
  return out;
}

}  // namespace marrow::tools
