// What can be asked of the cooker.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "deform/deformers.h"
#include "deform/elastic/elastic_options.h"
#include "deform/rig/auto_skeleton.h"
#include "marrow/cook_host.h"
#include "marrow/file.h"
#include "marrow/roles.h"
#include "text/event_text.h"

namespace marrow::deform {
enum class WeightMethod;
}

namespace marrow::cook {

struct Character;
struct RawScene;
struct RetargetMap;

// A file that an option names, once it has been read.
using NamedBytes = std::shared_ptr<const std::vector<std::byte>>;

inline constexpr int kMostSubdivisions = 3;
inline constexpr std::size_t kMostLods = 15;

// Which scene of the source is cooked.
struct SceneChoice {
  std::string name;  // or its number; empty: the default one, else the first
  RuleOrigin origin = {"--scene", ""};
};

// Which clips become additive, and over what.
struct AdditiveRule {
  std::string clips;                // a name; * stands for any characters, ? for one
  std::string reference = "first";  // their own first frame; "rest": the rest pose; else a clip whose first frame it is
  RuleOrigin origin = {"--additive", ""};
};

// How far clips may stray at some joints.
struct ClipErrorRule {
  std::string joints;   // a name with wildcards as above; empty: all
  double error = 1e-4;  // metres; or, if is_share, of the skeleton's diagonal
  bool is_share = false;
  bool is_for_a_person = false;  // of 2 m: as large a part of characters whose unit is clearly not the metre
  RuleOrigin origin = {"--clip-error", ""};
};

// Weights, painted.
struct PaintRule {
  std::string joint;  // its name; empty: the file says which
  std::string file;   // a grey-scale PNG of the joint; without one what read_painted() reads
  RuleOrigin origin = {"--paint", ""};
  NamedBytes bytes = {};
};

// Weights of a joint that go over to another by a number that clips move.
struct WeightsOverTime {
  std::string channel;   // the number: 0 … 1
  std::string from, to;  // names of joints
  int splines = 1;       // linear B-splines over the distance from the joint `from`; each has a number of its own
  double radius_m = 0;   // above 0: of a bump about the joint `to`, in place of splines
  RuleOrigin origin = {"--weights-over-time", ""};
};
inline constexpr int kMostWeightSplines = 16;

// Weights for meshes that come without, and changes to weights.
struct WeightOptions {
  std::optional<deform::WeightMethod> make;
  RuleOrigin make_origin = {"--auto-weights", ""};
  bool rebind = false;  // make them for meshes that have weights, too
  int smooth_steps = 0;
  RuleOrigin smooth_origin = {"--smooth-weights", ""};
  std::vector<PaintRule> paint;  // one after the other; of a joint the last mask counts
  bool any() const { return make.has_value() || smooth_steps > 0 || !paint.empty(); }
};

inline constexpr int kMostEigenTargets = 32;
enum class AnimationSpace { lift, smooth, fit };
enum class Truth { dual_quaternions, centres_of_rotation, delta_mush, delta_mush_over_dqs, elastic, examples };
// Whether it is delta mush over something.
constexpr bool smooths(Truth truth) {
  return truth == Truth::delta_mush || truth == Truth::delta_mush_over_dqs;
}
// Whether it takes rotations out of joints' matrices.
constexpr bool blends_rotations(Truth truth) {
  return truth != Truth::delta_mush && truth != Truth::examples;
}

inline constexpr int kAutoHelpers = -1;
inline constexpr int kMostHelpers = 32767;

// Of animation space, and of what else is learnt.
struct LearnOptions {
  AnimationSpace animation_space = AnimationSpace::lift;
  Truth truth = Truth::centres_of_rotation;
  deform::DeltaMushOptions delta_mush;
  deform::ElasticOptions elastic;
  deform::Deformer known_elastic;  // that truth of the only mesh, where it has been made
  std::string examples_file;
  std::shared_ptr<const RawScene> examples;  // that file
  int helpers = 0;                           // between the joints that vertices share, at most; or kAutoHelpers
  int influences = 0;  // that a vertex may have, more where its weights need them; 0: 4, with helpers 5
  bool keep_bind_pose = false;
  bool wide_poses = false;  // learn from poses far beyond the clips' too
  bool multi_weights = false;
  int pose_examples = 0;  // of pose space, at most; 0: none
  int eigen_targets = 0;  // morph targets by EigenSkin, at most; 0: none
};

// A shape at a point of a space, see marrow/example_space.h.
struct ShapeExample {
  std::string target;      // a morph target's name; empty: the mesh as it is
  std::vector<float> at;   // a parameter
  std::string where = {};  // in the file of the rule's origin
};

struct ShapeParameter {
  std::string name;  // and of the channel that drives it
  float rest = 0;
};

// Shapes that parameters weigh.
struct ShapeRule {
  std::string name;
  std::string mesh;                        // empty: each that has one of the targets
  std::vector<ShapeParameter> parameters;  // 1 … kMaxExampleParameters
  std::vector<ShapeExample> examples;      // 2 … kMaxExamples, no two at one point
  RuleOrigin origin = {"[[shapes]]", ""};
};

// Which joint has a role.
struct RoleRule {
  Role role = Role::none;
  std::string joint;  // its name; empty: none
  RuleOrigin origin = {"--roles", ""};
};

// Another file's rig, whose clips or poses are put onto the skeletons of this one.
struct RetargetRule {
  std::string file;
  std::string map;  // a file that pairs joints, see parse_retarget_map(); empty: by roles and names
  RuleOrigin origin = {"--retarget", ""};
  std::shared_ptr<const RawScene> rig = {};
  std::shared_ptr<const RetargetMap> pairs = {};  // of `map`
};

// A clip that is the mirror of another.
struct MirrorRule {
  std::string name, of;
  RuleOrigin origin = {"--mirror", ""};
};

// A graph of behaviour, see build_graph().
struct GraphRule {
  std::string file;
  std::string text = {};  // of the file
  RuleOrigin origin = {"--graph", ""};
};

// How much of a clip's motion the root has in place of the poses: none; over the ground, with its heading; and also up
// and down.
enum class RootMotion { none, ground, full };
struct RootRule {
  std::string clips;  // a name with wildcards as above
  RootMotion root = RootMotion::none;
  RuleOrigin origin = {"--root", ""};
};

struct EventRule {
  std::string clips;
  tools::EventText event;
  RuleOrigin origin = {"--event", ""};
};

// Where the segments of a cycle begin, in place of where feet come down.
struct PhaseRule {
  std::string clips;
  std::vector<tools::ClipMoment> marks;
  RuleOrigin origin = {"--phase", ""};
};

// What clips do beside their poses. Of roots and phases the last rule that fits a clip counts.
struct MotionOptions {
  std::vector<RootRule> roots;
  std::vector<EventRule> events;
  std::vector<PhaseRule> phases;
};

// A level of detail.
struct LodRule {
  double ratio = 1;                         // of the mesh's triangles
  std::size_t influences = kMaxInfluences;  // a vertex, at most
};

struct MeshPrecision {
  double normal_error_deg = 0.2;  // no normal or tangent is turned further
  double uv_error = 1.0 / 8192;   // in widths of the texture
  double weight_error = 2.5e-4;
};

// How long the cooker looks for fewer bytes.
enum class Effort { fast, normal, best };

enum class MeshCodec { draco, draco_smallest, meshopt, none };
// What becomes of the source's images.
enum class Images { reference, embed, none };

struct SourceOptions {
  SceneChoice scene;
  Images images = Images::reference;
  bool strict = false;  // refuse what would be mended
};

struct PrepareOptions {
  std::string auto_skeleton;                                 // a template's name; empty: the file's own skeletons
  std::shared_ptr<const deform::SkeletonTemplate> skeleton;  // that template
  WeightOptions weights;
  std::vector<WeightsOverTime> weights_over_time;
  std::vector<std::string> keep;  // names of nodes, with wildcards, to keep although they may be no joints
};

struct ClipOptions {
  Effort effort = Effort::normal;
  bool raw = false;                    // keep clips' keys as they are
  std::vector<AdditiveRule> additive;  // the last that fits a clip counts
  // The last that fits a joint counts; the first fits all.
  std::vector<ClipErrorRule> error = {{"", 1e-4, false, true}};
  std::optional<double> shell;  // metres: clips keep their promise there; none: at the vertices too
};

struct MeshOptions {
  MeshCodec codec = MeshCodec::draco;
  int subdivide = 0;  // steps of Loop's scheme, 0 … kMostSubdivisions
  // How far quantisation may move vertices, in metres or, if is_share, of the mesh's longest side.
  double position_error = 0;  // 0: as 14 bits on the longest side
  bool position_error_is_share = false;
  MeshPrecision precision;
  std::vector<LodRule> lod;        // ever coarser, at most kMostLods
  std::size_t most_entries = 341;  // palette entries of a mesh; primitives with more are split
  bool keep_vertex_order = false;  // remember where every vertex of the source went
};

// Clips and poses of other rigs, and mirrors.
struct RetargetOptions {
  std::vector<RetargetRule> clips;
  std::vector<RetargetRule> poses;  // while a game runs
  std::vector<MirrorRule> mirror;   // after `clips`, one after the other
};

// What is asked of each stage. Files that it names are read by read_named_files(), and stand beside their names then.
struct CookOptions {
  SourceOptions source;
  PrepareOptions prepare;
  RetargetOptions retarget;
  ClipOptions clips;
  MotionOptions motion;
  MeshOptions mesh;
  LearnOptions learn;
  std::vector<RoleRule> roles;  // in place of those that are found
  std::vector<ShapeRule> shapes;
  std::vector<GraphRule> graphs;
  bool clips_only = false;                // a clip pack
  std::string skeleton_file;              // the file of `onto`
  std::shared_ptr<const Character> onto;  // that a pack or an outfit is for; null: own skeletons
};

}  // namespace marrow::cook
