// What tells skeletons apart: the hashes that a clip pack carries (docs/format.md), FNV-1a.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "marrow/pose.h"

namespace marrow {

template <class Word, Word kPrime, Word kStart>
class Fnv1a {
 public:
  void add(const void* data, std::size_t bytes) {
    const auto* const p = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < bytes; ++i) state_ = (state_ ^ p[i]) * kPrime;
  }
  // Ten numbers: translation, rotation, scale.
  void add_rest(const SoaTransform* rest, std::size_t joint) {
    const auto* const first = reinterpret_cast<const std::byte*>(rest + joint / 4) + joint % 4 * sizeof(float);
    for (std::size_t i = 0; i < 10; ++i) add(first + i * 4 * sizeof(float), sizeof(float));
  }
  Word value() const { return state_; }

 private:
  Word state_ = kStart;
};
using Fnv32 = Fnv1a<std::uint32_t, 16777619u, 2166136261u>;
using Fnv64 = Fnv1a<std::uint64_t, 1099511628211u, 14695981039346656037u>;

inline std::uint32_t rest_hash(const SoaTransform* rest, std::size_t joint) {
  Fnv32 hash;
  hash.add_rest(rest, joint);
  return hash.value();
}

inline void add_joint(Fnv64& hash, const char* name, std::uint16_t parent, const SoaTransform* rest,
                      std::size_t joint) {
  hash.add(name, std::strlen(name) + 1);
  hash.add(&parent, sizeof parent);
  hash.add_rest(rest, joint);
}

}  // namespace marrow
