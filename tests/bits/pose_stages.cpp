// Sampling, matrices, palettes, deformers, blends, curves and playback, on creatures of noise.
#include <cstdio>
#include <cstdlib>
#include <iterator>

#include "bits/stages.h"
#include "support/aligned.h"
#include "support/family.h"
#include "support/morphs.h"
#include "support/rig.h"
#include "support/surface.h"

namespace marrow::test {
namespace {

// Forty moments of a creature of noise; vertices by each deformer.
void hash_creature(const TestCharacter& c, StageHashes& out_hashes) {
  const Skeleton skeleton = c.skeleton.view();
  const Clip clip = c.clip.view();
  const Mesh mesh = c.mesh.view();
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> model(skeleton.joint_count), palette(mesh.joint_count);
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry)), positions(mesh.geometry.slot_count * 3);
  std::vector<float> normals(positions.size()), tangents(mesh.geometry.slot_count * 4);
  must(as_coordinates(mesh.geometry, coordinates));
  std::uint64_t locals = kHashStart, models = kHashStart, palettes = kHashStart;
  std::uint64_t vertices[6];
  for (std::uint64_t& v : vertices) v = kHashStart;
  for (int moment = 0; moment < 40; ++moment) {
    must(sample(skeleton, clip, static_cast<float>(moment) * 0.0546875f, local));
    must(local_to_model(skeleton, local, model));
    must(build_palette(mesh, model, palette));
    locals = hash_of(local, locals);
    models = hash_of(model, models);
    palettes = hash_of(palette, palettes);
    for (int d = 0; d < 6; ++d) {
      const SkinOutput out{positions, normals, tangents,
                           d < 3 ? NormalTransform::inverse_transpose : NormalTransform::blended_matrix};
      must(d % 3 == 0   ? skin_rigid(mesh, palette, out)
           : d % 3 == 1 ? skin_ssd(mesh, palette, out)
                        : skin_as(mesh, coordinates, palette, out));
      vertices[d] = hash_of(tangents, hash_of(normals, hash_of(positions, vertices[d])));
    }
  }
  const StageHash hashes[] = {{"sample", locals},
                              {"local_to_model", models},
                              {"build_palette", palettes},
                              {"skin_rigid", vertices[0]},
                              {"skin_ssd", vertices[1]},
                              {"skin_as", vertices[2]},
                              {"skin_rigid, normals blended", vertices[3]},
                              {"skin_ssd, normals blended", vertices[4]},
                              {"skin_as, normals blended", vertices[5]}};
  out_hashes.insert(out_hashes.end(), std::begin(hashes), std::end(hashes));
}

// What the stages are given; if it differs, so does all that follows.
std::uint64_t creature_hash(const TestCharacter& c) {
  const std::uint64_t h = hash_of(c.clip.values, hash_of(c.mesh.skin, hash_of(c.skeleton.rest)));
  return hash_of(c.mesh.inverse_bind, hash_of(c.mesh.tangents, hash_of(c.mesh.normals, h)));
}

// A rotating and a plain curve of every kind at sixty moments.
std::uint64_t curves_hash(Random& random) {
  std::uint64_t h = kHashStart;
  for (int kind = 0; kind <= static_cast<int>(CurveKind::centripetal); ++kind) {
    for (const bool rotation : {false, true}) {
      std::vector<float> times(6), values(curve_value_count(static_cast<CurveKind>(kind), 4, times.size()));
      for (std::size_t k = 0; k < times.size(); ++k) times[k] = static_cast<float>(k * k + k) * 0.15625f;
      for (std::size_t i = 0; i < values.size(); i += 4) {
        const Quat q =
            rotation ? random.rotation()
                     : Quat{random.between(-2, 2), random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)};
        for (std::size_t c = 0; c < 4; ++c) values[i + c] = static_cast<float>(q[c]);
      }
      const Curve curve{static_cast<CurveKind>(kind), rotation, 4, times, values};
      std::vector<float> out(4), velocity(4);
      for (int moment = 0; moment < 60; ++moment) {
        const float time_s = static_cast<float>(moment) * 0.078125f;
        must(evaluate_curve(curve, time_s, out));
        must(curve_velocity(curve, time_s, velocity), rotation ? Status::unsupported : Status::ok);
        h = hash_of(velocity, hash_of(out, h));
      }
    }
  }
  return h;
}

