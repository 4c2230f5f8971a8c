// Palettes of a crowd at a moment: a fragment is a row of a matrix of an instance, its float's bits.
//
// Instances and the arithmetic of their times: runtime/gles3/crowd/; crowd_instance.cpp does the same on the CPU.
precision highp float;
precision highp int;

uniform highp sampler2D marrow_palettes;    // of every frame
uniform highp usampler2D marrow_instances;  // eight texels each
// Ticks of the clock; rows of a palette; instances end before this one, and begin with this.
uniform int marrow_crowd[4];
layout(location = 0) out uvec4 bits;

uvec4 instance_texel(int instance, int texel) {
  return texelFetch(marrow_instances, ivec2((instance & 255) * 8 + texel, instance >> 8), 0);
}

vec4 frame_row(int i) {
  return texelFetch(marrow_palettes, ivec2(i & 2047, i >> 11), 0);
}

// The first row of the frame where a clip is, and the share of the way to the next.
// clock: start, phase, rate; its lowest 16 bits and steps. range: limits of the ticks passed, first frame.
int place(uvec4 clock, uvec3 range, out float share) {
  int passed = clamp(marrow_crowd[0] - int(clock.x), int(range.x), int(range.y));
  uint ticks = uint(passed);
  uint low = clock.w & 0xFFFFu;
  uint steps = clock.w >> 16;
  uint at_share = clock.y + clock.z * ticks + low * uint(passed >> 16) + (low * (ticks & 0xFFFFu) >> 16);
  uint at = (at_share >> 16) * steps + ((at_share & 0xFFFFu) * steps >> 16);
  share = float(at & 0xFFFFu) * (1.0 / 65536.0);
  return int(range.z + (at >> 16)) * marrow_crowd[1];
}

// Adds a matrix, given by the texel of its first row.
void add(int row, float share, inout vec4 x, inout vec4 y, inout vec4 z) {
  if (share == 0.0) return;
  x += share * frame_row(row);
  y += share * frame_row(row + 1);
  z += share * frame_row(row + 2);
}

void main() {
  int texel = int(gl_FragCoord.y) * 2048 + int(gl_FragCoord.x);
  int instance = texel / marrow_crowd[1];
  if (instance >= marrow_crowd[2] || instance < marrow_crowd[3]) discard;
  int row = texel - instance * marrow_crowd[1];
  int first = row / 3 * 3;

  uvec4 range_a = instance_texel(instance, 5);
  uvec4 range_b = instance_texel(instance, 7);
  float blend = clamp(float(marrow_crowd[0] - int(range_a.w)) * uintBitsToFloat(range_b.w), 0.0, 1.0);
  vec4 x = vec4(0.0);
  vec4 y = vec4(0.0);
  vec4 z = vec4(0.0);
  float share;
  if (blend < 1.0) {
    int at = place(instance_texel(instance, 4), range_a.xyz, share) + first;
    add(at, (1.0 - blend) * (1.0 - share), x, y, z);
    add(at + marrow_crowd[1], (1.0 - blend) * share, x, y, z);
  }
  if (blend > 0.0) {
    int at = place(instance_texel(instance, 6), range_b.xyz, share) + first;
    add(at, blend * (1.0 - share), x, y, z);
    add(at + marrow_crowd[1], blend * share, x, y, z);
  }
  vec4 placed = uintBitsToFloat(instance_texel(instance, row - first));
  bits = floatBitsToUint(placed.x * x + placed.y * y + placed.z * z + vec4(0.0, 0.0, 0.0, placed.w));
}
