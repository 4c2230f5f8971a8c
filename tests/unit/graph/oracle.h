// A second animator in double precision, written from docs/cooking/graphs.md alone: it shares nothing with the runtime.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>

namespace marrow::test::oracle {

// A clip as unit/graph/graph_rig.h has it.
struct Clip {
  std::string name;
  double duration_s = 0, speed_m_s = 0;
  std::vector<double> marks;  // without any of the clip's own: 0
  std::vector<std::pair<std::string, double>> events;
  double way_m = 0, turn_rad = 0;
};
const std::vector<Clip>& clips();

enum class Play { loop, once, ping_pong };
enum class Test { set, not_set, above, below, at_least, at_most };
enum class Enter { beginning, seconds, phase };
enum class Kind { clip, space, machine, layer, given };

struct Condition {
  std::size_t parameter = 0;
  Test test = Test::set;
  double value = 0;
};
struct Transition {
  int from = -1;  // -1: any state
  std::vector<int> to;
  bool in_turn = false;
  std::vector<Condition> when;
  double after_s = -1, at_end_s = -1;  // -1: not asked for
  double fade_s = 0;
  bool inertial = false;
  Enter enter = Enter::beginning;
  double enter_s = 0;
};
struct State {
  std::string name;
  int node = -1;  // -1: nothing
};
struct Point {
  int node = -1;
  double x = 0, y = 0;
};
struct Node {
  std::string name;
  Kind kind = Kind::clip;
  // A clip's.
  std::size_t clip = 0;
  double speed = 1;
  Play play = Play::loop;
  // A space's.
  std::vector<std::size_t> by;
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  bool in_step = false, matches = false;
  // A machine's.
  std::vector<int> start;
  bool start_in_turn = false;
  std::vector<State> states;
  std::vector<Transition> transitions;
  // A layer's.
  int base = -1, pose = -1;
  std::vector<double> mask;  // one a bone; empty: all
  int by_parameter = -1;
  double weight = 1, fade_s = 0;
  bool additive = false, in_model = false;
};
enum class ParameterKind { number, flag, trigger };
struct Parameter {
  std::string name;
  ParameterKind kind = ParameterKind::number;
  double initial = 0, least = 0, most = 0, seconds = 0;
};
struct Graph {
  std::vector<Parameter> parameters;
  std::vector<Node> nodes;  // a node stands before those that it takes
  int output = 0;
  std::size_t parameter(const std::string& name) const;
};
// Reads a graph that is known to be valid.
Graph read(const std::string& text);

// A rigid motion, and its logarithm.
struct Rigid {
  glm::dquat turn{1, 0, 0, 0};
  glm::dvec3 way{0};
};
Rigid operator*(const Rigid& a, const Rigid& b);
struct Screw {
  glm::dvec3 turn{0}, way{0};
};
Screw logarithm(const Rigid& rigid);
Rigid exponential(const Screw& screw);

// Where a clip is, on a time line that does not wrap: x seconds of the clip since some beginning.
double folded(const Clip& clip, Play play, double x);
// How the root moves from x0 to x1.
Screw root_between(const Clip& clip, Play play, double x0, double x1);
// Adds the events that are met.
void count_events(const Clip& clip, Play play, double x0, double x1, bool with_begin, std::map<std::string, int>& out);

// Segments passed since some beginning, and the share of the one that goes on.
struct Place {
  long segment = 0;
  double share = 0;
};
double segment_s(const Clip& clip, long segment);
double time_at(const Clip& clip, const Place& place);  // on the line that does not wrap
Place place_at(const Clip& clip, double time_s);
void go_on(const std::vector<std::pair<const Clip*, double>>& group, double dt_s, Place& place);

std::vector<double> line(const std::vector<Point>& points, double at);
std::vector<double> plane(const Node& space, double x, double y);
std::vector<double> matched(const Graph& graph, const Node& space, double speed, double& rate);
std::vector<std::array<std::size_t, 3>> triangulated(const std::vector<Point>& points);

// What a node is in.
struct NodeState {
  bool shown = false;
  double x = 0;  // of a clip
  Place place;   // of a space in step
  // Of a machine.
  int current = -1;
  double age_s = 0, since_s = 0, fade_s = 0;
  std::vector<std::pair<int, double>> before;  // states that fade out: their weights when the fade began
  std::size_t turn = 0;                        // how often it has chosen one of several
  double ramp = 0;                             // of a layer
};

// What a node has of a step.
struct Run {
  bool reached = false;
  bool active = false;  // heard, and decides
  double loud = 0;
  bool fresh = false;  // begins anew
  Enter enter = Enter::beginning;
  double enter_s = 0;
  Place enter_place;
  // What came of it.
  struct Part {
    int node;
    double weight;  // mean
  };
  std::vector<Part> parts;
  double mean = 0;  // of a layer's weight
  Screw root;
  double there = 1;  // how much of it is there
};

using Pose = std::vector<glm::dquat>;  // one a bone
struct Shown {
  Pose pose;
  double there = 1;
};

class Animator {
 public:
  explicit Animator(Graph made, std::uint32_t seed = 1, double least_loudness = static_cast<double>(0.1f));
  void set_number(const std::string& name, double value);
  void set_flag(const std::string& name, bool value);
  void fire(const std::string& name);
  void update(double dt_s);

