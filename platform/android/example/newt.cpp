// A game for Android without Java: what the system calls, all on one thread. See docs/platforms/android.md.
#include <android/input.h>
#include <android/native_activity.h>
#include <sys/timerfd.h>
#include <time.h>
#include <unistd.h>

#include <new>

#include "scene.h"
#include "window.h"

namespace {

constexpr long kSoon = 1;                // nanoseconds: after what the system has to say
constexpr long kTryAgain = 250'000'000;  // a quarter of a second, after a context could not be had
constexpr int kMostTries = 20;
constexpr float kLongestStep_s = 0.1f;  // a pause does not make the character jump

// What stays of an app that is killed in the background. Any bytes may come back, so they are checked.
struct Saved {
  unsigned magic = 0;
  double time_s = 0;
};
constexpr unsigned kSavedMagic = 0x4E575431;

double now_s() {
  timespec t = {};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct App {
  ANativeActivity* activity = nullptr;
  AInputQueue* input = nullptr;
  int timer = -1;
  bool is_resumed = false, has_scene = false;
  int context = 0;  // in which the scene is: the number of Window::contexts()
  int tries = 0;    // in a row that showed nothing
  double last_s = 0;
  Window window;
  Scene scene;

  void start(const void* saved, std::size_t saved_bytes);
  void stop();
  void schedule(long nanoseconds);
  void frame();
  bool bring_up();
  void try_again();
  void give_up();
};

App& app_of(ANativeActivity* activity) {
  return *static_cast<App*>(activity->instance);
}

int on_timer(int file, int, void* data) {
  unsigned long long expirations = 0;
  if (read(file, &expirations, sizeof expirations) > 0) static_cast<App*>(data)->frame();
  return 1;  // go on
}

// Events are given back unread: an app that keeps them is closed as one that does not answer.
int on_input(int, int, void* data) {
  App& app = *static_cast<App*>(data);
  AInputEvent* event = nullptr;
  while (app.input != nullptr && AInputQueue_getEvent(app.input, &event) >= 0)
    if (AInputQueue_preDispatchEvent(app.input, event) == 0) AInputQueue_finishEvent(app.input, event, 0);
  return 1;
}

void App::start(const void* saved, std::size_t saved_bytes) {
  timer = timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC);
  ALooper_addFd(ALooper_forThread(), timer, ALOOPER_POLL_CALLBACK, ALOOPER_EVENT_INPUT, on_timer, this);
  has_scene = scene.load(activity->assetManager);
  if (!has_scene) {
    ANativeActivity_finish(activity);
    return;
  }
  if (saved == nullptr || saved_bytes != sizeof(Saved)) return;
  Saved was;
  __builtin_memcpy(&was, saved, sizeof was);
  if (was.magic != kSavedMagic || !(was.time_s >= 0 && was.time_s < 1e6)) return;
  LOG_INFO("goes on at %d ms of the walk, where it was when the app was ended", static_cast<int>(1000 * was.time_s));
  scene.set_time_s(was.time_s);
}

void App::stop() {
  if (timer < 0) return;
  ALooper_removeFd(ALooper_forThread(), timer);
  close(timer);
}

void App::schedule(long nanoseconds) {
  itimerspec at = {};
  at.it_value.tv_nsec = nanoseconds;
  timerfd_settime(timer, 0, &at, nullptr);
}

// Not at once, and not for ever.
void App::try_again() {
  if (++tries >= kMostTries)
    give_up();
  else
    schedule(kTryAgain);
}

void App::give_up() {
  LOG_ERROR(
      "EGL: no context after %d tries in %d s (error 0x%04x): the graphics driver does not answer, so the app ends; "
      "start it again, and the phone if that does not help",
      kMostTries, kMostTries / 4, static_cast<unsigned>(window.error()));
  ANativeActivity_finish(activity);
}

// Window, context and all that is to be in it. false: not now, or never.
bool App::bring_up() {
  if (!window.make_current()) {
    try_again();
    return false;
  }
  if (context == window.contexts()) return true;
  if (context > 0) {
    LOG_WARN("the context was lost with all that was in it, and is made again");
    scene.lose();
  }
  context = window.contexts();
  if (scene.restore()) return true;
  ANativeActivity_finish(activity);
  return false;
}

void App::frame() {
  if (!is_resumed || !has_scene || !window.is_there() || !bring_up()) return;
  const double time_s = now_s();
  const float step = static_cast<float>(time_s - last_s);
  last_s = time_s;
  if (!scene.advance(step < 0 ? 0 : step > kLongestStep_s ? kLongestStep_s : step))
    return ANativeActivity_finish(activity);
  if (!scene.draw(window.width(), window.height())) {
    window.lose_context();
    return try_again();
  }
  if (!window.show()) return try_again();  // waits for the screen
  tries = 0;
  schedule(kSoon);
}

}  // namespace

// The one function that Android looks for.
extern "C" __attribute__((visibility("default"))) void ANativeActivity_onCreate(ANativeActivity* activity, void* saved,
                                                                                std::size_t saved_bytes) {
  void* const memory = std::malloc(sizeof(App));
  if (memory == nullptr) return ANativeActivity_finish(activity);
  App* const app = new (memory) App;
  app->activity = activity;
  activity->instance = app;
  ANativeActivityCallbacks& on = *activity->callbacks;
  on.onResume = [](ANativeActivity* a) {
    app_of(a).is_resumed = true;
    app_of(a).last_s = now_s();
    app_of(a).schedule(kSoon);
  };
  on.onPause = [](ANativeActivity* a) { app_of(a).is_resumed = false; };
  on.onNativeWindowCreated = [](ANativeActivity* a, ANativeWindow* window) {
    app_of(a).window.set(window);
    app_of(a).schedule(kSoon);
  };
  on.onNativeWindowDestroyed = [](ANativeActivity* a, ANativeWindow*) { app_of(a).window.set(nullptr); };
  on.onInputQueueCreated = [](ANativeActivity* a, AInputQueue* queue) {
    app_of(a).input = queue;
    AInputQueue_attachLooper(queue, ALooper_forThread(), ALOOPER_POLL_CALLBACK, on_input, &app_of(a));
  };
  on.onInputQueueDestroyed = [](ANativeActivity* a, AInputQueue* queue) {
    AInputQueue_detachLooper(queue);
    app_of(a).input = nullptr;
  };
  on.onSaveInstanceState = [](ANativeActivity* a, std::size_t* size) -> void* {
    void* const out = std::malloc(sizeof(Saved));  // the system frees it
    *size = out == nullptr ? 0 : sizeof(Saved);
    if (out != nullptr) new (out) Saved{kSavedMagic, app_of(a).scene.time_s()};
    return out;
  };
  on.onDestroy = [](ANativeActivity* a) {
    App& gone = app_of(a);
    gone.stop();
    gone.~App();
    std::free(&gone);
  };
  app->start(saved, saved_bytes);
}
