// Motion vectors: where vertices were in the frame before, on every path, against the CPU's skinning of that frame.
#include <cstdio>
#include <functional>

#include <gtest/gtest.h>

#include "gl/support/crowd_worst.h"
#include "gl/support/models.h"
#include "gl/support/stage.h"
#include "gl/support/troop.h"
#include "gles3/compile.h"
#include "gles3/crowd/crowd.h"
#include "gles3/program.h"
#include "gles3/skinner_state.h"
#include "marrow/egl.h"
#include "marrow/gles3_skinner.h"
#include "marrow/marrow.h"
#include "pose/evaluate.h"
#include "support/family.h"
#include "support/places.h"
#include "support/rig.h"

namespace marrow::test {
namespace {

using gles3::SkinningPath;

constexpr double kMostApart = 2e-4;  // of the diagonal
constexpr std::uint32_t kCharacters = 3;

// A role that has both positions captured; the text of a game that makes motion vectors of them.
constexpr const char* kVertex = R"(
out vec3 now;
out vec3 before;
void main() {
  MarrowVertex v = marrow_skin();
  now = v.position;
  before = v.previous_position;
  gl_Position = vec4(now - before, 1.0);
  gl_PointSize = 1.0;
}
)";
constexpr const char* kFragment = R"(
precision highp float;
out vec4 colour;
void main() { colour = vec4(1.0); }
)";
constexpr const char* kVaryings[] = {"now", "before"};
const gles3::ProgramSource kSource{kVertex, kFragment, Span<const char* const>(kVaryings, 2)};

// A mesh in the poses of a clip.
struct Actor {
  Mesh mesh;
  Skeleton skeleton;
  Clip clip;
  std::vector<float> tangents = {};  // of animation space: its surface's own normals

  std::vector<Affine> joints(float time_s) const {
    std::vector<SoaTransform> local(skeleton.soa_size());
    std::vector<Affine> out(skeleton.joint_count);
    std::copy_n(skeleton.rest, skeleton.soa_size(), local.begin());
    if (clip.joint_count > 0) {
      EXPECT_EQ(sample(skeleton, clip, time_s, local), Status::ok);
    } else {
      for (SoaTransform& four : local)
        for (float& x : four.translation[0]) x += time_s;
    }
    EXPECT_EQ(local_to_model(skeleton, local, out), Status::ok);
    return out;
  }
  std::vector<float> weights(float time_s) const {
    std::vector<float> out(mesh.geometry.targets.size);
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = time_s * static_cast<float>(t % 3 + 1);
    return out;
  }
  // By the CPU.
  std::vector<float> positions(gles3::Deformer deformer, float time_s) const {
    std::vector<Affine> palette(mesh.palette_size());
    EXPECT_EQ(build_palette(mesh, joints(time_s), palette), Status::ok);
    Mesh moved = mesh;
    std::vector<SoaTransform> memory;
    MorphedGeometry morphed;
    std::vector<float> coordinates(as_coordinate_count(mesh.geometry)), out(std::size_t{3} * mesh.geometry.slot_count);
    EXPECT_EQ(as_coordinates(mesh.geometry, coordinates), Status::ok);
    if (!mesh.geometry.targets.empty()) {
      EXPECT_EQ(make_morphed(mesh.geometry, room_for(memory, morphed_bytes(mesh.geometry)), morphed), Status::ok);
      EXPECT_EQ(morph(weights(time_s), morphed), Status::ok);
      EXPECT_EQ(morph_coordinates(morphed, coordinates), Status::ok);
      moved.geometry = morphed.geometry;
    }
    const SkinOutput to{out, {}, {}};
    std::vector<float> distances(psd_distance_count(mesh.geometry));
    EXPECT_EQ(psd_distances(mesh.geometry, palette, distances), Status::ok);
    EXPECT_EQ(deformer == gles3::Deformer::rigid ? skin_rigid(moved, palette, to)
              : deformer == gles3::Deformer::ssd ? skin_ssd(moved, palette, to)
              : deformer == gles3::Deformer::psd ? skin_psd(moved, distances, palette, to)
                                                 : skin_as(moved, coordinates, palette, to),
              Status::ok);
    return out;
  }
};

