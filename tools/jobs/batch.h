// Which files a cook reads and writes: one, or a folder's worth.
#pragma once

#include <string>
#include <vector>

namespace marrow::tools {

struct CookJob {
  std::string in, out;
  std::string root;  // the folder that was named, or the file's own
};

// Whether inputs go into a folder: several, a folder among them, or an output that ends in "/" or is a folder.
bool is_batch(const std::vector<std::string>& inputs, const std::string& output);

// Folders are searched for .gltf, .glb, .vrm and .bvh, links to folders not followed; the tree below them is mirrored
// under `output`. Sorted within each folder by path; an input named twice counts once. Throws Failure: invalid for a
// folder with nothing to cook unless it `may_be_empty`, usage if two inputs have one output or `output` looks like a
// file, io if a folder cannot be read.
std::vector<CookJob> plan_batch(const std::vector<std::string>& inputs, const std::string& output,
                                bool may_be_empty = false);

// A single file into a file.
CookJob plan_one(const std::string& input, const std::string& output);

// Throws Failure (usage) for a name that does not end with .mrw.
void expect_cooked_name(const std::string& output);

// Throws Failure (usage) if two of the files to write are one, or one is read; empty names do not count.
void expect_distinct(const std::vector<std::string>& written, const std::vector<std::string>& read);

}  // namespace marrow::tools
