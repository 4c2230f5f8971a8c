// MARROW_ZONE: the first line of a public function that takes time, see marrow/zones.h.
#pragma once

#include "marrow/zones.h"

#if defined(MARROW_ZONES) && MARROW_ZONES

namespace marrow {

class Zone {
 public:
  explicit Zone(const char* name);
  ~Zone() {
    if (handler_ != nullptr) handler_->end(name_);
  }
  Zone(const Zone&) = delete;
  Zone& operator=(const Zone&) = delete;

 private:
  const ZoneHandler* handler_;  // the one that was told of the beginning
  const char* name_;
};

}  // namespace marrow
#define MARROW_ZONE const ::marrow::Zone marrow_zone(__func__)

#else

#define MARROW_ZONE static_cast<void>(0)

#endif
