// What a file's spaces of example shapes make of a character's morph weights.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "marrow/character.h"
#include "marrow/example_space.h"

namespace marrow::tools {

class ExampleWeights {
 public:
  // The file's spaces are good; `file` is copied. Throws Failure (invalid) otherwise.
  explicit ExampleWeights(const File& file);

  bool empty() const { return spaces_.empty(); }
  const std::vector<ExampleSpace>& spaces() const { return spaces_; }
  // A parameter of a space as the layers have it: channels of their clips, blended as morph weights are.
  float parameter(std::size_t space, std::size_t index, std::span<const AnimationLayer> layers) const;
  // Writes the weights of each mesh of each space, for between pose_character() and finish_character().
  void write(std::span<const AnimationLayer> layers, marrow::Character& character) const;

 private:
  File file_;
  std::vector<ExampleSpace> spaces_;
};

}  // namespace marrow::tools
