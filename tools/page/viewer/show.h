// A cooked file on a canvas: the stage of `marrow view`, as a page sets it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "page/viewer/plain.h"
#include "render/studio.h"
#include "stage/actor.h"
#include "stage/settings.h"

namespace marrow::tools {

struct PageSettings : Settings {
  Deformer other = Deformer::as;            // to the right of the divide
  bool plain = false, plain_other = false;  // in place of either: what add_plain() has
  float divide = 1;                         // share of the width; 1: there is no right half
  int graph = -1;                           // that plays; -1: clips
};

class Show {
 public:
  // Throws Failure: what loading and the driver throw; invalid for a file without a mesh.
  Show(std::string name, LoadedFile loaded, Images& images);

  Actor& actor() { return actor_; }
  // Has the same character without a better deformer, for a half of its own. False: it is another character.
  bool add_plain(LoadedFile loaded, Images& images);
  // Members of src/viewer.ts's Settings. What it does not name stays. Throws Failure (usage) for what makes no sense.
  void set(const nlohmann::json& wanted);
  // Moves time on by dt_s, poses and draws to the canvas, whose size is given in pixels. What is now, as JSON.
  nlohmann::ordered_json frame(float dt_s, int width, int height);
  // Of each joint, then of each goal, after frame(): x and y in the picture, 0 … 1 to the right and down, and its
  // depth, ≤ 0 behind the camera.
  const std::vector<float>& places() const { return places_; }

  // dx, dy: of a hand, points; of a picture `height` points high.
  // Where a joint is, model space.
  glm::vec3 joint_at(std::size_t joint) const;
  void turn(float dx, float dy);
  void move(float dx, float dy, float height);
  void zoom(float steps);
  // Returns where the goal is then.
  glm::vec3 drag_goal(std::size_t goal, float dx, float dy, float height);

 private:
  void set_graph(int graph);
  void set_goals(const nlohmann::json& goals);
  void draw(int width, int height);
  void take_half(Deformer deformer, bool plain, Shot shot);
  void keep_places(const Camera& camera);
  nlohmann::ordered_json now() const;

  Gl gl_;
  Studio studio_;
  Strokes strokes_;
  Actor actor_;
  std::unique_ptr<Plain> plain_;
  PageSettings settings_;
  std::string trouble_;
  std::vector<float> places_;
};

}  // namespace marrow::tools
