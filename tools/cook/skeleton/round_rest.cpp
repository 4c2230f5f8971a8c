#include "cook/skeleton/round_rest.h"

#include <algorithm>
#include <cmath>

#include "cook/scene/whole_steps.h"
#include "unpack/rest.h"

namespace marrow::cook {
namespace {

// Of any length but zero.
std::uint64_t encode_rotation(const double (&q)[4]) {
  std::uint64_t largest = 0;
  double squared = 0;
  for (std::uint64_t i = 0; i < 4; ++i) {
    squared += q[i] * q[i];
    if (std::abs(q[i]) > std::abs(q[largest])) largest = i;
  }
  std::uint64_t code = largest << 60 | std::uint64_t{q[largest] < 0} << 62;
  for (std::uint64_t i = 0, shift = 0; i < 4; ++i) {
    if (i == largest) continue;
    const double n = std::round(q[i] / std::sqrt(squared) / static_cast<double>(kRotationStep));
    constexpr double kMost = kRotationMiddle - 1;
    code |= static_cast<std::uint64_t>(std::clamp(n, -kMost, kMost) + kRotationMiddle) << shift;
    shift += 20;
  }
  return code;
}

}  // namespace

void round_rest(BuiltSkeleton& skeleton) {
  float longest = 0;
  for (const SoaTransform& four : skeleton.rest)
    for (const auto& axis : four.translation)
      for (const float t : axis) longest = std::max(longest, std::abs(t));
  skeleton.translation_exponent = exponent_for(longest, kMostTranslation);
  skeleton.rotation_codes.clear();
  for (std::size_t joint = 0; joint < skeleton.parents.size(); ++joint) {
    SoaTransform& four = skeleton.rest[joint / 4];
    const std::size_t lane = joint % 4;
    for (auto& axis : four.translation) axis[lane] = whole_steps(axis[lane], skeleton.translation_exponent);
    double q[4];
    for (int i = 0; i < 4; ++i) q[i] = static_cast<double>(four.rotation[i][lane]);
    skeleton.rotation_codes.push_back(encode_rotation(q));
    float rounded[4];
    decode_rotation(skeleton.rotation_codes.back(), rounded);
    for (int i = 0; i < 4; ++i) four.rotation[i][lane] = rounded[i];
    for (auto& axis : four.scale)
      if (std::abs(axis[lane] - 1.0f) <= 1e-6f) axis[lane] = 1.0f;
  }
}

}  // namespace marrow::cook
