#include "unpack/structure.h"

#include "core/memory.h"
#include "core/step.h"
#include "marrow/local_to_model.h"
#include "math/affine.h"
#include "unpack/rest.h"

namespace marrow {
namespace {

constexpr SoaTransform kIdentities = {{}, {{}, {}, {}, {1, 1, 1, 1}}, {{1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}}};

template <class T>
T* at(Span<std::byte> section, std::uint64_t offset) {
  return reinterpret_cast<T*>(section.data + offset);
}

// Reads a name's offset in the pool. Code 0 stands for the next new name, any other for an offset plus one.
std::uint32_t take_name(ByteReader& reader, NameReader& names) {
  const std::uint32_t code = reader.take_varint();
  return code == 0 ? names.next() : code - 1;
}

// Reads a signed number in zigzag code: 0, -1, 1, -2 … are stored as 0, 1, 2, 3 …
std::int32_t take_signed(ByteReader& reader) {
  const std::uint32_t code = reader.take_varint();
  return static_cast<std::int32_t>(code >> 1 ^ (0 - (code & 1)));
}

// Reads a matrix. Of two bits for each of its 12 numbers, lowest first, 0, 1 and 2 stand for 0, 1 and -1; 3: a float
// follows.
Affine take_map(ByteReader& reader) {
  constexpr float kKnown[] = {0, 1, -1};
  std::uint32_t codes = reader.take<std::uint16_t>();
  codes |= std::uint32_t{reader.take<std::uint8_t>()} << 16;
  Affine out;
  for (auto& row : out.rows)
    for (float& x : row) {
      x = (codes & 3) < 3 ? kKnown[codes & 3] : reader.take<float>();
      codes >>= 2;
    }
  return out;
}

void take_rotation(ByteReader& reader, std::size_t lane, SoaTransform& four) {
  const std::uint32_t codes = reader.take<std::uint8_t>();
  const auto code_of = [&](std::uint32_t i) { return codes >> 2 * i & 3; };
  double squared = 0;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const float x = code_of(i) == kCodeGiven ? reader.take<float>() : 0.0f;
    squared += static_cast<double>(x) * static_cast<double>(x);
    four.rotation[i][lane] = x;
  }
  const float left = left_of_rotation(squared);
  for (std::uint32_t i = 0; i < 4; ++i)
    if (code_of(i) >= kCodeLeft) four.rotation[i][lane] = code_of(i) == kCodeLeft ? left : -left;
}

// Numbers that are not stored keep the identity's values.
void take_joint(ByteReader& reader, std::uint32_t flags, std::size_t lane, SoaTransform& four) {
  for (std::uint32_t axis = 0; axis < 3; ++axis)
    if ((flags & packed::kJointTranslates << axis) != 0) four.translation[axis][lane] = reader.take<float>();
  if ((flags & packed::kJointRotates) != 0) take_rotation(reader, lane, four);
  if ((flags & packed::kJointScales) == 0) return;
  std::uint32_t codes = reader.take<std::uint8_t>();
  for (auto& axis : four.scale) {
    if ((codes & 3) == kCodeScale) axis[lane] = reader.take<float>();
    if ((codes & 3) == kCodeNearOne) axis[lane] = near_one(reader.take<std::int8_t>());
    codes >>= 2;
  }
}

void take_helpers(ByteReader& reader, std::uint32_t flags, Span<Helper> helpers, float* centres) {
  const bool bytes = (flags & packed::kMeshSharesAreBytes) != 0;
  for (Helper& helper : helpers) {
    helper.first = static_cast<std::uint16_t>(reader.take_varint());
    helper.second = static_cast<std::uint16_t>(reader.take_varint());
    helper.share = bytes ? static_cast<float>(reader.take<std::uint8_t>()) * 0x1p-8f : reader.take<float>();
  }
  if ((flags & packed::kMeshHasCentres) == 0) return;
  const std::int32_t exponent = reader.take<std::int8_t>();
  for (std::size_t i = 0; i < 3 * helpers.size; ++i) centres[i] = decode_centre(take_signed(reader), exponent);
}

// False if a count is out of range.
bool take_mesh_header(ByteReader& reader, std::uint32_t flags, format::MeshHeader& h) {
  h.flags = static_cast<std::uint8_t>(((flags & packed::kMeshIsDoubleSided) != 0 ? format::kDoubleSided : 0u) |
                                      ((flags & packed::kMeshIsNextPart) != 0 ? format::kNextPart : 0u) |
                                      ((flags & packed::kMeshHasCentres) != 0 ? format::kHelpersHaveCentres : 0u));
  h.name = reader.take_varint();
  h.material = reader.take_varint();
  h.material_section = reader.take_varint();
  h.skeleton = reader.take_varint();
  h.geometry = reader.take_varint();
  h.joint_count = reader.take_varint();
  h.target_count = reader.take_varint();
  const std::uint32_t helper_count = (flags & packed::kMeshHasHelpers) != 0 ? reader.take_varint() : 0;
  h.helper_count = static_cast<std::uint16_t>(helper_count);
  const std::uint32_t lod_count = (flags & packed::kMeshHasLods) != 0 ? reader.take_varint() : 0;
  h.lod_count = static_cast<std::uint8_t>(lod_count);
  for (float& c : h.base_colour) c = (flags & packed::kMeshHasColour) != 0 ? reader.take<float>() : 1.0f;
  constexpr std::uint32_t kMostTargets = 1 << 16;  // the same limit as for a geometry's targets
  return h.joint_count <= kMaxJoints && helper_count <= kMaxJoints && lod_count <= 255 &&
         h.target_count <= kMostTargets;
}

// Each joint is stored as its difference from (the joint before it + 1). False if the skeleton has no such joint.
bool take_mesh_joints(ByteReader& reader, const Skeleton& skeleton, Span<std::uint16_t> joints) {
  std::uint32_t joint = 0xFFFFFFFF;
  for (std::uint16_t& out : joints) {
    joint += 1 + static_cast<std::uint32_t>(take_signed(reader));
    if (joint >= skeleton.joint_count) return false;
    out = static_cast<std::uint16_t>(joint);
  }
  return true;
}

// Reads the inverse bind matrices that the file gives, and computes the others from the rest pose. model: the rest
// pose's model_from_joint.
void take_inverse_binds(ByteReader& reader, std::uint32_t flags, Span<const std::uint16_t> joints, const Affine* model,
                        const Affine& model_from_mesh, Affine* inverse_bind) {
  const Span<const std::byte> given =
      reader.take_bytes((flags & packed::kMeshGivesBinds) != 0 ? (joints.size + 7) / 8 : 0);
  for (std::size_t i = 0; i < joints.size; ++i)
    inverse_bind[i] = given.size > 0 && (static_cast<std::uint32_t>(given[i / 8]) >> i % 8 & 1) != 0
                          ? take_map(reader)
                          : derived_inverse_bind(model[joints[i]], model_from_mesh);
}

void take_targets(ByteReader& reader, std::uint32_t count, std::byte* targets) {
  for (std::uint32_t t = 0; t < count; ++t) {
    MeshTarget target{};
    target.name = reader.take_varint();
    target.channel = reader.take_varint();
    target.weight = reader.take<float>();
    std::memcpy(targets + t * sizeof target, &target, sizeof target);
  }
}

void take_lods(ByteReader& reader, Span<MeshLod> lods) {
  for (MeshLod& lod : lods) {
    lod.geometry = reader.take_varint();
    lod.error_m = reader.take<float>();
  }
}

}  // namespace

