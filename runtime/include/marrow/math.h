// A little mathematics of joints and places, for games that bring none: maps one after another, back, and on points.
//
// Maps take column vectors: compose(a, b) does b first. None of it allocates; all of it is thread-safe. marrow/glm.h
// is for games that have GLM.
#pragma once

#include "marrow/api.h"
#include "marrow/pose.h"

namespace marrow {

// translate · rotate · scale. The rotation is taken as it is: a unit quaternion gives a rotation.
MARROW_API Affine affine_of(const JointTransform& transform);

// a · b: what `b` makes, taken through `a`. world_from_joint = compose(world_from_model, model_from_joint[j]).
MARROW_API Affine compose(const Affine& a, const Affine& b);

// The way back: compose(out, map) is the identity, within rounding.
// Errors: bad_argument for a map that is flat (a scale of 0) or not finite, or whose inverse is not finite; nothing is
// written. Method: cofactors over the determinant.
MARROW_API Status invert(const Affine& map, Affine& out);

// A point through a map. out may be point.
MARROW_API void transform_point(const Affine& map, const float (&point)[3], float (&out)[3]);

// A direction through a map: as a point, but without the map's translation. Its length changes as the map scales.
MARROW_API void transform_direction(const Affine& map, const float (&direction)[3], float (&out)[3]);

// Which way in the joint's own axes a direction of model space is, of unit length: what Aim::forward and Aim::up ask
// for. With the rest pose's matrices it says once a load where a head's front is.
// Errors: bad_argument as invert(), and for a direction without length; nothing is written.
MARROW_API Status direction_in_joint(const Affine& model_from_joint, const float (&direction)[3], float (&out)[3]);

}  // namespace marrow
