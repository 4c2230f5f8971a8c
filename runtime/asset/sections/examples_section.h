// SHAP: a space of example shapes. load() looks at where it stands alone; File::example_space() holds it to its rules.
#pragma once

#include "asset/format.h"
#include "marrow/example_space.h"

namespace marrow::format {

struct ExampleHeader {
  std::uint32_t name;
  std::uint32_t mesh_count;
  std::uint16_t parameter_count;
  std::uint16_t example_count;
  std::uint16_t target_count;
  std::uint16_t reserved;
};
static_assert(sizeof(ExampleHeader) == 16);

// Floats of a row.
constexpr std::uint32_t example_row(std::uint32_t target_count) {
  return (target_count + 3) / 4 * 4;
}

struct ExampleLayout {
  Array<float> linear, radial, places, widths;
  Array<ExampleParameter> parameters;
  Array<std::uint32_t> targets, meshes;
  std::uint64_t bytes;
};
template <>
struct LayoutOf<ExampleHeader> {
  using Type = ExampleLayout;
};

template <class V>
constexpr void fields(V& v, const ExampleParameter& p) {
  v.name({"name"}, p.name);
  v.finite({"rest"}, p.rest);
}

template <class V>
constexpr void fields(V& v, const ExampleHeader& h, ExampleLayout& l) {
  const std::uint64_t row = example_row(h.target_count);
  v.name({"name", "offset into NAME"}, h.name);
  v.range({"mesh_count", "≥ 1"}, h.mesh_count, 1u, UINT32_MAX, "a space of no mesh");
  v.range({"parameter_count", "1 … 8"}, h.parameter_count, 1u, kMaxExampleParameters, "1 to 8 parameters");
  v.range({"example_count", "1 … 64"}, h.example_count, 1u, kMaxExamples, "1 to 64 examples");
  v.range({"target_count", "1 … 64"}, h.target_count, 1u, kMaxExamples, "1 to 64 targets");
  v.reserved(h.reserved);
  v.array({"linear", "constants, then what each parameter adds", "row × (1 + parameter_count)"}, l.linear,
          (h.parameter_count + 1u) * row, Floats::finite);
  v.array({"radial", "", "row × example_count"}, l.radial, h.example_count * row, Floats::finite);
  v.array({"places", "of the examples, finite", "parameter_count × example_count"}, l.places,
          std::uint64_t{h.example_count} * h.parameter_count, Floats::finite);
  v.array({"inverse_widths", "above 0, finite", "example_count"}, l.widths, h.example_count, Floats::finite);
  v.records({"parameters", "u32 name, also of the channel that drives it, an offset into NAME; f32 rest, finite",
             "parameter_count"},
            l.parameters, h.parameter_count, [&](const ExampleParameter& p) { fields(v, p); });
  v.array({"targets", "ascending; morph targets of each of the meshes", "target_count"}, l.targets, h.target_count);
  v.array({"meshes", "ascending; MESH sections", "mesh_count"}, l.meshes, h.mesh_count);
}

}  // namespace marrow::format
