// A file to the tree of its JSON, for files that nobody vouches for.
#include "cook/gltf/document/json.h"

#include <cstdint>
#include <cstring>

#include "common/formats.h"

namespace marrow::cook::gltf {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942;   // "BIN\0"
constexpr std::size_t kGlbHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;

std::uint32_t read_u32(std::span<const std::byte> file, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | std::to_integer<std::uint32_t>(file[offset + i]);
  return value;
}

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// The length that the header claims, which is at least one chunk header and no more than the file has.
std::size_t checked_length(std::span<const std::byte> file, Report& report) {
  if (file.size() < kGlbHeaderSize) report.invalid(at_offset(file.size()), "GLB header cut short", "export again");
  const std::uint32_t version = read_u32(file, 4);
  if (version == 1) report.unsupported("@4", "GLB version 1", "export as glTF 2.0");
  if (version != 2) report.invalid("@4", "unknown GLB version " + std::to_string(version), "export as glTF 2.0");
  const std::size_t length = read_u32(file, 8);
  if (length < kGlbHeaderSize + kChunkHeaderSize) {
    report.invalid("@8", "GLB length too small", "the header leaves no room for a JSON chunk; export again");
  }
  if (length > file.size()) {
    report.invalid(at_offset(file.size()), "GLB cut short",
                   "the header claims " + std::to_string(length) + " bytes; copy or export the file again");
  }
  if (length < file.size()) {
    report.warn(at_offset(length), "glb-trailing-bytes",
                "the file goes on for " + std::to_string(file.size() - length) + " bytes after its end; dropped");
  }
  return length;
}

struct Chunk {
  std::size_t offset;
  std::uint32_t type;
  std::span<const std::byte> bytes;
};

Chunk read_chunk(std::span<const std::byte> file, std::size_t offset, Report& report) {
  if (file.size() - offset < kChunkHeaderSize) {
    report.invalid(at_offset(file.size()), "chunk header cut short", "a chunk starts with 8 bytes; export again");
  }
  const std::size_t length = read_u32(file, offset);
  if (length % 4 != 0) report.invalid(at_offset(offset), "chunk length is not a multiple of 4", "pad and export again");
  if (length > file.size() - offset - kChunkHeaderSize) {
    report.invalid(at_offset(offset), "chunk too long",
                   "it claims " + std::to_string(length) + " bytes, more than the file has; export again");
  }
  return {offset, read_u32(file, offset + 4), file.subspan(offset + kChunkHeaderSize, length)};
}

void take_chunk(const Chunk& chunk, int number, Container& container, Report& report) {
  const std::string where = at_offset(chunk.offset);
  if (number == 0) {
    if (chunk.type != kJsonChunk) report.invalid(where, "first chunk is not JSON", "export again");
    if (chunk.bytes.empty()) report.invalid(where, "JSON chunk is empty", "export again");
    container.json = text_of(chunk.bytes);
    container.json_offset = chunk.offset + kChunkHeaderSize;
    return;
  }
  if (chunk.type == kJsonChunk) report.invalid(where, "second JSON chunk", "a file has one; export again");
  if (chunk.type == kBinChunk) {
    if (container.has_bin) report.invalid(where, "second BIN chunk", "a file has one; export again");
    if (number != 1) report.invalid(where, "misplaced BIN chunk", "it must be the second chunk; export again");
    container.has_bin = true;
    container.bin = chunk.bytes;
    return;
  }
  report.warn(where, "unknown-chunk", "a chunk of unknown type is ignored");
}

Container split_glb(std::span<const std::byte> file, Report& report) {
  file = file.first(checked_length(file, report));
  Container container;
  container.binary = true;
  std::size_t offset = kGlbHeaderSize;
  for (int number = 0; offset < file.size(); ++number) {
    const Chunk chunk = read_chunk(file, offset, report);
    take_chunk(chunk, number, container, report);
    offset += kChunkHeaderSize + chunk.bytes.size();
  }
  return container;
}

}  // namespace

Container split_container(std::span<const std::byte> file, Report& report) {
  if (file.empty()) report.invalid("@0", "empty file", "export again");
  if (file.size() >= 4 && read_u32(file, 0) == kMagic) return split_glb(file, report);
  Container container;
  container.json = text_of(file);
  const std::size_t start =
      container.json.find_first_not_of(" \t\r\n", container.json.starts_with(kByteOrderMark) ? 3 : 0);
  if (start == std::string_view::npos || container.json[start] != '{') {
    if (const tools::LooksLike* const other = tools::looks_like(file))
      report.invalid("@0", "not a glTF file but, as it begins, " + std::string(other->name),
                     std::string(other->advice));
    report.invalid("@0", "not a glTF file", "a .gltf starts with '{' and a .glb with 'glTF'");
  }
  return container;
}

