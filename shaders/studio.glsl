// The photographer's studio that surface.frag and backdrop.frag share: lights, shadow maps, film.
//
// Colours are linear; the frame buffer encodes sRGB. Directions are unit and point towards the light, model space.
precision highp float;
precision highp sampler2DShadow;

uniform vec3 camera_position;
uniform float scene_radius;   // of the character, scene units
uniform float ground_height;  // y of the ground, scene units
uniform vec3 key_direction;
uniform mat4 key_from_model;  // → [0, 1]³ of the shadow map
uniform vec2 key_extent;      // scene units: width of the map, depth of its range
uniform mat4 sky_from_model;  // the same, straight down: what keeps the sky from the ground
uniform vec2 sky_extent;
uniform sampler2DShadow key_shadow;
uniform sampler2D key_depth;
uniform sampler2D sky_depth;

const vec3 kKeyColour = vec3(3.6, 3.1, 2.5);
const vec3 kSkyColour = vec3(0.36, 0.47, 0.62);
const vec3 kBounceColour = vec3(0.40, 0.29, 0.21);

// Interleaved gradient noise (Jimenez, "Next generation post processing in Call of Duty", 2014): 0 … 1.
float noise(vec2 pixel) {
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
}

// Point i of n of a sunflower pattern in the unit disc.
vec2 sunflower(int i, int n, float turn) {
  float radius = sqrt((float(i) + 0.5) / float(n));
  float angle = 2.39996323 * float(i) + 6.2831853 * turn;
  return radius * vec2(cos(angle), sin(angle));
}

// How much of the key light arrives, 0 … 1. The penumbra widens with the distance to what casts the shadow.
// softness: tangent of the light's angular radius. bias: scene units.
float key_visibility(vec3 position, float softness, float bias, float turn) {
  vec3 p = (key_from_model * vec4(position, 1.0)).xyz;
  if (any(lessThan(p.xy, vec2(0.0))) || any(greaterThan(p.xy, vec2(1.0)))) return 1.0;
  float depth = p.z - bias / key_extent.y;  // above 1 on the ground behind the character: still in its shadow
  float compared = min(depth, 1.0);         // where nothing was drawn the map says 1
  float search = softness * scene_radius / key_extent.x;
  float blockers = 0.0;
  float blocker_depth = 0.0;
  for (int i = 0; i < 16; ++i) {
    float d = textureLod(key_depth, p.xy + search * sunflower(i, 16, turn), 0.0).r;
    if (d < compared) {
      blockers += 1.0;
      blocker_depth += d;
    }
  }
  if (blockers == 0.0) return 1.0;
  float gap = (depth - blocker_depth / blockers) * key_extent.y;
  float radius = clamp(softness * gap, 0.004 * scene_radius, softness * scene_radius) / key_extent.x;
  float light = 0.0;
  for (int i = 0; i < 32; ++i) {
    light += textureLod(key_shadow, vec3(p.xy + radius * sunflower(i, 32, turn), compared), 0.0);
  }
  return light / 32.0;
}

// Film: a toe that keeps shadows deep and a shoulder that lets highlights burn out slowly (Narkowicz, "ACES filmic tone
// mapping curve", 2015).
vec3 film(vec3 colour) {
  vec3 c = 0.72 * colour;
  return clamp(c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0);
}

// Breaks up the bands of slow gradients: half a step of the 8-bit sRGB frame buffer, in linear light.
vec3 dither(vec3 colour, vec2 pixel) {
  return colour + (noise(pixel + 17.0) - 0.5) / 255.0 * (2.2 * pow(max(colour, vec3(0.0)), vec3(0.55)) + 0.01);
}
