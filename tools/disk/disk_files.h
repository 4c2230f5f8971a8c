// Files of this machine, as the cooker reads them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "marrow/cook_host.h"

namespace marrow::tools {

// By their paths. Directories, devices, pipes and sockets are never opened: what names them may come from strangers.
class DiskFiles : public cook::Files {
 public:
  std::vector<std::byte> read(const std::string& path, std::uint64_t most) override;
  // In the document's own folder or below, links followed.
  std::string beside(const std::string& document, const std::string& relative) override;
  // The canonical path.
  std::string full_name(const std::string& path) override;
};

}  // namespace marrow::tools
