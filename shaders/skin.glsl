// The skinning arithmetic of every vertex shader: attributes and palette → deformed position, normal and tangent.
//
// The host puts `#version` and the MARROW_* defines before this text and a role's main() after it (runtime/gles3/program.cpp).
//   MARROW_DEFORMER        0 none (already skinned on the CPU), 1 rigid, 2 SSD, 3 animation space
//   MARROW_POSE_SPACE      1: SSD of what the examples of a pose space have moved
//   MARROW_INFLUENCES      4 to 8
//   MARROW_NORMAL, _TANGENT, _UV, _COLOUR  0 or 1: which attributes the mesh has
//   MARROW_MORPH_TARGETS   how many morph targets may count at a time; 0: none, the mesh has none
//   MARROW_SURFACE_NORMALS 1: animation space has tangents as vectors, and normals are the deformed surface's own
//   MARROW_PALETTES        0 in a uniform block, 1 in a texture, 2 in one that crowd.frag has written
//   MARROW_PALETTE_JOINTS  matrices in the uniform block; 48 bytes each
//   MARROW_COMPUTE         1: vertices are read from storage buffers, by the text of pre-skinning
//   MARROW_WORDS           animation space is read as words, two numbers each: 1; 2: y and z are the whole word; 3: that
//                          holds for tangents alone
//   MARROW_GPU             1 Mali-G, 2 Mali-T, 3 Adreno, 0 another: GpuFamily
//   MARROW_MOTION          1: where the vertex was in the frame before, too
//
// Positions arrive in the unit box [-1, 1]³ and nothing here undoes that: the palette's bind matrices do
// (GpuMesh::bind). Rows of vec4, never mat4: some drivers pad or transpose arrays of matrices.
precision highp float;
precision highp int;

// An attribute; in a compute shader a variable that main() fills in.
#if MARROW_COMPUTE
#define MARROW_IN(Location)
#else
#define MARROW_IN(Location) layout(location = Location) in
#endif

#if MARROW_DEFORMER == 3
// Each influence's q, (x, y, z, w), Σ w = 1 / marrow_coordinate_scale. With the surface's own normals its τ of the first
// tangent and of the second, Σ w = 0, in any unit; the last w is what the others leave, and in its place in the first
// tangent is the handedness of the texture's triad.
uniform float marrow_coordinate_scale;
#define MARROW_COORDINATE_WORDS (MARROW_WORDS && (MARROW_WORDS < 3 || MARROW_COMPUTE))
#if MARROW_WORDS
// All q, if they are words, all τ of the first tangent, all of the second. A pair of words is a vector, of numbers in
// steps of 1 / 32767.
#if MARROW_COMPUTE
uvec2 marrow_words(int pair);  // the text of pre-skinning reads them, when they are wanted
#else
#if MARROW_COORDINATE_WORDS
MARROW_IN(0) uvec4 in_words0;
MARROW_IN(1) uvec4 in_words1;
MARROW_IN(2) uvec4 in_words2;
MARROW_IN(3) uvec4 in_words3;
#if MARROW_SURFACE_NORMALS
MARROW_IN(4) uvec4 in_words4;
MARROW_IN(5) uvec4 in_words5;
MARROW_IN(6) uvec4 in_words6;
MARROW_IN(7) uvec4 in_words7;
MARROW_IN(10) uvec4 in_words8;
MARROW_IN(11) uvec4 in_words9;
MARROW_IN(14) uvec4 in_words10;
MARROW_IN(15) uvec4 in_words11;
#endif
#else
MARROW_IN(6) uvec4 in_words0;
MARROW_IN(7) uvec4 in_words1;
MARROW_IN(10) uvec4 in_words2;
MARROW_IN(11) uvec4 in_words3;
MARROW_IN(14) uvec4 in_words4;
MARROW_IN(15) uvec4 in_words5;
#endif
uvec2 marrow_words(int pair) {
  int i = pair / 2;
  uvec4 of_two = i == 0 ? in_words0 : i == 1 ? in_words1 : i == 2 ? in_words2 : in_words3;
#if MARROW_SURFACE_NORMALS
  if (i > 3) of_two = i == 4 ? in_words4 : in_words5;
#if MARROW_COORDINATE_WORDS
  if (i > 5) of_two = i == 6 ? in_words6 : i == 7 ? in_words7 : i == 8 ? in_words8 : in_words9;
  if (i > 9) of_two = i == 10 ? in_words10 : in_words11;
#endif
#endif
  return pair % 2 == 0 ? of_two.xy : of_two.zw;
}
#endif
vec4 marrow_numbers(int pair) {
  ivec2 words = ivec2(marrow_words(pair));
  return vec4(words.x << 16 >> 16, words.x >> 16, words.y << 16 >> 16, words.y >> 16);
}
// w stands before z, and y and z have what is below them behind their point.
vec4 marrow_whole_numbers(int pair) {
  ivec2 words = ivec2(marrow_words(pair));
  ivec2 lower = words << 16;
  return vec4(lower.x, words, lower.y);
}
#endif