Skeleton skeleton_at(UnpackedSkeletons skeletons, std::uint32_t index) {
  Skeleton s;
  if (index >= skeletons.count) return s;
  File::Section entry;
  std::memcpy(&entry, skeletons.file + sizeof(format::Header) + index * sizeof entry, sizeof entry);
  const std::byte* const section = skeletons.file + entry.offset;
  format::SkeletonHeader h;
  std::memcpy(&h, section, sizeof h);
  const format::SkeletonLayout l = layout(h);
  s.joint_count = h.joint_count;
  s.root_count = h.root_count;
  s.model_from_root = reinterpret_cast<const Affine*>(section + l.roots);
  s.rest = reinterpret_cast<const SoaTransform*>(section + l.rest);
  s.parents = reinterpret_cast<const std::uint16_t*>(section + l.parents);
  return s;
}

std::uint32_t joint_count_at(UnpackedSkeletons skeletons, std::uint32_t index) {
  if (index >= skeletons.reference_count) return skeleton_at(skeletons, index).joint_count;
  File::Section entry;
  format::ReferenceHeader h;
  std::memcpy(&entry, skeletons.file + sizeof(format::Header) + index * sizeof entry, sizeof entry);
  if (entry.bytes < sizeof h) return 0;
  std::memcpy(&h, skeletons.file + entry.offset, sizeof h);
  return h.joint_count <= kMaxJoints ? h.joint_count : 0;
}

