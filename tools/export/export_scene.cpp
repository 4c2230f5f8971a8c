// The steps one after the other.
#include "common/check_status.h"
#include "export/export.h"
#include "export/export_looks.h"
#include "export/export_parts.h"
#include "marrow/example_space.h"

namespace marrow::tools {

std::size_t ExportScene::add_node(Json node, std::size_t parent) {
  const std::size_t number = glb.add("nodes", std::move(node));
  if (parent == kScene) {
    roots.push_back(number);
  } else {
    glb.json["nodes"][parent]["children"].push_back(number);
  }
  return number;
}

ExportedClips all_clips(const File& file) {
  ExportedClips out{file, {}};
  for (std::uint32_t i = 0; i < file.clip_count(); ++i) out.clips.push_back({i, file.clip(i).skeleton});
  return out;
}

Exported export_file(const File& file, const std::string& name, const ExportedClips& clips) {
  ExportScene scene{file, name, Glb("marrow export"), {}, {}, {}, {}};
  scene.glb.json["scene"] = 0;
  export_skeletons(scene);
  export_limits(scene);
  for (std::uint32_t s = 0; s < file.skeleton_count(); ++s)
    if (file.spring_count(s) > 0)
      scene.warnings.push_back({"skeleton " + std::to_string(s) + " \"" + file.skeleton(s).name + "\"", "",
                                "glTF has no springs; they are left out"});
  for (std::uint32_t i = 0; i < file.example_space_count(); ++i) {
    ExampleSpace space;
    check(file.example_space(i, space));
    scene.warnings.push_back({"shape " + std::to_string(i) + " \"" + space.name + "\"", "",
                              "glTF has no spaces of example shapes; they are left out"});
  }
  export_meshes(scene);
  export_clips(scene, clips);
  export_nodes(scene);
  scene.glb.add("scenes", {{"nodes", scene.roots}});
  return {scene.glb.finish(name), std::move(scene.warnings)};
}

}  // namespace marrow::tools
