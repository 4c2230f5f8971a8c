#include "commands/view/files/graph_on_disk.h"

#include <exception>
#include <utility>

#include "common/formats.h"

namespace marrow::tools {

GraphOnDisk::GraphOnDisk(std::string wanted, bool at_once) : wanted_(std::move(wanted)), at_once_(at_once) {
  if (has_extension(wanted_, ".toml")) reads_ = wanted_;
  if (has_extension(wanted_, ".mrw")) reads_ = wanted_.substr(wanted_.find('@') + 1);  // NAME@PACK.mrw or PACK.mrw
}

FoundGraph GraphOnDisk::read(const std::string& path, const File& file) {
  const std::timespec began = Watch::now();
  if (!reads_.empty()) watch_.set({reads_}, began);
  return find_graph(path, file, wanted_);
}

std::optional<FoundGraph> GraphOnDisk::poll(const std::string& path, const File& file) {
  if (reads_.empty() || (!at_once_ && !watch_.is_due()) || !watch_.changed()) return std::nullopt;
  try {
    FoundGraph out = read(path, file);
    error_.clear();
    return out;
  } catch (const std::exception& why) {
    error_ = why.what();
    return std::nullopt;
  }
}

}  // namespace marrow::tools
