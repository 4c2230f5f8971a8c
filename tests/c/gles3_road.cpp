// What gles3_road.c does, in C++: the same pictures must come of it.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <vector>

#include <GLES3/gl3.h>
#include <marrow/egl.h>
#include <marrow/gles3_crowd.h>
#include <marrow/gles3_self_test.h>
#include <marrow/marrow.h>

namespace {

using namespace marrow;
namespace gl = marrow::gles3;

constexpr std::uint32_t kCharacters = 3, kCrowd = 5;
constexpr int kSide = 128;

constexpr const char* kVertex =
    "out vec3 tint;\n"
    "void main() {\n"
    "  MarrowVertex v = marrow_skin();\n"
    "  tint = (0.5 + 0.5 * v.normal) * marrow_instance_colour().rgb;\n"
    "#if MARROW_MOTION\n"
    "  tint.b = length(v.position - v.previous_position);\n"
    "#endif\n"
    "  gl_Position = vec4((v.position.xy - vec2(0.0, 0.7)) * 0.8, 0.4 * v.position.z, 1.0);\n"
    "}\n";
constexpr const char* kFragment =
    "precision highp float;\n"
    "in vec3 tint;\n"
    "out vec4 colour;\n"
    "void main() { colour = vec4(tint, 1.0); }\n";

void need(Status status, int line) {
  if (status == Status::ok) return;
  std::fprintf(stderr, "line %d: %s\n", line, to_string(status));
  std::exit(1);
}
#define TRY(call) need(call, __LINE__)

std::optional<egl::HeadlessContext> context;
gl::Api api;
gl::Caps caps;
unsigned framebuffer = 0;

void start() {
  context.reset();
  TRY(context.emplace().create());
  TRY(load_api(api, egl::load_proc));
  TRY(query_caps(api, caps));
  unsigned texture = 0;
  api.GenTextures(1, &texture);
  api.BindTexture(GL_TEXTURE_2D, texture);
  api.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSide, kSide, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  api.BindTexture(GL_TEXTURE_2D, 0);
  api.GenFramebuffers(1, &framebuffer);
  api.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  api.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
}

void begin_picture() {
  api.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  api.Viewport(0, 0, kSide, kSide);
  reinterpret_cast<PFNGLCLEARPROC>(egl::load_proc("glClear"))(GL_COLOR_BUFFER_BIT);
}

void end_picture(const char* what, const char* more = "") {
  std::vector<unsigned char> rgba(4 * kSide * kSide);
  api.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  api.ReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  unsigned hash = 2166136261u;
  int covered = 0;
  for (std::size_t i = 0; i < rgba.size(); ++i) {
    hash = (hash ^ rgba[i]) * 16777619u;
    covered += i % 4 == 3 && rgba[i] != 0;
  }
  std::printf("%s%s: %08x, %d pixels\n", what, more, hash, covered);
}

struct Scene {
  explicit Scene(const char* name) {
    std::ifstream stream(name, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(stream), {});
    TRY(load({reinterpret_cast<const std::byte*>(bytes.data()), bytes.size()}, file));
    for (std::uint32_t i = 0; i < file.mesh_count(); ++i)
      if (i == 0 || file.mesh(i).geometry.slot_count > mesh.geometry.slot_count) mesh = file.mesh(i);
    skeleton = file.skeleton(mesh.skeleton);
    local.resize(skeleton.soa_size());
    for (std::uint32_t i = 0; i < kCharacters; ++i) {
      joints[i].resize(skeleton.joint_count);
      TRY(sample(skeleton, file.clip(0), 0.3f * static_cast<float>(i), local));
      TRY(local_to_model(skeleton, local, joints[i]));
      for (Affine& joint : joints[i]) joint.rows[0][3] += 0.5f * (static_cast<float>(i) - 1);
    }
  }
  std::vector<char> bytes;
  File file;
  Mesh mesh;
  Skeleton skeleton;
  std::vector<SoaTransform> local;
  std::vector<Affine> joints[kCharacters];
};

void characters(const Scene& scene, gl::SkinnerOptions options, const char* what, const char* more) {
  options.instances = kCharacters;
  std::vector<std::byte> memory(skinner_bytes(scene.mesh, options));
  gl::ProgramSet programs;
  programs.roles[0] = {kVertex, kFragment, {}};
  gl::Skinner skinner;
  TRY(create_skinner(api, caps, scene.mesh, options, programs, memory, skinner));
  for (std::uint32_t i = 0; i < kCharacters; ++i) TRY(pose(skinner, i, scene.joints[i]));
  TRY(update(api, skinner, programs, kCharacters));
  const gl::Program& program = program_of(skinner, programs, 0);
  const auto picture = [&](const char* name, const char* rest) {
    begin_picture();
    api.UseProgram(program.id);
    TRY(draw(api, skinner, programs, program, 0, kCharacters));
    end_picture(name, rest);
  };
  picture(what, more);
  if (options.motion) {
    for (std::uint32_t i = 0; i < kCharacters; ++i) TRY(pose(skinner, i, scene.joints[(i + 1) % kCharacters]));
    TRY(reset_motion(skinner, 2));
    TRY(update(api, skinner, programs, kCharacters));
    picture("and moved", "");
  }
  destroy(api, skinner);
  destroy(api, programs);
}

void every_path(const Scene& scene) {
  for (const gl::Deformer deformer : {gl::Deformer::ssd, gl::Deformer::as})
    for (std::uint32_t i = 0; i < gl::kPathCount; ++i) {
      const auto path = static_cast<gl::SkinningPath>(i);
      if (path != gl::SkinningPath::compute || caps.compute)
        characters(scene, {.path = path, .deformer = deformer}, deformer == gl::Deformer::ssd ? "ssd, " : "as, ",
                   to_string(path));
    }
  for (std::uint32_t i = 0; i < gl::kPathCount; ++i) {
    const auto path = static_cast<gl::SkinningPath>(i);
    if (path != gl::SkinningPath::compute || caps.compute)
      characters(scene, {.path = path, .deformer = gl::Deformer::as, .motion = true}, "motion, ", to_string(path));
  }
  const Geometry& g = scene.mesh.geometry;
  std::vector<float> coordinates(as_coordinate_count(g)), tangents(as_tangent_count(g));
  TRY(as_coordinates(g, coordinates));
  const AsPart part{&scene.mesh, coordinates, tangents};
  std::vector<std::byte> scratch(as_tangent_scratch_bytes({part}));
  TRY(as_tangents({part}, scratch));
  characters(scene, {.deformer = gl::Deformer::as, .as_tangents = tangents}, "as, its own normals", "");
}

void crowds(Scene& scene) {
  const gl::CrowdSource sources[] = {{scene.file.clip(0)}, {scene.file.clip(1)}};
  gl::CrowdClip clips[2];
  std::uint32_t frame_count = 0;
  TRY(plan_crowd(sources, 30, clips, frame_count));
  std::vector<Affine> matrices(std::size_t{frame_count} * scene.skeleton.joint_count);
  gl::CrowdFrames frames;
  TRY(bake_crowd(scene.skeleton, sources, clips, scene.local, matrices, frames));
  gl::CrowdMesh mesh;
  gl::Crowd crowd;
  gl::ProgramSet programs;
  programs.roles[0] = {kVertex, kFragment, {}};
  std::vector<std::byte> memory(gl::crowd_mesh_bytes(scene.mesh)), records(kCrowd * gl::kCrowdInstanceBytes);
  TRY(create_crowd_mesh(api, caps, scene.mesh, {}, frames, kCrowd, memory, mesh, true));
  TRY(create_crowd_programs(api, caps, mesh, gl::Deformer::ssd, 255, programs));
  TRY(create_crowd(api, caps, kCrowd, records, crowd));
  gl::CrowdInstance instances[kCrowd];
  for (std::uint32_t i = 0; i < kCrowd; ++i) {
    instances[i].world_from_model.rows[0][3] = 0.4f * (static_cast<float>(i) - 2);
    instances[i].a.clip = i % 2;
    instances[i].a.phase_s = 0.1f * static_cast<float>(i);
    instances[i].colour[2] = 0.25f * static_cast<float>(i);
  }
  instances[4].b.clip = 1;
  instances[4].blend_start_s = 1;
  instances[4].blend_s = 0.5f;
  TRY(set_instances(api, crowd, frames, 0, instances));
  const gl::Program& blending = blending_program_of(programs);
  const gl::Program& drawing = crowd_program_of(mesh, gl::Deformer::ssd, 255, programs, 0);
  begin_frame(mesh);
  api.UseProgram(blending.id);
  TRY(blend_previous_crowd(api, crowd, mesh, 0, kCrowd, 1.2, 0, blending));
  TRY(blend_crowd(api, crowd, mesh, 0, kCrowd, 1.25, 0, blending));
  begin_picture();
  api.UseProgram(drawing.id);
  TRY(bind_crowd(api, crowd, mesh, 0, kCrowd, 0, drawing));
  TRY(draw(api, mesh, gl::Deformer::ssd, drawing, kCrowd));
  end_picture("crowd");
  Affine joint;
  TRY(crowd_joint(frames, instances[4], 1.25, scene.skeleton.joint_count - 1, joint));
  std::printf("a joint at %a %a %a\n", double{joint.rows[0][3]}, double{joint.rows[1][3]}, double{joint.rows[2][3]});
  destroy(api, crowd);
  destroy(api, mesh);
  destroy(api, programs);
}

void self_test() {
  int tries = 0;
  gl::SelfTestOptions options;
  options.about_to_try = [](void* user, gl::SkinningPath) { ++*static_cast<int*>(user); };
  options.user = &tries;
  std::vector<std::byte> memory(self_test_bytes(options));
  gl::SelfTest test;
  TRY(self_test(api, caps, options, memory, test));
  for (std::uint32_t i = 0; i < gl::kPathCount; ++i)
    std::printf("%s: %s, %a\n", to_string(static_cast<gl::SkinningPath>(i)), to_string(test.paths[i].verdict),
                double{test.paths[i].position_error});
  gl::SkinningPath best = gl::SkinningPath::cpu;
  TRY(choose(test, {}, best));
  std::printf("%s of %d tried\n", to_string(best), tries);
}

}  // namespace

int main(int argc, char** argv) {
  Scene scene(argc > 1 ? argv[1] : "newt.mrw");
  start();
  every_path(scene);
  crowds(scene);
  self_test();
  std::printf("1 error told, no reset\n");
}
