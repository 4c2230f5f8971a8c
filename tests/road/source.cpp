// Reads glTF for the reference evaluator, straight from the specification: JSON, buffers, accessors, Draco.
#include "road/source.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>

#include <draco/compression/decode.h>
#include <nlohmann/json.hpp>

namespace marrow::test {
namespace {

using Json = nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

Bytes read_bytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  return Bytes(std::istreambuf_iterator<char>(in), {});
}

Bytes from_base64(const std::string& text) {
  Bytes out;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    unsigned v = 0;
    if (c >= 'A' && c <= 'Z')
      v = static_cast<unsigned>(c - 'A');
    else if (c >= 'a' && c <= 'z')
      v = static_cast<unsigned>(c - 'a') + 26;
    else if (c >= '0' && c <= '9')
      v = static_cast<unsigned>(c - '0') + 52;
    else if (c == '+')
      v = 62;
    else if (c == '/')
      v = 63;
    else
      break;
    bits = (bits << 6 | v) & 0xFFFFFF;
    if ((count += 6) >= 8) out.push_back(static_cast<std::uint8_t>(bits >> (count -= 8) & 0xFF));
  }
  return out;
}

template <class T>
T load_as(const std::uint8_t* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

// One component as glTF 2.0 section 3.11 turns it into a number.
double component(const std::uint8_t* at, int type, bool normalised) {
  switch (type) {
    case 5120:
      return normalised ? std::max(load_as<std::int8_t>(at) / 127.0, -1.0) : load_as<std::int8_t>(at);
    case 5121:
      return normalised ? *at / 255.0 : *at;
    case 5122:
      return normalised ? std::max(load_as<std::int16_t>(at) / 32767.0, -1.0) : load_as<std::int16_t>(at);
    case 5123:
      return normalised ? load_as<std::uint16_t>(at) / 65535.0 : load_as<std::uint16_t>(at);
    case 5125:
      return load_as<std::uint32_t>(at);
    default:
      return static_cast<double>(load_as<float>(at));
  }
}

std::size_t component_bytes(int type) {
  return type <= 5121 ? 1 : type <= 5123 ? 2 : 4;
}

struct Reader {
  Json json;
  std::vector<Bytes> buffers;

  explicit Reader(const std::filesystem::path& path);
  explicit Reader(Json text) : json(std::move(text)) { read_buffers({}, {}); }
  void read_buffers(const std::filesystem::path& folder, const Bytes& glb_bin);
  const std::uint8_t* view(const Json& view_json, std::size_t offset) const {
    return buffers.at(view_json.at("buffer").get<std::size_t>()).data() +
           view_json.value("byteOffset", std::size_t{0}) + offset;
  }
  std::vector<double> accessor(std::size_t index, std::size_t& components) const;
  std::vector<Vec3> vectors(std::size_t index) const;
  Map matrix(const double* column_major) const;
  SourceNode node(const Json& j) const;
  SourcePrimitive primitive(const Json& j) const;
  SourcePrimitive draco_primitive(const Json& j) const;
  std::vector<SourceTarget> targets(const Json& j) const;
  SourceSkin skin(const Json& j) const;
  SourceAnimation animation(const Json& j) const;
  std::vector<SourceWeight> weights(const Json& sampler, std::size_t node_index) const;
};

Reader::Reader(const std::filesystem::path& path) {
  const Bytes file = read_bytes(path);
  Bytes glb_bin;
  if (file.size() > 20 && std::memcmp(file.data(), "glTF", 4) == 0) {
    const std::size_t json_bytes = load_as<std::uint32_t>(file.data() + 12);
    json = Json::parse(file.data() + 20, file.data() + 20 + json_bytes);
    const std::size_t bin = 20 + json_bytes;
    if (bin + 8 <= file.size()) {
      const std::size_t bin_bytes = load_as<std::uint32_t>(file.data() + bin);
      const auto first = file.begin() + static_cast<std::ptrdiff_t>(bin + 8);
      glb_bin.assign(first, first + static_cast<std::ptrdiff_t>(bin_bytes));
    }
  } else {
    json = Json::parse(file.begin(), file.end());
  }
  read_buffers(path.parent_path(), glb_bin);
}

void Reader::read_buffers(const std::filesystem::path& folder, const Bytes& glb_bin) {
  for (const Json& buffer : json.value("buffers", Json::array())) {
    const std::string uri = buffer.value("uri", "");
    if (uri.empty())
      buffers.push_back(glb_bin);
    else if (uri.rfind("data:", 0) == 0)
      buffers.push_back(from_base64(uri.substr(uri.find(',') + 1)));
    else
      buffers.push_back(read_bytes(folder / uri));
  }
}

std::vector<double> Reader::accessor(std::size_t index, std::size_t& components) const {
  static const std::map<std::string, std::size_t> kComponents = {
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
  const Json& a = json.at("accessors").at(index);
  components = kComponents.at(a.at("type").get<std::string>());
  const int type = a.at("componentType").get<int>();
  const bool normalised = a.value("normalized", false);
  const std::size_t count = a.at("count").get<std::size_t>(), size = component_bytes(type);
  std::vector<double> out(count * components, 0.0);
  static const Json kNoViews = Json::array();
  const Json& views = json.contains("bufferViews") ? json["bufferViews"] : kNoViews;  // value() would copy
  if (a.contains("bufferView")) {
    const Json& v = views.at(a["bufferView"].get<std::size_t>());
    const std::size_t stride = v.value("byteStride", size * components);
    const std::uint8_t* base = view(v, a.value("byteOffset", std::size_t{0}));
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = component(base + i / components * stride + i % components * size, type, normalised);
    }
  }
  if (a.contains("sparse")) {
    const Json &s = a["sparse"], &si = s.at("indices"), &sv = s.at("values");
    const int index_type = si.at("componentType").get<int>();
    const std::uint8_t* where =
        view(views.at(si.at("bufferView").get<std::size_t>()), si.value("byteOffset", std::size_t{0}));
    const std::uint8_t* what =
        view(views.at(sv.at("bufferView").get<std::size_t>()), sv.value("byteOffset", std::size_t{0}));
    for (std::size_t i = 0; i < s.at("count").get<std::size_t>(); ++i) {
      const auto target =
          static_cast<std::size_t>(component(where + i * component_bytes(index_type), index_type, false));
      for (std::size_t c = 0; c < components; ++c) {
        out.at(target * components + c) = component(what + (i * components + c) * size, type, normalised);
      }
    }
  }
  return out;
}

std::vector<Vec3> Reader::vectors(std::size_t index) const {
  std::size_t n = 0;
  const std::vector<double> flat = accessor(index, n);
  std::vector<Vec3> out(flat.size() / n);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = {flat[i * n], flat[i * n + 1], flat[i * n + 2]};
  return out;
}

Map Reader::matrix(const double* column_major) const {
  Map m;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) m.rows[r][c] = column_major[c * 4 + r];
  return m;
}

