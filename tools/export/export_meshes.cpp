// Meshes become primitives of skinned meshes, or, bound to one joint, of meshes on a node below it.
#include <algorithm>
#include <optional>
#include <span>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "common/failure.h"
#include "common/vertex_order.h"
#include "export/affine_parts.h"
#include "export/export_looks.h"
#include "export/export_parts.h"
#include "export/export_targets.h"
#include "export/export_vertices.h"
#include "marrow/local_to_model.h"

namespace marrow::tools {
namespace {

// Meshes share a skin as long as they agree on the inverse binds.
struct Skin {
  std::uint32_t skeleton;
  std::vector<std::uint16_t> joints;        // of the skeleton
  std::vector<Affine> inverse_bind;         // a joint of the skin
  std::map<std::uint16_t, std::size_t> at;  // joint of the skeleton → of the skin
};

struct PartTarget {
  std::string name, channel;
  float weight;
  bool operator==(const PartTarget&) const = default;
};

// What one glTF mesh is made of: consecutive cooked meshes that hang in the same place under the same name.
struct Part {
  std::string name;
  std::uint32_t skeleton;
  std::optional<std::size_t> skin;  // else bound to one joint
  std::uint16_t joint = 0;
  Affine joint_from_mesh{};
  std::vector<PartTarget> targets;
  Json primitives = Json::array();

  // Whether one mesh can hold both. A mesh without targets gets targets that leave it alone.
  bool holds(const Part& other) const {
    return name == other.name && skeleton == other.skeleton && skin == other.skin &&
           (skin || (joint == other.joint && same(joint_from_mesh, other.joint_from_mesh))) &&
           (targets.empty() || other.targets.empty() || targets == other.targets);
  }
};

// Cooking calls a weight's channel NODE.TARGET, or NODE.weights[i]: the node's name, for the export to cook alike.
std::optional<std::string> owner_of(const std::vector<PartTarget>& targets) {
  std::optional<std::string> owner;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const std::string& channel = targets[i].channel;
    const std::string number = ".weights[" + std::to_string(i) + ']', named = '.' + targets[i].name;
    const std::string& end = channel.ends_with(number) ? number : named;
    if (!channel.ends_with(end)) return std::nullopt;
    const std::string before = channel.substr(0, channel.size() - end.size());
    if (owner.value_or(before) != before) return std::nullopt;
    owner = before;
  }
  return owner;
}

class Meshes {
 public:
  explicit Meshes(ExportScene& scene) : scene_(scene), looks_(scene) {}

  void run() {
    for (std::uint32_t i = 0; i < scene_.file.mesh_count();) {
      const std::vector<Mesh> parts = parts_at(scene_.file, i);
      add(i, parts);
      i += static_cast<std::uint32_t>(parts.size());
    }
    if (part_) place();
    for (const Skin& skin : skins_) add_skin(skin);
  }

 private:
  // parts: of one primitive.
  void add(std::uint32_t number, std::span<const Mesh> parts) {
    const Mesh& mesh = parts.front();
    Part next{mesh.name, mesh.skeleton, std::nullopt, mesh.joints[0], mesh.inverse_bind[0], targets_of(mesh)};
    if (parts.size() > 1 || mesh.joint_count > 1) next.skin = skin_for(number, parts);
    const bool goes_on = part_ && part_->holds(next);
    if (part_ && !goes_on) place();
    if (!goes_on) {
      part_ = std::move(next);
    } else if (part_->targets.empty()) {
      part_->targets = std::move(next.targets);
    }
    part_->primitives.push_back(primitive(parts));
    warn_of_deformers(number, parts);
  }

  void warn_of_deformers(std::uint32_t number, std::span<const Mesh> parts) {
    const auto left_out = [&](const auto& has, const char* what) {
      if (std::ranges::any_of(parts, [&](const Mesh& part) { return has(part.geometry); }))
        scene_.warnings.push_back(
            {"mesh " + std::to_string(number) + " \"" + parts[0].name + "\"", "",
             std::string("glTF has no ") + what + " is left out, so it is deformed by linear blend skinning"});
    };
    left_out([](const Geometry& g) { return g.as_residual != nullptr; }, "animation space; its residual");
    left_out([](const Geometry& g) { return g.mwe_residual != nullptr; }, "multi-weight enveloping; it");
    left_out([](const Geometry& g) { return !g.pose_space.examples.empty(); }, "pose space; it");
  }

  std::vector<PartTarget> targets_of(const Mesh& mesh) const {
    std::vector<PartTarget> out;
    for (const MeshTarget& t : mesh.targets)
      out.push_back({scene_.file.text(t.name), scene_.file.text(t.channel), t.weight});
    return out;
  }

