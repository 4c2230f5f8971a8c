// An entry point of the driver, and who watches its calls for errors.
#pragma once

#include <cstddef>
#include <type_traits>

#include "marrow/api.h"

namespace marrow::gles3 {

// Told of every GL error by the call that caused it: for debugging, as each call is then between two of glGetError.
// One an Api and thread.
struct ErrorWatch {
  // call: "glBindBuffer", a static string. May be null.
  void (*report)(void* user, const char* call, unsigned error) = nullptr;
  void* user = nullptr;               // what `report` gets
  unsigned pending = 0;               // what the Api's GetError has yet to tell, as it would without a watch
  unsigned (*get_error)() = nullptr;  // the driver's glGetError
};

// What the Api's GetError returns under a watch.
MARROW_API unsigned take_error(ErrorWatch& watch);

// Errors from before are the caller's, and kept pending; those that it leaves behind are the call's.
class WatchedCall {
 public:
  // Takes what errors there are. name: of the call, a static string.
  MARROW_API WatchedCall(ErrorWatch& watch, const char* name);
  // Reports the call's own errors.
  MARROW_API ~WatchedCall();
  WatchedCall(const WatchedCall&) = delete;
  WatchedCall& operator=(const WatchedCall&) = delete;

 private:
  ErrorWatch& watch_;
  const char* name_;
  unsigned stuck_;  // what GL told again and again before the call
};

// A function pointer, called and assigned like one.
template <class Function>
struct Entry;
template <class Result, class... Arguments>
// An entry point of this result and these arguments.
struct Entry<Result(Arguments...)> {
  // What the driver gives.
  using Pointer = Result (*)(Arguments...);

  Pointer function = nullptr;   // null: the driver has it not
  const char* name;             // "glBindBuffer"; a static string
  ErrorWatch* watch = nullptr;  // null: nobody watches

  // An entry point that is not there yet. of: its name, a static string.
  explicit constexpr Entry(const char* of) : name(of) {}
  // Another function in its place.
  Entry& operator=(Pointer to) {
    function = to;
    return *this;
  }
  // Whether the driver has it not.
  bool operator==(std::nullptr_t) const { return function == nullptr; }

  // Calls the driver, watched if there is a watch. Precondition: it is there.
  Result operator()(Arguments... arguments) const {
    if (watch == nullptr) [[likely]]
      return function(arguments...);
    if constexpr (std::is_same_v<Pointer, unsigned (*)()>) {
      if (function == watch->get_error) return take_error(*watch);
    }
    const WatchedCall call(*watch, name);
    return function(arguments...);
  }
};

}  // namespace marrow::gles3
