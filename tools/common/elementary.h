// Sine, arc tangent, exponential and their like in double precision without a library: sums, products, quotients and
// roots only, which are the same bits everywhere. What decides a cooked file's bytes calls these; those of C libraries
// differ in the last bit. Compiled without contracted products.
#pragma once

namespace marrow::tools {

// Within 3e-16 up to 1e5; beyond, of an argument that is wrong by less than half its last place. What is not finite
// gives NaN.
double sine(double x);
double cosine(double x);
// atan2: the angle of (x, y), within 5e-16; 0 for the origin.
double angle_of(double y, double x);
// Of a number from -1 to 1, within 5e-16.
double arc_cosine(double x);
// e^x within 4e-16 of itself where that is no denormal number, and e^x - 1 for all x, within 8e-16 of itself.
double exponential(double x);
double exponential_less_1(double x);
// Of a finite number above 0, within 4e-16 of itself.
double cube_root(double x);
// √(a² + b² + c² + d²) without overflow in between, within 5e-16 of itself.
double length_of(double a, double b, double c, double d);

}  // namespace marrow::tools
