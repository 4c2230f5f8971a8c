// A character's vertices for a light: positions alone.
uniform mat4 clip_from_scene;

void main() {
  gl_Position = clip_from_scene * vec4(marrow_skin().position, 1.0);
}
