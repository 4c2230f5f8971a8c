// How a character is to be drawn, on the command line: what `marrow render` and `marrow view` share.
#pragma once

#include <span>

#include <CLI/CLI.hpp>

#include "render/look.h"

namespace marrow::tools {

// paths: what --path offers.
void add_look(CLI::App* command, LookArguments& arguments, std::span<const NamedSkinPath> paths,
              std::span<const Named<Deformer>> deformers = kDeformers);

// --ik and what goes with it.
void add_reach(CLI::App* command, ReachArguments& arguments);

}  // namespace marrow::tools
