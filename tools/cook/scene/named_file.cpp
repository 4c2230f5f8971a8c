#include "cook/scene/named_file.h"

#include <filesystem>
#include <system_error>

#include "common/files.h"
#include "common/hash.h"

namespace marrow::cook {

tools::AlignedBytes read_named_file(const std::string& path, const LargestFile& largest, std::vector<RawRead>& reads) {
  std::error_code error;
  if (std::filesystem::file_size(path, error) > largest.bytes && !error)
    throw tools::Failure(largest.exit, path, "", largest.rule, largest.advice);
  tools::AlignedBytes bytes = tools::read_file(path);
  reads.push_back({std::filesystem::weakly_canonical(std::filesystem::absolute(path), error).string(), bytes.size(),
                   tools::hash_of({bytes.data(), bytes.size()})});
  return bytes;
}

}  // namespace marrow::cook
