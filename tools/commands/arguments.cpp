#include "commands/arguments.h"

#include <charconv>
#include <cmath>

#include "common/failure.h"

namespace marrow::tools {

void add_input(CLI::App* command, ModelArguments& to) {
  command->add_option("file", to.file, "the cooked file")->required()->type_name("FILE");
}

void add_outfits(CLI::App* command, ModelArguments& to) {
  command->add_option("outfits", to.outfits, "hair, clothes, what it holds: files cooked with --skeleton FILE")
      ->type_name("OUTFIT.mrw");
}

void add_clip(CLI::App* command, ModelArguments& to, const std::string& without) {
  command
      ->add_option("--clip", to.choice.clip,
                   "clip by name or by index, and what other skeletons play by that name; C@SKELETON for that of one "
                   "skeleton alone; without it " +
                       without)
      ->type_name("C");
  command->add_option("--clips", to.choice.clips, "take clips from this clip pack")->type_name("PACK.mrw");
}

void add_choice(CLI::App* command, ModelArguments& to) {
  add_clip(command, to, "the rest pose");
  command
      ->add_option("--time", to.choice.time_s,
                   "seconds from the clip's start; outside the clip its first or last moment")
      ->type_name("S")
      ->check(finite("seconds"));
  command
      ->add_option("--set", to.choice.set,
                   "a parameter of example shapes, in place of the clip's; may be given several times")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

void add_level(CLI::App* command, ModelArguments& to) {
  command->add_option("--lod", to.lod, "level of detail; 0: in full")->type_name("N")->capture_default_str();
}

CLI::Option* add_graph(CLI::App* command, ModelArguments& to) {
  command->remove_option(command->get_option("--clips"));
  command
      ->add_option("--clips", to.behaviour.clips,
                   "take clips from this clip pack; for --graph it may be given several times")
      ->type_name("PACK.mrw")
      ->allow_extra_args(false);
  return command
      ->add_option("--graph", to.behaviour.graph,
                   "the character goes by a graph of behaviour: one of the file by name, without it the only one; "
                   "a text, which is cooked now; or of a graph pack, NAME@PACK.mrw where it has several. A model "
                   "(.glb and others) is cooked as well, with --root '*=ground'")
      ->type_name("[NAME|FILE.toml|PACK.mrw]")
      ->expected(0, 1);
}

void take_graph(const CLI::App& command, std::initializer_list<const char*> others, ModelArguments& to) {
  std::vector<std::string>& packs = to.behaviour.clips;
  to.by_graph = command.count("--graph") > 0;
  if (!to.by_graph && packs.size() > 1)
    throw Failure(Exit::usage, "--clips", "", "several packs", "a clip comes from one; --graph takes several");
  to.choice.clips = to.by_graph || packs.empty() ? "" : packs[0];
  if (!to.by_graph) return;
  for (const char* const other : others)
    if (command.count(other) > 0)
      throw Failure(Exit::usage, other, "", "a character that goes by a graph", "leave it out, or --graph");
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