#if MARROW_COORDINATE_WORDS
#define MARROW_FIRST_PAIR MARROW_INFLUENCES
#if MARROW_WORDS == 2
#define MARROW_STEP (1.0 / 32767.0 / 65536.0)
vec4 marrow_share(int i) {
  return marrow_whole_numbers(i);
}
#else
#define MARROW_STEP (1.0 / 32767.0)
vec4 marrow_share(int i) {
  return marrow_numbers(i);
}
#endif
#else
#define MARROW_STEP 1.0
#define MARROW_FIRST_PAIR 0
MARROW_IN(0) vec4 in_coordinate0;
MARROW_IN(1) vec4 in_coordinate1;
MARROW_IN(2) vec4 in_coordinate2;
MARROW_IN(3) vec4 in_coordinate3;
#if MARROW_INFLUENCES > 4
MARROW_IN(4) vec4 in_coordinate4;
MARROW_IN(5) vec4 in_coordinate5;
#endif
#if MARROW_INFLUENCES > 6
MARROW_IN(6) vec4 in_coordinate6;
MARROW_IN(7) vec4 in_coordinate7;
#endif
vec4 marrow_share(int i) {
#if MARROW_INFLUENCES > 6
  if (i > 5) return i == 6 ? in_coordinate6 : in_coordinate7;
#endif
#if MARROW_INFLUENCES > 4
  if (i > 3) return i == 4 ? in_coordinate4 : in_coordinate5;
#endif
  return i == 0 ? in_coordinate0 : i == 1 ? in_coordinate1 : i == 2 ? in_coordinate2 : in_coordinate3;
}
#endif

#if MARROW_SURFACE_NORMALS
#if MARROW_WORDS
#if MARROW_WORDS == 1
#define MARROW_TANGENT_STEP (1.0 / 32767.0)
#define marrow_tangent_numbers marrow_numbers
#else
#define MARROW_TANGENT_STEP (1.0 / 32767.0 / 65536.0)
#define marrow_tangent_numbers marrow_whole_numbers
#endif
vec4 marrow_first(int i) {
  return marrow_tangent_numbers(MARROW_FIRST_PAIR + i);
}
vec4 marrow_second(int i) {
  return marrow_tangent_numbers(MARROW_FIRST_PAIR + MARROW_INFLUENCES + i);
}
#else
#define MARROW_TANGENT_STEP 1.0
MARROW_IN(4) vec4 in_first0;
MARROW_IN(5) vec4 in_first1;
MARROW_IN(6) vec4 in_first2;
MARROW_IN(7) vec4 in_first3;
MARROW_IN(9) vec4 in_second0;
MARROW_IN(10) vec4 in_second1;
MARROW_IN(11) vec4 in_second2;
MARROW_IN(15) vec4 in_second3;
vec4 marrow_first(int i) {
  return i == 0 ? in_first0 : i == 1 ? in_first1 : i == 2 ? in_first2 : in_first3;
}
vec4 marrow_second(int i) {
  return i == 0 ? in_second0 : i == 1 ? in_second1 : i == 2 ? in_second2 : in_second3;
}
#endif
#endif
#else
#if MARROW_DEFORMER == 2
// Weights from the second on; the first one's is what they leave.
MARROW_IN(0) vec4 in_position;  // w: the second
MARROW_IN(1) vec4 in_weights0;  // the third to the sixth
#if MARROW_INFLUENCES > 6
MARROW_IN(2) vec2 in_weights1;
#endif
#else
MARROW_IN(0) vec3 in_position;
#if MARROW_DEFORMER == 0 && MARROW_MOTION
MARROW_IN(1) vec3 in_previous_position;
#endif
#endif
#endif

