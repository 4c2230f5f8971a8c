// Poses are the same bits on every processor, with SIMD or without: hashes of what every stage gives, stored here.
//
// A hash that differs on one processor only is a bug there. One that differs on all is a change of results: see that
// the road tests still hold, then store the new one and say why in the commit.
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "support/aligned.h"
#include "support/family.h"
#include "support/golden.h"
#include "support/morphs.h"
#include "support/pose_file.h"
#include "support/poses.h"
#include "support/rig.h"
#include "support/surface.h"

namespace marrow {
namespace {

template <class T>
std::uint64_t hash_of(const std::vector<T>& v, std::uint64_t state = test::kHashStart) {
  return test::hash(state, v.data(), v.size() * sizeof(T));
}

struct Hashes {
  std::uint64_t local = test::kHashStart, model = test::kHashStart, palette = test::kHashStart;
  // Rigid, SSD, AS with exact normals; the same with blended ones.
  std::uint64_t vertices[6] = {test::kHashStart, test::kHashStart, test::kHashStart,
                               test::kHashStart, test::kHashStart, test::kHashStart};
};

void expect_hashes(const Hashes& got, const Hashes& want) {
  EXPECT_EQ(got.local, want.local) << "sample";
  EXPECT_EQ(got.model, want.model) << "local_to_model";
  EXPECT_EQ(got.palette, want.palette) << "build_palette";
  const char* const names[] = {"rigid", "ssd", "as", "rigid, blended", "ssd, blended", "as, blended"};
  for (int d = 0; d < 6; ++d) EXPECT_EQ(got.vertices[d], want.vertices[d]) << names[d];
  if (::testing::Test::HasFailure()) {
    std::printf("{0x%016llX, 0x%016llX, 0x%016llX, {", 0ULL + got.local, 0ULL + got.model, 0ULL + got.palette);
    for (const std::uint64_t v : got.vertices) std::printf("0x%016llX, ", 0ULL + v);
    std::printf("}}\n");
  }
}

// Forty moments of a creature of noise; vertices by each deformer.
Hashes pose_character(const test::TestCharacter& c) {
  const Skeleton skeleton = c.skeleton.view();
  const Clip clip = c.clip.view();
  const Mesh mesh = c.mesh.view();
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> model(skeleton.joint_count), palette(mesh.joint_count);
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry)), positions(mesh.geometry.slot_count * 3);
  std::vector<float> normals(positions.size()), tangents(mesh.geometry.slot_count * 4);
  EXPECT_EQ(as_coordinates(mesh.geometry, coordinates), Status::ok);
  Hashes h;
  for (int moment = 0; moment < 40; ++moment) {
    EXPECT_EQ(sample(skeleton, clip, static_cast<float>(moment) * 0.0546875f, local), Status::ok);
    EXPECT_EQ(local_to_model(skeleton, local, model), Status::ok);
    EXPECT_EQ(build_palette(mesh, model, palette), Status::ok);
    h.local = hash_of(local, h.local);
    h.model = hash_of(model, h.model);
    h.palette = hash_of(palette, h.palette);
    for (int d = 0; d < 6; ++d) {
      const SkinOutput out{positions, normals, tangents,
                           d < 3 ? NormalTransform::inverse_transpose : NormalTransform::blended_matrix};
      EXPECT_EQ(d % 3 == 0   ? skin_rigid(mesh, palette, out)
                : d % 3 == 1 ? skin_ssd(mesh, palette, out)
                             : skin_as(mesh, coordinates, palette, out),
                Status::ok);
      h.vertices[d] = hash_of(tangents, hash_of(normals, hash_of(positions, h.vertices[d])));
    }
  }
  return h;
}

TEST(Bits, TheCreatureOfNoiseIsItselfTheSame) {
  const test::TestCharacter c = test::make_character(51, 67, 150, false);
  std::uint64_t h = hash_of(c.clip.values, hash_of(c.mesh.skin, hash_of(c.skeleton.rest)));
  h = hash_of(c.mesh.inverse_bind, hash_of(c.mesh.tangents, hash_of(c.mesh.normals, h)));
  EXPECT_EQ(h, 0x9710868BCF1CFB79u) << "the input of the tests below";
}

TEST(Bits, CreatureOfNoise) {
  expect_hashes(pose_character(test::make_character(51, 67, 150, false)),
                {0xD7885F5C53EEE295,
                 0xC37D058FF32F6F79,
                 0x5EF9EA3346008E53,
                 {0xCD9A9BD3C93216B7, 0x7DB7971F09C904D5, 0x329A05E316075D1B, 0x415B8FE16EAAC0D2, 0x47F9E5D7F59CCF70,
                  0x9BFC5D5F8DE93A9E}});
}

