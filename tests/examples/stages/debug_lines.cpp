// Lines that show joints, limits and bounds, as any renderer can draw them.
// $ debug_lines hero.mrw
#include "asset.h"

using marrow::Status;

int main(int argc, char** argv) {
  Asset asset;
  if (asset.open(argc > 1 ? argv[1] : "hero.mrw") != Status::ok) return 1;
  const marrow::File& file = asset.file;
  const marrow::Skeleton skeleton = file.skeleton(0);
  const std::uint32_t walk = file.find_clip("walk");
  std::vector<marrow::SoaTransform> local(skeleton.soa_size());
  std::vector<marrow::Affine> scene_from_joint(skeleton.joint_count);
  if (sample(skeleton, file.clip(walk), 0.4f, local) != Status::ok ||
      local_to_model(skeleton, local, scene_from_joint) != Status::ok)
    return 1;

  // Once: room for so many lines.
  static marrow::DebugLine room[1024];
  marrow::DebugLines lines{room};

  // Every frame: begin anew, and append what you want to see.
  lines.count = lines.left_out = 0;
  if (joint_lines(skeleton, scene_from_joint, 0.05f, lines) != Status::ok) return 1;
  std::printf("%zu lines show %u joints\n", lines.count, skeleton.joint_count);

  std::size_t before = lines.count;
  if (limit_lines(skeleton, skeleton.limits, local, scene_from_joint, 0.1f, lines) != Status::ok) return 1;
  std::printf("%zu lines show %zu limits\n", lines.count - before, skeleton.limits.size);

  before = lines.count;
  if (bounds_lines(file.bounds(walk, file.find_mesh("body")), lines) != Status::ok) return 1;
  std::printf("%zu lines show the bounds of the walk\n", lines.count - before);
  std::printf("%zu lines had no room\n", lines.left_out);

  // Then draw them: here as a file that any viewer of Wavefront's format shows.
  if (argc > 2) {
    std::FILE* const out = std::fopen(argv[2], "w");
    if (out == nullptr) return 1;
    for (const marrow::DebugLine& line : marrow::Span<marrow::DebugLine>(room, lines.count))
      std::fprintf(out, "v %g %g %g\nv %g %g %g\nl -2 -1\n", double(line.from[0]), double(line.from[1]),
                   double(line.from[2]), double(line.to[0]), double(line.to[1]), double(line.to[2]));
    std::fclose(out);
  }
}

// Prints:
//   175 lines show 44 joints
//   97 lines show 5 limits
//   60 lines show the bounds of the walk
//   0 lines had no room
