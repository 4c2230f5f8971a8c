// Unity's side of a native plugin, declared by hand from Unity's documentation, and marrow_unity as Unity loads it.
#pragma once

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../../platform/unity/native/marrow_unity.h"

#define NEEDS(condition)                                                                                       \
  do {                                                                                                         \
    if (!(condition)) exit((fprintf(stderr, "engine: line %d: %s does not hold\n", __LINE__, #condition), 1)); \
  } while (0)
#define TRY(call) NEEDS((call) == MRW_OK)

typedef struct Guid {
  unsigned long long high, low;
} Guid;
struct Interfaces {
  void* (*GetInterface)(Guid);
  void (*RegisterInterface)(Guid, void*);
  void* (*GetInterfaceSplit)(unsigned long long, unsigned long long);
  void (*RegisterInterfaceSplit)(unsigned long long, unsigned long long, void*);
};
struct Graphics {
  int (*GetRenderer)(void);
  void (*RegisterDeviceEventCallback)(void (*)(int));
  void (*UnregisterDeviceEventCallback)(void (*)(int));
  int (*ReserveEventIDRange)(int);
};
enum { kInitialize = 0, kShutdown = 1, kNull = 4, kOpenGLES30 = 11, kMetal = 16, kVulkan = 21 };

static int renderer = kNull;
static void (*device_event)(int) = NULL;
static int get_renderer(void) {
  return renderer;
}
static void add_callback(void (*callback)(int)) {
  device_event = callback;
}
static void remove_callback(void (*callback)(int)) {
  NEEDS(callback == device_event);
  device_event = NULL;
}
static int reserve_ids(int count) {
  return count;
}
static struct Graphics graphics = {get_renderer, add_callback, remove_callback, reserve_ids};
static void* find_split(unsigned long long high, unsigned long long low) {
  return high == 0x7CBA0A9CA4DDB544ull && low == 0x8C5AD4926EB17B11ull ? (void*)&graphics : NULL;
}
static void* find(Guid guid) {
  return find_split(guid.high, guid.low);
}
static void add_interface(Guid guid, void* made) {
  (void)guid, (void)made;
}
static void add_interface_split(unsigned long long high, unsigned long long low, void* made) {
  (void)high, (void)low, (void)made;
}
static struct Interfaces interfaces = {find, add_interface, find_split, add_interface_split};

// ---- the plugin ----

#define PLUGIN(X)                                                                              \
  X(void, UnityPluginLoad, (struct Interfaces*))                                               \
  X(void, UnityPluginUnload, (void))                                                           \
  X(uint32_t, marrow_unity_abi, (void))                                                        \
  X(const char*, marrow_unity_unavailable, (void))                                             \
  X(unity_render_event, marrow_unity_render_event, (void))                                     \
  X(int32_t, marrow_unity_open, (const mrw_mesh*))                                             \
  X(mrw_status, marrow_unity_pose, (int32_t, const mrw_affine*, size_t, const float*, size_t)) \
  X(int32_t, marrow_unity_request, (int32_t, const float*))                                    \
  X(mrw_status, marrow_unity_status, (int32_t))                                                \
  X(const char*, marrow_unity_log, (void))                                                     \
  X(void, marrow_unity_close, (int32_t))
static struct {
#define MEMBER(Result, Name, Parameters) Result(*Name) Parameters;
  PLUGIN(MEMBER)
#undef MEMBER
} plugin;

static void load_plugin(const char* name) {
  void* const library = dlopen(name, RTLD_NOW);
  void* function;
  if (library == NULL) exit((fprintf(stderr, "engine: %s\n", dlerror()), 1));
#define LOAD(Result, Name, Parameters) \
  function = dlsym(library, #Name);    \
  NEEDS(function != NULL);             \
  memcpy(&plugin.Name, &function, sizeof function);
  PLUGIN(LOAD)
#undef LOAD
}

static int says(const char* what) {
  const char* const why = plugin.marrow_unity_unavailable();
  if (strstr(why, what) != NULL && (why[0] == 0) == (what[0] == 0)) return 1;
  fprintf(stderr, "engine: it says \"%s\"\n", why);
  return 0;
}
