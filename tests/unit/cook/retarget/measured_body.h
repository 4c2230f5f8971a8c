// A cooked character, measured: its size, and where feet and hands are in the course of a clip.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "support/places.h"
#include "unit/cook/loaded_cook.h"

namespace marrow::cook {

inline constexpr double kTallM = 1.65;  // all figures are at this size
inline constexpr float kStepS = 1.0F / 60;

class MeasuredBody {
 public:
  MeasuredBody(const std::string& path, const CookOptions& options)
      : cook_(cook_file(path, options)), roles_(cook_.file.roles(0)), skeleton_(cook_.file.skeleton(0)) {
    std::vector<SoaTransform> rest(skeleton_.rest, skeleton_.rest + skeleton_.soa_size());
    std::vector<Affine> model(skeleton_.joint_count);
    EXPECT_EQ(local_to_model(skeleton_, rest, model), Status::ok);
    rest_ = model;
    const auto [low, high] = heights(model);
    to_size_ = kTallM / (high - low);
  }

  double to_size() const { return to_size_; }
  std::uint32_t clip(const std::string& name) const {
    for (std::uint32_t c = 0; c < cook_.file.clip_count(); ++c)
      if (name == cook_.file.clip(c).name) return c;
    ADD_FAILURE() << "no clip " << name;
    return 0;
  }
  double duration_s(std::uint32_t clip) const { return double{cook_.file.clip(clip).duration_s}; }
  glm::dvec3 rest(Role role) const { return place(rest_, role); }
  double leg() const { return way(Role::left_upper_leg, Role::left_lower_leg, Role::left_foot); }
  // 0 without hands.
  double arm() const {
    if (joint_of(roles_, Role::left_hand) == kNoJoint) return 0;
    return way(Role::left_upper_arm, Role::left_lower_arm, Role::left_hand);
  }
  // Of both feet, in the scene.
  double ground() const { return std::min(sole(rest_, Role::left_foot).y, sole(rest_, Role::right_foot).y); }

  std::vector<Affine> pose(std::uint32_t clip, float time_s) const {
    std::vector<SoaTransform> local(skeleton_.soa_size());
    std::vector<Affine> model(skeleton_.joint_count);
    EXPECT_EQ(sample(skeleton_, cook_.file.clip(clip), time_s, local), Status::ok);
    EXPECT_EQ(local_to_model(skeleton_, local, model), Status::ok);
    return model;
  }
  glm::dvec3 place(const std::vector<Affine>& model, Role role) const {
    const std::uint16_t joint = joint_of(roles_, role);
    if (joint == kNoJoint) return glm::dvec3(0);
    const auto& rows = model[joint].rows;
    return {double{rows[0][3]}, double{rows[1][3]}, double{rows[2][3]}};
  }
  glm::dvec3 sole(const std::vector<Affine>& model, Role role) const {
    const std::uint16_t joint = joint_of(roles_, role);
    const JointSole* const at = joint == kNoJoint ? nullptr : sole_of(roles_, joint);
    if (at == nullptr) return glm::dvec3(0);
    glm::dvec3 out;
    for (int r = 0; r < 3; ++r) {
      const auto& row = model[joint].rows[r];
      out[r] = double{row[0]} * double{at->place[0]} + double{row[1]} * double{at->place[1]} +
               double{row[2]} * double{at->place[2]} + double{row[3]};
    }
    return out;
  }
  // The lowest and the highest vertex, of all meshes or of those that a foot carries.
  std::pair<double, double> heights(const std::vector<Affine>& model, bool of_feet = false) const {
    double low = 1e9, high = -1e9;
    for (std::uint32_t m = 0; m < cook_.file.mesh_count(); ++m) {
      const Mesh mesh = cook_.file.mesh(m);
      const auto follows = [&](Role role) {
        return std::count(mesh.joints, mesh.joints + mesh.joint_count, joint_of(roles_, role)) > 0;
      };
      if (of_feet && !follows(Role::left_foot) && !follows(Role::right_foot)) continue;
      std::vector<Affine> palette(mesh.palette_size());
      std::vector<float> at(std::size_t{3} * mesh.geometry.slot_count);
      EXPECT_EQ(build_palette(mesh, model, palette), Status::ok);
      EXPECT_EQ(skin_ssd(mesh, palette, {at, {}, {}}), Status::ok);
      for (std::size_t i = 1; i < at.size(); i += 3) {
        low = std::min(low, double{at[i]});
        high = std::max(high, double{at[i]});
      }
    }
    return {low, high};
  }
  const File& file() const { return cook_.file; }

