// A 128-bit hash of bytes (XXH3): for telling contents apart, not against malice.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace marrow::tools {

// 32 hexadecimal digits; the same on every machine.
std::string hash_of(std::span<const std::byte> bytes);

// Of several parts; where one ends and the next begins counts.
class Hasher {
 public:
  Hasher();
  ~Hasher();
  Hasher(const Hasher&) = delete;
  Hasher& operator=(const Hasher&) = delete;
  void add(std::string_view part);
  std::string hex() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace marrow::tools
