// From the artist's scene to the runtime's: which nodes become joints, how keys become tracks, how vertices become
// blocks.
#pragma once

#include <string>
#include <vector>

#include "cook/built.h"
#include "cook/raw.h"

namespace marrow::cook {

// Where a rule was given, as failures say it, and whether it is a mistake if it fits nothing: a rule for many files
// need not fit each.
struct RuleOrigin {
  std::string file, where;  // "--additive", ""; "marrow.toml", "12:7"
  bool must_fit = true;
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
  double error = 1e-4;  // metres on the shell; or, if is_share, of the skeleton's diagonal
  bool is_share = false;
  RuleOrigin origin = {"--clip-error", ""};
};

struct CookOptions {
  std::vector<AdditiveRule> additive;            // the last that fits a clip counts
  bool raw_clips = false;                        // keep clips' keys as they are
  std::vector<ClipErrorRule> clip_error = {{}};  // the last that fits a joint counts; the first fits all
  bool keep_vertex_order = false;                // remember where every vertex of the source went
};

// Adds to scene.warnings what it mends or leaves out. Throws tools::Failure (invalid: nothing to cook; unsupported: a
// limit of the format).
BuiltScene build_scene(RawScene& scene, const CookOptions& options);

// The stages of build_scene, each in a file of its own.
BuiltSkeleton build_skeleton(RawScene& scene);
BuiltClip build_clip(const RawClip& clip, const BuiltSkeleton& skeleton);
// Behind the tracks, which must be final. all_keys: keep those too that others make superfluous.
void add_channels(const RawClip& raw, bool all_keys, BuiltClip& clip);
// For each clip its reference, or none; of clips not yet compressed. Throws tools::Failure (usage) if a rule's
// reference is no clip, or if it fits no clip and must; a warning if it need not.
struct AdditiveReference {
  std::string name;                // as AdditiveRule's; empty: an ordinary clip
  std::vector<SoaTransform> pose;  // empty: the rest pose
};
std::vector<AdditiveReference> additive_references(const BuiltScene& scene, const std::vector<AdditiveRule>& rules,
                                                   std::vector<RawWarning>& warnings);
void build_meshes(RawScene& scene, const CookOptions& options, BuiltScene& out);

// node-to-parent matrix of one node, and rows of an affine matrix.
glm::dmat4 local_matrix(const RawNode& node);
Affine to_affine(const glm::dmat4& m);

}  // namespace marrow::cook
