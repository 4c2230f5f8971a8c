#include "write_newt.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "glb/glb.h"

namespace marrow::sample {
namespace {

using tools::Component, tools::Json, tools::Target;
using tools::kMat4, tools::kScalar, tools::kVec3, tools::kVec4;

class Writer {
 public:
  std::string run(const Model& model) {
    json_["asset"]["copyright"] = "MIT";
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
    return glb_.finish("the sample");
  }

  std::string run(const std::vector<RigidPart>& face, const std::vector<Clip>& clips) {
    json_["asset"]["copyright"] = "MIT";
    json_["scene"] = 0;
    for (const char* name : {"scenes", "nodes", "animations", "accessors", "bufferViews"}) json_[name] = Json::array();
    add_joints();
    face_node_ = kJointCount;
    for (const RigidPart& part : face) add_face_node(part, {{"name", part.name}});
    json_["nodes"].push_back({{"name", "Armature"}, {"children", {kPelvis}}});
    json_["scenes"].push_back({{"name", "newt"}, {"nodes", {json_["nodes"].size() - 1}}});
    for (const Clip& clip : clips) add_clip(clip);
    return glb_.finish("the sample's moves");
  }

 private:
  // Joints come first, so that a joint's node index is its own index; then the skinned body, then the face.
  static constexpr int kBodyNode = kJointCount;
  int face_node_ = kJointCount + 1;  // without a body its own place

  std::size_t add_positions(const std::vector<glm::vec3>& positions) {
    const std::size_t accessor = glb_.add_accessor(positions, Component::f32, kVec3, Target::vertices);
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
    return glb_.add_accessor(packed, Component::u16, kVec4, Target::vertices, true);
  }

  std::size_t add_triangles(const std::vector<Triangle>& triangles) {
    std::vector<std::uint16_t> indices;
    for (const Triangle& t : triangles) {
      for (const std::uint32_t v : t) indices.push_back(static_cast<std::uint16_t>(v));
    }
    return glb_.add_accessor(indices, Component::u16, kScalar, Target::indices);
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
                       {"NORMAL", glb_.add_accessor(model.normals, Component::f32, kVec3, Target::vertices)},
                       {"COLOR_0", add_colours(model.colours)},
                       {"JOINTS_0", glb_.add_accessor(joints, Component::u8, kVec4, Target::vertices)},
                       {"WEIGHTS_0", glb_.add_accessor(weights, Component::u16, kVec4, Target::vertices, true)}};
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
                              {"inverseBindMatrices", glb_.add_accessor(inverses, Component::f32, kMat4, Target::none)},
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
                               {"NORMAL", glb_.add_accessor(part.normals, Component::f32, kVec3, Target::vertices)},
                               {"COLOR_0", add_colours(part.colours)}};
      const bool lid = part.name.rfind("lid", 0) == 0;
      add_mesh(part.name, attributes, add_triangles(part.mesh.triangles), lid ? 0 : 1);
      add_face_node(part, {{"name", part.name}, {"mesh", json_["meshes"].size() - 1}});
    }
  }

  void add_face_node(const RigidPart& part, Json node) {
    set_place_under(node, kHead, part.at, part.turn);
    json_["nodes"].push_back(node);
    json_["nodes"][kHead]["children"].push_back(json_["nodes"].size() - 1);
  }

  // Tracks of a clip with the same keys share one accessor.
  void add_clip(const Clip& clip) {
    std::map<std::vector<float>, std::size_t> inputs;
    Json samplers = Json::array(), channels = Json::array();
    for (const Track& track : clip.tracks) {
      if (inputs.find(track.times) == inputs.end()) {
        const std::size_t input = glb_.add_accessor(track.times, Component::f32, kScalar, Target::none);
        json_["accessors"][input]["min"] = {track.times.front()};
        json_["accessors"][input]["max"] = {track.times.back()};
        inputs[track.times] = input;
      }
      const bool turns = track.path == Path::rotation;
      const char* path = turns ? "rotation" : track.path == Path::scale ? "scale" : "translation";
      const char* interpolation = track.interpolation == Interpolation::cubic  ? "CUBICSPLINE"
                                  : track.interpolation == Interpolation::step ? "STEP"
                                                                               : "LINEAR";
      samplers.push_back(
          {{"input", inputs[track.times]},
           {"interpolation", interpolation},
           {"output", glb_.add_accessor(track.values, Component::f32, turns ? kVec4 : kVec3, Target::none)}});
      const int node = track.target < kFaceTarget ? track.target : track.target - kFaceTarget + face_node_;
      channels.push_back({{"sampler", samplers.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
    }
    json_["animations"].push_back({{"name", clip.name}, {"channels", channels}, {"samplers", samplers}});
    if (!clip.events.empty()) json_["animations"].back()["extras"]["marrow"]["events"] = clip.events;
  }

  tools::Glb glb_{"Marrow sample generator"};
  Json& json_ = glb_.json;
};

}  // namespace

std::string make_glb(const Model& model) {
  return Writer().run(model);
}

std::string make_moves_glb(const std::vector<RigidPart>& face, const std::vector<Clip>& clips) {
  return Writer().run(face, clips);
}

}  // namespace marrow::sample
