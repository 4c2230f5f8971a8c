// A section in the making: the header, and each array where its description (asset/sections) has it.
#pragma once

#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "asset/format.h"

namespace marrow::cook {

class Section {
 public:
  Section() = default;
  // Of a kind without a header.
  explicit Section(const std::vector<char>& bytes) : bytes_(bytes.size()), filled_(bytes.size()) {
    std::memcpy(bytes_.data(), bytes.data(), bytes.size());
  }

  // Puts a header behind what is there, and makes room for its arrays: those of `l`, its layout.
  template <class Header, class Layout>
  Layout begin(const Header& h, const Layout& l) {
    static_assert(std::is_trivially_copyable_v<Header>);
    std::memcpy(grow_to(l.bytes) + l.header, &h, sizeof h);
    filled_ += sizeof h;
    return l;
  }
  template <class Header>
  auto begin(const Header& h) {
    const auto l = format::layout(h);
    std::memcpy(grow_to(l.bytes), &h, sizeof h);
    filled_ += sizeof h;
    return l;
  }
  // Fills an array of a layout that begin() gave; it has as many elements as the header says.
  template <class T>
  void set(const format::Array<T>& array, const std::vector<T>& values) {
    if (values.size() != array.count) throw std::logic_error("an array of a section is not as long as its header says");
    if (!values.empty()) std::memcpy(bytes_.data() + array.at, values.data(), array.bytes());
    filled_ += array.bytes();
  }
  // All of it, once every array is filled.
  const std::vector<std::byte>& bytes() const {
    constexpr std::size_t kMostPadding = 3;
    if (bytes_.size() > filled_ + kMostPadding) throw std::logic_error("an array of a section was left out");
    return bytes_;
  }

  std::uint32_t codec = format::kCodecRaw;
  std::vector<std::byte> compact;  // the record that packed files have instead, if there is one

 private:
  std::byte* grow_to(std::uint64_t bytes) {
    bytes_.resize(static_cast<std::size_t>(bytes));
    return bytes_.data();
  }

  std::vector<std::byte> bytes_;
  std::size_t filled_ = 0;
};

}  // namespace marrow::cook
