// Plays Unity for marrow_unity: loads the library, hands it interfaces that are declared once more by hand, has a
// render thread with an OpenGL ES context of its own, loses it and makes another. Checks pixels against vertices that
// the CPU skins.
// usage: engine LIBMARROW_UNITY.so NEWT.mrw
#include <math.h>
#include <pthread.h>
#include <stdio.h>

#include <GLES3/gl3.h>

#include "../../c/surfaceless.h"
#include "unity_side.h"

enum { kSide = 192 };

// ---- the render thread ----

typedef void (*job)(void);
static void* run(void* of) {
  NEEDS(eglBindAPI(EGL_OPENGL_ES_API) && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context));
  (*(job*)of)();
  NEEDS(glGetError() == GL_NO_ERROR);
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  return NULL;
}
static void on_render_thread(job what) {
  pthread_t thread;
  NEEDS(pthread_create(&thread, NULL, run, &what) == 0);
  pthread_join(thread, NULL);
}

static void make_picture(void) {
  GLuint made[3];
  glGenTextures(2, made);
  glGenFramebuffers(1, &made[2]);
  glBindTexture(GL_TEXTURE_2D, made[0]);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, kSide, kSide);
  glBindTexture(GL_TEXTURE_2D, made[1]);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT24, kSide, kSide);
  glBindFramebuffer(GL_FRAMEBUFFER, made[2]);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, made[0], 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, made[1], 0);
  NEEDS(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

static void open_device(void) {
  open_context();
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  renderer = kOpenGLES30;
  device_event(kInitialize);
  on_render_thread(make_picture);
}

// The device goes first, then Unity tells of it: nothing of the old context may be called any more.
static void close_device(void) {
  close_context();
  device_event(kShutdown);
}

static int event_id = 0;
static unsigned char rgba[4 * kSide * kSide];
static void draw_event(void) {
  plugin.marrow_unity_render_event()(event_id);
}

// As an engine leaves it: all of it other than what the plugin draws with, and found again.
static void draw_picture(void) {
  GLuint buffers[3];
  GLint got[9];
  glGenBuffers(2, buffers);
  glGenVertexArrays(1, &buffers[2]);
  glViewport(0, 0, kSide, kSide);
  glDepthMask(GL_TRUE);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glBindVertexArray(buffers[2]);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBindBuffer(GL_UNIFORM_BUFFER, buffers[1]);
  glActiveTexture(GL_TEXTURE3);
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_GREATER);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  glFrontFace(GL_CW);
  draw_event();
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &got[0]);
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &got[1]);
  glGetIntegerv(GL_UNIFORM_BUFFER_BINDING, &got[2]);
  glGetIntegerv(GL_ACTIVE_TEXTURE, &got[3]);
  glGetIntegerv(GL_DEPTH_WRITEMASK, &got[4]);
  glGetIntegerv(GL_DEPTH_FUNC, &got[5]);
  glGetIntegerv(GL_CULL_FACE_MODE, &got[6]);
  glGetIntegerv(GL_FRONT_FACE, &got[7]);
  glGetIntegerv(GL_CURRENT_PROGRAM, &got[8]);
  NEEDS(got[0] == (GLint)buffers[2] && got[1] == (GLint)buffers[0] && got[2] == (GLint)buffers[1]);
  NEEDS(got[3] == GL_TEXTURE3 && got[4] == 0 && got[5] == GL_GREATER && got[6] == GL_FRONT && got[7] == GL_CW);
  NEEDS(got[8] == 0 && !glIsEnabled(GL_DEPTH_TEST) && glIsEnabled(GL_BLEND) && !glIsEnabled(GL_CULL_FACE));
  glBindVertexArray(0);
  glDeleteVertexArrays(1, &buffers[2]);
  glDeleteBuffers(2, buffers);
  glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
}

// ---- the character ----

static void* block_of(size_t bytes) {
  static void* taken[32];  // reachable to the end
  static int count = 0;
  mrw_block block = {NULL, 0};
  NEEDS(count < 32);
  taken[count] = malloc(mrw_block_bytes(bytes));
  TRY(mrw_block_in(taken[count++], mrw_block_bytes(bytes), &block));
  return block.data;
}

static mrw_character character, skinned;  // for the plugin, and by the CPU
static float* positions;
static size_t slots;

