// Weights of morph targets by graphs: means of what clips say, worked out by hand.
#include "unit/graph/graph_rig.h"

namespace marrow::test {
namespace {

// Where no clip drives them: smile, blink, frown.
constexpr double kRest[3] = {0.1, 0, 0.25};

// A face of three targets, and clips that drive some of them. "a": smile 0.6, blink 0.2. "b": smile from 0 to 1 in 2 s.
// "c": frown 0.75. "still": none.
GraphRigMade face_rig() {
  GraphRigMade out;
  out.clips = {{"a", 1.0f, 0, 0, {}, {}},
               {"b", 2.0f, 0, 0, {}, {}},
               {"c", 1.0f, 0, 0, {}, {}},
               {"still", 1.0f, 0, 0, {}, {}},
               {"anger", 1.0f, 0, 0, {}, {}}};
  cook::RawScene& scene = out.scene;
  scene = cook::raw_rig({{"hips", -1, {0, 1, 0}}, {"chest", 0, {0, 1.3, 0}}, {"head", 1, {0, 1.6, 0}}}, 2);
  const int face = static_cast<int>(scene.nodes.size());
  scene.nodes.emplace_back().name = "face";
  cook::RawMesh& mesh = scene.meshes.emplace_back();
  mesh.name = "face";
  cook::RawPrimitive& primitive = mesh.primitives.emplace_back();
  primitive.pointer = "/meshes/0/primitives/0";
  primitive.positions = {{0, 1.6f, 0}, {0.1f, 1.6f, 0}, {0, 1.7f, 0}};
  primitive.indices = {0, 1, 2};
  primitive.influences.assign(3, {{2, 1.0f}});
  const char* const names[3] = {"smile", "blink", "frown"};
  for (std::size_t t = 0; t < 3; ++t) {
    mesh.weights.push_back({names[t], std::string("face.") + names[t], static_cast<float>(kRest[t])});
    cook::RawTarget& target = primitive.targets.emplace_back();
    target.positions.assign(3, glm::vec3(0.01f * static_cast<float>(t + 1), 0, 0));
  }
  cook::RawInstance& instance = scene.instances.emplace_back();
  instance.node = face;
  instance.mesh = 0;
  instance.skin = 0;
  instance.weights = mesh.weights;
  const auto drive = [&](cook::RawClip& clip, std::size_t target, float from, float to, float duration_s) {
    clip.scalars.push_back({mesh.weights[target].channel,
                            face,
                            mesh.weights[target].rest,
                            cook::RawInterpolation::linear,
                            {0, duration_s},
                            {from, to}});
  };
  for (const GraphClipMade& made : out.clips) {
    cook::RawClip& clip = scene.clips.emplace_back();
    clip.name = made.name;
    cook::RawChannel turn{3, cook::RawPath::rotation, cook::RawInterpolation::linear, {0, made.duration_s}, {}};
    const glm::dquat q = scene.nodes[3].rotation;
    turn.values.assign(2, glm::vec4(q.x, q.y, q.z, q.w));
    clip.channels.push_back(turn);
    const std::string name = made.name;
    if (name == "a") drive(clip, 0, 0.6f, 0.6f, 1), drive(clip, 1, 0.2f, 0.2f, 1);
    if (name == "b") drive(clip, 0, 0, 1, 2);
    if (name == "c" || name == "anger") drive(clip, 2, 0.75f, 0.75f, 1);
  }
  out.options = graph_options(out.clips);
  out.options.clips.additive = {{"anger", "rest", {}}};
  return out;
}

class Face : public GraphRig {
 public:
  explicit Face(const std::string& text) : GraphRig(text, {}, face_rig()) {
    EXPECT_EQ(character.meshes.size, 1u);
    EXPECT_EQ(character.meshes[0].weights.size, 3u);
  }
  void expect(double smile, double blink, double frown) {
    for (int again = 0; again < 2; ++again) {  // nothing piles up
      ASSERT_EQ(pose_character(character, animator), Status::ok);
      const double wanted[3] = {smile, blink, frown};
      for (std::size_t t = 0; t < 3; ++t) EXPECT_NEAR(character.meshes[0].weights[t], wanted[t], 2e-4) << t;
    }
  }
};

double smoothstep(double u) {
  return 3 * u * u - 2 * u * u * u;
}

constexpr const char* kNumbers = R"(
[parameters]
x = { type = "number", range = [0, 1] }
y = { type = "number", range = [0, 1] }
on = { type = "flag" }
go = { type = "trigger" }
)";
std::string with(const char* output, const char* nodes) {
  return std::string("output = \"") + output + "\"\n" + kNumbers + nodes;
}

TEST(GraphMorphs, OfAClip) {
  Face face("output = \"b\"\n");
  face.step(0.5);
  face.expect(0.25, kRest[1], kRest[2]);
  Face still("output = \"still\"\n");
  still.step(0.5);
  still.expect(kRest[0], kRest[1], kRest[2]);
}

// A target that a point's clip does not drive is at rest there.
TEST(GraphMorphs, OfASpace) {
  Face face(with("s", R"(
[node.s]
type = "space"
by = "x"
points = [ { at = 0, pose = "a" }, { at = 1, pose = "b" } ]
)"));
  face.set_number("x", 0.25);
  face.step(1);
  face.expect(0.75 * 0.6 + 0.25 * 0.5, 0.75 * 0.2, kRest[2]);
  face.set_number("x", 1);
  face.step(0.5);
  face.expect(0.75, 0, kRest[2]);

  // Half of the way from a to b and a quarter to c: their barycentric shares are 1/4, 1/2, 1/4.
  Face plane(with("s", R"(
[node.s]
type = "space"
by = ["x", "y"]
points = [ { at = [0, 0], pose = "a" }, { at = [1, 0], pose = "b" }, { at = [0, 1], pose = "c" } ]
)"));
  plane.set_number("x", 0.5);
  plane.set_number("y", 0.25);
  plane.step(1);
  plane.expect(0.25 * 0.6 + 0.5 * 0.5 + 0.25 * kRest[0], 0.25 * 0.2, 0.75 * kRest[2] + 0.25 * 0.75);
}

TEST(GraphMorphs, OfALayer) {
  const char* const layer = R"(
[node.l]
type = "layer"
base = "a"
pose = "c"
weight = "x"
)";
  Face face(with("l", layer));
  for (const double x : {0.0, 0.3, 1.0}) {
    face.set_number("x", x);
    face.step(0.1);
    face.expect((1 - x) * 0.6 + x * kRest[0], (1 - x) * 0.2, (1 - x) * kRest[2] + x * 0.75);
  }
  // What has a mask changes joints alone.
  Face masked(with("l", (std::string(layer) + "mask = { joint = \"chest\" }\n").c_str()));
  masked.set_number("x", 0.3);
  masked.step(0.1);
  masked.expect(0.6, 0.2, kRest[2]);
  // A flag's ramp, after a quarter of its 0.4 s.
  Face ramp(with("l", R"(
[node.l]
type = "layer"
base = "a"
pose = "c"
weight = "on"
fade = 0.4
)"));
  ramp.step(0.1);
  ramp.set_flag("on", true);
  ramp.step(0.1);
  const double w = smoothstep(0.25);
  ramp.expect((1 - w) * 0.6 + w * kRest[0], (1 - w) * 0.2, (1 - w) * kRest[2] + w * 0.75);
}

TEST(GraphMorphs, OfAMachine) {
  const auto machine = [](const char* kind) {
    return std::string(R"(
[node.m]
type = "machine"
start = "one"
state.one = { pose = "a" }
state.two = { pose = "b" }
transition = [ { from = "one", to = "two", when = "go", fade = 0.4, kind = ")") +
           kind + "\" } ]\n";
  };
  Face face(with("m", machine("cross").c_str()));
  face.step(0.3);
  face.fire("go");
  face.step(0.1);
  const double w = smoothstep(0.25);
  face.expect((1 - w) * 0.6 + w * 0.05, (1 - w) * 0.2, kRest[2]);
  face.step(0.4);
  face.expect(0.25, 0, kRest[2]);
  // A fade that is inertial is of joints: weights are the new state's.
  Face inertial(with("m", machine("inertial").c_str()));
  inertial.step(0.3);
  inertial.expect(0.6, 0.2, kRest[2]);
  inertial.fire("go");
  inertial.step(0.1);
  inertial.expect(0.05, 0, kRest[2]);
}

// A third state before the second has come: what was shown keeps its ratio in what is left.
TEST(GraphMorphs, OfAFadeThatIsInterrupted) {
  Face face(with("m", R"(
[node.m]
type = "machine"
start = "one"
state.one = { pose = "a" }
state.two = { pose = "c" }
state.three = { pose = "still" }
transition = [
  { from = "one", to = "two", when = "go", fade = 0.4 },
  { from = "two", to = "three", when = "on", fade = 0.2 },
]
)"));
  face.step(0.1);
  face.fire("go");
  face.step(0.2);
  face.set_flag("on", true);
  face.step(0.05);
  const double third = smoothstep(0.25), left = (1 - third) * 0.5;  // of each of the first two
  face.expect(left * 0.6 + (1 - left) * kRest[0], left * 0.2, left * 0.75 + (1 - left) * kRest[2]);
}

TEST(GraphMorphs, OfAOneShot) {
  Face face(with("o", R"(
[node.o]
type = "one_shot"
base = "a"
pose = "c"
when = "go"
fade_in = 0.2
fade_out = 0.2
)"));
  face.step(0.1);
  face.fire("go");
  face.step(0.05);
  const double w = smoothstep(0.25);
  face.expect((1 - w) * 0.6 + w * kRest[0], (1 - w) * 0.2, (1 - w) * kRest[2] + w * 0.75);
  face.step(0.35);
  face.expect(kRest[0], 0, 0.75);
  face.step(0.5);  // 0.9 s: it began to fade out at 0.8 s
  face.expect(0.5 * 0.6 + 0.5 * kRest[0], 0.5 * 0.2, 0.5 * kRest[2] + 0.5 * 0.75);
  face.step(0.2);
  face.expect(0.6, 0.2, kRest[2]);
}

// What differs from rest is added, whatever the mask of joints.
TEST(GraphMorphs, OfAnAddition) {
  for (const char* const mask : {"", "mask = { joint = \"chest\" }\n"}) {
    Face face(with("d", (std::string(R"(
[node.d]
type = "add"
base = "a"
pose = "anger"
weight = "x"
)") + mask)
                            .c_str()));
    face.set_number("x", 0.4);
    face.step(0.1);
    face.expect(0.6, 0.2, kRest[2] + 0.4 * (0.75 - kRest[2]));
  }
}

// The game's pose has no weights: so much of them is at rest.
TEST(GraphMorphs, OfAGivenPose) {
  Face face(with("l", R"(
[node.doll]
type = "given"
[node.l]
type = "layer"
base = "a"
pose = "doll"
weight = "x"
)"));
  face.set_number("x", 0.25);
  face.step(0.1);
  face.expect(0.75 * 0.6 + 0.25 * kRest[0], 0.75 * 0.2, kRest[2]);
}

// A layer of 0.5 over a space of 0.25 and 0.75, whose second point is a machine in the middle of its fade.
TEST(GraphMorphs, OfNodesBelowNodes) {
  Face face(with("l", R"(
[node.m]
type = "machine"
start = "one"
state.one = { pose = "a" }
state.two = { pose = "c" }
transition = [ { from = "one", to = "two", when = "go", fade = 0.2 } ]
[node.s]
type = "space"
by = "x"
points = [ { at = 0, pose = "b" }, { at = 1, pose = "m" } ]
[node.l]
type = "layer"
base = "s"
pose = "still"
weight = "y"
)"));
  face.set_number("x", 0.75);
  face.set_number("y", 0.5);
  face.step(0.9);
  face.fire("go");
  face.step(0.1);
  const double b = 0.5, smile = 0.25 * b + 0.75 * (0.5 * 0.6 + 0.5 * kRest[0]), blink = 0.75 * 0.5 * 0.2,
               frown = 0.25 * kRest[2] + 0.75 * (0.5 * kRest[2] + 0.5 * 0.75);
  face.expect(0.5 * smile + 0.5 * kRest[0], 0.5 * blink, 0.5 * frown + 0.5 * kRest[2]);
}

}  // namespace
}  // namespace marrow::test
