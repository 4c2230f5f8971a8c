// Linear blend skinning smoothed over the surface of a mesh, in whole numbers. It gives a guess at animation space's
// residual that needs nothing but the rest of the file.
#pragma once

#include "core/memory.h"
#include "unpack/neighbours.h"
#include "unpack/streams.h"

namespace marrow {

// A joint that a vertex follows after smoothing: its weight, and the weight times (smoothed position - vertex).
struct Carried {
  std::int32_t joint;
  std::int32_t weight;  // of Smoothed::one()
  float offset[3];      // in steps of positions
};

// After Le and Lewis, "Direct delta mush skinning and variants", ACM TOG 38(4), 2019, the third variant, as
// tools/deform/animation_space.h has it: steps towards the mean of all neighbours, but for vertices on a border. Sums
// are of whole numbers, so that the order of neighbours does not matter. Only leaders are smoothed.
class Smoothed {
 public:
  static constexpr std::uint32_t kMostCarried = kMaxInfluences;
  static constexpr std::uint32_t kWholeStep = 1 << 15;

  // All own joints of a vertex in their order, then the others with the largest weights, in descending order.
  struct Joints {
    const Carried* carried;
    std::uint32_t own, all;
  };
  Joints of(std::uint32_t leader) const {
    return {carried_ + std::size_t{leader} * kMostCarried, own_[leader], all_[leader]};
  }
  std::int32_t one() const { return one_; }
  // The weight that the file gives an own joint; one() stands for 1.
  std::int32_t own_weight(std::uint32_t leader, std::uint32_t influence) const;

  // Bytes that begin() takes. With no iterations there are only the own joints.
  static std::uint64_t bytes(const MeshStreams& mesh, std::uint32_t iterations);
  // share: how far an iteration goes towards the mean; kWholeStep is all the way. mesh and near must outlive this.
  // Returns false if the memory does not suffice. step() reads the vertices.
  bool begin(const MeshStreams& mesh, const MeshNeighbours& near, std::uint32_t iterations, std::uint32_t share,
             Memory& memory);
  // Does one step's work, counted in vertices and their neighbours. Returns null, or the rule that is broken: joints
  // that spread so far that it would take too long.
  const char* step();
  bool at_end() const { return place_ == Place::smoothing && joint_ == joint_count_; }

 private:
  using Column = std::int32_t[4];  // of a joint and a vertex: its weight times the position, and its weight
  enum class Place : std::uint8_t { own, followers, smoothing };

  // Each goes on until `left` is used up, and returns whether it is finished.
  bool find_own(std::uint32_t& left);
  bool find_followers(std::uint32_t& left);
  bool iterate(std::uint32_t& left);
  bool keep(std::uint32_t& left);
  void begin_own(std::uint32_t joint);
  void activate(std::uint32_t vertex);
  void grow(std::uint32_t vertex);
  void smooth(std::uint32_t vertex);
  void keep(std::uint32_t joint, std::uint32_t vertex);

  const MeshStreams* mesh_ = nullptr;
  const MeshNeighbours* near_ = nullptr;
  std::uint32_t iterations_ = 0, joint_count_ = 0, joint_ = 0;
  std::int32_t one_ = 0;
  std::uint32_t weight_shift_ = 0, place_shift_ = 0;
  std::uint64_t work_ = 0;  // vertices that steps have taken
  Carried* carried_ = nullptr;
  std::uint8_t *own_ = nullptr, *all_ = nullptr;
  std::uint32_t* pace_ = nullptr;      // per leader: an iteration's factor of the summed differences, times 2^30
  std::uint32_t* first_of_ = nullptr;  // per joint, and one more: where its followers begin in followers_
  std::uint32_t* followers_ = nullptr;
  Column *now_ = nullptr, *next_ = nullptr;
  // The vertices that the current joint has reached, in active_; from grown_ on those that the last iteration reached.
  // reached_by_: the joint that last reached a vertex.
  std::uint32_t *active_ = nullptr, *reached_by_ = nullptr;
  std::uint32_t active_count_ = 0, grown_ = 0;
  // Where a step stopped: the index in the current pass, the joint's iteration, and the end of the active vertices
  // whose neighbours this iteration adds; is_grown_: whether all have been added.
  std::uint32_t at_ = 0, iteration_ = 0, grow_end_ = 0, share_ = 0;
  Place place_ = Place::own;
  bool is_begun_ = false, is_grown_ = false;
};

}  // namespace marrow
