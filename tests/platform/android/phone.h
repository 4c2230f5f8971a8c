// A phone for one test: it plays Android's side of the interface that an app's library calls. The library is the one of
// the APK, for this machine's processor; this program's functions come before those of the libraries that it names.
#pragma once

#include <android/native_activity.h>

#include <string>
#include <vector>

namespace phone {

// Opens the APK that assets are read from. Ends the program if it is none.
void open_apk(const char* path);
// Calls what is waiting at the looper, for so long or until `frames` more were shown.
void pump(int frames, double seconds);

struct Screen {
  int frames = 0;          // shown
  int contexts = 0;        // made
  int alive_contexts = 0;  // made and not destroyed
  int alive_surfaces = 0;
  int lose_at_frame = -1;  // then eglSwapBuffers says that the context is lost
  bool makes_contexts = true;
  int width = 360, height = 640;
  std::vector<unsigned char> rgba;  // of the last frame, rows from below
};
extern Screen screen;

struct Activity {
  ANativeActivityCallbacks callbacks = {};
  ANativeActivity activity = {};
  bool is_finished = false;
};
void finish_of(ANativeActivity* activity);

// Of the input queue: how many events were handed out, and how many came back.
extern int events_given, events_finished;
AInputQueue* input_queue();

extern std::string log;  // all lines

}  // namespace phone
