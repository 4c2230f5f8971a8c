// Put before a program's libraries: one of the calls that main() makes fails, as MARROW_FAULT="memory 17" says: the
// 17th request for memory, or with "memory-from 17" all from there on; with "files 3" the third call that opens, reads,
// writes, flushes, closes or renames a file.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(size_t bytes);
void* __libc_calloc(size_t count, size_t bytes);
void* __libc_realloc(void* memory, size_t bytes);
void* __libc_memalign(size_t alignment, size_t bytes);
}

namespace {

enum Kind { kNothing, kMemory, kMemoryFrom, kFiles };
Kind kind = kNothing;  // until main() is called
long at = 0;
std::atomic<long> calls{0};
int (*real_main)(int, char**, char**) = nullptr;

bool no_memory() {
  if (kind != kMemory && kind != kMemoryFrom) return false;
  const long number = ++calls;
  if (kind == kMemory ? number != at : number < at) return false;
  errno = ENOMEM;
  return true;
}

bool no_file(int error) {
  if (kind != kFiles || ++calls != at) return false;
  errno = error;
  return true;
}

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

int main_with_a_fault(int argc, char** argv, char** environment) {
  char name[16] = "";
  const char* const text = std::getenv("MARROW_FAULT");
  if (text == nullptr || std::sscanf(text, "%15s %ld", name, &at) != 2) std::abort();
  kind = std::strcmp(name, "memory") == 0 ? kMemory : std::strcmp(name, "memory-from") == 0 ? kMemoryFrom : kFiles;
  const int code = real_main(argc, argv, environment);
  kind = kNothing;
  return code;
}

}  // namespace

extern "C" {

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*linker_fini)(), void* stack_end) {
  real_main = main;
  return next<decltype(&__libc_start_main)>("__libc_start_main")(main_with_a_fault, argc, argv, init, fini, linker_fini,
                                                                 stack_end);
}

void* malloc(size_t bytes) {
  return no_memory() ? nullptr : __libc_malloc(bytes);
}
void* calloc(size_t count, size_t bytes) {
  return no_memory() ? nullptr : __libc_calloc(count, bytes);
}
void* realloc(void* memory, size_t bytes) {
  return no_memory() ? nullptr : __libc_realloc(memory, bytes);
}
void* aligned_alloc(size_t alignment, size_t bytes) {
  return no_memory() ? nullptr : __libc_memalign(alignment, bytes);
}
int posix_memalign(void** out, size_t alignment, size_t bytes) {
  *out = no_memory() ? nullptr : __libc_memalign(alignment, bytes);
  return *out == nullptr ? ENOMEM : 0;
}

int open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  return no_file(EMFILE) ? -1 : next<int (*)(const char*, int, ...)>("open")(path, flags, mode);
}
ssize_t read(int file, void* out, size_t bytes) {
  return no_file(EIO) ? -1 : next<decltype(&read)>("read")(file, out, bytes);
}
ssize_t write(int file, const void* from, size_t bytes) {
  return no_file(ENOSPC) ? -1 : next<decltype(&write)>("write")(file, from, bytes);
}
int ftruncate(int file, off_t bytes) {
  return no_file(EIO) ? -1 : next<decltype(&ftruncate)>("ftruncate")(file, bytes);
}
int fsync(int file) {
  return no_file(EIO) ? -1 : next<decltype(&fsync)>("fsync")(file);
}
int rename(const char* from, const char* to) {
  return no_file(EIO) ? -1 : next<decltype(&rename)>("rename")(from, to);
}
int close(int file) {
  const bool fails = no_file(EIO);
  const int result = next<decltype(&close)>("close")(file);
  if (fails) errno = EIO;
  return fails ? -1 : result;
}
}