#if MARROW_DEFORMER != 0
// Palette entries; the largest weight comes first.
#if MARROW_GPU == 1 && MARROW_INFLUENCES > 4 && !MARROW_COMPUTE
// Mali-G pays for attributes: eight joints in one, each two beside each other in a number.
MARROW_IN(8) uvec4 in_joint_pairs;
uniform ivec2 marrow_joint_bits;  // of a joint; and all of them set
uvec4 marrow_joints(uvec2 pairs) {
  return uvec4(pairs.x, pairs.x >> marrow_joint_bits.x, pairs.y, pairs.y >> marrow_joint_bits.x) &
         uint(marrow_joint_bits.y);
}
#define in_joints0 marrow_joints(in_joint_pairs.xy)
#define in_joints1 marrow_joints(in_joint_pairs.zw)
#else
MARROW_IN(8) uvec4 in_joints0;
#if MARROW_INFLUENCES > 4 && MARROW_DEFORMER != 1
MARROW_IN(9) uvec4 in_joints1;
#endif
#endif
#if MARROW_DEFORMER == 2
// The weight of an influence; the first one's is what the others leave of 1.
float marrow_share(int i) {
  float others = in_position.w + in_weights0.x + in_weights0.y;
#if MARROW_INFLUENCES > 4
  others += in_weights0.z;
#endif
#if MARROW_INFLUENCES > 5
  others += in_weights0.w;
#endif
#if MARROW_INFLUENCES > 6
  others += in_weights1.x;
  if (i > 5) return i == 6 ? in_weights1.x : in_weights1.y;
#endif
#if MARROW_INFLUENCES > 7
  others += in_weights1.y;
#endif
#if MARROW_INFLUENCES > 4
  if (i > 3) return i == 4 ? in_weights0.z : in_weights0.w;
#endif
  return i == 0 ? 1.0 - others : i == 1 ? in_position.w : i == 2 ? in_weights0.x : in_weights0.y;
}
#elif MARROW_DEFORMER == 1
#define marrow_share(I) 1.0
#endif

// Do(i, joint) for each influence, by its number.
#if MARROW_DEFORMER == 1
#define MARROW_EACH(Do) Do(0, in_joints0.x)
#else
// Influences that a vertex does not have repeat its first joint. The branch also keeps compilers from reading all rows
// and words at once, for which some GPUs' registers are too few; elsewhere, and on Adreno, it would only cost.
#if MARROW_GPU == 3
#define MARROW_IF(Do, I, Joint) Do(I, Joint)
#else
#define MARROW_IF(Do, I, Joint) if (Joint != in_joints0.x) { Do(I, Joint) }
#endif
#if MARROW_DEFORMER == 3 && (MARROW_SURFACE_NORMALS || MARROW_INFLUENCES > 5) || \
    MARROW_GPU == 1 && MARROW_DEFORMER == 2 && MARROW_PALETTES == 1 && MARROW_TANGENT && MARROW_INFLUENCES == 5
#define MARROW_MORE(Do, I, Joint) MARROW_IF(Do, I, Joint)
#else
#define MARROW_MORE(Do, I, Joint) Do(I, Joint)
#endif
#define MARROW_FOUR_APART(Do)                        \
  Do(0, in_joints0.x) MARROW_IF(Do, 1, in_joints0.y) \
  MARROW_IF(Do, 2, in_joints0.z) MARROW_IF(Do, 3, in_joints0.w)
// Orders and branches by which registers spilled least. The first last wants fewer registers.
#if MARROW_GPU == 1 && MARROW_DEFORMER == 2 && MARROW_PALETTES == 2 && MARROW_TANGENT
#define MARROW_FOUR(Do) MARROW_FOUR_APART(Do)
#elif MARROW_GPU == 2 && MARROW_DEFORMER == 2 && \
    (MARROW_POSE_SPACE == 1 && MARROW_INFLUENCES > 4 && MARROW_INFLUENCES < 7 && MARROW_PALETTES + MARROW_COMPUTE == 1 || \
     MARROW_TANGENT == 1 && MARROW_INFLUENCES == 6 && MARROW_PALETTES == 1)
