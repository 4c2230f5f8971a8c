// Roles that somebody gave: an avatar's file, or whoever cooks it.
#pragma once

#include <vector>

#include "cook/roles/role_body.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Those of "vrm/humanoid" properties. False: there are no hips among them, and the body is as it was.
bool give_avatar_roles(const RawScene& scene, const BuiltSkeleton& skeleton, Body& body);

// Those of the rules whose joints the body has. Of a tail the joint named and what hangs below it one by one.
void give_ruled_roles(const std::vector<RoleRule>& rules, Body& body);

// Throws tools::Failure (usage) for a joint that no skeleton has. Of settings for many files only where another rule
// fits, or the name is nearly that of a joint.
void check_rules_of_roles(const std::vector<RoleRule>& rules, const std::vector<BuiltSkeleton>& skeletons);

}  // namespace marrow::cook
