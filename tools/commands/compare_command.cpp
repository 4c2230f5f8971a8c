// The line of `marrow compare`.
#include "commands/arguments.h"
#include "commands/command.h"
#include "commands/cook_options.h"
#include "compare/compare.h"

namespace marrow::tools {

void add_compare(CLI::App& app, int&) {
  static CompareArguments a;  // as long as the options that point at it
  CLI::App* const command = app.add_subcommand("compare", "Say which deformer a character should use");
  command->add_option("file", a.in, "a glTF file with a skin and clips")->type_name("IN.glb");
  command->add_option("--sample", a.sample, "instead of a file, a mesh that deformers are commonly shown on")
      ->check(CLI::IsMember({"cylinder"}));
  add_cook_options(
      command, {"truth", "examples", "delta-mush", "elastic", "helpers", "influences", "keep-bind-pose", "wide-poses"},
      a.given);
  add_one_of(command, "--holdout", kHoldouts, a.holdout,
             "what is not learnt from but judged by: alternate frames of every clip, or whole clips in turn");
  command
      ->add_option("--eigenskin", a.eigen_fields,
                   "displacements that the row `eigenskin` has for each joint, at most; it is measured and not cooked")
      ->type_name("N")
      ->check(CLI::Range(1, kMostEigenFields))
      ->capture_default_str();
  command
      ->add_option(
          "--frames", a.frames_hz,
          "also how far clips are off that are played from so many frames a second, with linear, quadratic and "
          "cubic interpolation between them")
      ->type_name("HZ,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_flag(
      "--json", a.json,
      "as JSON: {recommended, why, truth, holdout, trained_poses, held_poses, diagonal, rows: [{deformer, train_rms, "
      "train_max, held_rms, held_max, worse_share, volume, crease_deg, look: {flipped_triangles, bend_deg, "
      "creased_share, jump_of_ssd}, normal_deg, blended_normal_deg, bytes_per_vertex, "
      "ns_per_vertex, instructions_per_vertex, displacements_per_vertex, influences, palette_entries, mali_cycles, "
      "adreno_instructions, videocore_instructions}], "
      "truth_look, truth_folds: {poses, worst: [{clip, time_s, joint, flipped_triangles, ssd_flipped_triangles}]}, "
      "range_of_motion: {poses, folding_poses, deformers, joints, left_out}, between_frames: [{hz, interpolation, "
      "frames, rms, max}]}, lengths in metres; docs/deformers.md says "
      "what is in the last two");
  auto* const thesis = command->add_flag(
      "--thesis", a.thesis,
      "instead, the comparison of the thesis of animation space made anew: speed, labour and smoothness of every "
      "algorithm, frames a second, and what holds; on the file, without one on the sample, and on the cylinder");
  command->add_flag("--full", a.full, "--thesis: frames with normals, too")->needs(thesis);
  command->add_option("-o,--output", a.out, "also a page with pictures and charts, in one file")->type_name("OUT.html");
#ifdef MARROW_HAS_GLES
  command->add_option("--pictures", a.pictures, "also the page's pictures, each a PNG in this folder")
      ->type_name("FOLDER");
  command
      ->add_option(
          "--show", a.shown,
          "which rows pictures are of, beside ssd; they zoom in on the last one's joints; if it is not given, what is "
          "recommended is the last")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
#endif
  command->callback([] { run_compare(a); });
}

}  // namespace marrow::tools