#define MARROW_FOUR(Do) Do(0, in_joints0.x) Do(1, in_joints0.y) Do(2, in_joints0.z) MARROW_IF(Do, 3, in_joints0.w)
#elif MARROW_DEFORMER == 2
#define MARROW_FOUR(Do) Do(1, in_joints0.y) Do(2, in_joints0.z) Do(3, in_joints0.w) Do(0, in_joints0.x)
#elif MARROW_SURFACE_NORMALS && MARROW_INFLUENCES > 4 && \
    (MARROW_GPU == 2 || MARROW_GPU == 0 && MARROW_PALETTES == 2 && MARROW_INFLUENCES > 5)
#define MARROW_FOUR(Do) \
  MARROW_IF(Do, 1, in_joints0.y) MARROW_IF(Do, 2, in_joints0.z) MARROW_IF(Do, 3, in_joints0.w) Do(0, in_joints0.x)
// The fourth is the last of four: its tangents have what the others leave.
#elif MARROW_SURFACE_NORMALS && MARROW_GPU == 0 && MARROW_PALETTES == 2 && MARROW_TANGENT && MARROW_INFLUENCES == 4
#define MARROW_FOUR(Do) \
  MARROW_IF(Do, 1, in_joints0.y) MARROW_IF(Do, 2, in_joints0.z) Do(0, in_joints0.x) MARROW_IF(Do, 3, in_joints0.w)
#elif MARROW_SURFACE_NORMALS && (MARROW_WORDS || MARROW_PALETTES == 2) || \
    MARROW_GPU == 2 && MARROW_PALETTES == 2 && MARROW_TANGENT
#define MARROW_FOUR(Do) MARROW_FOUR_APART(Do)
#else
#define MARROW_FOUR(Do) Do(0, in_joints0.x) Do(1, in_joints0.y) Do(2, in_joints0.z) Do(3, in_joints0.w)
#endif
#if MARROW_INFLUENCES == 4
#define MARROW_EACH(Do) MARROW_FOUR(Do)
#elif MARROW_INFLUENCES == 5
#define MARROW_EACH(Do) MARROW_FOUR(Do) MARROW_MORE(Do, 4, in_joints1.x)
#elif MARROW_INFLUENCES == 6
#define MARROW_EACH(Do) MARROW_FOUR(Do) MARROW_MORE(Do, 4, in_joints1.x) MARROW_MORE(Do, 5, in_joints1.y)
#elif MARROW_INFLUENCES == 7
#define MARROW_EACH(Do) \
  MARROW_FOUR(Do) MARROW_MORE(Do, 4, in_joints1.x) MARROW_MORE(Do, 5, in_joints1.y) MARROW_MORE(Do, 6, in_joints1.z)
#else
#define MARROW_EACH(Do)                                                             \
  MARROW_FOUR(Do) MARROW_MORE(Do, 4, in_joints1.x) MARROW_MORE(Do, 5, in_joints1.y) \
  MARROW_MORE(Do, 6, in_joints1.z) MARROW_MORE(Do, 7, in_joints1.w)
#endif
#endif