  // The first skin that agrees with the mesh on the inverse binds of the joints that both have; a new one if none does.
  std::size_t skin_for(std::uint32_t number, std::span<const Mesh> parts) {
    const auto agrees = [](const Skin& skin, const Mesh& mesh) {
      if (skin.skeleton != mesh.skeleton) return false;
      for (std::uint32_t i = 0; i < mesh.joint_count; ++i) {
        const auto found = skin.at.find(mesh.joints[i]);
        if (found != skin.at.end() && !same(skin.inverse_bind[found->second], mesh.inverse_bind[i])) return false;
      }
      return true;
    };
    const auto fits = [&](const Skin& skin) {
      return std::ranges::all_of(parts, [&](const Mesh& part) { return agrees(skin, part); });
    };
    std::size_t s = 0;
    while (s < skins_.size() && !fits(skins_[s])) ++s;
    if (s == skins_.size()) skins_.push_back({parts[0].skeleton, {}, {}, {}});
    for (const Mesh& mesh : parts)
      for (std::uint32_t i = 0; i < mesh.joint_count; ++i) add_to_skin(skins_[s], mesh.joints[i], mesh.inverse_bind[i]);
    if (!fits(skins_[s]))
      throw Failure(Exit::unsupported, scene_.name, "",
                    "mesh " + std::to_string(number) + " binds a joint twice, in two ways",
                    "glTF's skins name a joint once");
    return s;
  }

  static void add_to_skin(Skin& skin, std::uint16_t joint, const Affine& inverse_bind) {
    if (!skin.at.try_emplace(joint, skin.joints.size()).second) return;
    skin.joints.push_back(joint);
    skin.inverse_bind.push_back(inverse_bind);
  }

  Json primitive(std::span<const Mesh> parts) {
    const std::vector<Geometry> geometries = geometries_of(parts);
    std::vector<std::uint32_t> numbers;
    for (const Mesh& part : parts) numbers.push_back(part.geometry_index);
    auto found = vertices_.find(numbers);
    if (found == vertices_.end()) {
      found = vertices_.emplace(numbers, export_vertices(scene_.glb, geometries)).first;
      if (!geometries[0].targets.empty()) found->second["targets"] = export_targets(scene_.glb, geometries);
    }
    Json out = found->second;
    if (part_->skin) {
      const Skin& skin = skins_[*part_->skin];
      std::vector<std::vector<EntryJoints>> joints;
      for (const Mesh& part : parts) {
        joints.emplace_back();
        for (std::uint32_t i = 0; i < part.joint_count; ++i)
          joints.back().push_back({static_cast<std::uint16_t>(skin.at.at(part.joints[i]))});
        for (const Helper& helper : part.helpers)
          joints.back().push_back(
              {joints.back()[helper.first].first, joints.back()[helper.second].first, helper.share});
      }
      Json& weights = weights_[{numbers, joints}];
      if (weights.is_null())
        export_weights(scene_.glb, geometries, joints, scene_.file.skeleton(parts[0].skeleton).joint_count > 256,
                       weights);
      out["attributes"].update(weights);
    }
    if (const std::optional<std::size_t> number = material(parts[0])) out["material"] = *number;
    return out;
  }

  std::optional<std::size_t> material(const Mesh& mesh) {
    Json m = Json::object();
    if (*mesh.material != '\0') m["name"] = mesh.material;
    const std::vector<float> colour(mesh.base_colour, mesh.base_colour + 4);
    if (m.empty() && mesh.material_index == kNoMaterial && !mesh.double_sided &&
        colour == std::vector<float>{1, 1, 1, 1})
      return std::nullopt;
    // What a cooked file does not say of a surface is that of plain paint.
    m["pbrMetallicRoughness"] = {{"baseColorFactor", numbers(colour)}, {"metallicFactor", 0}};
    if (mesh.double_sided) m["doubleSided"] = true;
    looks_.add_to(m, mesh);
    return once("materials", m);
  }

  // The number of an element of a list that may be there already.
  std::size_t once(const char* list, const Json& element) {
    const auto [at, is_new] =
        known_.try_emplace(std::string(list) + element.dump(-1, ' ', false, Json::error_handler_t::replace), 0u);
    if (is_new) at->second = scene_.glb.add(list, element);
    return at->second;
  }

