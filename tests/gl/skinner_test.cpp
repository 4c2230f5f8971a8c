// A mesh as several characters by every path: the same picture, whatever happens to the context and to memory.
#include <cstring>
#include <set>

#include <gtest/gtest.h>

#include "gl/support/faulty_driver.h"
#include "gl/support/feedback.h"
#include "gl/support/models.h"
#include "gl/support/reports.h"
#include "gl/support/stage.h"
#include "gles3/program_set.h"
#include "gles3/skinner_state.h"
#include "marrow/egl.h"
#include "marrow/gles3_skinner.h"
#include "marrow/marrow.h"
#include "pose/evaluate.h"
#include "support/family.h"
#include "support/places.h"

namespace marrow::test {
namespace {

using gles3::SkinningPath;

constexpr std::uint32_t kCharacters = 3;
constexpr SkinningPath kPaths[] = {SkinningPath::ubo, SkinningPath::texture, SkinningPath::feedback,
                                   SkinningPath::compute, SkinningPath::cpu};
static_assert(std::size(kPaths) == gles3::kPathCount);
constexpr gles3::Deformer kDeformers[] = {gles3::Deformer::rigid, gles3::Deformer::ssd, gles3::Deformer::as,
                                          gles3::Deformer::psd};

// Colours by normal, so that pictures tell more than outlines. The camera looks along -z at a box of its own.
constexpr const char* kVertex = R"(
uniform vec4 from_scene;  // shift, then scale
out vec3 colour_of_normal;
void main() {
  MarrowVertex v = marrow_skin();
  colour_of_normal = 0.5 + 0.5 * v.normal;
  gl_Position = vec4((v.position + from_scene.xyz) * from_scene.w, 1.0);
}
)";
constexpr const char* kFragment = R"(
precision highp float;
in vec3 colour_of_normal;
out vec4 colour;
void main() { colour = vec4(colour_of_normal, 1.0); }
)";

// One mesh of a model, and what its characters do.
struct Scene {
  explicit Scene(const std::string& path) : model(cook_model(path)) {
    EXPECT_TRUE(model.has_value());
    for (std::uint32_t m = 0; m < model->file.mesh_count(); ++m)
      if (model->file.mesh(m).geometry.slot_count > mesh.geometry.slot_count) mesh = model->file.mesh(index = m);
    weights.assign(mesh.targets.size, 0.5f);
    space.emplace(5, mesh, 9, mesh.geometry.index_bytes == 4);
    const float size = mesh.geometry.box_max[0] - mesh.geometry.box_min[0];
    for (MorphTarget& example : space->examples) example.position_step *= 0.1f * size;
    space->put(mesh.geometry);
  }
  std::vector<Affine> joints(std::uint32_t character) const {
    const Skeleton skeleton = model->file.skeleton(mesh.skeleton);
    std::vector<SoaTransform> local(skeleton.soa_size());
    std::vector<Affine> out(skeleton.joint_count);
    std::copy_n(skeleton.rest, skeleton.soa_size(), local.begin());
    if (model->file.clip_count() > 0 && model->file.clip(0).skeleton == mesh.skeleton) {
      EXPECT_EQ(sample(skeleton, model->file.clip(0), 0.3f * static_cast<float>(character), local), Status::ok);
    }
    EXPECT_EQ(local_to_model(skeleton, local, out), Status::ok);
    const float size = mesh.geometry.box_max[0] - mesh.geometry.box_min[0];
    for (Affine& joint : out) joint.rows[0][3] += (static_cast<float>(character) - 1) * size;
    return out;
  }

  std::optional<Model> model;
  std::uint32_t index = 0;
  Mesh mesh;
  std::vector<float> weights;
  std::optional<TestPoseSpace> space;
};

