// Cooked files taken apart into sections and put together again.
#pragma once

#include <cstring>
#include <vector>

#include "asset/format.h"

namespace marrow::test {

struct Section {
  std::uint32_t type = 0, codec = 0;
  std::vector<std::byte> body;
};

// As far as the table leads anywhere.
inline std::vector<Section> sections_of(const std::byte* data, std::size_t size) {
  format::Header header;
  std::vector<Section> out;
  if (size < sizeof header) return out;
  std::memcpy(&header, data, sizeof header);
  for (std::size_t i = 0; i < header.section_count; ++i) {
    File::Section entry;
    const std::size_t at = sizeof header + i * sizeof entry;
    if (at + sizeof entry > size) break;
    std::memcpy(&entry, data + at, sizeof entry);
    if (entry.offset > size || entry.bytes > size - entry.offset) break;
    out.push_back({entry.type, entry.codec, {data + entry.offset, data + entry.offset + entry.bytes}});
  }
  return out;
}

// Without a checksum.
inline std::vector<std::byte> file_of(const std::vector<Section>& sections) {
  format::Header header{format::kMagic, format::kVersion, 0, static_cast<std::uint32_t>(sections.size()), 0, 0};
  std::vector<std::byte> out(sizeof header + sections.size() * sizeof(File::Section));
  for (std::size_t i = 0; i < sections.size(); ++i) {
    out.resize((out.size() + 15) / 16 * 16);
    const Section& s = sections[i];
    const File::Section entry{s.type, static_cast<std::uint32_t>(out.size()), static_cast<std::uint32_t>(s.body.size()),
                              s.codec};
    std::memcpy(out.data() + sizeof header + i * sizeof entry, &entry, sizeof entry);
    out.insert(out.end(), s.body.begin(), s.body.end());
  }
  header.file_bytes = static_cast<std::uint32_t>(out.size());
  std::memcpy(out.data(), &header, sizeof header);
  return out;
}

}  // namespace marrow::test
