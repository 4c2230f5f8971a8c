// Assets, the looper, events and the log. See phone.h.
#include <android/asset_manager.h>
#include <android/input.h>
#include <android/log.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>

#include "phone.h"

namespace phone {

std::string log;
int events_given = 0, events_finished = 0;

namespace {

const unsigned char* apk = nullptr;
std::size_t apk_bytes = 0;

struct Waiting {
  ALooper_callbackFunc callback;
  void* data;
};
std::map<int, Waiting> looper;
int events_file = -1;

unsigned number(const unsigned char* at, int bytes) {
  unsigned out = 0;
  for (int i = 0; i < bytes; ++i) out |= unsigned{at[i]} << 8 * i;
  return out;
}

}  // namespace

void open_apk(const char* path) {
  const int file = open(path, O_RDONLY);
  struct stat about = {};
  if (file < 0 || fstat(file, &about) != 0) std::exit((std::perror(path), 1));
  apk_bytes = static_cast<std::size_t>(about.st_size);
  apk = static_cast<const unsigned char*>(mmap(nullptr, apk_bytes, PROT_READ, MAP_PRIVATE, file, 0));
  close(file);
}

void pump(int frames, double seconds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + std::chrono::microseconds(static_cast<long>(1e6 * seconds));
  const int wanted = screen.frames + frames;
  while (Clock::now() < end && (frames == 0 || screen.frames < wanted)) {
    std::vector<pollfd> files;
    for (const auto& [file, waiting] : looper) files.push_back({file, POLLIN, 0});
    poll(files.data(), files.size(), 10);
    for (const pollfd& file : files) {
      const auto found = looper.find(file.fd);
      if (found == looper.end() || (file.revents & POLLIN) == 0) continue;
      const Waiting waiting = found->second;
      if (waiting.callback(file.fd, ALOOPER_EVENT_INPUT, waiting.data) == 0) looper.erase(file.fd);
    }
  }
}

AInputQueue* input_queue() {
  return reinterpret_cast<AInputQueue*>(&events_given);
}

}  // namespace phone

struct AAsset {
  const void* bytes;
  long size;
  void* allocated;
};

extern "C" {

AAsset* AAssetManager_open(AAssetManager*, const char* name, int) {
  const std::string path = std::string("assets/") + name;
  const unsigned char* const apk = phone::apk;
  std::size_t end = phone::apk_bytes - 22;
  while (end > 0 && phone::number(apk + end, 4) != 0x06054B50) --end;
  const unsigned char* at = apk + phone::number(apk + end + 16, 4);
  for (unsigned i = phone::number(apk + end + 10, 2); i > 0; --i) {
    const unsigned method = phone::number(at + 10, 2), packed = phone::number(at + 20, 4),
                   size = phone::number(at + 24, 4);
    const unsigned named = phone::number(at + 28, 2), rest = phone::number(at + 30, 2) + phone::number(at + 32, 2);
    const unsigned char* const local = apk + phone::number(at + 42, 4);
    if (path == std::string(reinterpret_cast<const char*>(at) + 46, named)) {
      const unsigned char* const data = local + 30 + phone::number(local + 26, 2) + phone::number(local + 28, 2);
      if (method == 0) return new AAsset{data, static_cast<long>(size), nullptr};
      char* const block = static_cast<char*>(std::malloc(size + 4));
      z_stream stream = {};
      stream.next_in = const_cast<unsigned char*>(data);
      stream.avail_in = packed;
      stream.next_out = reinterpret_cast<unsigned char*>(block) + 4;  // on no boundary of 16
      stream.avail_out = size;
      inflateInit2(&stream, -15);
      inflate(&stream, Z_FINISH);
      inflateEnd(&stream);
      return new AAsset{block + 4, static_cast<long>(size), block};
    }
    at += 46 + named + rest;
  }
  return nullptr;
}
const void* AAsset_getBuffer(AAsset* asset) {
  return asset->bytes;
}
long AAsset_getLength(AAsset* asset) {
  return asset->size;
}
int AAsset_isAllocated(AAsset* asset) {
  return asset->allocated != nullptr;
}
void AAsset_close(AAsset* asset) {
  std::free(asset->allocated);
  delete asset;
}

ALooper* ALooper_forThread() {
  return reinterpret_cast<ALooper*>(&phone::looper);
}
int ALooper_addFd(ALooper*, int file, int, int, ALooper_callbackFunc callback, void* data) {
  phone::looper[file] = {callback, data};
  return 1;
}
int ALooper_removeFd(ALooper*, int file) {
  return static_cast<int>(phone::looper.erase(file));
}

// Two events wait at once, the second of which an input method takes before the app may.
void AInputQueue_attachLooper(AInputQueue*, ALooper* to, int identifier, ALooper_callbackFunc callback, void* data) {
  phone::events_file = eventfd(1, EFD_NONBLOCK);
  ALooper_addFd(to, phone::events_file, identifier, ALOOPER_EVENT_INPUT, callback, data);
}
void AInputQueue_detachLooper(AInputQueue*) {
  phone::looper.erase(phone::events_file);
  close(phone::events_file);
}
int32_t AInputQueue_getEvent(AInputQueue*, AInputEvent** event) {
  if (phone::events_given == 2) {
    unsigned long long count = 0;
    if (read(phone::events_file, &count, sizeof count) < 0) return -1;
    return -1;
  }
  *event = reinterpret_cast<AInputEvent*>(static_cast<std::uintptr_t>(++phone::events_given));
  return 0;
}
int32_t AInputQueue_preDispatchEvent(AInputQueue*, AInputEvent* event) {
  return reinterpret_cast<std::uintptr_t>(event) == 2;
}
void AInputQueue_finishEvent(AInputQueue*, AInputEvent*, int) {
  ++phone::events_finished;
}

int __android_log_print(int priority, const char* tag, const char* format, ...) {
  char line[1024];
  va_list values;
  va_start(values, format);
  std::vsnprintf(line, sizeof line, format, values);
  va_end(values);
  phone::log += std::string(1, " ??DIWE"[priority]) + "/" + tag + ": " + line + "\n";
  return 1;
}

void ANativeActivity_finish(ANativeActivity* activity) {
  phone::finish_of(activity);
}
int32_t ANativeWindow_setBuffersGeometry(ANativeWindow*, int32_t, int32_t, int32_t) {
  return 0;
}
}
