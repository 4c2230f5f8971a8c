// Frames a second of every algorithm, for the meshes that the thesis of animation space measured.
#pragma once

#include <string>
#include <vector>

#include "cook/scene/cook_options.h"
#include "text/choices.h"

namespace marrow::tools {

struct ThesisSize {
  const char* name;
  std::uint32_t vertices, joints;
};
inline constexpr ThesisSize kThesisSizes[] = {
    {"1000 × 3", 1000, 3}, {"2000 × 3", 2000, 3}, {"4000 × 5", 4000, 5}, {"8000 × 7", 8000, 7}};

// What is judged beside the rows of compare. The last is what others learn from in processor_rates().
inline constexpr Named<cook::Truth> kJudgedTruths[] = {{"dqs", cook::Truth::dual_quaternions},
                                                       {"delta-mush", cook::Truth::delta_mush},
                                                       {"cor", cook::Truth::centres_of_rotation}};

struct FrameRate {
  std::string algorithm;  // as rows of compare are called
  std::string path;       // "kernel": the runtime's, one core; "double": offline, in double precision, one core; or the
                          // GPU's, from the first call to a pixel read back
  bool normals = false;   // else positions alone
  std::vector<double> frames_per_s;  // a size
};

// Four influences a vertex; with helpers five, and as many helpers as joints.
std::vector<FrameRate> processor_rates(const cook::LearnOptions& options);

// full: with normals, too. driver: its name. Throws Failure (unsupported) without OpenGL ES.
std::vector<FrameRate> gpu_rates(bool full, std::string& driver);

}  // namespace marrow::tools
