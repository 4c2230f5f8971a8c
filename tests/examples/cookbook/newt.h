// What every recipe of docs/ik/cookbook.md stands on: the sample character in a pose, and the distance that is left.
// Of a file that is not packed: marrow cook hero.glb --mesh-codec none --clip-codec raw -o hero.mrw
#pragma once

#include <marrow/math.h>
#include <marrow/owned.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

struct Newt {
  marrow::OwnedFile file;
  marrow::OwnedCharacter body;
  marrow::Pose pose;  // the body's

  explicit Newt(const char* path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) std::perror(path);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
    must(make_owned(bytes, file));
    must(make_owned(file, {}, body));
    pose = body.skeletons[0].pose;
  }
  const marrow::Animation* clip(const char* name) const { return find_animation(file.animations, name); }
  void play(const char* name, float time_s) { must(pose_character(body, {{clip(name), time_s}})); }
  std::uint32_t joint(const char* name) const {
    const std::uint32_t found = file.find_joint(pose.skeleton, name);
    if (found == pose.skeleton.joint_count) must(marrow::Status::bad_argument);
    return found;
  }
  // Where the joint is, in model space.
  float at(std::uint32_t joint, int axis) const { return pose.model_from_joint[joint].rows[axis][3]; }
  float millimetres(std::uint32_t joint, const float (&point)[3]) const {
    float sum = 0;
    for (int i = 0; i < 3; ++i) sum += (at(joint, i) - point[i]) * (at(joint, i) - point[i]);
    return 1000 * std::sqrt(sum);
  }
  // For pictures: the pose, a joint a line. See pictures.py.
  void save(const char* folder, const char* recipe) const {
    if (folder == nullptr) return;
    std::FILE* const out = std::fopen((std::string(folder) + "/" + recipe + ".pose").c_str(), "w");
    for (std::uint32_t j = 0; j < pose.skeleton.joint_count; ++j) {
      marrow::JointTransform t;
      must(get_joint(pose.local, j, t));
      std::fprintf(out, "%s %g %g %g %g %g %g %g\n", file.text(pose.skeleton.names[j]), double(t.translation[0]),
                   double(t.translation[1]), double(t.translation[2]), double(t.rotation[0]), double(t.rotation[1]),
                   double(t.rotation[2]), double(t.rotation[3]));
    }
    std::fclose(out);
  }
};
