// Lines and see-through faces among the figures: points of the scene, in colours of their own.
uniform mat4 clip_from_model;
uniform float nearer;  // share of the depth by which they are before the surface that they lie on
out vec4 colour;

void main() {
  colour = in_colour;
  gl_Position = clip_from_model * vec4(in_position.xyz, 1.0);
  gl_Position.z -= nearer * gl_Position.w;
}
