// A path through four points at an even speed, and easings.
// $ curves
#include <marrow/curve.h>

#include <cstdio>

using marrow::Status;

int main() {
  // Four keys of three numbers, a second apart.
  const float times_s[] = {0, 1, 2, 3};
  const float points[] = {0, 0, 0, 1, 1, 0, 2, 0, 0, 4, 0, 0};
  const marrow::Curve keys{.kind = marrow::CurveKind::linear, .components = 3, .times_s = times_s, .values = points};
  if (check_curve(keys) != Status::ok) return 1;  // once, where keys come from outside

  // Once: tangents that make speed and acceleration continuous.
  float hermite[marrow::curve_value_count(marrow::CurveKind::hermite, 3, 4)];
  if (natural_spline(keys, hermite) != Status::ok) return 1;
  marrow::Curve path = keys;
  path.kind = marrow::CurveKind::hermite;
  path.values = hermite;

  // Any time: a place and a speed.
  float place[3], velocity[3];
  if (evaluate_curve(path, 1.5f, place) != Status::ok || curve_velocity(path, 1.5f, velocity) != Status::ok) return 1;
  std::printf("at 1.5 s: %.4f %.4f, moving by %.4f %.4f a second\n", double(place[0]), double(place[1]),
              double(velocity[0]), double(velocity[1]));

  // Once: how long the path is. Then any distance gives a time.
  float lengths[marrow::arc_length_count(4, 8)];
  if (make_arc_length(path, 8, lengths) != Status::ok) return 1;
  const marrow::ArcLength table{.steps = 8, .lengths = lengths};
  const float whole = lengths[marrow::arc_length_count(4, 8) - 1];
  std::printf("the path is %.3f m long\n", double(whole));
  for (int quarter = 1; quarter < 4; ++quarter) {
    float time_s = 0;
    if (time_at_distance(path, table, whole * float(quarter) / 4, time_s) != Status::ok) return 1;
    if (evaluate_curve(path, time_s, place) != Status::ok) return 1;
    std::printf("after %d quarters: %.3f %.3f at %.3f s\n", quarter, double(place[0]), double(place[1]),
                double(time_s));
  }

  // Easings: from 0 to 1, by name or as CSS has them.
  float css = 0;
  if (ease(marrow::CubicBezierEase{.x1 = 0.42f, .y1 = 0, .x2 = 0.58f, .y2 = 1}, 0.5f, css) != Status::ok) return 1;
  std::printf("half way: quad in %.2f, cubic in and out %.2f, CSS ease-in-out %.2f\n",
              double(ease(marrow::Easing::quad, marrow::EaseMode::in, 0.5f)),
              double(ease(marrow::Easing::cubic, marrow::EaseMode::in_out, 0.5f)), double(css));
}

// Prints:
//   at 1.5 s: 1.4250 0.5750, moving by 0.9167 -1.2500 a second
//   the path is 4.936 m long
//   after 1 quarters: 0.777 0.950 at 0.755 s
//   after 2 quarters: 1.666 0.273 at 1.739 s
//   after 3 quarters: 2.775 -0.154 at 2.439 s
//   half way: quad in 0.25, cubic in and out 0.50, CSS ease-in-out 0.50
