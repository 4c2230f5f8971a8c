// A clip as the camera sees it: where the character is over the whole of it, and how to frame that.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "pose/evaluate.h"
#include "render/camera.h"
#include "render/studio.h"

namespace marrow::tools {

// What a character does that goes by no clip.
struct Moments {
  float duration_s = 0;
  std::function<void(float)> pose;  // the character at a moment; called from the first to the last
  std::optional<bool> follows =
      {};  // whether the camera goes along; else if the character goes farther than it is large
};

// Of a picture, the share that is left free on every side of what it frames.
inline constexpr float kFrameMargin = 0.09f;

class Performance {
 public:
  // Looks at 16 moments of what is played, or at the rest pose. Leaves `character` in some pose.
  Performance(const File& file, Character& character, const Play& play);
  static constexpr float kMomentsPerSecond = 8;
  // Looks at so many, up to 128. It stands on the ground at the first of them.
  Performance(const File& file, Character& character, const Moments& moments);

  float duration_s() const { return duration_s_; }
  // Diagonal of the rest pose's box, scene units.
  float diagonal() const { return diagonal_; }

  // A picture of this shape that frames the whole performance. A character that walks off is followed: `character`
  // stands where it is shot.
  Shot shot(const Character& character, float aspect, float margin, float turn_rad = 0) const;
  // From another side: the orbit's yaw and pitch count.
  Shot shot_from(const Orbit& side, const Character& character, float aspect, float margin) const;
  // For cameras that walk about: the orbit of shot(), but that what follows a character is to be added to its target.
  Orbit orbit(float aspect, float margin) const { return orbit_round(points_, aspect, margin); }
  glm::vec3 followed(const Character& character) const { return follows_ ? anchor(character) : glm::vec3(0); }
  // A picture by another camera.
  Shot shot_by(const Camera& camera) const;
  float radius() const { return radius_; }
  // Where it is known better than by what is lowest.
  void set_ground_height(float height) { ground_height_ = height; }
  // Where the character goes over the ground before a camera that stands; empty of one that follows.
  Box way() const { return follows_ ? Box() : way_; }
  // What all of it stays in, where the character stands.
  Box box(const Character& character) const;
  // The same on a turntable: framed so that all sides fit, from one distance, and lit from where the camera is.
  Shot turned_shot(const Character& character, float aspect, float margin, float turn_rad,
                   const Orbit& side = {}) const;

 private:
  void look(Character& character, const Moments& moments, int count);
  void keep_points(bool follows);
  glm::vec3 anchor(const Character& character) const;
  File file_;
  std::vector<glm::vec3> anchors_;             // a moment
  std::vector<std::vector<glm::vec3>> moved_;  // likewise, model space; empty once points are kept
  std::vector<glm::vec3> points_;              // model space, minus the anchor where the camera follows
  float ground_height_ = 0, first_lowest_ = 0;
  float radius_ = 1;
  Box way_;
  float duration_s_ = 0;
  float diagonal_ = 1;
  bool follows_ = false;
};

// Box of all vertices of a posed character.
Box box_of(const std::vector<PosedMesh>& posed);
// Every mesh deformed, those of what the character wears behind its own.
std::vector<PosedMesh> skin_all(const File& file, const Character& character, Deformer deformer);

}  // namespace marrow::tools
