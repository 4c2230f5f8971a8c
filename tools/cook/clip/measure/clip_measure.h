// How far what became of a clip takes joints, and what hangs on them, from where the source has them.
#pragma once

#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include "common/aligned_bytes.h"
#include "cook/clip/measure/rig.h"
#include "cook/scene/built.h"
#include "marrow/file.h"
#include "marrow/morph.h"

namespace marrow::cook {

// clip: outlives this.
class ChannelValues {
 public:
  explicit ChannelValues(const BuiltClip& clip);
  void go_to(float time_s);
  // kNone: no channel is called so.
  int find(const std::string& name) const;
  double value(int channel, double rest) const {
    return channel == kNone ? rest : static_cast<double>(values_[to_index(channel)]);
  }

 private:
  const std::vector<std::string>& names_;
  Clip clip_;
  std::vector<float> values_;
};

// A mesh at one level of detail. With morph targets it is there once more with each vertex where the target that takes
// it farthest has it, and in full detail as a clip weighs them.
struct HungMesh {
  Mesh mesh;
  std::vector<float> coordinates;  // of animation space; empty for a lift, which is where linear blend skinning is
  std::vector<float> skin;         // of a morphed geometry, which points into it
  std::vector<MorphedMesh::Target> targets;  // that a clip weighs; none: it is as it stands here
  std::vector<double> strictness;  // a slot: 1 / (how far it may stray, scene units)²; of what fills up blocks 0
};

struct Hung {
  std::vector<HungMesh> meshes;
  std::size_t slots = 0;    // of all meshes and deformers
  bool is_weighed = false;  // some of them, by clips
};

// meshes: of one skeleton, every level of detail of each; morphed: those of them with targets. What they point into
// outlives what is returned. promise: says how far vertices may stray, each the mean of its joints by weight; gets the
// points and reaches of the joints.
Hung hang(const std::vector<Mesh>& meshes, const std::vector<MorphedMesh>& morphed, const Rig& rig, Promise& promise);

// A kept node's place, in its joint's space.
void hang(std::size_t joint, const glm::dvec3& place, const Rig& rig, Promise& promise);

struct VertexError {
  double error_m = 0;
  double share = 0;  // of what is promised for the vertex
};

// The largest distance between the same vertices in two poses, by the runtime's own skinning: linear blend skinning,
// and whatever other deformer a mesh has data for.
class VertexErrors {
 public:
  // channels: of the clip, by which morph targets are weighed. Both outlive this.
  VertexErrors(const Hung& hung, const BuiltClip& channels);
  // At a moment of the clip.
  VertexError at(const std::vector<World>& source, const std::vector<World>& other, float time_s);

 private:
  // A mesh with morph targets, as the clip has it at a moment.
  struct Weighed {
    tools::AlignedBytes memory;
    MorphedGeometry morphed;
    std::vector<int> channels;  // a target
    std::vector<float> weights, coordinates;
  };
  bool weigh(const HungMesh& hung, Weighed& to);
  void skin(const Mesh& mesh, const std::vector<float>& coordinates, const std::vector<World>& pose, int deformer,
            std::vector<float>& out);

  const Hung& hung_;
  ChannelValues values_;
  std::vector<Weighed> weighed_;  // a mesh
  std::vector<Affine> joints_, palette_;
  std::vector<float> here_, there_, distances_;
};

// By the runtime's own decoder, in model space through the whole hierarchy.
class ClipMeasure {
 public:
  // What is given outlives this. channels: by which the clip weighs morph targets.
  ClipMeasure(const BuiltClip& clip, const BuiltClip& channels, const BuiltSkeleton& skeleton, const Rig& rig,
              const Hung& hung);

  // All moments at which it is looked at: these, ascending, and where the clip's curves and channels have keys; both
  // sides of what jumps.
  std::vector<float> moments(const std::vector<float>& of_grid) const;

  // At the moments, and nearer to those that are worst. The joints are looked at every time; the vertices too, or at
  // every few moments where that would be too many, as long as the joints keep the promise.
  ClipError measure(const BuiltClip& out, const std::vector<float>& moments, const Promise& promise) const;

 private:
  const BuiltClip& clip_;
  const BuiltClip& channels_;
  const BuiltSkeleton& skeleton_;
  const Rig& rig_;
  const Hung& hung_;
  SourceCurves curves_;
};

}  // namespace marrow::cook
