// Truths: what each makes of a mesh, and what it cannot do for a mesh or in a pose, which is warned of and kept out of
// what is learnt.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"
#include "cook/skin/deform_source.h"
#include "deform/fit/fit.h"
#include "deform/fit/remembered.h"

namespace marrow::cook {

// How many poses tell where the elastic truth does not apply.
inline constexpr std::size_t kLookedAt = 48;

const char* name_of(Truth truth);
// Refers to `source`.
deform::Deformer make_truth(const DeformSource& source, const LearnOptions& options);

// Makes `source.elastic` where that is the truth, and notes where it does not apply: by the source's range of motion,
// too. `source`, of `mesh`, must not move afterwards. most_bytes: of poses that it keeps.
void remember_truth(const LearnOptions& options, const RawScene& scene, const RawSkin& skin, const RawMesh& mesh,
                    DeformSource& source, Notes& notes, std::size_t most_bytes = deform::kRememberedBytes);

// Shortens delta mush's steps where smoothing would leave less than deform::kLeastArea of the mesh's area, with a
// warning. Options that do not smooth stay as they are.
LearnOptions with_gentle_steps(LearnOptions options, const deform::SkinnedMesh& mesh, const std::string& pointer,
                               Notes& notes);

// In which poses a truth says where the mesh is.
class UsablePoses {
 public:
  UsablePoses(const deform::SkinnedMesh& mesh, Truth truth);

  // The first joint that spoils the pose: one whose matrix is not finite and that a vertex follows; where the truth
  // blends rotations, also one that has none, of scale 0 say, and that a vertex follows beside another joint.
  std::optional<std::uint32_t> spoiling_joint(const deform::Pose& pose) const;

 private:
  std::vector<char> followed_, shared_;  // a joint
  bool blends_rotations_;
};

// Leaves out the poses that are not usable, with a warning that names the joint which spoils the most.
void drop_spoilt_poses(const RawScene& scene, const RawSkin& skin, const deform::SkinnedMesh& mesh, Truth truth,
                       const std::string& pointer, std::vector<deform::TrainingPose>& poses, Notes& notes);

// Notes about which joints of the mesh, `raw`, most vertices keep to dual quaternions where the truth is elastic, if
// many do.
void note_stiff_parts(const RawScene& scene, const RawSkin& skin, const RawMesh& raw, const deform::SkinnedMesh& mesh,
                      const std::vector<double>& rig_shares, Notes& notes);

}  // namespace marrow::cook