  // The part becomes a mesh and the node that carries it.
  void place() {
    Json mesh = Json::object(), node = Json::object();
    if (!part_->name.empty()) mesh["name"] = node["name"] = part_->name;
    mesh["primitives"] = part_->primitives;
    if (!part_->targets.empty()) add_targets(mesh, node);
    node["mesh"] = once("meshes", mesh);
    std::size_t placed = 0;
    if (part_->skin) {
      node["skin"] = *part_->skin;
      placed = scene_.add_node(std::move(node), ExportScene::kScene);
    } else {
      placed = hang(std::move(node));
    }
    if (!part_->targets.empty()) {
      MorphedNode& morphed = scene_.morphed.emplace_back();
      morphed.node = placed;
      for (const PartTarget& t : part_->targets) {
        morphed.channels.push_back(t.channel);
        morphed.weights.push_back(t.weight);
      }
    }
    part_.reset();
  }

  // All primitives of a mesh have as many targets.
  void add_targets(Json& mesh, Json& node) {
    Json names = Json::array(), weights = Json::array();
    bool named = false;
    for (const PartTarget& t : part_->targets) {
      names.push_back(t.name);
      named = named || !t.name.empty();
      weights.push_back(number(t.weight));
    }
    for (Json& primitive : mesh["primitives"])
      if (!primitive.contains("targets"))
        primitive["targets"] = still_targets(scene_.glb, primitive["attributes"]["POSITION"], names.size());
    mesh["weights"] = weights;
    if (named) mesh["extras"] = {{"targetNames", names}};
    if (const std::optional<std::string> owner = owner_of(part_->targets)) node["name"] = *owner;
  }

  // A node of its own even where nothing lies between, so that meshes keep their order.
  std::size_t hang(Json node) {
    std::size_t parent = scene_.joint_nodes[part_->skeleton][part_->joint];
    const std::vector<Parts> between = parts_of(part_->joint_from_mesh);
    for (std::size_t i = 0; i + 1 < between.size(); ++i) {
      Json outer = Json::object();
      set_parts(outer, between[i]);
      parent = scene_.add_node(std::move(outer), parent);
    }
    if (!between.empty()) set_parts(node, between.back());
    return scene_.add_node(std::move(node), parent);
  }

  // The skeleton's first skin names all its joints, so that they remain joints for whoever reads the export.
  void add_skin(Skin skin) {
    const Skeleton skeleton = scene_.file.skeleton(skin.skeleton);
    if (complete_.insert({skin.skeleton, true}).second) {
      std::vector<Affine> model(skeleton.joint_count);
      static_cast<void>(local_to_model(skeleton, {skeleton.rest, skeleton.soa_size()}, model));
      for (std::uint32_t j = 0; j < skeleton.joint_count; ++j)
        add_to_skin(skin, static_cast<std::uint16_t>(j), inverse(model[j]));
    }
    std::vector<float> matrices;
    Json joints = Json::array();
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
      joints.push_back(scene_.joint_nodes[skin.skeleton][skin.joints[j]]);
      for (std::size_t c = 0; c < 4; ++c) {
        for (std::size_t r = 0; r < 3; ++r) matrices.push_back(skin.inverse_bind[j].rows[r][c]);
        matrices.push_back(c == 3 ? 1.0f : 0.0f);
      }
    }
    const std::size_t accessor = scene_.glb.add_accessor(matrices, Component::f32, kMat4, Target::none);
    Json out = Json::object();
    if (*skeleton.name != '\0') out["name"] = skeleton.name;
    out["inverseBindMatrices"] = accessor;
    out["joints"] = joints;
    scene_.glb.add("skins", out);
  }

  // Of a joint at rest; the identity where there is none.
  static Affine inverse(const Affine& map) {
    glm::dmat4 m(1.0);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) m[c][r] = static_cast<double>(map.rows[r][c]);
    if (glm::determinant(m) == 0) m = glm::dmat4(1.0);
    m = glm::inverse(m);
    Affine out;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) out.rows[r][c] = static_cast<float>(m[c][r]);
    return out;
  }

  ExportScene& scene_;
  Looks looks_;
  std::optional<Part> part_;
  std::vector<Skin> skins_;
  using Numbers = std::vector<std::uint32_t>;
  std::map<Numbers, Json> vertices_;                                                   // geometries of parts
  std::map<std::pair<Numbers, std::vector<std::vector<EntryJoints>>>, Json> weights_;  // and their palettes
  std::map<std::string, std::size_t> known_;
  std::map<std::uint32_t, bool> complete_;  // skeletons
};

}  // namespace

void export_meshes(ExportScene& scene) {
  Meshes(scene).run();
}

}  // namespace marrow::tools