double diagonal(const Geometry& g) {
  double squared = 0;
  for (std::size_t c = 0; c < 3; ++c) squared += std::pow(double{g.box_max[c]} - double{g.box_min[c]}, 2);
  return std::sqrt(squared);
}

double farthest(const std::vector<float>& a, const std::vector<float>& b) {
  EXPECT_EQ(a.size(), b.size());
  double out = 0;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
    const double d = std::fabs(double{a[i]} - double{b[i]});
    out = d >= out ? d : d < out ? out : 1e30;
  }
  return out;
}

// What a draw call's state makes of every slot: both positions.
struct Both {
  std::vector<float> now, before;
};

struct Target {
  Target() : colour(gl()), framebuffer(gl()) {
    gl().BindRenderbuffer(GL_RENDERBUFFER, colour);
    gl().RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_RGBA8, 1, 1);
    gl().BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour);
  }
  tools::GlRenderbuffer colour;
  tools::GlFramebuffer framebuffer;
};

// instances: all of which are drawn; of each a Both.
std::vector<Both> capture(GLuint array, std::uint32_t slots, std::uint32_t instances) {
  static const auto draw_instanced =
      reinterpret_cast<void (*)(GLenum, GLint, GLsizei, GLsizei)>(egl::load_proc("glDrawArraysInstanced"));
  const Target target;
  const tools::GlBuffer buffer(gl());
  const std::size_t floats = std::size_t{6} * slots * instances;
  gl().BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffer);
  gl().BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, static_cast<std::ptrdiff_t>(floats * sizeof(float)), nullptr,
                  GL_STREAM_READ);
  gl().Enable(GL_RASTERIZER_DISCARD);
  gl().BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  gl().BindVertexArray(array);
  gl().BeginTransformFeedback(GL_POINTS);
  draw_instanced(GL_POINTS, 0, static_cast<GLsizei>(slots), static_cast<GLsizei>(instances));
  gl().EndTransformFeedback();
  gl().BindVertexArray(0);
  gl().BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  gl().Disable(GL_RASTERIZER_DISCARD);
  const std::vector<float> got = read_feedback(buffer, floats);
  std::vector<Both> out(instances);
  for (std::size_t i = 0; i < std::size_t{slots} * instances; ++i) {
    const auto at = got.begin() + static_cast<std::ptrdiff_t>(6 * i);
    out[i / slots].now.insert(out[i / slots].now.end(), at, at + 3);
    out[i / slots].before.insert(out[i / slots].before.end(), at + 3, at + 6);
  }
  EXPECT_EQ(gl().GetError(), static_cast<unsigned>(GL_NO_ERROR));
  return out;
}

