#include "cook/add_pose_maps.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "common/failure.h"
#include "cook/add_clips.h"
#include "cook/prepare/prepare_scene.h"
#include "cook/retarget/make_pose_map.h"
#include "cook/retarget/retarget_map.h"
#include "text/safe_name.h"

namespace marrow::cook {

std::vector<BuiltPoseMap> make_pose_maps(const Character& character, const CookOptions& options, Notes& notes) {
  std::vector<BuiltPoseMap> out;
  for (const RetargetRule& rule : options.pose_maps) {
    const std::string name = tools::safe_name(std::filesystem::path(rule.file).stem().string());
    if (std::ranges::find(out, name, &BuiltPoseMap::name) != out.end())
      throw tools::Failure(tools::Exit::usage, rule.origin.file, rule.origin.where,
                           "a second rig called \"" + name + "\"", "name one of the files otherwise");
    RawScene rig = read_rig(rule.file);
    Notes own, unused;
    if (!rule.file.ends_with(".mrw")) rig = prepare_scene(std::move(rig), {}, unused);  // as it is cooked
    notes.reads.insert(notes.reads.end(), rig.reads.begin(), rig.reads.end());
    RetargetMap map;
    if (!rule.map.empty()) map = read_retarget_map(rule.map, notes.reads);
    out.push_back(make_pose_map(character, rig, rule.map.empty() ? nullptr : &map, own));
    out.back().name = name;
    for (RawWarning& warning : own.warnings) {
      warning.pointer = rule.file + " " + warning.pointer;
      notes.warnings.push_back(std::move(warning));
    }
  }
  return out;
}

}  // namespace marrow::cook
