#include "paint/painting.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>

#include <glm/geometric.hpp>

#include "common/failure.h"
#include "cook/paint/paint_weights.h"
#include "disk/files.h"
#include "paint/mirror.h"
#include "text/printable.h"

namespace marrow::tools {
namespace {

// Of the model's diagonal: how far from a mirror image what is taken for one may be.
constexpr double kPlaceWithin = 0.005, kJointWithin = 0.02;

std::vector<std::vector<Affine>> rest_of(const File& file) {
  Character character(file);
  character.pose({}, 0);
  std::vector<std::vector<Affine>> out;
  for (std::uint32_t s = 0; s < file.skeleton_count(); ++s) {
    const std::span<const Affine> joints = character.model_from_joint(s);
    out.emplace_back(joints.begin(), joints.end());
  }
  return out;
}

double diagonal_of(const deform::Positions& positions) {
  if (positions.empty()) return 0;
  glm::dvec3 low = positions.front(), high = low;
  for (const glm::dvec3& p : positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return glm::distance(low, high);
}

std::string name_of(const File& file, std::uint32_t skeleton, std::uint32_t joint) {
  return file.text(file.skeleton(skeleton).names[joint]);
}

std::string refusal_of(const Canvas& canvas) {
  if (canvas.bind.empty()) return "There is no mesh.";
  if (canvas.has_helpers)
    return "It was cooked with helpers, whose weights are fitted. Cook it without --helpers to paint.";
  if (std::ranges::all_of(canvas.groups, &CanvasGroup::hangs))
    return "Every mesh hangs on one joint: without a skin there are no weights to paint.";
  return "";
}

}  // namespace

SkinJoints skin_joints(const cook::RawScene& scene) {
  SkinJoints out;
  for (const cook::RawInstance& instance : scene.instances) {
    if (instance.skin == cook::kNone) continue;
    const std::string& own = scene.meshes[cook::to_index(instance.mesh)].name;
    std::set<std::string>& names = out[own.empty() ? scene.nodes[cook::to_index(instance.node)].name : own];
    for (const int joint : scene.skins[cook::to_index(instance.skin)].joints)
      names.insert(scene.nodes[cook::to_index(joint)].name);
  }
  return out;
}

Painting::Painting(const File& file, std::string path, const SkinJoints& skins)
    : file_(file), path_(std::move(path)), rest_(rest_of(file)) {
  canvas_ = canvas_of(file, rest_);
  set_joints(skins);
  for (const CanvasGroup& group : canvas_.groups) binds_.push_back(bind_matrices(group, rest_[group.skeleton]));
  diagonal_ = diagonal_of(canvas_.model);
  refusal_ = refusal_of(canvas_);
  if (refusal_.empty()) read_saved();
}

void Painting::set_joints(const SkinJoints& skins) {
  for (CanvasGroup& group : canvas_.groups) {
    const auto skin = skins.find(group.name);
    for (std::uint32_t j = 0; skin != skins.end() && j < rest_[group.skeleton].size(); ++j)
      if (skin->second.contains(name_of(file_, group.skeleton, j))) group.joints.insert(j);
  }
}

std::string Painting::without(std::uint32_t skeleton, std::uint32_t joint) const {
  for (const CanvasGroup& group : canvas_.groups)
    if (group.skeleton == skeleton && !group.hangs && !group.may_follow(joint)) return group.name;
  return "";
}

void Painting::read_saved() {
  std::error_code error;
  if (!std::filesystem::exists(path_, error)) return;
  try {
    const AlignedBytes bytes = read_file(path_);
    add(cook::read_painted(path_, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
    history_.set_saved();
  } catch (const Failure& why) {
    trouble_ = why.what();
  }
}

void Painting::add(const std::vector<cook::PaintedMesh>& painted) {
  for (std::size_t m = 0; m < painted.size(); ++m) apply(painted[m], "/meshes/" + std::to_string(m));
  history_.set_unsaved();
}

void Painting::apply(const cook::PaintedMesh& mesh, const std::string& where) {
  bool is_here = false;
  for (std::uint32_t g = 0; g < canvas_.groups.size(); ++g) {
    const CanvasGroup& group = canvas_.groups[g];
    if (group.name != mesh.name) continue;
    is_here = true;
    std::vector<std::uint32_t> joints;
    for (const std::string& name : mesh.joints) {
      std::uint32_t j = 0;
      while (j < rest_[group.skeleton].size() && name_of(file_, group.skeleton, j) != name) ++j;
      if (j == rest_[group.skeleton].size())
        throw Failure(Exit::invalid, path_, where, printable("the skeleton has no joint \"" + name + '"'),
                      "it was painted for another");
      joints.push_back(j);
    }
    std::vector<std::uint32_t> places;
    deform::Positions positions;
    for (std::uint32_t p = 0; p < canvas_.bind.size(); ++p) {
      if (canvas_.group_of[p] != g) continue;
      places.push_back(p);
      positions.emplace_back(canvas_.bind[p]);
    }
    const cook::PaintMatch match = cook::match_painted(positions, mesh.vertices);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (match.of_place[i] == nullptr) continue;
      Influences& influences = canvas_.influences[places[i]];
      influences = match.of_place[i]->influences;
      for (deform::Influence& influence : influences) influence.joint = joints[influence.joint];
      std::ranges::sort(influences, {}, &deform::Influence::joint);
      canvas_.touched[places[i]] = 1;
    }
  }
  if (is_here) return;
  std::erase_if(others_, [&](const cook::PaintedMesh& other) { return other.name == mesh.name; });
  others_.push_back(mesh);
}

std::vector<cook::PaintedMesh> Painting::painted() const {
  std::vector<cook::PaintedMesh> out;
  for (std::uint32_t g = 0; g < canvas_.groups.size(); ++g) {
    const CanvasGroup& group = canvas_.groups[g];
    cook::PaintedMesh mesh{group.name, {}, {}};
    std::map<std::uint32_t, std::uint32_t> number;  // of a joint of the skeleton, among the mesh's
    for (std::uint32_t p = 0; p < canvas_.bind.size(); ++p) {
      if (canvas_.group_of[p] != g || canvas_.touched[p] == 0) continue;
      cook::PaintedVertex& vertex = mesh.vertices.emplace_back();
      vertex.place = canvas_.bind[p];
      for (const deform::Influence& i : canvas_.influences[p]) {
        const auto [at, is_new] = number.try_emplace(i.joint, static_cast<std::uint32_t>(mesh.joints.size()));
        if (is_new) mesh.joints.push_back(name_of(file_, group.skeleton, i.joint));
        vertex.influences.push_back({at->second, i.weight});
      }
    }
    if (!mesh.vertices.empty()) out.push_back(std::move(mesh));
  }
  out.insert(out.end(), others_.begin(), others_.end());
  return out;
}

void Painting::save() {
  if (!trouble_.empty())
    throw Failure(Exit::invalid, path_, "", "not written over: it does not hold what fits here",
                  "move it away, or name another file with --paint");
  write_file_atomically(path_, std::string_view(cook::text_of_painted(painted())));
  history_.set_saved();
}

void Painting::pose(const Character& character) {
  std::vector<std::vector<Affine>> joints;
  for (std::uint32_t s = 0; s < file_.skeleton_count(); ++s) {
    const std::span<const Affine> posed = character.model_from_joint(s);
    joints.emplace_back(posed.begin(), posed.end());
  }
  pose_canvas(canvas_, binds_, joints, posed_);
}

std::optional<SurfaceHit> Painting::hit(const Ray& ray) const {
  return first_hit(ray, posed_.places, canvas_.corners);
}

std::vector<PosedMesh> Painting::posed(const Character& character) const {
  std::vector<PosedMesh> out;
  for (std::uint32_t m = 0; m < file_.mesh_count(); ++m) {
    out.push_back(posed_mesh(file_.mesh(m), canvas_.place_of_slot[m], posed_));
    const std::span<const Affine> palette = character.palette(m);
    out.back().inside_out = turns_inside_out({palette.data(), palette.size()});
  }
  return out;
}

std::vector<float> Painting::weights(std::uint32_t mesh, std::uint32_t skeleton, std::uint32_t joint,
                                     std::uint32_t image) const {
  std::vector<float> out;
  for (const std::uint32_t p : canvas_.place_of_slot[mesh]) {
    const bool is_its = canvas_.groups[canvas_.group_of[p]].skeleton == skeleton;
    double weight = weight_of(canvas_.influences[p], joint);
    if (image != joint) weight += weight_of(canvas_.influences[p], image);
    out.push_back(is_its ? static_cast<float>(weight) : 0.0f);
  }
  return out;
}

std::size_t Painting::moved_by(std::uint32_t skeleton, std::uint32_t joint) const {
  std::size_t out = 0;
  for (std::size_t p = 0; p < canvas_.bind.size(); ++p)
    out += canvas_.groups[canvas_.group_of[p]].skeleton == skeleton && weight_of(canvas_.influences[p], joint) > 0;
  return out;
}

const std::vector<std::uint32_t>& Painting::mirror(const MirrorPlane& plane) {
  if (mirror_plane_ != plane) mirror_ = mirrored_places(canvas_, plane, kPlaceWithin * diagonal_);
  mirror_plane_ = plane;
  return mirror_;
}

std::size_t Painting::places_with_image(const MirrorPlane& plane) {
  const std::vector<std::uint32_t>& all = mirror(plane);
  return all.size() - static_cast<std::size_t>(std::ranges::count(all, kNoPlace));
}

std::uint32_t Painting::image_of(const Brush& brush, std::uint32_t skeleton, std::uint32_t joint) {
  if (brush.mirror.axis < 0) return joint;
  std::vector<std::string> names;
  std::vector<glm::vec3> places;
  for (std::uint32_t j = 0; j < rest_[skeleton].size(); ++j) {
    const Affine& m = rest_[skeleton][j];
    names.push_back(name_of(file_, skeleton, j));
    places.emplace_back(m.rows[0][3], m.rows[1][3], m.rows[2][3]);
  }
  return mirrored_joint(names, places, joint, brush.mirror, kJointWithin * diagonal_);
}

void Painting::begin(const Brush& brush, std::uint32_t skeleton, std::uint32_t joint) {
  std::span<const std::uint32_t> images;
  if (brush.mirror.axis >= 0) images = mirror(brush.mirror);
  stroke_.emplace(canvas_, brush, skeleton, joint, image_of(brush, skeleton, joint), images);
  kept_ = 0;
}

void Painting::dab(const SurfaceHit& hit) {
  stroke_->dab(posed_.places, hit);
}

void Painting::end() {
  Edit edit = stroke_->edit();
  kept_ = stroke_->kept();
  changed_ = edit.size();
  stroke_.reset();
  tools::redo(canvas_, edit);  // which marks them as touched
  history_.add(std::move(edit));
}

void Painting::undo() {
  if (!stroking()) history_.undo(canvas_);
}

void Painting::redo() {
  if (!stroking()) history_.redo(canvas_);
}

std::string paint_file_beside(const std::string& path) {
  return std::filesystem::path(path).replace_extension(".paint.json").string();
}

}  // namespace marrow::tools
