// What of marrow::gles3 refuses a call says so under its own name, before it calls GL: there is no context here.
#include <gtest/gtest.h>

#include "marrow/gles3_crowd.h"
#include "marrow/gles3_self_test.h"
#include "support/call_errors.h"

namespace marrow::gles3 {
namespace {

class GlesCallNames : public testing::Test {
 protected:
  void refused(const char* name, Status status) {
    EXPECT_EQ(status, Status::bad_argument) << name;
    const std::vector<test::CallError> heard = errors_.take();
    ASSERT_EQ(heard.size(), 1u) << name;
    EXPECT_EQ(heard[0].function, name);
    EXPECT_GT(heard[0].condition.size(), 3u) << name;
  }

  Api api_;
  Caps caps_;
  Mesh mesh_;
  GpuMesh gpu_;
  Program program_;
  test::CallErrors errors_;
};

#define REFUSED(function, ...) refused(#function, function(__VA_ARGS__))

TEST_F(GlesCallNames, OfMeshesAndPrograms) {
  PaletteRing ring;
  PaletteTexture texture;
  SkinnedMesh skinned;
  std::uint32_t offset = 0;
  REFUSED(load_api, api_, nullptr);
  REFUSED(prepare, api_, caps_, mesh_, {}, {}, {}, gpu_);
  REFUSED(build_program, api_, {}, {}, 0, program_);
  REFUSED(build_program, api_, {.influences = 3}, {.vertex = "", .fragment = ""}, 0, program_);
  REFUSED(create_palette_ring, api_, caps_, 0, 1, ring);
  REFUSED(push_palette, api_, ring, {}, offset);
  REFUSED(create_palette_texture, api_, caps_, 0, texture);
  REFUSED(upload_palettes, api_, texture, {});
  REFUSED(bind_palette, api_, texture, 0, 1, 0, program_);
  REFUSED(bind_previous_palette, api_, texture, 0, 1, true, 0, program_);
  REFUSED(set_morphs, api_, mesh_, gpu_, {}, 0, program_);
  REFUSED(set_previous_morphs, api_, mesh_, gpu_, {}, program_);
  REFUSED(pack_distances, {}, {}, {});
  REFUSED(bind_examples, api_, gpu_, texture, 0, 0, program_);
  REFUSED(bind_previous_distances, api_, gpu_, texture, 0, true, 0, program_);
  REFUSED(draw, api_, gpu_, Deformer::ssd, program_);
  REFUSED(build_preskin, api_, caps_, {.deformer = Deformer::none}, Preskin::feedback, 0, program_);
  REFUSED(preskin, api_, gpu_, Deformer::none, program_, skinned);
  REFUSED(upload_skinned, api_, skinned, {});
  SkinnedMesh larger;
  larger.slot_count = 4;
  REFUSED(set_previous, api_, skinned, larger);
}

TEST_F(GlesCallNames, OfSkinnersAndTheSelfTest) {
  Skinner skinner;
  ProgramSet programs;
  SelfTest test;
  REFUSED(create_skinner, api_, caps_, mesh_, {.instances = 0}, programs, {}, skinner);
  REFUSED(create_skinner, api_, caps_, mesh_, {}, programs, {}, skinner);
  REFUSED(pose, skinner, 5, {});
  REFUSED(reset_motion, skinner, 0);
  REFUSED(update, api_, skinner, programs, 5);
  REFUSED(draw, api_, skinner, programs, program_, 1, 1);
  REFUSED(self_test, api_, caps_, {.ssd = false, .as = false}, {}, test);
  REFUSED(save, test, {});
}

TEST_F(GlesCallNames, OfCrowds) {
  CrowdMesh mesh;
  Crowd crowd;
  CrowdFrames frames;
  ProgramSet programs;
  Affine out;
  std::uint32_t count = 0;
  REFUSED(plan_crowd, {}, 30, {}, count);
  REFUSED(bake_crowd, {}, {}, {}, {}, {}, frames);
  REFUSED(crowd_joint, frames, {}, 0, 0, out);
  REFUSED(crowd_pose, frames, {}, 0, {});
  REFUSED(create_crowd_mesh, api_, caps_, mesh_, {}, frames, 1, {}, mesh);
  REFUSED(create_crowd, api_, caps_, 0, {}, crowd);
  REFUSED(set_instances, api_, crowd, frames, 0, {});
  REFUSED(build_crowd_programs, api_, caps_, mesh, Deformer::none, 0, programs);
  REFUSED(blend_crowd, api_, crowd, mesh, 0, 1, 0, 0, program_);
  REFUSED(blend_previous_crowd, api_, crowd, mesh, 0, 0, 0, 0, program_);
  REFUSED(bind_crowd, api_, crowd, mesh, 0, 1, 0, program_);
}

// As tests/unit/designated_test.cpp.
TEST(GlesDesignated, MembersMayBeLeftOut) {
  const ProgramSet programs = {.role_count = 2};
  const ProgramSource source = {.vertex = ""};
  const ProgramKey key = {.influences = 8};
  const SkinnerOptions options = {.path = SkinningPath::cpu};
  const PrepareOptions prepared = {.as = false};
  const CrowdInstance instance = {.a = {.clip = 1}};
  const CrowdSource baked = {.loops = false};
  const SelfTestOptions tried = {.as = false};
  EXPECT_TRUE(programs.count == 0 && source.fragment == nullptr && key.features == kNormals && options.instances == 1);
  EXPECT_TRUE(prepared.ssd && instance.b.clip == kNoCrowdClip && baked.clip.duration_s == 0 && tried.ssd);
}

}  // namespace
}  // namespace marrow::gles3
