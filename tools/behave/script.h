// What is set while a graph plays, and when: a text of lines `TIME PARAMETER [VALUE]`.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "marrow/file.h"
#include "marrow/graph.h"

namespace marrow::tools {

struct ScriptLine {
  double time_s = 0;
  std::uint32_t parameter = 0;
  float value = 0;  // of a flag 0 or 1; of a trigger 1
};

// A number has a value in its range, a flag `true` or `false`, a trigger none. Names with spaces stand in quotes; `#`
// begins a comment. Lines come out by time, those of one time in their order. names: the graph's file. Throws Failure
// (usage) at "LINE:COLUMN" of what is wrong. The text is hostile: at most 1 MiB and 100 000 lines.
std::vector<ScriptLine> parse_script(const std::string& path, std::string_view text, const File& names,
                                     const Graph& graph);
// The same of a file.
std::vector<ScriptLine> read_script(const std::string& path, const File& names, const Graph& graph);

}  // namespace marrow::tools