// Control points without keys, a spline and its lengths.
std::uint64_t paths_hash(Random& random) {
  std::vector<float> times(12), values(48), spline(144), lengths(11 * 8 + 1), scratch(48), out(4);
  for (std::size_t k = 0; k < times.size(); ++k) times[k] = static_cast<float>(k) + 0.25f * static_cast<float>(k % 3);
  for (float& f : values) f = static_cast<float>(random.between(-2, 2));
  must(natural_spline({CurveKind::linear, false, 4, times, values}, spline));
  const Curve curve{CurveKind::hermite, false, 4, times, spline};
  must(make_arc_length(curve, 8, lengths));
  std::uint64_t h = hash_of(lengths, hash_of(spline));
  for (int i = 0; i <= 64; ++i) {
    const float u = static_cast<float>(i) / 64;
    float time_s = 0;
    must(time_at_distance(curve, {8, lengths}, u * lengths.back(), time_s));
    h = hash(h, &time_s, sizeof(time_s));
    must(bezier(values, 4, u, scratch, out));
    h = hash_of(out, h);
    for (const PatchBasis basis : {PatchBasis::catmull_rom, PatchBasis::bezier}) {
      must(bicubic_patch(basis, values, 3, u, 1 - u * u, out));
      h = hash_of(out, h);
    }
  }
  return h;
}

std::uint64_t easings_hash() {
  std::uint64_t h = kHashStart;
  for (int i = 0; i <= 500; ++i) {
    const float u = static_cast<float>(i) / 500;
    std::vector<float> out(1);
    for (int easing = 0; easing <= static_cast<int>(Easing::bounce); ++easing) {
      for (const EaseMode mode : {EaseMode::in, EaseMode::out, EaseMode::in_out})
        out.push_back(ease(static_cast<Easing>(easing), mode, u));
    }
    must(ease(CubicBezierEase{}, u, out[0]));
    h = hash_of(out, h);
  }
  return h;
}

void hash_curves(StageHashes& out) {
  Random random(53);
  out.push_back({"evaluate_curve", curves_hash(random)});
  out.push_back({"splines, lengths, Bezier curves", paths_hash(random)});
  out.push_back({"ease", easings_hash()});
}

// Every way through blend, overlay, add and inertialisation, on poses of noise.
void hash_blends(StageHashes& out) {
  Poses p(53, 67, 6);
  std::uint64_t blended = kHashStart, inertial = kHashStart;
  for (std::size_t count = 0; count <= 6; ++count) {
    for (const bool masked : {false, true}) {
      std::vector<BlendLayer> layers;
      for (std::size_t l = 0; l < count; ++l)
        layers.push_back({p.pose[l], 0.25f + static_cast<float>(l), masked ? p.masks(l) : Span<const float>()});
      must(blend(p.skeleton, layers, p.out));
      blended = hash_of(p.out, blended);
    }
  }
  std::vector<AdditiveTransform> change(p.groups());
  must(make_additive(p.skeleton, p.pose[0], p.pose[1], change));
  must(overlay(p.skeleton, {p.pose[2], 0.75f, p.masks(2)}, p.out));
  must(add(p.skeleton, {change, 0.5f, p.masks(3)}, p.out));
  blended = hash_of(change, hash_of(p.out, blended));
  std::vector<Affine> scratch(67);
  must(overlay_in_model_space(p.skeleton, {p.pose[4], 0.75f, p.masks(4)}, p.out, scratch));
  blended = hash_of(p.out, blended);

  std::vector<InertialOffset> memory(p.groups());
  Inertia inertia;
  inertia.offsets = memory;
  must(begin_inertia(p.skeleton, {p.pose[0], p.pose[1], p.pose[2], p.pose[3], 0.015625f}, 0.5f, inertia));
  inertial = hash_of(memory, inertial);
  for (int moment = 0; moment < 20; ++moment) {
    p.out = p.pose[2];
    const float time_s = static_cast<float>(moment) * 0.028f;
    must(apply_inertia(p.skeleton, inertia, time_s, p.out));
    inertial = hash_of(p.out, inertial);
    const float fade[] = {fade_weight(Fade::smoothstep, time_s, 0.5f), fade_weight(Fade::smootherstep, time_s, 0.5f)};
    inertial = hash(inertial, fade, sizeof fade);
  }
  out.push_back({"blend, overlay, add", blended});
  out.push_back({"inertia, fades", inertial});
}

