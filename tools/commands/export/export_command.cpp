#include <algorithm>

#include <fmt/format.h>

#include "commands/arguments.h"
#include "commands/command.h"
#include "common/formats.h"
#include "common/load_mrw.h"
#include "disk/files.h"
#include "export/export.h"
#include "terminal/warnings.h"

namespace marrow::tools {
namespace {

// All clips of a pack that are to go with `file`.
ExportedClips pack_clips(const LoadedFile& pack, const std::string& pack_path, const std::string& path,
                         const File& file) {
  const std::vector<Play> plays = plays_of_pack(pack_path, pack.file, path, file);
  ExportedClips out{pack.file, {}};
  for (std::uint32_t i = 0; i < pack.file.clip_count(); ++i) out.clips.push_back({i, *skeleton_of(plays[i], i)});
  return out;
}

ExportedClips clips_of(const Play& play) {
  ExportedClips out{play.clips, {}};
  for (std::uint32_t s = 0; s < play.clip_of_skeleton.size; ++s)
    if (play.clip_of_skeleton[s] != kNoClip) out.clips.push_back({play.clip_of_skeleton[s], s});
  std::ranges::sort(out.clips, {}, &ExportedClips::One::clip);
  return out;
}

Exported exported_with(const std::string& in, const Choice& choice) {
  const LoadedFile loaded = load_mrw(in);
  const File& file = loaded.file;
  expect_joints(in, file);
  if (!choice.clip.empty()) {
    const Chosen chosen = choose(in, file, choice, true);
    return export_file(file, in, clips_of(chosen.play));
  }
  if (choice.clips.empty()) return export_file(file, in);
  const LoadedFile pack = load_mrw(choice.clips);
  return export_file(file, in, pack_clips(pack, choice.clips, in, file));
}

}  // namespace

void add_export(CLI::App& app, int&) {
  static std::string in, out;  // as long as the options that point at them
  static Choice choice;
  CLI::App* const command = app.add_subcommand("export", "Write a cooked file back as plain glTF 2.0");
  add_input(command, in);
  add_clip(command, choice, "all of them");
  command->add_option("-o,--output", out, "the file to write")->required()->type_name("OUT.glb");
  command->callback([] {
    expect_extension(out, {".glb"});
    expect_writable(out);
    const Exported exported = exported_with(in, choice);
    for (const std::string& line : warning_lines(in, exported.warnings)) fmt::print(stderr, "{}\n", line);
    write_file_atomically(out, exported.glb);
  });
}

}  // namespace marrow::tools
