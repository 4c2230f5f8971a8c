/* See draw.h. */
#include "draw.h"

#include <stdlib.h>
#include <string.h>

#if defined(_WIN32) || defined(__APPLE__)
#error "Unity has no OpenGL ES 3 here, so the package has no marrow_unity either: leave it out"
#endif
#include "gl.h"
#include "look.h"

enum { TEXTURE_UNIT = 12, PALETTE_BINDING = 20 };

static mrw_gles3_api api;
static mrw_gles3_caps caps;
static mrw_gles3_program_set programs;
static bool has_context = false, has_programs = false;
static char log_text[1024];

const char* compile_log(void) {
  return log_text;
}

static void options_of(mrw_gles3_skinner_options* out) {
  mrw_gles3_skinner_options_init(out); /* in the vertex shader, palettes in a uniform block */
  out->texture_unit = TEXTURE_UNIT;
}

bool open_drawn(drawn_mesh* out, const mrw_mesh* mesh) {
  mrw_gles3_skinner_options options;
  size_t bytes;
  memset(out, 0, sizeof *out);
  options_of(&options);
  out->mesh = *mesh;
  bytes = mrw_gles3_skinner_bytes(mesh, &options);
  if (bytes == 0) return false;
  out->memory = malloc(mrw_block_bytes(bytes));
  return out->memory != NULL && mrw_block_in(out->memory, mrw_block_bytes(bytes), &out->block) == MRW_OK;
}

void free_drawn(drawn_mesh* drawn) {
  free(drawn->memory);
  drawn->memory = NULL;
}

static mrw_status begin_context(void) {
  mrw_status status;
  if (has_context) return MRW_OK;
  if (!load_gl()) return MRW_UNSUPPORTED;
  status = mrw_gles3_load_api(&api, load_proc, NULL);
  if (status == MRW_OK) status = mrw_gles3_query_caps(&api, &caps);
  if (status == MRW_OK && has_programs) status = mrw_gles3_programs_on_context_restored(&api, &caps, &programs);
  if (status != MRW_OK) return status;
  if (!has_programs) {
    mrw_gles3_program_set_init(&programs);
    programs.roles[0].vertex = kVertexText;
    programs.roles[0].fragment = kFragmentText;
    programs.role_features[0] = MRW_GLES3_NORMALS | MRW_GLES3_MORPHS;
    programs.palette_binding = PALETTE_BINDING;
    programs.log = log_text;
    programs.log_bytes = sizeof log_text;
  }
  has_context = has_programs = true;
  return MRW_OK;
}

mrw_status begin_drawn(drawn_mesh* drawn) {
  mrw_gles3_skinner_options options;
  gl_state state;
  mrw_status status = begin_context();
  if (status != MRW_OK || (drawn->made && !drawn->skinner.lost)) return status;
  state = save_state();
  options_of(&options);
  status = drawn->made ? mrw_gles3_skinner_on_context_restored(&api, &caps, &drawn->skinner)
                       : mrw_gles3_create_skinner(&api, &caps, &drawn->mesh, &options, &programs, drawn->block.data,
                                                  drawn->block.size, &drawn->skinner);
  drawn->made = drawn->made || status == MRW_OK;
  restore_state(&state);
  return status;
}

mrw_status pose_drawn(drawn_mesh* drawn, const mrw_affine* joints, size_t joint_count, const float* weights,
                      size_t weight_count) {
  return mrw_gles3_pose(&drawn->skinner, 0, joints, joint_count, weights, weight_count);
}

/* The determinant of a matrix of three columns. */
static float volume(const float* a, const float* b, const float* c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* Whether counter-clockwise triangles are seen clockwise. Rows x, y, w of a projection say on which side of a plane
 * the eye is; without perspective w is 1 there, and the third column of x, y, z decides. */
static bool turns_round(const float* m) {
  const float x[3] = {m[0], m[4], m[8]}, y[3] = {m[1], m[5], m[9]}, w[3] = {m[3], m[7], m[11]};
  const float z[3] = {m[2], m[6], m[10]};
  const float seen = volume(x, y, w);
  return seen != 0 ? seen > 0 : volume(x, y, z) > 0;
}

mrw_status draw(drawn_mesh* drawn, const float* clip_from_model) {
  const gl_state state = save_state();
  const mrw_gles3_program* program;
  mrw_status status = mrw_gles3_update(&api, &drawn->skinner, &programs, 1);
  if (status == MRW_OK) {
    program = mrw_gles3_program_of(&drawn->skinner, &programs, 0);
    gl.UseProgram(program->id);
    gl.UniformMatrix4fv(gl.GetUniformLocation(program->id, "clip_from_model"), 1, 0, clip_from_model);
    gl.Uniform4fv(gl.GetUniformLocation(program->id, "base_colour"), 1, drawn->mesh.base_colour);
    gl.Enable(GL_DEPTH_TEST_);
    gl.DepthFunc(GL_LEQUAL_);
    gl.DepthMask(1);
    gl.Disable(GL_BLEND_);
    set_enabled(GL_CULL_FACE_, !drawn->mesh.double_sided);
    gl.CullFace(GL_BACK_);
    gl.FrontFace(turns_round(clip_from_model) ? GL_CW_ : GL_CCW_);
    status = mrw_gles3_draw(&api, &drawn->skinner, &programs, program, 0, 1);
  }
  restore_state(&state);
  return status;
}

void delete_drawn(drawn_mesh* drawn) {
  if (drawn->made && has_context) mrw_gles3_destroy_skinner(&api, &drawn->skinner);
  drawn->made = false;
}

void forget_context(void) {
  if (has_programs) mrw_gles3_programs_on_context_lost(&programs);
  has_context = false;
}

void forget_drawn_context(drawn_mesh* drawn) {
  if (drawn->made) mrw_gles3_skinner_on_context_lost(&drawn->skinner);
}
