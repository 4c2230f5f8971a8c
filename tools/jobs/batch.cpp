#include "jobs/batch.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>

#include "common/failure.h"
#include "common/formats.h"

namespace marrow::tools {
namespace {

namespace fs = std::filesystem;

bool is_searched_for(const fs::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension == ".gltf" || extension == ".glb" || extension == ".bvh";
}

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
    if (is_searched_for(at->path()) && at->is_regular_file(ignored)) out.push_back(at->path());
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
  return inputs.size() > 1 || output.ends_with('/') || std::ranges::any_of(inputs, [&](const std::string& input) {
           return fs::is_directory(input, ignored) && !input.empty();
         });
}

CookJob plan_one(const std::string& input, const std::string& output) {
  const std::string root = fs::path(input).parent_path().string();
  return {input, output, root.empty() ? "." : root};
}

std::vector<CookJob> plan_batch(const std::vector<std::string>& inputs, const std::string& output, bool may_be_empty) {
  if (fs::path(output).extension() == ".mrw")
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
                    "there is no .gltf, .glb or .bvh file in it or below it");
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
  if (is_named_source(output))
    throw Failure(Exit::usage, output, "", "unknown format", "a cooked file is no source; its name ends with .mrw");
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
