// What the sample does in the demo, as a game would have it: the newt turns, walks a figure eight, sees a firefly, runs
// after it, hops over a stone, gets the firefly on its head, stops and turns back to where it began.
//
// It goes by its graph, newt.anim.toml. The game sets parameters, steers by a small turn a step, and places feet and
// looks. The same numbers come out each time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "marrow/pose.h"
#include "marrow/roles.h"

namespace marrow::tools {

inline constexpr int kStoryFps = 60;

// Files that it is told with: `marrow sample`, cooked, and its clips as a pack that has its graph.
struct StoryFiles {
  std::string character, moves;
};
// Cooks the pack for the character, into the character's folder. character: the sample, cooked in any way. Throws
// Failure.
StoryFiles cook_story(const std::string& character);

struct Print {
  std::size_t foot = 0;  // 0: the left one
  glm::vec3 at{0};       // below the ball of the foot, on the ground
  float heading_rad = 0;
  std::size_t from = 0, until = 0;  // steps in which the foot is there; until: the first without
};

struct Happening {
  std::string what;  // a state of the graph's machine that is entered, or what the game did
  std::size_t at = 0;
};

// A step of the story.
struct StoryStep {
  std::vector<Affine> world_from_joint;  // of the sample's skeleton
  glm::vec3 root{0};                     // where the newt is
  float heading_rad = 0;                 // from +Z towards +X
  glm::vec3 firefly{0};
};

struct Story {
  std::vector<StoryStep> steps;  // kStoryFps a second
  std::vector<Print> prints;     // by `from`
  std::vector<Happening> happenings;
  glm::vec3 stone{0};  // the middle of its lower side
  float stone_radius = 0, stone_height = 0;
};

// Throws Failure.
Story tell_story(const StoryFiles& files);

}  // namespace marrow::tools
