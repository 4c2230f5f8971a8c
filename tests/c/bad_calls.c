// Every function of marrow/c.h, or of marrow/c_gles3.h, with pointers that are null, off their boundary or lead to
// zeros, null with a count, and numbers that are none: a call that cannot be done says so, and nothing crashes. tools/c_api
// makes the calls.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "marrow/c.h"
#ifdef MARROW_TEST_GLES3
#include "marrow/c_gles3.h"
#define ABI_IS_RIGHT (mrw_gles3_abi() == MRW_GLES3_ABI)
#define CALLS "gles3_bad_calls.h"
#else
#define ABI_IS_RIGHT (mrw_abi() == MRW_ABI)
#define CALLS "bad_calls.h"
#endif

enum { kObjects = 12, kObjectBytes = 32768 };

// What the arguments of a call are.
typedef struct Round {
  const char* what;
  unsigned char* objects;  // one a parameter; null: all pointers are
  size_t off;              // bytes that they are off their boundary
  int lists_too;           // 0: lists are null
  size_t list_off;         // bytes that lists are off
  size_t count;            // of each list
  float real;
  uint32_t whole;
  const char* text;
  int has_driver;  // of paper, which does nothing
} Round;

typedef struct Row {
  const char* name;
  int (*call)(const Round*);  // the status, or -1 of what returns none
  int takes_struct, takes_list;
} Row;

static void* at(const Round* r, int i) {
  return r->objects == NULL ? NULL : r->objects + (size_t)i * kObjectBytes + r->off;
}
static void* list(const Round* r, int i) {
  return r->lists_too ? r->objects + (size_t)i * kObjectBytes + r->list_off : NULL;
}
static size_t count(const Round* r) {
  return r->count;
}
static float real(const Round* r) {
  return r->real;
}
static uint32_t whole(const Round* r) {
  return r->whole;
}

#ifdef MARROW_TEST_GLES3
void* paper_proc_of_c(const char* name);

static mrw_gles3_api driver;

static const mrw_gles3_api* ready(const Round* r, int i) {
  return r->has_driver ? &driver : at(r, i);
}
static mrw_gles3_load_proc gles3_load_proc(const Round* r) {
  return r->has_driver ? paper_proc_of_c : NULL;
}
#else
static const char* text(const Round* r) {
  return r->text;
}
#endif

// STATUS and CALL: a function's name, whether it takes a struct, or a list, and its arguments.
#define STATUS(name, takes_struct, takes_list, ...) \
  static int call_##name(const Round* r) {          \
    (void)r;                                        \
    return mrw_##name(__VA_ARGS__);                 \
  }
#define CALL(name, takes_struct, takes_list, ...) \
  static int call_##name(const Round* r) {        \
    (void)r;                                      \
    (void)mrw_##name(__VA_ARGS__);                \
    return -1;                                    \
  }
#include CALLS
#undef STATUS
#undef CALL
#define STATUS(name, takes_struct, takes_list, ...) {"mrw_" #name, call_##name, takes_struct, takes_list},
#define CALL STATUS
static const Row rows[] = {
#include CALLS
};

static int told, failures;
static const char* told_name = "";

static void on_call_error(const char* function, const char* condition) {
  ++told;
  told_name = function;
  if (condition == NULL || strlen(condition) < 4) ++failures;
}

static void expect(int holds, const Row* row, const Round* r, const char* what) {
  if (holds) return;
  ++failures;
  fprintf(stderr, "%s, %s: %s\n", row->name, r->what, what);
}

// What every call keeps to, and what a refused one does.
static int called(const Row* row, const Round* r) {
  int status;
  told = 0;
  if (r->objects != NULL) memset(r->objects, 0, (size_t)kObjects * kObjectBytes);
  status = row->call(r);
  expect(status < 0 || strlen(mrw_status_text((mrw_status)status)) > 1, row, r, "gives no status");
#if !defined(MARROW_CALL_ERRORS) || MARROW_CALL_ERRORS
  if (status >= 0) expect((status == MRW_BAD_ARGUMENT) == (told == 1), row, r, "does not tell of a refused call, once");
#endif
  return status;
}

int main(void) {
  unsigned char* const memory = malloc((size_t)kObjects * kObjectBytes + MRW_BLOCK_BOUNDARY);
  mrw_block objects;
  const size_t row_count = sizeof rows / sizeof *rows;
  size_t i, k;
  if (memory == NULL || mrw_block_in(memory, (size_t)kObjects * kObjectBytes + MRW_BLOCK_BOUNDARY, &objects) != MRW_OK)
    return 1;
  if (!ABI_IS_RIGHT) return 1;
#ifdef MARROW_TEST_GLES3
  if (sizeof(mrw_gles3_program_set) > kObjectBytes) return 1;
  if (mrw_gles3_load_api(&driver, paper_proc_of_c, NULL) != MRW_OK) return 1;
#endif
  mrw_set_call_error_handler(on_call_error);
  for (i = 0; i < row_count; ++i) {
    const Row* const row = &rows[i];
    const Round null = {"null", NULL, 0, 0, 0, 0, 0, 0, NULL, 0};
    const Round off = {"off its boundary", objects.data, 1, 0, 0, 0, 0, 0, "", 0};
    const Round nothing = {"a list of three at null", objects.data, 0, 0, 0, 3, 0, 0, "", 1};
    const Round others[] = {
        {"zeros and no driver", objects.data, 0, 1, 0, 1, 1, 1, "", 0},
        {"zeros", objects.data, 0, 0, 0, 0, 0, 0, "", 1},
        {"zeros and lists", objects.data, 0, 1, 0, 1, 0, 0, "no such", 1},
        {"zeros and lists of three", objects.data, 0, 1, 0, 3, 1, 1, NULL, 1},
        {"lists off their boundary", objects.data, 0, 1, 2, 2, 0, 1, "", 1},
        {"no numbers", objects.data, 0, 1, 0, 1, NAN, 0xFFFFFFFF, "", 1},
        {"huge numbers", objects.data, 0, 1, 0, 2, 1e38f, 0x7FFFFFFF, "no such", 1},
        {"infinity", objects.data, 0, 0, 0, 0, INFINITY, 0xFFFF, NULL, 1},
    };
    int status = called(row, &null);
    if (row->takes_struct && status >= 0) expect(status == MRW_BAD_ARGUMENT, row, &null, "is not refused");
    if (row->takes_struct && status >= 0) expect(strcmp(told_name, row->name) == 0, row, &null, "has another name");
    status = called(row, &off);
    if (row->takes_struct && status >= 0) expect(status == MRW_BAD_ARGUMENT, row, &off, "is not refused");
    status = called(row, &nothing);
    if (row->takes_list && status >= 0) expect(status == MRW_BAD_ARGUMENT, row, &nothing, "is not refused");
    for (k = 0; k < sizeof others / sizeof *others; ++k) called(row, &others[k]);
  }
  printf("%u functions, %d failures\n", (unsigned)row_count, failures);
  free(memory);
  return failures != 0;
}
