// A skeleton for a scene that has none, or in the place of the one that it has.
#pragma once

#include <string>

#include "cook/prepare/bind_weights.h"
#include "cook/scene/raw.h"
#include "deform/rig/auto_skeleton.h"

namespace marrow::cook {

struct RiggedScene {
  RawScene scene;
  MadeSkeleton made;
};

// Puts a template, called `name`, into all meshes that are drawn, as they rest: nodes that are
// joints, and nothing bound to them yet. Skins, clips of nodes, springs and limits are gone, and warnings say so.
// Throws tools::Failure: invalid for meshes without an inside, of several parts, or that the template does not fit;
// unsupported for too many vertices.
RiggedScene add_skeleton(RawScene scene, const std::string& name, const deform::SkeletonTemplate& skeleton,
                         Notes& notes);

}  // namespace marrow::cook
