#include "marrow/debug_lines.h"

#include <cstring>

#include "core/check.h"
#include "limits/limit_ranges.h"
#include "marrow/limits.h"
#include "math/affine.h"
#include "math/joint.h"

namespace marrow {
namespace {

using Colour = std::uint8_t[4];
constexpr Vector3 kAxes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr int kCircle = 16;                                            // lines of a circle, and of an arc
constexpr float kCircleCos = 0.923879533f, kCircleSin = 0.382683432f;  // of a sixteenth of a turn

// Appends to the caller's lines.
class Pen {
 public:
  explicit Pen(DebugLines& lines) : lines_(lines) {}

  void line(const Vector3& from, const Vector3& to, const Colour& colour) const {
    DebugLine l;
    store(l.from, from);
    store(l.to, to);
    std::memcpy(l.colour, colour, sizeof l.colour);
    if (lines_.count >= lines_.room.size || !all_finite(l.from, 3) || !all_finite(l.to, 3)) {
      ++lines_.left_out;
    } else {
      lines_.room[lines_.count++] = l;
    }
  }
  void axes(const Affine& model, float size, const Colour* colours) const {
    for (int i = 0; i < 3; ++i) line(origin(model), origin(model) + along(model, kAxes[i], size), colours[i]);
  }
  void cross(const Vector3& centre, float size, const Colour& colour) const {
    for (const Vector3& axis : kAxes) line(centre - axis * size, centre + axis * size, colour);
  }
  // Three great circles.
  void ball(const Vector3& centre, float radius, const Colour& colour) const {
    for (int i = 0; i < 3; ++i) {
      float c = radius, s = 0;
      for (int k = 0; k < kCircle; ++k) {
        const float next_c = c * kCircleCos - s * kCircleSin, next_s = s * kCircleCos + c * kCircleSin;
        const Vector3 &u = kAxes[i], &v = kAxes[(i + 1) % 3];
        line(centre + u * c + v * s, centre + u * next_c + v * next_s, colour);
        c = next_c;
        s = next_s;
      }
    }
  }

  // A direction of the space that `model` takes to model space, so long there.
  static Vector3 along(const Affine& model, const Vector3& direction, float size) {
    const Vector3 d = linear(model) * direction;
    const float squared = dot(d, d);
    return has_direction(squared) ? d * (size / sqrt(squared)) : Vector3{};
  }

 private:
  DebugLines& lines_;
};

Vector3 point_of(const Affine& model, const float (&point)[3]) {
  return origin(model) + linear(model) * vector3(point);
}

bool is_length(float x) {
  return within(x, 0.0f, 1e18f);
}

bool has_room(const DebugLines& lines) {
  return lines.count <= lines.room.size && holds(lines.room);
}

// One joint's limit, in the space that the joint turns in.
class LimitPen {
 public:
  LimitPen(const Pen& pen, const JointLimit& limit, const Affine& model_from_parent, const Vector3& at, float size)
      : pen_(pen),
        limit_(limit),
        scene_(model_from_parent),
        at_(at),
        size_(size),
        parent_from_limit_(conjugate(rotation(limit.limit_from_parent))) {}

