// Crowds: clips baked into frames, instances, their programs.
#include <cmath>

#include <gtest/gtest.h>

#include "gl/misuse/misuse_gl.h"
#include "gles3/crowd/crowd.h"
#include "gles3/mesh/prepare.h"
#include "gles3/program.h"
#include "gles3/program_set.h"

namespace marrow::test {
namespace {

using namespace gles3;

std::vector<CrowdSource> sources() {
  return {{stage().clip, true}, {stage().clip, false}};
}

// Baked, once.
struct Baked {
  Baked() : clips(2), scratch(stage().pose.size()) {
    EXPECT_EQ(plan_crowd(sources(), 10, clips, count), Status::ok);
    matrices.resize(std::size_t{count} * stage().joints.size());
    EXPECT_EQ(bake_crowd(stage().skeleton, sources(), clips, scratch, matrices, frames), Status::ok);
  }
  std::vector<CrowdClip> clips;
  std::uint32_t count = 0;
  std::vector<SoaTransform> scratch;
  std::vector<Affine> matrices;
  CrowdFrames frames;
};
const Baked& baked() {
  static const Baked made;
  return made;
}

CrowdFrames frames_of(Misuse& m) {
  return m.either(baked().frames, CrowdFrames{});
}

CrowdPlay play_of(Misuse& m, std::uint32_t clip) {
  return {m.index(clip), m.number(0.2f), m.number(1), static_cast<double>(m.number(0))};
}

CrowdInstance instance_of(Misuse& m) {
  CrowdInstance instance;
  instance.world_from_model.rows[0][0] = m.number(1);
  instance.world_from_model.rows[1][3] = m.number(2);
  instance.a = play_of(m, 0);
  instance.b = play_of(m, 1);
  instance.blend_start_s = static_cast<double>(m.number(0));
  instance.blend_s = m.number(0.5f);
  instance.colour[2] = m.number(1);
  return instance;
}

// A mesh and a crowd in good order, in memory that stays as long as they.
struct Marching {
  explicit Marching(Misuse& m, bool motion = true) {
    const Span<std::byte> room = bytes_of(mesh_memory, crowd_mesh_bytes(stage_mesh()));
    EXPECT_EQ(
        create_crowd_mesh(gl_stage().api, gl_stage().caps, stage_mesh(), {}, baked().frames, 4, room, mesh, motion),
        Status::ok);
    EXPECT_EQ(create_crowd(gl_stage().api, gl_stage().caps, 4, bytes_of(crowd_memory, 4 * kCrowdInstanceBytes), crowd),
              Status::ok);
    std::vector<CrowdInstance> instances(4);
    for (CrowdInstance& i : instances) i.a.clip = 0;
    EXPECT_EQ(set_instances(gl_stage().api, crowd, baked().frames, 0, instances), Status::ok);
    EXPECT_EQ(create_crowd_program(gl_stage().api, program), Status::ok);
    m.stays(paper_calls());
  }
  static const Mesh& stage_mesh() {
    static const Mesh mesh = with_box(stage().creature.mesh);
    return mesh;
  }
  static Span<std::byte> bytes_of(std::vector<Affine>& memory, std::size_t bytes) {
    memory.resize(bytes / sizeof(Affine) + 1);
    return {reinterpret_cast<std::byte*>(memory.data()), bytes};
  }
  std::vector<Affine> mesh_memory, crowd_memory;
  CrowdMesh mesh;
  Crowd crowd;
  Program program;
};

std::vector<MisuseRow> rows_of_frames() {
  return {
      {"plan_crowd",
       [](Misuse& m) {
         std::vector<CrowdSource> what = sources();
         what[1].clip.duration_s = m.number(what[1].clip.duration_s);
         what[0].clip.additive = m.truth(false);
         const Span<CrowdClip> out = m.out<CrowdClip>(2);
         std::uint32_t& count = m.one(std::uint32_t{0});
         m.returned(plan_crowd(m.in(what, Length::any), m.number(10), out, count));
       }},
      {"bake_crowd",
       [](Misuse& m) {
         std::vector<CrowdClip> clips = baked().clips;
         clips[1].first_frame = m.index(clips[1].first_frame);
         clips[0].steps = m.index(clips[0].steps);
         clips[0].duration_s = m.number(clips[0].duration_s);
         const std::vector<CrowdSource> what = sources();
         const Span<SoaTransform> scratch = m.room<SoaTransform>(stage().pose.size());
         const Span<Affine> matrices = m.room<Affine>(baked().matrices.size());
         CrowdFrames& out = m.one(CrowdFrames{});
         m.returned(bake_crowd(m.either(stage().skeleton, stage().smaller), m.in(what, Length::any), m.in(clips),
                               scratch, matrices, out));
       }},
      {"crowd_joint",
       [](Misuse& m) {
         Affine& out = m.one(Affine{});
         m.returned(crowd_joint(frames_of(m), instance_of(m), static_cast<double>(m.number(3)), m.index(5), out));
       }},
      {"crowd_mesh_bytes",
       [](Misuse& m) {
         (void)crowd_mesh_bytes(gl_mesh_of(m), crowd_mesh_options_of(m));
         m.returned_ok();
       }},
  };
}

std::vector<MisuseRow> rows_of_instances() {
  return {
      {"create_crowd_mesh",
       [](Misuse& m) {
         const Mesh mesh = m.either(Marching::stage_mesh(), gl_mesh_of(m));
         const CrowdMeshOptions options = crowd_mesh_options_of(m);
         const Span<std::byte> memory = m.memory(crowd_mesh_bytes(mesh, options));
         CrowdMesh& out = m.one(CrowdMesh{});
         m.returned(create_crowd_mesh(gl_stage().api, caps_of(m), mesh, options, frames_of(m), m.index(4), memory, out,
                                      m.truth(true)));
       }},
      {"create_crowd",
       [](Misuse& m) {
         Crowd& out = m.one(Crowd{});
         const Span<std::byte> memory = m.memory(4 * kCrowdInstanceBytes, 4);
         m.returned(create_crowd(gl_stage().api, caps_of(m), m.index(4), memory, out));
       }},
      {"destroy",
       [](Misuse& m) {
         Marching marching(m);
         destroy(gl_stage().api, marching.mesh);
         destroy(gl_stage().api, marching.crowd);
         destroy(gl_stage().api, marching.crowd);
         m.returned_ok();
       }},
      {"set_instances",
       [](Misuse& m) {
         Marching marching(m);
         const std::vector<CrowdInstance> instances = {instance_of(m), instance_of(m)};
         m.returned(
             set_instances(gl_stage().api, marching.crowd, frames_of(m), m.index(1), m.in(instances, Length::any)));
       }},
      {"blend_crowd",
       [](Misuse& m) {
         Marching marching(m);
         m.returned(blend_crowd(gl_stage().api, m.either(marching.crowd, Crowd{}), m.either(marching.mesh, CrowdMesh{}),
                                m.index(1), m.index(2), static_cast<double>(m.number(3)), m.index(0),
                                m.either(marching.program, Program{})));
       }},
      {"begin_frame",
       [](Misuse& m) {
         Marching marching(m, m.truth(true));
         begin_frame(marching.mesh);
         m.returned_ok();
       }},
      {"blend_previous_crowd",
       [](Misuse& m) {
         Marching marching(m, m.truth(true));
         m.returned(blend_previous_crowd(
             gl_stage().api, m.either(marching.crowd, Crowd{}), m.either(marching.mesh, CrowdMesh{}), m.index(1),
             m.index(2), static_cast<double>(m.number(3)), m.index(0), m.either(marching.program, Program{})));
       }},
      {"bind_crowd",
       [](Misuse& m) {
         Marching marching(m, m.truth(true));
         Program program = gl_stage().program;
         ProgramState state = state_of(program);
         state.reads = m.kind(Palettes::crowd);
         set_state(program, state);
         m.returned(bind_crowd(gl_stage().api, m.either(marching.crowd, Crowd{}), m.either(marching.mesh, CrowdMesh{}),
                               m.index(1), m.index(2), m.index(0), program));
       }},
      {"draw",
       [](Misuse& m) {
         Marching marching(m);
         m.returned(draw(gl_stage().api, m.either(marching.mesh, CrowdMesh{}), m.kind(Deformer::ssd),
                         m.either(gl_stage().program, Program{}), m.index(2)));
       }},
      {"on_context_lost",
       [](Misuse& m) {
         Marching marching(m);
         on_context_lost(marching.mesh);
         on_context_lost(marching.crowd);
         destroy(gl_stage().api, marching.mesh);
         m.returned_ok();
       }},
      {"on_context_restored",
       [](Misuse& m) {
         Marching marching(m);
         if (m.truth(true)) on_context_lost(marching.mesh);
         m.returned(on_context_restored(gl_stage().api, caps_of(m), marching.mesh));
       }},
      {"on_context_restored",
       [](Misuse& m) {
         Marching marching(m);
         if (m.truth(true)) on_context_lost(marching.crowd);
         m.returned(on_context_restored(gl_stage().api, caps_of(m), marching.crowd));
       }},
  };
}

std::vector<MisuseRow> rows_of_crowd_programs() {
  return {
      {"create_crowd_programs",
       [](Misuse& m) {
         Marching marching(m);
         ProgramSet programs;
         programs.roles[0] = {m.pointer("vertex"), m.pointer("fragment"), {}};
         programs.role_count = m.index(1);
         state_of(programs).count = m.truth(true) ? 0 : kMostPrograms;
         m.returned(create_crowd_programs(gl_stage().api, caps_of(m), m.either(marching.mesh, CrowdMesh{}),
                                          m.kind(Deformer::ssd), static_cast<std::uint8_t>(m.index(255)), programs));
       }},
      {"crowd_program_of",
       [](Misuse& m) {
         Marching marching(m);
         ProgramSet programs;
         programs.roles[0] = {"vertex", "fragment", {}};
         EXPECT_EQ(create_crowd_programs(gl_stage().api, gl_stage().caps, marching.mesh, Deformer::ssd, 255, programs),
                   Status::ok);
         (void)crowd_program_of(marching.mesh, m.kind(Deformer::ssd), static_cast<std::uint8_t>(m.index(255)), programs,
                                m.index(0));
         m.returned_ok();
       }},
      {"blending_program_of",
       [](Misuse& m) {
         (void)blending_program_of(ProgramSet{});
         m.returned_ok();
       }},
  };
}

}  // namespace

std::vector<MisuseRow> rows_of_crowds() {
  std::vector<MisuseRow> rows = rows_of_frames();
  for (const auto& more : {rows_of_instances(), rows_of_crowd_programs()})
    rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace marrow::test
