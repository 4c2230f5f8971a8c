#include "cook/write.h"

#include <cstring>
#include <map>

#include "common/aligned_bytes.h"
#include "common/failure.h"

namespace marrow::cook {
namespace {

// Bytes of one section in the making.
class Section {
 public:
  template <class T>
  void add(const T& value) {
    add_bytes(&value, sizeof value);
  }
  template <class T>
  void add_all(const std::vector<T>& values) {
    add_bytes(values.data(), values.size() * sizeof(T));
  }
  const std::vector<std::byte>& bytes() const { return bytes_; }
  std::uint32_t codec = format::kCodecRaw;

 private:
  void add_bytes(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  std::vector<std::byte> bytes_;
};

// Zero-terminated names, each once; the empty one first.
class Names {
 public:
  Names() { add(""); }
  std::uint32_t add(const std::string& name) {
    const std::string text = name.substr(0, name.find('\0'));
    const auto [at, is_new] = offsets_.try_emplace(text, static_cast<std::uint32_t>(pool_.size()));
    if (is_new) pool_.insert(pool_.end(), text.c_str(), text.c_str() + text.size() + 1);
    return at->second;
  }
  const std::vector<char>& pool() const { return pool_; }

 private:
  std::map<std::string, std::uint32_t> offsets_;
  std::vector<char> pool_;
};

Section write_skeleton(const BuiltSkeleton& s, Names& names) {
  Section out;
  const auto joints = static_cast<std::uint32_t>(s.parents.size());
  out.add(format::SkeletonHeader{names.add(s.name), joints, static_cast<std::uint32_t>(s.scene_from_root.size()), 0});
  out.add_all(s.scene_from_root);
  out.add_all(s.rest);
  for (const std::string& name : s.joint_names) out.add(names.add(name));
  out.add_all(s.parents);
  return out;
}

void add_coded(const BuiltCoded& coded, Section& out) {
  out.codec = format::kCodecSegments;
  out.add(coded.header);
  out.add_all(coded.offsets);
  out.add_all(coded.masks);
  out.add_all(coded.constants);
  out.add_all(coded.payload);
}

Section write_clip(const BuiltClip& c, Names& names) {
  Section out;
  out.add(format::ClipHeader{names.add(c.name), 0, c.duration_s, static_cast<std::uint32_t>(c.tracks.size()),
                             static_cast<std::uint32_t>(c.times_s.size()), static_cast<std::uint32_t>(c.values.size()),
                             static_cast<std::uint32_t>(c.channels.size()),
                             static_cast<std::uint16_t>(c.additive.empty() ? 0 : 1),
                             static_cast<std::uint16_t>(c.reference.size())});
  out.add_all(c.reference);
  out.add_all(c.tracks);
  for (std::size_t i = 0; i < c.channels.size(); ++i) {
    Channel channel = c.channels[i];
    channel.name = names.add(c.channel_names[i]);
    out.add(channel);
  }
  out.add_all(c.times_s);
  out.add_all(c.values);
  if (c.coded.header.frame_count > 0) add_coded(c.coded, out);
  return out;
}

Section write_geometry(const BuiltGeometry& g) {
  Section out;
  out.add(g.header);
  out.add_all(g.skin);
  out.add_all(g.normals);
  out.add_all(g.tangents);
  out.add_all(g.as_residual);
  out.add_all(g.uvs);
  out.add_all(g.colours);
  out.add_all(g.runs);
  out.add_all(g.source_slots);
  const bool wide = layout(g.header).index_bytes == 4;
  for (const std::uint32_t i : g.indices) wide ? out.add(i) : out.add(static_cast<std::uint16_t>(i));
  out.add_all(g.sets);
  return out;
}

Section write_mesh(const BuiltMesh& m, Names& names) {
  Section out;
  format::MeshHeader h{};
  h.name = names.add(m.name);
  h.material = names.add(m.material);
  h.geometry = m.geometry;
  h.joint_count = static_cast<std::uint32_t>(m.joints.size());
  h.material_section = m.material_section;
  h.flags = m.double_sided ? format::kDoubleSided : 0u;
  std::memcpy(h.base_colour, m.base_colour, sizeof h.base_colour);
  out.add(h);
  out.add_all(m.inverse_bind);
  out.add_all(m.joints);
  return out;
}

Section write_material(const BuiltMaterial& m, Names& names) {
  Section out;
  out.add(format::MaterialHeader{names.add(m.name), m.alpha_cutoff, m.alpha,
                                 static_cast<std::uint8_t>(m.textures.size()), 0});
  out.add_all(m.textures);
  return out;
}

Section write_image(const RawImage& i, Names& names) {
  Section out;
  out.add(format::ImageHeader{
      names.add(i.name), names.add(i.uri), static_cast<std::uint32_t>(i.bytes.size()), i.format, {}});
  out.add_all(i.bytes);
  return out;
}

Section write_node(const BuiltNode& n, Names& names) {
  Section out;
  out.add(format::NodeHeader{names.add(n.name), n.skeleton, static_cast<std::uint32_t>(n.properties.size()), n.joint, 0,
                             n.joint_from_node});
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
    out.add(p);
  }
  return out;
}

std::vector<std::byte> assemble(const std::vector<std::pair<format::Kind, Section>>& sections,
                                const std::string& source) {
  std::vector<File::Section> table;
  std::uint64_t end = sizeof(format::Header) + sections.size() * sizeof(File::Section);
  for (const auto& [kind, section] : sections) {
    const std::uint64_t offset = format::align16(end);
    end = offset + section.bytes().size();
    if (end > UINT32_MAX)
      throw tools::Failure(tools::Exit::unsupported, source, "", "too-large", "a cooked file holds at most 4 GiB");
    table.push_back({format::kTypes[kind], static_cast<std::uint32_t>(offset),
                     static_cast<std::uint32_t>(section.bytes().size()), section.codec});
  }
  std::vector<std::byte> bytes(end);
  format::Header h{format::kMagic,
                   format::kVersion,
                   static_cast<std::uint32_t>(end),
                   static_cast<std::uint32_t>(table.size()),
                   0,
                   0};
  std::memcpy(bytes.data() + sizeof h, table.data(), table.size() * sizeof(File::Section));
  for (std::size_t i = 0; i < sections.size(); ++i)
    std::memcpy(bytes.data() + table[i].offset, sections[i].second.bytes().data(), table[i].bytes);
  h.checksum = format::checksum(bytes.data() + sizeof h, bytes.size() - sizeof h);
  std::memcpy(bytes.data(), &h, sizeof h);
  return bytes;
}

}  // namespace

WrittenFile write_scene(const BuiltScene& scene, const std::string& source) {
  Names names;
  WrittenFile out;
  std::vector<std::pair<format::Kind, Section>> sections;
  sections.emplace_back(format::kSkeletons, write_skeleton(scene.skeleton, names));
  for (const BuiltClip& clip : scene.clips) {
    sections.emplace_back(format::kClips, write_clip(clip, names));
    out.clip_bytes.push_back(sections.back().second.bytes().size());
  }
  for (const BuiltGeometry& geometry : scene.geometries) {
    sections.emplace_back(format::kGeometries, write_geometry(geometry));
    out.geometry_bytes.push_back(sections.back().second.bytes().size());
  }
  for (const BuiltMesh& mesh : scene.meshes) {
    sections.emplace_back(format::kMeshes, write_mesh(mesh, names));
    out.mesh_bytes.push_back(sections.back().second.bytes().size());
  }
  for (const BuiltMaterial& material : scene.materials)
    sections.emplace_back(format::kMaterials, write_material(material, names));
  for (const RawImage& image : scene.images) sections.emplace_back(format::kImages, write_image(image, names));
  for (const BuiltNode& node : scene.nodes) sections.emplace_back(format::kNodes, write_node(node, names));
  Section pool;
  pool.add_all(names.pool());
  sections.emplace_back(format::kNames, std::move(pool));
  out.bytes = assemble(sections, source);

  const tools::AlignedBytes block{std::span<const std::byte>(out.bytes)};
  File loaded;
  DataError error;
  if (load({block.data(), block.size()}, loaded, &error) != Status::ok)
    throw tools::Failure(tools::Exit::internal, source, "@" + std::to_string(error.offset), to_string(error.status),
                         error.rule);
  return out;
}

}  // namespace marrow::cook
