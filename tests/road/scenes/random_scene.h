// Small characters made at random, each of a kind that has once been cooked worse than was said.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace marrow::test {

// What is unusual in a scene. A scene has one of them, and from its kind's sixth on others too.
enum class SceneKind : std::size_t {
  plain,
  deep,          // a chain of a dozen joints
  scale_above,   // 1e-3 … 1e3 above the skeleton
  scale_within,  // likewise of joints
  mirrored,      // negative scales
  far_50_m,      // from the origin
  far_1_km,
  animated_above,  // a node above the skeleton that a clip moves, scaled by 100 or its inverse
  far_camera,      // a camera and a light that clips carry up to a kilometre away
  several_roots,
  several_skins,  // on skeletons of their own
  additive,
  additive_over_zero,  // whose reference has a scale of 0
  morphed,
  uneven_rests,  // a translation tiny at one joint and huge at another
  rest_is_not_bind,
  pack,  // clips of another file
  pack_of_another_unit,
  interpolations,  // STEP, LINEAR and CUBICSPLINE in one clip
  two_keys_at_once,
  late_clip,  // that begins after minutes
  count
};
inline constexpr std::size_t kSceneKinds = static_cast<std::size_t>(SceneKind::count);

const char* name_of(SceneKind kind);

struct RandomScene {
  std::uint32_t number = 0;
  SceneKind kind = SceneKind::plain;
  std::array<bool, kSceneKinds> has = {};  // its own kind, and what else
  std::string character;                   // glTF
  std::string pack;                        // glTF: the clips of another file; empty: none
  // glTF: the character with the pack's clips, in its own unit and on its own joints: what is to be seen in the end.
  std::string together;
  std::vector<std::pair<std::string, std::string>> additive;  // clip, reference: "first", "rest" or another clip
  double clip_error = 1e-3;                                   // of the scene's diagonal
};

// The same on every machine but for the last bits of sines. number: 0, 1, 2, …; kinds take turns.
RandomScene random_scene(std::uint32_t number);

}  // namespace marrow::test
