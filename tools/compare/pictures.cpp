#include "compare/pictures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/glm.hpp>

#include "common/check_status.h"
#include "cook/scene/matrices.h"
#include "deform/surface.h"
#include "disk/cook_on_disk.h"
#include "image/jpeg.h"
#include "render/clearest_side.h"
#include "render/disk/images.h"
#include "render/figure.h"
#include "render/heat.h"
#include "render/performance.h"
#include "text/quantity.h"

namespace marrow::tools {
namespace {

// A study's mesh as the studio draws it, wherever deformers put its vertices.
class Stage {
 public:
  // Pictures of side × side pixels. `study` outlives it.
  Stage(const Study& study, int side);

  // What is framed, from which side, and what stands on the ground and is lit.
  struct View {
    std::vector<glm::vec3> framed;
    Orbit side;
    Box box;
  };
  // A pose by the truth, by plain skinning and by the last deformer that is shown.
  struct Compared {
    const std::vector<PosedMesh>& truth;
    const std::vector<PosedMesh>& plain;
    const std::vector<PosedMesh>& last;
  };
  // All of it, or a part, from where one sees best what the last deformer makes otherwise than plain skinning.
  View whole(const Compared& compared) const;
  View close_up(const Compared& compared, const Part& part) const;

  // Where a deformer has put the vertices in a pose. normals: empty for those of the triangles.
  std::vector<PosedMesh> posed(const deform::Pose& pose, const deform::Positions& positions,
                               std::vector<glm::dvec3> normals) const;

  // heat: its colours instead of the mesh's own, with a legend.
  Picture shoot(const std::vector<PosedMesh>& meshes, const View& view, const std::string& caption,
                const HeatMap* heat);

  // Adds to a row deformers and the truth in a pose, and how far the former are off.
  struct Scene {
    const deform::Pose& pose;
    const deform::Deformer& truth;
    const DeformerComparison& comparison;
    const std::vector<std::size_t>& deformers;  // indices into its rows, plain skinning first
  };
  using ViewOf = std::function<View(const Compared& compared)>;
  void draw(const Scene& scene, const ViewOf& view_of, PictureRow& row);

 private:
  const Study& study_;
  std::vector<glm::dvec3> bind_normals_;
  std::vector<std::byte> cooked_;
  AlignedBytes bytes_;
  File file_;
  std::optional<Gl> gl_;
  std::optional<Studio> studio_;
  std::optional<Textures> textures_;
  std::optional<Figure> figure_;
};

constexpr int kSide = 620;  // as wide as the slider shows them

// The held-out poses with the largest errors, no two of one clip; of poses without a clip just the worst.
std::vector<std::size_t> worst_poses(const Round& round, const std::vector<double>& errors, std::size_t most) {
  std::map<std::string, std::size_t> worst_of_clip;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const auto [at, is_new] = worst_of_clip.try_emplace(round.held[i].clip, i);
    if (errors[i] > errors[at->second]) at->second = i;
  }
  std::multimap<double, std::size_t> by_error;
  for (const auto& [clip, i] : worst_of_clip) by_error.emplace(-errors[i], i);
  std::vector<std::size_t> out;
  for (const auto& [error, i] : by_error)
    if (out.size() < most) out.push_back(i);
  return out;
}

// Of those in which the truth does not fold the one with the largest error.
std::size_t farthest_pose(const MotionStudy& motion, std::size_t deformer) {
  std::size_t out = MotionRow::kNowhere;
  double most = 0;
  for (std::size_t i = 0; i < motion.errors.size(); ++i) {
    const deform::MotionErrors& errors = motion.errors[i];
    if (!errors.is_usable || errors.truth_flipped > 0 || !(errors.of[deformer].rms > most)) continue;
    most = errors.of[deformer].rms;
    out = i;
  }
  return out;
}

// How the character stands: the bind pose's frame may lie on its back.
deform::Matrix standing(const Study& study, std::uint32_t joint) {
  while (study.source.parents[joint] >= 0) joint = static_cast<std::uint32_t>(study.source.parents[joint]);
  return study.rest[joint];
}

deform::Pose placed(const deform::Matrix& by, deform::Pose pose) {
  for (deform::Matrix& m : pose) m = deform::Matrix(glm::dmat4(by) * glm::dmat4(m));
  return pose;
}

// How far from the joint the surface lies where the joint's part goes over into the rest: nine tenths of it.
double reach(const deform::SkinnedMesh& mesh, const deform::MotionPose& pose) {
  constexpr double kLeastShare = 0.1;
  const std::vector<double> shares = deform::turned_shares(mesh, *pose.turns);
  std::vector<double> distances;
  for (std::size_t v = 0; v < shares.size(); ++v)
    if (shares[v] > kLeastShare && shares[v] < 1 - kLeastShare)
      distances.push_back(glm::length(mesh.positions[v] - pose.centre));
  if (distances.empty()) return 0.1 * deform::diagonal(mesh);
  const auto at = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() * 9 / 10);
  std::nth_element(distances.begin(), at, distances.end());
  return std::max(*at, 0.01 * deform::diagonal(mesh));
}

