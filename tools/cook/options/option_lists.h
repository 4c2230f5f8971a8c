// The parts of option_table(), each in a file of its own.
#pragma once

#include <array>
#include <iterator>
#include <span>

#include "cook/options/options.h"
#include "cook/options/read_value.h"
#include "text/choices.h"

namespace marrow::cook {

using tools::Named;
using tools::value_of;

// The names in one of text/choices.h's tables, as Option::choices has them.
template <const auto& table>
inline constexpr auto names_in = [] {
  std::array<const char*, std::size(table)> out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = table[i].name;
  return out;
}();

std::span<const Option> clip_options();
std::span<const Option> motion_options();
std::span<const Option> precision_options();
std::span<const Option> learn_options();
std::span<const Option> mesh_options();
std::span<const Option> weight_options();
std::span<const Option> scene_options();

}  // namespace marrow::cook
