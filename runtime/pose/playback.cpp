#include "marrow/playback.h"

#include <type_traits>

#include "core/builtins.h"
#include "core/check.h"
#include "math/finite.h"

namespace marrow {
namespace {

// A game may copy it as bytes. Asserted here, since <type_traits> is twice as long as all of marrow.h.
static_assert(std::is_trivially_copyable_v<Playback>);

constexpr std::int64_t kMostTurns = INT32_MAX;

// x = quotient · d + remainder with 0 ≤ remainder < d; the quotient stops at kMostTurns.
struct Division {
  std::int64_t quotient;
  double remainder;
};

// Long division in base two, for x ≥ 0 and d > 0. It is exact, since each number subtracted from x is between x / 2 and
// x (Sterbenz, Floating-Point Computation, 1974).
Division divide(double x, double d) {
  double multiple = d;
  int power = 0;
  for (; multiple + multiple <= x; ++power) multiple += multiple;
  std::int64_t quotient = 0;
  for (; power >= 0; --power, multiple *= 0.5) {
    if (multiple > x) continue;
    x -= multiple;
    quotient += power < 31 ? std::int64_t{1} << power : kMostTurns;
    if (quotient > kMostTurns) quotient = kMostTurns;
  }
  return {quotient, x};
}

double next_below(double positive) {
  return bit_cast<double>(bit_cast<std::uint64_t>(positive) - 1);
}

void run_once(Playback& p, double time_s, double duration_s) {
  p.time_s = time_s < 0 ? 0 : time_s > duration_s ? duration_s : time_s;
}

void run_loop(Playback& p, double time_s, double duration_s) {
  if (time_s >= 0) {
    const Division passed = divide(time_s, duration_s);
    p.time_s = passed.remainder;
    p.turns = static_cast<std::int32_t>(passed.quotient);
    return;
  }
  const Division passed = divide(-time_s, duration_s);
  const bool at_start = passed.remainder == 0;
  const std::int64_t turns = passed.quotient + (at_start ? 0 : 1);
  const double left_s = duration_s - passed.remainder;
  // After a tiny step back, left_s may have been rounded to duration_s.
  p.time_s = at_start ? 0 : left_s < duration_s ? left_s : next_below(duration_s);
  p.turns = static_cast<std::int32_t>(turns < kMostTurns ? -turns : -kMostTurns);
}

// time_s: the clip time that is reached without turning round at the ends; it is folded into 0 … duration_s here.
void run_ping_pong(Playback& p, double time_s, double duration_s) {
  const bool below = time_s < 0;
  // There and back is one period; the remainder gives the position and the direction.
  const Division passed = divide(below ? -time_s : time_s, duration_s + duration_s);
  const bool beyond = passed.remainder > duration_s;
  const bool at_start = passed.remainder == 0 && passed.quotient > 0;  // not yet turned there
  p.time_s = beyond ? duration_s + duration_s - passed.remainder : passed.remainder;
  const std::int64_t turns = 2 * passed.quotient + (beyond ? 1 : 0) - (at_start ? 1 : 0) + (below ? 1 : 0);
  p.turns = static_cast<std::int32_t>(turns < kMostTurns ? turns : kMostTurns);
  if ((beyond != at_start) != below) p.returning = !p.returning;
}

}  // namespace

Status advance(Playback& playback, float duration_s, float dt_s) {
  MARROW_REQUIRE(is_finite(playback.time_s) && is_finite(static_cast<double>(playback.speed)));
  MARROW_REQUIRE(is_finite(static_cast<double>(dt_s)));
  MARROW_REQUIRE(is_finite(static_cast<double>(duration_s)) && duration_s >= 0);
  const double duration = static_cast<double>(duration_s);
  const double moved_s = static_cast<double>(dt_s) * static_cast<double>(playback.speed);
  playback.turns = 0;
  if (duration_s == 0) {
    playback.time_s = 0;
    return Status::ok;
  }
  switch (playback.mode) {
    case PlayMode::once:
      run_once(playback, playback.time_s + moved_s, duration);
      break;
    case PlayMode::loop:
      run_loop(playback, playback.time_s + moved_s, duration);
      break;
    case PlayMode::ping_pong:
      run_ping_pong(playback, playback.returning ? playback.time_s - moved_s : playback.time_s + moved_s, duration);
      break;
  }
  return Status::ok;
}

bool finished(const Playback& playback, float duration_s) {
  if (playback.mode != PlayMode::once) return false;
  return playback.speed > 0 ? playback.time_s >= static_cast<double>(duration_s)
                            : playback.speed < 0 && playback.time_s <= 0;
}

}  // namespace marrow
