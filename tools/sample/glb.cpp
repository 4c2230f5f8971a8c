// Lays out buffers, accessors and nodes, and wraps them into the GLB container.
#include "glb.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

namespace marrow::sample {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFloat = 5126, kUnsignedShort = 5123, kUnsignedByte = 5121;
constexpr int kVertexData = 34962, kIndexData = 34963;

class Writer {
 public:
  std::string run(const Model& model) {
    json_["asset"] = {{"version", "2.0"}, {"generator", "Marrow sample generator"}, {"copyright", "MIT"}};
    json_["scene"] = 0;
    for (const char* name :
         {"scenes", "nodes", "meshes", "skins", "materials", "animations", "accessors", "bufferViews"}) {
      json_[name] = Json::array();
    }
    add_materials();
    add_joints();
    add_body(model);
    add_face(model);
    json_["nodes"].push_back({{"name", "Armature"}, {"children", {kPelvis}}});
    const std::size_t armature = json_["nodes"].size() - 1;
    json_["scenes"].push_back({{"name", "newt"}, {"nodes", {armature, kBodyNode}}});
    for (const Clip& clip : model.clips) add_clip(clip);
    json_["buffers"] = Json::array({{{"byteLength", data_.size()}}});
    return wrap();
  }

 private:
  // Joints come first, so that a joint's node index is its own index; then the skinned body, then the face.
  static constexpr int kBodyNode = kJointCount;
  static constexpr int kFaceNode = kJointCount + 1;

  template <typename T>
  std::size_t add_accessor(const std::vector<T>& values, int component, const char* type, int target,
                           bool normalised = false) {
    while (data_.size() % 4 != 0) data_.push_back('\0');
    const std::size_t bytes = values.size() * sizeof(T);
    Json view = {{"buffer", 0}, {"byteOffset", data_.size()}, {"byteLength", bytes}};
    if (target != 0) view["target"] = target;
    json_["bufferViews"].push_back(view);
    if (bytes > 0) data_.append(reinterpret_cast<const char*>(values.data()), bytes);
    const std::size_t parts =
        std::map<std::string, std::size_t>{{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}}.at(type);
    const std::size_t size = component == kFloat ? 4 : component == kUnsignedShort ? 2 : 1;
    Json accessor = {{"bufferView", json_["bufferViews"].size() - 1},
                     {"componentType", component},
                     {"count", bytes / (size * parts)},
                     {"type", type}};
    if (normalised) accessor["normalized"] = true;
    json_["accessors"].push_back(accessor);
    return json_["accessors"].size() - 1;
  }

  std::size_t add_positions(const std::vector<glm::vec3>& positions) {
    const std::size_t accessor = add_accessor(positions, kFloat, "VEC3", kVertexData);
    glm::vec3 low = positions[0], high = positions[0];
    for (const glm::vec3& p : positions) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    json_["accessors"][accessor]["min"] = {low.x, low.y, low.z};
    json_["accessors"][accessor]["max"] = {high.x, high.y, high.z};
    return accessor;
  }

  std::size_t add_colours(const std::vector<glm::vec3>& colours) {
    std::vector<std::array<std::uint16_t, 4>> packed;
    const auto pack = [](float x) {
      return static_cast<std::uint16_t>(std::lround(std::clamp(x, 0.0f, 1.0f) * 65535.0f));
    };
    for (const glm::vec3& c : colours) packed.push_back({pack(c.r), pack(c.g), pack(c.b), 65535});
    return add_accessor(packed, kUnsignedShort, "VEC4", kVertexData, true);
  }

  std::size_t add_triangles(const std::vector<Triangle>& triangles) {
    std::vector<std::uint16_t> indices;
    for (const Triangle& t : triangles) {
      for (const std::uint32_t v : t) indices.push_back(static_cast<std::uint16_t>(v));
    }
    return add_accessor(indices, kUnsignedShort, "SCALAR", kIndexData);
  }