TEST(Bits, CreatureOfNoiseWithResiduals) {
  expect_hashes(pose_character(test::make_character(52, 34, 90, true)),
                {0x864A09F7B392E4DA,
                 0x87E0E1E053627420,
                 0x2991113F2FC9A40C,
                 {0x734C3F0E1F5BA270, 0x2B2438A337C8A20D, 0xA1D01A567C91AB9D, 0x5F06B979E1A57093, 0xBE3F31E331E3B350,
                  0xD288E1A55DA013D6}});
}

// A rotating and a plain curve of every kind at sixty moments.
std::uint64_t curves_hash(test::Random& random) {
  std::uint64_t h = test::kHashStart;
  for (int kind = 0; kind <= static_cast<int>(CurveKind::centripetal); ++kind) {
    for (const bool rotation : {false, true}) {
      std::vector<float> times(6), values(curve_value_count(static_cast<CurveKind>(kind), 4, times.size()));
      for (std::size_t k = 0; k < times.size(); ++k) times[k] = static_cast<float>(k * k + k) * 0.15625f;
      for (std::size_t i = 0; i < values.size(); i += 4) {
        const test::Quat q = rotation ? random.rotation()
                                      : test::Quat{random.between(-2, 2), random.between(-2, 2), random.between(-2, 2),
                                                   random.between(-2, 2)};
        for (std::size_t c = 0; c < 4; ++c) values[i + c] = static_cast<float>(q[c]);
      }
      const Curve curve{static_cast<CurveKind>(kind), rotation, 4, times, values};
      std::vector<float> out(4), velocity(4);
      for (int moment = 0; moment < 60; ++moment) {
        const float time_s = static_cast<float>(moment) * 0.078125f;
        EXPECT_EQ(evaluate_curve(curve, time_s, out), Status::ok);
        EXPECT_EQ(curve_velocity(curve, time_s, velocity), rotation ? Status::unsupported : Status::ok);
        h = hash_of(velocity, hash_of(out, h));
      }
    }
  }
  return h;
}

// Control points without keys, a spline and its lengths.
std::uint64_t paths_hash(test::Random& random) {
  std::vector<float> times(12), values(48), spline(144), lengths(11 * 8 + 1), scratch(48), out(4);
  for (std::size_t k = 0; k < times.size(); ++k) times[k] = static_cast<float>(k) + 0.25f * static_cast<float>(k % 3);
  for (float& f : values) f = static_cast<float>(random.between(-2, 2));
  EXPECT_EQ(natural_spline({CurveKind::linear, false, 4, times, values}, spline), Status::ok);
  const Curve curve{CurveKind::hermite, false, 4, times, spline};
  EXPECT_EQ(build_arc_length(curve, 8, lengths), Status::ok);
  std::uint64_t h = hash_of(lengths, hash_of(spline));
  for (int i = 0; i <= 64; ++i) {
    const float u = static_cast<float>(i) / 64;
    float time_s = 0;
    EXPECT_EQ(time_at_distance(curve, {8, lengths}, u * lengths.back(), time_s), Status::ok);
    h = test::hash(h, &time_s, sizeof(time_s));
    EXPECT_EQ(bezier(values, 4, u, scratch, out), Status::ok);
    h = hash_of(out, h);
    for (const PatchBasis basis : {PatchBasis::catmull_rom, PatchBasis::bezier}) {
      EXPECT_EQ(bicubic_patch(basis, values, 3, u, 1 - u * u, out), Status::ok);
      h = hash_of(out, h);
    }
  }
  return h;
}

std::uint64_t easings_hash() {
  std::uint64_t h = test::kHashStart;
  for (int i = 0; i <= 500; ++i) {
    const float u = static_cast<float>(i) / 500;
    std::vector<float> out(1);
    for (int easing = 0; easing <= static_cast<int>(Easing::bounce); ++easing) {
      for (const EaseMode mode : {EaseMode::in, EaseMode::out, EaseMode::in_out})
        out.push_back(ease(static_cast<Easing>(easing), mode, u));
    }
    EXPECT_EQ(ease(CubicBezierEase{}, u, out[0]), Status::ok);
    h = hash_of(out, h);
  }
  return h;
}

TEST(Bits, Curves) {
  test::Random random(53);
  EXPECT_EQ(curves_hash(random), 0xA7B621FF61A04C56u) << "kinds of curves";
  EXPECT_EQ(paths_hash(random), 0x0971799CF199F8C9u) << "splines, arc length, Bézier curves and patches";
  EXPECT_EQ(easings_hash(), 0x103498BA5D13A5C3u) << "easings";
}

