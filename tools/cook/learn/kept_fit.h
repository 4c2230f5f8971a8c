// What a mesh has learnt, as bytes that a cache keeps.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cook/learn/learn.h"

namespace marrow::cook {

// By all that learn() looks at.
std::string fit_key(const DeformSource& source, const std::vector<deform::TrainingPose>& poses,
                    const LearnOptions& options);

std::string to_bytes(const Learnt& learnt);
// Nothing for bytes that are not of a mesh with so many vertices and joints.
std::optional<Learnt> from_bytes(std::string_view bytes, const deform::SkinnedMesh& mesh);

// learn(), or what `notes.host->fits` has of the same.
Learnt learn_or_find(const DeformSource& source, std::vector<deform::TrainingPose> poses, const LearnOptions& options,
                     Notes& notes);

}  // namespace marrow::cook