  void add_materials() {
    const auto material = [](const char* name, float roughness) {
      return Json{{"name", name}, {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", roughness}}}};
    };
    json_["materials"].push_back(material("skin", .55f));
    json_["materials"].push_back(material("gloss", .08f));
  }

  static void set_place(Json& node, glm::vec3 t, glm::quat q) {
    node["translation"] = {t.x, t.y, t.z};
    node["rotation"] = {q.x, q.y, q.z, q.w};
  }

  // Where something is, seen from a joint at rest.
  static void set_place_under(Json& node, int parent, glm::vec3 at, glm::quat turn) {
    const RestJoint origin = parent < 0 ? RestJoint{} : skeleton()[static_cast<std::size_t>(parent)];
    const glm::quat back = glm::inverse(origin.turn);
    set_place(node, back * (at - origin.head), glm::normalize(back * turn));
  }

  // Knees and elbows bend in the plane in which they are bent at rest, from straight to 150°; the neck looks about.
  static Json limits_of(int joint) {
    if (joint == kNeck)
      return {{"cone", {{"axis", {0, 1, 0}}, {"across", {1, 0, 0}}, {"swing", {40, 30}}, {"twist", {-50, 50}}}}};
    for (int side = 0; side < 2; ++side) {
      if (joint != on_side(kShin, side) && joint != on_side(kForearm, side)) continue;
      const glm::vec3 above = bone_direction(skeleton()[static_cast<std::size_t>(joint)].parent);
      const glm::vec3 along = bone_direction(joint), across = glm::cross(above, along);
      const float bent = glm::degrees(std::asin(glm::length(across)));
      const glm::vec3 axis = glm::inverse(skeleton()[static_cast<std::size_t>(joint)].turn) * glm::normalize(across);
      return {{"hinge", {{"axis", {axis.x, axis.y, axis.z}}, {"angle", {-std::ceil(bent), 150 - std::ceil(bent)}}}}};
    }
    return {};
  }

  void add_joints() {
    for (std::size_t i = 0; i < kJointCount; ++i) {
      const RestJoint& joint = skeleton()[i];
      Json node = {{"name", joint.name}};
      set_place_under(node, joint.parent, joint.head, joint.turn);
      if (const Json limits = limits_of(static_cast<int>(i)); !limits.is_null())
        node["extras"]["marrow"]["limits"] = limits;
      json_["nodes"].push_back(node);
    }
    for (std::size_t i = 0; i < kJointCount; ++i) {
      if (skeleton()[i].parent >= 0)
        json_["nodes"][static_cast<std::size_t>(skeleton()[i].parent)]["children"].push_back(i);
    }
  }

  void add_body(const Model& model) {
    std::vector<std::array<std::uint8_t, 4>> joints;
    std::vector<std::array<std::uint16_t, 4>> weights;
    for (const VertexWeights& w : model.weights) {
      joints.push_back(w.joints);
      weights.push_back(w.weights);
    }
    Json attributes = {{"POSITION", add_positions(model.body.positions)},
                       {"NORMAL", add_accessor(model.normals, kFloat, "VEC3", kVertexData)},
                       {"COLOR_0", add_colours(model.colours)},
                       {"JOINTS_0", add_accessor(joints, kUnsignedByte, "VEC4", kVertexData)},
                       {"WEIGHTS_0", add_accessor(weights, kUnsignedShort, "VEC4", kVertexData, true)}};
    add_mesh("body", attributes, add_triangles(model.body.triangles), 0);
    std::vector<glm::mat4> inverses;
    Json list = Json::array();
    for (std::size_t i = 0; i < kJointCount; ++i) {
      const RestJoint& joint = skeleton()[i];
      const glm::quat back = glm::inverse(joint.turn);
      glm::mat4 inverse = glm::mat4_cast(back);
      inverse[3] = glm::vec4(back * -joint.head, 1);
      inverses.push_back(inverse);
      list.push_back(i);
    }
    json_["skins"].push_back({{"name", "newt"},
                              {"inverseBindMatrices", add_accessor(inverses, kFloat, "MAT4", 0)},
                              {"skeleton", kPelvis},
                              {"joints", list}});
    json_["nodes"].push_back({{"name", "body"}, {"mesh", 0}, {"skin", 0}});
  }

  void add_mesh(const std::string& name, const Json& attributes, std::size_t indices, int material) {
    const Json primitive = {{"attributes", attributes}, {"indices", indices}, {"material", material}};
    json_["meshes"].push_back({{"name", name}, {"primitives", Json::array({primitive})}});
  }

  void add_face(const Model& model) {
    for (const RigidPart& part : model.face) {
      const Json attributes = {{"POSITION", add_positions(part.mesh.positions)},
                               {"NORMAL", add_accessor(part.normals, kFloat, "VEC3", kVertexData)},
                               {"COLOR_0", add_colours(part.colours)}};
      const bool lid = part.name.rfind("lid", 0) == 0;
      add_mesh(part.name, attributes, add_triangles(part.mesh.triangles), lid ? 0 : 1);
      Json node = {{"name", part.name}, {"mesh", json_["meshes"].size() - 1}};
      set_place_under(node, kHead, part.at, part.turn);
      json_["nodes"].push_back(node);
      json_["nodes"][kHead]["children"].push_back(json_["nodes"].size() - 1);
    }
  }

  // Tracks of a clip with the same keys share one accessor.
  void add_clip(const Clip& clip) {
    std::map<std::vector<float>, std::size_t> inputs;
    Json samplers = Json::array(), channels = Json::array();
    for (const Track& track : clip.tracks) {
      if (inputs.find(track.times) == inputs.end()) {
        const std::size_t input = add_accessor(track.times, kFloat, "SCALAR", 0);
        json_["accessors"][input]["min"] = {track.times.front()};
        json_["accessors"][input]["max"] = {track.times.back()};
        inputs[track.times] = input;
      }
      const bool turns = track.path == Path::rotation;
      const char* path = turns ? "rotation" : track.path == Path::scale ? "scale" : "translation";
      const char* interpolation = track.interpolation == Interpolation::cubic  ? "CUBICSPLINE"
                                  : track.interpolation == Interpolation::step ? "STEP"
                                                                               : "LINEAR";
      samplers.push_back({{"input", inputs[track.times]},
                          {"interpolation", interpolation},
                          {"output", add_accessor(track.values, kFloat, turns ? "VEC4" : "VEC3", 0)}});
      const int node = track.target < kFaceTarget ? track.target : track.target - kFaceTarget + kFaceNode;
      channels.push_back({{"sampler", samplers.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
    }
    json_["animations"].push_back({{"name", clip.name}, {"channels", channels}, {"samplers", samplers}});
  }

  std::string wrap() {
    std::string text = json_.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    data_.resize((data_.size() + 3) / 4 * 4, '\0');
    std::string file = "glTF";
    const auto word = [&](std::size_t value) {
      for (int shift = 0; shift < 32; shift += 8) file.push_back(static_cast<char>(value >> shift & 0xff));
    };
    word(2);
    word(12 + 8 + text.size() + 8 + data_.size());
    word(text.size());
    file += "JSON" + text;
    word(data_.size());
    file.append("BIN\0", 4);
    return file + data_;
  }

  Json json_;
  std::string data_;
};

}  // namespace

std::string make_glb(const Model& model) {
  return Writer().run(model);
}

}  // namespace marrow::sample
