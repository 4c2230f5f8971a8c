// Short runs of vertices become longer ones.
#pragma once

#include "cook/geometry/owned_streams.h"

namespace marrow::cook {

// Lets vertices follow joints without a weight where that makes fewer runs, as CPUs set up matrices once a run: two
// sets of joints become their union where that costs less. Both have the same last joint, whose weight is what others
// leave; so sums only gain zeros, and each vertex goes where it went to the bit. No vertex follows more joints than the
// mesh's most. Of welded streams.
void merge_runs(OwnedStreams& streams);

}  // namespace marrow::cook