struct Player {
  Player(const gles3::Api& api, const gles3::Caps& caps, const Scene& of, const gles3::SkinnerOptions& o)
      : Player(of, o) {
    status = create(api, caps);
  }
  Player(const Scene& of, const gles3::SkinnerOptions& o) : scene(of), options(o) {
    programs.roles[0] = {kVertex, kFragment, {}};
    programs.log = log;
    options.instances = kCharacters;
    memory.resize(gles3::skinner_bytes(scene.mesh, options) / sizeof(SoaTransform) + 1);
  }
  Status create(const gles3::Api& api, const gles3::Caps& caps) {
    return gles3::create_skinner(api, caps, scene.mesh, options, programs,
                                 {reinterpret_cast<std::byte*>(memory.data()), memory.size() * sizeof(SoaTransform)},
                                 skinner);
  }
  void pose_all() {
    for (std::uint32_t i = 0; i < kCharacters; ++i)
      EXPECT_EQ(gles3::pose(skinner, i, scene.joints(i), scene.weights), Status::ok);
  }
  // A frame: what a game does every time.
  Status frame(const gles3::Api& api, std::uint32_t role = 0) {
    const Status updated = gles3::update(api, skinner, programs, kCharacters);
    if (updated != Status::ok) return updated;
    const gles3::Program& program = gles3::program_of(skinner, programs, role);
    api.UseProgram(program.id);
    const Geometry& g = scene.mesh.geometry;
    const float width = 4 * (g.box_max[0] - g.box_min[0]);
    const float values[4] = {-0.5f * (g.box_min[0] + g.box_max[0]), -0.5f * (g.box_min[1] + g.box_max[1]),
                             -0.5f * (g.box_min[2] + g.box_max[2]), 2 / width};
    api.Uniform4fv(api.GetUniformLocation(program.id, "from_scene"), 1, values);
    return gles3::draw(api, skinner, programs, program, 0, kCharacters);
  }

  const Scene& scene;
  gles3::SkinnerOptions options;
  gles3::ProgramSet programs;
  std::vector<char> log = std::vector<char>(2048);
  std::vector<SoaTransform> memory;
  gles3::Skinner skinner;
  Status status = Status::bad_argument;
};

std::size_t covered(const std::vector<std::uint8_t>& picture) {
  std::size_t out = 0;
  for (std::size_t i = 3; i < picture.size(); i += 4) out += picture[i] != 0;
  return out;
}

// Pixels that differ by more than 8 levels.
std::size_t different(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  std::size_t out = 0;
  for (std::size_t i = 0; i < a.size(); i += 4) {
    int most = 0;
    for (std::size_t c = 0; c < 4; ++c) most = std::max(most, std::abs(int{a[i + c]} - int{b[i + c]}));
    out += most > 8;
  }
  return out;
}

std::vector<std::pair<SkinningPath, gles3::Deformer>> every_path_of(std::initializer_list<gles3::Deformer> deformers,
                                                                    const gles3::Caps& caps) {
  std::vector<std::pair<SkinningPath, gles3::Deformer>> out;
  for (const SkinningPath way : kPaths)
    for (const gles3::Deformer deformer : deformers)
      if (way != SkinningPath::compute || caps.compute) out.emplace_back(way, deformer);
  return out;
}

const std::string kFace = in_golden("face.gltf");

TEST(Skinner, EveryPathDrawsTheSame) {
  on_a_thread([] {
    const Stage stage;
    int pictures = 0;
    for (const std::string& path : {model_paths().front(), kFace}) {
      const Scene scene(path);
      for (const gles3::Deformer deformer : kDeformers) {
        std::vector<std::uint8_t> first;
        for (const SkinningPath way : kPaths) {
          if (way == SkinningPath::compute && !stage.caps().compute) continue;
          Player player(stage.real(), stage.caps(), scene, {way, deformer});
          ASSERT_EQ(player.status, Status::ok) << to_string(way) << player.log.data();
          player.pose_all();
          stage.clear();
          EXPECT_EQ(player.frame(stage.real()), Status::ok) << to_string(way);
          const std::vector<std::uint8_t> picture = stage.picture();
          EXPECT_GT(covered(picture), 500u) << to_string(way);
          if (first.empty()) first = picture;
          EXPECT_LE(different(first, picture), std::size_t{kStageSide} * kStageSide / 1000) << to_string(way);
          gles3::destroy(stage.real(), player.skinner);
          gles3::destroy(stage.real(), player.programs);
          EXPECT_EQ(stage.error(), 0u);
          ++pictures;
        }
      }
    }
    EXPECT_EQ(pictures, stage.caps().compute ? 40 : 32);
  });
}

