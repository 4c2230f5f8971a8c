// When the feet of a clip's own rig stand.
#pragma once

#include <utility>
#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/raw.h"
#include "marrow/roles.h"

namespace marrow::cook {

// From and to, in seconds, ascending; of a loop a span that goes on at its start is two.
struct FootSpans {
  Role foot = Role::none;
  std::vector<std::pair<double, double>> spans_s;
};

// As find_contacts() has them, of every foot with a role. `rig`: a skeleton of the scene, with roles. None where the
// clip is too short or too long to be looked at.
std::vector<FootSpans> taken_contacts(const BuiltSkeleton& rig, const RawClip& clip);

}  // namespace marrow::cook
