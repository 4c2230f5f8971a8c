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

  // Of each vertex how much of it goes by dual quaternions, whatever the pose: 0 … 1.
  const std::vector<double>& rig_shares() const;
  const Body& body() const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

// rig_shares: if not null, those of above.
Deformer elastic(const SkinnedMesh& mesh, const ElasticOptions& options = {},
                 std::vector<double>* rig_shares = nullptr);

}  // namespace marrow::deform
