// Cooks from memory to memory, and says how far it has come: cook_in_memory IN.glb OUT.mrw
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "marrow/cook.h"

struct Memory : marrow::cook::Files {
  std::map<std::string, std::string> files;
  std::vector<std::byte> read(const std::string& name, std::uint64_t most) override {
    using marrow::tools::Failure, marrow::tools::Exit;
    const auto found = files.find(name);
    if (found == files.end()) throw Failure(Exit::io, name, "", marrow::cook::kNoSuchFile, "add it to the map");
    const auto bytes =
        std::as_bytes(std::span(found->second)).first(std::min<std::uint64_t>(most, found->second.size()));
    return {bytes.begin(), bytes.end()};
  }
};

int main(int, char** argv) try {
  Memory memory;
  std::ifstream in(argv[1], std::ios::binary);
  memory.files["hero.glb"] = {std::istreambuf_iterator<char>(in), {}};
  const auto options = marrow::cook::read_options("hero.toml", "mesh-codec = 'meshopt'\nlod = '0.5'\n");
  const auto told = [](marrow::cook::Stage stage, std::size_t done, std::size_t count) {
    std::printf("%s %zu/%zu\n", name_of(stage), done, count);
  };
  const marrow::cook::Result result = cook("hero.glb", options, {memory, nullptr, told});
  std::ofstream(argv[2], std::ios::binary)
      .write(reinterpret_cast<const char*>(result.file.data()), std::ssize(result.file));
  std::printf("%zu bytes, %zu warnings\n", result.file.size(), result.report["warnings"].size());
} catch (const marrow::tools::Failure& failure) {
  std::fprintf(stderr, "%s\n", failure.what());
  return static_cast<int>(failure.code());
}
