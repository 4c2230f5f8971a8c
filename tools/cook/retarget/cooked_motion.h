// A cooked file's clips, to be put onto another rig.
#pragma once

#include <string>

#include "cook/scene/raw.h"
#include "marrow/cook_host.h"

namespace marrow::cook {

// A scene of the file's joints, which its clips move, but for additive ones: keys every 1/60 s, or farther apart where
// they would be too many. Throws tools::Failure as load_mrw(), and (invalid) for a clip pack, which does not say how
// its joints rest.
RawScene read_cooked_motion(const std::string& name, Files& files);

}  // namespace marrow::cook
