#include "sample/sample.h"

#include <memory>

#include <CLI/CLI.hpp>

#include "common/files.h"

namespace marrow::embedded {
extern const unsigned char newt_glb[];
extern const unsigned long long newt_glb_size;
}  // namespace marrow::embedded

namespace marrow::tools {

std::span<const std::byte> sample_glb() {
  return std::as_bytes(std::span(embedded::newt_glb, embedded::newt_glb_size));
}

void add_sample(CLI::App& app) {
  const auto out = std::make_shared<std::string>();
  CLI::App* const command = app.add_subcommand("sample", "Write the embedded sample character as a .glb file");
  command->add_option("-o,--output", *out, "the file to write")->required()->type_name("OUT.glb");
  command->callback([out] { write_file_atomically(*out, sample_glb()); });
}

}  // namespace marrow::tools
