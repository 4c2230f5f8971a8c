// Checks that sections keep to their descriptions (sections/*.h), and to the further rules of check_*.cpp.
#pragma once

#include <type_traits>

#include "asset/format.h"
#include "core/builtins.h"

namespace marrow {

// The least squared length of a quaternion that counts as a rotation. The least dot product of two consecutive keys of
// a LINEAR rotation. Both keep quaternions, and what is interpolated between them, away from length 0.
inline constexpr float kShortestSquare = 0.5f, kLeastProduct = -0.25f;
// The next float above format::kFarthest.
inline constexpr float kBeyondFarthest = bit_cast<float>(bit_cast<std::uint32_t>(format::kFarthest) + 1);
// A component of a unit quaternion is below this, rounding included.
inline constexpr float kMostOfUnit = 1.01f;
inline constexpr const char *kNotFinite = "a number that is not finite",
                            *kNotBounded = "a number that is not finite, or beyond 1e12",
                            *kNoUnit = "a rotation that is no unit quaternion",
                            *kWrongSize = "section size differs from its counts";

// Checks one block. It keeps the first broken rule and where it is broken. It can be called on after that; nothing
// changes then, so descriptions need not ask after each call whether all is well.
class Checker {
 public:
  using Field = format::Field;
  using Floats = format::Floats;

  // first, counts: for each kind of section, its first one and how many there are.
  Checker(Span<const std::byte> block, Span<const File::Section> sections, const std::uint32_t* first,
          const std::uint32_t* counts)
      : block_(block), sections_(sections), first_(first), counts_(counts) {}

  const DataError& error() const { return error_; }
  bool good() const { return error_.status == Status::ok; }
  // Keeps the first broken rule. Inline, so that callers see that it returns false.
  bool fail(const void* where, const char* rule) {
    keep_first(where, rule);
    return false;
  }

  // Begins a section. Returns whether it is long enough for a header, and its codec is no greater than `last_codec`.
  bool begin(const File::Section& s, std::uint32_t header_bytes, std::uint32_t last_codec);
  const File::Section& section() const { return *section_; }
  // Whether the section has exactly so many bytes.
  bool has_size(std::uint64_t bytes);
  // Whether the section before it in the file has the same type.
  bool follows_its_like() const { return section_ != sections_.data && section_[-1].type == section_->type; }
  const void* header() const { return base_; }
  template <class Header>
  const Header& header_before() const {
    return *reinterpret_cast<const Header*>(block_.data + section_[-1].offset);
  }
  // What stands at an offset in the section. The section must be known to be long enough.
  template <class T>
  const T& at(std::uint64_t offset) const {
    return *reinterpret_cast<const T*>(base_ + offset);
  }
  template <class T>
  Span<const T> in(const format::Array<T>& array) const {
    return array.in(header());
  }
  // The header of section number n of a kind. There must be such a section.
  template <class Header>
  const Header& nth(format::Kind kind, std::uint32_t n) const {
    return *reinterpret_cast<const Header*>(block_.data + sections_[first_[kind] + n].offset);
  }
  std::uint32_t bytes_of(format::Kind kind, std::uint32_t n) const { return sections_[first_[kind] + n].bytes; }
  // alone: whether `array` and `records` skip what stands in arrays. For a header that is checked before its section's
  // size is known.
  void leave_arrays(bool alone) { leaves_arrays_ = alone; }
  // The skeleton that the section is for.
  const format::SkeletonHeader& owner() const { return *owner_; }

  // The first float whose magnitude is not below `limit`; null if there is none. Infinities and NaN are never below it.
  static const float* first_from(float limit, const float* first, std::uint64_t count);
  bool floats_below(float limit, const float* first, std::uint64_t count, const char* rule);

  // The words of descriptions, see sections/fields.h.
  template <class T>
  void any(const Field&, const T&) {}
  template <class T>
  void reserved(const T& value) {
    zero(&value, sizeof value);
  }
  template <class T, class Least, class Most>
  void range(const Field&, const T& value, Least least, Most most, const char* rule) {
    in_range(&value, word(value), word(least), word(most), rule);
  }
  template <class T>
  void flags(const Field&, const T& value, std::uint32_t all, const char* rule) {
    in_range(&value, value & ~all, 0, 0, rule);
  }
  void name(const Field&, const std::uint32_t& n) { is_name(n); }
  void text(const Field&, const std::uint32_t& n) { is_text(n); }
  template <class T>
  void finite(const Field&, const T& value) {
    floats(value, Floats::finite);
  }
  template <class T>
  void bounded(const Field&, const T& value) {
    floats(value, Floats::bounded);
  }
  void not_negative(const Field&, const float& value, const char* rule) { float_within(value, 0, kInfinity, rule); }
  void within(const Field&, const float& value, float least, float most, const char* rule) {
    float_within(value, least, most, rule);
  }
  void inside(const Field&, const float& value, float least, float most, const char* rule) {
    if (!(value > least && value < most)) fail(&value, rule);
  }
  template <std::size_t count>
  void near(const Field&, const float (&values)[count], float most, const char* rule) {
    for (const float& x : values) float_within(x, -most, most, rule);
  }
  void skeleton(const Field&, const std::uint32_t& n) { find_owner(n, format::kSkeletons); }
  void skeleton_or_reference(const Field&, const std::uint32_t& n) {
    find_owner(n, counts_[format::kReferences] != 0 ? format::kReferences : format::kSkeletons);
  }
  void only_of_skeleton(const Field&, const std::uint32_t& n, const char* rule);
  template <class T>
  void below(const Field&, const T& value, std::uint32_t limit, const char* rule) {
    if (!(value < limit)) fail(&value, rule);
  }
  template <class T>
  void section(const Field&, const T& value, format::Kind kind, const char* rule) {
    below({}, value, counts_[kind], rule);
  }
  template <class T>
  void joint(const Field&, const T& value, const char* rule) {
    below({}, value, joint_count(), rule);
  }
  std::uint32_t count_of(format::Kind kind) const { return counts_[kind]; }
  std::uint32_t joint_count() const { return owner_->joint_count; }  // a reference's, too
  template <class T>
  void array(const Field&, const format::Array<T>& a, std::uint64_t, Floats which = Floats::any) {
    if (which != Floats::any) array_of_floats(a.at, a.bytes() / sizeof(float), which);
  }
  void array(const Field&, const format::Array<SoaTransform>& a, std::uint64_t) { array_of_transforms(a); }
  template <class T, class EachRecord>
  void records(const Field&, const format::Array<T>& a, std::uint64_t, const EachRecord& each) {
    if (leaves_arrays_) return;
    const Span<const T> all = in(a);
    for (const T* record = all.begin(); record != all.end() && good(); ++record) each(*record);
  }
  void align() {}

