#include "wasm/throw.h"

#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <typeinfo>

#include "common/failure.h"
#include "common/retold.h"

namespace marrow::tools {

Retelling* innermost_retelling = nullptr;

namespace {

// By all callers in turn who say it anew. One that throws instead comes here again, without those inside it.
[[noreturn]] void tell(const void* thrown, const std::type_info* type) {
  std::optional<Failure> failure;
  if (*type == typeid(Failure)) failure = *static_cast<const Failure*>(thrown);
  while (const Retelling* const retelling = innermost_retelling) {
    innermost_retelling = retelling->before;
    if (failure ? retelling->type != typeid(Failure) : retelling->type != *type) continue;
    failure = retelling->tell(failure ? &*failure : thrown);
  }
  if (!failure) failure = Failure(Exit::internal, "internal error", "", type->name(), "");
  const std::string text = failure->what();
  marrow_failed(text.data(), text.size(), static_cast<int>(failure->code()));
}

}  // namespace
}  // namespace marrow::tools

// Called in place of a throw: the first that is thrown is told to JavaScript.
extern "C" void* __cxa_allocate_exception(std::size_t size) {
  return std::malloc(size);
}

extern "C" [[noreturn]] void __cxa_throw(void* thrown, std::type_info* type, void (*)(void*)) {
  marrow::tools::tell(thrown, type);
}
