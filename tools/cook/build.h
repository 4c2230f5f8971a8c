// From the artist's scene to the runtime's: which nodes become joints, how keys become tracks, how vertices become
// blocks.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cook/learn/learn.h"
#include "cook/mesh/lod.h"
#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::deform {
enum class WeightMethod;
}

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

// A joint's weight, painted.
struct PaintRule {
  std::string joint;  // its name
  std::string file;   // a grey-scale PNG
  RuleOrigin origin = {"--paint", ""};
};

// Weights for meshes that come without, and changes to weights.
struct WeightOptions {
  std::optional<deform::WeightMethod> make;
  RuleOrigin make_origin = {"--auto-weights", ""};
  int smooth_steps = 0;
  RuleOrigin smooth_origin = {"--smooth-weights", ""};
  std::vector<PaintRule> paint;  // the last of a joint counts
  bool any() const { return make.has_value() || smooth_steps > 0 || !paint.empty(); }
};

struct Character;
enum class MeshCodec { draco, meshopt, none };
// What becomes of the source's images.
enum class Images { reference, embed, none };

struct CookOptions {
  MeshCodec mesh_codec = MeshCodec::draco;
  int subdivide = 0;  // steps of Loop's scheme, 0 … kMostSubdivisions
  // How far quantisation may move vertices, in metres or, if is_share, of the mesh's longest side.
  double position_error = 0;  // 0: as 14 bits on the longest side
  bool position_error_is_share = false;
  MeshPrecision precision;
  LearnOptions learn;                            // animation space
  std::vector<LodRule> lod;                      // levels of detail, ever coarser
  std::size_t most_entries = 341;                // palette entries of a mesh; primitives with more are split
  std::vector<AdditiveRule> additive;            // the last that fits a clip counts
  bool raw_clips = false;                        // keep clips' keys as they are
  std::vector<ClipErrorRule> clip_error = {{}};  // the last that fits a joint counts; the first fits all
  bool clips_only = false;                       // a clip pack
  std::string skeleton_file;                     // the file of `onto`, for whoever reads it
  std::shared_ptr<const Character> onto;         // that the pack is for; null: the file's own skeletons
  bool keep_vertex_order = false;                // remember where every vertex of the source went
  Images images = Images::reference;
  std::vector<std::string> keep;  // names of nodes, with wildcards as above, to keep although they may be no joints
  WeightOptions weights;
};

// Adds to scene.warnings what it mends or leaves out. Throws tools::Failure (invalid: nothing to cook; unsupported: a
// limit of the format).
BuiltScene build_scene(RawScene& scene, const CookOptions& options);
BuiltScene build_pack(RawScene& scene, const CookOptions& options);

// The stages of build_scene, each in a file of its own.
void build_skeletons(const RawScene& scene, BuiltScene& out);
// Of skeletons built before.
void build_limits(RawScene& scene, BuiltScene& out);
// What a clip of the source moves in one skeleton.
struct ClipPart {
  std::uint32_t skeleton;
  RawClip clip;
  float duration_s;  // of the whole clip, so that its parts stay in step
};
// At least one part a clip, in the order of clips, in each of skeletons.
std::vector<ClipPart> split_clips(const RawScene& scene, const BuiltScene& built);
// Of channels that all belong to one skeleton, or to none: those are left out.
BuiltClip build_clip(const RawClip& clip, const std::vector<int>& joint_of_node);
// Splits, builds, compresses. Throws tools::Failure (usage) if an option names what there is not.
void build_clips(RawScene& scene, const CookOptions& options, BuiltScene& out);
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
// One primitive's vertices: quantised, welded, in an order that GPUs like, encoded, decoded again. Throws
// tools::Failure (internal), without a place, if that is not what was encoded. deformers: of the primitive's vertices
// and bindings, a palette entry being a joint of those.
BuiltGeometry build_geometry(const RawPrimitive& primitive, const std::vector<Binding>& bindings,
                             std::size_t joint_count, const MeshGrid& grid, const CookOptions& options,
                             const DeformerData& deformers = {});
// Of a primitive in parts: quantised as a whole, so that parts still touch where they do, and the rest part by part.
struct GeometryPart {
  std::vector<std::uint32_t> vertices, indices;  // as PrimitivePart's
  std::vector<std::uint16_t> entries;            // of the palette, ascending
};
std::vector<BuiltGeometry> build_geometries(const RawPrimitive& primitive, const std::vector<Binding>& bindings,
                                            std::size_t joint_count, const std::vector<GeometryPart>& parts,
                                            const MeshGrid& grid, const CookOptions& options,
                                            const DeformerData& deformers);
// Of meshes built before.
void build_materials(RawScene& scene, Images images, BuiltScene& out);
void build_nodes(RawScene& scene, const std::vector<std::string>& keep, BuiltScene& out);

// node-to-parent matrix of one node, and rows of an affine matrix.
glm::dmat4 local_matrix(const RawNode& node);
Affine to_affine(const glm::dmat4& m);

}  // namespace marrow::cook