// 48 bytes a joint go up, as many again of a pose space of nine, no object is made, nothing compiled or asked.
TEST(Skinner, AFrameUploadsPalettesAlone) {
  on_a_thread([] {
    const Stage stage;
    const Scene scene(model_paths().front());
    int paths = 0;
    for (const auto& [way, deformer] : every_path_of({gles3::Deformer::ssd, gles3::Deformer::psd}, stage.caps())) {
      const gles3::Api api = faulty_api(stage.real());
      Player player(api, stage.caps(), scene, {way, deformer});
      ASSERT_EQ(player.status, Status::ok);
      player.pose_all();
      EXPECT_EQ(player.frame(api), Status::ok);
      driver().count.clear();
      driver().uploaded_bytes = 0;
      EXPECT_EQ(player.frame(api), Status::ok);
      const std::int64_t slots = scene.mesh.geometry.slot_count;
      EXPECT_EQ(driver().uploaded_bytes,
                kCharacters * (way == SkinningPath::cpu ? slots * (scene.mesh.geometry.tangents != nullptr ? 40 : 24)
                                                        : (deformer == gles3::Deformer::psd ? 96 : 48) *
                                                              std::int64_t{scene.mesh.palette_size()}));
      for (const char* const name : {"Gen", "Delete", "CreateShader", "CreateProgram", "CompileShader", "LinkProgram",
                                     "GetIntegerv", "GetProgramiv", "GetShaderiv", "GetString", "ObjectLabel"})
        EXPECT_EQ(driver().count[name], 0) << name << " on " << to_string(way);
      gles3::destroy(api, player.skinner);
      gles3::destroy(api, player.programs);
      EXPECT_EQ(driver().live, 0) << to_string(way);
      ++paths;
    }
    EXPECT_GE(paths, 8);
  });
}

// A shadow's outline is that of what casts it, though its programs read neither normals nor what only they need.
TEST(Skinner, ARoleReadsWhatItSaysAndNoMore) {
  on_a_thread([] {
    const Stage stage;
    const Scene scene(model_paths().front());
    const std::vector<float> tangents = tools::tangents_of(scene.model->file, 0)[scene.index];
    ASSERT_FALSE(tangents.empty());
    constexpr const char* kPlain = R"(
uniform vec4 from_scene;
void main() { gl_Position = vec4((marrow_skin().position + from_scene.xyz) * from_scene.w, 1.0); }
)";
    constexpr const char* kWhite = "precision highp float;\nout vec4 colour;\nvoid main() { colour = vec4(1.0); }\n";
    int paths = 0;
    for (const SkinningPath way : kPaths) {
      if (way == SkinningPath::compute && !stage.caps().compute) continue;
      gles3::SkinnerOptions options{way, gles3::Deformer::as};
      options.as_tangents = tangents;
      Player player(scene, options);
      player.programs.roles[1] = {kPlain, kWhite, {}};
      player.programs.role_features[1] = 0;
      player.programs.role_count = 2;
      ASSERT_EQ(player.create(stage.real(), stage.caps()), Status::ok) << to_string(way) << player.log.data();
      player.pose_all();
      std::vector<std::uint8_t> pictures[2];
      for (std::uint32_t role = 0; role < 2; ++role) {
        stage.clear();
        EXPECT_EQ(player.frame(stage.real(), role), Status::ok);
        pictures[role] = stage.picture();
      }
      EXPECT_GT(covered(pictures[0]), 500u) << to_string(way);
      for (std::size_t i = 3; i < pictures[0].size(); i += 4)
        ASSERT_EQ(pictures[0][i], pictures[1][i]) << to_string(way);
      for (std::uint32_t i = 0; i < state_of(player.programs).count; ++i) {
        const gles3::ProgramSetEntry& entry = state_of(player.programs).entries[i];
        if (entry.role == 1) {
          EXPECT_EQ(entry.key.features, 0) << to_string(way);
        }
        const bool by_shader = way == SkinningPath::ubo || way == SkinningPath::texture;
        if (entry.role == 0 && by_shader) {
          EXPECT_NE(entry.key.features & gles3::kSurfaceNormals, 0) << to_string(way);
        }
      }
      gles3::destroy(stage.real(), player.skinner);
      gles3::destroy(stage.real(), player.programs);
      EXPECT_EQ(stage.error(), 0u);
      ++paths;
    }
    EXPECT_GE(paths, 4);
  });
}

