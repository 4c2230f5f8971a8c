// `marrow export`: a cooked file back as plain glTF.
#include <algorithm>

#include <fmt/format.h>

#include "commands/arguments.h"
#include "commands/command.h"
#include "common/formats.h"
#include "disk/files.h"
#include "export/export.h"
#include "open/open_model.h"
#include "terminal/warnings.h"

namespace marrow::tools {
namespace {

// All clips of a pack that are to go with `file`.
ExportedClips pack_clips(const OpenedModel& pack, const std::string& path, const File& file) {
  const std::vector<Play> plays = plays_of_pack(pack.path, pack.file(), path, file);
  ExportedClips out{pack.file(), {}};
  for (std::uint32_t i = 0; i < pack.file().clip_count(); ++i) out.clips.push_back({i, *skeleton_of(plays[i], i)});
  return out;
}

ExportedClips clips_of(const Play& play) {
  ExportedClips out{play.clips, {}};
  for (std::uint32_t s = 0; s < play.clip_of_skeleton.size; ++s)
    if (play.clip_of_skeleton[s] != kNoClip) out.clips.push_back({play.clip_of_skeleton[s], s});
  std::ranges::sort(out.clips, {}, &ExportedClips::One::clip);
  return out;
}

Exported exported(const ModelArguments& a) {
  const OpenedModel model = open_model(a.file);
  const File& file = model.file();
  expect_joints(a.file, file);
  if (!a.choice.clip.empty()) return export_file(file, a.file, clips_of(choose(a.file, file, a.choice, true).play));
  if (a.choice.clips.empty()) return export_file(file, a.file);
  const OpenedModel pack = open_model(a.choice.clips);
  return export_file(file, a.file, pack_clips(pack, a.file, file));
}

}  // namespace

void add_export(CLI::App& app, int&) {
  static ModelArguments a;  // as long as the options that point at them
  static std::string out;
  CLI::App* const command = app.add_subcommand("export", "Write a cooked file back as plain glTF 2.0");
  add_input(command, a);
  add_clip(command, a, "all of them");
  command->add_option("-o,--output", out, "the file to write")->required()->type_name("OUT.glb");
  command->callback([] {
    expect_extension(out, {".glb"});
    expect_writable(out);
    const Exported made = exported(a);
    for (const std::string& line : warning_lines(a.file, made.warnings)) fmt::print(stderr, "{}\n", line);
    write_file_atomically(out, made.glb);
  });
}

}  // namespace marrow::tools
