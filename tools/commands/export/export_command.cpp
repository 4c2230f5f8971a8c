// The sub-command: file in, file out, warnings on stderr.
#include <fmt/format.h>

#include "common/files.h"
#include "common/load_mrw.h"
#include "export/export.h"

namespace marrow::tools {

void run_export(const ExportArguments& a) {
  const LoadedFile loaded = load_mrw(a.in);
  const Exported exported = export_file(loaded.file, a.in);
  for (const std::string& warning : exported.warnings) fmt::print(stderr, "{}: warning: {}\n", a.in, warning);
  write_file_atomically(a.out, exported.glb);
}

}  // namespace marrow::tools
