// Skinning ahead of drawing, by transform feedback: what the skinning text gives, a vertex each.
out vec3 out_position;
#if MARROW_NORMAL
out vec3 out_normal;
#endif
#if MARROW_TANGENT
out vec4 out_tangent;
#endif

void main() {
  MarrowVertex v = marrow_skin();
  out_position = v.position;
#if MARROW_NORMAL
  out_normal = v.normal;
#endif
#if MARROW_TANGENT
  out_tangent = v.tangent;
#endif
  gl_Position = vec4(v.position, 1.0);
  gl_PointSize = 1.0;
}