NameReader::NameReader(Span<const std::byte> record) : reader_(record.data, record.size) {
  pool_bytes_ = reader_.take_varint();
}

std::uint32_t NameReader::next(char* pool) {
  const std::uint32_t head = reader_.take<std::uint8_t>(), shared = head & 63;
  const auto from = last_[head >> 6];
  const std::uint32_t offset = end_;
  if (reader_.failed() || shared > from.length || shared > pool_bytes_ || offset > pool_bytes_ - shared) {
    failed_ = true;
    return 0;
  }
  if (pool != nullptr)
    for (std::uint32_t i = 0; i < shared; ++i) pool[offset + i] = pool[from.offset + i];
  end_ += shared;
  // The search costs no more than copying the name, however long it is; load() checks the length.
  const std::size_t room = pool_bytes_ - end_, most = reader_.left() < room ? reader_.left() : room;
  const void* const zero = most > 0 ? std::memchr(reader_.at(), 0, most) : nullptr;
  if (zero == nullptr) {
    failed_ = true;
    return 0;
  }
  const Span<const std::byte> rest =
      reader_.take_bytes(static_cast<std::size_t>(static_cast<const std::byte*>(zero) - reader_.at()) + 1);
  if (pool != nullptr) std::memcpy(pool + end_, rest.data, rest.size);
  end_ += static_cast<std::uint32_t>(rest.size);
  for (int i = 3; i > 0; --i) last_[i] = last_[i - 1];
  last_[0] = {offset, end_ - 1 - offset};
  return offset;
}

const char* unpack_names(NameReader& names, Span<std::byte> out, std::uint32_t& bytes, bool& done) {
  if (names.pool_bytes() < 1) return "a pool without the empty name";
  if (names.pool_bytes() > out.size) return "file_bytes too small";
  auto* const pool = reinterpret_cast<char*>(out.data);
  pool[0] = 0;
  for (const std::uint32_t first = names.end(); !names.at_end() && names.end() - first < kStepBytes / 4;) {
    names.next(pool);
    if (names.failed()) return "a name that does not fit";
  }
  done = names.at_end();
  if (done && names.end() != names.pool_bytes()) return "names that do not fill their pool";
  bytes = names.pool_bytes();
  return nullptr;
}

const char* unpack_skeleton(Span<const std::byte> record, NameReader& names, Span<std::byte> out,
                            std::uint32_t& bytes) {
  ByteReader reader(record.data, record.size);
  format::SkeletonHeader h{};
  h.name = take_name(reader, names);
  h.joint_count = reader.take_varint();
  h.root_count = reader.take_varint();
  if (h.joint_count > kMaxJoints || h.root_count < 1 || h.root_count > h.joint_count) return "a count out of range";
  const format::SkeletonLayout l = layout(h);
  if (l.bytes > out.size) return "file_bytes too small";
  std::memcpy(out.data, &h, sizeof h);
  for (std::uint32_t r = 0; r < h.root_count; ++r)
    at<Affine>(out, l.roots)[r] = reader.take<std::uint8_t>() != 0 ? take_map(reader) : kIdentity;

  auto* const rest = at<SoaTransform>(out, l.rest);
  auto* const parents = at<std::uint16_t>(out, l.parents);
  std::uint32_t known = h.root_count;  // joints whose parents are known
  for (std::uint32_t j = 0; j < h.root_count; ++j) parents[j] = kNoJoint;
  for (std::uint32_t j = 0; j < h.joint_count; ++j) {
    if (j % 4 == 0) rest[j / 4] = kIdentities;
    const std::uint32_t flags = reader.take<std::uint8_t>();
    std::uint32_t children = flags >> packed::kJointChildrenShift;
    if (children == packed::kJointManyChildren) children = reader.take_varint();
    if (j >= known || children > h.joint_count - known) return "joints that hang together wrongly";
    for (; children > 0; --children) parents[known++] = static_cast<std::uint16_t>(j);
    at<std::uint32_t>(out, l.names)[j] = (flags & packed::kJointNameIsOld) != 0 ? reader.take_varint() : names.next();
    take_joint(reader, flags, j % 4, rest[j / 4]);
  }
  if (reader.failed() || names.failed() || reader.left() != 0) return "a skeleton that is too short or too long";
  bytes = static_cast<std::uint32_t>(l.bytes);
  return nullptr;
}