// Every way through blend, overlay, add and inertialisation, on poses of noise.
TEST(Bits, BlendsAndTransitions) {
  test::Poses p(53, 67, 6);
  std::uint64_t blended = test::kHashStart, inertial = test::kHashStart;
  for (std::size_t count = 0; count <= 6; ++count) {
    for (const bool masked : {false, true}) {
      std::vector<BlendLayer> layers;
      for (std::size_t l = 0; l < count; ++l)
        layers.push_back({p.pose[l], 0.25f + static_cast<float>(l), masked ? p.masks(l) : Span<const float>()});
      EXPECT_EQ(blend(p.skeleton, layers, p.out), Status::ok);
      blended = hash_of(p.out, blended);
    }
  }
  std::vector<AdditiveTransform> change(p.groups());
  EXPECT_EQ(make_additive(p.skeleton, p.pose[0], p.pose[1], change), Status::ok);
  EXPECT_EQ(overlay(p.skeleton, {p.pose[2], 0.75f, p.masks(2)}, p.out), Status::ok);
  EXPECT_EQ(add(p.skeleton, {change, 0.5f, p.masks(3)}, p.out), Status::ok);
  blended = hash_of(change, hash_of(p.out, blended));

  std::vector<InertialOffset> memory(p.groups());
  Inertia inertia;
  inertia.offsets = memory;
  EXPECT_EQ(begin_inertia(p.skeleton, {p.pose[0], p.pose[1], p.pose[2], p.pose[3], 0.015625f}, 0.5f, inertia),
            Status::ok);
  inertial = hash_of(memory, inertial);
  for (int moment = 0; moment < 20; ++moment) {
    p.out = p.pose[2];
    const float time_s = static_cast<float>(moment) * 0.028f;
    EXPECT_EQ(apply_inertia(p.skeleton, inertia, time_s, p.out), Status::ok);
    inertial = hash_of(p.out, inertial);
    const float fade[] = {fade_weight(Fade::smoothstep, time_s, 0.5f), fade_weight(Fade::smootherstep, time_s, 0.5f)};
    inertial = test::hash(inertial, fade, sizeof fade);
  }
  EXPECT_EQ(blended, 0x8B281A8A3AC9C450u) << "blend, overlay, add";
  EXPECT_EQ(inertial, 0x6D13E9D127642971u) << "inertialisation, fades";
}

TEST(Bits, Playback) {
  test::Random random(54);
  std::uint64_t h = test::kHashStart;
  for (int i = 0; i < 3000; ++i) {
    Playback p;
    p.mode = static_cast<PlayMode>(i % 3);
    for (int frame = 0; frame < 20; ++frame) {
      p.speed = static_cast<float>(random.between(-3, 3));
      EXPECT_EQ(advance(p, 1.0f / static_cast<float>(1 + i % 7), static_cast<float>(random.between(-1, 1))),
                Status::ok);
      h = test::hash(test::hash(h, &p.time_s, sizeof p.time_s), &p.turns, sizeof p.turns);
    }
  }
  EXPECT_EQ(h, 0x4F2CABAC9C6F885Cu);
}

TEST(Bits, Morphs) {
  const test::TestCharacter c = test::make_character(55, 24, 11, true);
  Mesh mesh = c.mesh.view();
  const test::TestMorphs morphs(56, mesh.geometry.slot_count, 6);
  morphs.put(mesh.geometry);
  test::AlignedBlock memory(morphed_bytes(mesh.geometry));
  MorphedGeometry morphed;
  ASSERT_EQ(make_morphed(mesh.geometry, {memory.data(), memory.size()}, morphed), Status::ok);
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry)), weights = morphs.weights;
  EXPECT_EQ(as_coordinates(mesh.geometry, coordinates), Status::ok);
  std::uint64_t h = test::kHashStart;
  for (int frame = 0; frame < 10; ++frame) {
    weights[static_cast<std::size_t>(frame) % weights.size()] *= -0.75f;
    EXPECT_EQ(morph(weights, morphed), Status::ok);
    EXPECT_EQ(morph_coordinates(morphed, coordinates), Status::ok);
    const Geometry& g = morphed.geometry;
    h = hash_of(coordinates, test::hash(h, g.skin, std::size_t{12} * g.slot_count));
    h = test::hash(test::hash(h, g.normals, std::size_t{12} * g.slot_count), g.tangents,
                   std::size_t{16} * g.slot_count);
  }
  EXPECT_EQ(h, 0xE3E4EDF40629573Du);
}

