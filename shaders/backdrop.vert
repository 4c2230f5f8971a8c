// One triangle over the whole picture, at the far plane.
out vec2 position_clip;

void main() {
  position_clip = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(position_clip, 1.0, 1.0);
}