  // After an update.
  std::map<std::string, int> events;
  Rigid root;
  std::string state(const std::string& node, double* seconds = nullptr) const;
  bool inertial() const { return inertia_s_ > 0; }
  bool at_limit = false;  // a machine has switched eight times in a step
  int switches = 0, steps = 0;

  // What is shown; leaf: a clip at a time. rest: one a bone.
  Pose pose(const std::function<Pose(std::size_t, double)>& leaf, const Pose& rest, const Pose& reference) const;
  const Graph& graph() const { return graph_; }

 private:
  friend class Machine;
  struct Value {
    double target = 0, value = 0, mean = 0;  // of a flag: target 0 or 1
    bool is_set = false;                     // of a trigger
    double left_s = 0;
  };
  struct Everything {
    std::vector<Value> values;
    std::vector<NodeState> nodes;
    std::uint32_t chance = 1;
    Rigid root;
    std::map<std::string, int> events;
    double inertia_s = 0;
    int switches = 0, steps = 0;
  };
  Everything everything() const;
  void take(const Everything& from);
  bool weights_change() const;
  bool shows_several() const;
  void step(double dt_s);
  void step_whole(double dt_s);
  void step_numbers(double dt_s);
  void step_triggers(double dt_s);
  void request(int node, const Run& run);
  void begin(int node, NodeState& state, const Run& run) const;
  void go_clip(int node, Run& run);
  void go_space(int node, Run& run);
  void go_layer(int node, Run& run);
  void sum_up(int node, Run& run);
  void mark_shown();
  void show(int node, std::vector<bool>& shown) const;
  std::vector<double> weights(const Node& node, bool mean, double& rate) const;
  double layer_weight(const Node& node, const NodeState& state) const;
  Shown shown(int node, const std::function<Pose(std::size_t, double)>& leaf, const Pose& rest,
              const Pose& reference) const;
  int chosen(const std::vector<int>& to, bool in_turn, std::size_t& turn, int current);

  Graph graph_;
  double least_loudness_;
  std::vector<Value> values_;
  std::vector<NodeState> nodes_;
  std::uint32_t chance_;
  double inertia_s_ = 0;
  double dt_s_ = 0, cut_s_ = -1;
  bool first_ = true, several_ = false;
  std::vector<Run> runs_;
};

// The weights of a machine's states now.
std::vector<std::pair<int, double>> state_weights(const NodeState& state);
// 3 u² - 2 u³, and its mean between two times.
double smooth(double u);
double mean_smooth(double u0, double u1);

}  // namespace marrow::test::oracle
