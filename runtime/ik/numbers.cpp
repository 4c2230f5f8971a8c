#include "ik/numbers.h"

#include "ik/goals.h"
#include "ik/turn_onto.h"
#include "ik/two_bone.h"

namespace marrow {
namespace {

constexpr SplatConstant four_times(float x) {
  return {{x, x, x, x}};
}

}  // namespace

const Numbers kNumbers = {
    four_times(1),         four_times(0.5f),    four_times(4),        four_times(kTinySquare),
    four_times(0x1p+100f), four_times(0x3p-6f), four_times(0x1p-20f), four_times(kPoleCone* kPoleCone),
    four_times(0.25f),     four_times(kNoSide), four_times(1e-10f),   four_times(kNear)};

}  // namespace marrow
