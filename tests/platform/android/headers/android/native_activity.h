// Of Android's interface what the example calls, declared by hand for builds without an NDK: see cmake/android.cmake.
#pragma once
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
typedef struct AAssetManager AAssetManager;
typedef struct AInputQueue AInputQueue;
typedef struct ANativeWindow ANativeWindow;
typedef struct ARect ARect;
typedef struct ANativeActivity ANativeActivity;

typedef struct ANativeActivityCallbacks {
  void (*onStart)(ANativeActivity*);
  void (*onResume)(ANativeActivity*);
  void* (*onSaveInstanceState)(ANativeActivity*, size_t* size);
  void (*onPause)(ANativeActivity*);
  void (*onStop)(ANativeActivity*);
  void (*onDestroy)(ANativeActivity*);
  void (*onWindowFocusChanged)(ANativeActivity*, int has_focus);
  void (*onNativeWindowCreated)(ANativeActivity*, ANativeWindow*);
  void (*onNativeWindowResized)(ANativeActivity*, ANativeWindow*);
  void (*onNativeWindowRedrawNeeded)(ANativeActivity*, ANativeWindow*);
  void (*onNativeWindowDestroyed)(ANativeActivity*, ANativeWindow*);
  void (*onInputQueueCreated)(ANativeActivity*, AInputQueue*);
  void (*onInputQueueDestroyed)(ANativeActivity*, AInputQueue*);
  void (*onContentRectChanged)(ANativeActivity*, const ARect*);
  void (*onConfigurationChanged)(ANativeActivity*);
  void (*onLowMemory)(ANativeActivity*);
} ANativeActivityCallbacks;

struct ANativeActivity {
  ANativeActivityCallbacks* callbacks;
  void* vm;
  void* env;
  void* clazz;
  const char* internalDataPath;
  const char* externalDataPath;
  int32_t sdkVersion;
  void* instance;
  AAssetManager* assetManager;
  const char* obbPath;
};

void ANativeActivity_finish(ANativeActivity* activity);
int32_t ANativeWindow_setBuffersGeometry(ANativeWindow* window, int32_t width, int32_t height, int32_t format);
#ifdef __cplusplus
}
#endif
