// Curves, easings, patches.
#include <cmath>

#include <gtest/gtest.h>

#include "unit/misuse/misuse.h"

namespace marrow::test {
namespace {

const std::vector<float> kTimes = {0, 0.25f, 0.5f, 1.5f};
const std::vector<float> kValues = {0, 1, 2, 1, 0, 3, -1, 2, 5, 4, 1, 0, 7, -2, 1, 1, 2, 2, 3, 0.5f, 6, 1, 0, 8};

Curve curve_of(Misuse& m, CurveKind kind = CurveKind::hermite, std::uint32_t components = 2) {
  const std::size_t count = curve_value_count(kind, components, kTimes.size());
  return {m.kind(kind), m.truth(false), m.index(components), m.in(kTimes, Length::any),
          m.in(Span<const float>(kValues.data(), count))};
}

}  // namespace

std::vector<MisuseRow> rows_of_curves() {
  return {
      {"curve_value_count",
       [](Misuse& m) {
         (void)curve_value_count(m.kind(CurveKind::hermite), m.index(2), m.index(4));
         m.returned_ok();
       }},
      {"arc_length_count",
       [](Misuse& m) {
         (void)arc_length_count(m.index(4), m.index(8));
         m.returned_ok();
       }},
      {"check_curve", [](Misuse& m) { m.returned(check_curve(curve_of(m))); }},
      {"evaluate_curve",
       [](Misuse& m) {
         const Span<float> out = m.out<float>(2);
         m.returned(evaluate_curve(curve_of(m), m.number(0.3f), out));
       }},
      {"evaluate_curve",
       [](Misuse& m) {
         const std::vector<float> turns = {0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
         const Span<float> out = m.out<float>(4);
         const Curve curve{m.kind(CurveKind::centripetal), m.truth(true), m.index(4), m.in(kTimes, Length::any),
                           m.in(turns)};
         m.returned(evaluate_curve(curve, m.number(0.3f), out));
       }},
      {"curve_velocity",
       [](Misuse& m) {
         const Span<float> out = m.out<float>(2);
         m.returned(curve_velocity(curve_of(m), m.number(0.3f), out));
       }},
      {"natural_spline",
       [](Misuse& m) {
         const Span<float> out = m.out<float>(24);
         m.returned(natural_spline(curve_of(m, CurveKind::linear), out));
       }},
      {"clamped_spline",
       [](Misuse& m) {
         const std::vector<float> speed = {1, -1};
         const Span<float> out = m.out<float>(24);
         m.returned(clamped_spline(curve_of(m, CurveKind::linear), m.in(speed), m.in(speed), out));
       }},
      {"bezier",
       [](Misuse& m) {
         const Span<float> scratch = m.room<float>(kValues.size()), out = m.out<float>(3);
         m.returned(bezier(m.in(kValues, Length::any), m.index(3), m.number(0.5f), scratch, out));
       }},
      {"bezier_rotation",
       [](Misuse& m) {
         const std::vector<float> turns = {0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0};
         const Span<float> scratch = m.room<float>(turns.size()), out = m.out<float>(4);
         m.returned(bezier_rotation(m.in(turns, Length::any), m.number(0.5f), scratch, out));
       }},
      {"bicubic_patch",
       [](Misuse& m) {
         std::vector<float> points;
         for (int i = 0; i < 48; ++i) points.push_back(kValues[static_cast<std::size_t>(i) % kValues.size()]);
         const Span<float> out = m.out<float>(3);
         m.returned(bicubic_patch(m.kind(PatchBasis::catmull_rom), m.in(points), m.index(3), m.number(0.5f),
                                  m.number(0.25f), out));
       }},
      {"make_arc_length",
       [](Misuse& m) {
         const Span<float> out = m.out<float>(arc_length_count(4, 8));
         m.returned(make_arc_length(curve_of(m), m.index(8), out));
       }},
      {"time_at_distance",
       [](Misuse& m) {
         std::vector<float> lengths(arc_length_count(4, 8));
         for (std::size_t i = 0; i < lengths.size(); ++i) lengths[i] = static_cast<float>(i);
         float& out = m.one(0.0f);
         m.returned(time_at_distance(curve_of(m), {m.index(8), m.in(lengths)}, m.number(11.5f), out));
       }},
      {"ease", [](Misuse& m) { m.returned(ease(m.kind(Easing::elastic), m.kind(EaseMode::in_out), m.number(0.3f))); }},
      {"ease",
       [](Misuse& m) {
         float& out = m.one(0.0f);
         m.returned(ease({m.number(0.2f), m.number(0), m.number(0.5f), m.number(1)}, m.number(0.3f), out));
       }},
  };
}

}  // namespace marrow::test
