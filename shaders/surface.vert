// A character's vertices for the camera: skinned position and normal, colour and texture coordinates passed on.
uniform mat4 clip_from_model;

out vec3 position_scene;
#if MARROW_NORMAL
out vec3 normal_scene;
#endif
#if MARROW_UV
out vec2 uv;
#endif
#if MARROW_COLOUR || MARROW_PALETTES == 2
out vec4 vertex_colour;
#endif

void main() {
  MarrowVertex v = marrow_skin();
  position_scene = v.position;
#if MARROW_NORMAL
  normal_scene = v.normal;
#endif
#if MARROW_UV
  uv = in_uv;
#endif
#if MARROW_COLOUR || MARROW_PALETTES == 2
  vertex_colour = marrow_instance_colour();
#if MARROW_COLOUR
  vertex_colour *= in_colour;
#endif
#endif
  gl_Position = clip_from_model * vec4(v.position, 1.0);
}