 private:
  [[gnu::cold]] void keep_first(const void* where, const char* rule);
  template <class T>
  static constexpr std::uint32_t word(T value) {
    return static_cast<std::uint32_t>(value);
  }
  void in_range(const void* where, std::uint32_t value, std::uint32_t least, std::uint32_t most, const char* rule);
  void zero(const void* where, std::size_t bytes);
  bool is_text(const std::uint32_t& n);
  void is_name(const std::uint32_t& n);
  void floats(const float* first, std::uint64_t count, Floats which);
  void floats(const float& value, Floats which) { floats(&value, 1, which); }
  template <std::size_t count>
  void floats(const float (&values)[count], Floats which) {
    floats(values, count, which);
  }
  void floats(const Affine& value, Floats which) { floats(value.rows[0], 12, which); }
  void array_of_floats(std::uint64_t first, std::uint64_t count, Floats which);
  void array_of_transforms(const format::Array<SoaTransform>& a);
  void float_within(const float& value, float least, float most, const char* rule);
  void find_owner(const std::uint32_t& number, format::Kind kind);

  Span<const std::byte> block_;
  Span<const File::Section> sections_;
  const std::uint32_t* first_;
  const std::uint32_t* counts_;
  const File::Section* section_ = nullptr;
  const std::byte* base_ = nullptr;  // where the section begins
  const format::SkeletonHeader* owner_ = nullptr;
  bool leaves_arrays_ = false;
  DataError error_;
};

// The dot product of two quaternions whose components are `stride` floats apart.
inline float dot_of_rotations(const float* a, const float* b, std::size_t stride = 1) {
  return a[0] * b[0] + a[stride] * b[stride] + a[2 * stride] * b[2 * stride] + a[3 * stride] * b[3 * stride];
}

inline std::uint32_t count_bits(std::uint32_t bits) {
  std::uint32_t count = 0;
  for (; bits != 0; bits &= bits - 1) ++count;
  return count;
}

// Whether a section is as large as its header and arrays are, and keeps to its description.
template <class Header>
bool check_fields(Checker& c, const Header& h, typename format::LayoutOf<Header>::Type& l) {
  lay_out(h, l);
  if (!c.has_size(l.bytes)) return false;
  fields(c, h, l);
  return c.good();
}

// The check of a kind that has no rules beyond its description.
template <class Header>
void check(Checker& c, const Header& h) {
  typename format::LayoutOf<Header>::Type l;
  check_fields(c, h, l);
}
void check(Checker& c, const format::SkeletonHeader& h);
void check(Checker& c, const format::ReferenceHeader& h);
void check(Checker& c, const format::ClipHeader& h);
void check(Checker& c, const format::GeometryHeader& h);
void check(Checker& c, const format::MeshHeader& h);
void check(Checker& c, const format::MaterialHeader& h);
void check(Checker& c, const format::ImageHeader& h);
void check(Checker& c, const format::NodeHeader& h);
void check(Checker& c, const format::LimitHeader& h);
void check(Checker& c, const format::SpringHeader& h);
void check(Checker& c, const format::RoleHeader& h);
void check(Checker& c, const format::MotionHeader& h);
void check(Checker& c, const format::PoseMapHeader& h);
void check(Checker& c, const format::BoundsHeader& h);

// A kind of section as load() knows it.
struct SectionKind {
  std::uint32_t kind, type;
  std::uint32_t header_bytes, last_codec;
  void (*check)(Checker&, const void* header);  // null: only the section's place is checked
};
template <class Header>
constexpr SectionKind section_kind(std::uint32_t kind, std::uint32_t type, std::uint32_t last_codec) {
  if constexpr (std::is_void_v<Header>) {
    return {kind, type, 0, last_codec, nullptr};
  } else {
    return {kind, type, sizeof(Header), last_codec,
            [](Checker& c, const void* header) { check(c, *static_cast<const Header*>(header)); }};
  }
}
// Those of kind.h, in the order of a file.
extern const Span<const SectionKind> kSectionKinds;

// Checks a whole file, whose sections are of these kinds; the last section must be the names. Sets first[kind] and
// counts[kind] for each kind that the file has, by the kind's number: its first section, and how many there are. All
// counts must be 0 before.
DataError check_file(Span<const std::byte> block, Span<const SectionKind> kinds, std::uint32_t* first,
                     std::uint32_t* counts);

}  // namespace marrow
