#include "commands/arguments.h"

#include <charconv>
#include <cmath>

namespace marrow::tools {

void add_input(CLI::App* command, std::string& to) {
  command->add_option("file", to, "the cooked file")->required()->type_name("FILE");
}

void add_outfits(CLI::App* command, std::vector<std::string>& to) {
  command->add_option("outfits", to, "hair, clothes, what it holds: files cooked with --skeleton FILE")
      ->type_name("OUTFIT.mrw");
}

void add_clip(CLI::App* command, Choice& choice, const std::string& without) {
  command
      ->add_option("--clip", choice.clip,
                   "clip by name or by index, and what other skeletons play by that name; C@SKELETON for that of one "
                   "skeleton alone; without it " +
                       without)
      ->type_name("C");
  command->add_option("--clips", choice.clips, "take clips from this clip pack")->type_name("PACK.mrw");
}

void add_choice(CLI::App* command, Choice& choice) {
  add_clip(command, choice, "the rest pose");
  command
      ->add_option("--time", choice.time_s, "seconds from the clip's start; outside the clip its first or last moment")
      ->type_name("S")
      ->check(finite("seconds"));
  command
      ->add_option("--set", choice.set,
                   "a parameter of example shapes, in place of the clip's; may be given several times")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

void add_deformer(CLI::App* command, Deformer& to, std::span<const Named<Deformer>> deformers) {
  add_one_of(command, "--deformer", deformers, to, "how vertices follow joints");
}

CLI::Validator finite(const std::string& unit) {
  const auto check = [unit](const std::string& text) {
    float value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const bool good = error == std::errc() && stop == end && std::isfinite(value);
    return good ? std::string() : "not a finite number of " + unit + ": " + text;
  };
  return {check, ""};
}

}  // namespace marrow::tools
