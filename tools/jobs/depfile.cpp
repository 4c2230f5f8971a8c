#include "jobs/depfile.h"

#include "common/failure.h"

namespace marrow::tools {
namespace {

std::string escaped(const std::string& path) {
  std::string out;
  std::size_t backslashes = 0;  // just before this character
  for (const char c : path) {
    if (c == '\n' || c == '\r')
      throw Failure(Exit::usage, "--depfile", "", "a line break in \"" + path + "\"", "rename the file");
    // Backslashes count themselves only before a blank.
    if (c == ' ' || c == '\t') out.append(backslashes, '\\');
    if (c == ' ' || c == '\t' || c == '#' || c == ':') out += '\\';
    if (c == '$') out += '$';
    out += c;
    backslashes = c == '\\' ? backslashes + 1 : 0;
  }
  return out;
}

}  // namespace

std::string depfile_rule(const std::string& output, const std::vector<std::string>& inputs) {
  std::string line = escaped(output) + ":";
  for (const std::string& input : inputs) line += ' ' + escaped(input);
  return line + '\n';
}

}  // namespace marrow::tools
