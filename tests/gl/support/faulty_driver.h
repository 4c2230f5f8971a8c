// A driver between the code under test and the real one: counts calls and objects, loses the context, runs out of
// memory.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "marrow/gles3.h"

namespace marrow::test {

struct FaultyDriver {
  gles3::Api real;
  std::int64_t calls = 0;
  std::int64_t lost_after = -1;               // calls; from then on they do nothing. -1: never
  std::int64_t full_after = -1;               // allocations; from then on they fail
  std::int64_t allocations = 0;               // glBufferData and glTexImage2D with a size
  std::int64_t uploaded_bytes = 0;            // by them with data, and by their Sub forms
  unsigned reset = 0;                         // that glGetGraphicsResetStatus has not told yet
  unsigned error = 0;                         // that glGetError has not told yet
  std::map<std::string, std::int64_t> count;  // calls by name
  std::int64_t live = 0;                      // objects made and not deleted
  std::int64_t made = 0;                      // of any kind but shaders
  std::int64_t label_count = 0;               // since record_labels()
  // The last label by kind and name of the object, and how many it got.
  struct Label {
    std::string text;
    int count = 0;
  };
  std::map<std::pair<unsigned, unsigned>, Label> labels;

  bool is_lost() const { return lost_after >= 0 && calls > lost_after; }
};

// One a process.
FaultyDriver& driver();

// Notes labels instead of passing them on.
void record_labels(gles3::Api& api);

// Entry points that go through it to `real`. Its counts start anew.
gles3::Api faulty_api(const gles3::Api& real);

}  // namespace marrow::test
