// Clips as packed files hold them; runtime/unpack/clip reads them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "unpack/clip/clip_codec.h"

namespace marrow::cook {

// Of a file's clips, one after the other: each is coded by what those before it were like.
class ClipPacker {
 public:
  ClipPacker() { models_.begin(); }
  // Of a whole section.
  std::vector<std::byte> pack(std::span<const std::byte> section, std::uint32_t codec, std::size_t joint_count);
  // Of memory, to unpack them.
  std::uint64_t scratch_bytes() const { return scratch_bytes_; }

 private:
  ClipModels models_;
  std::uint64_t scratch_bytes_ = 0;
};

}  // namespace marrow::cook
