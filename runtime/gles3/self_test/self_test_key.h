// What a self-test's result depends on, as a number; and what its order of paths depends on.
#pragma once

#include "marrow/gles3_self_test.h"

namespace marrow::gles3 {

std::uint64_t self_test_key(const Api& api, const Caps& caps, const SelfTestOptions& options);

GpuFamily family_of(const unsigned char* renderer);

}  // namespace marrow::gles3
