// Fuzz target: the text of a marrow.toml must end in settings or in a located failure.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "common/failure.h"
#include "disk/settings.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const marrow::cook::Settings settings = marrow::cook::parse_settings("fuzz/marrow.toml", text);
    std::vector<bool> used(settings.rules.size());
    (void)marrow::cook::settings_for(settings, "fuzz/hero.glb", used);
  } catch (const marrow::tools::Failure& failure) {
    if (failure.where().empty() || failure.rule().empty()) std::abort();
  }
  return 0;
}
