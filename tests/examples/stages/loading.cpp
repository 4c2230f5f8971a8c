// Loads a file, says what is in it, and what is wrong with a damaged copy.
// $ loading hero.mrw
#include "asset.h"

int main(int argc, char** argv) {
  const char* const path = argc > 1 ? argv[1] : "hero.mrw";
  Asset asset;
  if (const marrow::Status status = asset.open(path); status != marrow::Status::ok) {
    std::fprintf(stderr, "%s: byte %u: %s: %s\n", path, asset.error.offset, to_string(status), asset.error.rule);
    return 1;
  }

  const marrow::File& file = asset.file;
  const marrow::Skeleton skeleton = file.skeleton(0);
  std::printf("skeleton \"%s\": %u joints, the hand is number %u\n", skeleton.name, skeleton.joint_count,
              file.find_joint(skeleton, "hand.L"));
  for (std::uint32_t i = 0; i < file.clip_count(); ++i) {
    const marrow::Clip clip = file.clip(i);
    std::printf("clip \"%s\": %.3f s\n", clip.name, double(clip.duration_s));
  }
  for (std::uint32_t i = 0; i < file.mesh_count(); ++i) {
    const marrow::Mesh mesh = file.mesh(i);
    std::printf("mesh \"%s\": %u vertices, %u triangles\n", mesh.name, mesh.geometry.vertex_count,
                mesh.geometry.index_count / 3);
  }

  // A name that is not there gives the count, which no index equals.
  if (file.find_clip("moonwalk") == file.clip_count()) std::printf("no clip \"moonwalk\"\n");

  // The same bytes with one of them wrong.
  std::ifstream stream(path, std::ios::binary);
  std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  bytes[bytes.size() / 2] ^= 1;
  Asset damaged;
  const marrow::Status status = damaged.open({reinterpret_cast<const std::byte*>(bytes.data()), bytes.size()});
  std::printf("a damaged copy: byte %u: %s: %s\n", damaged.error.offset, to_string(status), damaged.error.rule);
}

// Prints:
//   skeleton "newt": 44 joints, the hand is number 37
//   clip "idle": 3.000 s
//   clip "walk": 1.200 s
//   clip "twist": 2.800 s
//   clip "reach": 3.000 s
//   mesh "body": 6789 vertices, 13574 triangles
//   mesh "eye.L": 499 vertices, 960 triangles
//   mesh "eye.R": 499 vertices, 960 triangles
//   mesh "lid.L": 217 vertices, 408 triangles
//   mesh "lid.R": 217 vertices, 408 triangles
//   mesh "mouth": 360 vertices, 696 triangles
//   no clip "moonwalk"
//   a damaged copy: byte 24: damaged: checksum of everything behind the header
