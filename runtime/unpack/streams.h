// A decoded mesh that is not in blocks yet: triangles, and one stream of whole numbers per property of the vertices.
#pragma once

#include "marrow/file.h"
#include "unpack/packed.h"

namespace marrow {

// What a stream holds, and how many numbers per vertex. A vertex's joints ascend strictly; the last one repeats if
// other vertices have more. The last weight is 1 less the others and is not stored; places without a joint hold 0.
enum class StreamKind : std::uint8_t {
  position,      // 3
  normal,        // 2: octahedral, as Draco has them; verbatim: 3
  tangent,       // 2, as normal; verbatim: 3
  tangent_sign,  // 1: 0 for -1, 1 for +1
  uv,            // 2
  colour,        // 4: 0 … 255
  joints,        // one an influence
  weights,       // one an influence but the last; 2^bits - 1 is one
  // 4; a stream an influence. Relative to the vertex, see expand.cpp; w in steps of origin[0]; 2^(bits - 1) is nothing.
  residual,
  multi_weight,  // 12 of an influence: its residual; 2^(bits - 1) is nothing
  target,        // 3: what a morph target adds; 2^(bits - 1) is nothing
  pose_delta,    // 3: what an example of pose-space deformation adds; 2^(bits - 1) is nothing
};
inline constexpr std::uint32_t kBindStreams = 8 + 2 * kMaxInfluences;  // at most, before those of morph targets

// Whether no stream of kind `wanted` can follow one of kind `seen`. Only deformers' streams stand behind those of morph
// targets, which may be many.
inline bool is_past(StreamKind wanted, StreamKind seen) {
  return seen == StreamKind::target && wanted < StreamKind::residual;
}

struct Stream {
  StreamKind kind = StreamKind::position;
  std::uint8_t components = 0;
  std::uint8_t bits = 0;       // 0: the bits of floats, verbatim
  std::uint8_t attribute = 0;  // of a target: 0 positions, 1 normals, 2 tangents
  std::uint32_t target = 0;    // morph target, influence or example
  float origin[3] = {};        // value = origin + number · step
  float step = 1;
  std::int32_t* values = nullptr;  // vertex by vertex
};

// Whether numbers are biased: the middle of their range stands for 0.
constexpr bool is_centred(StreamKind kind) {
  return kind == StreamKind::residual || kind == StreamKind::multi_weight || kind == StreamKind::target ||
         kind == StreamKind::pose_delta;
}

// Whether it says which joints a vertex follows, and by how much.
constexpr bool is_skin(StreamKind kind) {
  return kind == StreamKind::joints || kind == StreamKind::weights;
}

// Of weights.
constexpr float weight_step(std::uint32_t bits) {
  return 1.0f / static_cast<float>((1 << bits) - 1);
}

// Animation space's residual, coded apart from the streams, which hold linear blend skinning's joints and weights.
struct ResidualApart {
  std::uint32_t influences = 0;  // that a vertex may have in animation space; 0: there is none apart
  std::uint32_t iterations = 0;  // of the smoothing that guesses the residual; 0: it is not guessed
  std::uint32_t share = 0;       // how far an iteration goes towards the neighbours' mean; 2^15 is all the way
  float step_of_w = 1, step = 1;
  Span<const std::byte> bits;
};

// How far a record's decoding has come.
struct Decoding {
  std::uint32_t read = 0;    // of the record's bytes
  std::uint32_t mapped = 0;  // of the source's vertices
  std::uint32_t parts = 0;   // of the codec, if it can stop: indices, then stream by stream
};

struct MeshStreams {
  std::uint32_t flags = 0;  // format::GeometryFlags
  std::uint32_t vertex_count = 0;
  std::uint32_t triangle_count = 0;
  std::uint32_t joint_count = 0;  // palette entries
  std::uint32_t influences = 1;   // the most of any vertex
  std::uint32_t source_vertex_count = 0;
  std::uint32_t* indices = nullptr;     // 3 a triangle
  std::uint32_t* source_map = nullptr;  // the vertex that each of the source has become
  std::uint32_t target_count = 0;       // morph targets; their streams follow, in the order of targets and attributes
  std::uint32_t mwe_root = 0;
  std::uint32_t example_count = 0;  // of pose-space deformation; their streams come last
  float sigma = 0;
  const std::int16_t* rotations = nullptr;  // for each example and palette entry x y z w
  const std::uint16_t* parents = nullptr;   // a palette entry
  ResidualApart apart;
  Stream* streams = nullptr;
  std::uint32_t stream_count = 0;
  Decoding* decoding = nullptr;  // a codec that can stop does one step per call and counts here; null: all at once

  const Stream* find(StreamKind kind) const {
    for (std::uint32_t i = 0; i < stream_count; ++i) {
      if (streams[i].kind == kind) return &streams[i];
      if (is_past(kind, streams[i].kind)) break;
    }
    return nullptr;
  }
};

}  // namespace marrow
