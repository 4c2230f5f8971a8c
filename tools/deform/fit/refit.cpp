#include "deform/fit/refit.h"

#include "common/parallel.h"
#include "deform/dense.h"

namespace marrow::deform {

// With the last weight as what the others leave: Σ_{j<last} δ_j (M_j v - M_last v) is what the truth has beside SSD.
SkinnedMesh refit_weights(const SkinnedMesh& mesh, const std::vector<TrainingPose>& poses, const Deformer& truth,
                          double ridge) {
  std::vector<Positions> wanted(poses.size());
  tools::for_each_in_parallel(poses.size(), [&](std::size_t i) { truth(poses[i].pose, wanted[i]); });
  SkinnedMesh out = mesh;
  tools::for_each_in_parallel(mesh.positions.size(), [&](std::size_t v) {
    std::vector<Influence>& influences = out.influences[v];
    const auto unknowns = static_cast<Eigen::Index>(influences.size()) - 1;
    if (unknowns < 1) return;
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(unknowns, unknowns);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
    Eigen::Matrix3Xd a(3, unknowns);
    for (std::size_t e = 0; e < poses.size(); ++e) {
      const Pose& pose = poses[e].pose;
      const glm::dvec3 last = transform(pose[influences.back().joint], mesh.positions[v]);
      glm::dvec3 missing = wanted[e][v] - last;
      for (Eigen::Index j = 0; j < unknowns; ++j) {
        const Influence& i = influences[static_cast<std::size_t>(j)];
        const glm::dvec3 apart = transform(pose[i.joint], mesh.positions[v]) - last;
        a.col(j) << apart.x, apart.y, apart.z;
        missing -= apart * i.weight;
      }
      normal.noalias() += a.transpose() * a;
      right.noalias() += a.transpose() * Eigen::Vector3d(missing.x, missing.y, missing.z);
    }
    const double hold = ridge * normal.trace() / static_cast<double>(unknowns);
    if (!(hold > 0)) return;
    normal.diagonal().array() += hold;
    const Eigen::VectorXd delta = solve_symmetric(normal, right);
    for (Eigen::Index j = 0; j < unknowns; ++j) {
      influences[static_cast<std::size_t>(j)].weight += delta[j];
      influences.back().weight -= delta[j];
    }
  });
  return out;
}

}  // namespace marrow::deform
