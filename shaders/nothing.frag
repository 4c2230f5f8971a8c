// OpenGL ES links no program without a fragment stage; this one never runs.
precision mediump float;
out vec4 colour;

void main() {
  colour = vec4(0.0);
}