TEST(Skinner, LabelsEveryObjectOnce) {
  on_a_thread([] {
    const Stage stage;
    const Scene scene(kFace);
    ASSERT_FALSE(scene.mesh.targets.empty());
    std::set<std::string> texts;
    for (const SkinningPath way : kPaths) {
      if (way == SkinningPath::compute && !stage.caps().compute) continue;
      for (const gles3::Deformer deformer : kDeformers) {
        gles3::Api api = faulty_api(stage.real());
        record_labels(api);
        Player player(api, stage.caps(), scene, {way, deformer});
        ASSERT_EQ(player.status, Status::ok);
        player.pose_all();
        EXPECT_EQ(player.frame(api), Status::ok);
        EXPECT_EQ(static_cast<std::int64_t>(driver().labels.size()), driver().live) << to_string(way);
        for (const auto& [object, label] : driver().labels) {
          EXPECT_EQ(label.count, 1) << label.text;
          EXPECT_FALSE(label.text.empty());
          texts.insert(label.text);
        }
        gles3::destroy(api, player.skinner);
        gles3::destroy(api, player.programs);
        EXPECT_EQ(driver().live, 0);
      }
    }
    for (const char* const role : {"skin", "animation space", "surface", "indices", "morph rows", "morph targets",
                                   "pose space", "skinned vertices"})
      EXPECT_EQ(texts.count(std::string(scene.mesh.name) + ": " + role), 1u) << role;
    for (const char* const text :
         {"marrow: palettes", "marrow: distances of poses", "marrow: drawing", "marrow: drawing, psd, morph targets",
          "marrow: drawing, ssd, morph targets", "marrow: pre-skinning by feedback, as, morph targets",
          "marrow: drawing, as, morph targets, palettes in a texture"})
      EXPECT_EQ(texts.count(text), 1u) << text;
  });
}

