/* The side of Unity: when there is a device, what is to be drawn by which event. draw.c draws. */
#include "marrow_unity.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "draw.h"

enum { MOST_OBJECTS = 256, MOST_REQUESTS = 1024 };

typedef struct object {
  bool open, closing;
  drawn_mesh drawn;
  /* What the main thread leaves for the render thread. */
  mrw_affine* joints;
  float* weights;
  uint32_t joint_count, weight_count;
  bool posed;
  mrw_status status;
} object;

typedef struct request {
  int32_t handle;
  float clip_from_model[16];
} request;

/* The render thread draws under `drawing`; `posing` guards what both threads write, for as long as a copy takes. */
static pthread_mutex_t drawing = PTHREAD_MUTEX_INITIALIZER;
static pthread_mutex_t posing = PTHREAD_MUTEX_INITIALIZER;
static object objects[MOST_OBJECTS];
static request requests[MOST_REQUESTS];
static int32_t next_request = 0;
static const unity_graphics* graphics = NULL;
static int renderer = UNITY_NO_DEVICE;

static object* object_of(int32_t handle) {
  object* const found = handle > 0 && handle <= MOST_OBJECTS ? &objects[handle - 1] : NULL;
  return found != NULL && found->open && !found->closing ? found : NULL;
}

static void forget(object* o) {
  free(o->joints);
  free(o->weights);
  free_drawn(&o->drawn);
  memset(o, 0, sizeof *o);
}

static void UNITY_API on_device_event(int type) {
  int i;
  if (type != UNITY_INITIALIZE && type != UNITY_SHUTDOWN) return; /* resets are Direct3D 9's */
  pthread_mutex_lock(&drawing);
  pthread_mutex_lock(&posing);
  renderer = type == UNITY_INITIALIZE && graphics != NULL ? graphics->get_renderer() : UNITY_NO_DEVICE;
  forget_context();
  for (i = 0; i < MOST_OBJECTS; ++i) {
    if (!objects[i].open) continue;
    forget_drawn_context(&objects[i].drawn);
    objects[i].status = MRW_GL_ERROR;
    if (objects[i].closing) forget(&objects[i]);
  }
  pthread_mutex_unlock(&posing);
  pthread_mutex_unlock(&drawing);
}

void UNITY_API UnityPluginLoad(const unity_interfaces* interfaces) {
  graphics = interfaces->get_interface_split(UNITY_GRAPHICS_HIGH, UNITY_GRAPHICS_LOW);
  if (graphics == NULL) return;
  graphics->register_device_event(on_device_event);
  on_device_event(UNITY_INITIALIZE); /* the device may have been there before the library */
}

void UNITY_API UnityPluginUnload(void) {
  int i;
  on_device_event(UNITY_SHUTDOWN);
  for (i = 0; i < MOST_OBJECTS; ++i) forget(&objects[i]);
  if (graphics != NULL) graphics->unregister_device_event(on_device_event);
  graphics = NULL;
}

uint32_t marrow_unity_abi(void) {
  return MRW_GLES3_ABI;
}

const char* marrow_unity_unavailable(void) {
  if (mrw_gles3_abi() != MRW_GLES3_ABI) return "marrow_unity and marrow_c are of two releases: take both from one";
  if (graphics == NULL)
    return "Unity has not loaded marrow_unity as a rendering plugin: tick Load on startup in the file's settings";
  if (renderer == UNITY_GLES3) return "";
  if (renderer == UNITY_NO_DEVICE) return "there is no graphics device at the moment";
  if (renderer == UNITY_VULKAN)
    return "the graphics device is Vulkan: put OpenGLES3 first in Player Settings, Graphics APIs";
  return "the graphics device is not OpenGL ES 3: skin to a Mesh there (MarrowPlayer does)";
}

static bool make_room(object* o, const mrw_mesh* mesh, uint32_t joint_count) {
  o->joint_count = joint_count;
  o->weight_count = (uint32_t)mesh->target_count;
  o->joints = malloc(joint_count * sizeof *o->joints);
  o->weights = malloc((o->weight_count + 1) * sizeof *o->weights);
  return o->joints != NULL && o->weights != NULL && open_drawn(&o->drawn, mesh);
}

/* The palette's joints are of the skeleton, which has at least as many as the largest of them says. */
static uint32_t joints_of(const mrw_mesh* mesh) {
  uint32_t i, most = 0;
  for (i = 0; i < mesh->joint_count; ++i)
    if (mesh->joints[i] >= most) most = mesh->joints[i] + 1u;
  return most;
}