void hash_playback(StageHashes& out) {
  Random random(54);
  std::uint64_t h = kHashStart;
  for (int i = 0; i < 3000; ++i) {
    Playback p;
    p.mode = static_cast<PlayMode>(i % 3);
    for (int frame = 0; frame < 20; ++frame) {
      p.speed = static_cast<float>(random.between(-3, 3));
      must(advance(p, 1.0f / static_cast<float>(1 + i % 7), static_cast<float>(random.between(-1, 1))));
      h = hash(hash(h, &p.time_s, sizeof p.time_s), &p.turns, sizeof p.turns);
    }
  }
  out.push_back({"advance", h});
}

void hash_morphs(StageHashes& out) {
  const TestCharacter c = make_character(55, 24, 11, true);
  Mesh mesh = c.mesh.view();
  const TestMorphs morphs(56, mesh.geometry.slot_count, 6);
  morphs.put(mesh.geometry);
  AlignedBlock memory(morphed_bytes(mesh.geometry));
  MorphedGeometry morphed;
  must(make_morphed(mesh.geometry, {memory.data(), memory.size()}, morphed));
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry)), weights = morphs.weights;
  must(as_coordinates(mesh.geometry, coordinates));
  std::uint64_t h = kHashStart;
  for (int frame = 0; frame < 10; ++frame) {
    weights[static_cast<std::size_t>(frame) % weights.size()] *= -0.75f;
    must(morph(weights, morphed));
    must(morph_coordinates(morphed, coordinates));
    const Geometry& g = morphed.geometry;
    h = hash_of(coordinates, hash(h, g.skin, std::size_t{12} * g.slot_count));
    h = hash(hash(h, g.normals, std::size_t{12} * g.slot_count), g.tangents, std::size_t{16} * g.slot_count);
  }
  out.push_back({"morph", h});
}

// Multi-weight enveloping and pose-space deformation, with exact and blended normals.
void hash_family(StageHashes& out) {
  const TestCharacter c = make_character(57, 34, 90, false);
  const Skeleton skeleton = c.skeleton.view();
  const Clip clip = c.clip.view();
  Mesh mesh = c.mesh.view();
  const TestMultiWeights weights(58, mesh, 5);
  weights.put(mesh.geometry);
  const TestPoseSpace space(59, mesh, 7);
  space.put(mesh.geometry);
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> model(skeleton.joint_count), palette(mesh.joint_count);
  std::vector<float> distances(psd_distance_count(mesh.geometry)), positions(mesh.geometry.slot_count * 3);
  std::vector<float> normals(positions.size()), tangents(mesh.geometry.slot_count * 4);
  std::uint64_t mwe = kHashStart, psd = kHashStart;
  for (int moment = 0; moment < 40; ++moment) {
    must(sample(skeleton, clip, static_cast<float>(moment) * 0.0546875f, local));
    must(local_to_model(skeleton, local, model));
    must(build_palette(mesh, model, palette));
    must(psd_distances(mesh.geometry, palette, distances));
    psd = hash_of(distances, psd);
    for (const NormalTransform t : {NormalTransform::inverse_transpose, NormalTransform::blended_matrix}) {
      const SkinOutput vertices{positions, normals, tangents, t};
      must(skin_mwe(mesh, palette, vertices));
      mwe = hash_of(tangents, hash_of(normals, hash_of(positions, mwe)));
      must(skin_psd(mesh, distances, palette, vertices));
      psd = hash_of(tangents, hash_of(normals, hash_of(positions, psd)));
    }
  }
  out.push_back({"skin_mwe", mwe});
  out.push_back({"skin_psd", psd});
}

// Animation space with normals through tangents.
void hash_surface_normals(StageHashes& out) {
  const Sheet sheet = make_sheet(60, 12, 9, 8, true);
  const TestSurface surface(sheet.vertices, sheet.triangles, std::vector<Map>(9), true);
  const Mesh mesh = surface.view();
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry)), tau(as_tangent_count(mesh.geometry));
  std::vector<float> positions(mesh.geometry.slot_count * 3), normals(positions.size()),
      tangents(mesh.geometry.slot_count * 4);
  must(as_coordinates(mesh.geometry, coordinates));
  const AsPart part{&mesh, coordinates, tau};
  std::vector<std::uint32_t> scratch(as_tangent_scratch_bytes({&part, 1}) / 4);
  must(as_tangents({&part, 1}, {reinterpret_cast<std::byte*>(scratch.data()), scratch.size() * 4}));
  out.push_back({"as_tangents", hash_of(tau)});
  Random random(61);
  std::uint64_t h = kHashStart;
  for (int moment = 0; moment < 10; ++moment) {
    std::vector<Affine> palette;
    for (int j = 0; j < 9; ++j) {
      const Vec3 t{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
      palette.push_back(to_affine(from_trs(t, random.rotation(), {1, j % 4 == 3 ? -1.0 : 1.0, 1})));
    }
    must(skin_as(mesh, coordinates, palette, {positions, normals, tangents}, tau));
    h = hash_of(tangents, hash_of(normals, hash_of(positions, h)));
  }
  out.push_back({"skin_as, normals by tangents", h});
}