SourceNode Reader::node(const Json& j) const {
  SourceNode n;
  if (j.contains("matrix")) {
    n.has_matrix = true;
    n.matrix = matrix(j["matrix"].get<std::array<double, 16>>().data());
  }
  n.translation = j.value("translation", n.translation);
  n.rotation = normalised(j.value("rotation", n.rotation));
  n.scale = j.value("scale", n.scale);
  n.name = j.value("name", "");
  n.mesh = j.value("mesh", -1);
  n.skin = j.value("skin", -1);
  if (n.mesh >= 0) {
    const Json& mesh = json.at("meshes").at(static_cast<std::size_t>(n.mesh));
    const std::size_t count = mesh.at("primitives").at(0).value("targets", Json::array()).size();
    n.weights = j.value("weights", mesh.value("weights", std::vector<double>(count)));
  }
  return n;
}

// Adds one JOINTS/WEIGHTS set; `joints` and `weights` hold four a vertex.
void add_influences(SourcePrimitive& p, const std::vector<double>& joints, const std::vector<double>& weights) {
  p.influences.resize(joints.size() / 4);
  for (std::size_t i = 0; i < joints.size(); ++i)
    p.influences[i / 4].push_back({static_cast<int>(joints[i]), weights.at(i)});
}

SourcePrimitive Reader::primitive(const Json& j) const {
  if (j.value("/extensions/KHR_draco_mesh_compression"_json_pointer, Json()).is_object()) return draco_primitive(j);
  SourcePrimitive p;
  const Json& attributes = j.at("attributes");
  p.positions = vectors(attributes.at("POSITION").get<std::size_t>());
  if (attributes.contains("NORMAL")) p.normals = vectors(attributes["NORMAL"].get<std::size_t>());
  if (attributes.contains("TANGENT")) {
    std::size_t n = 0;
    p.tangents = vectors(attributes["TANGENT"].get<std::size_t>());
    const std::vector<double> flat = accessor(attributes["TANGENT"].get<std::size_t>(), n);
    for (std::size_t i = 3; i < flat.size(); i += 4) p.tangent_signs.push_back(flat[i]);
  }
  for (int set = 0; attributes.contains("JOINTS_" + std::to_string(set)); ++set) {
    std::size_t n = 0;
    const auto joints = accessor(attributes["JOINTS_" + std::to_string(set)].get<std::size_t>(), n);
    add_influences(p, joints, accessor(attributes.at("WEIGHTS_" + std::to_string(set)).get<std::size_t>(), n));
  }
  p.targets = targets(j);
  return p;
}