namespace {

constexpr std::size_t kDeepest = 128;

// Walks the text and counts how far the parser has come, so that a finding of the builder has an offset.
struct CountingIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at;
  const char** furthest;

  const char& operator*() const { return *at; }
  CountingIterator& operator++() {
    *furthest = ++at;
    return *this;
  }
  bool operator==(const CountingIterator& other) const { return at == other.at; }
  bool operator!=(const CountingIterator& other) const { return at != other.at; }
};

// Builds the tree from the parser's events; a plain parse would let later duplicates win and has no depth limit.
class TreeBuilder {
 public:
  TreeBuilder(Json& root, const char* text, std::size_t text_offset, const char* const* furthest, Report& report)
      : root_(root), text_(text), text_offset_(text_offset), furthest_(furthest), report_(report) {}

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(Json::number_integer_t value) { return add(value); }
  bool number_unsigned(Json::number_unsigned_t value) { return add(value); }
  bool number_float(Json::number_float_t value, const Json::string_t&) { return add(value); }
  bool string(Json::string_t& value) { return add(std::move(value)); }
  bool binary(Json::binary_t&) { return false; }

  bool start_object(std::size_t) { return open(Json::object()); }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(Json::array()); }
  bool end_array() { return close(); }

  bool key(Json::string_t& name) {
    const auto [member, is_new] = open_.back()->get_ref<Json::object_t&>().try_emplace(name);
    if (!is_new) {
      report_.invalid(here(), "duplicate name in an object", "keep one of the members named \"" + name + '"');
    }
    member_ = &member->second;
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) {
    // "[json.exception.parse_error.101] parse error at line 1, column 2: what is wrong"
    std::string reason = error.what();
    reason.erase(0, reason.find("] ") + 2);
    if (reason.starts_with("parse error")) reason.erase(0, reason.find(": ") + 2);
    report_.invalid(at_offset(text_offset_ + (position == 0 ? 0 : position - 1)), "not JSON", reason);
  }

 private:
  std::string here() const {
    const auto read = static_cast<std::size_t>(*furthest_ - text_);
    return at_offset(text_offset_ + (read == 0 ? 0 : read - 1));
  }

  template <class Value>
  bool add(Value&& value) {
    place(Json(std::forward<Value>(value)));
    return true;
  }

  Json& place(Json value) {
    if (open_.empty()) return root_ = std::move(value);
    if (open_.back()->is_array()) return open_.back()->get_ref<Json::array_t&>().emplace_back(std::move(value));
    return *member_ = std::move(value);
  }

  bool open(Json value) {
    if (open_.size() >= kDeepest) {
      report_.invalid(here(), "JSON nested too deeply", "at most " + std::to_string(kDeepest) + " levels are read");
    }
    open_.push_back(&place(std::move(value)));
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  Json& root_;
  const char* text_;
  std::size_t text_offset_;
  const char* const* furthest_;
  Report& report_;
  std::vector<Json*> open_;  // stable: a container takes no new elements while one of its children is open
  Json* member_ = nullptr;
};

// Some exporters pad the JSON chunk with zeros where the specification asks for spaces.
std::string_view without_padding(const Container& container, Report& report) {
  std::string_view text = container.json;
  const std::size_t end = text.find_last_not_of('\0') + 1;
  if (container.binary && end < text.size()) {
    report.warn(at_offset(container.json_offset + end), "json-chunk-padding", "padded with zeros, not spaces; ignored");
    text = text.substr(0, end);
  }
  return text;
}

}  // namespace

Json parse_json(const Container& container, Report& report) {
  std::string_view text = without_padding(container, report);
  std::size_t offset = container.json_offset;
  if (text.starts_with(kByteOrderMark)) {
    report.mend(at_offset(offset), "byte-order-mark", "glTF's JSON is UTF-8 without one; skipped");
    text.remove_prefix(kByteOrderMark.size());
    offset += kByteOrderMark.size();
  }
  // The parser takes a zero for the end of its input and would ignore what follows.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    report.invalid(at_offset(offset + zero), "not JSON", "a zero byte; export again");
  }
  Json root;
  const char* furthest = text.data();
  TreeBuilder builder(root, text.data(), offset, &furthest, report);
  const CountingIterator begin{text.data(), &furthest};
  const CountingIterator end{text.data() + text.size(), &furthest};
  Json::sax_parse(begin, end, &builder);
  if (!root.is_object()) {
    report.invalid(at_offset(offset), "not a glTF object", "the JSON root must be an object");
  }
  return root;
}

std::uint64_t count_or(const Json& object, const char* name, std::uint64_t fallback) {
  const auto member = object.find(name);
  return member == object.end() ? fallback : member->get<std::uint64_t>();
}

}  // namespace marrow::cook::gltf
