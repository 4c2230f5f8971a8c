// Shape by example, the stage before morph: numbers that a game or a clip sets → weights of morph targets.
//
//   once a load    File::example_space, find_example_channels
//   every frame    sample_channels → parameters → evaluate_examples → weights of each of the space's meshes → morph(),
//                  or CharacterMesh::weights between pose_character() and finish_character()
//
// An artist places shapes at points of a space, such as "angry" at (1, 0). Each shape is a morph target, or the mesh as
// it is. Between those points all shapes are interpolated at once. The cooker solves for the coefficients here
// (docs/deformers.md).
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// What a space has at most.
inline constexpr std::uint32_t kMaxExampleParameters = 8;
inline constexpr std::uint32_t kMaxExamples = 64;  // also the most targets

// An axis of the space.
struct ExampleParameter {
  std::uint32_t name = 0;  // see File::text; also of the channel that drives it
  float rest = 0;          // where nothing drives it
};
static_assert(sizeof(ExampleParameter) == 8);

// Rows have one float a target, and zeros up to a multiple of four.
struct ExampleSpace {
  const char* name = "";                         // as the source calls it; never null
  std::uint32_t example_count = 0;               // at most kMaxExamples
  Span<const ExampleParameter> parameters = {};  // at most kMaxExampleParameters
  Span<const std::uint32_t> targets = {};  // of each mesh the targets that it weighs, ascending, at most kMaxExamples
  Span<const std::uint32_t> meshes = {};   // of the file, ascending
  Span<const float> linear = {};           // a row of constants, then a row a parameter
  Span<const float> radial = {};           // a row an example
  Span<const float> places = {};           // for each example its parameters
  Span<const float> inverse_widths = {};   // one an example; above 0
};

// For each parameter the index of the channel of `clip` that has its name, or kNoChannel. The space is of `file`, the
// clip of `clips`, the same or a clip pack. out: at least space.parameters.size. Errors: bad_argument. Cost: compares
// names; once a load.
MARROW_API Status find_example_channels(const File& file, const ExampleSpace& space, const File& clips,
                                        const Clip& clip, Span<std::uint32_t> out);

// Weights of the space's targets at a point of it; others are left as they are.
//   weight_t(p) = linear_t · (1, p) + Σ_k radial_kt R(|p - place_k| · inverse_width_k)
//   R(x) = 2/3 - x² + x³/2 below 1, (2 - x)³/6 below 2, 0 beyond: the cubic B-spline
// At an example's place its own target has weight 1 and all others 0, but for rounding. Far from all examples weights
// are linear: they leave 0 … 1, so clamp parameters where a shape must not be exaggerated.
// parameters: finite, at least space.parameters.size; weights: one a target of the mesh. Errors: bad_argument (also for
// a space by hand whose spans are too short, or with a target beyond the weights); bad_data if a weight is not finite:
// nothing is written. The same bits on every processor.
// Method: P.-P. Sloan, C. Rose, M. Cohen, "Shape by example", I3D 2001, section 3: cardinal functions.
// Cost: instructions an example, each with a target of its own, x86-64, g++ 12 -O3: in spaces of 2 parameters 91 of 8
// examples, 69 of 64; of 6 parameters 142 and 131. It grows with the examples that are near.
MARROW_API Status evaluate_examples(const ExampleSpace& space, Span<const float> parameters, Span<float> weights);

}  // namespace marrow
