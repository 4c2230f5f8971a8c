#include "common/load_mrw.h"

#include "common/failure.h"
#include "common/formats.h"
#include "common/section_names.h"
#include "common/unpack_mrw.h"
#include "marrow/example_space.h"
#include "marrow/unpack.h"

namespace marrow::tools {
namespace {

constexpr const char* kTypes[][7] = {{"geometry", "GEOM", "MESH", "SHAP"},
                                     {"skeletons", "SKEL", "SREF", "LIMI", "SPRI", "ROLE", "PMAP"},
                                     {"clips", "CLIP", "BNDS"},
                                     {"graphs", "GRPH"},
                                     {"images", "IMAG"}};

}  // namespace

LoadedFile load_mrw(const std::string& path, AlignedBytes file_bytes) {
  LoadedFile loaded;
  loaded.bytes = std::move(file_bytes);
  if (loaded.bytes.size() == 0) throw Failure(Exit::invalid, path, "@0", "empty file", "cook the source again");
  const std::span<const std::byte> bytes(loaded.bytes.data(), loaded.bytes.size());
  expect_cooked(path, bytes);
  loaded.stored_bytes = bytes.size();
  const bool packed = is_packed({bytes.data(), bytes.size()});
  if (packed) {
    AlignedBytes file = unpacked(bytes, path);
    loaded.stored = records_of(bytes);
    loaded.bytes = std::move(file);
  }
  DataError error;
  Status status = load({loaded.bytes.data(), loaded.bytes.size()}, loaded.file, &error);
  ExampleSpace space;
  for (std::uint32_t i = 0; status == Status::ok && i < loaded.file.example_space_count(); ++i)
    status = loaded.file.example_space(i, space, &error);
  const bool foreign = status == Status::unsupported || status == Status::bad_version;
  if (status != Status::ok)
    throw Failure(foreign ? Exit::unsupported : Exit::invalid, path, "@" + std::to_string(error.offset),
                  to_string(status), error.rule);
  if (!packed) loaded.stored.assign(loaded.file.sections().begin(), loaded.file.sections().end());
  return loaded;
}

std::vector<Spent> spent_bytes(const LoadedFile& loaded) {
  std::vector<Spent> out;
  std::size_t rest = loaded.stored_bytes;
  for (const auto& [on, a, b, c, d, e, f] : kTypes) {
    Spent& spent = out.emplace_back(Spent{on});
    for (const File::Section& section : loaded.stored) {
      const std::string type = section_name(section.type);
      const auto is = [&](const char* name) { return name != nullptr && type == name; };
      if (is(a) || is(b) || is(c) || is(d) || is(e) || is(f)) spent.bytes += section.bytes;
    }
    rest -= spent.bytes;
  }
  out.push_back({"names_and_structure", rest});
  return out;
}

}  // namespace marrow::tools
