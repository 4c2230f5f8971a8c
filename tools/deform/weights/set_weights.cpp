#include "deform/weights/set_weights.h"

#include <algorithm>
#include <utility>

#include "deform/weights/auto_weights.h"

namespace marrow::deform {

bool set_weights(std::span<const Influence> given, std::size_t most, std::vector<Influence>& influences) {
  const auto is_given = [&](const Influence& i) {
    return std::ranges::any_of(given, [&](const Influence& g) { return g.joint == i.joint; });
  };
  double sum = 0, rest = 0;
  for (const Influence& g : given) sum += g.weight;
  for (const Influence& i : influences)
    if (!is_given(i)) rest += i.weight;
  if (rest <= 0 && sum <= 0) return false;
  std::vector<Influence> out(given.begin(), given.end());
  for (const Influence& i : influences)
    if (!is_given(i) && rest > 0 && sum < 1) out.push_back({i.joint, i.weight / rest * (1 - sum)});
  keep_largest(out, most, 0);
  influences = std::move(out);
  return true;
}

}  // namespace marrow::deform
