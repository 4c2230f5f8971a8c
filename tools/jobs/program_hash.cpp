#include "jobs/program_hash.h"

#include <elf.h>
#include <link.h>

#include <filesystem>
#include <set>
#include <vector>

#include "common/failure.h"
#include "common/hash.h"
#include "disk/files.h"

namespace marrow::tools {
namespace {

struct Loaded {
  std::vector<std::string> paths;
  std::set<std::string> needed;  // by the program itself
};

// Names of libraries are offsets into a table of the program's own dynamic section.
void add_needed(const dl_phdr_info& program, std::set<std::string>& out) {
  for (int i = 0; i < program.dlpi_phnum; ++i) {
    if (program.dlpi_phdr[i].p_type != PT_DYNAMIC) continue;
    const auto* const entries = reinterpret_cast<const ElfW(Dyn)*>(program.dlpi_addr + program.dlpi_phdr[i].p_vaddr);
    const char* names = nullptr;
    for (const ElfW(Dyn)* e = entries; e->d_tag != DT_NULL; ++e)
      if (e->d_tag == DT_STRTAB) names = reinterpret_cast<const char*>(e->d_un.d_ptr);
    for (const ElfW(Dyn)* e = entries; names != nullptr && e->d_tag != DT_NULL; ++e)
      if (e->d_tag == DT_NEEDED) out.insert(names + e->d_un.d_val);
  }
}

int add_loaded(dl_phdr_info* info, std::size_t, void* user) {
  Loaded& loaded = *static_cast<Loaded*>(user);
  if (info->dlpi_name == nullptr || info->dlpi_name[0] == '\0') {
    if (loaded.needed.empty()) add_needed(*info, loaded.needed);
  } else if (info->dlpi_name[0] == '/') {
    loaded.paths.push_back(info->dlpi_name);
  }
  return 0;
}

std::string hash_of_file(const std::string& path) {
  try {
    const AlignedBytes bytes = read_file(path);
    return hash_of({bytes.data(), bytes.size()});
  } catch (const Failure&) {
    return path;
  }
}

}  // namespace

const std::string& program_hash() {
  static const std::string hash = [] {
    Loaded loaded;
    dl_iterate_phdr(add_loaded, &loaded);
    Hasher hasher;
    hasher.add(hash_of_file("/proc/self/exe"));
    for (const std::string& path : loaded.paths) {
      const std::string name = std::filesystem::path(path).filename().string();
      if (loaded.needed.contains(name)) hasher.add(hash_of_file(path));
    }
    return hasher.hex();
  }();
  return hash;
}

}  // namespace marrow::tools
