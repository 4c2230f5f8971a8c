// The panel of `marrow view`; colours are sRGB, as the window's are.
precision mediump float;

uniform sampler2D font;
in vec2 uv;
in vec4 colour;
out vec4 frag_colour;

void main() {
  frag_colour = colour * texture(font, uv);
}