 private:
  double way(Role a, Role b, Role c) const { return glm::length(rest(b) - rest(a)) + glm::length(rest(c) - rest(b)); }
  LoadedCook cook_;
  Roles roles_;
  Skeleton skeleton_;
  std::vector<Affine> rest_;
  double to_size_ = 1;
};

// How a clip came over, in millimetres of a body of that size: means.
struct HowCarried {
  double slide = 0, height = 0, hands = 0;
  double knees_deg = 0;  // by how much a knee is straighter at most
};

// `source`: the clip's own body. Feet are in contact where the source's soles are low and hardly move otherwise than
// the ground does below a body that walks on the spot.
inline HowCarried compare_bodies(const MeasuredBody& source, std::uint32_t source_clip, const MeasuredBody& target,
                                 std::uint32_t target_clip) {
  HowCarried out;
  const double scale = target.leg() / source.leg(), arms = target.arm() / source.arm(), mm = 1000 * target.to_size();
  const auto faces = [](const MeasuredBody& body) {
    return (body.rest(Role::left_upper_leg) - body.rest(Role::right_upper_leg)).x > 0;
  };
  const double facing = faces(source) == faces(target) ? 1 : -1;
  double spans = 0, contacts = 0, near = 0;
  const auto steps = static_cast<int>(source.duration_s(source_clip) / double{kStepS});
  for (const Role foot : {Role::left_foot, Role::right_foot}) {
    std::vector<glm::dvec3> from, to;
    double low = 1e9;
    for (int i = 0; i <= steps; ++i) {
      const float time_s = static_cast<float>(i) * kStepS;
      from.push_back(source.sole(source.pose(source_clip, time_s), foot));
      to.push_back(target.sole(target.pose(target_clip, time_s), foot));
      low = std::min(low, from.back().y);
    }
    low = std::min(low, source.ground());
    const auto touches = [&](int i) { return (from[static_cast<std::size_t>(i)].y - low) * source.to_size() < 0.025; };
    for (int i = 0; i <= steps; ++i) {
      if (!touches(i)) continue;
      int end = i;
      while (end < steps && touches(end + 1)) ++end;
      if (end - i >= 3) {
        glm::dvec2 least(1e9), most(-1e9);
        for (int k = i; k <= end; ++k) {
          const auto at = static_cast<std::size_t>(k);
          const glm::dvec2 off(to[at].x - facing * scale * from[at].x, to[at].z - facing * scale * from[at].z);
          least = glm::min(least, off);
          most = glm::max(most, off);
          // The source's ground is where its soles come lowest, as it may sink into that of its rest pose.
          out.height += mm * std::abs(to[at].y - target.ground() - scale * (from[at].y - low));
          ++contacts;
        }
        out.slide += mm * glm::length(most - least);
        ++spans;
      }
      i = end;
    }
  }
  for (int i = 0; i <= steps; ++i) {
    const float time_s = static_cast<float>(i) * kStepS;
    const std::vector<Affine> a = source.pose(source_clip, time_s), b = target.pose(target_clip, time_s);
    const auto apart = [](const MeasuredBody& body, const std::vector<Affine>& model) {
      return glm::length(body.place(model, Role::left_hand) - body.place(model, Role::right_hand));
    };
    const double d = apart(source, a);
    if (d < 0.5 * source.arm() && target.arm() > 0) {
      out.hands += mm * std::abs(apart(target, b) - arms * d);
      ++near;
    }
    const Role legs[2][3] = {{Role::left_upper_leg, Role::left_lower_leg, Role::left_foot},
                             {Role::right_upper_leg, Role::right_lower_leg, Role::right_foot}};
    for (const auto& leg : legs) {
      const auto angle = [&](const MeasuredBody& body, const std::vector<Affine>& model) {
        const glm::dvec3 middle = body.place(model, leg[1]);
        const glm::dvec3 up = glm::normalize(body.place(model, leg[0]) - middle);
        return std::acos(std::clamp(glm::dot(up, glm::normalize(body.place(model, leg[2]) - middle)), -1.0, 1.0));
      };
      out.knees_deg = std::max(out.knees_deg, 57.29577951308232 * (angle(target, b) - angle(source, a)));
    }
  }
  if (spans > 0) out.slide /= spans;
  if (contacts > 0) out.height /= contacts;
  if (near > 0) out.hands /= near;
  return out;
}

}  // namespace marrow::cook