// Weights of morph targets become so many times as large, and the CPU skins.
static void grow_weights(float by) {
  mrw_skin_output out;
  size_t i;
  for (i = 0; i < character.meshes[0].weight_count; ++i)
    skinned.meshes[0].weights[i] = character.meshes[0].weights[i] *= by;
  TRY(mrw_finish_character(&skinned));
  mrw_skin_output_init(&out);
  out.positions = positions;
  out.position_count = 3 * slots;
  TRY(mrw_skin_ssd(&skinned.meshes[0].mesh, skinned.meshes[0].palette, skinned.meshes[0].palette_count, &out));
}

static void load_character(const char* name) {
  FILE* const stream = fopen(name, "rb");
  mrw_file file;
  mrw_animations animations;
  mrw_character_options options;
  mrw_animation_layer layer;
  size_t size;
  void* bytes;
  NEEDS(stream != NULL && fseek(stream, 0, SEEK_END) == 0);
  size = (size_t)ftell(stream);
  bytes = block_of(size);
  rewind(stream);
  NEEDS(fread(bytes, 1, size, stream) == size);
  fclose(stream);
  TRY(mrw_load(bytes, size, &file, NULL));
  size = mrw_animations_bytes(&file, &file);
  TRY(mrw_make_animations(&file, &file, block_of(size), size, &animations));
  mrw_character_options_init(&options);
  size = mrw_character_bytes(&file, &options);
  TRY(mrw_make_character(&file, &options, block_of(size), size, &skinned));
  options.skin = false;
  size = mrw_character_bytes(&file, &options);
  TRY(mrw_make_character(&file, &options, block_of(size), size, &character));
  mrw_animation_layer_init(&layer);
  layer.animation = mrw_find_animation(&animations, "walk");
  layer.time_s = 0.4f;
  NEEDS(layer.animation != NULL);
  TRY(mrw_pose_character(&character, &layer, 1));
  TRY(mrw_pose_character(&skinned, &layer, 1));
  slots = character.meshes[0].mesh.geometry.slot_count;
  positions = block_of(12 * slots);
  grow_weights(30);
}

static mrw_status pose(int32_t handle) {
  const mrw_pose* const at = &character.skeletons[0].pose;
  return plugin.marrow_unity_pose(handle, at->model_from_joint, at->model_from_joint_count, character.meshes[0].weights,
                                  character.meshes[0].weight_count);
}

// From a camera at z = 4 that looks back: x' = x · side, all of the newt in sight. Columns.
static void camera(float* m, float side, int perspective) {
  const float near = 1, far = 8, zoom = perspective ? 3.2f : 0.8f;
  memset(m, 0, 16 * sizeof *m);
  m[0] = zoom * side;
  m[5] = zoom;
  m[13] = -0.7f * zoom;
  if (perspective) {  // eye z = z - 4
    m[10] = -(far + near) / (far - near);
    m[14] = 4 * (far + near) / (far - near) - 2 * far * near / (far - near);
    m[11] = -1;
    m[15] = 4;
  } else {
    m[10] = -0.25f;
    m[15] = 1;
  }
}

typedef struct box {
  int left, right, bottom, top, count;
} box;

static box drawn_box(void) {
  box out = {kSide, -1, kSide, -1, 0};
  int x, y;
  for (y = 0; y < kSide; ++y)
    for (x = 0; x < kSide; ++x) {
      if (rgba[4 * (y * kSide + x) + 3] == 0) continue;
      if (x < out.left) out.left = x;
      if (x > out.right) out.right = x;
      if (y < out.bottom) out.bottom = y;
      if (y > out.top) out.top = y;
      ++out.count;
    }
  return out;
}

// Where vertices that the CPU skinned are on the picture.
static box expected_box(const float* m) {
  float least[2] = {1e9f, 1e9f}, most[2] = {-1e9f, -1e9f};
  box out;
  size_t i;
  int k;
  for (i = 0; i < slots; ++i) {
    const float* const p = &positions[3 * i];
    const float w = m[3] * p[0] + m[7] * p[1] + m[11] * p[2] + m[15];
    for (k = 0; k < 2; ++k) {
      const float at = (0.5f + 0.5f * (m[k] * p[0] + m[4 + k] * p[1] + m[8 + k] * p[2] + m[12 + k]) / w) * kSide;
      least[k] = fminf(least[k], at);
      most[k] = fmaxf(most[k], at);
    }
  }
  out.left = (int)least[0];
  out.right = (int)most[0];
  out.bottom = (int)least[1];
  out.top = (int)most[1];
  out.count = 0;
  return out;
}

