// What a game sets, and how numbers go there.
#include "core/check.h"
#include "graph/graph_step.h"
#include "math/finite.h"

namespace marrow {
namespace {

// What is left of a distance after x half-lives, and the mean of what was left over that time.
struct Decay {
  double rest, mean;
};
// 2^-x and (1 - 2^-x) / (x ln 2): Taylor's series of e^-z to z = ½ ln 2, squared as often as x has halves.
Decay decay_over(double half_lives) {
  constexpr double kMostHalfLives = 64, kLn2 = 0.69314718055994530942;
  if (half_lives >= kMostHalfLives) return {0, 1.0 / (half_lives * kLn2)};
  const auto whole = static_cast<int>(half_lives);
  const double z = (half_lives - whole) * kLn2;
  double lost = 0;  // (1 - e^-z) / z
  for (int k = 16; k > 0; --k) lost = (1.0 - lost * z) / static_cast<double>(k);
  double rest = 1.0 - z * lost;
  for (int i = 0; i < whole; ++i) rest *= 0.5;
  const double mean = whole == 0 ? lost : (1.0 - rest) / (half_lives * kLn2);
  return {rest, mean};
}

}  // namespace

bool numbers_change(const GraphStep& step) {
  constexpr float kFarOff = 0x1p-6f;  // of its range
  if (step.head().is_updated == 0) return false;
  for (std::uint32_t i = 0; i < step.g.parameters.size; ++i) {
    const GraphParameter& p = step.g.parameters[i];
    if (p.kind != ParameterKind::number || !(p.seconds > 0)) continue;
    const float off = step.parameter(i).value - step.parameter(i).target;
    if ((off < 0 ? -off : off) > kFarOff * (p.most - p.least)) return true;
  }
  return false;
}

void step_parameters(const GraphStep& step) {
  for (std::uint32_t i = 0; i < step.g.parameters.size; ++i) {
    const GraphParameter& p = step.g.parameters[i];
    if (p.kind != ParameterKind::number) continue;
    ParameterState& own = step.parameter(i);
    const double target = static_cast<double>(own.target), off = static_cast<double>(own.value) - target;
    // A number arrives when its float does.
    Decay left{0, 0};
    if (p.seconds > 0 && step.head().is_updated != 0 && off != 0)
      left = step.dt_s > 0 ? decay_over(step.dt_s / static_cast<double>(p.seconds)) : Decay{1, 1};
    own.value = static_cast<float>(target + off * left.rest);
    step.s.means[i] = static_cast<float>(target + off * left.mean);
  }
}

void end_triggers(const GraphStep& step) {
  for (std::uint32_t i = 0; i < step.g.parameters.size; ++i) {
    ParameterState& own = step.parameter(i);
    const GraphParameter& p = step.g.parameters[i];
    if (p.kind != ParameterKind::trigger || own.target == 0 || !(p.seconds > 0)) continue;
    own.value -= static_cast<float>(step.dt_s);
    if (!(own.value > 0)) own = {};
  }
}

void drop_brief_triggers(const GraphStep& step) {
  for (std::uint32_t i = 0; i < step.g.parameters.size; ++i)
    if (step.g.parameters[i].kind == ParameterKind::trigger && !(step.g.parameters[i].seconds > 0))
      step.parameter(i) = {};
}

namespace {

// Whether the animator has such a parameter.
BadCall check_parameter(const Animator& a, std::uint32_t parameter, ParameterKind kind) {
  MARROW_CHECK(a.binding != nullptr && a.state.size >= a.binding->state_bytes);
  MARROW_CHECK(parameter < a.binding->graph.parameters.size);
  MARROW_CHECK(a.binding->graph.parameters[parameter].kind == kind);
  return {};
}

Status set(Animator& animator, std::uint32_t parameter, float value) {
  parameters_of(animator.state)[parameter].target = value;
  return Status::ok;
}

}  // namespace

Status set_number(Animator& animator, std::uint32_t parameter, float value) {
  MARROW_REQUIRE_GOOD(check_parameter(animator, parameter, ParameterKind::number));
  MARROW_REQUIRE(is_number(value));
  const GraphParameter& p = animator.binding->graph.parameters[parameter];
  return set(animator, parameter, value < p.least ? p.least : value < p.most ? value : p.most);
}

Status set_flag(Animator& animator, std::uint32_t parameter, bool value) {
  MARROW_REQUIRE_GOOD(check_parameter(animator, parameter, ParameterKind::flag));
  return set(animator, parameter, value ? 1.0f : 0.0f);
}

Status fire(Animator& animator, std::uint32_t parameter) {
  MARROW_REQUIRE_GOOD(check_parameter(animator, parameter, ParameterKind::trigger));
  parameters_of(animator.state)[parameter] = {1.0f, animator.binding->graph.parameters[parameter].seconds};
  return Status::ok;
}

float value_of(const Animator& animator, std::uint32_t parameter) {
  const bool is_there = animator.binding != nullptr && animator.state.size >= animator.binding->state_bytes &&
                        parameter < animator.binding->graph.parameters.size;
  return is_there ? parameters_of(animator.state)[parameter].target : 0.0f;
}

}  // namespace marrow
