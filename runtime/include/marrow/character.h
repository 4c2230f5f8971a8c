// A whole file as one character: takes all its skeletons and meshes through the stages of marrow.h, in their order.
//
//   once a load       make_animations
//   once a character  make_character
//   every frame       pose_character; the game's own inverse kinematics, feet and springs; finish_character
//   then              skin_ssd() and its like of a CharacterMesh, or pose() of a gles3::Skinner
//
// A file may hold several skeletons, such as a rider's and a horse's; they are posed together. Arrays with one element
// a skeleton or mesh are in the order of the file.
//
// Local poses may come from elsewhere. Then, instead of calling pose_character(), write Pose::local of each skeleton
// and CharacterMesh::weights, and call local_to_model().
//
// No allocation: memory is the caller's, sizes are asked for first. Thread-safe on different characters; animations are
// only read, and serve any number of them.
#pragma once

#include "marrow/api.h"
#include "marrow/blend.h"
#include "marrow/clip_motion.h"
#include "marrow/file.h"
#include "marrow/local_to_model.h"
#include "marrow/morph.h"
#include "marrow/playback.h"
#include "marrow/root_motion.h"
#include "marrow/sample.h"

namespace marrow {

// What the skeletons of a character play together: a clip each, or none. Plain pointers, which a game may fill itself.
struct Animation {
  const char* name = "";  // of its clips; may be empty
  File clips = {};        // the file that its clips are from: the character's file, or a clip pack
  float duration_s = 0;   // of the longest
  // One a skeleton of the character: which clip it plays; kNoClip: it rests.
  Span<const std::uint32_t> clip_of_skeleton = {};
  // One a morph target of the character, mesh after mesh: its channel in the clip that the mesh's skeleton plays, or
  // kNoChannel. From find_weight_channels().
  Span<const std::uint32_t> channels = {};
  // What its clips do beside their poses: that of the first skeleton whose clip has a root's motion, else of the first
  // whose clip has any.
  ClipMotion motion = {};
  std::uint32_t motion_skeleton = 0;  // which skeleton's clip that is
};

// All animations of a file, by name.
struct Animations {
  // One animation for each clip, at the clip's own index. It plays that clip and, on each other skeleton, the first
  // clip with the same name. A clip without a name plays alone.
  Span<const Animation> all = {};
};

// Bytes that make_animations() needs: for each clip an Animation, and 4 bytes for each skeleton and morph target. A
// multiple of 16.
MARROW_API std::size_t animations_bytes(const File& file, const File& clips);

// Makes animations from clips of `file`, the character's, or of a clip pack. A clip pack has references to skeletons in
// place of skeletons. Each reference is paired with one skeleton that it fits and that no earlier reference has taken:
// the one with its name, else the first. A reference that fits no skeleton is left out: no skeleton plays its clips.
// See bind_clips().
//
// memory: at least animations_bytes(), 16-byte aligned; `out` keeps pointers into it and into both files' blocks.
// Errors: bad_argument (the memory); mismatch (`clips` is another file but no pack, or a pack none of whose clips fits
// a skeleton). Cost: compares names; once a load.
MARROW_API Status make_animations(const File& file, const File& clips, Span<std::byte> memory, Animations& out);

// The first animation with this name that moves anything; null if there is none. Cost: compares names.
MARROW_API const Animation* find_animation(const Animations& animations, const char* name);

// The clip that a skeleton of the character plays in the animation; if that skeleton rests, an empty Clip: no name, no
// tracks, duration 0.
MARROW_API Clip clip_of(const Animation& animation, std::uint32_t skeleton);

// What a character is made for.
struct CharacterOptions {
  std::uint32_t layers = 2;      // the most layers that are blended at once; at least 1
  std::uint32_t level = 0;       // of detail, as in File::mesh
  bool skin = true;              // on the CPU; false: no palettes or morphed vertices; a gles3::Skinner makes its own
  bool animation_space = false;  // skin by skin_as(), too
};

// A skeleton of the file, posed. Between pose_character() and finish_character(), whatever changes Pose::local must
// also bring Pose::model_from_joint up to date, and the other way round; the functions called there all do so.
struct CharacterSkeleton {
  Pose pose = {};  // what solvers, feet and springs take
  // sample_character()'s own. One a layer: its sampled pose, and what is cached of the clip.
  Span<SoaTransform> sampled = {};
  Span<SampleCache> caches = {};  // as `sampled`
};

// A mesh, ready for skin_ssd(mesh, palette, …) or skin_as(mesh, coordinates, palette, …) after finish_character().
struct CharacterMesh {
  Mesh mesh = {};                  // of the level asked for; with `skin` its geometry is this character's own, morphed
  Span<float> weights = {};        // of morph targets
  Span<Affine> palette = {};       // empty without `skin`
  Span<float> coordinates = {};    // empty without `skin` and `animation_space`
  MorphedGeometry morphed = {};    // with `skin`
  Span<std::byte> vertices = {};   // the memory that `morphed` lies in
  std::uint32_t first_target = 0;  // in Animation::channels
};

// Views into the caller's memory. A copy is the same character.
struct Character {
  File file = {};                          // as it was given
  CharacterOptions options = {};           // as they were given
  Span<CharacterSkeleton> skeletons = {};  // all of the file, in its order
  Span<CharacterMesh> meshes = {};         // all of the file, in its order
  std::uint32_t target_count = 0;          // of morph targets, of all meshes

