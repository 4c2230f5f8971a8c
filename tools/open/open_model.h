// The model of a command: what its command line says of it, and the one way to open that. commands/arguments.h has the
// options.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "behave/find_graph.h"
#include "common/load_mrw.h"
#include "cook/scene/cook_options.h"
#include "cook/scene/raw.h"
#include "pose/choose.h"
#include "pose/evaluate.h"

namespace marrow::tools {

// What a command line says. A command has options for some of it; the rest stays as it is here.
struct ModelArguments {
  std::string file;
  std::vector<std::string> outfits;  // that it wears
  Choice choice;                     // what plays, and when
  std::uint32_t lod = 0;
  bool by_graph = false;         // whether it goes by a graph; then the choice names no clip
  BehaviourArguments behaviour;  // which graph, by clips of which packs
};

// What a command opens.
enum class Opens {
  cooked_files,
  models,          // too: they are cooked in memory first, as `marrow cook FILE` would
  models_by_graph  // likewise; clips without a rule of their own get --root '*=ground', as graphs move characters
};

struct OpenedModel {
  std::string path;
  LoadedFile loaded;
  std::vector<std::string> reads;  // what it was made from, itself first
  bool cooked_here = false;
  std::string settings;      // the marrow.toml that it was cooked by; empty: none
  std::size_t warnings = 0;  // of cooking

  const File& file() const { return loaded.file; }
};

// Called with the scene of a model before it is cooked.
using LookAtScene = std::function<void(const cook::RawScene&, const cook::CookOptions&)>;

// A model is cooked with the settings of the nearest marrow.toml, else with the defaults. Throws Failure: what loading
// and cooking throw; usage if the settings make it a clip pack. Cost: of cooking, seconds for a large file.
OpenedModel open_model(const std::string& path, Opens opens = Opens::cooked_files, const LookAtScene& look = {});

// With what is to play on it.
struct Model : OpenedModel {
  Chosen chosen;                            // nothing with a graph
  std::map<std::string, float> parameters;  // of example shapes, in place of the clip's
};

// Throws Failure as well: usage if it has not this level of detail, and what choose() and set_parameters() throw.
Model open_model(const ModelArguments& arguments, Opens opens);

// Sets the parameters of a character of the model, and puts on what it wears. Throws Failure: what put_on() throws.
void prepare(const ModelArguments& arguments, const Model& model, Character& character,
             AsNormals normals = AsNormals::blended);

// Throws Failure (usage) if `file`, of this path, has not this level of detail.
void expect_level(const std::string& path, const File& file, std::uint32_t level);

}  // namespace marrow::tools
