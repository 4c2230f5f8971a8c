// The names of a file in the making: its section NAME.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace marrow::cook {

// Zero-terminated names, each once; the empty one first.
class Names {
 public:
  Names() { add(""); }
  std::uint32_t add(const std::string& name) {
    const std::string text = name.substr(0, name.find('\0'));
    const auto [at, is_new] = offsets_.try_emplace(text, static_cast<std::uint32_t>(pool_.size()));
    if (is_new) pool_.insert(pool_.end(), text.c_str(), text.c_str() + text.size() + 1);
    return at->second;
  }
  // As compact records have it: 0 if this adds the name, else its offset, plus one.
  std::uint32_t add_in_turn(const std::string& name, std::uint32_t& offset) {
    const std::size_t end = pool_.size();
    offset = add(name);
    return offset == end ? 0 : offset + 1;
  }
  const std::vector<char>& pool() const { return pool_; }

 private:
  std::map<std::string, std::uint32_t> offsets_;
  std::vector<char> pool_;
};

}  // namespace marrow::cook
