// Where the panel begins, and what of it stays when another character is shown.
#pragma once

#include <optional>

#include "commands/view/view.h"
#include "commands/view/view_actor.h"

namespace marrow::tools {

// As the arguments have it. pair: of --heatmap. Throws Failure (usage): a joint that is not there, springs where none
// are.
ViewSettings first_settings(const ViewArguments& arguments, const std::optional<DeformerPair>& pair,
                            const ViewActor& actor);

// The same for another actor: clips and joints are known by their names, all else stays.
void carry_over(const Actor& from, const Actor& to, Settings& settings);

}  // namespace marrow::tools