TEST(Skinner, LabelsReachTheDriver) {
  on_a_thread([] {
    const Stage stage;
    const Scene scene(kFace);
    gles3::Api api = stage.real();
    const bool known =
        std::strstr(reinterpret_cast<const char*>(api.GetString(GL_EXTENSIONS)), "GL_KHR_debug") != nullptr;
    std::printf("labels: %s\n", known ? "GL_KHR_debug" : api.ObjectLabel != nullptr ? "OpenGL ES 3.2" : "none");
    ASSERT_TRUE(!known || api.ObjectLabel != nullptr);
    using GetObjectLabel = void (*)(GLenum kind, GLuint name, GLsizei size, GLsizei * length, char* text);
    const auto get = reinterpret_cast<GetObjectLabel>(egl::load_proc("glGetObjectLabelKHR"));
    for (const SkinningPath way : kPaths) {
      if (way == SkinningPath::compute && !stage.caps().compute) continue;
      Player player(api, stage.caps(), scene, {way});
      ASSERT_EQ(player.status, Status::ok);
      EXPECT_EQ(stage.error(), 0u) << to_string(way);
      if (known && get != nullptr) {
        char text[256] = {};
        get(0x82E0, state_of(player.skinner).gpu.index_buffer, sizeof(text), nullptr, text);
        EXPECT_EQ(text, std::string(scene.mesh.name) + ": indices");
      }
      gles3::destroy(api, player.skinner);
      gles3::destroy(api, player.programs);
    }
    api.ObjectLabel = nullptr;
    Player player(api, stage.caps(), scene, {SkinningPath::ubo});
    EXPECT_EQ(player.status, Status::ok);
    gles3::destroy(api, player.skinner);
    gles3::destroy(api, player.programs);
    EXPECT_EQ(stage.error(), 0u);
  });
}

TEST(Skinner, CausesNoErrorOnAnyPath) {
  on_a_thread([] {
    const Stage stage;
    for (const std::string& path : {model_paths().front(), kFace}) {
      const Scene scene(path);
      for (const auto& [way, deformer] : every_path_of({gles3::Deformer::as, gles3::Deformer::psd}, stage.caps())) {
        std::vector<Report> reports;
        gles3::ErrorWatch watch = watch_into(reports);
        gles3::Api api = stage.real();
        gles3::watch_errors(api, &watch);
        Player player(api, stage.caps(), scene, {way, deformer});
        ASSERT_EQ(player.status, Status::ok);
        player.pose_all();
        for (int frame = 0; frame < 4; ++frame) EXPECT_EQ(player.frame(api), Status::ok);
        gles3::destroy(api, player.skinner);
        gles3::destroy(api, player.programs);
        for (const Report& report : reports)
          ADD_FAILURE() << to_string(way) << ": " << report.call << " " << report.error;
        EXPECT_EQ(watch.pending, 0u);
      }
    }
  });
}

// The context goes at some call of a frame; the game notices afterwards, and has the same picture in the next context.
TEST(Skinner, SurvivesTheLossOfTheContextAnywhere) {
  on_a_thread([] {
    const Scene scene(model_paths().front());
    // At least, if a frame has as many calls.
    const std::int64_t losses_of_a_path = in_long_form() ? 19 : 4;
    int losses = 0;
    auto stage = std::make_unique<Stage>();
    for (const auto& [way, deformer] : every_path_of({gles3::Deformer::as, gles3::Deformer::psd}, stage->caps())) {
      gles3::Api api = faulty_api(stage->real());
      Player player(api, stage->caps(), scene, {way, deformer});
      ASSERT_EQ(player.status, Status::ok);
      player.pose_all();
      stage->clear();
      const std::int64_t before = driver().calls;
      EXPECT_EQ(player.frame(api), Status::ok);
      const std::int64_t calls = driver().calls - before;
      EXPECT_GT(calls, 8);
      const std::vector<std::uint8_t> wanted = stage->picture();
      for (std::int64_t at = 0; at <= calls; at += std::max<std::int64_t>(1, calls / losses_of_a_path)) {
        driver().lost_after = driver().calls + at;
        (void)player.frame(api);
        gles3::on_context_lost(player.skinner);
        gles3::on_context_lost(player.programs);
        EXPECT_EQ(gles3::update(api, player.skinner, player.programs, 1), Status::gl_error);
        stage.reset();
        stage = std::make_unique<Stage>();
        api = faulty_api(stage->real());
        ASSERT_EQ(gles3::on_context_restored(api, stage->caps(), player.programs), Status::ok);
        ASSERT_EQ(gles3::on_context_restored(api, stage->caps(), player.skinner), Status::ok);
        stage->clear();
        EXPECT_EQ(player.frame(api), Status::ok);
        EXPECT_EQ(stage->picture(), wanted) << to_string(way) << ", call " << at;
        EXPECT_EQ(stage->error(), 0u);
        ++losses;
      }
      gles3::destroy(api, player.skinner);
      gles3::destroy(api, player.programs);
      EXPECT_EQ(driver().live, 0) << to_string(way);
    }
    EXPECT_GE(losses, 8 * losses_of_a_path);
    std::printf("%d losses\n", losses);
  });
}

