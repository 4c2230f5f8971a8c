// Files: unpacked, loaded, looked up, bound to skeletons.
#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "support/fan.h"
#include "support/golden.h"
#include "unit/misuse/misuse.h"

namespace marrow::test {
namespace {

// A file in memory that stays.
struct Loaded {
  explicit Loaded(AlignedBlock (*copy)()) : block(copy()) { EXPECT_EQ(load(block, file), Status::ok); }
  AlignedBlock block;
  File file;
};
const Loaded& face() {
  static const Loaded made(golden_channels_copy);
  return made;
}
const Loaded& looks() {
  static const Loaded made(golden_looks_copy);
  return made;
}
const Loaded& shapes() {
  static const Loaded made(golden_shapes_copy);
  return made;
}
const Loaded& pack() {
  static const Loaded made(golden_pack_copy);
  return made;
}
const Loaded& dance() {
  static const Loaded made(golden_coded_copy);
  return made;
}

const Loaded& roles() {
  static const Loaded made(golden_roles_copy);
  return made;
}
const Loaded& maps() {
  static const Loaded made(golden_maps_copy);
  return made;
}
Roles roles_of(Misuse& m) {
  return m.either(roles().file.roles(0), Roles{});
}

File file_of(Misuse& m) {
  return m.either(face().file, m.either(pack().file, File{}));
}

// The bytes of a file: cut, off its boundary, a few of them changed.
Span<std::byte> block_of(Misuse& m, Span<const std::byte> good, std::size_t boundary) {
  if (m.spoils("bytes at null")) return {nullptr, good.size};
  const Span<std::byte> block = m.memory(good.size, boundary, Length::any);
  std::memcpy(block.data, good.data, block.size);
  for (int i = 0; i < 3; ++i) block[m.index(0) % block.size] ^= static_cast<std::byte>(m.index(0));
  return block;
}

const char* name_of(Misuse& m) {
  return m.truth(true) ? "no such" : "";
}

const std::vector<std::byte>& fan() {
  static const std::vector<std::byte> packed = packed_fan();
  return packed;
}

// Indices that there are not give what is empty.
std::vector<MisuseRow> rows_of_views() {
  return {
      {"skeleton_count", MISUSED(file_of(m).skeleton_count())},
      {"reference_count", MISUSED(file_of(m).reference_count())},
      {"clip_count", MISUSED(file_of(m).clip_count())},
      {"mesh_count", MISUSED(file_of(m).mesh_count())},
      {"material_count", MISUSED(file_of(m).material_count())},
      {"image_count", MISUSED(file_of(m).image_count())},
      {"node_count", MISUSED(file_of(m).node_count())},
      {"skeleton", MISUSED(std::string(file_of(m).skeleton(m.index(0)).name))},
      {"reference", MISUSED(std::string(m.either(pack().file, File{}).reference(m.index(0)).name))},
      {"clip", MISUSED(std::string(file_of(m).clip(m.index(0)).name))},
      {"mesh", MISUSED(std::string(file_of(m).mesh(m.index(0), m.index(0)).name))},
      {"bounds", MISUSED(file_of(m).bounds(m.index(0), m.index(0)).radius_m)},
      {"is_empty", MISUSED(m.either(Bounds{}, Bounds{{0, 0, 0}, {1, 1, 1}, 1}).is_empty())},
      {"centre", MISUSED(file_of(m).bounds(m.index(0), m.index(0)).centre(1))},
      {"material", MISUSED(std::string(m.either(looks().file, File{}).material(m.index(0)).name))},
      {"image", MISUSED(std::string(m.either(looks().file, File{}).image(m.index(0)).name))},
      {"node", MISUSED(std::string(m.either(looks().file, File{}).node(m.index(0)).name))},
      {"text", MISUSED(std::string(file_of(m).text(m.index(0))))},
      {"sections", MISUSED(file_of(m).sections().size)},
      {"find_skeleton", MISUSED(file_of(m).find_skeleton(m.pointer(name_of(m))))},
      {"find_mesh", MISUSED(file_of(m).find_mesh(m.pointer(name_of(m))))},
      {"find_node", MISUSED(file_of(m).find_node(m.pointer(name_of(m))))},
      {"spring_count", MISUSED(file_of(m).spring_count(m.index(0)))},
      {"spring", MISUSED(file_of(m).spring(m.index(0), m.index(0)).joints.size)},
      {"spring_colliders", MISUSED(file_of(m).spring_colliders(m.index(0)).size)},
      {"roles", MISUSED(m.either(roles().file, File{}).roles(m.index(0)).roles.size)},
      {"joint_of", MISUSED(joint_of(roles_of(m), m.kind(Role::head)))},
      {"role_of", MISUSED(role_of(roles_of(m), m.index(2)))},
      {"mirror_of", MISUSED(mirror_of(roles_of(m), m.index(2)))},
      {"sole_of", MISUSED(sole_of(roles_of(m), m.index(11)))},
      {"role_name", MISUSED(std::string(role_name(m.kind(Role::tail))))},
      {"find_role", MISUSED(find_role(m.pointer(m.truth(true) ? "tail" : "no such")))},
      {"example_space_count", MISUSED(file_of(m).example_space_count())},
      {"example_space",
       [](Misuse& m) {
         ExampleSpace space;
         m.returned(m.either(shapes().file, File{}).example_space(m.truth(true) ? 0 : m.index(0), space));
       }},
      {"find_clip", MISUSED(file_of(m).find_clip(m.pointer(name_of(m))))},
      {"find_clip", MISUSED(file_of(m).find_clip(m.pointer(name_of(m)), m.index(0)))},
      {"find_joint", MISUSED(face().file.find_joint(face().file.skeleton(m.index(0)), m.pointer(name_of(m))))},
      {"find_channel", MISUSED(face().file.find_channel(face().file.clip(m.index(0)), m.pointer(name_of(m))))},
      {"motion", MISUSED(m.either(roles().file, File{}).motion(m.index(1)).events.size)},
      {"find_event", MISUSED(roles().file.find_event(roles().file.motion(m.index(1)), m.pointer(name_of(m))))},
      {"pose_map_count", MISUSED(m.either(maps().file, File{}).pose_map_count())},
      {"pose_map", MISUSED(std::string(m.either(maps().file, File{}).pose_map(m.index(0)).name))},
      {"find_pose_map", MISUSED(m.either(maps().file, File{}).find_pose_map(m.pointer(name_of(m))))},
      {"node_property", MISUSED(looks().file.node_property(looks().file.node(m.index(0)), m.pointer(name_of(m))))},
      {"soa_size", MISUSED(file_of(m).skeleton(m.index(0)).soa_size())},
      {"time_of",
       MISUSED(m.either(dance().file.clip(0), Clip{}).coded.frame_count > 0 ? dance().file.clip(0).coded.time_of(0)
                                                                            : 0)},
      {"skeleton_hash", MISUSED(skeleton_hash(file_of(m), m.index(0)))},
  };
}

// What has no arguments that could be wrong, or only numbers.
std::vector<MisuseRow> rows_of_basics() {
  return {
      {"to_string", MISUSED(std::string(to_string(m.kind(Status::ok))))},
      {"set_call_error_handler", MISUSED(set_call_error_handler(set_call_error_handler(nullptr)))},
      {"set_zone_handler", MISUSED(set_zone_handler(set_zone_handler(nullptr)))},
      {"block_bytes", MISUSED(block_bytes(m.index(7)))},
      {"is_on_boundary", MISUSED(is_on_boundary(m.memory(5).data))},
      {"block_in",
       [](Misuse& m) {
         const Span<std::byte> memory = m.memory(m.index(20) % 64), block = block_in(memory);
         EXPECT_LE(block.size, memory.size);
         EXPECT_TRUE(block.empty() || is_on_boundary(block.data));
         m.returned_ok();
       }},
  };
}

}  // namespace

std::vector<MisuseRow> rows_of_files() {
  std::vector<MisuseRow> rows = {
      {"load",
       [](Misuse& m) {
         File& out = m.one(File{});
         DataError error;
         const Loaded& good = m.either(face(), dance());
         m.returned(load(block_of(m, {good.block.data(), good.block.size()}, 16), out, m.pointer(&error)));
       }},
      {"is_packed", MISUSED(is_packed(m.in(fan())))},
      {"unpack_sizes",
       [](Misuse& m) {
         UnpackSizes& out = m.one(UnpackSizes{});
         DataError error;
         m.returned(unpack_sizes(block_of(m, fan(), 1), out, m.pointer(&error)));
       }},
      {"unpack",
       [](Misuse& m) {
         UnpackSizes sizes;
         EXPECT_EQ(unpack_sizes(fan(), sizes), Status::ok);
         Span<const std::byte>& file = m.one(Span<const std::byte>{});
         DataError error;
         const Span<const MeshDecoder> decoders = m.truth(true) ? kPlainDecoder : Span<const MeshDecoder>();
         m.returned(unpack(block_of(m, fan(), 1), decoders, m.memory(sizes.memory_bytes), file, m.pointer(&error)));
       }},
      {"begin_unpack",
       [](Misuse& m) {
         UnpackSizes sizes;
         EXPECT_EQ(unpack_sizes(fan(), sizes), Status::ok);
         Unpacking& out = m.one(Unpacking{});
         DataError error;
         const Span<const MeshDecoder> decoders = m.truth(true) ? kPlainDecoder : Span<const MeshDecoder>();
         m.returned(
             begin_unpack(block_of(m, fan(), 1), decoders, m.memory(sizes.memory_bytes), out, m.pointer(&error)));
       }},
      {"unpack_step",
       [](Misuse& m) {
         UnpackSizes sizes;
         EXPECT_EQ(unpack_sizes(fan(), sizes), Status::ok);
         AlignedBlock memory(sizes.memory_bytes);
         Unpacking unpacking;
         if (m.truth(true)) {
           EXPECT_EQ(begin_unpack(fan(), kPlainDecoder, {memory.data(), memory.size()}, unpacking), Status::ok);
         }
         DataError error;
         m.returned(unpack_step(unpacking, m.pointer(&error)));
       }},
      {"bind_clips",
       [](Misuse& m) {
         std::size_t count = 0;
         const Span<JointMisfit> misfits = m.room<JointMisfit>(2, Length::any);
         m.returned(bind_clips(m.either(pack().file, file_of(m)), m.index(0), m.either(dance().file, file_of(m)),
                               m.index(0), misfits, m.pointer(&count)));
       }},
      {"bind_outfit",
       [](Misuse& m) {
         std::size_t count = 0;
         const File outfit = m.either(dance().file, file_of(m)), body = m.either(dance().file, file_of(m));
         const Span<std::uint16_t> joints = m.room<std::uint16_t>(dance().file.skeleton(0).joint_count);
         const Span<JointMisfit> misfits = m.room<JointMisfit>(2, Length::any);
         m.returned(bind_outfit(outfit, m.index(0), body, m.index(0), joints, misfits, m.pointer(&count)));
       }},
  };
  for (const auto& more : {rows_of_views(), rows_of_basics()}) rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace marrow::test
