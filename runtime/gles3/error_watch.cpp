// For debugging: which call causes which GL error.
#include "gles3/gl_constants.h"
#include "marrow/gles3.h"

namespace marrow::gles3 {
namespace {

// GL keeps an error of each kind; a lost context may report its loss for ever.
constexpr int kErrorKinds = 8;

// Reports errors other than `stuck`, if there is a call to blame. Returns an error that GL does not clear, or none.
unsigned collect(ErrorWatch& watch, const char* call, unsigned stuck) {
  unsigned last = kGlNoError;
  for (int i = 0; i < kErrorKinds; ++i) {
    const unsigned error = watch.get_error();
    if (error == kGlNoError || error == last) return error;
    last = error;
    if (watch.pending == kGlNoError) watch.pending = error;
    if (call != nullptr && error != stuck && watch.report != nullptr) watch.report(watch.user, call, error);
  }
  return last;
}

}  // namespace

unsigned take_error(ErrorWatch& watch) {
  const unsigned error = watch.pending;
  watch.pending = kGlNoError;
  return error != kGlNoError ? error : watch.get_error();
}

unsigned begin_watched(ErrorWatch& watch) {
  return collect(watch, nullptr, kGlNoError);
}

void end_watched(ErrorWatch& watch, const char* call, unsigned stuck) {
  collect(watch, call, stuck);
}

void watch_errors(Api& api, ErrorWatch* watch) {
  if (watch != nullptr) watch->get_error = api.GetError.function;
#define MARROW_WATCH(Result, Name, Parameters) api.Name.watch = watch;
  MARROW_GLES3_FUNCTIONS(MARROW_WATCH)
  MARROW_GLES3_OPTIONAL_FUNCTIONS(MARROW_WATCH)
#undef MARROW_WATCH
}

}  // namespace marrow::gles3
