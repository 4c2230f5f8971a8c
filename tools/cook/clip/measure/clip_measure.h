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

// A clip's channels by name, at any time. The clip outlives this.
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

// What hangs on the joints of a skeleton: a mesh at one level of detail. A mesh with morph targets is there a second
// time with each vertex where the target that takes it farthest has it, and, in full detail, a third time as a clip
// weighs the targets.
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
// outlives what is returned. promise: its errors say how far vertices may stray, each by the weighted mean of its
// joints; it gets the joints' points and reaches.
Hung hang(const std::vector<Mesh>& meshes, const std::vector<MorphedMesh>& morphed, const Rig& rig, Promise& promise);

// A kept node's place, in its joint's space.
void hang(std::size_t joint, const glm::dvec3& place, const Rig& rig, Promise& promise);

// By the runtime's own decoder, in model space through the whole hierarchy.
class ClipMeasure {
 public:
  // What is given outlives this. channels: by which the clip weighs morph targets.
  ClipMeasure(const BuiltClip& clip, const BuiltClip& channels, const BuiltSkeleton& skeleton, const Rig& rig,
              const Hung& hung);

  // All moments to measure at: these, which ascend, and the keys of the clip's curves and channels; both sides of what
  // jumps.
  std::vector<float> moments(const std::vector<float>& of_grid) const;

  // Measures at the moments, and closer by where it is worst. Joints are looked at each time; so are vertices while the
  // joints keep the promise, but only at every few moments where there are very many.
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