// Rows of a matrix of the palette: marrow_matrix(joint); of the frame before's, marrow_previous_matrix(joint).
struct MarrowMatrix {
  vec4 x, y, z;
};
#if MARROW_PALETTES == 0
layout(std140) uniform MarrowPalette {
  MarrowMatrix marrow_matrices[MARROW_PALETTE_JOINTS];
};
MarrowMatrix marrow_matrix(uint joint) {
  return marrow_matrices[joint];
}
#if MARROW_MOTION
layout(std140) uniform MarrowPreviousPalette {
  MarrowMatrix marrow_previous_matrices[MARROW_PALETTE_JOINTS];
};
MarrowMatrix marrow_previous_matrix(uint joint) {
  return marrow_previous_matrices[joint];
}
#endif
#else
#if MARROW_PALETTES == 2
#define MarrowPalettes highp usampler2D  // 2048 wide; a texel is a row, by the bits of its floats
#define marrow_floats(Texel) uintBitsToFloat(Texel)
#else
#define MarrowPalettes highp sampler2D  // 2048 wide; a texel is a row
#define marrow_floats(Texel) (Texel)
#endif
uniform MarrowPalettes marrow_palettes;
uniform ivec2 marrow_first_row;  // of the first instance; from one instance to the next
vec4 marrow_row(MarrowPalettes palettes, int row) {
  return marrow_floats(texelFetch(palettes, ivec2(row & 2047, row >> 11), 0));
}
MarrowMatrix marrow_matrix_of(MarrowPalettes palettes, uint joint) {
#if MARROW_COMPUTE
  int row = marrow_first_row.x + 3 * int(joint);
#else
  int row = marrow_first_row.x + gl_InstanceID * marrow_first_row.y + 3 * int(joint);
#endif
  return MarrowMatrix(marrow_row(palettes, row), marrow_row(palettes, row + 1), marrow_row(palettes, row + 2));
}
MarrowMatrix marrow_matrix(uint joint) {
  return marrow_matrix_of(marrow_palettes, joint);
}
#if MARROW_MOTION
uniform MarrowPalettes marrow_previous_palettes;  // the same instances, at the same places
MarrowMatrix marrow_previous_matrix(uint joint) {
  return marrow_matrix_of(marrow_previous_palettes, joint);
}
#endif
#endif
#endif

// Of an instance of a crowd; white otherwise.
#if MARROW_PALETTES == 2
uniform highp usampler2D marrow_instances;  // eight texels each
vec4 marrow_instance_colour() {
  int instance = marrow_first_row.x / marrow_first_row.y + gl_InstanceID;
  return uintBitsToFloat(texelFetch(marrow_instances, ivec2((instance & 255) * 8 + 3, instance >> 8), 0));
}
#else
vec4 marrow_instance_colour() {
  return vec4(1.0);
}
#endif

#if MARROW_NORMAL && !MARROW_SURFACE_NORMALS
#if MARROW_DEFORMER == 0
MARROW_IN(10) vec3 in_normal;
#else
MARROW_IN(10) vec2 in_normal;  // octahedral
#endif
#endif
#if MARROW_TANGENT && !MARROW_SURFACE_NORMALS
#if MARROW_DEFORMER == 0
MARROW_IN(11) vec4 in_tangent;
#else
MARROW_IN(11) vec2 in_tangent;  // octahedral; y is squeezed into (0, 1] and carries the handedness as sign
#endif
#endif
#if MARROW_UV
MARROW_IN(12) vec2 in_uv;
#endif
#if MARROW_COLOUR
MARROW_IN(13) vec4 in_colour;
#endif

#if MARROW_MORPH_TARGETS && MARROW_DEFORMER != 0
MARROW_IN(14) uint in_morph_row;  // 0: no target moves the vertex
uniform highp isampler2D marrow_morph_changes;
uniform vec4 marrow_morph_targets[MARROW_MORPH_TARGETS];  // first texel; weight · step of positions, normals, tangents
uniform int marrow_morph_count;
uniform int marrow_morph_shift;    // the texture is 1 << this wide
uniform int marrow_morph_per_row;  // texels
#if MARROW_MOTION
uniform vec4 marrow_previous_targets[MARROW_MORPH_TARGETS];
uniform int marrow_previous_count;
#endif
#endif

#if MARROW_POSE_SPACE
MARROW_IN(15) uint in_examples;  // one more than the vertex's first change; 0: no example moves it
uniform highp isampler2D marrow_examples;  // 2048 wide; a change, and one more than its example; of the last one less 0
uniform float marrow_example_step;
// 2048 wide; for each palette entry what is to be weighed and then exponentiated: of the bind pose, then of each example
uniform highp sampler2D marrow_distances;
uniform int marrow_distance_row[3];  // texels: of the first instance; from one instance, from one entry to the next
#if MARROW_MOTION
uniform highp sampler2D marrow_previous_distances;
#endif
#endif

// Model space. What the mesh lacks is zero.
struct MarrowVertex {
  vec3 position;
  vec3 normal;
  vec4 tangent;            // w: handedness
  vec3 previous_position;  // in the frame before; the position where MARROW_MOTION is 0
};

