// MARROW_MARK: the first line of a public function that takes time, see marrow/marks.h.
#pragma once

#include "marrow/marks.h"

#if defined(MARROW_MARKS) && MARROW_MARKS

namespace marrow {

class Mark {
 public:
  explicit Mark(const char* name);
  ~Mark() {
    if (handler_ != nullptr) handler_->end(name_);
  }
  Mark(const Mark&) = delete;
  Mark& operator=(const Mark&) = delete;

 private:
  const MarkHandler* handler_;  // the one that was told of the beginning
  const char* name_;
};

}  // namespace marrow
#define MARROW_MARK const ::marrow::Mark marrow_mark(__func__)

#else

#define MARROW_MARK static_cast<void>(0)

#endif