// The same sheet, its last three entries helpers: what a vertex lacks is a sum of its own.
void hash_tangents_of_helpers(StageHashes& out) {
  const Helper helpers[] = {{0, 1, 0.25f}, {0, 1, 0.75f}, {2, 5, 0.5f}};
  const Sheet sheet = make_sheet(60, 12, 9, 8, true);
  const TestSurface surface(sheet.vertices, sheet.triangles, std::vector<Map>(6), true);
  Mesh mesh = surface.view();
  mesh.helpers = helpers;
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry)), tau(as_tangent_count(mesh.geometry));
  must(as_coordinates(mesh.geometry, coordinates));
  const AsPart part{&mesh, coordinates, tau};
  std::vector<std::uint32_t> scratch(as_tangent_scratch_bytes({&part, 1}) / 4);
  must(as_tangents({&part, 1}, {reinterpret_cast<std::byte*>(scratch.data()), scratch.size() * 4}));
  out.push_back({"as_tangents of helpers", hash_of(tau)});
}

// Helpers between joints that only turn, far and near, and between such as have scales, mirrors and no size.
void hash_helpers(StageHashes& out) {
  constexpr double kScales[][3] = {{1, 1, 1}, {1, 1, 1}, {0.5, 2, 1.25}, {-1, 1, 1}, {0, 0, 0}, {1, 0, 1}};
  std::vector<std::uint16_t> joints;
  std::vector<Helper> helpers;
  for (std::uint16_t j = 0; j < 30; ++j) {
    joints.push_back(j);
    for (const float share : {0.25f, 0.5f, 0.7f})
      helpers.push_back({j, static_cast<std::uint16_t>((j + 7) % 30), share});
  }
  Random random(71);
  std::vector<Affine> bind(joints.size()), scene(joints.size()), palette(joints.size() + helpers.size());
  std::vector<float> centres(3 * helpers.size());
  std::uint64_t by_dual_quaternions = kHashStart, about_centres = kHashStart;
  for (std::size_t moment = 0; moment < 24; ++moment) {
    for (std::size_t j = 0; j < joints.size(); ++j) {
      // Draws one after the other: compilers evaluate the arguments of a call in orders of their own.
      const auto placed = [&](const Vec3& scale) {
        const Vec3 place = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        const auto turn = random.rotation();
        return to_affine(from_trs(place, turn, scale));
      };
      const double* const s = kScales[j % 10 == 0 ? moment % std::size(kScales) : 0];
      bind[j] = placed({1, 1, 1});
      scene[j] = placed({s[0], s[1], s[2]});
    }
    for (float& c : centres) c = static_cast<float>(random.between(-1, 1));
    must(build_palette(joints, bind, scene, palette, helpers));
    by_dual_quaternions = hash_of(palette, by_dual_quaternions);
    must(build_palette(joints, bind, scene, palette, helpers, centres));
    about_centres = hash_of(palette, about_centres);
  }
  out.push_back({"helpers", by_dual_quaternions});
  out.push_back({"helpers about centres", about_centres});
}

}  // namespace

void must(Status status, Status wanted) {
  if (status == wanted) return;
  std::fprintf(stderr, "marrow_bits: a call ended with status %d, not %d\n", static_cast<int>(status),
               static_cast<int>(wanted));
  std::abort();
}

void hash_poses(StageHashes& out) {
  const TestCharacter creature = make_character(51, 67, 150, false);
  out.push_back({"the creature of noise", creature_hash(creature)});
  hash_creature(creature, out);
  hash_creature(make_character(52, 34, 90, true), out);
  hash_helpers(out);
  hash_curves(out);
  hash_blends(out);
  hash_playback(out);
  hash_morphs(out);
  hash_family(out);
  hash_surface_normals(out);
  hash_tangents_of_helpers(out);
}

}  // namespace marrow::test
