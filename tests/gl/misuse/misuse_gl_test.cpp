// As tests/unit/misuse: every public function of marrow::gles3, over a driver of paper.
#include <gtest/gtest.h>

#include "gl/misuse/misuse_gl.h"
#include "gles3/mesh/gpu_mesh.h"
#include "gles3/mesh/prepare.h"

namespace marrow::test {
namespace {

std::vector<MisuseRow> all_rows() {
  std::vector<MisuseRow> out = rows_of_loading();
  for (const auto& rows : {rows_of_skinners(), rows_of_crowds()}) out.insert(out.end(), rows.begin(), rows.end());
  for (MisuseRow& row : out) {
    row.call = [call = row.call](Misuse& m) {
      m.stays(paper_calls());
      call(m);
    };
  }
  return out;
}

TEST(GlesMisuse, OfEveryFunctionIsRefusedOrHarmless) {
  expect_rows_of("runtime/c/gles3.txt", all_rows());
}

// What was destroyed, or never made, has nothing to show, whatever path its options name.
TEST(GlesMisuse, WhatIsClearedIsRefused) {
  using namespace gles3;
  const Api& api = gl_stage().api;
  const ProgramSet programs;
  int refused = 0;
  const auto refuse = [&](Status status) {
    EXPECT_EQ(status, Status::bad_argument) << refused;
    ++refused;
  };
  for (const SkinningPath path :
       {SkinningPath::ubo, SkinningPath::texture, SkinningPath::feedback, SkinningPath::compute, SkinningPath::cpu}) {
    Skinner s;
    s.options.path = path;
    s.options.motion = true;
    refuse(pose(s, 0, stage().joints));
    refuse(reset_motion(s, 0));
    refuse(update(api, s, programs, 1));
    refuse(update(api, s, programs, 0));
    refuse(draw(api, s, programs, gl_stage().program, 0, 0));
    refuse(on_context_restored(api, gl_stage().caps, s));
    EXPECT_FALSE(s.lost);
  }
  Crowd crowd;
  CrowdMesh mesh;
  const CrowdInstance instance;
  refuse(set_instances(api, crowd, {}, 0, {&instance, 1}));
  refuse(on_context_restored(api, gl_stage().caps, crowd));
  refuse(on_context_restored(api, gl_stage().caps, mesh));
  EXPECT_FALSE(crowd.lost || mesh.lost);
  EXPECT_EQ(refused, 33);
}

// A geometry that follows more than the mesh has would read outside its palette on the GPU.
TEST(GlesMisuse, AnotherMeshesGeometryIsRefused) {
  using namespace gles3;
  Mesh mesh = gl_stage().mesh;
  --mesh.joint_count;
  std::vector<Affine> scratch(prepare_scratch_bytes(mesh, {}) / sizeof(Affine) + 1), bind(mesh.joint_count);
  GpuMesh out;
  EXPECT_EQ(prepare(gl_stage().api, gl_stage().caps, mesh, {},
                    {reinterpret_cast<std::byte*>(scratch.data()), scratch.size() * sizeof(Affine)}, bind, out),
            Status::bad_argument);
  EXPECT_EQ(out.index_count, 0u);
}

}  // namespace
}  // namespace marrow::test
