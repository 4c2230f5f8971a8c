// Feet of a character on the ground, where motion capture has them.
#pragma once

#include <vector>

#include "cook/prepare/retarget/retarget_puppet.h"
#include "cook/prepare/retarget/retarget_soles.h"

namespace marrow::cook {

// How high above the ground a captured foot is, a leg, in lengths of the character.
struct FootHeights {
  std::vector<double> ankle;   // above where it is when the foot stands
  std::vector<double> lowest;  // the lowest node's, likewise
};

// Poses the feet and legs of a puppet, and returns by how much to raise it. An ankle goes as high as its counterpart.
// Feet, and then toes, slope downwards no more than the ground lets them. Then a foot whose sole is still below the
// ground is raised, or one that is higher than its counterpart's lowest is lowered, by the hip and the knee. The
// character is raised so that no leg has to be longer. All this grows less as the foot is higher than a twentieth of
// the leg, and is only what keeps soles out of the ground beyond a fifth.
double stand(const RetargetPlan& plan, const Legs& legs, const std::vector<Sole>& soles, const FootHeights& heights,
             Puppet& puppet);

}  // namespace marrow::cook
