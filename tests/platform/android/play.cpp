// Plays an app's life to the library of an APK, and says what came of it.
// usage: play LIBRARY APK STORY [PICTURE.ppm]
//   life      start, some frames, the background, back, some frames, the end
//   lost      the context is lost once
//   never     no context can be had
//   killed    ended in the background without a word, and begun anew with what it had saved; then with bytes of no one
//   open      start and a few frames: what the app makes of the APK's files
#include <dlfcn.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include "phone.h"

namespace {

using Create = void (*)(ANativeActivity*, void*, std::size_t);
Create create = nullptr;
ANativeWindow* const window = reinterpret_cast<ANativeWindow*>(&phone::screen);
int wrong = 0;

void expect(bool holds, const char* what) {
  if (holds) return;
  std::printf("WRONG: %s\n", what);
  ++wrong;
}

// How much of the picture is not background, as that is in its corner.
double covered() {
  const std::vector<unsigned char>& rgba = phone::screen.rgba;
  if (rgba.empty()) return 0;
  std::size_t out = 0;
  for (std::size_t i = 0; i < rgba.size(); i += 4) out += std::memcmp(&rgba[i], rgba.data(), 3) != 0;
  return 4 * static_cast<double>(out) / static_cast<double>(rgba.size());
}

void begin(phone::Activity& app, void* saved = nullptr, std::size_t bytes = 0) {
  app.activity.callbacks = &app.callbacks;
  app.activity.sdkVersion = 21;
  create(&app.activity, saved, bytes);
}
void show(phone::Activity& app) {
  if (app.callbacks.onStart != nullptr) app.callbacks.onStart(&app.activity);
  app.callbacks.onResume(&app.activity);
  app.callbacks.onNativeWindowCreated(&app.activity, window);
}
void hide(phone::Activity& app) {
  app.callbacks.onPause(&app.activity);
  app.callbacks.onNativeWindowDestroyed(&app.activity, window);
  if (app.callbacks.onStop != nullptr) app.callbacks.onStop(&app.activity);
}
void end(phone::Activity& app) {
  app.callbacks.onDestroy(&app.activity);
  expect(phone::screen.alive_contexts == 0, "no context stays behind");
  expect(phone::screen.alive_surfaces == 0, "no surface stays behind");
}

void live(phone::Activity& app) {
  begin(app);
  app.callbacks.onInputQueueCreated(&app.activity, phone::input_queue());
  show(app);
  phone::pump(20, 30);
  expect(phone::screen.frames == 20 && covered() > 0.02, "twenty frames with a character");
  expect(phone::events_given == 2 && phone::events_finished == 1, "events are given back, but those of input methods");
  hide(app);
  const int frames = phone::screen.frames;
  phone::pump(0, 0.2);
  expect(phone::screen.frames == frames && phone::screen.alive_surfaces == 0, "in the background nothing is drawn");
  phone::screen.width = 640, phone::screen.height = 360;  // the phone was turned
  show(app);
  phone::pump(10, 30);
  expect(phone::screen.frames == frames + 10 && covered() > 0.02, "ten frames more");
  expect(phone::screen.contexts == 1, "the context outlived the background");
  hide(app);
  app.callbacks.onInputQueueDestroyed(&app.activity, phone::input_queue());
  end(app);
}

void lose(phone::Activity& app) {
  begin(app);
  show(app);
  phone::pump(10, 30);
  const double before = covered();
  phone::screen.rgba.clear();
  phone::screen.lose_at_frame = 10;
  phone::pump(5, 30);
  expect(phone::screen.contexts == 2 && phone::screen.alive_contexts == 1,
         "a second context, and the first is destroyed");
  expect(std::fabs(covered() - before) < 0.1 * before, "the character is there again");
  hide(app);
  end(app);
}

void never(phone::Activity& app) {
  phone::screen.makes_contexts = false;
  begin(app);
  show(app);
  for (int i = 0; i < 100 && !app.is_finished; ++i) phone::pump(0, 0.1);
  expect(app.is_finished && phone::screen.frames == 0, "the app ends");
  hide(app);
  end(app);
}

void kill(phone::Activity& app) {
  begin(app);
  show(app);
  phone::pump(20, 30);
  std::size_t bytes = 0;
  void* const saved = app.callbacks.onSaveInstanceState(&app.activity, &bytes);
  hide(app);
  phone::log.clear();
  phone::Activity second;
  begin(second, saved, bytes);
  expect(phone::log.find("goes on at") != std::string::npos, "what was saved is taken up");
  second.callbacks.onDestroy(&second.activity);
  std::memset(saved, 0xFF, bytes);
  const std::string log = phone::log;
  phone::Activity third;
  begin(third, saved, bytes);
  third.callbacks.onDestroy(&third.activity);
  phone::Activity fourth;
  begin(fourth, saved, 3);
  expect(phone::log.find("goes on at", log.size()) == std::string::npos, "bytes of no one are not");
  show(fourth);
  phone::pump(3, 30);
  hide(fourth);
  fourth.callbacks.onDestroy(&fourth.activity);
  std::free(saved);
}

void open(phone::Activity& app) {
  begin(app);
  show(app);
  if (!app.is_finished) phone::pump(3, 10);
  hide(app);
  end(app);
}

void save(const char* path) {
  const int width = phone::screen.width, height = phone::screen.height;
  std::ofstream out(path, std::ios::binary);
  out << "P6\n" << width << ' ' << height << "\n255\n";
  for (int y = height - 1; y >= 0; --y)
    for (int x = 0; x < width; ++x)
      out.write(reinterpret_cast<const char*>(&phone::screen.rgba[static_cast<std::size_t>(4 * (y * width + x))]), 3);
}

}  // namespace

void phone::finish_of(ANativeActivity* activity) {
  // Its callbacks are the first member of what it is part of.
  reinterpret_cast<Activity*>(activity->callbacks)->is_finished = true;
}

int main(int argc, char** argv) {
  if (argc < 4) return 1;
  phone::open_apk(argv[2]);
  void* const library = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return std::printf("WRONG: %s\n", dlerror()), 1;
  create = reinterpret_cast<Create>(dlsym(library, "ANativeActivity_onCreate"));
  if (create == nullptr) return std::printf("WRONG: %s\n", dlerror()), 1;
  const std::string story = argv[3];
  phone::Activity app;
  if (story == "life") live(app);
  if (story == "lost") lose(app);
  if (story == "never") never(app);
  if (story == "killed") kill(app);
  if (story == "open") open(app);
  std::fputs(phone::log.c_str(), stdout);
  std::printf("%s: %d frames, %d contexts%s, %.1f %% of the picture\n", story.c_str(), phone::screen.frames,
              phone::screen.contexts, app.is_finished ? ", ended by itself" : "", 100 * covered());
  if (argc > 4 && !phone::screen.rgba.empty()) save(argv[4]);
  return wrong == 0 ? 0 : 1;
}
