// A character's file as a command names it: cooked, or a model that is cooked in memory first.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "common/load_mrw.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"

namespace marrow::tools {

struct OpenedCharacter {
  LoadedFile loaded;
  std::vector<std::string> reads;  // what it was made from, itself first
  bool cooked_here = false;
  std::string settings;      // the marrow.toml that it was cooked by; empty: none
  std::size_t warnings = 0;  // of cooking
};

// What a caller wants of a model that is cooked here.
struct CookHere {
  bool takes_roots = false;  // clips without a rule of their own get --root '*=ground', as graphs move characters
  // Called with the scene before it is cooked.
  std::function<void(const cook::RawScene&, const cook::CookOptions&)> look = {};
};

// A model is cooked as `marrow cook PATH` would: with the settings of the nearest marrow.toml, else with the defaults.
// Throws Failure: what loading and cooking throw; usage if the settings make it a clip pack. Cost: of cooking, seconds
// for a large file.
OpenedCharacter open_character(const std::string& path, const CookHere& how = {});

}  // namespace marrow::tools
