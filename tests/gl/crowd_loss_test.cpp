// Crowds whose context is lost, or for which memory runs out: the same picture in the next context, nothing leaked.
#include <cstring>
#include <memory>

#include <gtest/gtest.h>

#include "gl/support/faulty_driver.h"
#include "gl/support/models.h"
#include "gl/support/stage.h"
#include "gl/support/troop.h"
#include "gles3/crowd/crowd.h"
#include "gles3/program.h"
#include "gles3/program_set.h"
#include "marrow/marrow.h"
#include "support/places.h"

namespace marrow::test {
namespace {

constexpr std::uint32_t kCapacity = 300;  // more than a line of the texture
constexpr std::uint32_t kCount = 270;
constexpr std::uint8_t kRead = gles3::kNormals;
constexpr gles3::Deformer kDeformer = gles3::Deformer::as;

constexpr const char* kVertex = R"(
out vec4 colour_of_one;
void main() {
  MarrowVertex v = marrow_skin();
  colour_of_one = vec4(0.5 + 0.5 * v.normal, 1.0) * marrow_instance_colour();
  gl_Position = vec4(v.position, 1.0);
}
)";
constexpr const char* kFragment = R"(
precision highp float;
in vec4 colour_of_one;
out vec4 colour;
void main() { colour = colour_of_one; }
)";

// The arm, many times, in rows over the picture, as a game has crowds. It is small: each loss draws it three times.
struct Parade {
  Parade() : model(*cook_model(in_golden("tiny.gltf"))), mesh(model.file.mesh(0)), reel(skeleton(), clips(), 20) {
    programs.roles[0] = {kVertex, kFragment, {}};
    const Geometry& g = mesh.geometry;
    const float scale = 0.3f / (g.box_max[0] - g.box_min[0]);
    for (std::uint32_t i = 0; i < kCapacity; ++i) {
      gles3::CrowdInstance& one = instances.emplace_back();
      const float x = 0.1f * static_cast<float>(i % 18) - 0.9f, y = 0.11f * static_cast<float>(i / 18) - 0.9f;
      one.world_from_model = {{{scale, 0, 0, x}, {0, scale, 0, y}, {0, 0, scale, 0}}};
      one.a = {i % static_cast<std::uint32_t>(reel.clips.size()), 0.01f * static_cast<float>(i), 1, 0};
      one.colour[i % 3] = 0.5f;
    }
  }
  Skeleton skeleton() const { return model.file.skeleton(mesh.skeleton); }
  std::vector<gles3::CrowdSource> clips() const {
    std::vector<gles3::CrowdSource> out;
    for (std::uint32_t i = 0; i < model.file.clip_count(); ++i)
      if (model.file.clip(i).skeleton == mesh.skeleton) out.push_back({model.file.clip(i), true});
    return out;
  }
  Status create(const gles3::Api& api, const gles3::Caps& caps) {
    Status status = gles3::create_crowd_mesh(api, caps, mesh, {}, reel.frames, kCapacity,
                                             room_for(mesh_memory, gles3::crowd_mesh_bytes(mesh)), crowd_mesh);
    if (status == Status::ok)
      status = gles3::create_crowd(api, caps, kCapacity, room_for(crowd_memory, kCapacity * gles3::kCrowdInstanceBytes),
                                   crowd);
    return status == Status::ok ? gles3::create_crowd_programs(api, caps, crowd_mesh, kDeformer, kRead, programs)
                                : status;
  }
  Status set(const gles3::Api& api, std::uint32_t first, std::uint32_t count) {
    return gles3::set_instances(api, crowd, reel.frames, first, {instances.data() + first, count});
  }
  Status frame(const gles3::Api& api, const Stage& stage) {
    const gles3::Program& blending = gles3::blending_program_of(programs);
    api.UseProgram(blending.id);
    const Status blended = gles3::blend_crowd(api, crowd, crowd_mesh, 0, kCount, 0.4, 0, blending);
    if (blended != Status::ok) return blended;
    stage.clear();
    const gles3::Program& drawing = gles3::crowd_program_of(crowd_mesh, kDeformer, kRead, programs, 0);
    api.UseProgram(drawing.id);
    const Status bound = gles3::bind_crowd(api, crowd, crowd_mesh, 0, kCount, 0, drawing);
    return bound == Status::ok ? gles3::draw(api, crowd_mesh, kDeformer, drawing, kCount) : bound;
  }
  void lose() {
    gles3::on_context_lost(crowd);
    gles3::on_context_lost(programs);
    gles3::on_context_lost(crowd_mesh);
  }
  Status restore(const gles3::Api& api, const gles3::Caps& caps) {
    Status status = gles3::on_context_restored(api, caps, programs);
    if (status == Status::ok) status = gles3::on_context_restored(api, caps, crowd_mesh);
    return status == Status::ok ? gles3::on_context_restored(api, caps, crowd) : status;
  }
  void destroy(const gles3::Api& api) {
    gles3::destroy(api, crowd);
    gles3::destroy(api, crowd_mesh);
    gles3::destroy(api, programs);
  }

