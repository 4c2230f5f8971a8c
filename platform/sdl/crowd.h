// Sixty-four characters, whose walk is baked into a texture: the CPU does nothing for them.
#pragma once

#include <marrow/gles3_crowd.h>
#include <marrow/marrow.h>

#include <cmath>
#include <vector>

#include "asset.h"
#include "stage.h"

constexpr std::uint32_t kCrowd = 64;

struct Crowd {
  gles3::CrowdFrames frames;
  gles3::Crowd instances;
  std::vector<gles3::CrowdMesh> meshes;

  void make(const marrow::File& file, float walk_s, Stage& stage, gles3::ProgramSet& programs) {
    const gles3::CrowdSource sources[] = {{file.clip(file.find_clip("walk")), true}};
    static gles3::CrowdClip clips[1];
    std::uint32_t count = 0;
    must(gles3::plan_crowd(sources, 30, clips, count), "planning the crowd");
    const marrow::Skeleton skeleton = file.skeleton(0);
    static std::vector<marrow::Affine> matrices(count * skeleton.joint_count);
    std::vector<marrow::SoaTransform> scratch(skeleton.soa_size());
    must(gles3::bake_crowd(skeleton, sources, clips, scratch, matrices, frames), "baking the crowd");
    meshes.resize(file.mesh_count());
    for (std::uint32_t i = 0; i < meshes.size(); ++i) {
      const marrow::Mesh mesh = file.mesh(i, 1);  // a coarser one, if there is one
      must(create_crowd_mesh(stage.gl, stage.caps, mesh, {}, frames, kCrowd, block_of(gles3::crowd_mesh_bytes(mesh)),
                             meshes[i]),
           "the crowd on the GPU", programs.log.data);
      must(create_crowd_programs(stage.gl, stage.caps, meshes[i], gles3::Deformer::ssd, 255, programs), "its programs");
    }
    marrow::Span<std::byte> records = block_of(kCrowd * gles3::kCrowdInstanceBytes);
    must(create_crowd(stage.gl, stage.caps, kCrowd, records, instances), "the crowd's instances");
    std::vector<gles3::CrowdInstance> newts(kCrowd);
    for (int i = 0; i < int(kCrowd); ++i) {  // eight columns; each newt has a moment of the walk, and a hue of its own
      const float away = 2.2f + 1.6f * float(i % 4), x = i % 8 < 4 ? -away : away;
      const float z = -2.3f - 1.95f * float(i / 8) - 0.95f * float(i % 2);
      newts[i].world_from_model = {{{1, 0, 0, x}, {0, 1, 0, hill(x, 0)}, {0, 0, 1, z}}};
      newts[i].a = {0, walk_s * std::fmod(0.618f * float(i), 1.0f)};
      newts[i].colour[i % 3] = 1 - 0.22f * float(i * 7 % 5);
    }
    must(set_instances(stage.gl, instances, frames, 0, newts), "placing the crowd");
  }

  // Nothing goes up but a few uniforms. Leaves the screen's framebuffer bound.
  void update(const Stage& stage, const gles3::ProgramSet& programs, double time_s) const {
    const gles3::Program& blending = blending_program_of(programs);
    stage.gl.UseProgram(blending.id);
    stage.gl.Disable(GL_CULL_FACE);
    for (const gles3::CrowdMesh& mesh : meshes)
      must(blend_crowd(stage.gl, instances, mesh, 0, kCrowd, time_s, 0, blending), "blending the crowd");
  }

  void draw(const Stage& stage, const gles3::ProgramSet& programs, Role role) const {
    for (const gles3::CrowdMesh& mesh : meshes) {
      const gles3::Program& program = crowd_program_of(mesh, gles3::Deformer::ssd, 255, programs, role);
      stage.use(program, mesh.mesh, role);
      must(bind_crowd(stage.gl, instances, mesh, 0, kCrowd, 0, program), "binding the crowd");
      must(gles3::draw(stage.gl, mesh, gles3::Deformer::ssd, program, kCrowd), "drawing the crowd");
    }
  }
};
