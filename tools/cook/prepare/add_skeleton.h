// A skeleton for a scene that has none, or in the place of the one that it has.
#pragma once

#include <string>

#include "cook/prepare/bind_weights.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

struct RiggedScene {
  RawScene scene;
  MadeSkeleton made;
};

// Puts a template, as read_template() knows it by name, into all meshes that are drawn, as they rest: nodes that are
// joints, and nothing bound to them yet. Skins, clips of nodes, springs and limits are gone, and warnings say so.
// Throws tools::Failure: invalid for meshes without an inside, of several parts, or that the template does not fit;
// unsupported for too many vertices; for the template as read_template() does.
RiggedScene add_skeleton(RawScene scene, const std::string& name, Notes& notes);

}  // namespace marrow::cook
