// SHAP sections byte by byte (docs/format.md).
#pragma once

#include "asset/format.h"
#include "marrow/example_space.h"

namespace marrow::format {

// Behind it rows of floats and what they belong to.
struct ExampleHeader {
  std::uint32_t name;
  std::uint32_t mesh_count;       // ≥ 1
  std::uint16_t parameter_count;  // 1 … kMaxExampleParameters
  std::uint16_t example_count;    // 1 … kMaxExamples
  std::uint16_t target_count;     // 1 … kMaxExamples
  std::uint16_t reserved;         // 0
};
static_assert(sizeof(ExampleHeader) == 16);

// Floats of a row.
constexpr std::uint32_t example_row(std::uint32_t target_count) {
  return (target_count + 3) / 4 * 4;
}

struct ExampleLayout {
  std::uint64_t linear, radial, places, widths, parameters, targets, meshes, bytes;
};
constexpr ExampleLayout layout(const ExampleHeader& h) {
  const std::uint64_t row = std::uint64_t{example_row(h.target_count)} * 4;
  ExampleLayout l{};
  l.linear = sizeof h;
  l.radial = l.linear + (h.parameter_count + 1u) * row;
  l.places = l.radial + h.example_count * row;
  l.widths = l.places + std::uint64_t{h.example_count} * h.parameter_count * 4;
  l.parameters = l.widths + std::uint64_t{h.example_count} * 4;
  l.targets = l.parameters + h.parameter_count * sizeof(ExampleParameter);
  l.meshes = l.targets + std::uint64_t{h.target_count} * 4;
  l.bytes = l.meshes + std::uint64_t{h.mesh_count} * 4;
  return l;
}

}  // namespace marrow::format
