// What a self-test's result depends on, as a number; and what its order of paths depends on.
#pragma once

#include "marrow/gles3_self_test.h"

namespace marrow::gles3 {

// How many values Verdict and GpuFamily have.
inline constexpr std::uint32_t kVerdictCount = 8;
inline constexpr std::uint32_t kGpuFamilyCount = 5;
// The most that PathResult::position_error may be, metres, and normal_error. Numbers of 16 bits are off by more.
inline constexpr float kMostPositionError = 0.001f;
inline constexpr float kMostNormalError = 0.005f;
// From so many characters on choose() prefers palettes in a texture.
inline constexpr std::uint32_t kManyCharacters = 8;

std::uint64_t self_test_key(const Api& api, const Caps& caps, const SelfTestOptions& options);

GpuFamily family_of(const unsigned char* renderer);

}  // namespace marrow::gles3