struct Player {
  Player(const Actor& of, SkinningPath path, gles3::Deformer deformer) : actor(of) {
    programs.roles[0] = kSource;
    programs.log = log;
    gles3::SkinnerOptions options{path, deformer};
    options.instances = kCharacters;
    options.texture_unit = 2;
    options.motion = true;
    options.as_tangents = actor.tangents;
    const Span<std::byte> room = room_for(memory, gles3::skinner_bytes(actor.mesh, options));
    status = gles3::create_skinner(gl(), gl().caps(), actor.mesh, options, programs, room, skinner);
  }
  ~Player() {
    gles3::destroy(gl(), skinner);
    gles3::destroy(gl(), programs);
  }
  void pose(std::uint32_t character, float time_s) {
    EXPECT_EQ(gles3::pose(skinner, character, actor.joints(time_s), actor.weights(time_s)), Status::ok);
  }
  void update(std::uint32_t count) {
    const Target target;  // transform feedback wants a complete one
    EXPECT_EQ(gles3::update(gl(), skinner, programs, count), Status::ok);
  }
  // What drawing binds, is then captured with points.
  Both drawn(std::uint32_t character) {
    const gles3::Program& program = gles3::program_of(skinner, programs, 0);
    EXPECT_TRUE(state_of(program).motion);
    const Target target;
    gl().UseProgram(program.id);
    EXPECT_EQ(gles3::draw(gl(), skinner, programs, program, character, 1), Status::ok);
    const GLuint array = !skinner.skinned.empty()                          ? skinner.skinned[character].array
                         : skinner.options.deformer == gles3::Deformer::as ? state_of(skinner).gpu.as_array
                                                                           : state_of(skinner).gpu.ssd_array;
    return capture(array, state_of(skinner).gpu.slot_count, 1)[0];
  }
  void expect(std::uint32_t character, float now_s, float before_s) {
    const double size = diagonal(actor.mesh.geometry);
    const Both got = drawn(character);
    const std::vector<float> now = actor.positions(skinner.options.deformer, now_s);
    const std::vector<float> before = actor.positions(skinner.options.deformer, before_s);
    if (now_s != before_s) {
      EXPECT_GT(farthest(now, before), 20 * kMostApart * size) << "a test that could not fail";
    }
    const double apart = farthest(got.now, now) / size, apart_before = farthest(got.before, before) / size;
    EXPECT_LE(apart, kMostApart) << "character " << character;
    EXPECT_LE(apart_before, kMostApart) << "character " << character;
    worst = std::max({worst, apart, apart_before});
    compared += got.before.size() / 3;
  }

  const Actor& actor;
  gles3::ProgramSet programs;
  std::vector<char> log = std::vector<char>(4096);
  std::vector<SoaTransform> memory;
  gles3::Skinner skinner;
  Status status = Status::bad_argument;
  double worst = 0;
  std::size_t compared = 0;
};

// Of three characters two are there at first; one is put elsewhere at once; the third comes later, and goes again.
void play(Player& player) {
  player.pose(0, 0.1f);
  player.pose(1, 0.2f);
  player.update(2);
  player.expect(0, 0.1f, 0.1f);
  player.pose(0, 0.3f);
  player.pose(1, 0.5f);
  player.pose(2, 0.7f);
  EXPECT_EQ(gles3::reset_motion(player.skinner, 1), Status::ok);
  player.update(3);
  player.expect(0, 0.3f, 0.1f);
  player.expect(1, 0.5f, 0.5f);
  player.expect(2, 0.7f, 0.7f);
  player.pose(0, 0.6f);
  player.pose(2, 0.4f);
  player.update(3);
  player.expect(0, 0.6f, 0.3f);
  player.expect(1, 0.5f, 0.5f);
  player.expect(2, 0.4f, 0.7f);
  player.update(1);  // nobody has moved, and two are gone
  player.expect(0, 0.6f, 0.6f);
  player.pose(0, 0.2f);
  player.update(2);
  player.expect(0, 0.2f, 0.6f);
  player.expect(1, 0.5f, 0.5f);
}

std::size_t play_all(const char* what, const Actor& actor) {
  using gles3::Deformer;
  const bool examples = !actor.mesh.geometry.pose_space.examples.empty();
  const std::vector<Deformer> deformers =
      examples ? std::vector{Deformer::psd} : std::vector{Deformer::rigid, Deformer::ssd, Deformer::as};
  std::size_t played = 0;
  for (int path = 0; path < static_cast<int>(gles3::kPathCount); ++path) {
    for (const gles3::Deformer deformer : deformers) {
      Player player(actor, static_cast<SkinningPath>(path), deformer);
      if (player.status == Status::unsupported) continue;
      EXPECT_EQ(player.status, Status::ok) << player.log.data();
      if (player.status != Status::ok) continue;
      play(player);
      std::printf("%s, %s, deformer %d: %zu vertices, %.1e of the diagonal apart at most\n", what,
                  to_string(static_cast<SkinningPath>(path)), static_cast<int>(deformer), player.compared,
                  player.worst);
      ++played;
    }
  }
  return played;
}

