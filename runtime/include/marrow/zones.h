// Profiler zones: begin and end of the calls that take time, for Perfetto, Tracy, systrace, Instruments.
//
//   static const marrow::ZoneHandler zones = {[](const char* name) { ATrace_beginSection(name); },
//                                             [](const char*) { ATrace_endSection(); }};
//   marrow::set_zone_handler(&zones);
//
// Only a build with MARROW_ZONES=ON has zones. Without it, which is the default, they take no byte and no instruction,
// and nobody is told.
#pragma once

#include "marrow/api.h"

namespace marrow {

// Called on the thread of the call. name: of the public function, as "sample"; a static string. Calls nest, and each
// begin has its end, by the same handler.
struct ZoneHandler {
  void (*begin)(const char* name);  // a call begins
  void (*end)(const char* name);    // it ends
};

// From now on calls that begin are told to `handler`, which stays as it is while any of them goes on; null: nobody is
// told. Returns the handler before. Thread-safe; the handler must be so too. Cost of a zone without a handler: a load
// and a comparison. Without MARROW_ZONES it does nothing and returns null.
MARROW_API const ZoneHandler* set_zone_handler(const ZoneHandler* handler);

}  // namespace marrow
