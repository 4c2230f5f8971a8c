// When feet stand, and how fast the ground goes below them.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "cook/motion/trace_clip.h"

namespace marrow::cook {

// A foot stands from `from` to `to`, both frames included.
struct Contact {
  std::size_t foot = 0;  // of ClipTrace::feet
  std::size_t from = 0;
  std::size_t to = 0;  // in a loop that goes on at its start beyond the last frame
};

struct Contacts {
  bool is_loop = false;        // the clip ends as it begins
  glm::dvec3 ground_m_s{0};    // level; of the ground that feet stand on: of a clip that walks on the spot backwards
  std::vector<Contact> spans;  // by `from`
};

// Contacts of all feet of a clip; none where the clip does not come near the ground that feet stand on at rest.
//
// The ground goes as the feet that are low do most of the time: not their mean but the mode of their velocities. A foot
// stands while it is low, and as fast as the ground; it begins more strictly than it goes on.
Contacts find_contacts(const ClipTrace& trace);

}  // namespace marrow::cook
