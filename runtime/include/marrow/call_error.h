// Who is told when a call is wrong: which function, and what it asks for and did not get.
#pragma once

#include "marrow/api.h"

namespace marrow {

// function: the name of the public function that was called, as "place_feet". condition: what does not hold, as it
// stands in the function's source. Both are static strings.
using CallErrorHandler = void (*)(const char* function, const char* condition);

// From now on `handler` is told of every call that returns Status::bad_argument, on the thread of that call and before
// it returns. null: nobody is told. Returns the handler before.
//
// The runtime itself never logs. Without a call of this nobody is told in a build with NDEBUG, and in one without a
// line goes to stderr. A library built with MARROW_CALL_ERRORS=OFF, as it is by default for MinSizeRel, holds no names
// and no conditions, and tells nobody whatever is set here.
//
// Bad data in a file is no bad call: see DataError.
// Thread-safe; the handler must be so too, and the one before may still be running on other threads. It may call
// anything of Marrow, may set another handler, and may stop the program.
MARROW_API CallErrorHandler set_call_error_handler(CallErrorHandler handler);

// The handler of now; null: nobody is told. Thread-safe.
MARROW_API CallErrorHandler call_error_handler();

}  // namespace marrow
