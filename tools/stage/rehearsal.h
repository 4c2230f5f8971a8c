// A graph that plays in the window: what is set, what happened, and a past to go back to.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "behave/behaviour.h"
#include "marrow/roles.h"
#include "render/overlay/ground.h"

namespace marrow::tools {

// So many parameters have a key: 1, 2 and so on.
inline constexpr std::uint32_t kParameterKeys = 9;
// The first number of a graph, which keys change at first; 0: there is none.
std::size_t first_number(const Graph& graph);

class Rehearsal {
 public:
  // That it goes back to at most: ten seconds at sixty a second.
  static constexpr std::size_t kMostMoments = 600;
  // How long prints and the way are kept.
  static constexpr double kKept_s = 60;

  // As Behaviour. It has not moved, and can be posed.
  Rehearsal(const std::string& path, const File& file, FoundGraph found, const std::vector<std::string>& packs);

  const Behaviour& behaviour() const { return behaviour_; }
  double time_s() const { return behaviour_.time_s(); }

  // As Behaviour::set(), in the moment of now.
  void set(std::uint32_t parameter, float value);
  // Moves on from the moment of now; what came after it is forgotten.
  void move_on(float dt_s);
  // From the beginning, at the origin; what is set stays.
  void restart();
  // Poses the character in the moment of now, and keeps that.
  void pose(Character& character);

  // Moments that are kept, the oldest first.
  std::size_t count() const { return moments_.size(); }
  std::size_t now() const { return now_; }
  double moment_s(std::size_t moment) const { return moments_[moment].all.time_s; }
  // The one that is nearest to a time.
  std::size_t moment_at(double time_s) const;
  // What a machine was in, by its node; kNoIndex: it was not shown.
  std::uint32_t state_at(std::size_t moment, std::uint32_t node) const;
  // To a moment that is kept, or, beyond the last, to that.
  void go_to(std::size_t moment);
  // So many moments back or on.
  void step(std::ptrdiff_t by);

  // What was met, the oldest first, also after the moment of now.
  struct Event {
    double at_s = 0;
    std::string name;
    Role role = Role::none;  // of a foot that comes down
  };
  const std::deque<Event>& events() const { return events_; }
  struct Print {
    double at_s = 0;
    GroundPrint print;
  };
  const std::deque<Print>& prints() const { return prints_; }
  // Where the root was.
  struct Place {
    double at_s = 0;
    glm::vec3 at{0};
  };
  const std::deque<Place>& way() const { return way_; }

  // What goes over to another graph: parameters by their names, and where the character stands.
  struct Kept {
    std::map<std::string, std::pair<ParameterKind, float>> parameters;
    RootPlace place;
  };
  Kept kept() const;
  void take(const Kept& kept);

 private:
  struct Remembered {
    Behaviour::Moment all;
    std::vector<std::uint32_t> states;  // a machine
  };
  void begin();
  void remember(const Character& character);

  Behaviour behaviour_;
  Feet feet_;
  std::vector<std::uint32_t> machines_;  // their nodes
  std::deque<Remembered> moments_;
  std::size_t now_ = 0;
  bool has_moved_ = false;  // since it was posed
  std::deque<Event> events_;
  std::deque<Print> prints_;
  std::deque<Place> way_;
};

}  // namespace marrow::tools
