#include <marrow/draco.h>
#include <marrow/marrow.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

int main(int argc, char** argv) {
  std::ifstream stream(argc > 1 ? argv[1] : "character.mrw", std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  marrow::Span<const std::byte> block(reinterpret_cast<const std::byte*>(bytes.data()), bytes.size());
  std::vector<std::byte> memory;
  if (marrow::is_packed(block)) {  // meshes are compressed, unless cooked with --mesh-codec none
    const marrow::MeshDecoder decoders[] = {marrow::draco_decoder()};
    marrow::UnpackSizes sizes;
    if (unpack_sizes(block, sizes) != marrow::Status::ok) return 1;
    memory.resize(sizes.memory_bytes);
    if (unpack(block, {decoders, 1}, memory, block) != marrow::Status::ok) return 1;
  }
  marrow::File file;
  if (load(block, file) != marrow::Status::ok) return 1;

  const marrow::Skeleton skeleton = file.skeleton(0);
  const marrow::Mesh mesh = file.mesh(0);
  std::vector<marrow::SoaTransform> local(skeleton.soa_size());
  std::vector<marrow::Affine> joints(skeleton.joint_count), palette(mesh.palette_size());
  std::vector<float> positions(3 * mesh.geometry.slot_count);

  // Every frame; nothing here allocates.
  if (sample(skeleton, file.clip(0), 0.5f, local) != marrow::Status::ok ||
      local_to_model(skeleton, local, joints) != marrow::Status::ok ||
      build_palette(mesh, joints, palette) != marrow::Status::ok ||
      skin_ssd(mesh, palette, {.positions = positions, .normals = {}, .tangents = {}}) != marrow::Status::ok)
    return 1;
  std::printf("%s: vertex 0 at %g %g %g m\n", mesh.name, double(positions[0]), double(positions[1]),
              double(positions[2]));
}
