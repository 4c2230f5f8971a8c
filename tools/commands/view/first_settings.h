// Where the panel begins, and what of it stays when another character is shown.
#pragma once

#include <optional>

#include "commands/view/stage/actor.h"
#include "commands/view/stage/view_settings.h"
#include "commands/view/view.h"

namespace marrow::tools {

// As the arguments have it. pair: of --heatmap. Throws Failure (usage): a joint that is not there, springs where none
// are.
Settings first_settings(const ViewArguments& arguments, const std::optional<DeformerPair>& pair, const Actor& actor);

// The same for another actor: clips and joints are known by their names, all else stays.
void carry_over(const Actor& from, const Actor& to, Settings& settings);

}  // namespace marrow::tools