  Model model;
  Mesh mesh;
  Reel reel;
  std::vector<gles3::CrowdInstance> instances;
  std::vector<SoaTransform> mesh_memory, crowd_memory;
  gles3::CrowdMesh crowd_mesh;
  gles3::Crowd crowd;
  gles3::ProgramSet programs;
};

std::size_t covered(const std::vector<std::uint8_t>& picture) {
  std::size_t out = 0;
  for (std::size_t i = 3; i < picture.size(); i += 4) out += picture[i] != 0;
  return out;
}

TEST(CrowdLoss, SurvivesItAnywhere) {
  on_a_thread([] {
    Parade parade;
    auto stage = std::make_unique<Stage>();
    gles3::Api api = faulty_api(stage->real());
    ASSERT_EQ(parade.create(api, stage->caps()), Status::ok);
    const auto change_and_draw = [&] {
      EXPECT_EQ(parade.set(api, 200, 70), Status::ok);
      return parade.frame(api, *stage);
    };
    ASSERT_EQ(parade.set(api, 0, 200), Status::ok);
    ASSERT_EQ(change_and_draw(), Status::ok);
    const std::vector<std::uint8_t> wanted = stage->picture();
    EXPECT_GT(covered(wanted), 2000u);
    const std::int64_t before = driver().calls, objects = driver().live;
    ASSERT_EQ(change_and_draw(), Status::ok);
    const std::int64_t calls = driver().calls - before;
    // At least, if a frame has as many calls.
    const std::int64_t wanted_losses = in_long_form() ? 12 : 4;
    std::int64_t losses = 0;
    for (std::int64_t at = 0; at <= calls; at += std::max<std::int64_t>(1, calls / wanted_losses), ++losses) {
      // In the old context they are some others by now.
      const std::vector<gles3::CrowdInstance> kept = parade.instances;
      for (gles3::CrowdInstance& one : parade.instances) one.a.phase_s += 0.3f;
      ASSERT_EQ(parade.set(api, 0, kCount), Status::ok);
      parade.instances = kept;
      ASSERT_EQ(parade.set(api, 0, 200), Status::ok);
      driver().lost_after = driver().calls + at;
      (void)change_and_draw();
      parade.lose();
      EXPECT_EQ(parade.frame(api, *stage), Status::bad_argument) << "no programs";
      stage.reset();
      stage = std::make_unique<Stage>();
      api = faulty_api(stage->real());
      ASSERT_EQ(parade.restore(api, stage->caps()), Status::ok);
      EXPECT_EQ(driver().live, objects);
      EXPECT_EQ(parade.frame(api, *stage), Status::ok);
      EXPECT_EQ(stage->picture(), wanted) << "call " << at;
      EXPECT_EQ(stage->error(), 0u);
    }
    EXPECT_GE(losses, std::min(wanted_losses, calls));
    std::printf("%d losses in %d calls\n", static_cast<int>(losses), static_cast<int>(calls));
    parade.destroy(api);
    EXPECT_EQ(driver().live, 0);
  });
}

TEST(CrowdLoss, KeepsWhatIsSetMeanwhile) {
  on_a_thread([] {
    Parade parade;
    auto stage = std::make_unique<Stage>();
    gles3::Api api = faulty_api(stage->real());
    ASSERT_EQ(parade.create(api, stage->caps()), Status::ok);
    ASSERT_EQ(parade.set(api, 0, kCount), Status::ok);
    ASSERT_EQ(parade.frame(api, *stage), Status::ok);
    const std::vector<std::uint8_t> wanted = stage->picture();
    const std::int64_t uploaded = driver().uploaded_bytes;
    // Lost before any is set, and all set before it is back.
    gles3::Crowd other;
    std::vector<SoaTransform> memory;
    ASSERT_EQ(gles3::create_crowd(api, stage->caps(), kCapacity,
                                  room_for(memory, kCapacity * gles3::kCrowdInstanceBytes), other),
              Status::ok);
    gles3::destroy(api, parade.crowd);
    parade.crowd = other;
    parade.lose();
    const std::int64_t calls = driver().calls;
    EXPECT_EQ(parade.set(api, 0, kCount), Status::ok);
    EXPECT_EQ(parade.set(api, kCount + 1, 1), Status::bad_argument) << "a gap";
    gles3::Program any = {.id = 1};
    gles3::ProgramState state = {.reads = gles3::Palettes::crowd};
    state.palettes = state.crowd = 1;
    set_state(any, state);
    EXPECT_EQ(gles3::blend_crowd(api, parade.crowd, parade.crowd_mesh, 0, kCount, 0, 0, any), Status::gl_error);
    EXPECT_EQ(gles3::bind_crowd(api, parade.crowd, parade.crowd_mesh, 0, kCount, 0, any), Status::gl_error);
    EXPECT_EQ(driver().calls, calls) << "no GL while it is lost";
    EXPECT_GT(uploaded, 0);
    stage.reset();
    stage = std::make_unique<Stage>();
    api = faulty_api(stage->real());
    ASSERT_EQ(parade.restore(api, stage->caps()), Status::ok);
    EXPECT_EQ(parade.frame(api, *stage), Status::ok);
    EXPECT_EQ(stage->picture(), wanted);
    // One that is lost for good is let go without a call to GL.
    parade.lose();
    stage.reset();
    const std::int64_t live = driver().live, last = driver().calls;
    EXPECT_GT(live, 0);
    gles3::destroy(api, parade.crowd);
    gles3::destroy(api, parade.crowd_mesh);
    EXPECT_EQ(driver().calls, last);
  });
}

