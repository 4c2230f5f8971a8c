// The character on show in `marrow view`: posed and coloured as the settings have it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands/view/opening.h"
#include "commands/view/overlay/footprints.h"
#include "commands/view/stage/recording.h"
#include "commands/view/stage/rehearsal.h"
#include "commands/view/stage/rigging.h"
#include "commands/view/stage/view_settings.h"
#include "paint/painting.h"
#include "render/figure.h"
#include "render/performance.h"

namespace marrow::tools {

struct NamedPlay {
  std::string name;
  Play play;
};

struct NamedJoint {
  std::string name;
  std::uint32_t skeleton, joint;
};

// Milliseconds that the processor took.
struct ActorTimes {
  float pose = 0;
  float skin = 0;  // and upload
};

class Actor {
 public:
  // Of a source, and what choose() made of it by `choice`. programs: of the studio. Throws Failure: what textures
  // throw. `gl` and `programs` outlive it.
  Actor(const Gl& gl, gles3::ProgramSet& programs, const Choice& choice, Source source, Chosen chosen);

  // It plays this graph from now on, with clips of these packs as well; what is set and where it stands stays. Throws
  // as Rehearsal; then all is as before.
  void rehearse(FoundGraph found, const std::vector<std::string>& packs);
  // Null: it plays clips.
  Rehearsal* rehearsal() { return rehearsal_.get(); }
  const Rehearsal* rehearsal() const { return rehearsal_.get(); }

  // The rest pose, each clip of the file, and what --clips chose.
  const std::vector<NamedPlay>& plays() const { return plays_; }
  // Which of them --clip chose, or 0.
  std::size_t chosen() const { return chosen_; }
  // Of all skeletons, in the file's order.
  const std::vector<NamedJoint>& joints() const { return joints_; }
  const Source& source() const { return source_; }
  const File& file() const { return source_.loaded.file; }
  const Character& character() const { return *character_; }
  const Performance& performance() const { return *performance_; }
  int coarsest_lod() const { return coarsest_lod_; }
  // Whether the vertex shader has no room for a mesh's joints.
  bool cpu_only() const { return figure_->too_large().has_value(); }
  // The distance that the hottest colour stands for: the largest seen since the settings changed.
  float heat_scale() const { return heat_scale_; }
  const ActorTimes& times() const { return times_; }

  const Rig& rig() const { return rig_; }
  // Frames a second: what the settings say, else the clip's own, else 30.
  float rate_hz(const Settings& settings) const;
  // Of a play whose keys stand at even steps; 0: it has none.
  float own_rate_hz(std::size_t play) const;
  // The local transform of a joint of joints() in the last pose.
  JointTransform local(std::size_t joint) const;
  // The curves of the chosen joint over the chosen clip; null: nothing moves. Made when they are first asked for.
  const JointCurves* curves(const Settings& settings);
  // Of the chosen clip. Made when they are first asked for.
  const Footprints& footprints(const Settings& settings);
  // All meshes as they are at a moment of the chosen clip alone.
  std::vector<PosedMesh> ghost(const Settings& settings, float time_s);
  // All meshes as they are now, skinned on the processor.
  std::vector<PosedMesh> posed(Deformer deformer) const { return skin_all(file(), *character_, deformer); }

  // Of this file, and of the settings' paint_file. Made when it is first asked for.
  Painting& painting(const Settings& settings);
  // Whether the settings ask for it, and it can be done.
  bool paints(const Settings& settings);
  // Null before.
  Painting* painting() { return painting_ ? &*painting_ : nullptr; }

  // Poses; before it, rebuilds what the settings changed. dt_s: since the last pose.
  void pose(const Settings& settings, float dt_s);
  std::vector<Drawable> drawables(const Settings& settings, Shot& shot);

 private:
  // What things are made for; as the settings have it, they are made again.
  struct Made {
    std::size_t clip = 0;
    int lod = -1;
    AsNormals normals = AsNormals::blended;
    std::uint32_t layers = 0;  // that poses hold at once
    bool operator==(const Made&) const = default;
  };
  void add_plays(Chosen chosen, const Choice& choice);
  void make(const Made& wanted);
  Performance perform_graph();
  std::vector<Drawable> weighted(const Settings& settings, Shot& shot);
  std::vector<Drawable> painted(const Settings& settings, Shot& shot);
  std::vector<Drawable> heat(const Settings& settings, Shot& shot);
  std::vector<Drawable> checkered(const Settings& settings);
  void make_checker();
  void listen();

  const Gl& gl_;
  gles3::ProgramSet& programs_;
  Source source_;
  std::optional<LoadedFile> pack_;
  std::vector<NamedPlay> plays_;
  std::vector<NamedJoint> joints_;
  std::size_t chosen_ = 0;
  int coarsest_lod_ = 0;
  Textures textures_;
  Rig rig_;
  GlTexture checker_;
  GlSampler checker_sampler_;
  Made made_;
  std::vector<std::vector<SoaTransform>> local_;  // a skeleton, of the last pose
  std::optional<Character> ghost_;
  struct Recorded {
    std::size_t clip, joint;
    float rate_hz;
    bool operator==(const Recorded&) const = default;
  };
  std::optional<Recorded> recorded_;
  JointCurves curves_;
  std::size_t footprints_of_ = 0;
  std::optional<Footprints> footprints_;
  std::optional<Character> character_;
  std::optional<Performance> performance_;
  std::optional<Figure> figure_;
  DeformerPair heat_pair_;
  float heat_largest_ = 0, heat_scale_ = 1;
  ActorTimes times_;
  std::optional<Painting> painting_;
  std::unique_ptr<Rehearsal> rehearsal_;
};

}  // namespace marrow::tools
