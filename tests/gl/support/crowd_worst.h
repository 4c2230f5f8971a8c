// Crowds' vertices as the GPU draws them against the CPU's: crowd_pose → build_palette → skinning.
#pragma once

#include <vector>

#include "gl/support/troop.h"
#include "gl/support/worst.h"
#include "gles3/crowd/crowd.h"

namespace marrow::test {

inline constexpr double kMostCrowdPosition = 2e-4;  // of the diagonal

// Every clip, speeds of both signs, blends that are to come, under way and over.
std::vector<gles3::CrowdInstance> some_of_each(const gles3::CrowdFrames& frames, std::size_t count, double around_s,
                                               double reach);

// One instance.
Worst compare_instance(const Mesh& mesh, const gles3::CrowdFrames& frames, const gles3::CrowdInstance& instance,
                       double time_s, gles3::Deformer deformer, Span<const float> coordinates,
                       Span<const float> tangents, const Skinned& got);

// All deformers, at some moments `after_s` after the times about which the instances start and blend.
Worst compare_crowd(const Mesh& mesh, const Reel& reel, Span<const float> tangents, double after_s,
                    std::uint32_t count = 12);

// Prints what there is, too.
void expect_crowd_promises(const char* what, const Worst& worst);

// Of a skeleton; every other one loops.
std::vector<gles3::CrowdSource> all_clips(const File& file, std::uint32_t skeleton);

}  // namespace marrow::test
