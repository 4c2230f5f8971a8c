#include "commands/compare/stage.h"

#include <algorithm>

#include <fmt/format.h>

#include "common/check_status.h"
#include "cook/scene/matrices.h"
#include "deform/surface.h"
#include "disk/cook_on_disk.h"
#include "image/jpeg.h"
#include "render/legend.h"
#include "text/quantity.h"

namespace marrow::tools {
namespace {

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
  textures_.emplace(*gl_, source, file_, places_beside(source));
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
