/* What of Unity's native plugin interface is used here, declared by hand: that of Unity 5.2 and later. */
#ifndef MARROW_UNITY_UNITY_H
#define MARROW_UNITY_UNITY_H

#include <stdint.h>

#if defined(_WIN32)
#define UNITY_API __stdcall
#define UNITY_EXPORT __declspec(dllexport)
#else
#define UNITY_API
#define UNITY_EXPORT __attribute__((visibility("default")))
#endif

/* Of UnityGfxRenderer, those that are named in messages. */
enum {
  UNITY_D3D11 = 2,
  UNITY_NO_DEVICE = 4,
  UNITY_GLES3 = 11,
  UNITY_METAL = 16,
  UNITY_GL_CORE = 17,
  UNITY_D3D12 = 18,
  UNITY_VULKAN = 21
};

/* UnityGfxDeviceEventType */
enum { UNITY_INITIALIZE = 0, UNITY_SHUTDOWN = 1, UNITY_BEFORE_RESET = 2, UNITY_AFTER_RESET = 3 };

/* IUnityGraphics is asked for by this name. */
#define UNITY_GRAPHICS_HIGH 0x7CBA0A9CA4DDB544ull
#define UNITY_GRAPHICS_LOW 0x8C5AD4926EB17B11ull

typedef void(UNITY_API* unity_device_event)(int type);
typedef void(UNITY_API* unity_render_event)(int id);

typedef struct unity_guid {
  uint64_t high, low;
} unity_guid;

typedef struct unity_interfaces {
  void*(UNITY_API* get_interface)(unity_guid guid);
  void(UNITY_API* register_interface)(unity_guid guid, void* made);
  void*(UNITY_API* get_interface_split)(uint64_t high, uint64_t low);
  void(UNITY_API* register_interface_split)(uint64_t high, uint64_t low, void* made);
} unity_interfaces;

typedef struct unity_graphics {
  int(UNITY_API* get_renderer)(void);
  void(UNITY_API* register_device_event)(unity_device_event callback);
  void(UNITY_API* unregister_device_event)(unity_device_event callback);
  int(UNITY_API* reserve_event_ids)(int count);
} unity_graphics;

#endif
