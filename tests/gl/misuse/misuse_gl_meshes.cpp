// Meshes, programs, palettes, vertices skinned once.
#include <gtest/gtest.h>

#include "gl/misuse/misuse_gl.h"

namespace marrow::test {
namespace {

using namespace gles3;

ProgramKey key_of(Misuse& m, Deformer deformer = Deformer::ssd) {
  return {m.kind(deformer), static_cast<std::uint8_t>(m.index(8)), static_cast<std::uint8_t>(m.index(kNormals)),
          m.kind(Palettes::uniform_block)};
}

ProgramSource source_of(Misuse& m) {
  return {m.pointer("vertex"), m.pointer("fragment"), {}};
}

Program program_of(Misuse& m) {
  Program program = gl_stage().program;
  program.reads = m.kind(program.reads);
  program.morph_targets = static_cast<std::int32_t>(m.index(1));
  program.examples = static_cast<std::int32_t>(m.index(1));
  return program;
}

PaletteRing ring_of(Misuse& m) {
  PaletteRing ring;
  EXPECT_EQ(create_palette_ring(gl_stage().api, gl_stage().caps, 20, 3, ring), Status::ok);
  m.stays(paper_calls());
  ring.used = m.truth(true) ? 0 : ring.capacity;
  return m.either(ring, PaletteRing{});
}

PaletteTexture texture_of(Misuse& m) {
  PaletteTexture texture;
  EXPECT_EQ(create_palette_texture(gl_stage().api, gl_stage().caps, 40, texture), Status::ok);
  for (int frame = 0; frame < 2; ++frame)
    EXPECT_EQ(upload_palettes(gl_stage().api, texture, stage().palette), Status::ok);
  m.stays(paper_calls());
  return m.either(texture, PaletteTexture{});
}

SkinnedMesh skinned_of(Misuse& m) {
  SkinnedMesh skinned;
  EXPECT_EQ(create_skinned(gl_stage().api, gl_stage().gpu, skinned), Status::ok);
  m.stays(paper_calls());
  return m.either(skinned, SkinnedMesh{});
}

std::vector<MisuseRow> rows_of_loading() {
  return {
      {"load_api",
       [](Misuse& m) {
         Api api;
         const char* missing = nullptr;
         m.returned(load_api(api, m.truth(true) ? paper_proc : nullptr, m.pointer(&missing)));
       }},
      {"context_was_reset",
       [](Misuse& m) {
         EXPECT_FALSE(context_was_reset(m.either(gl_stage().api, Api{})));
         m.returned_ok();
       }},
      {"watch_errors",
       [](Misuse& m) {
         Api api = paper_api();
         ErrorWatch watch;
         watch_errors(api, m.pointer(&watch));
         EXPECT_EQ(api.GetError(), 0u);
         watch_errors(api, nullptr);
         m.returned_ok();
       }},
      {"take_error",
       [](Misuse& m) {
         ErrorWatch watch;
         watch.get_error = [] { return 7u; };
         watch.pending = m.index(0);
         (void)take_error(watch);
         m.returned_ok();
       }},
      {"query_caps",
       [](Misuse& m) {
         Api api = paper_api();
         if (m.truth(false)) api.GetString = [](unsigned) -> const unsigned char* { return nullptr; };
         if (m.truth(false)) api.GetIntegerv = [](unsigned, int* values) { *values = -1; };
         Caps& out = m.one(Caps{});
         m.never_refuses();
         m.returned(query_caps(api, out));
       }},
      {"prepare_scratch_bytes",
       [](Misuse& m) {
         (void)prepare_scratch_bytes(gl_mesh_of(m), prepare_options_of(m));
         m.returned_ok();
       }},
      {"prepare",
       [](Misuse& m) {
         const Mesh mesh = gl_mesh_of(m);
         const PrepareOptions options = prepare_options_of(m);
         const Span<std::byte> scratch = m.memory(prepare_scratch_bytes(gl_stage().mesh, options), 4);
         const Span<Affine> bind = m.out<Affine>(gl_stage().mesh.joint_count);
         GpuMesh& out = m.one(GpuMesh{});
         m.returned(prepare(gl_stage().api, caps_of(m), mesh, options, scratch, bind, out));
       }},
      {"destroy",
       [](Misuse& m) {
         GpuMesh mesh = m.either(gl_stage().gpu, GpuMesh{});
         Program program = gl_stage().program;
         PaletteRing ring = ring_of(m);
         PaletteTexture texture = texture_of(m);
         SkinnedMesh skinned = skinned_of(m);
         destroy(gl_stage().api, mesh);
         destroy(gl_stage().api, program);
         destroy(gl_stage().api, ring);
         destroy(gl_stage().api, texture);
         destroy(gl_stage().api, skinned);
         m.returned_ok();
       }},
      {"create_program",
       [](Misuse& m) {
         std::vector<const char*> varyings = {"a", "b"};
         ProgramSource source = source_of(m);
         if (m.truth(false)) source.feedback_varyings = varyings;
         Program& out = m.one(Program{});
         const Span<char> log = m.truth(true) ? Span<char>() : m.room<char>(3, Length::any);
         m.returned(create_program(gl_stage().api, key_of(m), source, m.index(0), out, log));
       }},
  };
}

std::vector<MisuseRow> rows_of_palettes() {
  return {
      {"create_palette_ring",
       [](Misuse& m) {
         PaletteRing& out = m.one(PaletteRing{});
         m.returned(create_palette_ring(gl_stage().api, caps_of(m), m.index(20), m.index(3), out));
       }},
      {"begin_frame",
       [](Misuse& m) {
         PaletteRing ring = ring_of(m);
         begin_frame(gl_stage().api, ring);
         m.returned_ok();
       }},
      {"push_palette",
       [](Misuse& m) {
         PaletteRing ring = ring_of(m);
         std::uint32_t& offset = m.one(std::uint32_t{0});
         m.returned(push_palette(gl_stage().api, ring, m.in(stage().palette, Length::any), offset));
       }},
      {"bind_palette",
       [](Misuse& m) {
         bind_palette(gl_stage().api, ring_of(m), m.index(0), m.index(0));
         m.returned_ok();
       }},
      {"create_palette_texture",
       [](Misuse& m) {
         PaletteTexture& out = m.one(PaletteTexture{});
         m.returned(create_palette_texture(gl_stage().api, caps_of(m), m.index(40), out));
       }},
      {"upload_palettes",
       [](Misuse& m) {
         PaletteTexture texture = texture_of(m);
         m.returned(upload_palettes(gl_stage().api, texture, m.in(stage().palette, Length::any)));
       }},
      {"bind_palette",
       [](Misuse& m) {
         Program program = program_of(m);
         program.reads = m.kind(Palettes::texture);
         m.returned(bind_palette(gl_stage().api, texture_of(m), m.index(0), m.index(20), m.index(1), program));
       }},
      {"bind_previous_palette",
       [](Misuse& m) {
         Program program = program_of(m);
         program.reads = m.kind(Palettes::texture);
         m.returned(bind_previous_palette(gl_stage().api, texture_of(m), m.index(0), m.index(20), m.truth(true),
                                          m.index(1), program));
       }},
      {"set_previous_morphs",
       [](Misuse& m) {
         const Mesh mesh = gl_mesh_of(m);
         const Span<const float> weights = m.in(gl_stage().morphs.weights);
         m.returned(
             set_previous_morphs(gl_stage().api, mesh, m.either(gl_stage().gpu, GpuMesh{}), weights, program_of(m)));
       }},
      {"set_morphs",
       [](Misuse& m) {
         const Mesh mesh = gl_mesh_of(m);
         const Span<const float> weights = m.in(gl_stage().morphs.weights);
         m.returned(
             set_morphs(gl_stage().api, mesh, m.either(gl_stage().gpu, GpuMesh{}), weights, m.index(1), program_of(m)));
       }},
      {"distance_matrices",
       [](Misuse& m) {
         EXPECT_LE(distance_matrices(gl_mesh_of(m).geometry), 3 * stage().palette.size());
         m.returned_ok();
       }},
      {"pack_distances",
       [](Misuse& m) {
         const Mesh mesh = gl_mesh_of(m);
         const Span<const Affine> palette = m.in(stage().palette);
         m.returned(pack_distances(mesh.geometry, palette, m.out<Affine>(distance_matrices(gl_stage().mesh.geometry))));
       }},
      {"bind_examples",
       [](Misuse& m) {
         m.returned(bind_examples(gl_stage().api, m.either(gl_stage().gpu, GpuMesh{}), texture_of(m), m.index(0),
                                  m.index(1), program_of(m)));
       }},
      {"bind_previous_distances",
       [](Misuse& m) {
         m.returned(bind_previous_distances(gl_stage().api, m.either(gl_stage().gpu, GpuMesh{}), texture_of(m),
                                            m.index(0), m.truth(true), m.index(1), program_of(m)));
       }},
      {"draw",
       [](Misuse& m) {
         m.returned(draw(gl_stage().api, m.either(gl_stage().gpu, GpuMesh{}), m.kind(Deformer::ssd), program_of(m),
                         m.index(1)));
       }},
      {"create_skinned",
       [](Misuse& m) {
         SkinnedMesh& out = m.one(SkinnedMesh{});
         m.never_refuses();
         m.returned(create_skinned(gl_stage().api, m.either(gl_stage().gpu, GpuMesh{}), out));
       }},
      {"set_previous",
       [](Misuse& m) {
         const SkinnedMesh skinned = skinned_of(m);
         m.returned(set_previous(gl_stage().api, skinned, skinned_of(m)));
       }},
      {"upload_skinned",
       [](Misuse& m) {
         const std::size_t slots = gl_stage().mesh.geometry.slot_count;
         SkinnedMesh skinned = skinned_of(m);
         const SkinOutput out{m.room<float>(slots * 3, Length::any), m.room<float>(slots * 3, Length::any),
                              m.room<float>(slots * 4, Length::any)};
         m.returned(upload_skinned(gl_stage().api, skinned, out));
       }},
      {"create_preskin",
       [](Misuse& m) {
         Program& out = m.one(Program{});
         m.returned(create_preskin(gl_stage().api, caps_of(m), key_of(m), m.kind(Preskin::feedback), m.index(0), out));
       }},
      {"preskin",
       [](Misuse& m) {
         Program program;
         EXPECT_EQ(create_preskin(gl_stage().api, gl_stage().caps, {.influences = 8}, Preskin::feedback, 0, program),
                   Status::ok);
         program.reads = m.kind(program.reads);
         m.returned(preskin(gl_stage().api, m.either(gl_stage().gpu, GpuMesh{}), m.kind(Deformer::ssd), program,
                            skinned_of(m)));
       }},
      {"draw",
       [](Misuse& m) {
         draw(gl_stage().api, m.either(gl_stage().gpu, GpuMesh{}), skinned_of(m));
         m.returned_ok();
       }},
  };
}

constexpr PrepareOptions kWithPoseSpace = {true, true, {}, true};

}  // namespace

GlStage::GlStage()
    : morphs(3, stage().mesh.geometry.slot_count, 6),
      targets(6),
      space(4, stage().mesh, 6, !morphs.blocks.empty()),
      mesh(with_box(stage().creature.mesh)),
      bind(stage().mesh.palette_size()) {
  morphs.put(mesh.geometry);
  space.put(mesh.geometry);
  mesh.targets = targets;
  EXPECT_EQ(query_caps(api, caps), Status::ok);
  std::vector<Affine> scratch(prepare_scratch_bytes(mesh, kWithPoseSpace) / sizeof(Affine) + 1);
  const Span<std::byte> bytes(reinterpret_cast<std::byte*>(scratch.data()), scratch.size() * sizeof(Affine));
  EXPECT_EQ(prepare(api, caps, mesh, kWithPoseSpace, bytes, bind, gpu), Status::ok);
  EXPECT_EQ(create_program(api, {.influences = 8}, {"vertex", "fragment", {}}, 0, program), Status::ok);
}

const GlStage& gl_stage() {
  static const GlStage made;
  return made;
}

Mesh gl_mesh_of(Misuse& m) {
  Mesh mesh = m.either(gl_stage().mesh, m.either(stage().mesh, Mesh{}));
  mesh.geometry.normals = m.pointer(mesh.geometry.normals);
  mesh.geometry.box_max[1] = m.number(mesh.geometry.box_max[1]);
  return mesh;
}

PrepareOptions prepare_options_of(Misuse& m) {
  static const std::vector<float> tangents(as_tangent_count(gl_stage().mesh.geometry), 0.25f);
  return {m.truth(true), m.truth(true), m.truth(true) ? Span<const float>() : m.in(tangents), m.truth(true)};
}

Caps caps_of(Misuse& m) {
  Caps caps = gl_stage().caps;
  caps.uniform_block_bytes = m.index(caps.uniform_block_bytes);
  caps.texture_size = m.index(caps.texture_size);
  caps.uniform_offset_alignment = m.truth(true) ? caps.uniform_offset_alignment : 16;
  caps.compute = m.truth(caps.compute);
  return caps;
}

std::vector<MisuseRow> rows_of_gl_meshes() {
  std::vector<MisuseRow> rows = rows_of_loading();
  const std::vector<MisuseRow> more = rows_of_palettes();
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace marrow::test