  // Scratch.
  Span<BlendLayer> blended = {};        // as many as CharacterOptions::layers
  Span<AdditiveTransform> change = {};  // soa_size() of the largest skeleton
};

// Bytes that make_character() needs: a multiple of 16, so that the blocks of a crowd may stand back to back.
MARROW_API std::size_t character_bytes(const File& file, const CharacterOptions& options);

// A character in its rest pose, finished.
//
// `file`'s block must outlive it. memory: at least character_bytes(), 16-byte aligned.
// Errors: bad_argument (the memory, no layers, a default weight that is not finite). Cost: a copy of the vertices of
// meshes with morph targets, and as_coordinates().
MARROW_API Status make_character(const File& file, const CharacterOptions& options, Span<std::byte> memory,
                                 Character& out);

// An animation at a time, and how much of it.
struct AnimationLayer {
  const Animation* animation = nullptr;  // made for the character's file
  float time_s = 0;                      // see playback.h
  float weight = 1;                      // 0 … kMaxBlendWeight; with a mask 0 … 1
  // Empty: the layer is averaged with the others. Else the layer is laid over those and over the masked layers before
  // it, joint by joint, as overlay() does: a hand waves while the legs walk. The factors are as in BlendLayer; those of
  // several skeletons follow one another, each skeleton's beginning at a multiple of four floats. mask_below() fills
  // one skeleton's.
  Span<const float> mask = {};
  RigidStep step = {};  // how its root moves in this frame: for character_root_step(); poses do not need it
};

// Samples and blends. Local poses of all skeletons and weights of all morph targets become weighted means of the layers
// without masks, as in blend(). Without such layers all skeletons are in the rest pose, and all morph targets have
// their default weights. Then layers with masks are laid over the poses. They leave weights of morph targets alone:
// add_expression() is for those. A clip that is cooked as additive is first added to its reference pose.
//
// Errors: bad_argument (more layers than the options say, an animation that is null or not made for this file, a weight
// out of range, a time that is not a number, a mask too short); a part of the character may have been written then.
// Cost: sample(), blend() and overlay() of each skeleton, sample_channels() of what drives morph targets.
MARROW_API Status sample_character(Character& character, Span<const AnimationLayer> layers);

// Brings model_from_joint of all skeletons up to date with `local`.
MARROW_API Status local_to_model(Character& character);

// sample_character(), then local_to_model(): the pose is ready for inverse kinematics, feet and springs. Errors: as
// sample_character().
MARROW_API Status pose_character(Character& character, Span<const AnimationLayer> layers);

// Puts a layer where a step of its animation's playback has come to: sets time_s, and `step` by root_step(). `after` is
// `before` after one advance() with Animation::motion's duration, or both are from follow_phase().
// Errors: bad_argument (no animation; as root_step()); nothing is written. Cost: as root_step().
MARROW_API Status step_layer(const Playback& before, const Playback& after, AnimationLayer& layer);

// How the layers together move the character, for move_root(). Steps of layers without masks are averaged, as
// blend_root_steps() of root_motion.h does. Then each layer with a mask, in their order, takes the share weight · mask
// at the hips.
// Errors: bad_argument (as pose_character(); a result that is not finite); nothing is written. Cost: some 400
// operations in double precision a layer of weight above 0.
MARROW_API Status character_root_step(const Character& character, Span<const AnimationLayer> layers, RigidStep& out);

// Adds an expression, such as a face's, to the weights of morph targets: the difference between the animation's weight
// and the default, times `weight`. Call it once for each expression, between pose_character() and finish_character(). A
// weight that no channel drives keeps its bits; poses do, too.
//
// Errors: bad_argument (an animation that is null or not made for this file, a weight out of range, a time that is not
// a number); nothing is written. Cost: sample_channels() of what drives morph targets.
MARROW_API Status add_expression(Character& character, const AnimationLayer& expression);

// Palettes from model_from_joint, and vertices morphed by `weights`; nothing without `skin`.
// Errors: bad_argument (a weight that is not finite). Cost: build_palette(), morph() and morph_coordinates() of each
// mesh.
MARROW_API Status finish_character(Character& character);

// What one skeleton of an outfit follows.
struct OutfitSkeleton {
  std::uint32_t body_skeleton = 0;             // of the body's character
  Span<const std::uint16_t> body_joints = {};  // one a joint of the outfit; see bind_outfit()
};

// How an outfit, hair or clothes in a file of its own, follows the skeletons of a body's file. It serves any number of
// characters.
struct Outfit {
  Span<const OutfitSkeleton> skeletons = {};  // one a skeleton of the outfit
};

// Bytes that make_outfit() needs: 24 a skeleton and 2 a joint, on boundaries of 16. A multiple of 16.
MARROW_API std::size_t outfit_bytes(const File& outfit);

// Finds the body's skeleton that each skeleton of an outfit follows: the one with the same name if the outfit's fits
// it, else the first that it fits. An outfit is cooked with `--skeleton BODY`; outfit.h says when it fits.
//
// memory: at least outfit_bytes(), 16-byte aligned; `out` keeps pointers into it. Several outfits may follow one body.
// Errors: bad_argument (the memory); mismatch if a skeleton fits none, and bind_outfit() says which joints are in the
// way. Cost: compares names; once a load.
MARROW_API Status make_outfit(const File& body, const File& outfit, Span<std::byte> memory, Outfit& out);

// Brings model_from_joint of an outfit's skeletons to the body's pose. Call it once the body is posed, then
// finish_character(). Joints that only the outfit has are placed by the outfit's `local`, which stays as it is from
// frame to frame. If clips or springs of the outfit move them, a frame is
//
//   sample_character(outfit, …); follow_body(…); springs; finish_character(outfit)
//
// sample_character() without layers puts those joints back to rest. `local` of the body's joints is neither read nor
// written. The outfit drives its own morph targets: by its clips, or the game writes CharacterMesh::weights.
//
// worn: made from the outfit's file. Errors: bad_argument if `outfit` was made for other files. Cost: follow_body() of
// outfit.h for each skeleton.
MARROW_API Status follow_body(const Outfit& outfit, const Character& body, Character& worn);

}  // namespace marrow
