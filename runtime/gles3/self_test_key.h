// What a self-test's result depends on, as a number.
#pragma once

#include "marrow/gles3_self_test.h"

namespace marrow::gles3 {

std::uint64_t self_test_key(const Api& api, const Caps& caps, const SelfTestOptions& options);

}  // namespace marrow::gles3