  void draw(const Rotation& local) const {
    const Rotation t = rotation(limit_.limit_from_parent) * local * rotation(limit_.joint_from_limit);
    float now[4];
    store(now, local);
    const Colour& colour = limit_excess(limit_, now) > kLimitTolerance_rad ? kOutsideColour : kInsideColour;
    if (limit_.kind == LimitKind::hinge) {
      arc(limit_.angles[0], kAxes[0], kAxes[1], kBoneColour, true);
      pen_.line(at_, tip(t, kAxes[1]), colour);
    } else if (limit_.kind == LimitKind::cone) {
      rim();
      pen_.line(at_, tip(t, kAxes[0]), colour);
    } else if (limit_.kind == LimitKind::euler) {
      // Which axis each factor of the product turns about.
      constexpr std::uint8_t kFactors[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
      for (int f = 0; f < 3; ++f) {
        const int axis = kFactors[static_cast<int>(limit_.order)][f];
        arc(limit_.angles[f], kAxes[axis], kAxes[(axis + 1) % 3], kAxisColours[axis], false);
        pen_.line(at_, tip(t, kAxes[axis]), colour);
      }
    }
  }

 private:
  Vector3 tip(const Rotation& t, const Vector3& axis) const {
    return at_ + Pen::along(scene_, rotate(parent_from_limit_ * t, axis), size_);
  }

  // Where `shown` goes as the joint turns about `axis` from one end of the range to the other.
  void arc(const AngleRange& range, const Vector3& axis, const Vector3& shown, const Colour& colour,
           bool spokes) const {
    const ranges::HalfAngle middle = ranges::half_angle(range.middle);
    Vector3 last;
    for (int k = 0; k <= kCircle; ++k) {
      const float share = static_cast<float>(2 * k - kCircle) / kCircle;
      const ranges::HalfAngle angle = middle + ranges::half_angle(range.half_width * share);
      const Vector3 next = tip(quaternion(axis * angle.sin, angle.cos), shown);
      if (k > 0) pen_.line(last, next, colour);
      if (spokes && (k == 0 || k == kCircle)) pen_.line(at_, next, colour);
      last = next;
    }
  }

  void rim() const {
    float c = 1, s = 0;
    Vector3 last = swung(c, s);
    for (int k = 0; k < kCircle; ++k) {
      if (k % (kCircle / 4) == 0) pen_.line(at_, last, kBoneColour);
      const float next_c = c * kCircleCos - s * kCircleSin;
      s = s * kCircleCos + c * kCircleSin;
      c = next_c;
      const Vector3 next = swung(c, s);
      pen_.line(last, next, kBoneColour);
      last = next;
    }
  }
  // The limit's x, swung as far as may be about (0, c, s).
  Vector3 swung(float c, float s) const {
    const float y = c * limit_.angles[1].half_width, z = s * limit_.angles[2].half_width, squared = y * y + z * z;
    const float k = 1.0f / (1.0f + squared);
    return tip({0, 2 * y * k, 2 * z * k, (1 - squared) * k}, kAxes[0]);
  }

  const Pen& pen_;
  const JointLimit& limit_;
  const Affine& scene_;
  Vector3 at_;
  float size_;
  Rotation parent_from_limit_;
};

}  // namespace

Status joint_lines(const Skeleton& skeleton, Span<const Affine> model_from_joint, float axis_m, DebugLines& lines) {
  MARROW_REQUIRE(has_room(lines));
  MARROW_REQUIRE(holds(model_from_joint, skeleton.joint_count));
  MARROW_REQUIRE(is_length(axis_m));
  const Pen pen(lines);
  for (std::uint32_t j = 0; j < skeleton.joint_count; ++j) {
    const std::uint16_t parent = skeleton.parents[j];
    if (parent != kNoJoint) pen.line(origin(model_from_joint[parent]), origin(model_from_joint[j]), kBoneColour);
    if (axis_m > 0) pen.axes(model_from_joint[j], axis_m, kAxisColours);
  }
  return Status::ok;
}

Status limit_lines(const Skeleton& skeleton, Span<const JointLimit> limits, Span<const SoaTransform> local,
                   Span<const Affine> model_from_joint, float size_m, DebugLines& lines) {
  MARROW_REQUIRE(has_room(lines));
  MARROW_REQUIRE(holds(local, skeleton.soa_size()) && holds(model_from_joint, skeleton.joint_count));
  MARROW_REQUIRE(holds(limits));
  MARROW_REQUIRE(is_length(size_m));
  for (const JointLimit& limit : limits) MARROW_REQUIRE(limit.joint < skeleton.joint_count);
  const Pen pen(lines);
  for (const JointLimit& limit : limits) {
    if (!is_valid(limit)) continue;
    const std::uint16_t j = limit.joint, parent = skeleton.parents[j];
    const Affine& above = parent == kNoJoint ? skeleton.model_from_root[j] : model_from_joint[parent];
    LimitPen(pen, limit, above, origin(model_from_joint[j]), size_m).draw(rotation_of(local, j));
  }
  return Status::ok;
}

Status goal_lines(const Skeleton& skeleton, Span<const IkGoal> goals, Span<const Affine> model_from_joint, float size_m,
                  float tolerance_m, DebugLines& lines) {
  MARROW_REQUIRE(has_room(lines));
  MARROW_REQUIRE(holds(model_from_joint, skeleton.joint_count) && holds(goals));
  MARROW_REQUIRE(is_length(size_m) && is_length(tolerance_m));
  for (const IkGoal& goal : goals) MARROW_REQUIRE(goal.joint < skeleton.joint_count);
  const Pen pen(lines);
  for (const IkGoal& goal : goals) {
    const Vector3 there = vector3(goal.position), here = point_of(model_from_joint[goal.joint], goal.offset);
    const Vector3 way = there - here;
    const Colour& colour = dot(way, way) <= tolerance_m * tolerance_m ? kInsideColour : kOutsideColour;
    if (goal.rotation_weight > 0) {
      pen.axes(affine(columns_of(normalised(rotation(goal.rotation))), there), size_m, kAxisColours);
    } else {
      pen.cross(there, size_m, colour);
    }
    pen.line(here, there, colour);
  }
  return Status::ok;
}

Status spring_lines(const Skeleton& skeleton, Span<const SpringChain> chains, Span<const Affine> model_from_joint,
                    DebugLines& lines) {
  MARROW_REQUIRE(has_room(lines));
  MARROW_REQUIRE(holds(model_from_joint, skeleton.joint_count) && holds(chains));
  for (const SpringChain& chain : chains) {
    MARROW_REQUIRE(holds(chain.joints));
    for (const SpringJoint& j : chain.joints) MARROW_REQUIRE(j.joint < skeleton.joint_count);
  }
  const Pen pen(lines);
  for (const SpringChain& chain : chains) {
    for (std::size_t i = 1; i < chain.joints.size; ++i)
      pen.line(origin(model_from_joint[chain.joints[i - 1].joint]), origin(model_from_joint[chain.joints[i].joint]),
               kSpringColour);
    const Vector3 tip = vector3(chain.tip);
    if (chain.joints.empty() || !(dot(tip, tip) > 0)) continue;
    const Affine& last = model_from_joint[chain.joints[chain.joints.size - 1].joint];
    pen.line(origin(last), point_of(last, chain.tip), kSpringColour);
  }
  return Status::ok;
}

Status collider_lines(const Skeleton& skeleton, Span<const SpringCollider> colliders,
                      Span<const Affine> model_from_joint, DebugLines& lines) {
  MARROW_REQUIRE(has_room(lines));
  MARROW_REQUIRE(holds(model_from_joint, skeleton.joint_count) && holds(colliders));
  for (const SpringCollider& c : colliders) MARROW_REQUIRE(c.joint < skeleton.joint_count);
  const Pen pen(lines);
  for (const SpringCollider& c : colliders) {
    const Affine& model = model_from_joint[c.joint];
    float most = 0;
    for (int i = 0; i < 3; ++i) {
      const Vector3 axis = column(model, i);
      const float squared = dot(axis, axis);
      most = squared > most ? squared : most;
    }
    const float radius = c.radius_m * sqrt(most);
    const Vector3 from = point_of(model, c.from), to = point_of(model, c.to), way = to - from;
    pen.ball(from, radius, kColliderColour);
    if (!(dot(way, way) > 0)) continue;
    pen.ball(to, radius, kColliderColour);
    const Vector3 any = absolute(way.x) < absolute(way.y) ? kAxes[0] : kAxes[1];
    const Vector3 across = cross(way, any), other = cross(way, across);
    const Vector3 sides[2] = {across * (radius / sqrt(dot(across, across))),
                              other * (radius / sqrt(dot(other, other)))};
    for (const Vector3& side : sides) {
      pen.line(from + side, to + side, kColliderColour);
      pen.line(from - side, to - side, kColliderColour);
    }
  }
  return Status::ok;
}

Status bounds_lines(const Bounds& bounds, DebugLines& lines) {
  MARROW_REQUIRE(has_room(lines));
  if (bounds.is_empty()) return Status::ok;
  const Pen pen(lines);
  const Vector3 least = vector3(bounds.box_min), most = vector3(bounds.box_max);
  // From each corner along the axes that are at their least there.
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 at = {(corner & 1) != 0 ? most.x : least.x, (corner & 2) != 0 ? most.y : least.y,
                        (corner & 4) != 0 ? most.z : least.z};
    if ((corner & 1) == 0) pen.line(at, {most.x, at.y, at.z}, kBoundsColour);
    if ((corner & 2) == 0) pen.line(at, {at.x, most.y, at.z}, kBoundsColour);
    if ((corner & 4) == 0) pen.line(at, {at.x, at.y, most.z}, kBoundsColour);
  }
  pen.ball({bounds.centre(0), bounds.centre(1), bounds.centre(2)}, bounds.radius_m, kBoundsColour);
  return Status::ok;
}

}  // namespace marrow
