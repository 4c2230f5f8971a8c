// A scene made in a test, and its text as glTF: whole, or as another file of the same skeleton's clips.
#pragma once

#include <string>
#include <vector>

#include "support/double_math.h"

namespace marrow::test {

enum class MadeNodeKind { transform, camera, light };

struct MadeNode {
  std::string name;
  int parent = -1;
  Vec3 translation{0, 0, 0};
  Quat rotation{0, 0, 0, 1};
  Vec3 scale{1, 1, 1};
  MadeNodeKind kind = MadeNodeKind::transform;
};

struct MadeChannel {
  int node = -1;
  std::string path, interpolation = "LINEAR";
  std::vector<float> times_s;
  std::vector<float> values;  // flat
};

struct MadeClip {
  std::string name;
  bool of_pack = false;
  std::vector<MadeChannel> channels;
};

// Drawn at a node, which it hangs on if it has no joints.
struct MadeMesh {
  int node = -1;
  std::vector<int> joints;                  // nodes
  std::vector<float> inverse_bind;          // 16 a joint
  std::vector<float> positions;             // 3 a vertex
  std::vector<unsigned char> of;            // 4 a vertex, which of `joints`
  std::vector<float> weights;               // likewise
  std::vector<std::vector<float>> targets;  // 3 a vertex
  std::vector<float> target_weights;        // at rest
};

struct MadeScene {
  std::vector<MadeNode> nodes;
  std::vector<MadeMesh> meshes;
  std::vector<MadeClip> clips;
  // The file of the pack's clips: how many of its units are one of the character's, and a node that it has turned.
  double pack_unit = 1;
  int turned = -1;
  Quat turned_to{0, 0, 0, 1};
};

// The character: without the pack's clips, or with them as they are to be seen on it.
std::string text_of(const MadeScene& scene, bool with_pack);
// The pack's clips in a file of their own: no meshes, other units, nodes in another order and below another root.
std::string pack_text_of(const MadeScene& scene);

}  // namespace marrow::test
