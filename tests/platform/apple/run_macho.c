// Runs code for iOS on Linux: maps an executable that ld64.lld linked, binds what it imports, and calls its entry,
// which is road() of road.c. Both systems pass these arguments alike. The executable has its fixups in chains, as iOS 14 has.
// usage: run_macho EXECUTABLE FILE.mrw CLIP SECONDS OUT.bin
#define _GNU_SOURCE
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

static void die(const char* what) {
  fprintf(stderr, "run_macho: %s\n", what);
  exit(1);
}

static void smashed(void) {
  die("the stack is damaged");
}
static void zero(void* where, size_t size) {
  memset(where, 0, size);
}
static uintptr_t guard = 0x5eed;

static const struct {
  const char* name;
  void* address;
} imports[] = {
    {"___stack_chk_fail", smashed}, {"___stack_chk_guard", &guard},
    {"_bzero", zero},               {"___bzero", zero},
    {"_floor", floor},              {"_floorf", floorf},
    {"_ldexpf", ldexpf},            {"_memchr", memchr},
    {"_memcmp", memcmp},            {"_memcpy", memcpy},
    {"_memmove", memmove},          {"_memset", memset},
    {"_strcmp", strcmp},            {"_strlen", strlen},
};

static void* address_of(const char* name) {
  for (size_t i = 0; i < sizeof imports / sizeof imports[0]; ++i)
    if (strcmp(imports[i].name, name) == 0) return imports[i].address;
  fprintf(stderr, "run_macho: %s is imported, and is not in the list\n", name);
  exit(1);
}

static char* read_all(const char* name, size_t* size) {
  FILE* const file = fopen(name, "rb");
  if (file == NULL || fseek(file, 0, SEEK_END) != 0) die(name);
  *size = (size_t)ftell(file);
  rewind(file);
  char* const out = aligned_alloc(16, (*size + 16) / 16 * 16);
  if (out == NULL || fread(out, 1, *size, file) != *size) die(name);
  fclose(file);
  return out;
}

static uint32_t u32(const void* at) {
  uint32_t out;
  memcpy(&out, at, sizeof out);
  return out;
}
static uint64_t u64(const void* at) {
  uint64_t out;
  memcpy(&out, at, sizeof out);
  return out;
}

static uint64_t base = 0;  // where __TEXT begins, at which the executable is linked and mapped

static void map_segment(const char* command, const char* file) {
  const uint64_t address = u64(command + 24), size = u64(command + 32), offset = u64(command + 40);
  if (u32(command + 56) == 0) return;  // __PAGEZERO may not be touched
  const size_t whole = (size + 0xfff) / 0x1000 * 0x1000;
  void* const where = (void*)(uintptr_t)address;
  const int all = PROT_READ | PROT_WRITE | PROT_EXEC, there = MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED_NOREPLACE;
  if (mmap(where, whole, all, there, -1, 0) != where)
    die("a segment cannot be mapped at its address");
  memcpy(where, file + offset, u64(command + 48));
  if (strcmp(command + 8, "__TEXT") == 0) base = address;
}

// One page's chain of 64-bit pointers, each with the distance to the next in words of 4 bytes.
static void fix_chain(char* at, unsigned format, const char* table, const char* names) {
  for (;;) {
    const uint64_t word = u64(at);
    uint64_t value = word & 0xfffffffffull;
    if (word >> 63)
      value = (uint64_t)(uintptr_t)address_of(names + (u32(table + 4 * (word & 0xffffff)) >> 9));
    else if (format == 6)
      value += base;
    else if (format != 2)
      die("a chain of pointers of another format");
    memcpy(at, &value, sizeof value);
    const unsigned step = word >> 51 & 0xfff;
    if (step == 0) return;
    at += 4 * (size_t)step;
  }
}

// dyld_chained_fixups_header: offsets of what begins in the image, of the table of imports, of their names.
static void fix(const char* header) {
  const char* const starts = header + u32(header + 4);
  const char *const table = header + u32(header + 8), *const names = header + u32(header + 12);
  if (u32(header + 20) != 1) die("imports of another format");
  for (uint32_t i = 0; i < u32(starts); ++i) {
    const uint32_t offset = u32(starts + 4 + 4 * (size_t)i);
    if (offset == 0) continue;
    const char* const segment = starts + offset;
    uint16_t page_size, format, pages, first;
    memcpy(&page_size, segment + 4, 2);
    memcpy(&format, segment + 6, 2);
    memcpy(&pages, segment + 20, 2);
    for (unsigned page = 0; page < pages; ++page) {
      memcpy(&first, segment + 22 + 2 * (size_t)page, 2);
      if (first == 0xffff) continue;
      fix_chain((char*)(uintptr_t)(base + u64(segment + 8)) + (size_t)page * page_size + first, format, table, names);
    }
  }
}

typedef long road_function(const void*, size_t, const char*, float, void*, size_t, float*, size_t);

static road_function* load(const char* name) {
  size_t size;
  const char* const file = read_all(name, &size);
  if (u32(file) != 0xfeedfacf) die("no Mach-O file of 64 bits");
  const char* command = file + 32;
  uint64_t entry = 0;
  const char* chains = NULL;
  for (uint32_t i = 0; i < u32(file + 16); ++i, command += u32(command + 4)) {
    if (u32(command) == 0x19) map_segment(command, file);
    if (u32(command) == 0x80000028) entry = u64(command + 8);
    if (u32(command) == 0x80000034) chains = file + u32(command + 8);
  }
  if (base == 0 || entry == 0 || chains == NULL) die("no entry, or no chains of fixups");
  fix(chains);
  __builtin___clear_cache((char*)(uintptr_t)base, (char*)(uintptr_t)base + size);
  return (road_function*)(uintptr_t)(base + entry);
}

int main(int argc, char** argv) {
  static _Alignas(16) char memory[1 << 24];
  static float out[1 << 20];
  if (argc != 6) die("usage: run_macho EXECUTABLE FILE.mrw CLIP SECONDS OUT.bin");
  road_function* const road = load(argv[1]);
  size_t size;
  const char* const cooked = read_all(argv[2], &size);
  const long count = road(cooked, size, argv[3], strtof(argv[4], NULL), memory, sizeof memory, out, sizeof out / 4);
  if (count < 0) {
    fprintf(stderr, "run_macho: road.c stops at line %ld\n", -count);
    return 1;
  }
  FILE* const file = fopen(argv[5], "wb");
  if (file == NULL || fwrite(out, 4, (size_t)count, file) != (size_t)count || fclose(file) != 0) die(argv[5]);
  return 0;
}
