// A deformer that does not fold: the body as a lattice of elastic cells which the joints carry.
#pragma once

#include <memory>
#include <vector>

#include "deform/elastic/body.h"

namespace marrow::deform {

// Where a mesh has a body: closed, or nearly so, and at least a few voxels thick. Elsewhere dual quaternions, and in
// between a blend of both without a seam. Refers to the mesh. Joints may scale and mirror. In poses that are not
// finite, or in which nothing has a volume, it is dual quaternions.
// Thread-safe; the same bits everywhere. Memory: 90 MB while it is made, then about 20 MB, and 5 MB a pose at a time.
class Elastic {
 public:
  // cells: 0 for as many as are good.
  explicit Elastic(const SkinnedMesh& mesh, const ElasticOptions& options = {}, std::size_t cells = 0);
  ~Elastic();

  void pose(const Pose& pose, Positions& out) const;

  // Looks at poses, before it is asked for any: where the body pulls a vertex that follows one joint alone from that by
  // more than 2 % of the diagonal, as something beside it goes elsewhere, it goes by dual quaternions from then on.
  // Returns how many vertices do. A part of the mesh that the body stretches more than dual quaternions do, a plate or
  // a pouch, keeps from then on the shape that those give it, and goes where the body has its middle. On all cores.
  std::size_t look_at(const std::vector<Pose>& poses);

  // Of each vertex how much of it goes by dual quaternions, whatever the pose: 0 … 1.
  const std::vector<double>& rig_shares() const;
  const Body& body() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// poses: what it looks at. rig_shares: if not null, those of above.
Deformer elastic(const SkinnedMesh& mesh, const ElasticOptions& options = {}, const std::vector<Pose>& poses = {},
                 std::vector<double>* rig_shares = nullptr);

}  // namespace marrow::deform
