// The panel of `marrow view`: points of the window → clip space.
uniform vec4 window;  // upper left corner and size, points
out vec2 uv;
out vec4 colour;

void main() {
  uv = in_uv;
  colour = in_colour;
  vec2 p = (in_position.xy - window.xy) / window.zw;
  gl_Position = vec4(2.0 * p.x - 1.0, 1.0 - 2.0 * p.y, 0.0, 1.0);
}
