// What is asked of layers of animations.
#pragma once

#include "core/check.h"
#include "marrow/character.h"

namespace marrow {

// Of one, and of as many as the character's options say.
BadCall check_layer(const Character& character, const AnimationLayer& layer);
BadCall check_layers(const Character& character, Span<const AnimationLayer> layers);

}  // namespace marrow