Actor actor_of(const Model& model) {
  Actor out;
  for (std::uint32_t m = 0; m < model.file.mesh_count(); ++m)
    if (model.file.mesh(m).geometry.slot_count > out.mesh.geometry.slot_count) out.mesh = model.file.mesh(m);
  out.skeleton = model.file.skeleton(out.mesh.skeleton);
  if (model.file.clip_count() > 0 && model.file.clip(0).skeleton == out.mesh.skeleton) out.clip = model.file.clip(0);
  return out;
}

TEST(Motion, EveryPathKnowsTheFrameBefore) {
  const std::size_t paths = gl().caps().compute ? 5 : 4;
  const std::optional<Model> newt = cook_model(newt_glb()), face = cook_model(in_golden("face.gltf"));
  ASSERT_TRUE(newt && face);
  EXPECT_EQ(play_all("newt", actor_of(*newt)), 3 * paths);
  Actor smooth = actor_of(*newt);
  smooth.tangents = tools::tangents_of(newt->file)[0];
  EXPECT_EQ(play_all("newt, its surface's normals", smooth), 3 * paths);
  const Actor talking = actor_of(*face);
  ASSERT_GT(talking.mesh.geometry.targets.size, 1u);
  EXPECT_EQ(play_all("face, morphing", talking), 3 * paths);
  const TestCharacter eight = make_character(40, 40, 13, true), many = make_character(700, 700, 13, true);
  EXPECT_EQ(play_all("noise", {with_box(eight.mesh), eight.skeleton.view(), eight.clip.view()}), 3 * paths);
  EXPECT_EQ(play_all("700 joints", {with_box(many.mesh), many.skeleton.view(), many.clip.view()}), 3u * 2);
  Actor posed{with_box(eight.mesh), eight.skeleton.view(), eight.clip.view()};
  const TestPoseSpace space(41, posed.mesh, 9);
  space.put(posed.mesh.geometry);
  EXPECT_EQ(play_all("pose space", posed), paths);
}

// In one draw call where palettes lie in a texture, but for characters without a frame before.
TEST(Motion, DrawsTogetherWhatMovesAlike) {
  const TestCharacter character = make_character(9, 20, 5, false);
  const Actor actor{with_box(character.mesh), character.skeleton.view(), character.clip.view()};
  Player player(actor, SkinningPath::texture, gles3::Deformer::ssd);
  ASSERT_EQ(player.status, Status::ok) << player.log.data();
  static int calls;
  static std::uint32_t characters;
  gles3::Api api = gl();
  api.DrawElements = [](unsigned, int, unsigned, const void*) { ++calls, ++characters; };
  api.DrawElementsInstanced = [](unsigned, int, unsigned, const void*, int instances) {
    ++calls, characters += static_cast<std::uint32_t>(instances);
  };
  const gles3::Program& program = gles3::program_of(player.skinner, player.programs, 0);
  const auto expect_calls = [&](int wanted) {
    calls = 0;
    characters = 0;
    gl().UseProgram(program.id);
    EXPECT_EQ(gles3::draw(api, player.skinner, player.programs, program, 0, kCharacters), Status::ok);
    EXPECT_EQ(calls, wanted);
    EXPECT_EQ(characters, kCharacters);
  };
  for (std::uint32_t i = 0; i < kCharacters; ++i) player.pose(i, 0.1f);
  player.update(kCharacters);
  expect_calls(1);
  player.update(kCharacters);
  expect_calls(1);
  EXPECT_EQ(gles3::reset_motion(player.skinner, 1), Status::ok);
  player.update(kCharacters);
  expect_calls(3);
}

