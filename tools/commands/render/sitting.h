// A character in the studio, as the options of `marrow render` have it: one picture after the other of any moment.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "commands/between.h"
#include "commands/render/acting.h"
#include "commands/render/viewpoint.h"
#include "open/open_model.h"
#include "pose/file_springs.h"
#include "render/look.h"
#include "render/performance.h"

namespace marrow::tools {

struct RenderArguments : LookArguments {
  std::string output;  // empty: nothing is drawn
  ViewpointArguments viewpoint;
  ActingArguments acting;              // by a graph
  std::optional<bool> camera_follows;  // the character over the ground; of a graph alone
  std::string trace;                   // empty: none
  std::optional<int> film;             // so many moments in one picture
  bool movie = false;
  bool held = false;  // a movie of the moment --time
  int fps = 15;
  bool springs = false;
  BetweenArguments between;
  std::optional<float> turn_deg;
};

struct Instant {
  float time_s = 0;
  std::optional<float> turn_rad;  // on a turntable, so far
};

class Sitting {
 public:
  // Throws Failure: usage if an option makes no sense, and what loading, textures and the driver throw.
  explicit Sitting(const RenderArguments& arguments);

  // How long what is played takes; 0: nothing moves.
  float duration_s() const { return acting_ ? acting_->duration_s() : play().duration_s; }
  // Whether it ends elsewhere than it begins.
  bool is_acting() const { return acting_ != nullptr; }
  const File& file() const { return model_.file(); }
  int width() const { return size_.first; }
  int height() const { return size_.second; }
  const Gl& gl() const { return gl_; }

  // With --heatmap, before the first picture: makes colours mean the same in the pictures of all these moments, and
  // says on stdout what they mean. Without it nothing.
  void agree_on_heat(std::span<const Instant> instants);

  // With a legend of colours, and marks at the goals of inverse kinematics, if there are any.
  Image shoot(const Instant& instant);
  // The same picture, which does not count among those of warn_of_misses().
  Image glimpse(const Instant& instant);

  // After the last picture: says on stderr which goals were not reached.
  void warn_of_misses() const;

 private:
  // Of a goal over all pictures.
  struct Misses {
    float largest_m = 0;
    int pictures = 0;
  };
  const Play& play() const { return model_.chosen.play; }  // nothing with a graph
  Character& prepared();
  Performance perform();
  void act_to(float time_s);
  void swing_to(float time_s);
  void pose_at(float time_s);
  Shot frame(const Instant& instant) const;
  void add_ground(const Shot& shot);
  void note_misses();
  const RenderArguments& arguments_;
  std::pair<int, int> size_;
  Manner manner_;
  AsNormals normals_;
  Model model_;
  std::unique_ptr<Acting> acting_;  // null: a clip plays
  Viewpoint viewpoint_;
  Reach reach_;
  std::vector<Misses> misses_;  // as reach_.goals()
  int pictures_ = 0;
  FileSprings springs_;
  float swung_s_ = -1;                  // the moment that springs have come to; below 0: they have not begun
  float dt_s_ = 0;                      // of the next pose
  std::optional<PlayedFrames> frames_;  // with --between
  Character character_;
  Performance performance_;
  Gl gl_;
  Textures textures_;
  Studio studio_;
  Figure figure_;
  Strokes strokes_;  // of the ground below what acts
  // One of what the character wears.
  struct WornFigure {
    WornFigure(const Gl& gl, gles3::ProgramSet& programs, const Worn& worn, const RenderArguments& arguments);
    Textures textures;
    Figure figure;
  };
  std::vector<std::unique_ptr<WornFigure>> worn_;
  float largest_m_ = 0;               // of the heat map
  std::unique_ptr<BakedPlay> baked_;  // of path crowd
};

}  // namespace marrow::tools