int32_t marrow_unity_open(const mrw_mesh* mesh) {
  int32_t i;
  if (mesh == NULL || mesh->joints == NULL || mesh->geometry.slot_count == 0) return 0;
  pthread_mutex_lock(&posing);
  for (i = 0; i < MOST_OBJECTS && objects[i].open; ++i) {
  }
  if (i < MOST_OBJECTS) {
    objects[i].open = true;
    objects[i].status = MRW_GL_ERROR;
    if (!make_room(&objects[i], mesh, joints_of(mesh))) {
      forget(&objects[i]);
      i = MOST_OBJECTS;
    }
  }
  pthread_mutex_unlock(&posing);
  return i < MOST_OBJECTS ? i + 1 : 0;
}

mrw_status marrow_unity_pose(int32_t handle, const mrw_affine* model_from_joint, size_t joint_count,
                             const float* weights, size_t weight_count) {
  mrw_status status = MRW_BAD_ARGUMENT;
  object* o;
  pthread_mutex_lock(&posing);
  o = object_of(handle);
  if (o != NULL && model_from_joint != NULL && joint_count >= o->joint_count && weight_count >= o->weight_count &&
      (weights != NULL || o->weight_count == 0)) {
    memcpy(o->joints, model_from_joint, o->joint_count * sizeof *o->joints);
    if (o->weight_count > 0) memcpy(o->weights, weights, o->weight_count * sizeof *weights);
    o->posed = true;
    status = MRW_OK;
  }
  pthread_mutex_unlock(&posing);
  return status;
}

int32_t marrow_unity_request(int32_t handle, const float* clip_from_model) {
  int32_t id = 0;
  pthread_mutex_lock(&posing);
  if (object_of(handle) != NULL && clip_from_model != NULL) {
    next_request = next_request % (MOST_REQUESTS - 1) + 1;
    id = next_request;
    requests[id].handle = handle;
    memcpy(requests[id].clip_from_model, clip_from_model, sizeof requests[id].clip_from_model);
  }
  pthread_mutex_unlock(&posing);
  return id;
}

mrw_status marrow_unity_status(int32_t handle) {
  mrw_status status;
  pthread_mutex_lock(&posing);
  status = object_of(handle) != NULL ? object_of(handle)->status : MRW_BAD_ARGUMENT;
  pthread_mutex_unlock(&posing);
  return status;
}

const char* marrow_unity_log(void) {
  return compile_log();
}

void marrow_unity_close(int32_t handle) {
  pthread_mutex_lock(&drawing);
  pthread_mutex_lock(&posing);
  if (object_of(handle) != NULL) object_of(handle)->closing = true;
  pthread_mutex_unlock(&posing);
  pthread_mutex_unlock(&drawing);
}

/* Deletes what was closed: only here a context is current. */
static void tidy_up(void) {
  int i;
  for (i = 0; i < MOST_OBJECTS; ++i) {
    if (!objects[i].closing) continue;
    delete_drawn(&objects[i].drawn);
    forget(&objects[i]);
  }
}

/* What the event is to draw, as long as `drawing` is held; null: nothing. */
static object* object_of_event(int id, float* clip_from_model) {
  object* o = NULL;
  pthread_mutex_lock(&posing);
  tidy_up();
  if (id > 0 && id < MOST_REQUESTS) o = object_of(requests[id].handle);
  if (o != NULL && !o->posed) o = NULL;
  if (o != NULL) memcpy(clip_from_model, requests[id].clip_from_model, sizeof requests[id].clip_from_model);
  pthread_mutex_unlock(&posing);
  return o;
}

static void UNITY_API on_render_event(int id) {
  float clip_from_model[16];
  mrw_status status;
  object* o;
  pthread_mutex_lock(&drawing);
  o = marrow_unity_unavailable()[0] == 0 ? object_of_event(id, clip_from_model) : NULL;
  if (o != NULL) {
    status = begin_drawn(&o->drawn);
    pthread_mutex_lock(&posing);
    if (status == MRW_OK) status = pose_drawn(&o->drawn, o->joints, o->joint_count, o->weights, o->weight_count);
    pthread_mutex_unlock(&posing);
    if (status == MRW_OK) status = draw(&o->drawn, clip_from_model);
    pthread_mutex_lock(&posing);
    o->status = status;
    pthread_mutex_unlock(&posing);
  }
  pthread_mutex_unlock(&drawing);
}

unity_render_event marrow_unity_render_event(void) {
  return on_render_event;
}
