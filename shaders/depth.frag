// Nothing but depth.
precision highp float;

void main() {
}