vec3 marrow_unit(vec3 v) {
  return v * inversesqrt(max(dot(v, v), 1e-37));
}

// Of any length: only where morph targets add to it has it to be 1.
vec3 marrow_from_octahedron(vec2 e) {
  vec3 v = vec3(e, 1.0 - abs(e.x) - abs(e.y));
  float fold = max(-v.z, 0.0);  // at most as large as either of e
  v.xy -= clamp(e, -fold, fold);
#if MARROW_MORPH_TARGETS
  v = marrow_unit(v);
#endif
  return v;
}

// The bind normal through the inverse transpose of the matrix with rows a, b, c, up to a positive factor: its cofactors,
// turned round where it mirrors. Sizes of 1e-9 to 1e9 are safe from under- and overflow.
// mirrored: -1 where the matrix mirrors, else 1; with it the triad of normal, tangent and bitangent changes hands.
vec3 marrow_normal(vec3 a, vec3 b, vec3 c, vec3 normal, out float mirrored) {
  vec3 bc = cross(b, c);
  mirrored = dot(a, bc) < 0.0 ? -1.0 : 1.0;
  vec3 n = vec3(dot(bc, normal), dot(c, cross(a, normal)), -dot(b, cross(a, normal)));
  return mirrored * marrow_unit(n);
}

#if MARROW_MORPH_TARGETS && MARROW_DEFORMER != 0
vec3 marrow_change(int texel) {
  ivec2 at = ivec2(texel & ((1 << marrow_morph_shift) - 1), texel >> marrow_morph_shift);
  return vec3(texelFetch(marrow_morph_changes, at, 0).xyz);
}

// Adds what the targets change, in the bind pose.
void marrow_morph(inout vec3 position, inout vec3 normal, inout vec3 tangent) {
  if (in_morph_row == 0u) return;
  int row = (int(in_morph_row) - 1) * marrow_morph_per_row;
  for (int i = 0; i < marrow_morph_count; ++i) {
    vec4 target = marrow_morph_targets[i];
    int texel = int(target.x) + row;
    position += target.y * marrow_change(texel);
#if MARROW_NORMAL
    normal += target.z * marrow_change(texel + 1);
#endif
#if MARROW_TANGENT
    tangent += target.w * marrow_change(texel + 2);
#endif
  }
}
#endif

#if MARROW_POSE_SPACE
vec4 marrow_distance(highp sampler2D distances, int first, uint joint) {
  int texel = first + marrow_distance_row[2] * int(joint);
  return texelFetch(distances, ivec2(texel & 2047, texel >> 11), 0);
}

// How near the pose is to four examples. first: their texel of palette entry 0.
vec4 marrow_phi(highp sampler2D distances, int first) {
  vec4 largest = marrow_distance(distances, first, in_joints0.x);
  vec4 sum = largest;
#define MARROW_WEIGH(I, Joint) \
  if (I != 0) sum += marrow_share(I) * (marrow_distance(distances, first, Joint) - largest);
  MARROW_EACH(MARROW_WEIGH)
  return exp(sum);
}

// What the examples change of the bind position.
vec3 marrow_pose_change(highp sampler2D distances) {
  vec3 change = vec3(0.0);
  if (in_examples == 0u) return change;
#if MARROW_COMPUTE
  int first = marrow_distance_row[0];
#else
  int first = marrow_distance_row[0] + gl_InstanceID * marrow_distance_row[1];
#endif
  vec4 phi = marrow_phi(distances, first);
  float scale = marrow_example_step * (1.0 - phi.x);
  int four = 0;  // examples that phi is of
  for (int texel = int(in_examples) - 1, i = 0; i < 32; ++i, ++texel) {
    ivec4 change_by = texelFetch(marrow_examples, ivec2(texel & 2047, texel >> 11), 0);
    int example = abs(change_by.w);
    if (example >> 2 != four) {
      four = example >> 2;
      phi = marrow_phi(distances, first + four);
    }
    change += phi[example & 3] * vec3(change_by.xyz);
    if (change_by.w <= 0) break;
  }
  return scale * change;
}
#endif

