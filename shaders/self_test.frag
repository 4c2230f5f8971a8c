// The bits of a point into a texture of integers.
precision highp float;
precision highp int;
flat in uvec4 bits;
out uvec4 value;

void main() {
  value = bits;
}
