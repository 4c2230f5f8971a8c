// A pointer and a count: std::span without its header's weight.
#pragma once

#include <cstddef>

namespace marrow {

template <class T>
struct Span {
  T* data = nullptr;
  std::size_t size = 0;

  constexpr Span() = default;
  constexpr Span(T* first, std::size_t count) : data(first), size(count) {}
  // From anything with data() and size(): std::vector, std::array, std::span, std::string.
  template <class Container>
  requires requires(Container& c, T*& p) {
    p = c.data();
    c.size();
  }
  constexpr Span(Container&& c) : data(c.data()), size(c.size()) {}
  template <class U>
  requires requires(U* u, T*& p) { p = u; }
  constexpr Span(Span<U> other) : data(other.data), size(other.size) {}

  constexpr T& operator[](std::size_t i) const { return data[i]; }
  constexpr T* begin() const { return data; }
  constexpr T* end() const { return data + size; }
  constexpr bool empty() const { return size == 0; }
};

}  // namespace marrow
