// glTF documents as texts, with their numbers in them, and what reading makes of them as facts.
#pragma once

#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "unit/cook/facts.h"
#include "unit/cook/gltf/document.h"

namespace marrow::cook {

// Adds what "f32x3 0 0 0  1 0 0" says, and gives its number: an accessor, or a view without a "x". Types are i8, u8,
// i16, u16, u32 and f32, times 1, 2, 3, 4 or 16; an "n" behind: normalised, a "b": with bounds; "/8" behind a view's:
// its stride. "0.5*16" is sixteen times that.
inline int numbers_of(Builder& b, const std::string& text, bool bounds = false) {
  std::istringstream words(text);
  std::string type, word;
  words >> type;
  const std::size_t end = type.find_first_of("x/"), stride = type.find('/');
  const bool is_view = type.find('x') == std::string::npos;
  const std::size_t count = is_view ? 1 : std::stoul(type.substr(end + 1));
  std::vector<double> values;
  while (words >> word) {
    const std::size_t star = word.find('*'), times = star < word.size() ? std::stoul(word.substr(star + 1)) : 1;
    values.insert(values.end(), times, std::strtod(word.c_str(), nullptr));
  }
  Json extra = Json::object();
  if (stride < type.size()) extra["byteStride"] = std::stoi(type.substr(stride + 1));
  if (type.back() == 'n') extra["normalized"] = true;
  for (std::size_t i = 0; (bounds || type.back() == 'b') && i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    const auto value = static_cast<double>(static_cast<float>(values[i]));
    Json &low = extra["min"][i % count], &high = extra["max"][i % count];
    low = low.is_null() ? value : std::min(low.get<double>(), value);
    high = high.is_null() ? value : std::max(high.get<double>(), value);
  }
  const std::map<std::size_t, const char*> types = {{1, "SCALAR"}, {2, "VEC2"}, {3, "VEC3"}, {4, "VEC4"}, {16, "MAT4"}};
  const auto add = [&]<class T>(int component, T) {
    std::vector<T> as;
    for (const double v : values) as.push_back(static_cast<T>(v));
    return is_view ? b.view(as, extra) : b.numbers<T>(component, types.at(count), count, as, extra);
  };
  const std::string component = type.substr(0, end);
  if (component == "i8") return add(kI8, std::int8_t{});
  if (component == "u8") return add(kU8, std::uint8_t{});
  if (component == "i16") return add(kI16, std::int16_t{});
  if (component == "u16") return add(kU16, std::uint16_t{});
  if (component == "u32") return add(kU32, std::uint32_t{});
  EXPECT_EQ(component, "f32") << text;
  return add(kF32, float{});
}

// "=f32x3 0 0 0": the number of what such a text adds, which is made once.
inline void add_numbers(Builder& b, Json& value, std::map<std::string, int>& made, const std::string& key = "") {
  if (value.is_object()) {
    for (const auto& [name, member] : value.items()) add_numbers(b, member, made, name);
  } else if (value.is_array()) {
    for (Json& item : value) add_numbers(b, item, made, key);
  } else if (value.is_string() && value.get<std::string>().starts_with("=")) {
    const std::string text = value;
    if (!made.contains(text)) made[text] = numbers_of(b, text.substr(1), key == "POSITION" || key == "input");
    value = made[text];
  }
}

// The document of a text, without what all have: the version, a scene of node 0, and that node. Texts in "accessors"
// are such as numbers_of() takes; elsewhere one with a "=" in front stands for the number of such an accessor or view.
inline Builder document_of(const std::string& text) {
  Builder b;
  Json given = Json::parse("{" + text + "}");
  const Json accessors = given.contains("accessors") ? given["accessors"] : Json::array();
  given.erase("accessors");
  for (const Json& accessor : accessors) numbers_of(b, accessor.get<std::string>());
  std::map<std::string, int> made;
  add_numbers(b, given, made);
  for (const auto& [name, value] : given.items()) b.root[name] = value;
  return b;
}

// "wave: turn 4, carry 5 0 0.5 1; nod: turn 2": clips that turn nodes about Z or carry them along x, there and back,
// with keys at these seconds or at 0 and 1.
inline Json clips_of(const std::string& text) {
  Json out = Json::array();
  std::istringstream clips(text);
  for (std::string clip; std::getline(clips, clip, ';');) {
    const std::size_t begin = clip.find_first_not_of(' '), colon = clip.find(':');
    Json channels = Json::array(), samplers = Json::array();
    std::istringstream parts(clip.substr(colon + 1));
    for (std::string part; std::getline(parts, part, ',');) {
      std::istringstream words(part);
      std::string how, times, time, keys;
      std::size_t node = 0, count = 0;
      for (words >> how >> node; words >> time; ++count) times += " " + time;
      if (count == 0) times = " 0 1", count = 2;
      const bool turns = how == "turn";
      for (std::size_t i = 0; i < count; ++i) {
        const std::string y = std::to_string(0.125 * static_cast<double>(i));
        keys += turns ? (i % 2 == 0 ? " 0 0 0 1" : " 0 0 .28 .96") : (i % 2 == 0 ? " 0 " : " 1 ") + y + " 0";
      }
      channels.push_back(
          {{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", turns ? "rotation" : "translation"}}}});
      samplers.push_back({{"input", "=f32x1" + times}, {"output", (turns ? "=f32x4" : "=f32x3") + keys}});
    }
    out.push_back({{"name", clip.substr(begin, colon - begin)}, {"channels", channels}, {"samplers", samplers}});
  }
  return out;
}

// "/clips" stands for animations, see clips_of().
// What a change says of buffers is said of the whole document, which then gets no more numbers.
inline Builder changed(Builder b, const std::string& change) {
  if (change.find("\"/buffers") != std::string::npos) {
    b.root = Json::parse(b.text());
    b.is_whole = true;
  }
  change_json(b.root, change);
  if (b.root.contains("clips")) {
    b.root["animations"] = clips_of(b.root["clips"]);
    b.root.erase("clips");
  }
  std::map<std::string, int> made;
  Json root = b.root;
  add_numbers(b, root, made);
  for (const char* list : {"accessors", "bufferViews"}) {
    if (!b.root.contains(list) || !b.root[list].is_array()) continue;
    for (std::size_t i = root[list].size(); i < b.root[list].size(); ++i) root[list].push_back(b.root[list][i]);
  }
  b.root = root;
  return b;
}

// A triangle: its only accessor are the positions.
inline const char* const kTriangle = R"("nodes": [{"mesh": 0}], "accessors": ["f32x3b 0 0 0 1 1 0 2 4 0"],
                                        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}])";

template <class V>
Json list_of(const V& v) {
  Json out = Json::array();
  for (int i = 0; i < v.length(); ++i) out.push_back(v[i]);
  return out;
}
inline Json list_of(const glm::dquat& q) {
  return {q.x, q.y, q.z, q.w};
}
template <class V>
Json lists_of(const std::vector<V>& all) {
  Json out = Json::array();
  for (const V& v : all) out.push_back(list_of(v));
  return out;
}

inline Json facts_of(const RawNode& n) {
  Json extras = Json::object();
  for (const RawProperty& p : n.extras) extras[p.name] = p.type == PropertyType::text ? Json(p.text) : Json(p.number);
  return {{"name", n.name},
          {"parent", n.parent},
          {"translation", list_of(n.translation)},
          {"rotation", list_of(n.rotation)},
          {"scale", list_of(n.scale)},
          {"in_scene", n.in_scene},
          {"limited", n.limit.has_value()},
          {"extras", extras}};
}
inline Json facts_of(const RawTarget& t) {
  return {{"positions", lists_of(t.positions)}, {"normals", lists_of(t.normals)}, {"tangents", lists_of(t.tangents)}};
}
// "influences": a list a vertex, of pairs of joint and weight.
inline Json facts_of(const RawPrimitive& p) {
  Json influences = Json::array(), targets = Json::array();
  for (const auto& vertex : p.influences) {
    influences.push_back(Json::array());
    for (const RawInfluence& i : vertex) influences.back().push_back({i.joint, i.weight});
  }
  for (const RawTarget& t : p.targets) targets.push_back(facts_of(t));
  return {{"pointer", p.pointer},           {"positions", lists_of(p.positions)},
          {"normals", lists_of(p.normals)}, {"tangents", lists_of(p.tangents)},
          {"uvs", lists_of(p.uvs)},         {"colours", lists_of(p.colours)},
          {"influences", influences},       {"targets", targets},
          {"indices", p.indices},           {"material", p.material}};
}
inline Json facts_of(const std::vector<RawTargetWeight>& all) {
  Json out = Json::array();
  for (const RawTargetWeight& w : all) out.push_back({{"target", w.target}, {"channel", w.channel}, {"rest", w.rest}});
  return out;
}
inline const char* name_of(RawInterpolation i) {
  return i == RawInterpolation::step ? "step" : i == RawInterpolation::linear ? "linear" : "cubic";
}
inline Json facts_of(const RawClip& clip) {
  Json channels = Json::array(), scalars = Json::array();
  for (const RawChannel& c : clip.channels)
    channels.push_back({{"node", c.node},
                        {"path", c.path == RawPath::translation ? "translation"
                                 : c.path == RawPath::rotation  ? "rotation"
                                                                : "scale"},
                        {"interpolation", name_of(c.interpolation)},
                        {"times_s", c.times_s},
                        {"values", lists_of(c.values)}});
  for (const RawScalar& s : clip.scalars)
    scalars.push_back({{"name", s.name},
                       {"node", s.node},
                       {"rest", s.rest},
                       {"interpolation", name_of(s.interpolation)},
                       {"times_s", s.times_s},
                       {"values", s.values}});
  return {{"name", clip.name}, {"channels", channels}, {"scalars", scalars}};
}
// Of textures what the runtime's enumerations say, as numbers.
inline Json facts_of(const RawMaterial& m) {
  Json textures = Json::array();
  for (const Texture& t : m.textures)
    textures.push_back(
        {{"role", t.role}, {"image", t.image}, {"wrap", {t.wrap_u, t.wrap_v}}, {"mag", t.mag}, {"min", t.min}});
  return {{"name", m.name},   {"base_colour", list_of(m.base_colour)}, {"double_sided", m.double_sided},
          {"alpha", m.alpha}, {"alpha_cutoff", m.alpha_cutoff},        {"textures", textures}};
}

inline std::vector<std::string> texts_of(const std::vector<RawWarning>& warnings) {
  std::vector<std::string> out;
  for (const RawWarning& w : warnings) out.push_back(w.rule + " " + w.pointer);
  return out;
}

// "drawn" are nodes with a mesh, "moved" those that clips move, "said" all warnings' texts by their rules.
inline Json facts_of(const RawScene& scene) {
  Json out = {{"source_bytes", scene.source_bytes},
              {"draws_elsewhere", scene.draws_elsewhere},
              {"warnings", texts_of(scene.warnings)},
              {"nodes", Json::array()},
              {"meshes", Json::array()},
              {"skins", Json::array()},
              {"materials", Json::array()},
              {"instances", Json::array()},
              {"clips", Json::array()},
              {"drawn", Json::array()},
              {"moved", Json::array()},
              {"said", Json::object()}};
  for (const RawNode& n : scene.nodes) out["nodes"].push_back(facts_of(n));
  for (const RawMesh& m : scene.meshes) {
    out["meshes"].push_back({{"name", m.name}, {"primitives", Json::array()}});
    for (const RawPrimitive& p : m.primitives) out["meshes"].back()["primitives"].push_back(facts_of(p));
  }
  for (const RawSkin& s : scene.skins) {
    out["skins"].push_back({{"joints", s.joints}, {"inverse_bind", Json::array()}});
    for (const glm::dmat4& m : s.inverse_bind)
      out["skins"].back()["inverse_bind"].push_back({list_of(m[0]), list_of(m[1]), list_of(m[2]), list_of(m[3])});
  }
  for (const RawMaterial& m : scene.materials) out["materials"].push_back(facts_of(m));
  for (const RawInstance& i : scene.instances) {
    out["instances"].push_back(
        {{"node", i.node}, {"mesh", i.mesh}, {"skin", i.skin}, {"weights", facts_of(i.weights)}});
    out["drawn"].push_back(i.node);
  }
  for (const RawClip& c : scene.clips) {
    out["clips"].push_back(facts_of(c));
    for (const RawChannel& channel : c.channels) out["moved"].push_back(channel.node);
  }
  for (const RawWarning& w : scene.warnings) out["said"].emplace(w.rule, w.text);
  return out;
}

// Each row's change to the document is read.
inline void expect_rows(const Builder& document, std::initializer_list<Row> rows, const ReadOptions& options = {}) {
  for (const Row& row : rows) {
    SCOPED_TRACE(std::string(row.name) + ": " + row.change);
    expect_outcome([&] { return facts_of(read_text(changed(document, row.change).text(), options)); }, row.facts);
  }
}
inline void expect_rows(const std::string& document, std::initializer_list<Row> rows) {
  expect_rows(document_of(document), rows);
}

}  // namespace marrow::cook
