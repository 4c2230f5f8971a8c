#include "cook/write/write_scene.h"

#include <algorithm>
#include <cstring>
#include <deque>

#include "asset/sections/examples_section.h"
#include "asset/skeleton_hash.h"
#include "common/aligned_bytes.h"
#include "common/failure.h"
#include "common/unpack_mrw.h"
#include "cook/geometry/record.h"
#include "cook/write/bounds_packer.h"
#include "cook/write/clip_packer.h"
#include "cook/write/compact.h"
#include "cook/write/measure_bounds.h"
#include "cook/write/names.h"
#include "cook/write/section_bytes.h"
#include "cook/write/write_graph.h"

namespace marrow::cook {
namespace {

Section write_skeleton(const BuiltSkeleton& s, Names& names) {
  Section out;
  const auto joints = static_cast<std::uint32_t>(s.parents.size());
  std::uint32_t name = 0;
  const std::uint32_t name_code = names.add_in_turn(s.name, name);
  const auto l =
      out.begin(format::SkeletonHeader{name, joints, static_cast<std::uint32_t>(s.model_from_root.size()), 0});
  std::vector<std::uint32_t> codes, joint_names;
  for (const std::string& joint : s.joint_names) {
    codes.push_back(names.add_in_turn(joint, name));
    joint_names.push_back(name);
  }
  out.set(l.roots, s.model_from_root);
  out.set(l.rest, s.rest);
  out.set(l.names, joint_names);
  out.set(l.parents, s.parents);
  out.compact = compact_skeleton(s, name_code, codes);
  return out;
}

Section write_reference(const BuiltSkeleton& s, Names& names) {
  Section out;
  Fnv64 hash;
  std::vector<std::uint32_t> rest_hashes, joint_names;
  for (std::size_t j = 0; j < s.parents.size(); ++j) {
    add_joint(hash, s.joint_names[j].c_str(), s.parents[j], s.rest.data(), j);
    rest_hashes.push_back(rest_hash(s.rest.data(), j));
  }
  const auto l =
      out.begin(format::ReferenceHeader{names.add(s.name), static_cast<std::uint32_t>(s.parents.size()), hash.value()});
  for (const std::string& name : s.joint_names) joint_names.push_back(names.add(name));
  out.set(l.names, joint_names);
  out.set(l.rest_hashes, rest_hashes);
  out.set(l.parents, s.parents);
  return out;
}

void add_coded(const BuiltCoded& coded, std::uint64_t start, std::size_t joint_count, Section& out) {
  out.codec = format::kCodecSegments;
  const auto l = out.begin(coded.header, layout(coded.header, start, static_cast<std::uint32_t>(joint_count)));
  out.set(l.times, coded.times_s);
  out.set(l.offsets, coded.offsets);
  out.set(l.masks, coded.masks);
  out.set(l.constants, coded.constants);
  out.set(l.payload, coded.payload);
}

Section write_clip(const BuiltClip& c, std::size_t joint_count, Names& names, ClipPacker& packer) {
  Section out;
  const auto l = out.begin(format::ClipHeader{
      names.add(c.name), c.skeleton, c.duration_s, static_cast<std::uint32_t>(c.tracks.size()),
      static_cast<std::uint32_t>(c.times_s.size()), static_cast<std::uint32_t>(c.values.size()),
      static_cast<std::uint32_t>(c.channels.size()), static_cast<std::uint16_t>(c.additive.empty() ? 0 : 1),
      static_cast<std::uint16_t>(c.reference.size())});
  std::vector<Channel> channels = c.channels;
  for (std::size_t i = 0; i < channels.size(); ++i) channels[i].name = names.add(c.channel_names[i]);
  out.set(l.reference, c.reference);
  out.set(l.tracks, c.tracks);
  out.set(l.channels, channels);
  out.set(l.times, c.times_s);
  out.set(l.values, c.values);
  if (c.coded.header.frame_count > 0) add_coded(c.coded, l.bytes, joint_count, out);
  out.compact = packer.pack(out.bytes(), out.codec, joint_count);
  return out;
}

Section write_mesh(const BuiltMesh& m, Names& names) {
  Section out;
  format::MeshHeader h{};
  h.name = names.add(m.name);
  h.material = names.add(m.material);
  h.skeleton = m.skeleton;
  h.geometry = m.geometry;
  h.joint_count = static_cast<std::uint32_t>(m.joints.size());
  h.material_section = m.material_section;
  h.flags =
      static_cast<std::uint8_t>((m.double_sided ? format::kDoubleSided : 0u) | (m.part > 0 ? format::kNextPart : 0u) |
                                (m.helper_centres.empty() ? 0u : format::kHelpersHaveCentres));
  h.lod_count = static_cast<std::uint8_t>(m.lods.size());
  h.helper_count = static_cast<std::uint16_t>(m.helpers.size());
  std::memcpy(h.base_colour, m.base_colour, sizeof h.base_colour);
  h.target_count = static_cast<std::uint32_t>(m.targets.size());
  std::vector<MeshTarget> targets;
  for (const RawTargetWeight& t : m.targets) targets.push_back({names.add(t.target), names.add(t.channel), t.rest});
  std::vector<MeshLod> lods;
  for (const BuiltLod& lod : m.lods) lods.push_back({lod.geometry, static_cast<float>(lod.max_error_m)});
  const auto l = out.begin(h);
  out.set(l.inverse_bind, m.inverse_bind);
  out.set(l.targets, targets);
  out.set(l.joints, m.joints);
  out.set(l.helpers, m.helpers);
  out.set(l.centres, m.helper_centres);
  out.set(l.lods, lods);
  if (!m.bind_is_given.empty()) out.compact = compact_mesh(m, h, targets);
  return out;
}

Section write_material(const BuiltMaterial& m, Names& names) {
  Section out;
  const bool emits = m.emissive != glm::vec3(0);
  std::uint16_t flags = 0;
  if (m.unlit) flags |= format::kUnlit;
  if (emits) flags |= format::kEmits;
  const auto l = out.begin(format::MaterialHeader{names.add(m.name), m.alpha_cutoff, m.alpha,
                                                  static_cast<std::uint8_t>(m.textures.size()), flags});
  out.set(l.textures, m.textures);
  if (emits) out.set(l.emissive, std::vector<float>{m.emissive.x, m.emissive.y, m.emissive.z});
  return out;
}

Section write_image(const RawImage& i, Names& names) {
  Section out;
  const auto l =
      out.begin(format::ImageHeader{names.add(i.name), names.add(i.uri), static_cast<std::uint32_t>(i.bytes.size()),
                                    i.format, 0, static_cast<std::uint16_t>(i.fallback + 1)});
  out.set(l.data, i.bytes);
  return out;
}

Section write_node(const BuiltNode& n, Names& names) {
  Section out;
  std::vector<Property> properties;
  const auto l = out.begin(format::NodeHeader{
      names.add(n.name), n.skeleton, static_cast<std::uint32_t>(n.properties.size()), n.joint, 0, n.joint_from_node});
  for (const RawProperty& raw : n.properties) {
    Property p{};
    p.name = names.add(raw.name);
    p.type = raw.type;
    p.number = 0;  // all eight bytes
    if (raw.type == PropertyType::text) {
      p.text = names.add(raw.text);
    } else {
      p.number = raw.number;
    }
    properties.push_back(p);
  }
  out.set(l.properties, properties);
  return out;
}

Section write_limits(const BuiltSkeleton& s, std::uint32_t skeleton) {
  Section out;
  const auto l = out.begin(format::LimitHeader{skeleton, static_cast<std::uint32_t>(s.limits.size())});
  out.set(l.limits, s.limits);
  return out;
}

Section write_springs(const BuiltSprings& s, std::uint32_t skeleton) {
  Section out;
  const auto l = out.begin(format::SpringHeader{skeleton, static_cast<std::uint32_t>(s.chains.size()),
                                                static_cast<std::uint32_t>(s.joints.size()),
                                                static_cast<std::uint32_t>(s.colliders.size())});
  out.set(l.chains, s.chains);
  out.set(l.joints, s.joints);
  out.set(l.colliders, s.colliders);
  return out;
}

Section write_roles(const BuiltRoles& r, std::uint32_t skeleton) {
  Section out;
  const auto l = out.begin(format::RoleHeader{skeleton, static_cast<std::uint16_t>(r.roles.size()),
                                              static_cast<std::uint16_t>(r.pairs.size()),
                                              static_cast<std::uint16_t>(r.soles.size()), 0});
  out.set(l.roles, r.roles);
  out.set(l.pairs, r.pairs);
  out.set(l.soles, r.soles);
  return out;
}

// Whether anything is known of a clip.
bool moves(const BuiltMotion& m) {
  return m.speed_m_s > 0 || !m.root.empty() || !m.events.empty() || !m.marks.empty();
}

Section write_motion(const BuiltMotion& m, std::uint32_t clip, Names& names) {
  Section out;
  format::MotionHeader h{clip, m.speed_m_s, {}, 0, 0, 0};
  std::memcpy(h.heading, m.heading, sizeof h.heading);
  h.root_count = static_cast<std::uint32_t>(m.root.size());
  h.event_count = static_cast<std::uint32_t>(m.events.size());
  h.mark_count = static_cast<std::uint32_t>(m.marks.size());
  std::vector<ClipEvent> events;
  for (const BuiltEvent& e : m.events) events.push_back({e.time_s, e.until_s, names.add(e.name), e.number});
  const auto l = out.begin(h);
  out.set(l.root, m.root);
  out.set(l.events, events);
  out.set(l.marks, m.marks);
  return out;
}

Section write_pose_map(const BuiltPoseMap& m, Names& names) {
  Section out;
  const auto l = out.begin(
      format::PoseMapHeader{names.add(m.name), m.skeleton, m.rig_hash, static_cast<std::uint16_t>(m.rig_joint_count),
                            static_cast<std::uint16_t>(m.groups.size()), static_cast<std::uint32_t>(m.turns.size()),
                            static_cast<std::uint32_t>(m.places.size()), static_cast<std::uint32_t>(m.steps.size())});
  out.set(l.groups, m.groups);
  out.set(l.turns, m.turns);
  out.set(l.places, m.places);
  out.set(l.steps, m.steps);
  return out;
}

Section write_example_space(const BuiltExampleSpace& e, Names& names) {
  Section out;
  const auto l = out.begin(format::ExampleHeader{
      names.add(e.name), static_cast<std::uint32_t>(e.meshes.size()), static_cast<std::uint16_t>(e.parameters.size()),
      static_cast<std::uint16_t>(e.inverse_widths.size()), static_cast<std::uint16_t>(e.targets.size()), 0});
  std::vector<ExampleParameter> parameters;
  for (std::size_t p = 0; p < e.parameters.size(); ++p) parameters.push_back({names.add(e.parameters[p]), e.rests[p]});
  out.set(l.linear, e.linear);
  out.set(l.radial, e.radial);
  out.set(l.places, e.places);
  out.set(l.widths, e.inverse_widths);
  out.set(l.parameters, parameters);
  out.set(l.targets, e.targets);
  out.set(l.meshes, e.meshes);
  return out;
}

constexpr std::size_t kLeastSaved = 8;

Section write_bounds(const MeasuredBounds& b) {
  Section out;
  const auto l = out.begin(b.header);
  out.set(l.codes, b.codes);
  out.compact = pack_bounds(b);
  // What is hardly smaller takes more than itself where files are compressed once more.
  if (out.compact.size() + kLeastSaved > out.bytes().size()) out.compact.clear();
  return out;
}

// A section on its way: what the runtime sees, and what a packed file has instead.
struct Entry {
  format::Kind kind;
  std::uint32_t codec;
  std::span<const std::byte> section;
  std::uint32_t record_codec;
  std::span<const std::byte> record;
};

std::uint32_t checked_size(std::uint64_t bytes, const std::string& source) {
  if (bytes > UINT32_MAX)
    throw tools::Failure(tools::Exit::unsupported, source, "", "too-large", "a cooked file holds at most 4 GiB");
  return static_cast<std::uint32_t>(bytes);
}

std::uint32_t file_size(const std::vector<Entry>& entries, const std::string& source) {
  std::uint64_t end = sizeof(format::Header) + entries.size() * sizeof(File::Section);
  for (const Entry& e : entries) end = format::align16(end) + e.section.size();
  return checked_size(end, source);
}

std::vector<std::byte> write_plain(const std::vector<Entry>& entries, const std::string& source) {
  std::vector<std::byte> bytes(file_size(entries, source));
  format::Header h{format::kMagic,
                   format::kVersion,
                   static_cast<std::uint32_t>(bytes.size()),
                   static_cast<std::uint32_t>(entries.size()),
                   0,
                   0};
  std::uint64_t end = sizeof h + entries.size() * sizeof(File::Section);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::uint64_t offset = format::align16(end);
    const File::Section s{format::kTypes[entries[i].kind], static_cast<std::uint32_t>(offset),
                          static_cast<std::uint32_t>(entries[i].section.size()), entries[i].codec};
    std::memcpy(bytes.data() + sizeof h + i * sizeof s, &s, sizeof s);
    std::memcpy(bytes.data() + offset, entries[i].section.data(), s.bytes);
    end = offset + s.bytes;
  }
  h.checksum = format::checksum(bytes.data() + sizeof h, bytes.size() - sizeof h);
  std::memcpy(bytes.data(), &h, sizeof h);
  return bytes;
}

std::vector<std::byte> write_packed(const std::vector<Entry>& entries, std::uint64_t scratch_bytes,
                                    const std::string& source) {
  packed::Header h{packed::kMagic,
                   packed::kVersion,
                   0,
                   file_size(entries, source),
                   0,
                   static_cast<std::uint32_t>(entries.size()),
                   0};
  h.memory_bytes = checked_size(format::align16(h.file_bytes) + format::align16(scratch_bytes), source);
  std::vector<std::byte> bytes(sizeof h);
  for (const Entry& e : entries) {
    bytes.push_back(static_cast<std::byte>(e.kind));
    bytes.push_back(static_cast<std::byte>(e.record_codec));
    add_varint(checked_size(e.record.size(), source), bytes);
    bytes.insert(bytes.end(), e.record.begin(), e.record.end());
  }
  h.packed_bytes = checked_size(bytes.size(), source);
  h.checksum = format::checksum(bytes.data() + sizeof h, bytes.size() - sizeof h);
  std::memcpy(bytes.data(), &h, sizeof h);
  return bytes;
}

void check(const tools::AlignedBytes& file, const std::string& source) {
  const auto fail = [&](const DataError& error) {
    throw tools::Failure(tools::Exit::internal, source, "@" + std::to_string(error.offset), to_string(error.status),
                         error.rule);
  };
  File loaded;
  DataError error;
  if (load({file.data(), file.size()}, loaded, &error) != Status::ok) fail(error);
  ExampleSpace space;
  for (std::uint32_t i = 0; i < loaded.example_space_count(); ++i)
    if (loaded.example_space(i, space, &error) != Status::ok) fail(error);
  Graph graph;
  for (std::uint32_t i = 0; i < loaded.graph_count(); ++i)
    if (loaded.graph(i, graph, &error) != Status::ok) fail(error);
}

// A packed file must unpack to the plain one.
void check_packed(const WrittenFile& written, const std::string& source) {
  const tools::AlignedBytes file = tools::unpacked(written.bytes, source);
  if (file.size() != written.plain.size() || std::memcmp(file.data(), written.plain.data(), file.size()) != 0)
    throw tools::Failure(tools::Exit::internal, source, "", "packed-file", "the file does not unpack to itself");
}

bool has_records(const BuiltScene& scene) {
  return std::any_of(scene.geometries.begin(), scene.geometries.end(),
                     [](const BuiltGeometry& g) { return g.codec != 0; }) ||
         (scene.packs_clips && std::any_of(scene.clips.begin(), scene.clips.end(),
                                           [](const BuiltClip& c) { return c.coded.header.frame_count > 0; }));
}

// A scene's sections in the order of a file, and what is known of them.
class SceneWriter {
 public:
  SceneWriter(const BuiltScene& scene, WrittenFile& out) : scene_(scene), out_(out), is_packed_(has_records(scene)) {}

