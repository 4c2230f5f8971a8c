// Bad calls by chance: arguments most of which are good, and what every public function keeps to whatever it is given.
#pragma once

#include <algorithm>
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
    std::is_same_v<T, AdditiveTransform> || std::is_same_v<T, InertialOffset> || std::is_same_v<T, RigidStep> ||
    std::is_same_v<T, RootKey> || std::is_same_v<T, PlanePoint> || std::is_same_v<T, SpeedPoint>;

// How long a list must be at least: as it is, or nothing at all, or anything.
enum class Length { exact, exact_or_none, any };

// The arguments of one call, and what came of it. Memory that it hands out is exactly as long as it says, so that a
// sanitizer sees the first byte past it. A call with good arguments is done. One of which a single argument cannot be
// right, such as memory that is too short, is refused.
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
  // Whether this round spoils what no call may take.
  bool spoils(const char* what) { return is_bad() && must_refuse(what); }
  // A copy: shorter, empty, null, off its boundary, or holding such numbers and indices. Longer is as good.
  template <class T>
  Span<const T> in(Span<const T> good, Length length = Length::exact) {
    return span(good, length);
  }
  template <class T>
  Span<const T> in(const std::vector<T>& good, Length length = Length::exact) {
    return span(Span<const T>(good), length);
  }
  // The same to be written: its bytes stay if the call is refused, and its floats are finite if it is not.
  template <class T>
  Span<T> out(Span<const T> good, Length length = Length::exact) {
    const Span<T> given = span(good, length);
    if (shape_ != Shape::null && shape_ != Shape::off_boundary) watch<T>(given.data, given.size);
    if (shape_ == Shape::longer && length != Length::any) watched_.back().written = good.size * sizeof(T);
    return given;
  }
  template <class T>
  Span<T> out(const std::vector<T>& good, Length length = Length::exact) {
    return out(Span<const T>(good), length);
  }
  template <class T>
  Span<T> out(std::size_t count, Length length = Length::exact) {
    return out(std::vector<T>(count), length);
  }
  // Room to work in, which may hold anything.
  template <class T>
  Span<T> room(std::size_t count, Length length = Length::exact) {
    const bool garbage = garbage_;
    const Span<T> given = span(Span<const T>(std::vector<T>(count)), length);
    garbage_ = garbage;
    return given;
  }
  // Bytes on a boundary; now and then off it, or too few, which is no bad call where they are a file's.
  Span<std::byte> memory(std::size_t bytes, std::size_t boundary = 16, Length length = Length::exact);
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
  // From here on `calls` stays as it is if the call is refused: what a driver counts, once all is made ready.
  void stays(const std::size_t& calls);
  // There is nothing to refuse; or good arguments are not all that it takes.
  void never_refuses() { refuses_ = false; }
  void may_fail() { may_fail_ = true; }

  // What the call came to.
  void returned(Status status);
  void returned(float value);
  void returned_ok() { ++ok_; }
  std::size_t ok() const { return ok_; }
  std::size_t refused() const { return refused_; }
  // Of a call that is refused as such, and of one that gives a Status.
  std::size_t told() const { return told_; }
  bool refuses() const { return refuses_; }
  bool gave_status() const { return gave_status_; }

 private:
  enum class Shape { good, shorter, empty, null, off_boundary, numbers, longer };
  struct Watched {
    const std::byte* at;
    std::vector<std::byte> before;
    bool is_floats;
    std::size_t written;  // bytes that an accepted call may write
  };

  bool is_bad();
  bool must_refuse(const char* what);
  float bad_number(float good);
  template <class T>
  Span<T> span(Span<const T> good, Length length);
  void take_shape(std::size_t size, std::size_t boundary, Length length);
  bool same_behind(const Watched& w, std::size_t first) const;
  template <class T>
  T* own(std::size_t count, std::size_t off);
  template <class T>
  void watch(const T* first, std::size_t count);
  void expect_finite();
  void expect_what_must_come(Status status, const std::vector<CallError>& heard);

  const char* function_;
  std::uint64_t round_;
  Random random_;
  bool careless_, garbage_ = false, gave_status_ = false;
  // How many arguments are bad. Of a single one: what is wrong with it, if no call may take it, or that every call
  // does.
  int bad_ = 0;
  const char* wrong_ = nullptr;
  bool fine_ = false, refuses_ = true, may_fail_ = false;
  const std::size_t* calls_ = nullptr;
  std::size_t calls_before_ = 0;
  Shape shape_ = Shape::good;
  std::size_t ok_ = 0, refused_ = 0, told_ = 0;
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
Span<T> Misuse::span(Span<const T> good, Length length) {
  take_shape(good.size, alignof(T), length);
  const std::size_t size = shape_ == Shape::empty     ? 0
                           : shape_ == Shape::shorter ? good.size - 1
                           : shape_ == Shape::longer  ? good.size + 1
                                                      : good.size;
  if (shape_ == Shape::null) return {nullptr, size};
  // Half of the boundary: what allocators of 32-bit machines give, of what wants 16 bytes.
  T* const first = own<T>(size, shape_ == Shape::off_boundary ? alignof(T) / 2 : 0);
  if (size > 0) std::memcpy(static_cast<void*>(first), good.data, std::min(size, good.size) * sizeof(T));
  if (size > good.size) std::memcpy(static_cast<void*>(first + good.size), good.data, sizeof(T));
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
  watched_.push_back({bytes, {bytes, bytes + count * sizeof(T)}, kIsFloats<T>, count * sizeof(T)});
}

// A row's call of what refuses nothing.
#define MISUSED(call) \
  [](Misuse& m) {     \
    (void)(call);     \
    m.returned_ok();  \
  }

// A public function and a call of it.
struct MisuseRow {
  const char* function;
  std::function<void(Misuse&)> call;
};
std::vector<MisuseRow> rows_of_files();
std::vector<MisuseRow> rows_of_poses();
std::vector<MisuseRow> rows_of_motion();
std::vector<MisuseRow> rows_of_animators();
std::vector<MisuseRow> rows_of_curves();
std::vector<MisuseRow> rows_of_reaching();
std::vector<MisuseRow> rows_of_following();
std::vector<MisuseRow> rows_of_skinning();
std::vector<MisuseRow> rows_of_characters();
std::vector<MisuseRow> rows_of_lines();

// A function that a description of C has (runtime/c/*.txt), by its name in C++. tools/c_api holds them to the headers.
struct PublicFunction {
  std::string name;
  bool has_arguments, gives_status;
};
std::vector<PublicFunction> functions_in(const char* description);
// That there is a row of every function of the description, and no other, and that each is refused or harmless.
void expect_rows_of(const char* description, const std::vector<MisuseRow>& rows);

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
