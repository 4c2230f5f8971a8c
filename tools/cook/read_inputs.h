// The first stage: all that a cook reads, the scene and the files that options name.
#pragma once

#include <string>
#include <vector>

#include "cook/gltf/read.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"
#include "marrow/cook_host.h"

namespace marrow::cook {

// An artist's file: read_bvh() of what is called so, else read_gltf(). Throws as they do, and tools::Failure (usage)
// where a scene of motion capture is asked for.
RawScene read_source(const std::string& name, Files& files, const SourceOptions& options);

// A file with another rig: glTF, motion capture or cooked. Throws as these are read.
RawScene read_rig(const std::string& name, Files& files);

// Reads what options name, but for `skeleton_file`: it is beside the names then. Files are added to `reads`. Throws
// tools::Failure as Files::read(); usage and invalid for what is too large or not of its kind.
void read_named_files(CookOptions& options, Files& files, std::vector<Read>& reads);

}  // namespace marrow::cook
