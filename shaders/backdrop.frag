// The empty studio: a backdrop that is lighter behind the character, and a ground with its shadow that fades into it.
uniform mat4 model_from_clip;
uniform vec3 scene_centre;  // of the character
in vec2 position_clip;
out vec4 frag_colour;

// Seen from the character's height the light falls off round it; corners stay dark.
vec3 backdrop(vec2 p) {
  vec2 q = (p - vec2(0.05, 0.0)) * vec2(0.9, 0.8);
  vec3 low = vec3(0.033, 0.052, 0.078);
  vec3 high = vec3(0.235, 0.315, 0.36);
  return mix(low, high, exp(-dot(q, q)));
}

// How much sky the ground sees, 0 … 1: what stands within reach above it, counted less the higher it is.
float ground_openness(vec3 position, float turn) {
  vec3 p = (sky_from_model * vec4(position, 1.0)).xyz;
  float reach = 0.28 * scene_radius / sky_extent.x;
  float closed = 0.0;
  for (int i = 0; i < 24; ++i) {
    vec2 at = p.xy + reach * sunflower(i, 24, turn);
    if (any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)))) continue;
    float gap = (textureLod(sky_depth, at, 0.0).r - p.z) * -sky_extent.y / scene_radius;
    if (gap > 0.0) closed += exp(-gap * 5.0);
  }
  return 1.0 - 0.85 * closed / 24.0;
}

void main() {
  vec4 far_point = model_from_clip * vec4(position_clip, 1.0, 1.0);
  vec3 ray = normalize(far_point.xyz / far_point.w - camera_position);
  vec3 back = backdrop(position_clip);
  vec3 colour = back;
  float t = (ground_height - camera_position.y) / ray.y;
  if (t > 0.0) {
    vec3 ground = camera_position + t * ray;
    float away = length(ground.xz - scene_centre.xz) / scene_radius;
    float there = exp(-0.22 * away * away);
    if (there > 0.002) {
      float turn = noise(gl_FragCoord.xy);
      float visible = key_visibility(ground, 0.16, 0.002 * scene_radius, turn);
      float open = ground_openness(ground, turn);
      vec3 albedo = vec3(0.40, 0.37, 0.335);
      vec3 light = kKeyColour / 3.14159 * 1.1 * visible * key_direction.y + kSkyColour * 0.75 * open * open;
      colour = mix(back, film(albedo * light), there);
    }
  }
  frag_colour = vec4(dither(colour, gl_FragCoord.xy), 1.0);
}
