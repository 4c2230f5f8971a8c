// Vertices by all that they hold.
#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "cook/geometry/owned_streams.h"

namespace marrow::cook {

// All numbers of each vertex, one behind the other.
class Rows {
 public:
  explicit Rows(const OwnedStreams& streams);
  std::string_view of(std::size_t vertex) const { return {&all_[vertex * bytes_], bytes_}; }

 private:
  std::size_t bytes_ = 0;
  std::vector<char> all_;
};

// The first vertex of each row of `rows`, which must outlive this. Empty if some are alike but not in `whole`.
using Places = std::unordered_map<std::string_view, std::uint32_t>;
Places places_of(const Rows& rows, const Rows& whole, std::uint32_t count);

}  // namespace marrow::cook