#if MARROW_DEFORMER != 0
// sum + row · q
float marrow_plus(float sum, vec4 row, vec4 q) {
#if MARROW_GPU == 2  // four numbers at a time
  return sum + dot(row, q);
#else
  return sum + row.x * q.x + row.y * q.y + row.z * q.z + row.w * q.w;
#endif
}
// sum + M q
vec3 marrow_plus(vec3 sum, MarrowMatrix m, vec4 q) {
  return vec3(marrow_plus(sum.x, m.x, q), marrow_plus(sum.y, m.y, q), marrow_plus(sum.z, m.z, q));
}
#endif

#if MARROW_DEFORMER == 3
// Adds one influence of animation space: M q to the position, w M to the matrix that normals and tangents go through.
void marrow_add(vec4 q, uint joint, inout vec3 position, inout vec3 x, inout vec3 y, inout vec3 z) {
  MarrowMatrix m = marrow_matrix(joint);
  position = marrow_plus(position, m, q);
#if MARROW_NORMAL || MARROW_TANGENT || MARROW_MORPH_TARGETS
  x += q.w * m.x.xyz;
  y += q.w * m.y.xyz;
  z += q.w * m.z.xyz;
#endif
}

#if MARROW_SURFACE_NORMALS
// Adds influence i of the position and of both tangents, so that rows are fetched once and live no longer than it.
// left: what the last w are less than 0. mirrored: by the first joint's matrix.
void marrow_add_surface(int i, uint joint, inout vec3 position, inout vec3 first, inout vec3 second, inout vec2 left,
                        inout float mirrored) {
  MarrowMatrix m = marrow_matrix(joint);
  if (i == 0) mirrored = dot(m.x.xyz, cross(m.y.xyz, m.z.xyz)) < 0.0 ? -1.0 : 1.0;
  vec4 a = marrow_first(i);
  vec4 b = marrow_second(i);
  if (i == MARROW_INFLUENCES - 1) {
    a.w = -left.x;
    b.w = -left.y;
  }
  position = marrow_plus(position, m, marrow_share(i));
  first = marrow_plus(first, m, a);
  second = marrow_plus(second, m, b);
  left += vec2(a.w, b.w);
}

// Position, normal and tangent, of the deformed surface itself.
void marrow_surface(inout MarrowVertex v) {
  vec3 position = vec3(0.0);
  vec3 first = vec3(0.0);
  vec3 second = vec3(0.0);
  vec2 left = vec2(0.0);
  float mirrored = 1.0;
#define MARROW_ADD(I, Joint) marrow_add_surface(I, Joint, position, first, second, left, mirrored);
  MARROW_EACH(MARROW_ADD)
  v.position = MARROW_STEP * marrow_coordinate_scale * position;
  first *= MARROW_TANGENT_STEP;
  second *= MARROW_TANGENT_STEP;
#if MARROW_NORMAL
  v.normal = mirrored * marrow_unit(cross(first, second));
#endif
#if MARROW_TANGENT
  v.tangent = vec4(marrow_unit(first), marrow_first(MARROW_INFLUENCES - 1).w < 0.0 ? -mirrored : mirrored);
#endif
}
#endif
#elif MARROW_DEFORMER != 0
// Adds one influence of SSD to the blended matrix.
void marrow_add(float weight, uint joint, inout vec4 x, inout vec4 y, inout vec4 z) {
  MarrowMatrix m = marrow_matrix(joint);
  x += weight * m.x;
  y += weight * m.y;
  z += weight * m.z;
}
#endif

#if MARROW_MOTION && MARROW_DEFORMER != 0
// M q, by the palette of the frame before.
vec3 marrow_was(vec4 q, uint joint) {
  return marrow_plus(vec3(0.0), marrow_previous_matrix(joint), q);
}

