// Nothing but depth, and none where a texture has holes.
precision highp float;

#if MARROW_UV
uniform highp sampler2D base_texture;
uniform vec4 base_colour;
uniform vec2 alpha_range;  // what is less opaque than x casts no shadow
in vec2 uv;
#endif

void main() {
#if MARROW_UV
  if (base_colour.a * texture(base_texture, uv).a < alpha_range.x) discard;
#endif
}
