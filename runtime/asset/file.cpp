#include "marrow/file.h"

#include <cstring>

#include "asset/format.h"
#include "asset/section_views.h"
#include "core/builtins.h"

namespace marrow {
namespace {

template <class T>
const T* at(const std::byte* base, std::uint64_t offset) {
  return reinterpret_cast<const T*>(base + offset);
}

// Where an array begins; null if it is not there.
template <class T>
const T* first_if(bool present, const format::Array<T>& array, const std::byte* base) {
  return present ? array.in(base).data : nullptr;
}

// No name is the null pointer.
bool is_called(const char* text, const char* name) {
  return name != nullptr && std::strcmp(text, name) == 0;
}

}  // namespace

const std::byte* File::section(std::uint32_t kind, std::uint32_t index) const {
  return block_ + sections_[first_[kind] + index].offset;
}

const char* File::text(std::uint32_t name) const {
  if (block_ == nullptr || name >= sections_[first_[format::kNames]].bytes) return "";
  return at<char>(section(format::kNames, 0), name);
}

Skeleton File::skeleton(std::uint32_t index) const {
  Skeleton s;
  if (index >= skeleton_count()) return s;
  const std::byte* const base = section(format::kSkeletons, index);
  const auto& header = *at<format::SkeletonHeader>(base, 0);
  const format::SkeletonLayout l = layout(header);
  s.name = text(header.name);
  s.joint_count = header.joint_count;
  s.root_count = header.root_count;
  s.model_from_root = l.roots.in(base).data;
  s.rest = l.rest.in(base).data;
  s.parents = l.parents.in(base).data;
  s.names = l.names.in(base).data;
  for (std::uint32_t i = 0; i < counts_[format::kLimits]; ++i) {
    const std::byte* const section_i = section(format::kLimits, i);
    const auto& limits = *at<format::LimitHeader>(section_i, 0);
    if (limits.skeleton == index) s.limits = layout(limits).limits.in(section_i);
  }
  return s;
}

SkeletonReference File::reference(std::uint32_t index) const {
  SkeletonReference r;
  if (index >= reference_count()) return r;
  const std::byte* const base = section(format::kReferences, index);
  const auto& header = *at<format::ReferenceHeader>(base, 0);
  const format::ReferenceLayout l = layout(header);
  r.name = text(header.name);
  r.joint_count = header.joint_count;
  r.hash = header.hash;
  r.names = l.names.in(base).data;
  r.rest_hashes = l.rest_hashes.in(base).data;
  r.parents = l.parents.in(base).data;
  return r;
}

Clip File::clip(std::uint32_t index) const {
  Clip c;
  if (index >= clip_count()) return c;
  const std::byte* const base = section(format::kClips, index);
  const auto& header = *at<format::ClipHeader>(base, 0);
  const format::ClipLayout l = layout(header);
  c.name = text(header.name);
  c.skeleton = header.skeleton;
  c.duration_s = header.duration_s;
  c.additive = header.additive != 0;
  c.reference = first_if(header.reference_groups != 0, l.reference, base);
  c.tracks = l.tracks.in(base);
  c.channels = l.channels.in(base);
  c.times_s = l.times.in(base).data;
  c.values = l.values.in(base).data;
  c.id = format::mix_checksum(at<format::Header>(block_, 0)->checksum, index + 1) | 1;
  c.joint_count = reference_count() > 0
                      ? at<format::ReferenceHeader>(section(format::kReferences, header.skeleton), 0)->joint_count
                      : at<format::SkeletonHeader>(section(format::kSkeletons, header.skeleton), 0)->joint_count;
  if (sections_[first_[format::kClips] + index].codec == format::kCodecSegments) {
    const auto& coded = *at<format::CodedHeader>(base, l.bytes);
    const format::CodedLayout k = layout(coded, l.bytes, c.joint_count);
    c.coded = {coded.frame_count,
               coded.track_count,
               coded.constant_count,
               coded.segment_intervals,
               coded.start_s,
               coded.frames_per_s,
               first_if(coded.time_count > 0, k.times, base),
               k.masks.in(base).data,
               k.offsets.in(base).data,
               base + k.constants,
               base + k.payload};
  }
  return c;
}

Geometry view_geometry(const std::byte* base) {
  const auto& header = *at<format::GeometryHeader>(base, 0);
  const format::GeometryLayout l = layout(header);
  const auto has = [&](format::GeometryFlags flag) { return (header.flags & flag) != 0; };
  Geometry g;
  g.slot_count = header.block_count * 4;
  g.vertex_count = header.vertex_count;
  g.index_count = header.index_count;
  g.index_bytes = l.index_bytes;
  g.joint_count = header.joint_count;
  g.indices = at<void>(base, l.indices);
  g.runs = l.runs.in(base);
  g.sets = l.sets.in(base).data;
  g.skin = l.skin.in(base).data;
  g.normals = first_if(has(format::kHasNormals), l.normals, base);
  g.tangents = first_if(has(format::kHasTangents), l.tangents, base);
  g.as_residual = first_if(has(format::kHasAsResidual), l.as_residual, base);
  g.mwe_residual = first_if(has(format::kHasMwe), l.mwe_residual, base);
  g.mwe_root = header.mwe_root;
  g.uvs = first_if(has(format::kHasUvs), l.uvs, base);
  g.colours = first_if(has(format::kHasColours), l.colours, base);
  g.source_slots = l.source_slots.in(base);
  if (has(format::kHasMorphTargets)) {
    const auto& morphs = *at<format::MorphHeader>(base, format::morph_start(l));
    const format::MorphLayout k = layout(morphs, l);
    g.targets = k.targets.in(base);
    g.target_blocks = at<void>(base, k.blocks);
    g.target_records = at<std::int16_t>(base, k.records);
  }
  if (has(format::kHasPoseSpace)) {
    const std::uint64_t start = format::pose_space_start(base);
    const auto& space = *at<format::PoseSpaceHeader>(base, start);
    const format::PoseSpaceLayout k = layout(space, header, start);
    g.pose_space = {space.sigma,
                    k.examples.in(base),
                    at<void>(base, k.blocks),
                    at<std::int16_t>(base, k.records),
                    at<std::int16_t>(base, k.rotations),
                    k.parents.in(base).data};
  }
  std::memcpy(g.box_min, header.box_min, sizeof g.box_min);
  std::memcpy(g.box_max, header.box_max, sizeof g.box_max);
  return g;
}

Geometry File::geometry(std::uint32_t index) const {
  return view_geometry(section(format::kGeometries, index));
}

Mesh File::mesh(std::uint32_t index, std::uint32_t level) const {
  Mesh m;
  if (index >= mesh_count()) return m;
  const std::byte* const base = section(format::kMeshes, index);
  const auto& header = *at<format::MeshHeader>(base, 0);
  const format::MeshLayout l = layout(header);
  m.name = text(header.name);
  m.material = text(header.material);
  if (header.material_section != 0) m.material_index = header.material_section - 1;
  m.skeleton = header.skeleton;
  m.lods = l.lods.in(base);
  level = level < m.lods.size ? level : static_cast<std::uint32_t>(m.lods.size);
  m.geometry_index = level > 0 ? m.lods[level - 1].geometry : header.geometry;
  m.joint_count = header.joint_count;
  m.joints = l.joints.in(base).data;
  m.inverse_bind = l.inverse_bind.in(base).data;
  std::memcpy(m.base_colour, header.base_colour, sizeof m.base_colour);
  m.double_sided = (header.flags & format::kDoubleSided) != 0;
  m.is_next_part = (header.flags & format::kNextPart) != 0;
  m.helpers = l.helpers.in(base);
  m.helper_centres = l.centres.in(base);
  m.geometry = geometry(m.geometry_index);
  m.targets = {at<MeshTarget>(base, l.targets), m.geometry.targets.size};
  return m;
}

std::uint32_t File::find_skeleton(const char* name) const {
  std::uint32_t i = 0;
  while (i < skeleton_count() && !is_called(skeleton(i).name, name)) ++i;
  return i;
}

std::uint32_t File::find_joint(const Skeleton& skeleton, const char* name) const {
  std::uint32_t joint = 0;
  while (joint < skeleton.joint_count && !is_called(text(skeleton.names[joint]), name)) ++joint;
  return joint;
}

std::uint32_t File::find_mesh(const char* name) const {
  std::uint32_t i = 0;
  while (i < mesh_count() && !is_called(mesh(i).name, name)) ++i;
  return i;
}

std::uint32_t File::find_clip(const char* name, std::uint32_t of_skeleton) const {
  std::uint32_t i = 0;
  while (i < clip_count() && (clip(i).skeleton != of_skeleton || !is_called(clip(i).name, name))) ++i;
  return i;
}

Material File::material(std::uint32_t index) const {
  Material m;
  if (index >= material_count()) return m;
  const std::byte* const base = section(format::kMaterials, index);
  const auto& header = *at<format::MaterialHeader>(base, 0);
  m.name = text(header.name);
  m.alpha = header.alpha;
  m.alpha_cutoff = header.alpha_cutoff;
  const format::MaterialLayout l = layout(header);
  m.unlit = (header.flags & format::kUnlit) != 0;
  if ((header.flags & format::kEmits) != 0) std::memcpy(m.emissive, base + l.emissive, sizeof m.emissive);
  m.textures = l.textures.in(base);
  return m;
}

Image File::image(std::uint32_t index) const {
  Image i;
  if (index >= image_count()) return i;
  const std::byte* const base = section(format::kImages, index);
  const auto& header = *at<format::ImageHeader>(base, 0);
  i.name = text(header.name);
  i.uri = text(header.uri);
  i.format = header.format;
  i.bytes = layout(header).data.in(base);
  if (header.fallback != 0) i.fallback = header.fallback - 1u;
  return i;
}

Node File::node(std::uint32_t index) const {
  Node n;
  if (index >= node_count()) return n;
  const std::byte* const base = section(format::kNodes, index);
  const auto& header = *at<format::NodeHeader>(base, 0);
  n.name = text(header.name);
  n.skeleton = header.skeleton;
  n.joint = header.joint;
  n.joint_from_node = &header.joint_from_node;
  n.properties = layout(header).properties.in(base);
  return n;
}

const std::byte* File::springs_of(std::uint32_t skeleton) const {
  for (std::uint32_t i = 0; i < counts_[format::kSprings]; ++i) {
    const std::byte* const base = section(format::kSprings, i);
    if (at<format::SpringHeader>(base, 0)->skeleton == skeleton) return base;
  }
  return nullptr;
}

std::uint32_t File::spring_count(std::uint32_t of_skeleton) const {
  const std::byte* const base = springs_of(of_skeleton);
  return base != nullptr ? at<format::SpringHeader>(base, 0)->chain_count : 0;
}

SpringChain File::spring(std::uint32_t of_skeleton, std::uint32_t index) const {
  if (index >= spring_count(of_skeleton)) return {};
  const std::byte* const base = springs_of(of_skeleton);
  const format::SpringLayout l = layout(*at<format::SpringHeader>(base, 0));
  const format::SpringRecord& record = l.chains.in(base)[index];
  SpringChain chain;
  chain.joints = {l.joints.in(base).data + record.first_joint, record.joint_count};
  std::memcpy(chain.tip, record.tip, sizeof chain.tip);
  chain.colliders = record.colliders;
  return chain;
}

Span<const SpringCollider> File::spring_colliders(std::uint32_t of_skeleton) const {
  const std::byte* const base = springs_of(of_skeleton);
  if (base == nullptr) return {};
  const auto& header = *at<format::SpringHeader>(base, 0);
  return layout(header).colliders.in(base);
}

Roles File::roles(std::uint32_t of_skeleton) const {
  for (std::uint32_t i = 0; i < counts_[format::kRoles]; ++i) {
    const std::byte* const base = section(format::kRoles, i);
    const auto& header = *at<format::RoleHeader>(base, 0);
    if (header.skeleton != of_skeleton) continue;
    const format::RoleLayout l = layout(header);
    return {l.roles.in(base), l.pairs.in(base), l.soles.in(base)};
  }
  return {};
}

ClipMotion view_motion(const format::MotionHeader& header, float duration_s) {
  const format::MotionLayout l = layout(header);
  ClipMotion out;
  out.duration_s = duration_s;
  out.speed_m_s = header.speed_m_s;
  std::memcpy(out.heading, header.heading, sizeof out.heading);
  out.events = l.events.in(&header);
  out.phase_marks = l.marks.in(&header);
  out.root = l.root.in(&header);
  return out;
}

ClipMotion File::motion(std::uint32_t of_clip) const {
  if (of_clip >= clip_count()) return {};
  const float duration_s = clip(of_clip).duration_s;
  for (std::uint32_t i = 0; i < counts_[format::kMotions]; ++i) {
    const auto& header = *at<format::MotionHeader>(section(format::kMotions, i), 0);
    if (header.clip == of_clip) return view_motion(header, duration_s);
  }
  ClipMotion none;
  none.duration_s = duration_s;
  return none;
}

std::uint32_t File::find_event(const ClipMotion& motion, const char* name) const {
  std::uint32_t i = 0;
  while (i < motion.events.size && !is_called(text(motion.events[i].name), name)) ++i;
  return i;
}

PoseMap File::pose_map(std::uint32_t index) const {
  PoseMap m;
  if (index >= pose_map_count()) return m;
  const std::byte* const base = section(format::kPoseMaps, index);
  const auto& header = *at<format::PoseMapHeader>(base, 0);
  const format::PoseMapLayout l = layout(header);
  m.name = text(header.name);
  m.skeleton = header.skeleton;
  m.rig_joint_count = header.rig_joint_count;
  m.rig_hash = header.rig_hash;
  m.groups = l.groups.in(base);
  m.turns = l.turns.in(base);
  m.places = l.places.in(base);
  m.steps = l.steps.in(base);
  return m;
}

std::uint32_t File::find_pose_map(const char* name) const {
  std::uint32_t i = 0;
  while (i < pose_map_count() && !is_called(pose_map(i).name, name)) ++i;
  return i;
}

Bounds decode_bounds(const format::BoundsCodes& codes) {
  const float step = bit_cast<float>(static_cast<std::uint32_t>(codes.exponent + 127) << 23);
  Bounds out;
  for (int c = 0; c < 3; ++c) {
    out.box_min[c] = static_cast<float>(codes.box_min[c]) * step;
    out.box_max[c] = static_cast<float>(codes.box_max[c]) * step;
  }
  out.radius_m = static_cast<float>(codes.radius) * step;
  return out;
}

Bounds File::bounds(std::uint32_t clip, std::uint32_t mesh) const {
  if (clip >= clip_count() || mesh >= mesh_count()) return {};
  const auto skeleton_of_mesh = [&](std::uint32_t m) {
    return at<format::MeshHeader>(section(format::kMeshes, m), 0)->skeleton;
  };
  const auto skeleton_of_clip = [&](std::uint32_t c) {
    return at<format::ClipHeader>(section(format::kClips, c), 0)->skeleton;
  };
  const std::uint32_t skeleton = skeleton_of_mesh(mesh);
  if (skeleton_of_clip(clip) != skeleton) return {};
  for (std::uint32_t i = 0; i < counts_[format::kBounds]; ++i) {
    const std::byte* const base = section(format::kBounds, i);
    const auto& header = *at<format::BoundsHeader>(base, 0);
    if (header.skeleton != skeleton) continue;
    std::uint32_t row = 0, column = 0;
    for (std::uint32_t c = 0; c < clip; ++c) row += skeleton_of_clip(c) == skeleton;
    for (std::uint32_t m = 0; m < mesh; ++m) column += skeleton_of_mesh(m) == skeleton;
    if (row >= header.clip_count || column >= header.mesh_count) return {};
    return decode_bounds(layout(header).codes.in(base)[std::size_t{row} * header.mesh_count + column]);
  }
  return {};
}

std::uint32_t File::find_clip(const char* name) const {
  std::uint32_t i = 0;
  while (i < clip_count() && !is_called(clip(i).name, name)) ++i;
  return i;
}

std::uint32_t File::find_node(const char* name) const {
  std::uint32_t i = 0;
  while (i < node_count() && !is_called(node(i).name, name)) ++i;
  return i;
}

const Property* File::node_property(const Node& node, const char* name) const {
  for (const Property& p : node.properties)
    if (is_called(text(p.name), name)) return &p;
  return nullptr;
}

std::uint32_t File::find_channel(const Clip& clip, const char* name) const {
  std::uint32_t i = 0;
  while (i < clip.channels.size && !is_called(text(clip.channels[i].name), name)) ++i;
  return i;
}

}  // namespace marrow
