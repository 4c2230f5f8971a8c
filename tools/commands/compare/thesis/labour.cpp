#include "commands/compare/thesis/labour.h"

namespace marrow::tools {
namespace {

// One less than a vertex has joints, as they sum to 1.
double weights_per_vertex(const deform::SkinnedMesh& mesh) {
  std::size_t out = 0;
  for (const auto& influences : mesh.influences) out += influences.size();
  return static_cast<double>(out) / static_cast<double>(mesh.influences.size()) - 1;
}

bool is_learnt(const std::string& deformer) {
  return deformer == "ssd_refit" || deformer == "as_fit" || deformer.starts_with("as_helpers_fit") ||
         deformer == "mwe" || deformer == "psd" || deformer == "eigenskin";
}

}  // namespace

Labour labour_of(const std::string& deformer, const Study& study, std::size_t shown_poses) {
  if (deformer == "rigid" || deformer == "stitched") return {1, 0, 0, "a joint"};
  if (deformer == "joint_local") return {1, 0, 0, "a joint, and for each joint where it acts"};
  Labour out;
  out.numbers_per_vertex = weights_per_vertex(study.source.mesh);
  out.of_what = "weights";
  if (is_learnt(deformer) && shown_poses > 0) {
    out.files = 1;
    out.poses = shown_poses;
  }
  return out;
}

}  // namespace marrow::tools
