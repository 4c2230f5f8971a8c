// The character on the stage: posed and coloured as the settings have it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/figure.h"
#include "render/performance.h"
#include "render/textures.h"
#include "stage/footprints.h"
#include "stage/recording.h"
#include "stage/rehearsal.h"
#include "stage/rigging.h"
#include "stage/settings.h"

namespace marrow::tools {

struct NamedPlay {
  std::string name;
  Play play;
};

// Milliseconds that the processor took.
struct ActorTimes {
  float pose = 0;
  float skin = 0;  // and upload
};

class Actor {
 public:
  // Of a file that was loaded from `path`. programs: of the studio. Throws Failure (internal) if the driver refuses.
  // `gl` and `programs` outlive it, `images` need not.
  Actor(const Gl& gl, gles3::ProgramSet& programs, std::string path, LoadedFile loaded, Images& images);
  Actor(const Actor&) = delete;
  Actor& operator=(const Actor&) = delete;

  // It plays this graph from now on, with clips of these packs as well; what is set and where it stands stays. Throws
  // as Rehearsal; then all is as before.
  void rehearse(FoundGraph found, const std::vector<std::string>& packs);
  // It plays clips again.
  void stop_rehearsal();
  // Null: it plays clips.
  Rehearsal* rehearsal() { return rehearsal_.get(); }
  const Rehearsal* rehearsal() const { return rehearsal_.get(); }

  // The rest pose, each clip of the file, and what was added.
  const std::vector<NamedPlay>& plays() const { return plays_; }
  // Which of them plays the same, or one more by this name. pack: holds its clips, if the file does not.
  std::size_t add_play(const std::string& name, Play play, std::optional<LoadedFile> pack);
  // Of all skeletons, in the file's order.
  const std::vector<NamedJoint>& joints() const { return joints_; }
  const std::string& path() const { return path_; }
  const LoadedFile& loaded() const { return loaded_; }
  const File& file() const { return loaded_.file; }
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
  // After the first pose.
  Figure& figure() { return *figure_; }
  // All meshes as they are now, skinned on the processor.
  std::vector<PosedMesh> posed(Deformer deformer) const { return skin_all(file(), *character_, deformer); }

  // Poses; before it, rebuilds what the settings changed. dt_s: since the last pose.
  void pose(const Settings& settings, float dt_s);
  // Completes `shot`, which has a camera already. Without a box it gets one that holds the whole performance: it costs
  // nothing, and keeps shadows steady.
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
  void add_plays();
  void make(const Made& wanted);
  Performance perform_graph();
  std::vector<Drawable> weighted(const Settings& settings, Shot& shot);
  std::vector<Drawable> heat(const Settings& settings, Shot& shot);
  std::vector<Drawable> checkered(const Settings& settings);
  void make_checker();
  void listen();

  const Gl& gl_;
  gles3::ProgramSet& programs_;
  std::string path_;
  LoadedFile loaded_;
  std::optional<LoadedFile> pack_;
  std::vector<NamedPlay> plays_;
  std::vector<NamedJoint> joints_;
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
  std::unique_ptr<Rehearsal> rehearsal_;
};

}  // namespace marrow::tools
