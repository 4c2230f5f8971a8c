// A character that plays a graph by a script, at any moment of it, with the prints that its feet leave; and all of it
// as a trace.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "behave/behaviour.h"
#include "behave/find_graph.h"
#include "behave/script.h"
#include "render/overlay/ground.h"

namespace marrow::tools {

// What `marrow render --graph` says of when what happens.
struct ActingArguments {
  std::string script;            // empty: parameters stay as they are at first
  std::optional<float> seconds;  // none: kAfterScript_s after the script's last line
};

class Acting {
 public:
  // As Behaviour, and what read_script() throws.
  Acting(const std::string& path, const File& file, const BehaviourArguments& behaviour,
         const ActingArguments& arguments);

  Behaviour& behaviour() { return behaviour_; }
  const Behaviour& behaviour() const { return behaviour_; }
  float duration_s() const { return duration_s_; }

  // An event that was met.
  struct Met {
    double at_s = 0;  // the end of the step that met it, of at most 1/60 s
    std::string name, clip;
    float time_s = 0, number = 0;  // as AnimatorEvent has them
  };
  // Called behind each step of at most 1/60 s; it may pose the character.
  using OnStep = std::function<void(float dt_s)>;
  // Goes on to a moment, or begins anew if that is over: in steps that end at sixtieths of a second, where the script
  // sets something, and at the moment. So what happens is the same whatever is asked for. Returns what was met.
  std::vector<Met> play_to(double time_s, const OnStep& on_step = {});

  // Behind a step, with the character in its pose in the world: prints of the feet that came down in it.
  void leave_prints(const Character& character);
  struct Print {
    GroundPrint print;
    double at_s = 0;
  };
  const std::vector<Print>& prints() const { return prints_; }
  // Where most prints so far are; none: there are none.
  std::optional<float> ground_height() const;
  double now_s() const { return now_s_; }

 private:
  void set_what_is_due();
  void step(float dt_s, const OnStep& on_step, std::vector<Met>& met);

  Behaviour behaviour_;
  std::vector<ScriptLine> lines_;
  std::size_t next_line_ = 0;
  float duration_s_ = 0;
  double now_s_ = -1;  // below 0: nothing has begun
  Feet feet_;
  std::vector<Print> prints_;
};

// `--trace`: what a graph does, frame by frame, as JSON. Of as many frames a second, from 0 to the end.
// docs/reference/graphs.md has the fields. Throws Failure.
std::string trace_text(const std::string& path, Acting& acting, double duration_s, int fps);

}  // namespace marrow::tools
