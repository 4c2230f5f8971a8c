// Whole files in and out, with Failures that name the file.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "common/aligned_bytes.h"

namespace marrow::tools {

// Reads a regular file of at most 4 GiB. Throws Failure (io).
AlignedBytes read_file(const std::string& path);

// Writes a temporary file beside `path`, flushes it to the disk and renames it: whatever happens, `path` is the old
// file or the new one, never a part. Throws Failure (io), leaving nothing behind.
void write_file_atomically(const std::string& path, std::span<const std::byte> bytes);
void write_file_atomically(const std::string& path, std::string_view text);

}  // namespace marrow::tools