static box draw(int32_t handle, const float* m) {
  event_id = plugin.marrow_unity_request(handle, m);
  NEEDS(event_id > 0);
  on_render_thread(draw_picture);
  TRY(plugin.marrow_unity_status(handle));
  return drawn_box();
}

static void expect_box(box got, box wanted) {
  fprintf(stderr, "drawn %d pixels, x %d to %d, y %d to %d; vertices x %d to %d, y %d to %d\n", got.count, got.left,
          got.right, got.bottom, got.top, wanted.left, wanted.right, wanted.bottom, wanted.top);
  NEEDS(got.count > kSide * kSide / 20);
  NEEDS(abs(got.left - wanted.left) <= 1 && abs(got.right - wanted.right) <= 1);
  NEEDS(abs(got.bottom - wanted.bottom) <= 1 && abs(got.top - wanted.top) <= 1);
}

// Pixels that differ between two pictures by more than rounding; mirrored: the other one's x runs backwards.
static int different(const unsigned char* a, const unsigned char* b, int mirrored) {
  int x, y, k, count = 0;
  for (y = 0; y < kSide; ++y)
    for (x = 0; x < kSide; ++x) {
      int most = 0;
      for (k = 0; k < 4; ++k) {
        const int d = abs(a[4 * (y * kSide + x) + k] - b[4 * (y * kSide + (mirrored ? kSide - 1 - x : x)) + k]);
        most = d > most ? d : most;
      }
      count += most > 16;
    }
  return count;
}

static void draw_from_all_sides(int32_t handle) {
  static unsigned char first[sizeof rgba];
  float m[16];
  mrw_mesh both = character.meshes[0].mesh;
  int perspective;
  int32_t other;
  both.double_sided = true;
  other = plugin.marrow_unity_open(&both);
  NEEDS(other > 0);
  TRY(pose(other));
  for (perspective = 0; perspective < 2; ++perspective) {
    camera(m, 1, perspective);
    expect_box(draw(handle, m), expected_box(m));
    memcpy(first, rgba, sizeof rgba);
    // A closed surface looks the same with its back sides: so what is left out are those.
    draw(other, m);
    NEEDS(different(rgba, first, 0) < kSide * kSide / 500);
    // Unity's mirrored scene.
    camera(m, -1, perspective);
    expect_box(draw(handle, m), expected_box(m));
    NEEDS(different(rgba, first, 1) < kSide * kSide / 100);
    NEEDS(different(rgba, first, 0) > kSide * kSide / 100);
  }
  plugin.marrow_unity_close(other);
}

static void refuse_nonsense(int32_t handle) {
  float m[16];
  mrw_mesh none;
  int32_t handles[256];
  int i;
  memset(&none, 0, sizeof none);
  camera(m, 1, 0);
  NEEDS(plugin.marrow_unity_open(NULL) == 0 && plugin.marrow_unity_open(&none) == 0);
  NEEDS(pose(0) == MRW_BAD_ARGUMENT && pose(257) == MRW_BAD_ARGUMENT && pose(-1) == MRW_BAD_ARGUMENT);
  NEEDS(plugin.marrow_unity_pose(handle, NULL, 0, NULL, 0) == MRW_BAD_ARGUMENT);
  NEEDS(plugin.marrow_unity_pose(handle, character.skeletons[0].pose.model_from_joint, 3, NULL, 0) == MRW_BAD_ARGUMENT);
  NEEDS(plugin.marrow_unity_request(0, m) == 0 && plugin.marrow_unity_request(handle, NULL) == 0);
  plugin.marrow_unity_close(0);
  for (i = 0; i < 256; ++i) handles[i] = plugin.marrow_unity_open(&character.meshes[0].mesh);
  NEEDS(handles[0] > 0 && handles[255] == 0);  // one is open already
  for (i = 0; i < 256; ++i) plugin.marrow_unity_close(handles[i]);
  for (i = 0; i < 5000; ++i) {
    event_id = plugin.marrow_unity_request(handle, m);
    NEEDS(event_id > 0 && event_id < 1024);
  }
  event_id = 1 << 30;
  on_render_thread(draw_event);
  NEEDS(plugin.marrow_unity_open(&character.meshes[0].mesh) > 0);  // those of before are gone by the event
}

