// Rows of misuse of marrow::gles3, and what good calls of it are made with.
#pragma once

#include "gl/misuse/paper_driver.h"
#include "gles3/mesh/gpu_mesh.h"
#include "gles3/mesh/prepare.h"
#include "marrow/gles3_crowd.h"
#include "marrow/gles3_self_test.h"
#include "support/family.h"
#include "support/morphs.h"
#include "unit/misuse/misuse.h"

namespace marrow::test {

std::vector<MisuseRow> rows_of_loading();
std::vector<MisuseRow> rows_of_skinners();
std::vector<MisuseRow> rows_of_crowds();

// A mesh with morph targets and a pose space, prepared, and a character of it.
struct GlStage {
  GlStage();
  gles3::Api api = paper_api();
  gles3::Caps caps;
  TestMorphs morphs;
  std::vector<MeshTarget> targets;
  TestPoseSpace space;
  Mesh mesh;
  std::vector<Affine> bind;
  gles3::GpuMesh gpu;
  gles3::Program program;
};
const GlStage& gl_stage();

// A mesh, or none; without what it may lack.
Mesh gl_mesh_of(Misuse& m);
gles3::CrowdMeshOptions crowd_mesh_options_of(Misuse& m);
gles3::Caps caps_of(Misuse& m);

}  // namespace marrow::test