Part part_of(const deform::SkinnedMesh& mesh, const deform::MotionPose& pose, const deform::Matrix& placed) {
  constexpr double kAround = 1.7;
  const glm::dvec3 axis = deform::linear_of(placed) * pose.axis, centre = deform::transform(placed, pose.centre);
  return {glm::vec3(centre), static_cast<float>(kAround * reach(mesh, pose) * glm::length(axis))};
}

constexpr int kQuality = 88;          // of a page's pictures: no grain is seen beside the same as PNG
constexpr float kLeastScale = 1e-4f;  // of the diagonal: what is less is no difference that anyone sees

void put(const glm::dvec3& v, std::size_t slot, std::vector<float>& out) {
  for (int c = 0; c < 3; ++c) out[3 * slot + static_cast<std::size_t>(c)] = static_cast<float>(v[c]);
}

std::vector<std::string> ramp_of_styles() {
  std::vector<std::string> out;
  for (int i = 0; i <= 10; ++i) {
    const Rgb c = heat_colour(0.1f * static_cast<float>(i));
    out.push_back(fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]));
  }
  return out;
}

}  // namespace

std::vector<PictureRow> draw_worst_poses(const Study& study, const DeformerComparison& comparison,
                                         const deform::Deformer& truth, const std::vector<std::size_t>& deformers,
                                         std::size_t most) {
  Stage stage(study, kSide);
  const Round& round = study.rounds.front();
  std::vector<PictureRow> out;
  for (const std::size_t i : worst_poses(round, comparison.rows[deformers.front()].error_of_pose, most)) {
    const HeldPose& held = round.held[i];
    PictureRow row;
    row.title =
        held.clip.empty() ? fmt::format("pose {}", i) : fmt::format("{} at {} s", held.clip, plain_number(held.time_s));
    stage.draw(
        {held.pose, truth, comparison, deformers},
        [&](const Stage::Compared& compared) { return stage.whole(compared); }, row);
    out.push_back(std::move(row));
  }
  return out;
}

std::vector<PictureRow> draw_worst_joints(const Study& study, const DeformerComparison& comparison,
                                          const MotionStudy& motion, const deform::Deformer& truth,
                                          const std::vector<std::size_t>& deformers) {
  std::vector<PictureRow> out;
  if (motion.poses == 0) return out;
  const std::size_t judged = deformers.back();
  const std::string& name = comparison.rows[judged].deformer;
  const std::size_t farthest = farthest_pose(motion, judged), narrowest = motion.of[judged].narrowest_pose;
  Stage stage(study, kSide);
  const auto add = [&](std::size_t number, const char* why) {
    const deform::MotionPose& pose = study.motion.poses[number];
    const deform::Matrix by = standing(study, pose.joint);
    const deform::Pose stands = placed(by, pose.pose());
    PictureRow row;
    row.title = fmt::format("{}: {} {}", title_of(study, pose), name, why);
    stage.draw(
        {stands, truth, comparison, deformers},
        [&](const Stage::Compared& compared) { return stage.close_up(compared, part_of(study.source.mesh, pose, by)); },
        row);
    out.push_back(std::move(row));
  };
  if (farthest != MotionRow::kNowhere) add(farthest, "is farthest from the truth");
  if (narrowest != MotionRow::kNowhere && narrowest != farthest) add(narrowest, "has the narrowest ring beside it");
  return out;
}

Stage::Stage(const Study& study, int side) : study_(study) {
  const deform::SkinnedMesh& mesh = study.source.mesh;
  bind_normals_ = deform::vertex_normals(mesh.positions, mesh.indices);
  cook::CookOptions options;
  options.mesh.codec = cook::MeshCodec::none;
  options.mesh.keep_vertex_order = true;
  options.clips.raw = true;
  options.mesh.most_entries = kMaxJoints;  // a mesh a primitive
  cooked_ = cook::cook_scene(study.scene, options).file;
  bytes_ = AlignedBytes{std::span<const std::byte>(cooked_)};
  check(load({bytes_.data(), bytes_.size()}, file_));
  gl_.emplace();
  studio_.emplace(*gl_, side, side);
  const std::string& source = study.scene.source;
  FoundImages images(source, file_, places_beside(source));
  textures_.emplace(*gl_, file_, images);
  figure_.emplace(*gl_, studio_->programs(), file_, &*textures_);
}

