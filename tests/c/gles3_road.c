// Skinning by OpenGL ES 3.0 in C99: characters by every path, a crowd, the self-test; and all again after a loss of the
// context. Prints hashes of pictures. gles3_road.cpp does the same in C++.
#include <marrow/c_gles3.h>

#include "picture.h"

#define TRY(call)                                                                                 \
  do {                                                                                            \
    const mrw_status status = (call);                                                             \
    if (status != MRW_OK) exit((fprintf(stderr, "%s: %s\n", #call, mrw_status_text(status)), 1)); \
  } while (0)
#define EXPECT(call, wanted)                                                                             \
  do {                                                                                                   \
    const mrw_status got = (call);                                                                       \
    if (got != (wanted)) exit((fprintf(stderr, "%s: %s\n", #call, mrw_status_text(got)), 1)); \
  } while (0)
#define NEEDS(condition)                                                        \
  do {                                                                          \
    if (!(condition)) exit((fprintf(stderr, "%s does not hold\n", #condition), 1)); \
  } while (0)

enum { kCharacters = 3, kCrowd = 5 };

static const char kVertex[] =
    "out vec3 tint;\n"
    "void main() {\n"
    "  MarrowVertex v = marrow_skin();\n"
    "  tint = (0.5 + 0.5 * v.normal) * marrow_instance_colour().rgb;\n"
    "#if MARROW_MOTION\n"
    "  tint.b = length(v.position - v.previous_position);\n"
    "#endif\n"
    "  gl_Position = vec4((v.position.xy - vec2(0.0, 0.7)) * 0.8, 0.4 * v.position.z, 1.0);\n"
    "}\n";
static const char kFragment[] =
    "precision highp float;\n"
    "in vec3 tint;\n"
    "out vec4 colour;\n"
    "void main() { colour = vec4(tint, 1.0); }\n";

// All memory, which goes back as the program ends.
static void* taken[256];
static size_t taken_count = 0;

static void give_back(void) {
  while (taken_count > 0) free(taken[--taken_count]);
}

static void* block_of(size_t bytes) {
  mrw_block block;
  void* const memory = malloc(mrw_block_bytes(bytes));
  if (memory == NULL || taken_count == sizeof taken / sizeof taken[0]) exit(1);
  if (taken_count == 0) atexit(give_back);
  taken[taken_count++] = memory;
  TRY(mrw_block_in(memory, mrw_block_bytes(bytes), &block));
  return block.data;
}

static mrw_file read_file(const char* name) {
  mrw_file out;
  FILE* const file = fopen(name, "rb");
  void* block;
  long size = 0;
  if (file == NULL || fseek(file, 0, SEEK_END) != 0 || (size = ftell(file)) < 0) exit(1);
  rewind(file);
  block = block_of((size_t)size);
  if (fread(block, 1, (size_t)size, file) != (size_t)size) exit(1);
  fclose(file);
  TRY(mrw_load(block, (size_t)size, &out, NULL));
  return out;
}

static mrw_gles3_api api;
static mrw_gles3_caps caps;
static mrw_gles3_program_set programs;
static char log_text[2048];

static mrw_file file;
static mrw_mesh mesh;
static mrw_skeleton skeleton;
static mrw_affine* joints[kCharacters];

static void start(void) {
  const char* missing = NULL;
  open_context();
  make_picture();
  TRY(mrw_gles3_load_api(&api, load_proc, &missing));
  TRY(mrw_gles3_query_caps(&api, &caps));
}

static void open_programs(void) {
  mrw_gles3_program_set_init(&programs);
  programs.roles[0].vertex = kVertex;
  programs.roles[0].fragment = kFragment;
  programs.log = log_text;
  programs.log_bytes = sizeof log_text;
}

// The largest mesh, and a pose of each character.
static void load_scene(const char* name) {
  uint32_t i, k;
  mrw_soa_transform* local;
  file = read_file(name);
  TRY(mrw_file_mesh(&file, 0, 0, &mesh));
  for (i = 1; i < mrw_file_mesh_count(&file); ++i) {
    mrw_mesh other;
    TRY(mrw_file_mesh(&file, i, 0, &other));
    if (other.geometry.slot_count > mesh.geometry.slot_count) mesh = other;
  }
  TRY(mrw_file_skeleton(&file, mesh.skeleton, &skeleton));
  local = block_of(mrw_skeleton_soa_size(&skeleton) * sizeof *local);
  for (i = 0; i < kCharacters; ++i) {
    mrw_clip clip;
    TRY(mrw_file_clip(&file, 0, &clip));
    joints[i] = block_of(skeleton.joint_count * sizeof(mrw_affine));
    TRY(mrw_sample(&skeleton, &clip, 0.3f * (float)i, local, mrw_skeleton_soa_size(&skeleton), NULL));
    TRY(mrw_local_to_model(&skeleton, local, mrw_skeleton_soa_size(&skeleton), joints[i], skeleton.joint_count));
    for (k = 0; k < skeleton.joint_count; ++k) joints[i][k].rows[0][3] += 0.5f * ((float)i - 1);
  }
}

static unsigned told(const char* what, unsigned hash) {
  printf("%s: %08x, %d pixels\n", what, hash, covered);
  NEEDS(covered > 500);
  return hash;
}

static void lose_context(void) {
  close_context();
  start();
  TRY(mrw_gles3_programs_on_context_restored(&api, &caps, &programs));
}

static unsigned draw_characters(mrw_gles3_skinner* skinner) {
  const mrw_gles3_program* program;
  TRY(mrw_gles3_update(&api, skinner, &programs, kCharacters));
  program = mrw_gles3_program_of(skinner, &programs, 0);
  NEEDS(program != NULL && program->id != 0);
  begin_picture();
  gl.UseProgram(program->id);
  TRY(mrw_gles3_draw(&api, skinner, &programs, program, 0, kCharacters));
  return end_picture();
}

// Nothing is made of memory that is short, off its boundary, or of more characters than it has room for.
static void refuse_skinners(mrw_gles3_skinner_options options) {
  const size_t bytes = mrw_gles3_skinner_bytes(&mesh, &options);
  char* const memory = block_of(bytes + 4);
  mrw_gles3_skinner none;
  memset(&none, 0, sizeof none);
  EXPECT(mrw_gles3_create_skinner(&api, &caps, &mesh, &options, &programs, memory, bytes - 1, &none), MRW_BAD_ARGUMENT);
  EXPECT(mrw_gles3_create_skinner(&api, &caps, &mesh, &options, &programs, memory + 4, bytes, &none), MRW_BAD_ARGUMENT);
  EXPECT(mrw_gles3_create_skinner(&api, &caps, &mesh, &options, &programs, NULL, bytes, &none), MRW_BAD_ARGUMENT);
  options.instances = 0xFFFFFFFF;
  EXPECT(mrw_gles3_create_skinner(&api, &caps, &mesh, &options, &programs, memory, bytes, &none), MRW_BAD_ARGUMENT);
  options.instances = 1;
  options.path = 77;
  EXPECT(mrw_gles3_create_skinner(&api, &caps, &mesh, &options, &programs, memory, bytes, &none), MRW_BAD_ARGUMENT);
  NEEDS(mrw_gles3_program_of(&none, &programs, 99)->id == 0);
  EXPECT(mrw_gles3_pose(&none, 0, joints[0], skeleton.joint_count, NULL, 0), MRW_BAD_ARGUMENT);
  EXPECT(mrw_gles3_update(&api, &none, &programs, 1), MRW_BAD_ARGUMENT);
  mrw_gles3_destroy_skinner(&api, &none);
  NEEDS(gl.GetError() == GL_NO_ERROR);
}

static void characters(mrw_gles3_skinner_options options, const char* what) {
  const mrw_gles3_program none = {0};
  mrw_gles3_skinner skinner;
  size_t bytes;
  uint32_t i;
  unsigned hash;
  options.instances = kCharacters;
  bytes = mrw_gles3_skinner_bytes(&mesh, &options);
  open_programs();
  refuse_skinners(options);
  TRY(mrw_gles3_create_skinner(&api, &caps, &mesh, &options, &programs, block_of(bytes), bytes, &skinner));
  for (i = 0; i < kCharacters; ++i)
    TRY(mrw_gles3_pose(&skinner, i, joints[i], skeleton.joint_count, NULL, 0));
  hash = told(what, draw_characters(&skinner));
  if (options.motion) {  // two step aside, and one is put there
    for (i = 0; i < kCharacters; ++i)
      TRY(mrw_gles3_pose(&skinner, i, joints[(i + 1) % kCharacters], skeleton.joint_count, NULL, 0));
    TRY(mrw_gles3_reset_motion(&skinner, 2));
    NEEDS(told("and moved", draw_characters(&skinner)) != hash);
    for (i = 0; i < kCharacters; ++i)
      TRY(mrw_gles3_pose(&skinner, i, joints[i], skeleton.joint_count, NULL, 0));
  }
  EXPECT(mrw_gles3_update(&api, &skinner, &programs, kCharacters + 1), MRW_BAD_ARGUMENT);
  EXPECT(mrw_gles3_pose(&skinner, kCharacters, joints[0], skeleton.joint_count, NULL, 0), MRW_BAD_ARGUMENT);
  EXPECT(mrw_gles3_pose(&skinner, 0, joints[0], 1, NULL, 0), MRW_BAD_ARGUMENT);

  mrw_gles3_skinner_on_context_lost(&skinner);
  mrw_gles3_programs_on_context_lost(&programs);
  EXPECT(mrw_gles3_update(&api, &skinner, &programs, kCharacters), MRW_GL_ERROR);
  EXPECT(mrw_gles3_draw(&api, &skinner, &programs, &none, 0, 0), MRW_GL_ERROR);
  lose_context();
  TRY(mrw_gles3_skinner_on_context_restored(&api, &caps, &skinner));
  NEEDS(draw_characters(&skinner) == hash);
  mrw_gles3_destroy_skinner(&api, &skinner);
  mrw_gles3_destroy_programs(&api, &programs);
}

static void every_path(void) {
  const mrw_gles3_deformer deformers[] = {MRW_GLES3_DEFORMER_SSD, MRW_GLES3_DEFORMER_AS};
  mrw_gles3_skinner_options options;
  mrw_as_part part;
  char what[64];
  size_t d, bytes;
  uint32_t path;
  mrw_gles3_skinner_options_init(&options);
  for (d = 0; d < 2; ++d) {
    options.deformer = deformers[d];
    for (path = 0; path < MRW_GLES3_PATH_COUNT; ++path) {
      options.path = (mrw_gles3_skinning_path)path;
      sprintf(what, "%s, %s", d == 0 ? "ssd" : "as", mrw_gles3_skinning_path_text(options.path));
      if (options.path != MRW_GLES3_SKINNING_PATH_COMPUTE || caps.compute) characters(options, what);
    }
  }
  options.motion = true;
  for (path = 0; path < MRW_GLES3_PATH_COUNT; ++path) {
    options.path = (mrw_gles3_skinning_path)path;
    sprintf(what, "motion, %s", mrw_gles3_skinning_path_text(options.path));
    if (options.path != MRW_GLES3_SKINNING_PATH_COMPUTE || caps.compute) characters(options, what);
  }
  options.motion = false;
  // With the deformed surface's own normals.
  mrw_as_part_init(&part);
  part.mesh = &mesh;
  part.coordinate_count = mrw_as_coordinate_count(&mesh.geometry);
  part.coordinates = block_of(part.coordinate_count * sizeof(float));
  TRY(mrw_as_coordinates(&mesh.geometry, (float*)part.coordinates, part.coordinate_count));
  part.tangent_count = mrw_as_tangent_count(&mesh.geometry);
  part.tangents = block_of(part.tangent_count * sizeof(float));
  bytes = mrw_as_tangent_scratch_bytes(&part, 1);
  TRY(mrw_as_tangents(&part, 1, block_of(bytes), bytes));
  options.path = MRW_GLES3_SKINNING_PATH_UBO;
  options.as_tangents = part.tangents;
  options.as_tangent_count = part.tangent_count;
  characters(options, "as, its own normals");
}

static unsigned draw_crowd(const mrw_gles3_crowd* crowd, mrw_gles3_crowd_mesh* drawn) {
  const mrw_gles3_program* const blending = mrw_gles3_blending_program_of(&programs);
  const mrw_gles3_program* const drawing =
      mrw_gles3_crowd_program_of(drawn, MRW_GLES3_DEFORMER_SSD, 255, &programs, 0);
  NEEDS(blending != NULL && drawing != NULL);
  mrw_gles3_begin_crowd_frame(drawn);
  gl.UseProgram(blending->id);
  TRY(mrw_gles3_blend_previous_crowd(&api, crowd, drawn, 0, kCrowd, 1.2, 0, blending));
  TRY(mrw_gles3_blend_crowd(&api, crowd, drawn, 0, kCrowd, 1.25, 0, blending));
  begin_picture();
  gl.UseProgram(drawing->id);
  TRY(mrw_gles3_bind_crowd(&api, crowd, drawn, 0, kCrowd, 0, drawing));
  TRY(mrw_gles3_draw_crowd(&api, drawn, MRW_GLES3_DEFORMER_SSD, drawing, kCrowd));
  return end_picture();
}

static mrw_gles3_crowd_frames bake(void) {
  mrw_gles3_crowd_source sources[2];
  mrw_gles3_crowd_clip* const clips = block_of(2 * sizeof *clips);
  mrw_gles3_crowd_frames out;
  mrw_soa_transform* const scratch = block_of(mrw_skeleton_soa_size(&skeleton) * sizeof *scratch);
  mrw_affine* matrices;
  uint32_t frame_count, i;
  for (i = 0; i < 2; ++i) {
    mrw_gles3_crowd_source_init(&sources[i]);
    TRY(mrw_file_clip(&file, i, &sources[i].clip));
  }
  TRY(mrw_gles3_plan_crowd(sources, 2, 30, clips, 2, &frame_count));
  matrices = block_of((size_t)frame_count * skeleton.joint_count * sizeof *matrices);
  TRY(mrw_gles3_bake_crowd(&skeleton, sources, 2, clips, 2, scratch, mrw_skeleton_soa_size(&skeleton), matrices,
                           (size_t)frame_count * skeleton.joint_count, &out));
  return out;
}

static void crowds(void) {
  const mrw_gles3_crowd_frames frames = bake();
  const size_t bytes = mrw_gles3_crowd_mesh_bytes(&mesh, NULL);
  mrw_gles3_crowd_mesh drawn;
  mrw_gles3_crowd crowd;
  mrw_gles3_crowd_instance instances[kCrowd];
  mrw_affine joint;
  unsigned hash;
  uint32_t i;
  open_programs();
  TRY(mrw_gles3_create_crowd_mesh(&api, &caps, &mesh, NULL, &frames, kCrowd, block_of(bytes), bytes, &drawn,
                                  true));
  TRY(mrw_gles3_create_crowd_programs(&api, &caps, &drawn, MRW_GLES3_DEFORMER_SSD, 255, &programs));
  TRY(mrw_gles3_create_crowd(&api, &caps, kCrowd, block_of(kCrowd * MRW_GLES3_CROWD_INSTANCE_BYTES),
                             kCrowd * MRW_GLES3_CROWD_INSTANCE_BYTES, &crowd));
  for (i = 0; i < kCrowd; ++i) {
    mrw_gles3_crowd_instance_init(&instances[i]);
    instances[i].world_from_model.rows[0][3] = 0.4f * ((float)i - 2);
    instances[i].a.clip = i % 2;
    instances[i].a.phase_s = 0.1f * (float)i;
    instances[i].colour[2] = 0.25f * (float)i;
  }
  instances[4].b.clip = 1;
  instances[4].blend_start_s = 1;
  instances[4].blend_s = 0.5f;
  EXPECT(mrw_gles3_set_instances(&api, &crowd, &frames, 1, instances, kCrowd), MRW_BAD_ARGUMENT);
  EXPECT(mrw_gles3_set_instances(&api, &crowd, &frames, 0, NULL, kCrowd), MRW_BAD_ARGUMENT);
  EXPECT(mrw_gles3_set_instances(&api, &crowd, &frames, 0xFFFFFFFF, instances, 2), MRW_BAD_ARGUMENT);
  TRY(mrw_gles3_set_instances(&api, &crowd, &frames, 0, instances, kCrowd));
  hash = told("crowd", draw_crowd(&crowd, &drawn));
  TRY(mrw_gles3_crowd_joint(&frames, &instances[4], 1.25, skeleton.joint_count - 1, &joint));
  printf("a joint at %a %a %a\n", (double)joint.rows[0][3], (double)joint.rows[1][3], (double)joint.rows[2][3]);

  mrw_gles3_crowd_on_context_lost(&crowd);
  mrw_gles3_crowd_mesh_on_context_lost(&drawn);
  EXPECT(mrw_gles3_blend_crowd(&api, &crowd, &drawn, 0, kCrowd, 1.25, 0, mrw_gles3_blending_program_of(&programs)),
         MRW_GL_ERROR);
  mrw_gles3_programs_on_context_lost(&programs);
  lose_context();
  TRY(mrw_gles3_crowd_mesh_on_context_restored(&api, &caps, &drawn));
  TRY(mrw_gles3_crowd_on_context_restored(&api, &caps, &crowd));
  NEEDS(draw_crowd(&crowd, &drawn) == hash);
  mrw_gles3_destroy_crowd(&api, &crowd);
  mrw_gles3_destroy_crowd_mesh(&api, &drawn);
  mrw_gles3_destroy_programs(&api, &programs);
}

static int tries = 0;

static void about_to_try(void* user, mrw_gles3_skinning_path path) {
  NEEDS(user == &tries && path < MRW_GLES3_PATH_COUNT);
  ++tries;
}

static void self_test(void) {
  mrw_gles3_self_test_options options;
  mrw_gles3_self_test test, restored;
  mrw_gles3_path_need need;
  mrw_gles3_skinning_path best;
  unsigned char saved[MRW_GLES3_SAVED_SELF_TEST_BYTES];
  size_t bytes;
  int i;
  mrw_gles3_self_test_options_init(&options);
  options.about_to_try = about_to_try;
  options.user = &tries;
  bytes = mrw_gles3_self_test_bytes(&options);
  EXPECT(mrw_gles3_run_self_test(&api, &caps, &options, block_of(bytes), bytes - 1, &test), MRW_BAD_ARGUMENT);
  TRY(mrw_gles3_run_self_test(&api, &caps, &options, block_of(bytes), bytes, &test));
  for (i = 0; i < (int)MRW_GLES3_PATH_COUNT; ++i)
    printf("%s: %s, %a\n", mrw_gles3_skinning_path_text((mrw_gles3_skinning_path)i),
           mrw_gles3_verdict_text(test.paths[i].verdict), (double)test.paths[i].position_error);
  mrw_gles3_path_need_init(&need);
  TRY(mrw_gles3_choose(&test, &need, &best));
  TRY(mrw_gles3_save(&test, saved, sizeof saved));
  EXPECT(mrw_gles3_save(&test, saved, sizeof saved - 1), MRW_BAD_ARGUMENT);
  TRY(mrw_gles3_restore(&api, &caps, &options, saved, sizeof saved, &restored));
  NEEDS(memcmp(&test.key, &restored.key, sizeof test.key) == 0);
  NEEDS(test.paths[best].verdict == restored.paths[best].verdict);
  EXPECT(mrw_gles3_restore(&api, &caps, &options, saved, 50, &restored), MRW_TRUNCATED);
  options.as = false;
  EXPECT(mrw_gles3_restore(&api, &caps, &options, saved, sizeof saved, &restored), MRW_MISMATCH);
  printf("%s of %d tried\n", mrw_gles3_skinning_path_text(best), tries);
}

static int reports = 0;

static void report(void* user, const char* call, uint32_t error) {
  NEEDS(user == &reports && strcmp(call, "glUniformBlockBinding") == 0 && error == GL_INVALID_VALUE);
  ++reports;
}

// A call that GL refuses is told by its name.
static void watched(void) {
  mrw_gles3_error_watch watch;
  mrw_gles3_skinner_options options;
  mrw_gles3_skinner skinner;
  size_t bytes;
  mrw_gles3_skinner_options_init(&options);
  bytes = mrw_gles3_skinner_bytes(&mesh, &options);
  open_programs();
  programs.palette_binding = 0xFFFF;
  mrw_gles3_error_watch_init(&watch);
  watch.report = report;
  watch.user = &reports;
  mrw_gles3_watch_errors(&api, &watch);
  TRY(mrw_gles3_create_skinner(&api, &caps, &mesh, &options, &programs, block_of(bytes), bytes, &skinner));
  mrw_gles3_watch_errors(&api, NULL);
  mrw_gles3_destroy_skinner(&api, &skinner);
  mrw_gles3_destroy_programs(&api, &programs);
  NEEDS(gl.GetError() == GL_NO_ERROR);
  printf("%d error told, %s\n", reports, mrw_gles3_context_was_reset(&api) ? "a reset" : "no reset");
}

static void on_call_error(const char* function, const char* condition) {
  NEEDS(function[0] != 0 && condition[0] != 0);
}

int main(int argc, char** argv) {
  NEEDS(mrw_abi() == MRW_ABI && mrw_gles3_abi() == MRW_GLES3_ABI);
  mrw_set_call_error_handler(on_call_error);
  load_scene(argc > 1 ? argv[1] : "newt.mrw");
  EXPECT(mrw_gles3_query_caps(&api, &caps), MRW_BAD_ARGUMENT);  // not loaded
  start();
  every_path();
  crowds();
  self_test();
  watched();
  close_context();
  return 0;
}
