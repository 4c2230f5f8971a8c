// glTF documents made in memory, a fault at a time, and what reading them must give.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/failure.h"
#include "cook/gltf/read.h"

namespace marrow::cook {

using Json = nlohmann::json;
using tools::Exit;
using tools::Failure;

inline constexpr int kI8 = 5120, kU8 = 5121, kI16 = 5122, kU16 = 5123, kU32 = 5125, kF32 = 5126;
inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

inline std::string base64(std::span<const std::byte> bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t b = 0; b < 3; ++b) {
      bits = bits << 8 | (i + b < bytes.size() ? std::to_integer<unsigned>(bytes[i + b]) : 0U);
    }
    for (std::size_t c = 0; c < 4; ++c) text += c > bytes.size() - i ? '=' : kDigits[bits >> (18 - 6 * c) & 63];
  }
  return text;
}

// A document under construction: one buffer, a view and an accessor a block of numbers.
struct Builder {
  Json root = {
      {"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", {0}}}}}, {"nodes", {Json::object()}}};
  std::vector<std::byte> bytes;
  bool is_whole = false;  // root has its buffers

  template <class T>
  int view(const std::vector<T>& numbers, Json extra = Json::object()) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    const std::size_t offset = bytes.size();
    bytes.resize(offset + numbers.size() * sizeof(T));
    if (!numbers.empty()) std::memcpy(bytes.data() + offset, numbers.data(), numbers.size() * sizeof(T));
    extra.update({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", numbers.size() * sizeof(T)}});
    root["bufferViews"].push_back(extra);
    return static_cast<int>(root["bufferViews"].size()) - 1;
  }

  int accessor(Json accessor) {
    root["accessors"].push_back(std::move(accessor));
    return static_cast<int>(root["accessors"].size()) - 1;
  }

  template <class T>
  int numbers(int component, const char* type, std::size_t components, const std::vector<T>& values,
              const Json& extra = Json::object()) {
    Json json = {{"bufferView", view(values)},
                 {"componentType", component},
                 {"type", type},
                 {"count", values.size() / components}};
    json.update(extra);
    return accessor(std::move(json));
  }

  int positions(const std::vector<float>& xyz) {
    Json low = {xyz[0], xyz[1], xyz[2]};
    Json high = low;
    for (std::size_t i = 0; i < xyz.size(); ++i) {
      low[i % 3] = std::min(low[i % 3].get<float>(), xyz[i]);
      high[i % 3] = std::max(high[i % 3].get<float>(), xyz[i]);
    }
    return numbers(kF32, "VEC3", 3, xyz, {{"min", low}, {"max", high}});
  }

  int times(const std::vector<float>& seconds) {
    return numbers(kF32, "SCALAR", 1, seconds, {{"min", {seconds.front()}}, {"max", {seconds.back()}}});
  }

  // `count` vertices (i, i², 0): no three on a line.
  int curve(std::size_t count) {
    std::vector<float> xyz;
    for (std::size_t i = 0; i < count; ++i) {
      const auto x = static_cast<float>(i);
      xyz.insert(xyz.end(), {x, x * x, 0});
    }
    return positions(xyz);
  }

  // Adds a primitive to the only mesh, drawn at node 0.
  Json& primitive(Json attributes) {
    root["nodes"][0]["mesh"] = 0;
    root["meshes"][0]["primitives"].push_back({{"attributes", std::move(attributes)}});
    return root["meshes"][0]["primitives"].back();
  }

  void channel(int input, int output, const std::string& path, const std::string& interpolation = "LINEAR",
               int node = 0) {
    Json& animation = root["animations"][0];
    const std::size_t sampler = animation.contains("samplers") ? animation["samplers"].size() : 0;
    animation["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
    animation["channels"].push_back({{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}});
  }

  std::string text() {
    if (!bytes.empty() && !is_whole) {
      root["buffers"] = {
          {{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}}};
    }
    return root.dump();
  }
};

inline RawScene read_text(const std::string& text, const ReadOptions& options = {}) {
  return read_gltf("test.gltf", std::as_bytes(std::span(text.data(), text.size())), options);
}

inline RawScene read(Builder& builder, const ReadOptions& options = {}) {
  return read_text(builder.text(), options);
}

// said: a scene, or what stages have noted.
template <class Said>
bool warns(const Said& said, const std::string& rule, const std::string& pointer = "") {
  return std::ranges::any_of(said.warnings, [&](const RawWarning& warning) {
    return warning.rule == rule && (pointer.empty() || warning.pointer == pointer);
  });
}

inline void expect_failure(const std::function<void()>& action, Exit code, const std::string& where,
                           const std::string& rule) {
  try {
    action();
    ADD_FAILURE() << "expected: " << where << ": " << rule;
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), code) << failure.what();
    EXPECT_EQ(failure.where(), where) << failure.what();
    EXPECT_NE(failure.rule().find(rule), std::string::npos) << failure.what();
    EXPECT_FALSE(failure.advice().empty()) << failure.what();
  }
}

inline void expect_refused(const std::string& text, Exit code, const std::string& where, const std::string& rule) {
  SCOPED_TRACE(text.substr(0, 200));
  expect_failure([&] { read_text(text); }, code, where, rule);
}

inline void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance = 1e-12) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << "component " << i;
}

// A bone above another, four vertices on each, a clip that turns the upper one. Without a fault.
inline Builder skinned() {
  Builder b;
  b.root["nodes"] = {
      {{"mesh", 0}, {"skin", 0}}, {{"name", "root"}, {"children", {2}}}, {{"name", "tip"}, {"translation", {0, 1, 0}}}};
  b.root["scenes"][0]["nodes"] = {0, 1};
  const int positions = b.curve(4);
  const int joints = b.numbers<std::uint8_t>(kU8, "VEC4", 4, {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0});
  const int weights = b.numbers<float>(kF32, "VEC4", 4, {1, 0, 0, 0, 1, 0, 0, 0, 0.25F, 0.75F, 0, 0, 1, 0, 0, 0});
  const int indices = b.numbers<std::uint16_t>(kU16, "SCALAR", 1, {0, 1, 2, 1, 3, 2});
  b.root["meshes"] = {{{"primitives",
                        {{{"attributes", {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
                          {"indices", indices}}}}}};
  const int inverse_bind = b.numbers<float>(kF32, "MAT4", 16, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                                               1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
  b.root["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", inverse_bind}, {"skeleton", 1}}};
  const int times = b.times({0, 1});
  const int rotations = b.numbers<float>(kF32, "VEC4", 4, {0, 0, 0, 1, 0, 0, 1, 0});
  b.channel(times, rotations, "rotation", "LINEAR", 2);
  return b;
}

}  // namespace marrow::cook