  void add_all(const std::string& source) {
    for (const BuiltSkeleton& skeleton : scene_.skeletons) add_skeleton(skeleton);
    add_clips();
    for (const BuiltGeometry& geometry : scene_.geometries) add_geometry(geometry);
    for (const BuiltMesh& mesh : scene_.meshes)
      out_.mesh_bytes.push_back(add(format::kMeshes, write_mesh(mesh, names_)));
    for (const BuiltMaterial& material : scene_.materials) add(format::kMaterials, write_material(material, names_));
    for (const RawImage& image : scene_.images) add(format::kImages, write_image(image, names_));
    for (const BuiltNode& node : scene_.nodes) add(format::kNodes, write_node(node, names_));
    if (!scene_.is_pack) add_limits_springs_and_roles();
    for (std::size_t c = 0; c < scene_.clips.size(); ++c)
      if (const BuiltMotion& m = scene_.clips[c].motion; moves(m))
        add(format::kMotions, write_motion(m, static_cast<std::uint32_t>(c), names_));
    for (const BuiltPoseMap& map : scene_.pose_maps) add(format::kPoseMaps, write_pose_map(map, names_));
    for (const BuiltExampleSpace& space : scene_.example_spaces)
      add(format::kExamples, write_example_space(space, names_));
    for (const BuiltGraph& graph : scene_.graphs) add(format::kGraphs, write_graph(graph, names_));
    add_names();
    // Poses of an outfit are its body's.
    if (!scene_.is_outfit) add_bounds(source);
  }

