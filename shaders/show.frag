// A finished picture, at any size, into a window whose frame buffer does not encode sRGB by itself.
precision highp float;

uniform sampler2D picture;
in vec2 position_clip;
out vec4 frag_colour;

void main() {
  vec3 linear = texture(picture, 0.5 * position_clip + 0.5).rgb;
  vec3 encoded = mix(1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
  frag_colour = vec4(encoded, 1.0);
}
