// What the cooker asks of whoever calls it: files by name, threads, patience.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/failure.h"
#include "common/parallel.h"

namespace marrow::cook {

// Where the cooker reads. One call at a time.
class Files {
 public:
  virtual ~Files() = default;
  // The first `most` bytes of the file of this name, or all that it has. Throws tools::Failure: io, whose rule is
  // kNoSuchFile where there is none; unsupported, by too_large(), for more than kMostBytes.
  virtual std::vector<std::byte> read(const std::string& name, std::uint64_t most) = 0;
  // The name of a file that `document` refers to by a relative path, which has no "..". Throws tools::Failure: io, and
  // invalid if links would lead elsewhere than to the document's folder or below.
  virtual std::string beside(const std::string& document, const std::string& relative);
  // One name for all names of a file, as Read has it.
  virtual std::string full_name(const std::string& name) { return name; }
};
inline constexpr const char* kNoSuchFile = "no such file";
// Far above any scene for a phone, and below what 32-bit offsets can name.
inline constexpr std::uint64_t kMostBytes = 2'147'483'647;
tools::Failure too_large(const std::string& name);

// A file that was read, or its first bytes.
struct Read {
  std::string name;  // the first one's as given, others' as Files::full_name() and beside() have it
  std::uint64_t bytes = 0;
  std::string hash;  // of those bytes, 128 bits in hexadecimal
};

// Where a value was given, as failures say it, and whether it is a mistake if it fits nothing: a rule for many files
// need not fit each.
struct RuleOrigin {
  std::string file, where;  // "--additive", ""; "marrow.toml", "12:7"
  bool must_fit = true;
};

// Keeps what meshes have learnt, which can take minutes, by what they learnt it from. From any thread. What find()
// gives is checked: wrong bytes are as good as none.
class Fits {
 public:
  virtual ~Fits() = default;
  virtual std::optional<std::string> find(const std::string& key) = 0;
  virtual void keep(const std::string& key, const std::string& bytes) = 0;
};

// What a cook is at.
enum class Stage { read, prepare, clip, mesh, learn, write };
const char* name_of(Stage stage);

struct Host {
  Files& files;
  tools::Threads* threads = nullptr;  // null: all in the caller's thread
  // How far a stage has come, `done` of `count` parts; 0 of 0 as it begins. From any thread, at the same time too.
  std::function<void(Stage stage, std::size_t done, std::size_t count)> progress = {};
  const std::atomic<bool>* stop = nullptr;  // once it is true, cook() soon throws tools::Failure (interrupted)
  Fits* fits = nullptr;                     // null: nothing is kept
};

}  // namespace marrow::cook
