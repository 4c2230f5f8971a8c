// Feet of a character: their soles, where they stand on the ground, and that they stay there.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "cook/retarget/plan/retarget_plan.h"
#include "cook/retarget/plan/take.h"

namespace marrow::cook {

// The middle of the tops of the legs that carry.
struct Middle {
  glm::dvec3 own{0}, taken{0};
};
Middle middle_of(const RetargetPlan& plan, const Legs& legs, const Take& take, const Puppet& puppet);

// Where an ankle must go so that its foot is `offset` away from its counterpart's place, see offset_of(). The puppet is
// posed, but not yet carried.
glm::dvec3 ankle_at(const RetargetPlan& plan, const CarriedJoint& carried, std::size_t leg, const glm::dvec3& offset,
                    const Take& take, const Puppet& puppet);

// How far a foot's hold (FootHold) is from its counterpart's place when the leg points the same way. Both places are
// relative to the middle of the legs' tops, the take's scaled. The offset changes as wider hips turn and longer feet
// roll.
glm::dvec3 offset_of(const RetargetPlan& plan, const CarriedJoint& carried, std::size_t leg, const Take& take,
                     const Puppet& puppet);

// Whether the foot's counterpart touches the ground.
bool touches(const CarriedJoint& carried, std::size_t leg, const Take& take);

// A foot in a frame.
struct FootFrame {
  glm::dvec3 offset{0};
  bool touches = false;
};

// The offsets of one leg, frame by frame, so that the foot slides no more than its counterpart: during a contact with
// the ground the offset is its mean over that contact, and in between it goes over from one mean to the next. In a clip
// that ends as it begins, a contact goes on from the last frame to the first.
std::vector<glm::dvec3> held(const std::vector<FootFrame>& frames, double leg_length);

// The rotation of a joint's counterpart since rest, as the character faces.
glm::dquat taken_turn(const RetargetPlan& plan, const RetargetJoint& joint, const Take& take);

// Finds the ground of the clip that the take has taken up. Where a foot of motion capture stands, the character's
// stands as at rest: the capture's soles may not be level at rest.
void find_stance(RetargetPlan& plan, Take& take, Legs& legs);

// A vertex of a sole: the sum of its joints' maps, each applied to its own coordinate.
struct SolePoint {
  struct Share {
    std::size_t joint;
    glm::dvec4 coordinate;
  };
  std::vector<Share> shares;
  glm::dvec3 rest{0};  // in the scene

  glm::dvec3 at(const std::vector<glm::dmat4>& model_from_joint) const;
};

// What bends about one joint: the foot about the ankle, toes about theirs.
struct SolePart {
  std::size_t joint = 0;
  std::vector<std::size_t> turned;  // joints with counterparts that bend with it
  std::vector<SolePoint> points;
};

struct Sole {
  std::size_t leg = 0;          // of Legs::tops
  std::vector<SolePart> parts;  // the foot first
  double ground = 0;            // how high it rests
  glm::dvec3 forward{0};        // from the ankle to the farthest point at rest, level, of length 1; 0: nowhere
};

// Finds the vertices that ankles and toes carry and that can be lowest. meshes: of the character, all levels of detail.
// A foot without vertices gets points straight below its paired joints, as low as the lowest of these.
std::vector<Sole> find_soles(const RetargetPlan& plan, const Legs& legs, const std::vector<Mesh>& meshes);

// Where the take has its feet: a leg, in lengths of the character.
struct FootGoals {
  std::vector<double> ankle;   // how high it is above where it is when the foot stands
  std::vector<double> lowest;  // the lowest node's height, likewise
  // The ankle's x and z in the scene, of the puppet as it is posed, before it is carried.
  std::vector<glm::dvec3> place;
  std::vector<double> knee;  // the cosine of the knee's angle, -1 for straight legs
};

// Poses the feet and legs of a puppet, and returns by how much to raise it. An ankle goes as high as its counterpart.
// Feet, and then toes, slope downwards no more than the ground lets them. Then hip and knee raise a foot whose sole is
// still below the ground, and lower one that is higher than its counterpart's lowest. The character is raised so that
// no leg has to be longer, nor straighter than its counterpart. All this fades from a twentieth of the leg's length
// above the ground to a fifth; beyond that it only keeps soles out of the ground.
double stand(const RetargetPlan& plan, const Legs& legs, const std::vector<Sole>& soles, const FootGoals& goals,
             Puppet& puppet);

}  // namespace marrow::cook
