// Weights of spherical linear interpolation without trigonometry from a library, so that every processor gets the same.
#pragma once

namespace marrow {

// sin(√y) / √y for y in [0, (π/2)²], within 5e-9. Minimax fit of degree 4.
inline float sinc_of_square(float y) {
  return 0.999999996f + y * (-0.166666580f + y * (8.33305098e-3f + y * (-1.98090690e-4f + y * 2.60521026e-6f)));
}

// asin(√z) / √z for z in [0, ½], within 1.1e-7. Minimax fit of degree 6.
inline float asinc_of_square(float z) {
  return 1.00000011f +
         z * (0.16664676f +
              z * (0.07559077f + z * (0.03815005f + z * (0.06348833f + z * (-0.05957173f + z * 0.10395446f)))));
}

struct SlerpWeights {
  float a, b;
};

// The weights of unit quaternions a and b at u in [0, 1], from the squared length of b - a (at most 2: the shorter
// arc): sin((1-u) θ) / sin θ and sin(u θ) / sin θ with sin(θ/2) = |b - a| / 2, all as even functions of θ, which leaves
// nothing to divide by zero at θ = 0. The angle is off by at most 4e-7 of itself.
inline SlerpWeights slerp_weights(float chord_squared, float u) {
  const float half = asinc_of_square(0.25f * chord_squared);
  const float angle_squared = chord_squared * half * half;
  const float v = 1.0f - u;
  const float whole = sinc_of_square(angle_squared);
  return {v * sinc_of_square(v * v * angle_squared) / whole, u * sinc_of_square(u * u * angle_squared) / whole};
}

}  // namespace marrow
