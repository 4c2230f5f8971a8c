// The smallest graphs on which the animator once did other than docs/cooking/graphs.md says.
#include "unit/graph/oracle_pair.h"

namespace marrow::test {
namespace {

struct SmallCase {
  const char* rule;
  const char* graph;
  const char* inputs;
};
const SmallCase kSmallCases[] = {
    {"A space that begins anew in a step has moved the root before, too.",
     R"(output = "m"
[parameters]
f = { type = "flag", initial = true }
p = { type = "number", range = [0, 1], initial = 0.4 }
[node.s]
type = "space"
by = "p"
sync = true
points = [{ at = 0, pose = "run" }, { at = 1, pose = "walk" }]
[node.m]
type = "machine"
start = "a"
state.a = { pose = "s" }
state.b = { pose = "idle" }
transition = [
  { from = "a", to = "b", after = 0.5, fade = 0.2 },
  { from = "b", to = "a", when = "f", fade = 0.1 },
]
)",
     "dt 0.3 dt 0.15 dt 0.3"},
    {"A state whose fade ends in an update.",
     R"(output = "m"
[node.m]
type = "machine"
start = "a"
state.a = { pose = "turn" }
state.b = { pose = "idle" }
transition = [
  { from = "a", to = "b", at_end = 0.2, fade = 0.2 },
]
)",
     "dt 0.71 dt 0.5 dt 0.5"},
    {"A trigger without hold counts for one update, not for a part of it.",
     R"(output = "m"
[parameters]
t = { type = "trigger" }
[node.m]
type = "machine"
start = "a"
state.a = { pose = "run" }
state.b = { pose = "idle" }
transition = [
  { from = "a", to = "b", when = "t", after = 0.5, fade = 0 },
]
)",
     "dt 0.49 fire t dt 0.02"},
    {"A trigger without hold counts for one update of 0 s, too.",
     R"(output = "m"
[parameters]
t = { type = "trigger" }
f = { type = "flag" }
[node.m]
type = "machine"
start = "a"
state.a = { pose = "run" }
state.b = { pose = "idle" }
transition = [
  { from = "a", to = "b", when = ["t", "f"], fade = 0 },
]
)",
     "dt 0.3 fire t dt 0 flag f 1 dt 0.1"},
    {"A machine that switches within a step is there as much as before.",
     R"(output = "l"
[node.l]
type = "layer"
base = "run"
pose = "m"
weight = 0.5
[node.m]
type = "machine"
start = "a"
state.a = { pose = "idle" }
state.b = { pose = "idle" }
transition = [
  { from = "a", to = "b", after = 0.4, fade = 0 },
]
)",
     "dt 0.3 dt 0.3"},
    {"A machine that shows something from the middle of a step on is there as long.",
     R"(output = "l"
[node.l]
type = "layer"
base = "run"
pose = "m"
weight = 0.5
[node.m]
type = "machine"
start = "a"
state.a = { }
state.b = { pose = "idle" }
transition = [
  { from = "a", to = "b", after = 0.4, fade = 0 },
]
)",
     "dt 0.3 dt 0.3"},
    {"Of more than four states the one that has the least is dropped, also if it is the newest.",
     R"(output = "m"
[node.m]
type = "machine"
start = "a"
state.a = { pose = "run" }
state.b = { pose = "walk" }
state.c = { pose = "turn" }
state.d = { pose = "jump" }
state.e = { pose = "idle" }
transition = [
  { from = "a", to = "b", after = 0.1, fade = 1 },
  { from = "b", to = "c", after = 0.5, fade = 1 },
  { from = "c", to = "d", after = 0.5, fade = 1 },
  { from = "d", to = "e", after = 0.05, fade = 1 },
]
)",
     "dt 0.3 dt 0.3 dt 0.3 dt 0.3 dt 0.1"},
    {"The phase of a state that was entered in the same step.",
     R"(output = "m"
[node.m]
type = "machine"
start = "a"
state.a = { pose = "idle" }
state.b = { pose = "run" }
state.c = { pose = "walk" }
transition = [
  { from = "a", to = "b", after = 0.5, fade = 0, enter = 0.3 },
  { from = "b", to = "c", after = 0.1, fade = 0, enter = "same_phase" },
]
)",
     "dt 0.45 dt 0.17"},
    {"A state that is left and entered again in one step is not heard between.",
     R"(output = "m"
[node.m]
type = "machine"
start = "a"
state.a = { pose = "walk" }
state.b = { pose = "idle" }
transition = [
  { from = "a", to = "b", after = 0.45, fade = 0 },
  { from = "b", to = "a", after = 0.1, fade = 0, enter = "same_phase" },
]
)",
     "dt 0.4 dt 0.3"},
    {"A state that is entered in an update of 0 s has begun.",
     R"(output = "m"
[parameters]
t = { type = "trigger" }
[node.m]
type = "machine"
start = "a"
state.a = { pose = "idle" }
state.b = { pose = "run" }
transition = [
  { from = "a", to = "b", when = "t", fade = 0.2, enter = 0.05 },
]
)",
     "dt 0.3 fire t dt 0 dt 0.1 dt 0.1"},
    {"What a layer lays over begins anew with the layer.",
     R"(output = "m"
[parameters]
t = { type = "trigger" }
[node.l]
type = "layer"
base = "idle"
pose = "walk"
weight = 0.5
[node.m]
type = "machine"
start = "a"
state.a = { pose = "l" }
transition = [
  { from = "a", to = "a", when = "t", fade = 0.2 },
]
)",
     "dt 0.3 fire t dt 0.25"},
    {"A machine decides nothing in the moment in which its state is left.",
     R"(output = "m"
[parameters]
t = { type = "trigger" }
u = { type = "trigger" }
[node.inner]
type = "machine"
start = "a"
state.a = { pose = "idle" }
state.b = { pose = "walk" }
transition = [{ from = "a", to = "b", when = "u", fade = 0.2 }]
[node.m]
type = "machine"
start = "a"
state.a = { pose = "inner" }
state.b = { pose = "idle" }
transition = [
  { from = "a", to = "b", when = "t", fade = 0.2 },
]
)",
     "dt 0.3 fire t fire u dt 0.01"},
    {"A state without weight is not shown, so what it gives way to may be faded to.",
     R"(output = "m"
[parameters]
t = { type = "trigger" }
u = { type = "trigger" }
v = { type = "trigger" }
[node.m]
type = "machine"
start = "a"
state.a = { pose = "run" }
state.b = { pose = "idle" }
state.c = { pose = "walk" }
transition = [
  { from = "a", to = "b", when = "t", fade = 0.2 },
  { from = "b", to = "c", when = "u", fade = 0.2 },
  { from = "c", to = "b", when = "v", fade = 0.2 },
]
)",
     "dt 0.4 fire t fire u dt 0.01 fire v dt 0.01"},
};

TEST(Oracle, AgreesOnSmallCases) {
  for (const SmallCase& each : kSmallCases) {
    Pair pair(each.graph, 1);
    EXPECT_EQ(pair.run(each.inputs), "") << each.rule << "\n" << each.graph << each.inputs;
  }
}

}  // namespace
}  // namespace marrow::test
