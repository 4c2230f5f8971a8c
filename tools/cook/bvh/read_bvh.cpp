#include "cook/bvh/read_bvh.h"

#include <filesystem>
#include <string_view>
#include <utility>

#include "cook/bvh/bvh_hierarchy.h"
#include "cook/bvh/bvh_motion.h"
#include "cook/bvh/bvh_words.h"
#include "cook/gltf/document/scene_files.h"
#include "text/safe_name.h"

namespace marrow::cook {
namespace {

using namespace bvh;

RawScene read_scene(const std::string& name, std::span<const std::byte> bytes, gltf::Report& report) {
  Words words({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, report);
  const BvhHierarchy hierarchy = read_hierarchy(words, report);
  RawScene scene;
  scene.source = name;
  scene.source_bytes = bytes.size();
  scene.is_capture = true;
  RawSkin& skin = scene.skins.emplace_back();
  for (const BvhJoint& joint : hierarchy.joints) {
    if (!joint.is_end) skin.joints.push_back(static_cast<int>(scene.nodes.size()));
    RawNode& node = scene.nodes.emplace_back();
    node.name = joint.name;
    node.parent = joint.parent;
    node.translation = joint.offset;
  }
  skin.inverse_bind.assign(skin.joints.size(), glm::dmat4(1.0));
  scene.clips.push_back(read_motion(words, hierarchy, report));
  scene.clips.back().name = tools::safe_name(std::filesystem::path(name).stem().string());
  scene.warnings = report.take_warnings();
  scene.reads = report.take_reads();
  return scene;
}

}  // namespace

RawScene read_bvh(const std::string& name, Files& files) {
  gltf::Report report(name);
  const std::vector<std::byte> bytes = gltf::read_scene_file(files, name, kMostBytes + 1, "", report);
  return read_scene(name, bytes, report);
}

RawScene read_bvh(const std::string& name, std::span<const std::byte> bytes) {
  gltf::Report report(name);
  return read_scene(name, bytes, report);
}

}  // namespace marrow::cook
