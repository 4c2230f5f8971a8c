#include "vulkan/uniform_block.h"

#include <algorithm>
#include <cstring>

namespace marrow::test {
namespace {

// Numbers of the SPIR-V specification.
constexpr std::uint32_t kOpName = 5, kOpMemberName = 6, kOpMemberDecorate = 72, kOffset = 35;
constexpr std::size_t kHeaderWords = 5;

// A literal string of the module: zero-terminated, from a word on.
std::string string_at(const std::vector<std::uint32_t>& spirv, std::size_t word, std::size_t end) {
  std::string out(4 * (end - word), '\0');
  std::memcpy(out.data(), spirv.data() + word, out.size());
  return out.substr(0, out.find('\0'));
}

// Calls visit(opcode, first word, word behind) for every instruction.
template <class Visit>
void for_each_instruction(const std::vector<std::uint32_t>& spirv, const Visit& visit) {
  for (std::size_t at = kHeaderWords; at < spirv.size();) {
    const std::size_t end = at + std::max<std::size_t>(spirv[at] >> 16, 1);
    if (end > spirv.size()) return;
    visit(spirv[at] & 0xFFFF, at, end);
    at = end;
  }
}

}  // namespace

UniformBlock find_uniform_block(const std::vector<std::uint32_t>& spirv) {
  std::uint32_t block = 0;
  for_each_instruction(spirv, [&](std::uint32_t op, std::size_t at, std::size_t end) {
    if (op == kOpName && end > at + 2 && string_at(spirv, at + 2, end) == "MarrowUniforms") block = spirv[at + 1];
  });
  std::map<std::uint32_t, std::string> names;
  UniformBlock out;
  for_each_instruction(spirv, [&](std::uint32_t op, std::size_t at, std::size_t end) {
    if (end < at + 4 || spirv[at + 1] != block) return;
    if (op == kOpMemberName) names[spirv[at + 2]] = string_at(spirv, at + 3, end);
    if (op == kOpMemberDecorate && end == at + 5 && spirv[at + 3] == kOffset)
      out.offsets[names[spirv[at + 2]]] = spirv[at + 4];
  });
  return out;
}

std::vector<std::byte> pack_uniforms(const UniformBlock& block,
                                     const std::map<std::string, std::vector<std::uint32_t>>& uniforms) {
  std::vector<std::byte> out(16);
  for (const auto& [name, words] : uniforms) {
    const auto found = block.offsets.find(name);
    if (found == block.offsets.end()) continue;
    out.resize(std::max(out.size(), found->second + 16 * words.size()));
    for (std::size_t i = 0; i < words.size(); ++i) std::memcpy(&out[found->second + 16 * i], &words[i], 4);
  }
  return out;
}

}  // namespace marrow::test
