/* Draws an animation with OpenGL ES, in C99. Of a file that is not packed. */
#include <marrow/c_gles3.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 128, MOST_MESHES = 16 };

static const char vertex[] =
    "out vec3 normal;\n"
    "void main() {\n"
    "  MarrowVertex v = marrow_skin();\n"
    "  normal = v.normal;\n"
    "  gl_Position = vec4(v.position.xy - vec2(0.0, 0.7), 0.5 * v.position.z, 1.0);\n"
    "}\n";
static const char fragment[] =
    "precision highp float;\n"
    "in vec3 normal;\n"
    "out vec4 colour;\n"
    "void main() { colour = vec4(0.5 + 0.5 * normalize(normal), 1.0); }\n";

/* All memory, which goes back as the program ends. */
static void* taken[64];
static int taken_count = 0;

static void give_back(void) {
  while (taken_count > 0) free(taken[--taken_count]);
}

/* Memory that the runtime works in begins on a boundary of 16 bytes. */
static void* block_of(size_t bytes) {
  void* const memory = malloc(mrw_block_bytes(bytes));
  mrw_block block = {NULL, 0};
  if (memory == NULL || taken_count == 64) exit(1);
  if (taken_count == 0) atexit(give_back);
  taken[taken_count++] = memory;
  if (mrw_block_in(memory, mrw_block_bytes(bytes), &block) != MRW_OK) exit(1);
  return block.data;
}

static void must(mrw_status status) {
  if (status == MRW_OK) return;
  fprintf(stderr, "%s\n", mrw_status_text(status));
  exit(1);
}

/* C turns no function into a pointer to data, so the bytes are copied. */
static void* load_proc(const char* name) {
  const __eglMustCastToProperFunctionPointerType function = eglGetProcAddress(name);
  void* out = NULL;
  memcpy(&out, &function, sizeof out);
  return out;
}

/* Where a game has a window, here is a texture. */
static void open_window(void) {
  const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 3, EGL_NONE};
  const PFNEGLGETPLATFORMDISPLAYEXTPROC get =
      (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
  const EGLDisplay display = get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  GLuint texture = 0, framebuffer = 0;
  if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_ES_API)) exit(1);
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE,
                      eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version)))
    exit(1);
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, SIDE, SIDE);
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  glViewport(0, 0, SIDE, SIDE);
}

static mrw_file read_file(const char* name) {
  FILE* const file = fopen(name, "rb");
  mrw_file out;
  void* block;
  size_t size;
  if (file == NULL || fseek(file, 0, SEEK_END) != 0) {
    perror(name);
    exit(1);
  }
  size = (size_t)ftell(file);
  block = block_of(size);
  rewind(file);
  if (fread(block, 1, size, file) != size) exit(1);
  fclose(file);
  must(mrw_load(block, size, &out, NULL));
  return out;
}

int main(int argc, char** argv) {
  static mrw_gles3_program_set programs; /* 11 kB */
  static mrw_gles3_skinner skinners[MOST_MESHES];
  static unsigned char rgba[4 * SIDE * SIDE];
  const mrw_file file = read_file(argc > 1 ? argv[1] : "newt.mrw");
  mrw_gles3_api api;
  mrw_gles3_caps caps;
  mrw_gles3_skinner_options options;
  mrw_character_options posed;
  mrw_character character;
  mrw_animations animations;
  mrw_animation_layer layer;
  size_t bytes, i, frame, drawn = 0;

  if (mrw_abi() != MRW_ABI || mrw_gles3_abi() != MRW_GLES3_ABI) return 1; /* another release */
  bytes = mrw_animations_bytes(&file, &file);
  must(mrw_make_animations(&file, &file, block_of(bytes), bytes, &animations));
  mrw_character_options_init(&posed);
  posed.skin = false; /* the GPU does */
  bytes = mrw_character_bytes(&file, &posed);
  must(mrw_make_character(&file, &posed, block_of(bytes), bytes, &character));
  if (character.mesh_count > MOST_MESHES) return 1;

  open_window();
  must(mrw_gles3_load_api(&api, load_proc, NULL));
  must(mrw_gles3_query_caps(&api, &caps));
  mrw_gles3_program_set_init(&programs);
  programs.roles[0].vertex = vertex;
  programs.roles[0].fragment = fragment;
  mrw_gles3_skinner_options_init(&options); /* path ubo, deformer ssd, one character */
  for (i = 0; i < character.mesh_count; ++i) {
    bytes = mrw_gles3_skinner_bytes(&character.meshes[i].mesh, &options);
    must(mrw_gles3_create_skinner(&api, &caps, &character.meshes[i].mesh, &options, &programs, block_of(bytes), bytes,
                                  &skinners[i]));
  }

  mrw_animation_layer_init(&layer);
  layer.animation = mrw_find_animation(&animations, "walk");
  for (frame = 0; frame < 30; ++frame) {
    layer.time_s = (float)frame / 60;
    must(mrw_pose_character(&character, &layer, 1));
    glClear(GL_COLOR_BUFFER_BIT);
    for (i = 0; i < character.mesh_count; ++i) {
      const mrw_character_mesh* const m = &character.meshes[i];
      const mrw_pose* const pose = &character.skeletons[m->mesh.skeleton].pose;
      const mrw_gles3_program* program;
      must(mrw_gles3_pose(&skinners[i], 0, pose->model_from_joint, pose->model_from_joint_count, m->weights,
                          m->weight_count));
      must(mrw_gles3_update(&api, &skinners[i], &programs, 1));
      program = mrw_gles3_program_of(&skinners[i], &programs, 0);
      glUseProgram(program->id); /* and the game's own uniforms */
      must(mrw_gles3_draw(&api, &skinners[i], &programs, program, 0, 1));
    }
  }
  glReadPixels(0, 0, SIDE, SIDE, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  for (i = 3; i < sizeof rgba; i += 4) drawn += rgba[i] != 0;
  printf("%u meshes, %u pixels\n", (unsigned)character.mesh_count, (unsigned)drawn);
  for (i = 0; i < character.mesh_count; ++i) mrw_gles3_destroy_skinner(&api, &skinners[i]);
  mrw_gles3_destroy_programs(&api, &programs);
  return 0;
}
