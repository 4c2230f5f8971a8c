// A pointer and a count: std::span without its header's weight.
#pragma once

#include <cstddef>
#include <initializer_list>

namespace marrow {

// Views memory of the caller's, whatever that is in; const T takes what is T, too. A call refuses, as bad_argument, a
// span that is too short, null with a size, or off the boundary of its elements: 16 bytes for SoaTransform and Affine,
// which allocators of 32-bit systems do not give.
template <class T>
struct Span {
  T* data = nullptr;     // the first; null if empty
  std::size_t size = 0;  // how many

  constexpr Span() = default;
  // `count` elements from `first` on.
  constexpr Span(T* first, std::size_t count) : data(first), size(count) {}
  // From anything with data() and size(): std::vector, std::array, std::span, std::string.
  template <class Container>
  requires requires(Container& c, T*& p) {
    p = c.data();
    c.size();
  }
  constexpr Span(Container&& c) : data(c.data()), size(c.size()) {}
  // From a span of what converts: of T to const T.
  template <class U>
  requires requires(U* u, T*& p) { p = u; }
  constexpr Span(Span<U> other) : data(other.data), size(other.size) {}
  // From an array, all of it: of a text with the zero that ends it.
  template <std::size_t count>
  constexpr Span(T (&array)[count]) : data(array), size(count) {}
  // From a list in braces, to read: blend(skeleton, {{walk, 0.7f}, {run, 0.3f}}, out). The list is there until the call
  // is over, so a Span that is kept, a variable or a member of one, must not be made from it.
  constexpr Span(std::initializer_list<T> list) requires requires(const T* listed, T*& p) {
    p = listed;
  } : Span(list.begin(), list.size()) {
  }

  // Precondition: i < size.
  constexpr T& operator[](std::size_t i) const { return data[i]; }
  // For loops over all.
  constexpr T* begin() const { return data; }
  // One behind the last.
  constexpr T* end() const { return data + size; }
  // Whether there are none.
  constexpr bool empty() const { return size == 0; }
};

}  // namespace marrow
