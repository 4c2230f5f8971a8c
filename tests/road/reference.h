// The reference evaluator: glTF 2.0 posed and skinned in double precision from the source file, independent of the
// cooker and the runtime that it judges.
#pragma once

#include <string>
#include <vector>

#include "road/source.h"

namespace marrow::test {

// Vertices in model space: for each node of the scene with a mesh in node order, each triangle primitive in order, each
// vertex of its POSITION accessor in order. All arrays are equally long.
struct ReferencePose {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;   // unit; zero where not comparable: absent, or the blend is near singular
  std::vector<Vec3> tangents;  // likewise
  std::vector<double>
      tangent_signs;        // ±1 so that sign · cross(normal, tangent) is where the bitangent goes; 0 where absent
  std::vector<Vec3> rigid;  // where the joint of the largest weight alone takes the vertex
  std::vector<bool> rigid_unique;   // false where two weights tie for the largest
  std::vector<double> float_noise;  // how far 32-bit floats may take each position, whoever calculates it
};

class Reference {
 public:
  explicit Reference(const std::string& path) : Reference(read_source(path)) {}
  explicit Reference(Source source);

  const Source& source() const { return source_; }
  // Of the bounding box of the rest pose's vertices.
  double diagonal() const { return diagonal_; }
  // Vertices that no weight binds to anything: glTF gives them no meaning, so their positions are not compared.
  std::size_t unbound_count() const { return unbound_count_; }
  bool comparable(std::size_t vertex) const { return bound_[vertex]; }
  // Time of the last key of any channel; 0 without.
  double duration_s(std::size_t animation) const;

  // model_from_node of every node at a time of an animation.
  std::vector<Map> nodes_at(std::size_t animation, double time_s) const {
    return model_from_node(&source_.animations.at(animation), time_s).nodes;
  }
  // How far 32-bit floats may take their origins.
  std::vector<double> node_noise_at(std::size_t animation, double time_s) const;

  ReferencePose rest() const { return pose(nullptr, 0); }
  // At rest, but that the weights of every mesh's morph targets are these in turn.
  ReferencePose rest(const std::vector<float>& cycle) const { return pose(nullptr, 0, cycle); }
  ReferencePose at(std::size_t animation, double time_s) const {
    return pose(&source_.animations.at(animation), time_s);
  }

 private:
  ReferencePose pose(const SourceAnimation* animation, double time_s, const std::vector<float>& cycle = {}) const;
  // Of every node where it is in the scene, and how many roundings of how large a length led there.
  struct Placed {
    std::vector<Map> nodes;
    std::vector<double> largest, levels;
  };
  Placed model_from_node(const SourceAnimation* animation, double time_s) const;

  Source source_;
  double diagonal_ = 0;
  std::size_t unbound_count_ = 0;
  std::vector<bool> bound_;
};

// A channel's value at a time, glTF 2.0 appendix C: clamped at both ends; rotations come out unit length.
Quat sample_channel(const SourceChannel& channel, double time_s);

// What the cooker promises to keep of a vertex's influences: zeros dropped, one entry a joint, the eight largest,
// renormalised; largest first.
std::vector<SourceInfluence> kept_influences(const std::vector<SourceInfluence>& all);

}  // namespace marrow::test