Stage::View Stage::whole(const Compared& compared) const {
  const Box box = box_of(compared.truth);
  View out = close_up(compared, {box.centre(), std::max(box.radius(), 1e-6f)});
  out.framed.clear();
  for (const PosedMesh& mesh : compared.truth)
    for (std::size_t i = 0; i + 2 < mesh.positions.size(); i += 3)
      out.framed.emplace_back(mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]);
  return out;
}

Stage::View Stage::close_up(const Compared& compared, const Part& part) const {
  return {framed(part), clearest_side(file_, compared.plain, compared.last, part).side, box_of(compared.truth)};
}

std::vector<PosedMesh> Stage::posed(const deform::Pose& pose, const deform::Positions& positions,
                                    std::vector<glm::dvec3> normals) const {
  if (normals.empty()) normals = deform::vertex_normals(positions, study_.source.mesh.indices);
  std::vector<Affine> palette;
  for (const deform::Matrix& m : pose) palette.push_back(cook::to_affine(glm::dmat4(m)));
  std::vector<PosedMesh> out(file_.mesh_count());
  for (std::uint32_t m = 0; m < file_.mesh_count(); ++m) {
    const Geometry g = file_.mesh(m).geometry;
    out[m].inside_out = turns_inside_out(palette);
    out[m].positions.resize(std::size_t{3} * g.slot_count);
    out[m].normals.resize(g.normals != nullptr ? std::size_t{3} * g.slot_count : 0);
    const std::vector<std::uint32_t>& vertex_of = study_.source.vertex_of[m];
    for (std::size_t slot = 0; slot < g.slot_count; ++slot) put(positions[vertex_of[0]], slot, out[m].positions);
    for (std::size_t v = 0; v < vertex_of.size(); ++v) {
      const std::uint32_t slot = g.source_slots[v];
      if (slot == kNoSlot) continue;
      put(positions[vertex_of[v]], slot, out[m].positions);
      if (g.normals != nullptr) put(normals[vertex_of[v]], slot, out[m].normals);
    }
  }
  return out;
}

Picture Stage::shoot(const std::vector<PosedMesh>& meshes, const View& view, const std::string& caption,
                     const HeatMap* heat) {
  Shot shot;
  shot.box = view.box;
  shot.camera = frame_points_from(view.side, view.framed, 1.0f, 0.06f);
  shot.radius = std::max(shot.box.radius(), 1e-6f);
  shot.ground_height = shot.box.min.y;
  shot.light_turn_rad = view.side.yaw - Orbit().yaw;
  std::vector<Drawable> drawables;
  if (heat != nullptr) {
    shot.shading = kHeatShading;
    drawables = figure_->from_cpu(meshes, heat->colours);
  } else {
    drawables = figure_->from_cpu(meshes);
  }
  Image image = studio_->shoot(shot, drawables);
  if (heat != nullptr) draw_legend(image, "off the truth", heat->largest, heat->full_scale);
  return {caption, encode_jpeg(image, kQuality), [image] { return encode_png(image); }};
}

void Stage::draw(const Scene& scene, const ViewOf& view_of, PictureRow& row) {
  deform::Positions positions;
  scene.truth(scene.pose, positions);
  const std::vector<PosedMesh> wanted = posed(scene.pose, positions, {});
  std::vector<std::vector<PosedMesh>> shapes;
  float scale = 0;
  for (const std::size_t d : scene.deformers) {
    const Trained& trained = scene.comparison.trained_in_first_round[d];
    trained.deform(scene.pose, positions);
    shapes.push_back(posed(scene.pose, positions, shading_normals(trained, bind_normals_, scene.pose)));
    scale = std::max(scale, largest_distance(shapes.back(), wanted));
  }
  const View from = view_of({wanted, shapes.front(), shapes.back()});
  for (std::size_t d = 0; d < shapes.size(); ++d)
    row.shapes.push_back(shoot(shapes[d], from, scene.comparison.rows[scene.deformers[d]].deformer, nullptr));
  row.shapes.push_back(shoot(wanted, from, "truth", nullptr));
  scale = std::max({scale, kLeastScale * static_cast<float>(scene.comparison.diagonal_m), 1e-9f});
  row.scale_m = static_cast<double>(scale);
  row.ramp = ramp_of_styles();
  for (std::size_t d = 0; d < scene.deformers.size(); ++d) {
    const HeatMap heat = compare(shapes[d], wanted, scale);
    row.errors.push_back(shoot(shapes[d], from,
                               fmt::format("{}: off by up to {}", scene.comparison.rows[scene.deformers[d]].deformer,
                                           length_text(static_cast<double>(heat.largest))),
                               &heat));
  }
}

}  // namespace marrow::tools
