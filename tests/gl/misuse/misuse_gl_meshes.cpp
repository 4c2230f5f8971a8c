// The driver's functions and what the context can do; the mesh and the program that rows are made with.
#include <gtest/gtest.h>

#include "gl/misuse/misuse_gl.h"
#include "gles3/mesh/gpu_mesh.h"
#include "gles3/mesh/morph.h"
#include "gles3/mesh/pose_examples.h"
#include "gles3/mesh/prepare.h"
#include "gles3/palettes.h"
#include "gles3/program.h"
#include "gles3/skinned.h"

namespace marrow::test {

using namespace gles3;

namespace {

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

CrowdMeshOptions crowd_mesh_options_of(Misuse& m) {
  static const std::vector<float> tangents(as_tangent_count(gl_stage().mesh.geometry), 0.25f);
  return {m.truth(true), m.truth(true), m.truth(true) ? Span<const float>() : m.in(tangents)};
}

Caps caps_of(Misuse& m) {
  Caps caps = gl_stage().caps;
  caps.uniform_block_bytes = m.index(caps.uniform_block_bytes);
  caps.texture_size = m.index(caps.texture_size);
  caps.uniform_offset_alignment = m.truth(true) ? caps.uniform_offset_alignment : 16;
  caps.compute = m.truth(caps.compute);
  return caps;
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
      {"begin_watched",
       [](Misuse& m) {
         ErrorWatch watch;
         watch.get_error = [] { return 7u; };
         watch.pending = m.index(0);
         (void)begin_watched(watch);
         m.returned_ok();
       }},
      {"end_watched",
       [](Misuse& m) {
         ErrorWatch watch;
         watch.get_error = [] { return 7u; };
         end_watched(watch, m.pointer("glFinish"), m.index(7));
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
  };
}

}  // namespace marrow::test
