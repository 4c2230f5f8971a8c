// Preloaded into the game of platform/sdl: counts what the game's own code allocates, and has events happen that are
// hard to come by, in the frames that MARROW_EVENTS names: "pause:20,reset:40,quit:60".
#include <SDL.h>

#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

std::uintptr_t begin_ = 0, end_ = 0;  // of the program
std::atomic<long> taken_ = 0;
long frame_ = 0, taken_before_ = 0;
SDL_GLContext gone_ = nullptr;
Uint32 then_ms_ = 0, longest_ms_ = 0;

int find_program(dl_phdr_info* info, std::size_t, void*) {  // the first is the program
  begin_ = info->dlpi_addr;
  for (int i = 0; i < info->dlpi_phnum; ++i)
    if (const ElfW(Phdr)& part = info->dlpi_phdr[i]; part.p_type == PT_LOAD)
      end_ = info->dlpi_addr + part.p_vaddr + part.p_memsz;
  return 1;
}

void count(const void* caller) {
  const auto at = reinterpret_cast<std::uintptr_t>(caller);
  taken_ += at >= begin_ && at < end_;
}

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

// What Android's SDL does for a context that did not come back: it makes another, and then says so.
void reset() {
  const SDL_GLContext before = SDL_GL_GetCurrentContext();
  SDL_GL_CreateContext(SDL_GL_GetCurrentWindow());
  SDL_GL_DeleteContext(before);
  gone_ = before;
}

Uint32 resume(Uint32, void*) {
  SDL_Event event = {};
  event.type = SDL_APP_DIDENTERFOREGROUND;
  SDL_PushEvent(&event);
  return 0;
}

void happen(const char* what) {
  SDL_Event event = {};
  if (std::strcmp(what, "quit") == 0) event.type = SDL_QUIT;
  if (std::strcmp(what, "pause") == 0) event.type = SDL_APP_WILLENTERBACKGROUND;
  if (std::strcmp(what, "reset") == 0) event.type = SDL_RENDER_DEVICE_RESET;
  if (std::strcmp(what, "space") == 0) {
    event.type = SDL_KEYDOWN;
    event.key.keysym.sym = SDLK_SPACE;
  }
  if (event.type == SDL_APP_WILLENTERBACKGROUND) SDL_AddTimer(1500, resume, nullptr);
  if (event.type == SDL_RENDER_DEVICE_RESET) reset();
  if (std::strcmp(what, "resize") == 0) SDL_SetWindowSize(SDL_GL_GetCurrentWindow(), 200, 300);
  if (event.type != 0) SDL_PushEvent(&event);
}

}  // namespace

void* operator new(std::size_t bytes) {
  count(__builtin_return_address(0));
  static const auto real = next<void* (*)(std::size_t)>("_Znwm");
  return real(bytes);
}

extern "C" {

void SDL_GL_SwapWindow(SDL_Window* window) {
  static const auto real = next<void (*)(SDL_Window*)>("SDL_GL_SwapWindow");
  real(window);
  if (begin_ == 0) dl_iterate_phdr(find_program, nullptr);
  if (++frame_ == 2) taken_before_ = taken_;
  const Uint32 now_ms = SDL_GetTicks();
  if (frame_ > 2) longest_ms_ = std::max(longest_ms_, now_ms - then_ms_);
  then_ms_ = now_ms;
  char events[256] = "";
  if (const char* const named = std::getenv("MARROW_EVENTS")) std::snprintf(events, sizeof events, "%s", named);
  for (char* event = std::strtok(events, ","); event != nullptr; event = std::strtok(nullptr, ","))
    if (char* const at = std::strchr(event, ':'); at != nullptr && std::atol(at + 1) == frame_) {
      *at = 0;
      happen(event);
    }
}

void SDL_GL_DeleteContext(SDL_GLContext context) {
  if (context != nullptr && context == gone_) {
    std::fprintf(stderr, "shim: the game deletes a context that SDL has deleted\n");
    std::exit(3);
  }
  next<void (*)(SDL_GLContext)>("SDL_GL_DeleteContext")(context);
}

void SDL_Quit() {
  std::printf("%ld frames, the longest took %u ms, %ld allocations of the game's own from the third on\n", frame_,
              longest_ms_, taken_ - taken_before_);
  next<void (*)()>("SDL_Quit")();
}

}  // extern "C"
