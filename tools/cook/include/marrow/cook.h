// The cooker as a function: an artist's file in, a cooked file and a report out. It opens nothing itself, starts no
// thread and prints nothing: files, threads and patience are the caller's. See docs/cooking/library.md.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "marrow/cook_host.h"

namespace marrow::cook {

struct ShapeRule;

// One value of an option, as text: what the command line takes. A flag's is "true" or "false".
struct Value {
  std::string text;
  RuleOrigin origin;
  std::shared_ptr<const ShapeRule> shape = nullptr;  // of [[shapes]], whose text tells shapes apart
};

// What is asked of the cooker: values by the option's name, which `marrow cook --help` lists without the two dashes.
using Options = std::map<std::string, std::vector<Value>>;

// Adds a value to an option that may have several, or replaces it. Throws tools::Failure (usage), at "--NAME", for
// options that there are not. Values are looked at by cook().
void set(Options& options, std::string_view name, std::string_view value);
// Options as marrow.toml has them, for all files. Throws tools::Failure (usage), at "LINE:COLUMN" of `file`.
Options read_options(const std::string& file, std::string_view toml);
// The same as text that read_options() reads.
std::string write_options(const Options& options);

struct Result {
  std::vector<std::byte> file;    // what load() or unpack() takes
  nlohmann::ordered_json report;  // docs/reference/report.md
  std::vector<Read> reads;        // all that the result depends on beside the options; the named file first
};

// Cooks `name`: glTF, or BVH by its name. The same bytes for the same input, however many threads there are. May be
// called from several threads at once. Throws tools::Failure: io, invalid and unsupported, located in the file; usage,
// at the option; interrupted.
Result cook(const std::string& name, const Options& options, const Host& host);

struct Looked {
  std::vector<Read> reads;        // as Result has them, but for what the skeletons of options refer to
  std::vector<std::size_t> fits;  // of each skinned mesh that the options let learn its vertices
};
// What cooking of `name` would read and learn. Reads the scene, and does no more. Throws as cook().
Looked look(const std::string& name, const Options& options, const Host& host);
// Learns for one of Looked::fits into `host.fits`, so that cook() of the same finds it there. Throws as cook().
void learn_fit(const std::string& name, std::size_t which, const Options& options, const Host& host);

// A graph pack: the options' graphs alone, for characters of other files. Throws as cook(), and usage without a graph.
Result cook_graphs(const Options& options, const Host& host);

}  // namespace marrow::cook
