// How a kind of section is described: once, for all that read, check, write and list it.
//
// A kind has a header, a layout, which says where the arrays behind the header stand, and one description:
//
//   template <class V>
//   constexpr void fields(V& v, const NodeHeader& h, NodeLayout& l);
//
// It names each member of the header and each array in the order of the file, with the rule of docs/format.md. Who
// visits it decides what that does: LayOut (below) places the arrays, Checker (checker.h) holds a section to the rules,
// the cooker writes by the layout, and a test lists the tables of docs/format.md. What one member has to do with
// another, or with other sections, is a plain function of check_*.cpp.
//
// To add a kind: a header like those beside this one, and its line in kinds.h.
#pragma once

#include <cstddef>
#include <cstdint>

#include "marrow/span.h"

namespace marrow::format {

// What the page says of a member or an array.
struct Field {
  const char* name;
  const char* rule = "";
  const char* times = "";  // of an array: how many; of bytes what they are
};

// Which numbers an array of floats may have.
enum class Floats : std::uint8_t { any, finite, bounded };

// An array of a section: where it begins, in bytes from the section's start, and how many elements it has.
template <class T>
struct Array {
  std::uint64_t at = 0, count = 0;
  constexpr operator std::uint64_t() const { return at; }
  constexpr std::uint64_t bytes() const { return count * sizeof(T); }
  // Where the section is known to be whole.
  Span<const T> in(const void* section) const {
    return {reinterpret_cast<const T*>(static_cast<const std::byte*>(section) + at), static_cast<std::size_t>(count)};
  }
};

inline constexpr std::uint64_t align4(std::uint64_t n) {
  return (n + 3) & ~std::uint64_t{3};
}
inline constexpr std::uint64_t align16(std::uint64_t n) {
  return (n + 15) & ~std::uint64_t{15};
}

// The words of descriptions, none of which does anything here.
struct Unheard {
  // A member of a header or a record: any number; 0; least to most; no bits but those of `all`.
  template <class... A>
  constexpr void any(const Field&, const A&...) {}
  template <class... A>
  constexpr void reserved(const A&...) {}
  template <class... A>
  constexpr void range(const Field&, const A&...) {}
  template <class... A>
  constexpr void flags(const Field&, const A&...) {}
  // An offset into NAME: of a name, whose length has a limit; of any text.
  template <class... A>
  constexpr void name(const Field&, const A&...) {}
  template <class... A>
  constexpr void text(const Field&, const A&...) {}
  // Floats: one, an array of them, or an Affine. Finite; within 1e12; one that is not below 0; one from least to most,
  // or between them.
  template <class... A>
  constexpr void finite(const Field&, const A&...) {}
  template <class... A>
  constexpr void bounded(const Field&, const A&...) {}
  template <class... A>
  constexpr void not_negative(const Field&, const A&...) {}
  template <class... A>
  constexpr void within(const Field&, const A&...) {}
  template <class... A>
  constexpr void inside(const Field&, const A&...) {}
  // Floats whose magnitude is at most `most`.
  template <class... A>
  constexpr void near(const Field&, const A&...) {}
  // The skeleton that the section is for, by its number; in a clip pack the reference. The last is of kinds of which a
  // skeleton has one section at most, in their order.
  template <class... A>
  constexpr void skeleton(const Field&, const A&...) {}
  template <class... A>
  constexpr void skeleton_or_reference(const Field&, const A&...) {}
  template <class... A>
  constexpr void only_of_skeleton(const Field&, const A&...) {}
  // A number below a limit; the number of a section of a kind; that of a joint of the skeleton.
  template <class... A>
  constexpr void below(const Field&, const A&...) {}
  template <class... A>
  constexpr void section(const Field&, const A&...) {}
  template <class... A>
  constexpr void joint(const Field&, const A&...) {}
  constexpr std::uint32_t count_of(std::uint32_t) { return 0; }  // sections of a kind
  constexpr std::uint32_t joint_count() { return 0; }            // of the skeleton

  // The arrays behind the header, one after the other: of plain numbers, of transforms, and of records, each of which
  // is described as a header is.
  template <class... A>
  constexpr void array(const Field&, const A&...) {}
  template <class... A>
  constexpr void records(const Field&, const A&...) {}
  // The next array begins on a boundary of four bytes.
  constexpr void align() {}
};

// More elements than any file holds: a product of two counts may be more, and wrap when it is times their size.
inline constexpr std::uint64_t kTooMany = std::uint64_t{1} << 48;

// Says where arrays stand.
class LayOut : public Unheard {
 public:
  constexpr explicit LayOut(std::uint64_t at) : end_(at) {}
  template <class T>
  constexpr void array(const Field&, Array<T>& out, std::uint64_t count, Floats = Floats::any) {
    out = {end_, count < kTooMany ? count : kTooMany};
    end_ += out.bytes();
  }
  template <class T, class EachRecord>
  constexpr void records(const Field& field, Array<T>& out, std::uint64_t count, const EachRecord&) {
    array(field, out, count);
  }
  constexpr void align() { end_ = align4(end_); }
  constexpr std::uint64_t end() const { return end_; }

 private:
  std::uint64_t end_;
};

// Which layout a header has: a specialisation of each header.
template <class Header>
struct LayoutOf;

// Of counts too large for any file, more bytes than a section may have.
template <class Header>
constexpr void lay_out(const Header& h, typename LayoutOf<Header>::Type& l) {
  LayOut v(sizeof h);
  fields(v, h, l);
  l.bytes = v.end();
}
template <class Header>
constexpr auto layout(const Header& h) -> typename LayoutOf<Header>::Type {
  typename LayoutOf<Header>::Type l{};
  lay_out(h, l);
  return l;
}

}  // namespace marrow::format
