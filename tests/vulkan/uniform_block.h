// The block of loose uniforms that SPIR-V for Vulkan has: where each is, and its bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace marrow::test {

// A member of the block "MarrowUniforms" by the module's own names and offsets (OpMemberName, OpMemberDecorate Offset).
struct UniformBlock {
  std::map<std::string, std::uint32_t> offsets;  // bytes
};
UniformBlock find_uniform_block(const std::vector<std::uint32_t>& spirv);

// std140: a value of one word is as it is, arrays have an element each 16 bytes. uniforms: words by name; what the
// block has not is left out. Scalars and arrays of scalars alone.
std::vector<std::byte> pack_uniforms(const UniformBlock& block,
                                     const std::map<std::string, std::vector<std::uint32_t>>& uniforms);

}  // namespace marrow::test
