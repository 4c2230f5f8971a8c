// A heap that takes equals in the same order with every standard library, of which each orders them in its own way:
// what is cooked in a browser is the same as on a desktop.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace marrow::tools {

template <class T>
class Heap {
 public:
  bool empty() const { return items_.empty(); }

  void push(T value) {
    items_.emplace_back();
    rise(items_.size() - 1, std::move(value));
  }

  // The largest by operator<. There must be one. Bottom-up: the hole goes down to a leaf, and the last item rises from
  // there (I. Wegener, Bottom-up heapsort, 1993).
  T pop() {
    T out = std::move(items_.front());
    T last = std::move(items_.back());
    items_.pop_back();
    if (items_.empty()) return out;
    std::size_t hole = 0;
    for (std::size_t child = 1; child < items_.size(); child = 2 * hole + 1) {
      if (child + 1 < items_.size() && !(items_[child + 1] < items_[child])) ++child;
      items_[hole] = std::move(items_[child]);
      hole = child;
    }
    rise(hole, std::move(last));
    return out;
  }

 private:
  void rise(std::size_t hole, T value) {
    for (std::size_t parent; hole > 0 && items_[parent = (hole - 1) / 2] < value; hole = parent)
      items_[hole] = std::move(items_[parent]);
    items_[hole] = std::move(value);
  }

  std::vector<T> items_;
};

}  // namespace marrow::tools
