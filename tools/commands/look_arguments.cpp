#include "commands/look_arguments.h"

#include "commands/arguments.h"

namespace marrow::tools {
namespace {

void add_skin_path(CLI::App* command, SkinPath& to, std::span<const NamedSkinPath> paths) {
  std::string about;
  for (const NamedSkinPath& path : paths)
    about.append(about.empty() ? "" : "; ").append(path.name).append(": ").append(path.about);
  add_one_of(command, "--path", paths, to, about);
}

}  // namespace

void add_look(CLI::App* command, LookArguments& a, std::span<const NamedSkinPath> paths,
              std::span<const Named<Deformer>> deformers) {
  add_input(command, a);
  add_choice(command, a);
  add_deformer(command, a.deformer, deformers);
  add_skin_path(command, a.path, paths);
  add_one_of(command, "--normals", kAsNormals, a.normals,
             "in animation space: through the blended matrix, as meshes with morph targets always have them, or those "
             "of the deformed surface, through its tangents: exact, with every fold and dent of it");
  command->add_option("--size", a.size, "pixels")->type_name("WxH")->capture_default_str();
  add_level(command, a);
  command->add_option("--heatmap", a.heatmap, "colour the distance between two deformers, as in ssd:as")
      ->type_name("A:B");
  command
      ->add_option("--images-from", a.images_from,
                   "where images by reference are looked for: a folder and below, or the source that they lie inside; "
                   "without it the cooked file's folder, and there a source of the same name")
      ->type_name("DIR|SOURCE.glb")
      ->check(CLI::ExistingPath);
}

void add_reach(CLI::App* command, ReachArguments& a) {
  CLI::Option* const goal =
      command->add_option("--ik", a.goals, "bring a joint to a point of the scene, metres; may be given several times")
          ->type_name("JOINT=X,Y,Z")
          ->expected(1)
          ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_one_of(
      command, "--ik-solver", kIkSolvers, a.solver,
      "two_bone: the two joints above, in closed form; genetic: by evolution, slowly, out of corners that limits "
      "make; others: by iteration; all but two_bone within the limits that the file has")
      ->needs(goal);
  command->add_option("--ik-seed", a.seed, "what chance begins with, of --ik-solver genetic")
      ->type_name("N")
      ->capture_default_str()
      ->needs(goal);
  command
      ->add_option("--ik-joints", a.joints,
                   "how many joints above turn, not counting those called twist or roll; two_bone: two")
      ->type_name("N")
      ->check(CLI::Range(1, 32767))
      ->capture_default_str()
      ->needs(goal);
}

}  // namespace marrow::tools