TEST(Motion, ComesBackWithTheContext) {
  const TestCharacter character = make_character(9, 20, 5, false);
  const Actor actor{with_box(character.mesh), character.skeleton.view(), character.clip.view()};
  for (const SkinningPath path : {SkinningPath::ubo, SkinningPath::texture, SkinningPath::feedback}) {
    Player player(actor, path, gles3::Deformer::as);
    ASSERT_EQ(player.status, Status::ok) << player.log.data();
    for (std::uint32_t i = 0; i < kCharacters; ++i) player.pose(i, 0.1f);
    player.update(kCharacters);
    gles3::on_context_lost(player.skinner);  // the objects stay behind, which does not matter here
    ASSERT_EQ(gles3::on_context_restored(gl(), gl().caps(), player.skinner), Status::ok);
    player.pose(0, 0.4f);
    player.update(kCharacters);
    player.expect(0, 0.4f, 0.4f);
    player.pose(0, 0.2f);
    player.update(kCharacters);
    player.expect(0, 0.2f, 0.4f);
  }
}

TEST(Motion, CostsNothingWhereNobodyAsks) {
  const TestCharacter character = make_character(9, 20, 5, false);
  const Mesh mesh = with_box(character.mesh);
  for (int path = 0; path < static_cast<int>(gles3::kPathCount); ++path) {
    gles3::SkinnerOptions options{static_cast<SkinningPath>(path)};
    const std::size_t without = gles3::skinner_bytes(mesh, options);
    options.motion = true;
    EXPECT_LE(gles3::skinner_bytes(mesh, options), without + 16 * 6 + sizeof(gles3::SkinnedMesh)) << "per character";
  }
  // A role that does not read it gets the programs of a skinner without.
  const Actor actor{mesh, character.skeleton.view(), character.clip.view()};
  Player player(actor, SkinningPath::ubo, gles3::Deformer::ssd);
  player.programs.role_features[0] = 255 & ~gles3::kMotion;
  EXPECT_EQ(gles3::program_of(player.skinner, player.programs, 0).id, 0u) << "none was asked for yet";
  gles3::Skinner plain;
  EXPECT_EQ(gles3::reset_motion(plain, 0), Status::bad_argument);
  EXPECT_EQ(gles3::reset_motion(player.skinner, kCharacters), Status::bad_argument);
}

// The texts that docs/gles/shaders.md shows: how far on the screen a pixel has come, in widths and heights of the
// picture.
constexpr const char* kVelocityVertex = R"(
uniform mat4 clip_from_model;           // of this frame, and of the frame before
uniform mat4 previous_clip_from_model;
out vec4 clip;
out vec4 previous_clip;
void main() {
  MarrowVertex v = marrow_skin();
  clip = clip_from_model * vec4(v.position, 1.0);
  previous_clip = previous_clip_from_model * vec4(v.previous_position, 1.0);
  gl_Position = clip;
}
)";
constexpr const char* kVelocityFragment = R"(
precision highp float;
in vec4 clip;
in vec4 previous_clip;
out vec4 motion;
void main() {
  motion = vec4(0.5 * (clip.xy / clip.w - previous_clip.xy / previous_clip.w), 0.0, 1.0);
  motion.xy = 0.5 + 0.5 * motion.xy;  // into a texture of bytes; one of floats takes them as they are
}
)";

// A camera that looks along -z at a box, and has moved by `shift` of what it sees.
struct Camera {
  float matrix[16];
  Camera(const Geometry& g, float shift) {
    const float scale = 1 / static_cast<float>(diagonal(g));
    const float all[16] = {scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, 1};
    std::copy_n(all, 16, matrix);
    for (int c = 0; c < 3; ++c) matrix[12 + c] = -0.5f * (g.box_min[c] + g.box_max[c]) * scale;
    matrix[12] += shift;
  }
};