TEST(CrowdLoss, RunsOutOfMemoryAnywhere) {
  on_a_thread([] {
    Parade parade;
    auto stage = std::make_unique<Stage>();
    int failures = 0;
    for (std::int64_t room = 0;; ++room) {
      const gles3::Api api = faulty_api(stage->real());
      driver().full_after = room;
      const Status status = parade.create(api, stage->caps());
      parade.destroy(api);
      EXPECT_EQ(driver().live, 0) << room;
      if (status == Status::ok) break;
      EXPECT_EQ(status, Status::gl_error);
      ASSERT_LT(room, 50);
      ++failures;
    }
    EXPECT_GE(failures, 7) << "vertices of two deformers, a surface, indices, three textures";

    // The same as it comes back; then it may be tried again.
    gles3::Api api = faulty_api(stage->real());
    ASSERT_EQ(parade.create(api, stage->caps()), Status::ok);
    ASSERT_EQ(parade.set(api, 0, kCount), Status::ok);
    ASSERT_EQ(parade.frame(api, *stage), Status::ok);
    const std::vector<std::uint8_t> wanted = stage->picture();
    parade.lose();
    stage.reset();
    stage = std::make_unique<Stage>();
    api = faulty_api(stage->real());
    ASSERT_EQ(gles3::on_context_restored(api, stage->caps(), parade.programs), Status::ok);
    const std::int64_t programs = driver().live;
    gles3::Caps small = stage->caps();
    small.texture_size = 1024;
    EXPECT_EQ(gles3::on_context_restored(api, small, parade.crowd_mesh), Status::unsupported);
    EXPECT_EQ(gles3::on_context_restored(api, small, parade.crowd), Status::unsupported);
    int again = 0;
    const auto come_back = [&](auto& object) {
      for (std::int64_t room = 0;; ++room) {
        driver().allocations = 0;
        driver().full_after = room;
        const std::int64_t live = driver().live;
        const Status status = gles3::on_context_restored(api, stage->caps(), object);
        if (status == Status::ok) break;
        EXPECT_EQ(status, Status::gl_error);
        EXPECT_EQ(driver().live, live) << room;
        EXPECT_TRUE(object.lost);
        ASSERT_LT(room, 50);
        ++again;
      }
    };
    come_back(parade.crowd_mesh);
    come_back(parade.crowd);
    EXPECT_EQ(again, failures);
    EXPECT_GT(driver().live, programs);
    driver().full_after = -1;
    EXPECT_EQ(parade.frame(api, *stage), Status::ok);
    EXPECT_EQ(stage->picture(), wanted);
    parade.destroy(api);
    EXPECT_EQ(driver().live, 0);
    EXPECT_EQ(stage->error(), 0u);
  });
}

TEST(CrowdLoss, ProgramsOfCrowdsAreASets) {
  on_a_thread([] {
    const Stage stage;
    Parade parade;
    const gles3::Api api = faulty_api(stage.real());
    ASSERT_EQ(parade.create(api, stage.caps()), Status::ok);
    EXPECT_EQ(state_of(parade.programs).count, 2u);
    ASSERT_EQ(gles3::create_crowd_programs(api, stage.caps(), parade.crowd_mesh, kDeformer, kRead, parade.programs),
              Status::ok);
    EXPECT_EQ(state_of(parade.programs).count, 2u) << "they are there";
    ASSERT_EQ(
        gles3::create_crowd_programs(api, stage.caps(), parade.crowd_mesh, gles3::Deformer::ssd, 255, parade.programs),
        Status::ok);
    EXPECT_EQ(state_of(parade.programs).count, 3u);
    EXPECT_NE(gles3::crowd_program_of(parade.crowd_mesh, gles3::Deformer::ssd, 255, parade.programs, 0).id, 0u);
    EXPECT_EQ(gles3::crowd_program_of(parade.crowd_mesh, kDeformer, 0, parade.programs, 0).id, 0u) << "not built";
    EXPECT_EQ(
        gles3::create_crowd_programs(api, stage.caps(), parade.crowd_mesh, gles3::Deformer::none, 0, parade.programs),
        Status::bad_argument);
    gles3::ProgramSet none;
    none.role_count = 0;
    EXPECT_EQ(gles3::create_crowd_programs(api, stage.caps(), parade.crowd_mesh, kDeformer, 0, none),
              Status::bad_argument);
    EXPECT_EQ(gles3::blending_program_of(none).id, 0u);
    parade.destroy(api);
    EXPECT_EQ(driver().live, 0);
  });
}

}  // namespace
}  // namespace marrow::test
