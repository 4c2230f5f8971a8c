// What an elastic body may be told.
#pragma once

namespace marrow::deform {

struct ElasticOptions {
  double volume = 6;  // how dearly cells keep theirs, beside keeping their shape; 15 for what twists far
  double keep = 0.1;  // how dearly corners keep to where joints take them
};

}  // namespace marrow::deform
