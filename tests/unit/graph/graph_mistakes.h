// A whole graph of which one line is exchanged for a wrong one, and what must be said of it.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "cook/graph/build_graph.h"

namespace marrow::cook {

// A whole graph, line by line, as it should be.
inline const std::vector<std::string> kLines = {
    "output = 'all'",                                                             // 1
    "[parameters]",                                                               // 2
    "speed = { type = 'number', range = [0, 6], initial = 1, half_life = 0.1 }",  // 3
    "bend = { type = 'number', range = [-1, 1] }",                                // 4
    "armed = { type = 'flag', initial = true }",                                  // 5
    "jump = { type = 'trigger', hold = 0.2 }",                                    // 6
    "[node.slow]",                                                                // 7
    "type = 'clip'",                                                              // 8
    "clip = 'walk'",                                                              // 9
    "speed = 0.5",                                                                // 10
    "play = 'ping_pong'",                                                         // 11
    "[node.gaits]",                                                               // 12
    "type = 'space'",                                                             // 13
    "by = 'speed'",                                                               // 14
    "points = [ { at = 0, pose = 'idle' }, { pose = 'slow' } ]",                  // 15
    "match_speed = true",                                                         // 16
    "sync = true",                                                                // 17
    "[node.plane]",                                                               // 18
    "type = 'space'",                                                             // 19
    "by = ['speed', 'bend']",                                                     // 20
    "points = [ { at = [0, 0], pose = 'gaits' }, { at = [1, 0], pose = 'idle' }, { at = [0, 1], pose = 'run' } "
    "]",                                                                                                  // 21
    "[node.body]",                                                                                        // 22
    "type = 'machine'",                                                                                   // 23
    "start = 'ground'",                                                                                   // 24
    "state.ground = { pose = 'plane' }",                                                                  // 25
    "state.air = { pose = 'fly' }",                                                                       // 26
    "state.land = { pose = 'hit' }",                                                                      // 27
    "transition = [",                                                                                     // 28
    "  { from = 'ground', to = 'air', when = ['jump', 'speed > 0.5'], fade = 0.1, kind = 'inertial' },",  // 29
    "  { from = ['air'], to = 'land', after = 0.5, enter = 0.25 },",                                      // 30
    "  { from = 'land', to = 'ground', at_end = 0.1, fade = 0.1, enter = 'same_phase' },",                // 31
    "  { from = '*', to = ['air', 'land'], choose = 'turn', when = 'not armed' },",                       // 32
    "]",                                                                                                  // 33
    "[node.guard]",                                                                                       // 34
    "type = 'layer'",                                                                                     // 35
    "base = 'body'",                                                                                      // 36
    "pose = 'block'",                                                                                     // 37
    "mask = [ { role = 'chest', falloff = 2 }, { joint = 'tail' } ]",                                     // 38
    "weight = 'armed'",                                                                                   // 39
    "fade = 0.1",                                                                                         // 40
    "[node.lean]",                                                                                        // 41
    "type = 'add'",                                                                                       // 42
    "base = 'guard'",                                                                                     // 43
    "pose = 'leaning'",                                                                                   // 44
    "weight = 0.5",                                                                                       // 45
    "[node.all]",                                                                                         // 46
    "type = 'one_shot'",                                                                                  // 47
    "base = 'lean'",                                                                                      // 48
    "pose = 'strike'",                                                                                    // 49
    "when = 'jump'",                                                                                      // 50
    "fade_in = 0.1",                                                                                      // 51
    "[node.variants]",                                                                                    // 52
    "type = 'pick'",                                                                                      // 53
    "poses = ['a', 'b']",                                                                                 // 54
    "choose = 'chance'",                                                                                  // 55
    "[node.ragdoll]",                                                                                     // 56
    "type = 'given'",                                                                                     // 57
};

// line: from 1; 0: as it is.
inline std::string text_with(std::size_t line, const std::string& other) {
  std::string out;
  for (std::size_t i = 0; i < kLines.size(); ++i) out += (i + 1 == line ? other : kLines[i]) + "\n";
  return out;
}

struct Mistake {
  std::size_t line;  // from 1; 0: the text is all of the file
  const char* text;
  const char* where;
  const char* says;
};

// The file, the place and the word that helps; what the cooker would write is not made.
inline void expect_located(const Mistake& m, const std::string& text) {
  Notes notes;
  BuiltGraph built;
  try {
    built = build_graph(parse_graph("wrong.anim.toml", text), notes);
    ADD_FAILURE() << "nothing is wrong with " << m.text;
  } catch (const tools::Failure& f) {
    EXPECT_EQ(f.code(), tools::Exit::usage) << m.text;
    EXPECT_EQ(f.file(), "wrong.anim.toml") << m.text;
    EXPECT_TRUE(f.where().starts_with(m.where)) << f.what() << "\nnot at " << m.where << ": " << m.text;
    EXPECT_NE(std::string(f.what()).find(m.says), std::string::npos) << f.what() << "\nnot " << m.says;
    EXPECT_TRUE(built.nodes.empty() && built.name.empty());
  }
}
inline void expect_located(const std::vector<Mistake>& mistakes) {
  for (const Mistake& m : mistakes) expect_located(m, m.line == 0 ? m.text : text_with(m.line, m.text));
  std::printf("%zu mistakes\n", mistakes.size());
}

}  // namespace marrow::cook
