#pragma once

namespace marrow::cook {

// What animation space's residual is made of, as far as the rest of a file says it: linear blend skinning smoothed.
struct ResidualSource {
  int iterations = 0;  // 0: it is not known
  double step = 0;
  bool is_all = false;  // it is nothing else
};

}  // namespace marrow::cook