std::vector<SourceTarget> Reader::targets(const Json& j) const {
  std::vector<SourceTarget> out;
  for (const Json& target : j.value("targets", Json::array())) {
    const auto changes = [&](const char* name) {
      return target.contains(name) ? vectors(target[name].get<std::size_t>()) : std::vector<Vec3>();
    };
    out.push_back({changes("POSITION"), changes("NORMAL"), changes("TANGENT")});
  }
  return out;
}

SourcePrimitive Reader::draco_primitive(const Json& j) const {
  const Json& extension = j.at("extensions").at("KHR_draco_mesh_compression");
  const Json& v = json.at("bufferViews").at(extension.at("bufferView").get<std::size_t>());
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(view(v, 0)), v.at("byteLength").get<std::size_t>());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) throw std::runtime_error("Draco: " + decoded.status().error_msg_string());
  const draco::Mesh& mesh = *decoded.value();
  const auto values = [&](const char* name) {
    std::vector<double> out;
    if (!extension.at("attributes").contains(name)) return out;
    const auto* attribute = mesh.GetAttributeByUniqueId(extension["attributes"][name].get<std::uint32_t>());
    for (draco::PointIndex i(0); i < mesh.num_points(); ++i) {
      double value[4] = {};
      const int components = attribute->num_components();
      attribute->ConvertValue<double>(attribute->mapped_index(i), static_cast<std::int8_t>(components), value);
      out.insert(out.end(), value, value + components);
    }
    return out;
  };
  SourcePrimitive p;
  const std::vector<double> positions = values("POSITION"), normals = values("NORMAL");
  for (std::size_t i = 0; i + 2 < positions.size(); i += 3)
    p.positions.push_back({positions[i], positions[i + 1], positions[i + 2]});
  for (std::size_t i = 0; i + 2 < normals.size(); i += 3)
    p.normals.push_back({normals[i], normals[i + 1], normals[i + 2]});
  const std::vector<double> joints = values("JOINTS_0");
  if (!joints.empty()) add_influences(p, joints, values("WEIGHTS_0"));
  p.targets = targets(j);
  return p;
}

SourceSkin Reader::skin(const Json& j) const {
  SourceSkin s;
  s.joints = j.at("joints").get<std::vector<int>>();
  s.inverse_bind.resize(s.joints.size());
  if (!j.contains("inverseBindMatrices")) return s;
  std::size_t n = 0;
  const std::vector<double> flat = accessor(j["inverseBindMatrices"].get<std::size_t>(), n);
  for (std::size_t i = 0; i < s.joints.size(); ++i) s.inverse_bind[i] = matrix(flat.data() + i * 16);
  return s;
}

