#include "pose/worn.h"

#include "common/failure.h"
#include "marrow/outfit.h"
#include "pose/misfits_text.h"

namespace marrow::tools {
namespace {

// The first of an outfit's skeletons that fits none, beside the body's of its name or else the first.
[[noreturn]] void refuse(const std::string& path, const File& outfit, const std::string& body_path, const File& body) {
  for (std::uint32_t s = 0; s < outfit.skeleton_count(); ++s) {
    const Skeleton own = outfit.skeleton(s);
    std::vector<std::uint16_t> joints(own.joint_count);
    bool fits = false;
    for (std::uint32_t b = 0; b < body.skeleton_count() && !fits; ++b)
      fits = bind_outfit(outfit, s, body, b, joints) == Status::ok;
    if (fits) continue;
    const std::uint32_t named = body.find_skeleton(own.name), beside = named < body.skeleton_count() ? named : 0;
    std::vector<JointMisfit> misfits(kMostMisfits);
    std::size_t count = 0;
    (void)bind_outfit(outfit, s, body, beside, joints, misfits, &count);
    throw Failure(
        Exit::invalid, path, "", "skeleton \"" + std::string(own.name) + "\" does not fit " + body_path,
        misfits_text(
            misfits, count, [&](std::uint32_t joint) { return outfit.text(own.names[joint]); },
            [&](std::uint32_t joint) { return body.text(body.skeleton(beside).names[joint]); }, "the outfit") +
            "; cook the outfit with --skeleton " + body_path);
  }
  throw Failure(Exit::invalid, path, "", "no skeleton", "cook the outfit with --skeleton " + body_path);
}

}  // namespace

void put_on(std::span<const std::string> paths, const std::string& body_path, const File& body, const Play& chosen,
            Character& character, AsNormals normals, std::uint32_t level) {
  std::vector<std::shared_ptr<Worn>> all;
  for (const std::string& path : paths) {
    Worn& worn = *all.emplace_back(std::make_shared<Worn>());
    worn.path = path;
    worn.loaded = load_mrw(path);
    const File& file = worn.loaded.file;
    worn.memory = AlignedBytes(outfit_bytes(file));
    const Status status = make_outfit(body, file, worn.memory, worn.outfit);
    if (status == Status::mismatch) refuse(path, file, body_path, body);
    check(status);
    worn.character = std::make_unique<Character>(file, normals, level);
    for (std::uint32_t s = 0; s < body.skeleton_count() && worn.play.empty(); ++s) {
      const std::optional<Clip> clip = chosen.clip(s);
      if (!clip) continue;
      const std::uint32_t own = file.find_clip(clip->name);
      if (own < file.clip_count()) worn.play = play_together(file, own);
    }
  }
  character.wear(std::move(all));
}

}  // namespace marrow::tools
