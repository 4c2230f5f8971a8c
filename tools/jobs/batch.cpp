#include "jobs/batch.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "common/failure.h"
#include "common/formats.h"

namespace marrow::tools {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_read(const fs::path& folder, const std::error_code& error) {
  throw Failure(Exit::io, folder.string(), "", "cannot read the folder", error.message());
}

std::vector<fs::path> scenes_below(const fs::path& folder) {
  std::vector<fs::path> out;
  std::error_code error;
  fs::recursive_directory_iterator at(folder, error);
  if (error) cannot_read(folder, error);
  while (at != fs::recursive_directory_iterator()) {
    std::error_code ignored;
    if (is_named_source(at->path().string()) && at->is_regular_file(ignored)) out.push_back(at->path());
    at.increment(error);
    if (error) cannot_read(folder, error);
  }
  std::sort(out.begin(), out.end());
  return out;
}

// Canonical names of many files: each folder is looked up once.
class CanonicalNames {
 public:
  fs::path of(const std::string& name) {
    std::error_code ignored;
    const fs::path path = name;
    if (!path.has_filename() || fs::is_symlink(path, ignored)) return whole(path);
    const auto [folder, is_new] = folders_.try_emplace(path.parent_path());
    if (is_new) folder->second = whole(path.has_parent_path() ? path.parent_path() : ".");
    return folder->second / path.filename();
  }

 private:
  static fs::path whole(const fs::path& path) {
    std::error_code ignored;
    return fs::weakly_canonical(fs::absolute(path), ignored);
  }
  std::map<fs::path, fs::path> folders_;
};

}  // namespace

bool is_batch(const std::vector<std::string>& inputs, const std::string& output) {
  std::error_code ignored;
  const auto is_folder = [&](const std::string& path) { return !path.empty() && fs::is_directory(path, ignored); };
  return inputs.size() > 1 || output.ends_with('/') || (is_folder(output) && !has_extension(output, ".mrw")) ||
         std::ranges::any_of(inputs, is_folder);
}

CookJob plan_one(const std::string& input, const std::string& output) {
  const std::string root = fs::path(input).parent_path().string();
  return {input, output, root.empty() ? "." : root};
}

std::vector<CookJob> plan_batch(const std::vector<std::string>& inputs, const std::string& output, bool may_be_empty) {
  if (has_extension(output, ".mrw"))
    throw Failure(Exit::usage, output, "", "several inputs, one output", "name a folder; put / behind its name");
  std::vector<CookJob> jobs;
  for (const std::string& input : inputs) {
    std::error_code ignored;
    if (!fs::is_directory(input, ignored)) {
      const fs::path in(input);
      jobs.push_back({input, (output / in.filename().replace_extension(".mrw")).string(),
                      in.has_parent_path() ? in.parent_path().string() : "."});
      continue;
    }
    const std::vector<fs::path> found = scenes_below(input);
    if (found.empty() && !may_be_empty)
      throw Failure(Exit::invalid, input, "", "nothing to cook",
                    "there is no .gltf, .glb, .vrm or .bvh file in it or below it");
    for (const fs::path& in : found) {
      const fs::path name = in.lexically_relative(input);
      jobs.push_back({in.string(), (output / fs::path(name).replace_extension(".mrw")).string(), input});
    }
  }
  CanonicalNames names;
  std::map<fs::path, const CookJob*> job_of;
  std::vector<CookJob> out;
  for (const CookJob& job : jobs) {
    const auto [other, is_new] = job_of.try_emplace(names.of(job.out), &job);
    if (is_new) {
      out.push_back(job);
    } else if (names.of(other->second->in) != names.of(job.in)) {
      throw Failure(Exit::usage, job.out, "", "two inputs have this output",
                    other->second->in + " and " + job.in + "; rename one, or cook them into different folders");
    }
  }
  return out;
}

void expect_cooked_name(const std::string& output) {
  if (!has_extension(output, ".mrw"))
    throw Failure(Exit::usage, output, "", "unknown format",
                  "a cooked file's name ends with .mrw; that of a folder which is not there yet with /");
}

void expect_distinct(const std::vector<std::string>& written, const std::vector<std::string>& read) {
  CanonicalNames names;
  std::set<fs::path> inputs, seen;
  for (const std::string& path : read) inputs.insert(names.of(path));
  for (const std::string& path : written) {
    if (path.empty()) continue;
    if (inputs.contains(names.of(path)))
      throw Failure(Exit::usage, path, "", "is an input", "name another file to write");
    if (!seen.insert(names.of(path)).second)
      throw Failure(Exit::usage, path, "", "would be written twice", "give each output a file of its own");
  }
}

}  // namespace marrow::tools
