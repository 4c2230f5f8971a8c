// Feet of a character on the ground, where a take has them.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "cook/retarget/feet/retarget_soles.h"
#include "cook/retarget/plan/retarget_puppet.h"

namespace marrow::cook {

// Where the take has its feet: a leg, in lengths of the character.
struct FootGoals {
  std::vector<double> ankle;   // how high it is above where it is when the foot stands
  std::vector<double> lowest;  // the lowest node's height, likewise
  std::vector<glm::dvec3>
      place;                 // the ankle's x and z in the scene, of the puppet as it is posed, before it is carried
  std::vector<double> knee;  // the cosine of the knee's angle, -1 for straight legs
};

// Poses the feet and legs of a puppet, and returns by how much to raise it. An ankle goes as high as its counterpart.
// Feet, and then toes, slope downwards no more than the ground lets them. Then a foot whose sole is still below the
// ground is raised, or one that is higher than its counterpart's lowest is lowered, by the hip and the knee. The
// character is raised so that no leg has to be longer, nor straighter than its counterpart. All this grows less as the
// foot is higher than a twentieth of the leg, and is only what keeps soles out of the ground beyond a fifth.
double stand(const RetargetPlan& plan, const Legs& legs, const std::vector<Sole>& soles, const FootGoals& goals,
             Puppet& puppet);

}  // namespace marrow::cook