// Multi-weight enveloping and pose-space deformation, with exact and blended normals.
TEST(Bits, Family) {
  const test::TestCharacter c = test::make_character(57, 34, 90, false);
  const Skeleton skeleton = c.skeleton.view();
  const Clip clip = c.clip.view();
  Mesh mesh = c.mesh.view();
  const test::TestMultiWeights weights(58, mesh, 5);
  weights.put(mesh.geometry);
  const test::TestPoseSpace space(59, mesh, 7);
  space.put(mesh.geometry);
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> model(skeleton.joint_count), palette(mesh.joint_count);
  std::vector<float> distances(psd_distance_count(mesh.geometry)), positions(mesh.geometry.slot_count * 3);
  std::vector<float> normals(positions.size()), tangents(mesh.geometry.slot_count * 4);
  std::uint64_t mwe = test::kHashStart, psd = test::kHashStart;
  for (int moment = 0; moment < 40; ++moment) {
    EXPECT_EQ(sample(skeleton, clip, static_cast<float>(moment) * 0.0546875f, local), Status::ok);
    EXPECT_EQ(local_to_model(skeleton, local, model), Status::ok);
    EXPECT_EQ(build_palette(mesh, model, palette), Status::ok);
    EXPECT_EQ(psd_distances(mesh.geometry, palette, distances), Status::ok);
    psd = hash_of(distances, psd);
    for (const NormalTransform t : {NormalTransform::inverse_transpose, NormalTransform::blended_matrix}) {
      const SkinOutput out{positions, normals, tangents, t};
      EXPECT_EQ(skin_mwe(mesh, palette, out), Status::ok);
      mwe = hash_of(tangents, hash_of(normals, hash_of(positions, mwe)));
      EXPECT_EQ(skin_psd(mesh, distances, palette, out), Status::ok);
      psd = hash_of(tangents, hash_of(normals, hash_of(positions, psd)));
    }
  }
  EXPECT_EQ(mwe, 0xDBFEE162F0108126u);
  EXPECT_EQ(psd, 0x1A75385F8B210DF4u);
}

// Animation space with normals through tangents.
TEST(Bits, SurfaceNormals) {
  const test::Sheet sheet = test::make_sheet(60, 12, 9, 8, true);
  const test::TestSurface surface(sheet.vertices, sheet.triangles, std::vector<test::Map>(9), true);
  const Mesh mesh = surface.view();
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry)), tau(as_tangent_count(mesh.geometry));
  std::vector<float> positions(mesh.geometry.slot_count * 3), normals(positions.size()),
      tangents(mesh.geometry.slot_count * 4);
  EXPECT_EQ(as_coordinates(mesh.geometry, coordinates), Status::ok);
  const AsPart part{&mesh, coordinates, tau};
  std::vector<std::uint32_t> scratch(as_tangent_scratch_bytes({&part, 1}) / 4);
  EXPECT_EQ(as_tangents({&part, 1}, {reinterpret_cast<std::byte*>(scratch.data()), scratch.size() * 4}), Status::ok);
  EXPECT_EQ(hash_of(tau), 0x4C48EC061FD99C0Bu) << "as_tangents";
  test::Random random(61);
  std::uint64_t h = test::kHashStart;
  for (int moment = 0; moment < 10; ++moment) {
    std::vector<Affine> palette;
    for (int j = 0; j < 9; ++j) {
      const test::Vec3 t{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
      palette.push_back(test::to_affine(test::from_trs(t, random.rotation(), {1, j % 4 == 3 ? -1.0 : 1.0, 1})));
    }
    EXPECT_EQ(skin_as(mesh, coordinates, palette, {positions, normals, tangents}, tau), Status::ok);
    h = hash_of(tangents, hash_of(normals, hash_of(positions, h)));
  }
  EXPECT_EQ(h, 0xEAA4E4084A861FF4u) << "skin_as";
}

TEST(Bits, GoldenFile) {
  test::AlignedBlock block = test::golden_copy();
  File file;
  ASSERT_EQ(load(block, file), Status::ok);
  EXPECT_EQ(test::exercise(file), 0xCC73CA0C866C4361u);
}

TEST(Bits, ChannelsAndAdditiveClips) {
  test::AlignedBlock block = test::golden_channels_copy();
  File file;
  ASSERT_EQ(load(block, file), Status::ok);
  ASSERT_EQ(file.clip(0).channels.size, 7u);
  EXPECT_EQ(test::exercise(file), 0x805BF74F6C8D50A9u);
}

TEST(Bits, UnevenClip) {
  test::AlignedBlock block = test::golden_uneven_copy();
  File file;
  ASSERT_EQ(load(block, file), Status::ok);
  ASSERT_NE(file.clip(0).coded.times_s, nullptr);
  EXPECT_EQ(test::exercise(file), 0xAFBEA18630CBECCAu);
}

TEST(Bits, CodedClip) {
  test::AlignedBlock block = test::golden_coded_copy();
  File file;
  ASSERT_EQ(load(block, file), Status::ok);
  ASSERT_GT(file.clip(0).coded.frame_count, 0u);
  EXPECT_EQ(test::exercise(file), 0x1F17210C405D98E0u);
}

}  // namespace
}  // namespace marrow
