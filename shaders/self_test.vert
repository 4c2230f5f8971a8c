// A slot's vertex as a point at a pixel of its own, bit for bit: what the self-test reads back.
uniform vec4 self_test;  // row of the first instance; what: 0 position, 1 normal, 2 tangent; pixels of a row, rows
flat out uvec4 bits;

void main() {
  MarrowVertex v = marrow_skin();
  vec4 values = vec4(v.position, 1.0);
  if (self_test.y > 0.5) values = vec4(v.normal, 0.0);
  if (self_test.y > 1.5) values = v.tangent;
  bits = floatBitsToUint(values);
  vec2 pixel = vec2(float(gl_VertexID), self_test.x + float(gl_InstanceID)) + 0.5;
  gl_Position = vec4(2.0 * pixel / self_test.zw - 1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}
