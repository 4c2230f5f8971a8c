#include "deform/motion/between_poses.h"

namespace marrow::deform {
namespace {

// Of one joint, from a row of poses.
glm::dvec3 three(const float (&lanes)[3][4], std::size_t lane) {
  return {lanes[0][lane], lanes[1][lane], lanes[2][lane]};
}

void put(const glm::dvec3& v, std::size_t lane, float (&lanes)[3][4]) {
  for (int i = 0; i < 3; ++i) lanes[i][lane] = static_cast<float>(v[i]);
}

}  // namespace

std::vector<SoaTransform> between_poses(BetweenFrames kind, const std::vector<std::vector<SoaTransform>>& frames,
                                        double at) {
  std::vector<SoaTransform> out = frames.front();
  for (std::size_t j = 0; j < 4 * out.size(); ++j) {
    std::vector<glm::dvec3> translations, scales;
    std::vector<glm::dquat> rotations;
    for (const std::vector<SoaTransform>& frame : frames) {
      const SoaTransform& t = frame[j / 4];
      translations.push_back(three(t.translation, j % 4));
      scales.push_back(three(t.scale, j % 4));
      rotations.emplace_back(t.rotation[3][j % 4], t.rotation[0][j % 4], t.rotation[1][j % 4], t.rotation[2][j % 4]);
    }
    SoaTransform& to = out[j / 4];
    put(between_frames(kind, translations, at), j % 4, to.translation);
    put(between_frames(kind, scales, at), j % 4, to.scale);
    const glm::dquat q = between_frames(kind, rotations, at);
    const double parts[] = {q.x, q.y, q.z, q.w};
    for (int i = 0; i < 4; ++i) to.rotation[i][j % 4] = static_cast<float>(parts[i]);
  }
  return out;
}

}  // namespace marrow::deform
