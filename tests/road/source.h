// A glTF file as doubles: the tests' own reading of it, which shares nothing with tools/cook. Valid files only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/double_math.h"

namespace marrow::test {

struct SourceNode {
  std::string name;
  int parent = -1;
  bool in_scene = false;
  bool has_matrix = false;
  Map matrix;  // parent_from_node if has_matrix, else translate · rotate · scale
  Vec3 translation{0, 0, 0};
  Quat rotation{0, 0, 0, 1};
  Vec3 scale{1, 1, 1};
  int mesh = -1;
  int skin = -1;
  std::vector<double> weights;  // of the mesh's morph targets: the node's, else the mesh's, else zeros
};

struct SourceInfluence {
  int joint;  // index into SourceSkin::joints
  double weight;
};

// What a morph target adds; arrays are empty or as long as the primitive's.
struct SourceTarget {
  std::vector<Vec3> positions, normals, tangents;
};

// Arrays are empty or as long as `positions`.
struct SourcePrimitive {
  std::vector<Vec3> positions, normals, tangents;
  std::vector<double> tangent_signs;                     // as long as `tangents`
  std::vector<std::vector<SourceInfluence>> influences;  // as in the file, every set in order, zeros included
  std::vector<SourceTarget> targets;
};

struct SourceSkin {
  std::vector<int> joints;
  std::vector<Map> inverse_bind;
};

struct SourceChannel {
  int node = -1;
  std::string path, interpolation;
  std::vector<double> times_s;
  std::vector<Quat> values;  // one a key, three for CUBICSPLINE; w unused but for rotations
};

// A morph target's weight; values hold it in x.
struct SourceWeight {
  std::string name;  // NODE.TARGET, NODE.weights[2] without a target's name; nodes[3] for a node without
  double rest = 0;
  std::size_t target = 0;
  SourceChannel channel;  // of its node
};

struct SourceAnimation {
  std::string name;
  std::vector<SourceChannel> channels;  // morph weights left out
  std::vector<SourceWeight> weights;
};

struct Source {
  std::vector<SourceNode> nodes;
  std::vector<std::vector<SourcePrimitive>> meshes;  // triangles only
  std::vector<SourceSkin> skins;
  std::vector<SourceAnimation> animations;
};

// Throws std::exception of some kind if the file cannot be read.
Source read_source(const std::string& path);
// Of the text of a file without others: its buffers are data URIs.
Source read_source_text(const std::string& json);

}  // namespace marrow::test