TEST(Skinner, RunsOutOfMemoryAnywhere) {
  on_a_thread([] {
    const Stage stage;
    const Scene scene(kFace);
    int failures = 0;
    for (const SkinningPath way : kPaths) {
      if (way == SkinningPath::compute && !stage.caps().compute) continue;
      for (std::int64_t room = 0;; ++room) {
        const gles3::Api api = faulty_api(stage.real());
        driver().full_after = room;
        Player player(api, stage.caps(), scene, {way});
        gles3::destroy(api, player.skinner);
        gles3::destroy(api, player.programs);
        EXPECT_EQ(driver().live, 0) << to_string(way) << ", allocation " << room;
        if (player.status == Status::ok) break;
        EXPECT_EQ(player.status, Status::gl_error);
        ASSERT_LT(room, 50);
        ++failures;
      }
    }
    EXPECT_GE(failures, 16);
    EXPECT_EQ(stage.error(), 0u);
  });
}

TEST(Skinner, RefusesBadCalls) {
  on_a_thread([] {
    const Stage stage;
    const Scene scene(kFace);
    const gles3::Api& api = stage.real();
    gles3::Caps caps = stage.caps();
    caps.compute = false;
    EXPECT_EQ(Player(api, caps, scene, {SkinningPath::compute}).status, Status::unsupported);
    EXPECT_EQ(Player(api, caps, scene, {SkinningPath::ubo, gles3::Deformer::none}).status, Status::bad_argument);
    Player player(api, caps, scene, {SkinningPath::ubo});
    ASSERT_EQ(player.status, Status::ok);
    gles3::Skinner other;
    const auto make = [&](std::uint32_t instances, std::size_t bytes, std::size_t shift) {
      gles3::SkinnerOptions options = player.options;
      options.instances = instances;
      std::vector<SoaTransform> memory(bytes / sizeof(SoaTransform) + 2);
      return gles3::create_skinner(api, caps, scene.mesh, options, player.programs,
                                   {reinterpret_cast<std::byte*>(memory.data()) + shift, bytes}, other);
    };
    const std::size_t enough = gles3::skinner_bytes(scene.mesh, player.options);
    EXPECT_EQ(make(0, enough, 0), Status::bad_argument);
    EXPECT_EQ(make(kCharacters, enough - 1, 0), Status::bad_argument);
    EXPECT_EQ(make(kCharacters, enough, 4), Status::bad_argument);
    EXPECT_EQ(make(kCharacters, enough, 0), Status::ok);
    gles3::destroy(api, other);

    const std::vector<Affine> joints = scene.joints(0);
    EXPECT_EQ(gles3::pose(player.skinner, kCharacters, joints, scene.weights), Status::bad_argument);
    EXPECT_EQ(gles3::pose(player.skinner, 0, joints, {}), Status::bad_argument);
    EXPECT_EQ(gles3::update(api, player.skinner, player.programs, kCharacters + 1), Status::bad_argument);
    const gles3::Program& program = gles3::program_of(player.skinner, player.programs, 0);
    EXPECT_EQ(gles3::draw(api, player.skinner, player.programs, program, 0, 1), Status::bad_argument) << "not updated";
    EXPECT_EQ(gles3::program_of(player.skinner, player.programs, 1).id, 0u);
    gles3::destroy(api, player.skinner);
    gles3::destroy(api, player.programs);
    EXPECT_EQ(stage.error(), 0u);
  });
}

}  // namespace
}  // namespace marrow::test