// What stands still, before a camera that moves; what moves, before one that stands still; and a camera that follows.
TEST(Motion, IsDistanceOnTheScreen) {
  const std::optional<Model> newt = cook_model(newt_glb());
  ASSERT_TRUE(newt);
  on_a_thread([&] {
    const Stage stage;
    const gles3::Api& api = stage.real();
    const Actor actor = actor_of(*newt);
    const Geometry& g = actor.mesh.geometry;
    gles3::ProgramSet programs;
    programs.roles[0] = {kVelocityVertex, kVelocityFragment, {}};
    gles3::SkinnerOptions options;
    options.motion = true;
    std::vector<SoaTransform> memory;
    gles3::Skinner skinner;
    ASSERT_EQ(gles3::create_skinner(api, stage.caps(), actor.mesh, options, programs,
                                    room_for(memory, gles3::skinner_bytes(actor.mesh, options)), skinner),
              Status::ok);
    const auto step = static_cast<float>(0.4 * diagonal(g));  // 0.4 of the clip space's unit: a fifth of the picture
    struct Case {
      float character, camera;
      int red;  // 255 (0.5 + 0.5 motion)
    };
    for (const Case& c : {Case{0, 0, 128}, Case{step, 0, 153}, Case{0, 0.4f, 153}, Case{step, -0.4f, 128}}) {
      std::vector<Affine> joints = actor.joints(0.2f);
      for (int frame = 0; frame < 2; ++frame) {
        if (frame == 1)
          for (Affine& joint : joints) joint.rows[0][3] += c.character;
        ASSERT_EQ(gles3::pose(skinner, 0, joints), Status::ok);
        ASSERT_EQ(gles3::update(api, skinner, programs, 1), Status::ok);
      }
      const gles3::Program& program = gles3::program_of(skinner, programs, 0);
      stage.clear();
      api.UseProgram(program.id);
      api.UniformMatrix4fv(api.GetUniformLocation(program.id, "clip_from_model"), 1, 0, Camera(g, c.camera).matrix);
      api.UniformMatrix4fv(api.GetUniformLocation(program.id, "previous_clip_from_model"), 1, 0, Camera(g, 0).matrix);
      ASSERT_EQ(gles3::draw(api, skinner, programs, program, 0, 1), Status::ok);
      const std::vector<std::uint8_t> picture = stage.picture();
      std::size_t covered = 0;
      for (std::size_t i = 0; i < picture.size(); i += 4) {
        if (picture[i + 3] == 0) continue;
        ++covered;
        ASSERT_NEAR(picture[i], c.red, 1) << "character " << c.character << ", camera " << c.camera;
        ASSERT_NEAR(picture[i + 1], 128, 1);
      }
      EXPECT_GT(covered, 200u);
    }
    gles3::destroy(api, skinner);
    gles3::destroy(api, programs);
    EXPECT_EQ(stage.error(), 0u);
  });
}

