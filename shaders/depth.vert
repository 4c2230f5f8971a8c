// A character's vertices for a light: positions, and where its texture has holes.
uniform mat4 clip_from_model;

#if MARROW_UV
out vec2 uv;
#endif

void main() {
#if MARROW_UV
  uv = in_uv;
#endif
  gl_Position = clip_from_model * vec4(marrow_skin().position, 1.0);
}
