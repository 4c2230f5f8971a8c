#include "commands/compare/pictures.h"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "common/aligned_bytes.h"
#include "cook/cook.h"
#include "cook/scene/matrices.h"
#include "deform/surface.h"
#include "render/figure.h"
#include "render/heat.h"
#include "render/legend.h"
#include "render/performance.h"
#include "text/quantity.h"

namespace marrow::tools {
namespace {

constexpr int kSide = 380;
constexpr float kLeastScale = 1e-4f;  // of the diagonal: what is less is no difference that anyone sees

// The study's mesh as the studio draws it.
class Stage {
 public:
  explicit Stage(const Study& study) : study_(study) {
    cook::CookOptions options;
    options.mesh_codec = cook::MeshCodec::none;
    options.keep_vertex_order = true;
    options.raw_clips = true;
    options.most_entries = kMaxJoints;  // a mesh a primitive
    cooked_ = cook::cook_scene(study.scene, options).file;
    bytes_ = AlignedBytes{std::span<const std::byte>(cooked_)};
    check(load({bytes_.data(), bytes_.size()}, file_));
    gl_.emplace();
    studio_.emplace(*gl_, kSide, kSide);
    const std::string& source = study.scene.source;
    textures_.emplace(*gl_, source, file_, places_beside(source));
    figure_.emplace(*gl_, studio_->programs(), file_, &*textures_);
  }

  // Where a deformer has put the vertices in a pose. normals: empty for those of the triangles.
  std::vector<PosedMesh> posed(const deform::Pose& pose, const deform::Positions& positions,
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

  // Framed as `framed` is. heat: its colours instead of the mesh's own, with a legend.
  Picture shoot(const std::vector<PosedMesh>& meshes, const std::vector<PosedMesh>& framed, const std::string& caption,
                const HeatMap* heat) {
    std::vector<glm::vec3> points;
    for (const PosedMesh& mesh : framed)
      for (std::size_t i = 0; i + 2 < mesh.positions.size(); i += 3)
        points.emplace_back(mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]);
    Shot shot;
    for (const glm::vec3& p : points) shot.box.add(p);
    shot.camera = frame_points(points, 1.0f, 0.06f);
    shot.radius = std::max(shot.box.radius(), 1e-6f);
    shot.ground_height = shot.box.min.y;
    std::vector<Drawable> drawables;
    if (heat != nullptr) {
      shot.shading = kHeatShading;
      drawables = figure_->from_cpu(meshes, heat->colours);
    } else {
      drawables = figure_->from_cpu(meshes);
    }
    Image image = studio_->shoot(shot, drawables);
    if (heat != nullptr) draw_legend(image, "off the truth", heat->largest, heat->full_scale);
    return {caption, encode_png(image)};
  }

 private:
  static void put(const glm::dvec3& v, std::size_t slot, std::vector<float>& out) {
    for (int c = 0; c < 3; ++c) out[3 * slot + static_cast<std::size_t>(c)] = static_cast<float>(v[c]);
  }

  const Study& study_;
  std::vector<std::byte> cooked_;
  AlignedBytes bytes_;
  File file_;
  std::optional<Gl> gl_;
  std::optional<Studio> studio_;
  std::optional<Textures> textures_;
  std::optional<Figure> figure_;
};

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
  Stage stage(study);
  const Round& round = study.rounds.front();
  const deform::SkinnedMesh& mesh = study.source.mesh;
  const std::vector<glm::dvec3> bind_normals = deform::vertex_normals(mesh.positions, mesh.indices);
  std::vector<PictureRow> out;
  for (const std::size_t i : worst_poses(round, comparison.rows[deformers.front()].error_of_pose, most)) {
    const HeldPose& held = round.held[i];
    PictureRow row;
    row.title =
        held.clip.empty() ? fmt::format("pose {}", i) : fmt::format("{} at {} s", held.clip, plain_number(held.time_s));
    deform::Positions positions;
    truth(held.pose, positions);
    const std::vector<PosedMesh> wanted = stage.posed(held.pose, positions, {});
    row.shapes.push_back(stage.shoot(wanted, wanted, "truth", nullptr));
    std::vector<std::vector<PosedMesh>> shapes;
    float scale = 0;
    for (const std::size_t d : deformers) {
      const Trained& trained = comparison.trained_in_first_round[d];
      trained.deform(held.pose, positions);
      shapes.push_back(stage.posed(held.pose, positions, shading_normals(trained, bind_normals, held.pose, false)));
      scale = std::max(scale, largest_distance(shapes.back(), wanted));
      row.shapes.push_back(stage.shoot(shapes.back(), wanted, comparison.rows[d].deformer, nullptr));
    }
    scale = std::max({scale, kLeastScale * static_cast<float>(comparison.diagonal_m), 1e-9f});
    row.scale_m = static_cast<double>(scale);
    row.ramp = ramp_of_styles();
    for (std::size_t d = 0; d < deformers.size(); ++d) {
      const HeatMap heat = compare(shapes[d], wanted, scale);
      row.errors.push_back(stage.shoot(shapes[d], wanted,
                                       fmt::format("{}: off by up to {}", comparison.rows[deformers[d]].deformer,
                                                   length_text(static_cast<double>(heat.largest))),
                                       &heat));
    }
    out.push_back(std::move(row));
  }
  return out;
}

}  // namespace marrow::tools
