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
  std::vector<marrow::Affine> model_from_joint(skeleton.joint_count);
  if (sample(skeleton, file.clip(walk), 0.4f, local) != Status::ok ||
      local_to_model(skeleton, local, model_from_joint) != Status::ok)
    return 1;

  // Once: room for so many lines.
  static marrow::DebugLine room[1024];
  marrow::DebugLines lines{room};

  // Every frame: begin anew, and append what you want to see.
  lines.count = lines.left_out = 0;
  if (joint_lines(skeleton, model_from_joint, 0.05f, lines) != Status::ok) return 1;
  std::printf("%zu lines show %u joints\n", lines.count, skeleton.joint_count);

  std::size_t before = lines.count;
  if (limit_lines(skeleton, skeleton.limits, local, model_from_joint, 0.1f, lines) != Status::ok) return 1;
  std::printf("%zu lines show %zu limits\n", lines.count - before, skeleton.limits.size);

  before = lines.count;
  if (bounds_lines(file.bounds(walk, file.find_mesh("body")), lines) != Status::ok) return 1;
  std::printf("%zu lines show the bounds of the walk\n", lines.count - before);
  std::printf("%zu lines had no room\n", lines.left_out);

  // Then draw them: here from a little aside, into a picture that a browser shows.
  if (argc > 2) {
    std::FILE* const out = std::fopen(argv[2], "w");
    if (out == nullptr) return 1;
    std::fprintf(out, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='-1.25 -1.7 2.05 2.05' stroke-width='0.006'>\n");
    for (const marrow::DebugLine& line : marrow::Span<marrow::DebugLine>(room, lines.count)) {
      const auto across = [](const float(&p)[3]) { return 0.8 * double(p[0]) + 0.6 * double(p[2]); };
      std::fprintf(out, "<line x1='%.3f' y1='%.3f' x2='%.3f' y2='%.3f' stroke='rgb(%d,%d,%d)'/>\n", across(line.from),
                   -double(line.from[1]), across(line.to), -double(line.to[1]), line.colour[0], line.colour[1],
                   line.colour[2]);
    }
    std::fprintf(out, "</svg>\n");
    std::fclose(out);
  }
}

// Prints:
//   175 lines show 44 joints
//   97 lines show 5 limits
//   60 lines show the bounds of the walk
//   0 lines had no room
