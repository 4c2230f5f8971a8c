// JSON text to a document tree, for text that nobody vouches for.
#include "cook/gltf/document/json.h"

namespace marrow::cook::gltf {
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

}  // namespace marrow::cook::gltf
