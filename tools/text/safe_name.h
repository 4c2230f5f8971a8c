// Names of an untrusted scene, on their way to a terminal or a file name.
#pragma once

#include <string>
#include <string_view>

namespace marrow::tools {

// A name fit to print and to become a file name: no control or direction-changing characters, no way out of a folder,
// no device, at most 1024 bytes. Anything else stays as it is.
std::string safe_name(std::string_view name);

}  // namespace marrow::tools
