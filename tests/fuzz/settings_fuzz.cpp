// Fuzz target: the text of a marrow.toml must end in settings or in a located failure; what is written of them is read
// again as it was.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "common/failure.h"
#include "disk/settings.h"
#include "marrow/cook.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const marrow::cook::Settings settings = marrow::cook::parse_settings("fuzz/marrow.toml", text);
    std::vector<bool> used(settings.rules.size());
    const marrow::cook::Options options = marrow::cook::settings_for(settings, "fuzz/hero.glb", used);
    const std::string written = marrow::cook::write_options(options);
    if (marrow::cook::write_options(marrow::cook::read_options("written", written)) != written) std::abort();
  } catch (const marrow::tools::Failure& failure) {
    if (failure.where().empty() || failure.rule().empty()) std::abort();
  }
  return 0;
}
