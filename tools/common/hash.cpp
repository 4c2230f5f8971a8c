#include "common/hash.h"

#include <cstdint>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace marrow::tools {
namespace {

std::string hex_of(const XXH128_hash_t& hash) {
  XXH128_canonical_t bytes;
  XXH128_canonicalFromHash(&bytes, hash);
  std::string text;
  for (const unsigned char byte : bytes.digest) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

}  // namespace

std::string hash_of(std::span<const std::byte> bytes) {
  return hex_of(XXH3_128bits(bytes.data(), bytes.size()));
}

struct Hasher::State {
  XXH3_state_t xxh;
};

Hasher::Hasher() : state_(std::make_unique<State>()) {
  XXH3_128bits_reset(&state_->xxh);
}

Hasher::~Hasher() = default;

void Hasher::add(std::string_view part) {
  const std::string length = std::to_string(part.size()) + ':';
  XXH3_128bits_update(&state_->xxh, length.data(), length.size());
  XXH3_128bits_update(&state_->xxh, part.data(), part.size());
}

std::string Hasher::hex() const {
  return hex_of(XXH3_128bits_digest(&state_->xxh));
}

}  // namespace marrow::tools