// One channel of glTF holds the weights of all targets: for a spline first all in-tangents of a key, then all values,
// then all out-tangents.
std::vector<SourceWeight> Reader::weights(const Json& sampler, std::size_t node_index) const {
  const Json& node = json.at("nodes").at(node_index);
  const Json& mesh = json.at("meshes").at(node.at("mesh").get<std::size_t>());
  const std::size_t count = mesh.at("primitives").at(0).at("targets").size();
  const Json names = mesh.value("extras", Json::object()).value("targetNames", Json::array());
  const Json rest = node.contains("weights") ? node.at("weights") : mesh.value("weights", Json::array());
  const std::string number = std::to_string(node_index);
  std::size_t n = 0;
  const std::vector<double> flat = accessor(sampler.at("output").get<std::size_t>(), n);
  std::vector<SourceWeight> out(count);
  for (std::size_t t = 0; t < count; ++t) {
    out[t].name = node.value("name", "nodes[" + number + "]") + "." +
                  (t < names.size() ? names[t].get<std::string>() : "weights[" + std::to_string(t) + "]");
    out[t].rest = t < rest.size() ? rest[t].get<double>() : 0.0;
    out[t].target = t;
    out[t].channel.node = static_cast<int>(node_index);
    out[t].channel.interpolation = sampler.value("interpolation", "LINEAR");
    out[t].channel.times_s = accessor(sampler.at("input").get<std::size_t>(), n);
    for (std::size_t i = t; i < flat.size(); i += count) out[t].channel.values.push_back({flat[i], 0, 0, 0});
  }
  return out;
}

SourceAnimation Reader::animation(const Json& j) const {
  SourceAnimation a;
  a.name = j.value("name", "");
  for (const Json& channel : j.at("channels")) {
    const Json& target = channel.at("target");
    SourceChannel c;
    c.path = target.at("path").get<std::string>();
    c.node = target.value("node", -1);
    if (c.node >= 0 && c.path == "weights") {
      for (SourceWeight& w :
           weights(j.at("samplers").at(channel.at("sampler").get<std::size_t>()), static_cast<std::size_t>(c.node)))
        a.weights.push_back(std::move(w));
    }
    if (c.node < 0 || (c.path != "translation" && c.path != "rotation" && c.path != "scale")) continue;
    const Json& sampler = j.at("samplers").at(channel.at("sampler").get<std::size_t>());
    c.interpolation = sampler.value("interpolation", "LINEAR");
    std::size_t n = 0;
    c.times_s = accessor(sampler.at("input").get<std::size_t>(), n);
    const std::vector<double> flat = accessor(sampler.at("output").get<std::size_t>(), n);
    c.values.resize(flat.size() / n, Quat{0, 0, 0, 0});
    for (std::size_t i = 0; i < flat.size(); ++i) c.values[i / n][i % n] = flat[i];
    a.channels.push_back(std::move(c));
  }
  return a;
}

void mark_in_scene(std::vector<SourceNode>& nodes, const Json& json) {
  const Json& list = json.value("nodes", Json::array());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const int child : list[i].value("children", std::vector<int>{}))
      nodes[static_cast<std::size_t>(child)].parent = static_cast<int>(i);
  }
  const Json& scenes = json.value("scenes", Json::array());
  std::vector<int> todo;
  if (scenes.empty()) {
    for (std::size_t i = 0; i < nodes.size(); ++i) todo.push_back(static_cast<int>(i));
  } else {
    todo = scenes.at(json.value("scene", std::size_t{0})).value("nodes", std::vector<int>{});
  }
  while (!todo.empty()) {
    const auto n = static_cast<std::size_t>(todo.back());
    todo.pop_back();
    nodes[n].in_scene = true;
    for (const int child : list[n].value("children", std::vector<int>{})) todo.push_back(child);
  }
}

Source source_of(const Reader& reader) {
  const Json& json = reader.json;
  Source source;
  for (const Json& j : json.value("nodes", Json::array())) source.nodes.push_back(reader.node(j));
  mark_in_scene(source.nodes, json);
  for (const Json& mesh : json.value("meshes", Json::array())) {
    auto& primitives = source.meshes.emplace_back();
    for (const Json& j : mesh.at("primitives")) {
      if (j.value("mode", 4) >= 4 && j.at("attributes").contains("POSITION")) primitives.push_back(reader.primitive(j));
    }
  }
  for (const Json& j : json.value("skins", Json::array())) source.skins.push_back(reader.skin(j));
  for (const Json& j : json.value("animations", Json::array())) source.animations.push_back(reader.animation(j));
  return source;
}

}  // namespace

Source read_source(const std::string& path) {
  return source_of(Reader{std::filesystem::path(path)});
}

Source read_source_text(const std::string& json) {
  return source_of(Reader{Json::parse(json)});
}

}  // namespace marrow::test