// Every deformer is a sum of M q here: q = w (p, 1) by SSD.
vec3 marrow_previous() {
  vec3 change = vec3(0.0);
#if MARROW_MORPH_TARGETS
  int row = (int(in_morph_row) - 1) * marrow_morph_per_row;
  for (int i = 0; in_morph_row != 0u && i < marrow_previous_count; ++i) {
    vec4 target = marrow_previous_targets[i];
    change += target.y * marrow_change(int(target.x) + row);
  }
#endif
#if MARROW_POSE_SPACE
  change += marrow_pose_change(marrow_previous_distances);
#endif
  vec3 p = vec3(0.0);
#if MARROW_DEFORMER != 3
  vec4 bind = vec4(in_position.xyz + change, 1.0);
#define MARROW_WAS(I, Joint) p += marrow_share(I) * marrow_was(bind, Joint);
#elif MARROW_MORPH_TARGETS
#define MARROW_WAS(I, Joint) p += marrow_was(marrow_share(I) + vec4(marrow_share(I).w * change, 0.0), Joint);
#else
#define MARROW_WAS(I, Joint) p += marrow_was(marrow_share(I), Joint);
#endif
#if MARROW_DEFORMER == 3 && MARROW_INFLUENCES == 4 && (MARROW_PALETTES != 0 || MARROW_GPU == 0)
  MARROW_FOUR_APART(MARROW_WAS)
#else
  MARROW_EACH(MARROW_WAS)
#endif
#if MARROW_DEFORMER == 3
  p *= MARROW_STEP * marrow_coordinate_scale;
#endif
  return p;
}
#endif

MarrowVertex marrow_skin() {
  MarrowVertex v = MarrowVertex(vec3(0.0), vec3(0.0), vec4(0.0), vec3(0.0));
#if MARROW_MOTION && MARROW_DEFORMER != 0
  v.previous_position = marrow_previous();
#endif
#if MARROW_DEFORMER == 0
  v.position = in_position;
#if MARROW_NORMAL
  v.normal = in_normal;
#endif
#if MARROW_TANGENT
  v.tangent = in_tangent;
#endif
#elif MARROW_SURFACE_NORMALS
  marrow_surface(v);
#else
  vec3 change = vec3(0.0);  // of the bind position
  vec3 normal = vec3(0.0);
  vec3 tangent = vec3(0.0);
#if MARROW_NORMAL
  normal = marrow_from_octahedron(in_normal);
#endif
#if MARROW_TANGENT
  tangent = marrow_from_octahedron(vec2(in_tangent.x, abs(in_tangent.y) * 2.0 - 1.0));
#endif
#if MARROW_DEFORMER == 3
#if MARROW_MORPH_TARGETS
  marrow_morph(change, normal, tangent);
#endif
  vec3 x = vec3(0.0);
  vec3 y = vec3(0.0);
  vec3 z = vec3(0.0);
#define MARROW_ADD(I, Joint) marrow_add(marrow_share(I), Joint, v.position, x, y, z);
  MARROW_EACH(MARROW_ADD)
#if MARROW_MORPH_TARGETS
  v.position += vec3(dot(x, change), dot(y, change), dot(z, change));
#endif
  v.position *= MARROW_STEP * marrow_coordinate_scale;
  x *= MARROW_STEP;  // its sizes are safe from overflow
  y *= MARROW_STEP;
  z *= MARROW_STEP;
#else
  vec4 x = vec4(0.0);
  vec4 y = vec4(0.0);
  vec4 z = vec4(0.0);
#define MARROW_ADD(I, Joint) marrow_add(marrow_share(I), Joint, x, y, z);
  MARROW_EACH(MARROW_ADD)
#if MARROW_MORPH_TARGETS
  marrow_morph(change, normal, tangent);
#endif
#if MARROW_POSE_SPACE
  change += marrow_pose_change(marrow_distances);
#endif
  vec4 p = vec4(in_position.xyz + change, 1.0);
  v.position = vec3(dot(x, p), dot(y, p), dot(z, p));
#endif

  float mirrored = 1.0;
#if MARROW_NORMAL
  v.normal = marrow_normal(x.xyz, y.xyz, z.xyz, normal, mirrored);
#endif
#if MARROW_TANGENT
  v.tangent = vec4(marrow_unit(vec3(dot(x.xyz, tangent), dot(y.xyz, tangent), dot(z.xyz, tangent))),
                   in_tangent.y < 0.0 ? -mirrored : mirrored);
#endif
#endif
#if !MARROW_MOTION
  v.previous_position = v.position;
#elif MARROW_DEFORMER == 0
  v.previous_position = in_previous_position;
#endif
  return v;
}