// The render thread draws while the main thread poses, asks, opens and closes.
static int32_t crowded = 0, crowd_ends = 0, crowd_events = 0;
static void* draw_many(void* unused) {
  NEEDS(eglBindAPI(EGL_OPENGL_ES_API) && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context));
  while (!__atomic_load_n(&crowd_ends, __ATOMIC_ACQUIRE))
    plugin.marrow_unity_render_event()(1 + __atomic_add_fetch(&crowd_events, 1, __ATOMIC_RELAXED) % 50);
  NEEDS(glGetError() == GL_NO_ERROR);
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  return unused;
}

static void crowd(int32_t handle, const float* m) {
  pthread_t thread;
  int i;
  NEEDS(pthread_create(&thread, NULL, draw_many, NULL) == 0);
  for (i = 0; i < 400 || __atomic_load_n(&crowd_events, __ATOMIC_RELAXED) < 100; ++i) {
    const int32_t other = plugin.marrow_unity_open(&character.meshes[i % 2].mesh);
    TRY(pose(handle));
    NEEDS(plugin.marrow_unity_request(handle, m) > 0);
    if (other == 0) continue;  // those that are closed stay until an event
    NEEDS(plugin.marrow_unity_request(other, m) > 0);
    plugin.marrow_unity_close(other);
    ++crowded;
  }
  __atomic_store_n(&crowd_ends, 1, __ATOMIC_RELEASE);
  pthread_join(thread, NULL);
  NEEDS(crowded > 0);
}

int main(int argc, char** argv) {
  static unsigned char before[sizeof rgba];
  float m[16];
  int32_t handle;
  NEEDS(argc == 3);
  load_plugin(argv[1]);
  load_character(argv[2]);
  NEEDS(plugin.marrow_unity_abi() == MRW_GLES3_ABI);
  NEEDS(says("Load on startup"));
  renderer = kVulkan;
  plugin.UnityPluginLoad(&interfaces);
  NEEDS(device_event != NULL && says("Vulkan"));
  plugin.marrow_unity_render_event()(1);  // without a context: does nothing
  device_event(kShutdown);
  NEEDS(says("no graphics device"));
  renderer = kMetal;
  device_event(kInitialize);
  NEEDS(says("skin to a Mesh"));
  device_event(kShutdown);

  handle = plugin.marrow_unity_open(&character.meshes[0].mesh);
  NEEDS(handle > 0 && plugin.marrow_unity_status(handle) == MRW_GL_ERROR);
  open_device();
  NEEDS(says(""));
  camera(m, 1, 1);
  event_id = plugin.marrow_unity_request(handle, m);
  on_render_thread(draw_picture);  // not posed yet: draws nothing
  NEEDS(drawn_box().count == 0);
  TRY(pose(handle));
  draw_from_all_sides(handle);
  camera(m, 1, 1);
  draw(handle, m);
  memcpy(before, rgba, sizeof rgba);

  // The context goes; an event that was under way comes too late; another context comes, and the pose is still there.
  close_device();
  NEEDS(says("no graphics device"));
  plugin.marrow_unity_render_event()(event_id);
  NEEDS(plugin.marrow_unity_status(handle) == MRW_GL_ERROR);
  open_device();
  crowd(handle, m);
  draw(handle, m);
  NEEDS(memcmp(before, rgba, sizeof rgba) == 0);
  grow_weights(10);  // beyond the shape: a mesh with morph targets reaches further
  TRY(pose(handle));
  expect_box(draw(handle, m), expected_box(m));
  NEEDS(character.meshes[0].weight_count == 0 || memcmp(before, rgba, sizeof rgba) != 0);
  refuse_nonsense(handle);
  plugin.marrow_unity_close(handle);
  NEEDS(plugin.marrow_unity_request(handle, m) == 0);
  event_id = 0;
  on_render_thread(draw_event);
  close_device();
  plugin.UnityPluginUnload();
  NEEDS(device_event == NULL && says("Load on startup"));
  printf("render event: drawn as the CPU skins, mirrored, and the same in a second context\n");
  return 0;
}