  const std::vector<Entry>& entries() const { return entries_; }
  bool is_packed() const { return is_packed_; }
  std::uint64_t scratch_bytes() const { return scratch_bytes_; }

 private:
  Entry entry_of(format::Kind kind, const Section& section) const {
    const bool compact = is_packed_ && !section.compact.empty();
    return {kind, section.codec, section.bytes(), compact ? std::uint32_t{packed::kCompact} : section.codec,
            compact ? section.compact : section.bytes()};
  }
  std::size_t add(format::Kind kind, Section section) {
    entries_.push_back(entry_of(kind, sections_.emplace_back(std::move(section))));
    return entries_.back().record.size();
  }
  void need_scratch(std::uint64_t bytes) { scratch_bytes_ = std::max(scratch_bytes_, bytes); }

  void add_skeleton(const BuiltSkeleton& skeleton) {
    scene_.is_pack ? add(format::kReferences, write_reference(skeleton, names_))
                   : add(format::kSkeletons, write_skeleton(skeleton, names_));
    need_scratch(compact_scratch_bytes(skeleton));
  }
  void add_clips() {
    ClipPacker packer;
    for (const BuiltClip& clip : scene_.clips) {
      out_.clip_bytes.push_back(
          add(format::kClips, write_clip(clip, scene_.skeletons[clip.skeleton].parents.size(), names_, packer)));
      out_.clip_memory_bytes.push_back(entries_.back().section.size());
    }
    need_scratch(packer.scratch_bytes());
  }
  void add_geometry(const BuiltGeometry& g) {
    const std::span<const std::byte> section(g.section.data(), g.section.size());
    const bool has_record = g.codec != 0;
    entries_.push_back({format::kGeometries, format::kCodecRaw, section, g.codec,
                        has_record ? std::span<const std::byte>(g.record) : section});
    out_.geometry_bytes.push_back(entries_.back().record.size());
    need_scratch(g.scratch_bytes);
  }
  void add_limits_springs_and_roles() {
    const auto count = static_cast<std::uint32_t>(scene_.skeletons.size());
    for (std::uint32_t s = 0; s < count; ++s)
      if (!scene_.skeletons[s].limits.empty()) add(format::kLimits, write_limits(scene_.skeletons[s], s));
    for (std::uint32_t s = 0; s < count; ++s)
      if (!scene_.skeletons[s].springs.chains.empty())
        add(format::kSprings, write_springs(scene_.skeletons[s].springs, s));
    for (std::uint32_t s = 0; s < count; ++s)
      if (!scene_.skeletons[s].roles.roles.empty()) add(format::kRoles, write_roles(scene_.skeletons[s].roles, s));
  }
  void add_names() {
    Section pool(names_.pool());
    pool.compact = compact_names(names_.pool());
    add(format::kNames, std::move(pool));
  }
  // What the file without them shows; before the names.
  void add_bounds(const std::string& source) {
    const Entry names = entries_.back();
    const std::vector<MeasuredBounds> bounds = measure_bounds(tools::AlignedBytes(write_plain(entries_, source)));
    entries_.pop_back();
    for (const MeasuredBounds& b : bounds) add(format::kBounds, write_bounds(b));
    entries_.push_back(names);
  }

  const BuiltScene& scene_;
  WrittenFile& out_;
  bool is_packed_;
  Names names_;
  std::deque<Section> sections_;  // their bytes stay where they are
  std::vector<Entry> entries_;
  std::uint64_t scratch_bytes_ = 0;
};

}  // namespace

WrittenFile write_scene(const BuiltScene& scene, const std::string& source) {
  WrittenFile out;
  SceneWriter writer(scene, out);
  writer.add_all(source);
  const std::vector<Entry>& entries = writer.entries();
  out.bytes = writer.is_packed() ? write_packed(entries, writer.scratch_bytes(), source) : write_plain(entries, source);
  for (const Entry& e : entries)
    out.sections.push_back({format::kTypes[e.kind], static_cast<std::uint32_t>(e.record.size())});
  out.plain = tools::AlignedBytes(writer.is_packed() ? write_plain(entries, source) : out.bytes);
  check(out.plain, source);
  if (writer.is_packed()) check_packed(out, source);
  return out;
}

}  // namespace marrow::cook
