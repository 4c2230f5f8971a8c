// Lines and see-through faces among the figures; colours are linear.
precision mediump float;

in vec4 colour;
out vec4 frag_colour;

void main() {
  frag_colour = colour;
}
