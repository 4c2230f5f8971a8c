// `marrow retarget`: which joints are taken for one another, as a map to edit.
#include <fmt/format.h>

#include "commands/command.h"
#include "cook/retarget/add_clips.h"
#include "disk/files.h"
#include "jobs/batch.h"

namespace marrow::tools {

void add_retarget(CLI::App& app, int&) {
  static std::string character, source, map;  // as long as the options that point at them
  static bool asks_for_map = false;
  CLI::App* const command =
      app.add_subcommand("retarget", "Say which joints `cook --retarget` takes for one another, as a map to edit");
  command->add_option("character", character, "whose joints move: glTF, VRM or a cooked file")
      ->required()
      ->type_name("CHARACTER");
  command->add_option("source", source, "whose clips they are: glTF, .bvh or a cooked file")
      ->required()
      ->type_name("SOURCE");
  command->add_flag("--map", asks_for_map, "print the map, TOML")->required();
  command->add_option("-o,--output", map, "write it to a file instead of stdout")->type_name("MAP.toml");
  command->callback([] {
    if (!map.empty()) {
      expect_distinct({map}, {character, source});
      expect_writable(map);
    }
    const std::string text = cook::map_of(cook::read_character(character), cook::read_rig(source));
    if (map.empty()) {
      fmt::print("{}", text);
    } else {
      write_file_atomically(map, text);
    }
  });
}

}  // namespace marrow::tools
