// Morph targets, palettes, deformers.
#include <cmath>

#include <gtest/gtest.h>

#include "support/family.h"
#include "support/morphs.h"
#include "support/surface.h"
#include "unit/misuse/misuse.h"

namespace marrow::test {
namespace {

// A mesh with everything that a deformer may want, and triangles.
struct Skinned {
  Skinned()
      : morphs(3, stage().mesh.geometry.slot_count, 6),
        weights(5, stage().mesh, 1),
        poses(7, stage().mesh, 5),
        sheet(make_sheet(11, 8, 4, 4, false)),
        surface(sheet.vertices, sheet.triangles, std::vector<Map>(4)) {
    morphed = weighed = posed = stage().mesh;
    morphs.put(morphed.geometry);
    morphed.targets = targets = std::vector<MeshTarget>(6);
    weights.put(weighed.geometry);
    poses.put(posed.geometry);
    sheet_mesh = surface.view();
  }
  TestMorphs morphs;
  TestMultiWeights weights;
  TestPoseSpace poses;
  Sheet sheet;
  TestSurface surface;
  std::vector<MeshTarget> targets;
  Mesh morphed, weighed, posed, sheet_mesh;
};

const Skinned& skinned() {
  static const Skinned made;
  return made;
}

// A mesh without normals, or with fewer joints than its geometry follows, or none at all, now and then.
Mesh mesh_of(Misuse& m, const Mesh& good = stage().mesh) {
  Mesh other = good;
  other.joint_count = 1;
  Mesh mesh = m.either(m.either(good, other), Mesh{});
  mesh.geometry.normals = m.pointer(mesh.geometry.normals);
  mesh.geometry.tangents = m.pointer(mesh.geometry.tangents);
  return mesh;
}

// One in four is skinned without normals and tangents.
bool has_normals(const Misuse& m) {
  return m.round() % 4 != 0;
}

// To be skinned: without what is asked for, off its boundaries, with another one's geometry.
Mesh skinned_mesh_of(Misuse& m, const Mesh& good = stage().mesh) {
  Mesh mesh = m.either(good, Mesh{});
  Geometry& g = mesh.geometry;
  if (m.spoils("another mesh's geometry")) --mesh.joint_count;
  // Where there are any: no pointer may be moved from null.
  const auto move = [](auto*& first) { first += first != nullptr ? 1 : 0; };
  if (m.spoils("vertices off their boundary")) move(g.skin);
  if (!has_normals(m)) {
    g.normals = g.tangents = nullptr;
    return mesh;
  }
  if (m.spoils("normals off their boundary")) move(g.normals);
  if (m.spoils("tangents off their boundary")) move(g.tangents);
  if (m.spoils("normals that are not there")) g.normals = nullptr;
  if (m.spoils("tangents that are not there")) g.tangents = nullptr;
  return mesh;
}

SkinOutput output_of(Misuse& m) {
  const std::size_t slots = stage().mesh.geometry.slot_count, more = has_normals(m) ? slots : 0;
  return {m.out<float>(slots * 3), m.out<float>(more * 3, Length::exact_or_none),
          m.out<float>(more * 4, Length::exact_or_none), m.kind(NormalTransform::inverse_transpose)};
}

std::vector<float> coordinates_of(const Mesh& mesh) {
  std::vector<float> out(as_coordinate_count(mesh.geometry));
  EXPECT_EQ(as_coordinates(mesh.geometry, out), Status::ok);
  return out;
}

std::vector<float> distances() {
  std::vector<float> out(psd_distance_count(skinned().posed.geometry));
  EXPECT_EQ(psd_distances(skinned().posed.geometry, stage().palette, out), Status::ok);
  return out;
}

// An instance in good order, in memory that stays.
struct Instance {
  Instance() : memory(morphed_bytes(skinned().morphed.geometry) / sizeof(Affine) + 1) {
    EXPECT_EQ(make_morphed(skinned().morphed.geometry,
                           {reinterpret_cast<std::byte*>(memory.data()), memory.size() * sizeof(Affine)}, morphed),
              Status::ok);
  }
  std::vector<Affine> memory;
  MorphedGeometry morphed;
};

std::vector<MisuseRow> rows_of_morphs() {
  return {
      {"morph_weights",
       [](Misuse& m) {
         const std::vector<std::uint32_t> channels = {0, 1, kNoChannel, 2, kNoChannel, 0};
         const std::vector<float> values = {0.5f, 1, 2};
         const Span<float> out = m.out<float>(6);
         m.returned(morph_weights(m.either(skinned().morphed, stage().mesh), m.in(channels, Length::exact_or_none),
                                  m.in(values), out));
       }},
      {"morphed_bytes",
       [](Misuse& m) {
         (void)morphed_bytes(m.either(skinned().morphed, Mesh{}).geometry);
         m.returned_ok();
       }},
      {"make_morphed",
       [](Misuse& m) {
         const Geometry& g = m.either(skinned().morphed, stage().mesh).geometry;
         MorphedGeometry& out = m.one(MorphedGeometry{});
         m.returned(make_morphed(g, m.memory(morphed_bytes(g)), out));
       }},
      {"morph",
       [](Misuse& m) {
         Instance instance;
         std::vector<float> weights = skinned().morphs.weights;
         for (float& w : weights) w = m.number(w);
         m.returned(morph(m.in(weights), instance.morphed));
       }},
      {"morph_coordinates",
       [](Misuse& m) {
         Instance instance;
         EXPECT_EQ(morph(skinned().morphs.weights, instance.morphed), Status::ok);
         m.returned(morph_coordinates(instance.morphed, m.out(coordinates_of(skinned().morphed))));
       }},
  };
}

// A space by hand, each of whose spans may be short, null or off its boundary.
ExampleSpace space_of(Misuse& m) {
  static const std::vector<ExampleParameter> parameters(2);
  static const std::vector<std::uint32_t> targets = {1, 3, 4};
  static const std::vector<float> linear(12, 0.25f), radial(16, 0.5f), places = {0, 0, 1, 0, 0, 1, 1, 1}, widths(4, 1);
  ExampleSpace out;
  out.example_count = m.index(4);
  out.parameters = parameters;
  out.targets = m.in(targets, Length::any);
  out.linear = m.in(linear);
  out.radial = m.in(radial);
  out.places = m.in(places);
  out.inverse_widths = m.in(widths);
  return out;
}

std::vector<MisuseRow> rows_of_examples() {
  return {
      {"find_example_channels",
       [](Misuse& m) {
         const std::vector<ExampleParameter> parameters(2);
         ExampleSpace space;
         space.parameters = m.in(parameters, Length::any);
         const Span<std::uint32_t> out = m.out<std::uint32_t>(2);
         m.returned(find_example_channels(File{}, space, File{}, m.either(stage().creature.clip.view(), Clip{}), out));
       }},
      {"evaluate_examples",
       [](Misuse& m) {
         const ExampleSpace space = space_of(m);
         const std::vector<float> parameters = {m.number(0.5f), m.number(0.25f)};
         const Span<float> out = m.out<float>(5);
         m.returned(evaluate_examples(space, m.in(parameters), out));
       }},
  };
}

std::vector<MisuseRow> rows_of_palettes() {
  return {
      {"build_palette",
       [](Misuse& m) {
         std::vector<std::uint16_t> joints = stage().creature.mesh.joints;
         if (m.spoils("a joint that the skeleton has not"))
           joints.back() = static_cast<std::uint16_t>(stage().joints.size());
         const std::vector<Helper> helper = {
             {static_cast<std::uint16_t>(m.index(1)), static_cast<std::uint16_t>(m.index(2)), m.number(0.5f)}};
         const std::vector<float> centre = {m.number(0.1f), m.number(0.2f), m.number(0.3f)};
         const Span<Affine> out = m.out<Affine>(stage().palette.size() + 1);
         m.returned(build_palette(m.in(joints, Length::any), m.in(stage().creature.mesh.inverse_bind),
                                  m.in(stage().joints), out, m.in(helper, Length::any), m.in(centre, Length::any)));
       }},
      {"build_palette",
       [](Misuse& m) {
         const Span<Affine> out = m.out<Affine>(stage().palette.size());
         m.returned(build_palette(mesh_of(m), m.in(stage().joints), out));
       }},
      {"palette_size", [](Misuse& m) { m.returned(static_cast<float>(mesh_of(m).palette_size())); }},
      {"extents_bytes",
       [](Misuse& m) {
         (void)extents_bytes(m.either(skinned().morphed, Mesh{}));
         m.returned_ok();
       }},
      {"make_extents",
       [](Misuse& m) {
         const Mesh& mesh = m.either(skinned().morphed, stage().mesh);
         MeshExtents& out = m.one(MeshExtents{});
         m.returned(make_extents(mesh, m.memory(extents_bytes(mesh)), out));
       }},
      {"palette_bounds",
       [](Misuse& m) {
         std::vector<JointExtent> joints(stage().palette.size());
         std::vector<MorphExtent> targets(3);
         MeshExtents extents;
         extents.joints = joints;
         extents.targets = targets;
         std::vector<float> weights = {0.5f, -1, 2};
         for (float& w : weights) w = m.number(w);
         Bounds& out = m.one(Bounds{});
         m.returned(palette_bounds(extents, m.in(stage().palette), m.in(weights, Length::exact_or_none), out));
       }},
      {"turns_inside_out",
       [](Misuse& m) {
         const Span<const Affine> palette = m.in(stage().palette);
         // A null pointer and a boundary are nothing that it could refuse.
         if (palette.data != nullptr && is_on_boundary(palette.data)) (void)turns_inside_out(palette);
         m.returned_ok();
       }},
      {"turns_inside_out",
       [](Misuse& m) {
         Affine map = stage().palette[0];
         map.rows[1][2] = m.number(0.5f);
         map.rows[0][0] = m.number(1);
         (void)turns_inside_out(map);
         m.returned_ok();
       }},
  };
}

std::vector<MisuseRow> rows_of_animation_space() {
  return {
      {"as_coordinate_count",
       [](Misuse& m) { m.returned(static_cast<float>(as_coordinate_count(mesh_of(m).geometry))); }},
      {"as_tangent_count", [](Misuse& m) { m.returned(static_cast<float>(as_tangent_count(mesh_of(m).geometry))); }},
      {"as_coordinates",
       [](Misuse& m) {
         const Span<float> out = m.out<float>(as_coordinate_count(stage().mesh.geometry));
         m.returned(as_coordinates(mesh_of(m).geometry, out));
       }},
      {"as_tangent_scratch_bytes",
       [](Misuse& m) {
         const Mesh mesh = mesh_of(m, skinned().sheet_mesh);
         const AsPart part{m.pointer(&mesh), {}, {}};
         (void)as_tangent_scratch_bytes({&part, m.truth(true) ? 1u : 0u});
         m.returned_ok();
       }},
      {"as_tangents",
       [](Misuse& m) {
         Mesh mesh = mesh_of(m, skinned().sheet_mesh);
         if (m.spoils("another mesh's geometry")) --mesh.joint_count;
         if (m.spoils("a mesh without normals")) mesh.geometry.normals = nullptr;
         const std::vector<float> coordinates = coordinates_of(skinned().sheet_mesh);
         const AsPart part{m.spoils("no mesh") ? nullptr : &mesh, m.in(coordinates),
                           m.out<float>(as_tangent_count(skinned().sheet_mesh.geometry))};
         const AsPart good{&skinned().sheet_mesh, {}, {}};
         const Span<std::byte> scratch = m.memory(as_tangent_scratch_bytes({&good, 1}), 4);
         m.returned(as_tangents({&part, 1}, scratch));
       }},
      {"skin_as",
       [](Misuse& m) {
         const Mesh mesh = skinned_mesh_of(m);
         const std::vector<float> coordinates = coordinates_of(stage().mesh);
         const std::vector<float> tangents(as_tangent_count(stage().mesh.geometry), 0.25f);
         const SkinOutput out = output_of(m);
         m.returned(skin_as(mesh, m.in(coordinates), m.in(stage().palette), out,
                            m.truth(false) ? m.in(tangents, Length::exact_or_none) : Span<const float>()));
       }},
  };
}

}  // namespace

std::vector<MisuseRow> rows_of_skinning() {
  std::vector<MisuseRow> rows = {
      {"skin_rigid",
       [](Misuse& m) {
         const SkinOutput out = output_of(m);
         m.returned(skin_rigid(skinned_mesh_of(m), m.in(stage().palette), out));
       }},
      {"skin_ssd",
       [](Misuse& m) {
         const SkinOutput out = output_of(m);
         m.returned(skin_ssd(skinned_mesh_of(m), m.in(stage().palette), out));
       }},
      {"skin_mwe",
       [](Misuse& m) {
         const SkinOutput out = output_of(m);
         m.returned(skin_mwe(skinned_mesh_of(m, skinned().weighed), m.in(stage().palette), out));
       }},
      {"psd_distance_count",
       [](Misuse& m) { m.returned(static_cast<float>(psd_distance_count(mesh_of(m, skinned().posed).geometry))); }},
      {"psd_distances",
       [](Misuse& m) {
         const Mesh mesh = mesh_of(m, skinned().posed);
         const Span<float> out = m.out<float>(psd_distance_count(skinned().posed.geometry));
         m.returned(psd_distances(mesh.geometry, m.in(stage().palette), out));
       }},
      {"skin_psd",
       [](Misuse& m) {
         const SkinOutput out = output_of(m);
         m.returned(skin_psd(skinned_mesh_of(m, skinned().posed), m.in(distances()), m.in(stage().palette), out));
       }},
  };
  for (const auto& more : {rows_of_morphs(), rows_of_examples(), rows_of_palettes(), rows_of_animation_space()})
    rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace marrow::test
