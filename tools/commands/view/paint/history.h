// Strokes that can be taken back, and made again.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "commands/view/paint/stroke.h"

namespace marrow::tools {

class History {
 public:
  static constexpr std::size_t kMost = 200;  // strokes; older ones stay

  // One that has been made. What was taken back is forgotten.
  void add(Edit edit) {
    if (edit.empty()) return;
    edits_.resize(done_);
    if (saved_ > static_cast<std::ptrdiff_t>(done_)) saved_ = kGone;
    edits_.push_back(std::move(edit));
    ++done_;
    if (edits_.size() <= kMost) return;
    edits_.erase(edits_.begin());
    --done_;
    saved_ = saved_ <= 0 ? kGone : saved_ - 1;
  }
  std::size_t done() const { return done_; }
  std::size_t undone() const { return edits_.size() - done_; }
  void undo(Canvas& canvas) {
    if (done_ > 0) tools::undo(canvas, edits_[--done_]);
  }
  void redo(Canvas& canvas) {
    if (done_ < edits_.size()) tools::redo(canvas, edits_[done_++]);
  }
  // Whether it is as it was when it was saved last, or at first.
  bool saved() const { return saved_ == static_cast<std::ptrdiff_t>(done_); }
  void set_saved() { saved_ = static_cast<std::ptrdiff_t>(done_); }
  void set_unsaved() { saved_ = kGone; }

 private:
  static constexpr std::ptrdiff_t kGone = -1;
  std::vector<Edit> edits_;
  std::size_t done_ = 0;
  std::ptrdiff_t saved_ = 0;
};

}  // namespace marrow::tools
