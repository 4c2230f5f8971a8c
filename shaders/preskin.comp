// Skinning ahead of drawing, by compute shader: reads the vertex buffers as words, an invocation a vertex.
layout(local_size_x = 64) in;
// Mali-G waits for loads, and two words are one. With more influences the pairs would spill.
#define MARROW_PAIRS (MARROW_GPU == 1 && MARROW_SURFACE_NORMALS && MARROW_INFLUENCES == 4)
layout(std430, binding = 0) restrict readonly buffer MarrowSkinWords {
  uint marrow_skin_words[];
};
// Not beside the pairs: every GPU has four buffers, and some no more.
#if !MARROW_PAIRS
layout(std430, binding = 1) restrict readonly buffer MarrowSurfaceWords {
  uint marrow_surface_words[];
};
#endif
layout(std430, binding = 2) restrict readonly buffer MarrowMorphRows {
  uint marrow_morph_rows[];
};
layout(std430, binding = 3) restrict writeonly buffer MarrowSkinned {
  float marrow_skinned[];
};

// In words: vertices; a vertex's stride; where its weights, tangent vectors and joints are; bytes of a joint; and of
// the surface: a vertex's stride; where its normal and tangent are; and where its first change by an example is.
uniform int marrow_vertex_layout[10];

int marrow_at;  // the vertex's first word

vec4 marrow_snorm(int at) {
  return vec4(unpackSnorm2x16(marrow_skin_words[at]), unpackSnorm2x16(marrow_skin_words[at + 1]));
}

uvec4 marrow_joints(int at, int group) {
  if (marrow_vertex_layout[5] == 1) {
    uint four = marrow_skin_words[at + group];
    return uvec4(four, four >> 8, four >> 16, four >> 24) & 255u;
  }
  uint two = marrow_skin_words[at + 2 * group];
  uint more = marrow_skin_words[at + 2 * group + 1];
  return uvec4(two, two >> 16, more, more >> 16) & 65535u;
}

#if MARROW_PAIRS
layout(std430, binding = 0) restrict readonly buffer MarrowSkinPairs {
  uvec2 marrow_skin_pairs[];
};
// A vertex that begins amid a pair has halves of the first and the last. Its joints follow, so that the last is a whole one.
uvec2 marrow_pairs[13];
uvec2 marrow_words(int pair) {
  return (marrow_at & 1) == 0 ? marrow_pairs[pair] : uvec2(marrow_pairs[pair].y, marrow_pairs[pair + 1].x);
}
#elif MARROW_DEFORMER == 3
uvec2 marrow_words(int pair) {
  return uvec2(marrow_skin_words[marrow_at + 2 * pair], marrow_skin_words[marrow_at + 2 * pair + 1]);
}
#endif

// Fills in what are attributes elsewhere.
void marrow_load(int vertex) {
  int at = vertex * marrow_vertex_layout[1];
  marrow_at = at;
#if MARROW_PAIRS
  for (int i = 0; i < 12; ++i) marrow_pairs[i] = marrow_skin_pairs[(at >> 1) + i];
  marrow_pairs[12] = marrow_skin_pairs[(at >> 1) + 11 + (at & 1)];
#endif
#if MARROW_DEFORMER != 3
#if MARROW_DEFORMER == 2
  in_position = marrow_snorm(at);
  int weights = at + marrow_vertex_layout[2];
  in_weights0.xy = unpackUnorm2x16(marrow_skin_words[weights]);
#if MARROW_INFLUENCES > 4
  in_weights0.zw = unpackUnorm2x16(marrow_skin_words[weights + 1]);
#endif
#if MARROW_INFLUENCES > 6
  in_weights1 = unpackUnorm2x16(marrow_skin_words[weights + 2]);
#endif
#else
  in_position = marrow_snorm(at).xyz;
#endif
#endif
  in_joints0 = marrow_joints(at + marrow_vertex_layout[4], 0);
#if MARROW_INFLUENCES > 4 && MARROW_DEFORMER != 1
  in_joints1 = marrow_joints(at + marrow_vertex_layout[4], 1);
#endif
#if !MARROW_SURFACE_NORMALS
  int surface = vertex * marrow_vertex_layout[6];
#if MARROW_NORMAL
  in_normal = unpackSnorm2x16(marrow_surface_words[surface + marrow_vertex_layout[7]]);
#endif
#if MARROW_TANGENT
  in_tangent = unpackSnorm2x16(marrow_surface_words[surface + marrow_vertex_layout[8]]);
#endif
#endif
#if MARROW_MORPH_TARGETS
  in_morph_row = marrow_morph_rows[vertex];
#endif
#if MARROW_POSE_SPACE
  in_examples = marrow_skin_words[at + marrow_vertex_layout[9]];
#endif
}

void main() {
  int vertex = int(gl_GlobalInvocationID.x);
  int count = marrow_vertex_layout[0];
  if (vertex >= count) return;
  marrow_load(vertex);
  MarrowVertex v = marrow_skin();
  int at = 3 * vertex;
  marrow_skinned[at] = v.position.x;
  marrow_skinned[at + 1] = v.position.y;
  marrow_skinned[at + 2] = v.position.z;
  int block = 3 * count;
#if MARROW_NORMAL
  at = block + 3 * vertex;
  marrow_skinned[at] = v.normal.x;
  marrow_skinned[at + 1] = v.normal.y;
  marrow_skinned[at + 2] = v.normal.z;
  block += 3 * count;
#endif
#if MARROW_TANGENT
  at = block + 4 * vertex;
  marrow_skinned[at] = v.tangent.x;
  marrow_skinned[at + 1] = v.tangent.y;
  marrow_skinned[at + 2] = v.tangent.z;
  marrow_skinned[at + 3] = v.tangent.w;
#endif
}
