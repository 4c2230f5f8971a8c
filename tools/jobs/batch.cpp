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

fs::path canonical(const std::string& path) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(path), ignored);
}

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
  std::map<fs::path, const CookJob*> job_of;
  std::vector<CookJob> out;
  for (const CookJob& job : jobs) {
    const auto [other, is_new] = job_of.try_emplace(canonical(job.out), &job);
    if (is_new) {
      out.push_back(job);
    } else if (canonical(other->second->in) != canonical(job.in)) {
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
  std::set<fs::path> inputs, seen;
  for (const std::string& path : read) inputs.insert(canonical(path));
  for (const std::string& path : written) {
    if (path.empty()) continue;
    if (inputs.contains(canonical(path)))
      throw Failure(Exit::usage, path, "", "is an input", "name another file to write");
    if (!seen.insert(canonical(path)).second)
      throw Failure(Exit::usage, path, "", "would be written twice", "give each output a file of its own");
  }
}

}  // namespace marrow::tools