Affine derived_inverse_bind(const Affine& model, const Affine& model_from_mesh) {
  const Linear<float> m = linear(model), c = cofactors(m);
  // Expanded by the first row: cooked files depend on how this rounds.
  const float volume = m.x.x * c.x.x + m.y.x * c.y.x + m.z.x * c.z.x;
  const Linear<float> rows = {c.x / volume, c.y / volume, c.z / volume};
  const Vector3 at = -transposed_times(rows, origin(model));
  const Affine inverse = {{{rows.x.x, rows.x.y, rows.x.z, at.x},
                           {rows.y.x, rows.y.y, rows.y.z, at.y},
                           {rows.z.x, rows.z.y, rows.z.z, at.z}}};
  Affine out;
  multiply(inverse, model_from_mesh, out);
  return out;
}

const char* unpack_mesh(Span<const std::byte> record, UnpackedSkeletons skeletons, std::uint32_t& modelled,
                        Span<std::byte> scratch, Span<std::byte> out, std::uint32_t& bytes) {
  ByteReader reader(record.data, record.size);
  const std::uint32_t flags = reader.take_varint();
  if ((flags & ~std::uint32_t{packed::kAllPackedMeshFlags}) != 0) return "unknown mesh flags";
  format::MeshHeader h{};
  if (!take_mesh_header(reader, flags, h)) return "a count out of range";
  const Affine model_from_mesh = (flags & packed::kMeshHasPlace) != 0 ? take_map(reader) : kIdentity;
  const Skeleton skeleton = skeleton_at(skeletons, h.skeleton);
  if (skeleton.joint_count == 0) return "no such skeleton among the compact ones";
  const format::MeshLayout l = layout(h);
  if (l.bytes > out.size) return "file_bytes too small";
  Memory memory{scratch.data, 0, scratch.size};
  Affine* const model = memory.take<Affine>(skeleton.joint_count).data;
  if (model == nullptr) return "memory_bytes too small";
  if (modelled != h.skeleton)
    (void)local_to_model(skeleton, {skeleton.rest, skeleton.soa_size()}, {model, skeleton.joint_count});
  modelled = h.skeleton;

  std::memcpy(out.data, &h, sizeof h);
  const Span<std::uint16_t> joints{at<std::uint16_t>(out, l.joints), h.joint_count};
  if (!take_mesh_joints(reader, skeleton, joints)) return "a joint out of range";
  take_inverse_binds(reader, flags, joints, model, model_from_mesh, at<Affine>(out, l.inverse_bind));
  take_targets(reader, h.target_count, out.data + l.targets);
  const std::uint64_t end_of_joints = l.joints + std::uint64_t{h.joint_count} * 2;
  std::memset(out.data + end_of_joints, 0, static_cast<std::size_t>(l.helpers - end_of_joints));
  take_helpers(reader, flags, {at<Helper>(out, l.helpers), h.helper_count}, at<float>(out, l.centres));
  take_lods(reader, {at<MeshLod>(out, l.lods), h.lod_count});
  if (reader.failed() || reader.left() != 0) return "a mesh that is too short or too long";
  bytes = static_cast<std::uint32_t>(l.bytes);
  return nullptr;
}

}  // namespace marrow
