// A clip of a take, frame by frame, on a character's joints.
#pragma once

#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include "cook/retarget/feet/retarget_soles.h"
#include "cook/retarget/plan/retarget_plan.h"
#include "cook/retarget/plan/take.h"
#include "cook/retarget/taken_contacts.h"
#include "cook/scene/built.h"

namespace marrow::cook {

// The keys of each joint, one a frame; none: it does not move.
struct TakenKeys {
  std::vector<std::vector<glm::vec4>> turns, places;
};

// The clip that the take has taken up, on the character's skeleton. `meshes`: of that. Feet
// without `contacts` stand while they are low. Throws tools::Failure (invalid)
// where a place comes out beyond what a file may hold; `file`: of the character.
TakenKeys play_take(const BuiltSkeleton& skeleton, RetargetPlan& plan, Take& take,
                    const std::vector<FootSpans>& contacts, const std::vector<Mesh>& meshes, const std::string& file);

}  // namespace marrow::cook
