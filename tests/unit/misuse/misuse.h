// Bad calls by chance: arguments most of which are good, and what every public function keeps to whatever it is given.
#pragma once

#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "marrow/marrow.h"
#include "support/call_errors.h"
#include "support/rig.h"

namespace marrow::test {

// What holds nothing but floats.
template <class T>
inline constexpr bool kIsFloats =
    std::is_same_v<T, float> || std::is_same_v<T, SoaTransform> || std::is_same_v<T, Affine> ||
    std::is_same_v<T, AdditiveTransform> || std::is_same_v<T, InertialOffset>;

// The arguments of one call, and what came of it. Memory that it hands out is exactly as long as it says, so that a
// sanitizer sees the first byte past it.
class Misuse {
 public:
  Misuse(const char* function, std::uint64_t seed);

  // Each gives what it is given; in two of three rounds, some give what a careless game might pass instead.
  float number(float good);                 // not a number, infinite, the smallest, huge, of the other sign
  std::uint32_t index(std::uint32_t good);  // 0, the next, far beyond
  bool truth(bool good) { return is_bad() ? !good : good; }
  template <class E>
  E kind(E good) {
    return is_bad() ? static_cast<E>(random_.below(256)) : good;
  }
  template <class T>
  T* pointer(T* good) {
    return is_bad() ? nullptr : good;
  }
  // A copy: shorter, empty, null, off its boundary, or holding such numbers and indices.
  template <class T>
  Span<const T> in(Span<const T> good) {
    return span(good);
  }
  template <class T>
  Span<const T> in(const std::vector<T>& good) {
    return span(Span<const T>(good));
  }
  // The same to be written: its bytes stay if the call is refused, and its floats are finite if it is not.
  template <class T>
  Span<T> out(Span<const T> good) {
    const Span<T> given = span(good);
    if (shape_ != Shape::null && shape_ != Shape::off_boundary) watch<T>(given.data, given.size);
    return given;
  }
  template <class T>
  Span<T> out(const std::vector<T>& good) {
    return out(Span<const T>(good));
  }
  template <class T>
  Span<T> out(std::size_t count) {
    return out(std::vector<T>(count));
  }
  // Room to work in, which may hold anything.
  template <class T>
  Span<T> room(std::size_t count) {
    const bool garbage = garbage_;
    const Span<T> given = span(Span<const T>(std::vector<T>(count)));
    garbage_ = garbage;
    return given;
  }
  // Bytes on a boundary of 16; now and then off it, or too few.
  Span<std::byte> memory(std::size_t bytes);
  // A result, or a state, that is one thing.
  template <class T>
  T& one(T good) {
    T* const t = own<T>(1, 0);
    std::memcpy(static_cast<void*>(t), &good, sizeof good);
    watch<T>(t, 1);
    return *t;
  }
  // One thing to be read, in memory of its own.
  template <class T>
  const T& given(T good) {
    T* const t = own<T>(1, 0);
    std::memcpy(static_cast<void*>(t), &good, sizeof good);
    return *t;
  }
  // One of several, mostly the first.
  template <class T>
  const T& either(const T& good, const T& other) {
    return is_bad() ? other : good;
  }

  // Which of a row's calls this is.
  std::uint64_t round() const { return round_; }
  // A refused call may have written a part.
  void may_write_when_refused() { watched_.clear(); }
  // Floats that make no sense went in as they were: nobody promises what comes out.
  void garbage_in() { garbage_ = true; }

  // What the call came to.
  void returned(Status status);
  void returned(float value);
  void returned_ok() { ++ok_; }
  std::size_t ok() const { return ok_; }
  std::size_t refused() const { return refused_; }

 private:
  enum class Shape { good, shorter, empty, null, off_boundary, numbers };
  struct Watched {
    const std::byte* at;
    std::vector<std::byte> before;
    bool is_floats;
  };

  bool is_bad() { return careless_ && random_.below(8) == 0; }
  float bad_number(float good);
  template <class T>
  Span<T> span(Span<const T> good);
  template <class T>
  T* own(std::size_t count, std::size_t off);
  template <class T>
  void watch(const T* first, std::size_t count);
  void expect_finite();

