// Makes names of an untrusted scene fit to print and to become file names.
#include "cook/gltf/import/import.h"
#include "text/safe_name.h"

namespace marrow::cook::gltf {

std::string clean_name(const std::string& name, const std::string& where, Report& report) {
  std::string clean = tools::safe_name(name);
  if (clean != name)
    report.warn(under(where, "name"), "name-cleaned", "unfit to print or to name a file; now \"" + clean + '"');
  return clean;
}

}  // namespace marrow::cook::gltf
