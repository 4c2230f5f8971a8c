// A mesh as the codecs take it, with the memory that its arrays live in.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"
#include "cook/scene/residual_source.h"
#include "unpack/streams.h"

namespace marrow::cook {

// A vertex's joints, as palette entries in ascending order, with weights that sum to one.
struct Binding {
  std::vector<std::uint16_t> set;
  std::vector<double> weights;
  std::vector<glm::dvec4> residual;  // of animation space; none, or as many: (d, δ)
};

// Multi-weight enveloping: for each vertex of the source and joint of its binding twelve weights, row by row, as
// deform::MultiWeight has them. Empty: none.
struct MultiWeightData {
  std::uint32_t root = 0;  // palette entry
  std::vector<std::vector<std::array<double, 12>>> weights;
};

// Pose-space deformation, as deform::PoseSpace has it. Without examples: none.
struct PoseSpaceData {
  struct Example {
    std::vector<glm::dquat> rotations;  // a palette entry; of those without a parent they do not count
    std::vector<glm::dvec3> deltas;     // a vertex of the source; metres, mesh space
  };
  double sigma = 1;                    // 0.001 … 1000
  std::vector<std::uint16_t> parents;  // a palette entry: another one or kNoJoint
  std::vector<Example> examples;       // at most kMaxPoseExamples
};

// What a mesh's deformers need beside positions and weights.
struct DeformerData {
  MultiWeightData multi_weight;
  PoseSpaceData pose_space;
};

class OwnedStreams {
 public:
  MeshStreams mesh;  // its arrays are null; see view()
  std::vector<std::uint32_t> indices, source_map;
  std::vector<Stream> streams;
  std::vector<std::vector<std::int32_t>> values;  // a stream
  std::vector<std::int16_t> rotations;            // of examples, as MeshStreams'
  std::vector<std::uint16_t> parents;
  std::vector<std::byte> residual_bits;  // of mesh.apart
  bool has_collapsed = false;            // triangles without an area that are kept for their vertices

  Stream& add(StreamKind kind, std::uint32_t components, std::uint32_t bits);
  // With the arrays' addresses, until one of them changes.
  MeshStreams view();
  // Of bind streams, of which there is one a kind at most.
  const Stream* find(StreamKind kind) const;
  std::vector<std::int32_t>* values_of(StreamKind kind);
  // Leaves out the streams for which drops(stream, values) is true.
  template <class Drops>
  void drop(const Drops& drops) {
    std::size_t to = 0;
    for (std::size_t i = 0; i < streams.size(); ++i) {
      if (drops(streams[i], values[i])) continue;
      std::swap(streams[to], streams[i]);
      values[to++].swap(values[i]);
    }
    streams.resize(to);
    values.resize(to);
  }
};

// How finely meshes are quantised.
struct MeshGrid {
  glm::dvec3 origin{0};
  double step = 0;  // metres; 0: not at all, everything is kept as floats
  // Of residuals: metres, and of their w; 0: there are none.
  double residual_step = 0;
  double residual_weight_step = 0;
  ResidualSource residual_source = {};
  std::vector<glm::dmat4> rest = {};  // model_from_mesh of each palette entry at rest; none: not measured
};

// Every vertex of the source as it is, bits of floats; but morph targets, which are 16 bits even in memory.
OwnedStreams verbatim_streams(const RawPrimitive& primitive, const std::vector<Binding>& bindings,
                              std::size_t joint_count, MeshError& error);
// Rounded to the grid and to as few bits as keep the precision.
OwnedStreams quantised_streams(const RawPrimitive& primitive, const std::vector<Binding>& bindings,
                               std::size_t joint_count, const MeshGrid& grid, const MeshPrecision& precision,
                               MeshError& error);

// What this leaves of a vertex's binding: influences that do not vanish, with the weights that the runtime will see.
Binding quantised_binding(const Binding& binding, const glm::vec3& position, const MeshGrid& grid,
                          const MeshPrecision& precision);

// Changes of vertices as a stream of `kind`, on steps no finer than 16 bits allow. False if nothing moves by half a
// step. worst: gets how far a change is off at most.
bool add_changes(StreamKind kind, const std::vector<glm::dvec3>& changes, std::uint32_t target, std::uint8_t attribute,
                 double finest, OwnedStreams& out, double& worst);

// Adds what the deformers need to streams that either of the above has made of the same vertices: residuals of weights
// on the weights that the streams have, and examples' deltas in 16 bits. Steps are such that the errors, as MeshError
// has them, stay below the grid's step; where that takes more bits than there are, or without a grid, all bits are used
// (multi-weight residuals are then floats). Influences that rounding has left out lose their weights. Throws
// tools::Failure (unsupported) if the data are not as they must be.
void add_deformers(const RawPrimitive& primitive, const std::vector<Binding>& bindings, const DeformerData& data,
                   const MeshGrid& grid, OwnedStreams& streams, MeshError& error);

// A stream's numbers of `count` vertices: the i-th is vertex from(i).
template <class From>
std::vector<std::int32_t> numbers_of(const Stream& stream, const std::vector<std::int32_t>& values, std::size_t count,
                                     const From& from) {
  std::vector<std::int32_t> out;
  out.reserve(count * stream.components);
  for (std::size_t i = 0; i < count; ++i) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(std::size_t{from(i)} * stream.components);
    out.insert(out.end(), first, first + stream.components);
  }
  return out;
}

// Merges vertices that agree in everything, drops triangles that have no area in any pose and vertices without a
// triangle. keep_map: fill in source_map. A vertex of a dropped triangle then goes to one in its place, and where there
// is none its triangle stays; a vertex that no triangle uses gets kNoSlot.
void weld(OwnedStreams& streams, bool keep_map);

// Whether so many triangles meet in vertices, or in places, that what looks at all of them for each takes too long:
// more than 20 million pairs, and 64 times the corners.
enum class Meeting { vertex, place };
bool meets_too_often(const OwnedStreams& streams, Meeting in);

// Orders triangles for the GPU's vertex cache and for little overdraw.
void optimise_order(OwnedStreams& streams);

// Lets vertices follow joints without a weight where that makes fewer runs, as CPUs set up matrices once a run: two
// sets of joints become their union where that costs less. Both have the same last joint, whose weight is what others
// leave; so sums only gain zeros, and each vertex goes where it went to the bit. No vertex follows more joints than the
// mesh's most. Of welded streams.
void merge_runs(OwnedStreams& streams);

// All numbers of each vertex, one behind the other; of streams of the kinds that count, if not of all.
class Rows {
 public:
  explicit Rows(const OwnedStreams& streams, bool (*counts)(StreamKind) = nullptr);
  std::string_view of(std::size_t vertex) const { return {&all_[vertex * bytes_], bytes_}; }

 private:
  std::size_t bytes_ = 0;
  std::vector<char> all_;
};

// The first vertex of each row of `rows`, which must outlive this. Empty if two vertices are alike in `rows` but not in
// `whole`.
using RowPlaces = std::unordered_map<std::string_view, std::uint32_t>;
RowPlaces places_of(const Rows& rows, const Rows& whole, std::uint32_t count);

}  // namespace marrow::cook
