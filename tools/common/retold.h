// Failures said anew by who knows more: where in the file it is, or what to do about it. Also where nothing can be
// caught as in WebAssembly, where the first exception ends the program.
#pragma once

#include <functional>
#include <typeinfo>

#include "common/failure.h"

namespace marrow::tools {

#ifdef __wasi__

// Those who are to be asked before an exception is told, the innermost first; see wasm/throw.cpp.
struct Retelling {
  const std::type_info& type;
  std::function<Failure(const void*)> tell;
  Retelling* before;
};
extern Retelling* innermost_retelling;

// What `ask` returns. A Thrown that it throws is thrown as the Failure that `tell` makes of it.
template <class Thrown, class Ask, class Tell>
auto retold(const Ask& ask, const Tell& tell) {
  Retelling retelling{typeid(Thrown), [&](const void* thrown) { return tell(*static_cast<const Thrown*>(thrown)); },
                      innermost_retelling};
  struct Entered {
    Retelling* before;
    ~Entered() { innermost_retelling = before; }
  } const entered{retelling.before};
  innermost_retelling = &retelling;
  return ask();
}

#else

template <class Thrown, class Ask, class Tell>
auto retold(const Ask& ask, const Tell& tell) {
  try {
    return ask();
  } catch (const Thrown& thrown) {
    throw tell(thrown);
  }
}

#endif

}  // namespace marrow::tools