  const char* function_;
  std::uint64_t round_;
  Random random_;
  bool careless_, garbage_ = false;
  Shape shape_ = Shape::good;
  std::size_t ok_ = 0, refused_ = 0;
  std::vector<std::unique_ptr<std::byte, void (*)(void*)>> memory_;
  std::vector<Watched> watched_;
  CallErrors errors_;
};

template <class T>
T* Misuse::own(std::size_t count, std::size_t off) {
  void* first = nullptr;
  if (posix_memalign(&first, 16, count * sizeof(T) + off + (count == 0)) != 0) std::abort();
  memory_.emplace_back(static_cast<std::byte*>(first), std::free);
  return reinterpret_cast<T*>(static_cast<std::byte*>(first) + off);
}

template <class T>
Span<T> Misuse::span(Span<const T> good) {
  shape_ = is_bad() ? static_cast<Shape>(1 + random_.below(5)) : Shape::good;
  const std::size_t size = shape_ == Shape::empty                      ? 0
                           : shape_ == Shape::shorter && good.size > 0 ? good.size - 1
                                                                       : good.size;
  if (shape_ == Shape::null) return {nullptr, size};
  // Half of the boundary: what allocators of 32-bit machines give, of what wants 16 bytes.
  T* const first = own<T>(size, shape_ == Shape::off_boundary ? alignof(T) / 2 : 0);
  if (size > 0) std::memcpy(static_cast<void*>(first), good.data, size * sizeof(T));
  if (shape_ == Shape::numbers && size > 0) {
    if constexpr (kIsFloats<T>) {
      float* const floats = reinterpret_cast<float*>(first);
      for (int i = 0; i < 3; ++i) {
        float& f = floats[random_.below(static_cast<std::uint32_t>(size * sizeof(T) / sizeof(float)))];
        f = bad_number(f);
      }
      garbage_ = true;
    } else if constexpr (std::is_integral_v<T>) {
      T& i = first[random_.below(static_cast<std::uint32_t>(size))];
      i = static_cast<T>(random_.below(2) == 0 ? ~T{} : i + 1);
    }
  }
  return {first, size};
}

template <class T>
void Misuse::watch(const T* first, std::size_t count) {
  const auto* const bytes = reinterpret_cast<const std::byte*>(first);
  watched_.push_back({bytes, {bytes, bytes + count * sizeof(T)}, kIsFloats<T>});
}

// A public function and a call of it.
struct MisuseRow {
  const char* function;
  std::function<void(Misuse&)> call;
};
std::vector<MisuseRow> rows_of_files();
std::vector<MisuseRow> rows_of_poses();
std::vector<MisuseRow> rows_of_curves();
std::vector<MisuseRow> rows_of_reaching();
std::vector<MisuseRow> rows_of_following();
std::vector<MisuseRow> rows_of_skinning();
std::vector<MisuseRow> rows_of_characters();
std::vector<MisuseRow> rows_of_lines();

// Names of all functions that headers declare, members too. headers: which of them, by name.
std::set<std::string> declared_functions(const std::function<bool(const std::string&)>& headers);
// That there is a row of every function that the headers declare, and no other. headers: which of them, by name.
void expect_a_row_of_each(const std::vector<MisuseRow>& rows, const std::function<bool(const std::string&)>& headers);
// That a page of the documents names every function that the headers declare, as `function`.
void expect_each_named_in(const char* document, const std::function<bool(const std::string&)>& headers);
// That misuse is refused or harmless, and good calls are done.
void misuse_all(const std::vector<MisuseRow>& rows);

// What good calls are made with.
struct MisuseStage {
  MisuseStage();
  TestCharacter creature;
  TestSkeleton smaller_skeleton;
  Skeleton skeleton, smaller;
  Clip clip;
  Mesh mesh;
  std::vector<SoaTransform> pose, other;
  std::vector<Affine> joints, palette;
};
const MisuseStage& stage();

}  // namespace marrow::test