// A crowd: instances that play on, one that is placed elsewhere on the way, one that jumps.
TEST(Motion, CrowdsKnowTheFrameBefore) {
  const TestCharacter character = make_character(31, 23, 13, true);
  const Mesh mesh = with_box(character.mesh);
  const Reel reel(character.skeleton.view(), {{character.clip.view(), true}}, 20);
  constexpr std::uint32_t kCount = 40;  // 40 palettes of 23 matrices share lines of 2048 rows
  gles3::CrowdMesh crowd_mesh;
  gles3::Crowd crowd;
  std::vector<SoaTransform> mesh_memory, memory;
  ASSERT_EQ(gles3::create_crowd_mesh(gl(), {}, mesh, {}, reel.frames, kCount,
                                     room_for(mesh_memory, gles3::crowd_mesh_bytes(mesh)), crowd_mesh, true),
            Status::ok);
  ASSERT_EQ(gles3::create_crowd(gl(), {}, kCount, room_for(memory, kCount * gles3::kCrowdInstanceBytes), crowd),
            Status::ok);
  gles3::ProgramSet programs;
  programs.roles[0] = kSource;
  ASSERT_EQ(gles3::create_crowd_programs(gl(), gl().caps(), crowd_mesh, gles3::Deformer::as, 255, programs),
            Status::ok);
  const gles3::Program& blending = gles3::blending_program_of(programs);
  const gles3::Program& drawing = gles3::crowd_program_of(crowd_mesh, gles3::Deformer::as, 255, programs, 0);
  ASSERT_TRUE(state_of(drawing).motion);
  std::vector<gles3::CrowdInstance> instances = some_of_each(reel.frames, kCount, 50, 3), before = instances;
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry));
  ASSERT_EQ(as_coordinates(mesh.geometry, coordinates), Status::ok);

  const auto blend = [&](double time_s) {
    gles3::begin_frame(crowd_mesh);
    gl().UseProgram(blending.id);
    ASSERT_EQ(gles3::blend_crowd(gl(), crowd, crowd_mesh, 0, kCount, time_s, 3, blending), Status::ok);
  };
  ASSERT_EQ(gles3::set_instances(gl(), crowd, reel.frames, 0, instances), Status::ok);
  blend(50.1);
  instances[3].world_from_model.rows[0][3] += 0.5f;  // walks
  instances[7].world_from_model.rows[1][3] += 100;   // jumps
  instances[39].a.phase_s += 0.7f;                   // its clip jumps
  ASSERT_EQ(gles3::set_instances(gl(), crowd, reel.frames, 0, instances), Status::ok);
  blend(50.2);
  const auto previous = [&](std::uint32_t first, double time_s) {
    return gles3::blend_previous_crowd(gl(), crowd, crowd_mesh, first, 1, time_s, 3, blending);
  };
  ASSERT_EQ(previous(7, 50.1), Status::ok);
  ASSERT_EQ(previous(39, 50.2), Status::ok);
  before[7] = instances[7];
  before[39] = instances[39];

  gl().UseProgram(drawing.id);
  ASSERT_EQ(gles3::bind_crowd(gl(), crowd, crowd_mesh, 0, kCount, 1, drawing), Status::ok);
  gles3::tell_of_vertices(gl(), state_of(crowd_mesh).gpu, drawing);
  const std::vector<Both> got = capture(state_of(crowd_mesh).gpu.as_array, state_of(crowd_mesh).gpu.slot_count, kCount);
  Worst worst;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const auto add = [&](const std::vector<float>& positions, const gles3::CrowdInstance& one, double time_s) {
      Skinned skinned{positions, std::vector<float>(positions.size()), std::vector<float>(positions.size() / 3 * 4)};
      Geometry bare = mesh.geometry;
      bare.normals = nullptr;
      bare.tangents = nullptr;
      Mesh compared = mesh;
      compared.geometry = bare;
      worst.add(compare_instance(compared, reel.frames, one, time_s, gles3::Deformer::as, coordinates, {}, skinned));
    };
    add(got[i].now, instances[i], 50.2);
    add(got[i].before, before[i], i == 39 ? 50.2 : 50.1);
  }
  EXPECT_LE(worst.position, kMostCrowdPosition);
  std::printf("crowd: %zu vertices, %.1e of the diagonal apart at most\n", worst.vertices, worst.position);
  EXPECT_GT(farthest(got[3].now, got[3].before), 0.4);
  EXPECT_LT(farthest(got[39].now, got[39].before), 1e-4 * diagonal(mesh.geometry));

  gles3::CrowdMesh still;
  std::vector<SoaTransform> still_memory;
  ASSERT_EQ(gles3::create_crowd_mesh(gl(), {}, mesh, {}, reel.frames, kCount,
                                     room_for(still_memory, gles3::crowd_mesh_bytes(mesh)), still),
            Status::ok);
  EXPECT_EQ(gles3::blend_previous_crowd(gl(), crowd, still, 0, 1, 50, 3, blending), Status::bad_argument);
  EXPECT_EQ(gles3::bind_crowd(gl(), crowd, still, 0, 1, 3, drawing), Status::bad_argument) << "it keeps no motion";
  gles3::destroy(gl(), still);
  gles3::destroy(gl(), crowd_mesh);
  gles3::destroy(gl(), crowd);
  gles3::destroy(gl(), programs);
}

}  // namespace
}  // namespace marrow::test
