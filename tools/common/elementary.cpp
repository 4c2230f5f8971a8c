#include "common/elementary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace marrow::tools {
namespace {

// c[0] + y (c[1] + y (…)).
template <std::size_t N>
double horner(const double (&c)[N], double y) {
  double sum = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) sum = c[i] + y * sum;
  return sum;
}

// The three fits are those of fdlibm (Sun Microsystems, 1993).

// Up to π/4 either way.
double sine_near_0(double x) {
  constexpr double kFit[] = {-1.66666666666666324348e-01, 8.33333333332248946124e-03,  -1.98412698298579493134e-04,
                             2.75573137070700676789e-06,  -2.50507602534068634195e-08, 1.58969099521155010221e-10};
  const double y = x * x;
  return x + x * y * horner(kFit, y);
}
double cosine_near_0(double x) {
  constexpr double kFit[] = {4.16666666666666019037e-02,  -1.38888888888741095749e-03, 2.48015872894767294178e-05,
                             -2.75573143513906633035e-07, 2.08757232129817482790e-09,  -1.13596475577881948265e-11};
  const double y = x * x, half = y / 2, most = 1 - half;
  return most + (((1 - most) - half) + y * y * horner(kFit, y));
}

// The sine of x and of `quarters` quarters of a turn more.
double sine_of_sum(double x, double quarters) {
  constexpr double kTwoPi = 6.283185307179586, kPerQuarter = 0.6366197723675814;
  // A quarter of a turn in parts of 33 bits, so that products with 20 are exact.
  constexpr double kPart1 = 1.57079632673412561417e+00, kPart2 = 6.07710050630396597660e-11,
                   kPart3 = 2.02226624879595063154e-21;
  if (std::abs(x) > 1e5) x = std::fmod(x, kTwoPi);  // exact
  const double n = std::floor(x * kPerQuarter + 0.5);
  const double rest = ((x - n * kPart1) - n * kPart2) - n * kPart3;
  const double all = n + quarters, quadrant = all - 4 * std::floor(all / 4);
  const double size = quadrant == 1 || quadrant == 3 ? cosine_near_0(rest) : sine_near_0(rest);
  return quadrant >= 2 ? -size : size;
}

// Of 0 and above.
double arc_tangent(double x) {
  constexpr double kFit[] = {3.33333333333329318027e-01,  -1.99999999998764832476e-01, 1.42857142725034663711e-01,
                             -1.11111104054623557880e-01, 9.09088713343650656196e-02,  -7.69187620504482999495e-02,
                             6.66107313738753120669e-02,  -5.83357013379057348645e-02, 4.97687799461593236017e-02,
                             -3.65315727442169155270e-02, 1.62858201153657823623e-02};
  // The angle to begin from, with what a double leaves of it, and its tangent.
  struct From {
    double most, angle, rest, tangent;
  };
  constexpr From kFrom[] = {{0.4375, 0, 0, 0},
                            {0.6875, 4.63647609000806093515e-01, 2.26987774529616870924e-17, 0.5},
                            {1.1875, 7.85398163397448278999e-01, 3.06161699786838301793e-17, 1},
                            {2.4375, 9.82793723247329054082e-01, 1.39033110312309984516e-17, 1.5}};
  From from{0, 1.57079632679489655800e+00, 6.12323399573676603587e-17, 0};
  double y = -1 / x;
  for (const From& f : kFrom) {
    if (!(x < f.most)) continue;
    from = f;
    y = (x - f.tangent) / (1 + f.tangent * x);
    break;
  }
  const double z = y * y;
  return from.angle - ((y * z * horner(kFit, z) - from.rest) - y);
}

// e^x - 1 up to half of ln 2 either way: Taylor's series.
double less_1_near_0(double x) {
  constexpr double kSeries[] = {1.0,
                                1.0 / 2,
                                1.0 / 6,
                                1.0 / 24,
                                1.0 / 120,
                                1.0 / 720,
                                1.0 / 5040,
                                1.0 / 40320,
                                1.0 / 362880,
                                1.0 / 3628800,
                                1.0 / 39916800,
                                1.0 / 479001600,
                                1.0 / 6227020800.0,
                                1.0 / 87178291200.0};
  return x * horner(kSeries, x);
}

}  // namespace

double sine(double x) {
  return sine_of_sum(x, 0);
}

double cosine(double x) {
  return sine_of_sum(x, 1);
}

double angle_of(double y, double x) {
  constexpr double kPi = 3.141592653589793, kRest = 1.2246467991473532e-16;
  if (x == 0 && y == 0) return 0;
  const double acute = arc_tangent(std::abs(y) / std::abs(x));
  const double angle = x < 0 ? kPi - (acute - kRest) : acute;
  return y < 0 ? -angle : angle;
}

double arc_cosine(double x) {
  return angle_of(std::sqrt((1 - x) * (1 + x)), x);
}

double exponential(double x) {
  constexpr double kPerTwofold = 1.4426950408889634, kTwofold = 6.93147180369123816490e-01,
                   kTwofoldRest = 1.90821492927058770002e-10;
  if (x < -746) return 0;
  if (x > 710) return std::numeric_limits<double>::infinity();
  if (x != x) return x;
  const double n = std::floor(x * kPerTwofold + 0.5);
  return std::ldexp(1 + less_1_near_0((x - n * kTwofold) - n * kTwofoldRest), static_cast<int>(n));
}

double exponential_less_1(double x) {
  constexpr double kHalfTwofold = 0.34657359;
  return std::abs(x) < kHalfTwofold ? less_1_near_0(x) : exponential(x) - 1;
}

double cube_root(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // from a half to 1
  for (; exponent % 3 != 0; ++exponent) m /= 2;
  double root = 0.37 + 0.66 * m;  // within a sixth
  for (int i = 0; i < 6; ++i) root -= (root - m / (root * root)) / 3;
  return std::ldexp(root, exponent / 3);
}

double length_of(double a, double b, double c, double d) {
  int exponent = 0;
  std::frexp(std::max({std::abs(a), std::abs(b), std::abs(c), std::abs(d)}), &exponent);
  double sum = 0;
  for (const double x : {a, b, c, d}) {
    const double part = std::ldexp(x, -exponent);
    sum += part * part;
  }
  return std::ldexp(std::sqrt(sum), exponent);
}

}  // namespace marrow::tools
