// Characters on the GPU, and which path a device can be trusted with.
#include <cmath>

#include <gtest/gtest.h>

#include "gl/misuse/misuse_gl.h"
#include "gles3/program.h"
#include "gles3/program_set.h"

namespace marrow::test {
namespace {

using namespace gles3;

Deformer deformer_of(Misuse& m) {
  return m.round() % 3 == 0 ? Deformer::psd : Deformer::ssd;
}

// Skinners that will not compile, or have no room, are part of it.
SkinnerOptions skinner_options(Misuse& m, SkinningPath path) {
  return {m.kind(path), m.kind(deformer_of(m)), m.index(2) % 5, m.index(0), static_cast<std::uint8_t>(m.index(255)),
          {},           m.truth(true)};
}

// A skinner in good order, in memory that stays as long as it.
struct Dressed {
  explicit Dressed(Misuse& m, SkinningPath path, bool motion = true, Deformer deformer = Deformer::ssd) {
    programs.roles[0] = {"vertex", "fragment", {}};
    const SkinnerOptions options{.path = path, .deformer = deformer, .instances = 2, .motion = motion};
    memory.resize(skinner_bytes(gl_stage().mesh, options) / sizeof(Affine) + 1);
    EXPECT_EQ(create_skinner(gl_stage().api, gl_stage().caps, gl_stage().mesh, options, programs,
                             {reinterpret_cast<std::byte*>(memory.data()), memory.size() * sizeof(Affine)}, skinner),
              Status::ok);
    for (std::uint32_t i = 0; i < 2; ++i)
      EXPECT_EQ(pose(skinner, i, stage().joints, gl_stage().morphs.weights), Status::ok);
    EXPECT_EQ(update(gl_stage().api, skinner, programs, 2), Status::ok);
    m.stays(paper_calls());
  }
  ProgramSet programs;
  std::vector<Affine> memory;
  Skinner skinner;
};

// As it is, or cleared.
Skinner& skinner_of(Misuse& m, Dressed& dressed, Skinner& cleared) {
  cleared.options.path = dressed.skinner.options.path;
  return m.truth(true) ? dressed.skinner : cleared;
}

SkinningPath path_of(Misuse& m) {
  const SkinningPath all[] = {SkinningPath::ubo, SkinningPath::texture, SkinningPath::feedback, SkinningPath::compute,
                              SkinningPath::cpu};
  return all[m.round() % std::size(all)];
}

SelfTest tested(Misuse& m) {
  SelfTest test;
  for (PathResult& path : test.paths) path = {m.kind(Verdict::usable), m.number(0.001f), m.number(0.001f), m.number(3)};
  return test;
}

SelfTestOptions self_test_options(Misuse& m) {
  return {.paths = m.index((1u << kPathCount) - 1),
          .crashed = m.index(0),
          .ssd = m.truth(true),
          .as = m.truth(true),
          .slow = m.number(4)};
}

std::vector<MisuseRow> rows_of_self_tests() {
  return {
      {"bit_of",
       [](Misuse& m) {
         EXPECT_NE(bit_of(path_of(m)), 0u);
         m.returned_ok();
       }},
      {"self_test_bytes",
       [](Misuse& m) {
         (void)self_test_bytes(self_test_options(m));
         m.returned_ok();
       }},
      {"self_test",
       [](Misuse& m) {
         if (m.round() % 100 != 0) return m.returned_ok();  // a thousand times the cost of the others
         const SelfTestOptions options = self_test_options(m);
         SelfTest& out = m.one(SelfTest{});
         m.may_fail();  // nothing is drawn
         m.returned(self_test(gl_stage().api, gl_stage().caps, options, m.memory(self_test_bytes(options)), out));
         for (const PathResult& path : out.paths) EXPECT_TRUE(std::isfinite(path.position_error));
       }},
      {"choose",
       [](Misuse& m) {
         SkinningPath& out = m.one(SkinningPath::cpu);
         const SelfTest test = tested(m);
         m.never_refuses();
         m.returned(choose(test, {m.index(1), m.index(1), m.index(20)}, out));
       }},
      {"save",
       [](Misuse& m) {
         const Span<std::byte> out = m.memory(kSavedSelfTestBytes, 1);
         m.returned(save(tested(m), out));
       }},
      {"restore",
       [](Misuse& m) {
         const SelfTestOptions options;
         SelfTest test;
         EXPECT_EQ(restore(gl_stage().api, gl_stage().caps, options, {}, test), Status::truncated);
         std::vector<std::byte> bytes(kSavedSelfTestBytes);
         EXPECT_EQ(save(test, bytes), Status::ok);
         for (int i = 0; i < 3; ++i) bytes[m.index(0) % bytes.size()] ^= static_cast<std::byte>(m.index(0));
         SelfTest& out = m.one(SelfTest{});
         m.may_fail();
         const Status status = restore(gl_stage().api, gl_stage().caps, options, m.in(bytes, Length::any), out);
         EXPECT_NE(status, Status::ok) << "its key is no one's";
         m.returned(status);
         m.returned_ok();
       }},
  };
}

std::vector<MisuseRow> rows_of_dressing() {
  return {
      {"to_string",
       [](Misuse& m) {
         EXPECT_NE(to_string(m.kind(SkinningPath::ubo)), nullptr);
         EXPECT_NE(to_string(m.kind(Verdict::usable)), nullptr);
         m.returned_ok();
       }},
      {"skinner_bytes",
       [](Misuse& m) {
         (void)skinner_bytes(gl_mesh_of(m), skinner_options(m, path_of(m)));
         m.returned_ok();
       }},
      {"create_skinner",
       [](Misuse& m) {
         const SkinnerOptions options = skinner_options(m, path_of(m));
         const Mesh mesh = gl_mesh_of(m);
         ProgramSet programs;
         programs.roles[0] = {m.pointer("vertex"), m.pointer("fragment"), {}};
         programs.role_count = m.index(1);
         state_of(programs).count = m.truth(true) ? 0 : kMostPrograms;
         const Span<std::byte> memory = m.memory(skinner_bytes(mesh, options));
         Skinner& out = m.one(Skinner{});
         m.returned(create_skinner(gl_stage().api, caps_of(m), mesh, options, programs, memory, out));
       }},
      {"destroy",
       [](Misuse& m) {
         Dressed dressed(m, path_of(m), true, deformer_of(m));
         destroy(gl_stage().api, dressed.skinner);
         destroy(gl_stage().api, dressed.skinner);
         destroy(gl_stage().api, dressed.programs);
         m.returned_ok();
       }},
      {"pose",
       [](Misuse& m) {
         Dressed dressed(m, path_of(m), true, deformer_of(m));
         const Span<const Affine> joints = m.in(stage().joints);
         Skinner cleared;
         m.returned(pose(skinner_of(m, dressed, cleared), m.index(1), joints, m.in(gl_stage().morphs.weights)));
       }},
      {"reset_motion",
       [](Misuse& m) {
         Dressed dressed(m, path_of(m), m.truth(true), deformer_of(m));
         Skinner cleared;
         cleared.options.motion = true;
         m.returned(reset_motion(skinner_of(m, dressed, cleared), m.index(1)));
       }},
      {"update",
       [](Misuse& m) {
         Dressed dressed(m, path_of(m), true, deformer_of(m));
         const ProgramSet none;
         Skinner cleared;
         m.returned(
             update(gl_stage().api, skinner_of(m, dressed, cleared), m.either(dressed.programs, none), m.index(2)));
       }},
      {"program_of",
       [](Misuse& m) {
         Dressed dressed(m, path_of(m), true, deformer_of(m));
         const ProgramSet none;
         Skinner cleared;
         (void)program_of(skinner_of(m, dressed, cleared), m.either(dressed.programs, none), m.index(0));
         m.returned_ok();
       }},
      {"draw",
       [](Misuse& m) {
         Dressed dressed(m, path_of(m), m.round() % 2 == 0, deformer_of(m));
         Program program = program_of(dressed.skinner, dressed.programs, 0);
         ProgramState state = state_of(program);
         state.motion = m.truth(state.motion);
         set_state(program, state);
         const ProgramSet none;
         Skinner cleared;
         m.returned(draw(gl_stage().api, skinner_of(m, dressed, cleared), m.either(dressed.programs, none),
                         m.either(program, Program{}), m.index(1), m.index(1)));
       }},
      {"on_context_lost",
       [](Misuse& m) {
         Dressed dressed(m, path_of(m), true, deformer_of(m));
         on_context_lost(dressed.skinner);
         on_context_lost(dressed.programs);
         destroy(gl_stage().api, dressed.skinner);
         m.returned_ok();
       }},
      {"on_context_restored",
       [](Misuse& m) {
         Dressed dressed(m, path_of(m), true, deformer_of(m));
         on_context_lost(dressed.skinner);
         on_context_lost(dressed.programs);
         m.returned(on_context_restored(gl_stage().api, caps_of(m), dressed.programs));
       }},
      {"on_context_restored",
       [](Misuse& m) {
         Dressed dressed(m, path_of(m), true, deformer_of(m));
         if (m.truth(true)) on_context_lost(dressed.skinner);
         Skinner cleared;
         m.returned(on_context_restored(gl_stage().api, caps_of(m), skinner_of(m, dressed, cleared)));
       }},
  };
}

}  // namespace

std::vector<MisuseRow> rows_of_skinners() {
  std::vector<MisuseRow> rows = rows_of_dressing();
  const std::vector<MisuseRow> more = rows_of_self_tests();
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace marrow::test
