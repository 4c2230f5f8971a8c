#include "commands/info/details.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "asset/format.h"
#include "behave/find_graph.h"
#include "marrow/roles.h"
#include "text/printable.h"
#include "text/quantity.h"
#include "text/words.h"

namespace marrow::tools {
namespace {

using nlohmann::ordered_json;

ordered_json describe_parameter(const File& file, const GraphParameter& p) {
  const char* const name = file.text(p.name);
  switch (p.kind) {
    case ParameterKind::number:
      return {{"name", name},
              {"type", "number"},
              {"range", {p.least, p.most}},
              {"initial", p.initial},
              {"half_life_s", p.seconds}};
    case ParameterKind::flag:
      return {{"name", name}, {"type", "flag"}, {"initial", p.initial > 0.5f}};
    case ParameterKind::trigger:
      break;
  }
  return {{"name", name}, {"type", "trigger"}, {"hold_s", p.seconds}};
}

ordered_json describe_graph(const File& file, const Graph& graph, std::size_t bytes) {
  ordered_json parameters = ordered_json::array(), clips = ordered_json::array();
  for (const GraphParameter& p : graph.parameters) parameters.push_back(describe_parameter(file, p));
  std::set<std::string> there, wanted;
  for (std::uint32_t c = 0; c < file.clip_count(); ++c) there.insert(file.clip(c).name);
  for (const GraphClip& clip : graph.clips) {
    const std::string name = file.text(clip.name);
    if (wanted.insert(name).second) clips.push_back({{"name", name}, {"in_file", there.contains(name)}});
  }
  return {{"name", graph.name},
          {"bytes", bytes},
          {"nodes", graph.nodes.size},
          {"parameters", parameters},
          {"clips", clips}};
}

std::string number(const ordered_json& value) {
  return plain_number(value.get<double>());
}

void print_parameter(const ordered_json& p, std::size_t width) {
  const std::string type = p["type"].get<std::string>();
  std::string words = type;
  if (type == "number") {
    words +=
        fmt::format(" from {} to {}, {} at first", number(p["range"][0]), number(p["range"][1]), number(p["initial"]));
    if (p["half_life_s"] != 0.0) words += fmt::format(", half of the way in {} s", number(p["half_life_s"]));
  } else if (type == "flag") {
    words += p["initial"].get<bool>() ? ", set at first" : "";
  } else if (p["hold_s"] != 0.0) {
    words += fmt::format(", waits {} s", number(p["hold_s"]));
  }
  fmt::print("  {:<{}}  {}\n", printable(p["name"].get<std::string>()), width, words);
}

// As JSON has it, so that whatever a file says, it stays on its line.
std::string quoted(const ordered_json& value) {
  return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

ordered_json value_of(const File& file, const Property& p) {
  if (p.type == PropertyType::text) return file.text(p.text);
  if (p.type == PropertyType::boolean) return p.number != 0;
  return p.number;
}

bool emits(const Material& m) {
  return m.emissive[0] > 0 || m.emissive[1] > 0 || m.emissive[2] > 0;
}

constexpr double kDegree = 3.14159265358979323846 / 180;

// Where the root is at the end, from where it was at the start.
ordered_json describe_root(const ClipMotion& motion) {
  if (motion.root.empty()) return nullptr;
  const RootKey& end = motion.root[motion.root.size - 1];
  const auto turn = 2 * std::atan2(static_cast<double>(end.rotation[1]), static_cast<double>(end.rotation[3]));
  return {{"keys", motion.root.size},
          {"end_m", {end.translation[0], end.translation[1], end.translation[2]}},
          {"end_turn_deg", std::remainder(turn / kDegree, 360.0)}};
}

// To a millimetre, and 0 without a sign.
std::string place(const ordered_json& at) {
  const auto number = [&](std::size_t axis) { return std::round(at[axis].get<double>() * 1000) / 1000 + 0.0; };
  return fmt::format("{:.3f} {:.3f} {:.3f}", number(0), number(1), number(2));
}

std::string seconds(const ordered_json& time) {
  return fmt::format("{:.3f}", time.get<double>());
}

void print_events(const ordered_json& events) {
  std::size_t width = 0;
  for (const ordered_json& e : events) width = std::max(width, e["name"].get<std::string>().size());
  for (const ordered_json& e : events) {
    const bool is_moment = e["from_s"] == e["until_s"];
    const std::string number = e["number"] == 0.0 ? "" : ", " + plain_number(e["number"].get<double>());
    fmt::print("  {:<{}}  {}{} s{}\n", e["name"].get<std::string>(), width, seconds(e["from_s"]),
               is_moment ? "" : " … " + seconds(e["until_s"]), number);
  }
}

void print_motion(const ordered_json& clip) {
  const ordered_json& motion = clip["motion"];
  fmt::print("clip \"{}\": {} s{}\n", clip["name"].get<std::string>(), seconds(clip["duration_s"]),
             summary_of_motion(motion));
  if (!motion["heading"].is_null()) fmt::print("  heads for {}\n", place(motion["heading"]));
  if (!motion["root"].is_null())
    fmt::print("  root: {} keys, ends at {} m, turned by {:.1f}°\n", motion["root"]["keys"].get<std::size_t>(),
               place(motion["root"]["end_m"]), motion["root"]["end_turn_deg"].get<double>());
  if (!motion["phase_marks"].empty()) {
    std::vector<std::string> marks;
    for (const ordered_json& mark : motion["phase_marks"]) marks.push_back(seconds(mark));
    fmt::print("  phase marks: {} s\n", fmt::join(marks, ", "));
  }
  print_events(motion["events"]);
}

}  // namespace

void describe_graphs(const std::string& path, const LoadedFile& loaded, ordered_json& description) {
  std::vector<std::size_t> bytes;
  for (const File::Section& s : loaded.stored)
    if (s.type == format::kTypes[format::kGraphs]) bytes.push_back(s.bytes);
  ordered_json graphs = ordered_json::array();
  for (const Graph& graph : graphs_of(path, loaded.file))
    graphs.push_back(describe_graph(loaded.file, graph, bytes.at(graphs.size())));
  description["graphs"] = graphs;
}

void print_graphs(const ordered_json& description) {
  for (const ordered_json& g : description["graphs"]) {
    fmt::print("graph \"{}\": {} bytes, {} nodes\n", printable(g["name"].get<std::string>()),
               g["bytes"].get<std::size_t>(), g["nodes"].get<std::size_t>());
    std::size_t width = 0;
    for (const ordered_json& p : g["parameters"])
      width = std::max(width, printable(p["name"].get<std::string>()).size());
    for (const ordered_json& p : g["parameters"]) print_parameter(p, width);
    std::vector<std::string> there, elsewhere;
    for (const ordered_json& clip : g["clips"])
      (clip["in_file"].get<bool>() ? there : elsewhere).push_back(printable(clip["name"].get<std::string>()));
    if (!there.empty()) fmt::print("  clips: {}\n", fmt::join(there, ", "));
    if (!elsewhere.empty()) fmt::print("  clips of other files: {}\n", fmt::join(elsewhere, ", "));
  }
}

void describe_looks(const File& file, ordered_json& r) {
  r["materials"] = ordered_json::array();
  for (std::uint32_t i = 0; i < file.material_count(); ++i) {
    const Material m = file.material(i);
    ordered_json textures = ordered_json::array();
    for (const Texture& t : m.textures) textures.push_back({{"role", word(t.role)}, {"image", t.image}});
    r["materials"].push_back({{"name", m.name}, {"alpha", word(m.alpha)}, {"textures", textures}});
    if (m.alpha == AlphaMode::mask) r["materials"].back()["alpha_cutoff"] = m.alpha_cutoff;
    if (m.unlit) r["materials"].back()["unlit"] = true;
    if (emits(m)) r["materials"].back()["emissive"] = m.emissive;
  }
  r["images"] = ordered_json::array();
  for (std::uint32_t i = 0; i < file.image_count(); ++i) {
    const Image image = file.image(i);
    r["images"].push_back({{"name", image.name},
                           {"uri", image.uri},
                           {"format", word(image.format)},
                           {"embedded_bytes", image.bytes.size}});
    if (image.fallback != kNoImage) r["images"].back()["fallback"] = image.fallback;
  }
}

void describe_nodes(const File& file, ordered_json& r) {
  r["nodes"] = ordered_json::array();
  for (std::uint32_t i = 0; i < file.node_count(); ++i) {
    const Node n = file.node(i);
    ordered_json properties = ordered_json::array();
    for (const Property& p : n.properties)
      properties.push_back({{"name", file.text(p.name)}, {"value", value_of(file, p)}});
    const bool has_joint = n.joint != kNoJoint;
    r["nodes"].push_back({{"name", n.name},
                          {"skeleton", n.skeleton},
                          {"joint", has_joint ? ordered_json(n.joint) : ordered_json()},
                          {"joint_name", has_joint ? file.text(file.skeleton(n.skeleton).names[n.joint]) : ""},
                          {"properties", properties}});
  }
}

void print_looks(const ordered_json& r) {
  for (std::size_t i = 0; i < r["materials"].size(); ++i) {
    const auto& m = r["materials"][i];
    fmt::print("material {} {}: {}", i, quoted(m["name"]), m["alpha"].get<std::string>());
    for (const auto& t : m["textures"])
      fmt::print(", {} image {}", t["role"].get<std::string>(), t["image"].get<int>());
    if (m.contains("unlit")) fmt::print(", unlit");
    if (m.contains("emissive"))
      fmt::print(", emits {} {} {}", plain_number(m["emissive"][0]), plain_number(m["emissive"][1]),
                 plain_number(m["emissive"][2]));
    fmt::print("\n");
  }
  for (std::size_t i = 0; i < r["images"].size(); ++i) {
    const auto& image = r["images"][i];
    const auto bytes = image["embedded_bytes"].get<std::size_t>();
    fmt::print("image {} {}: {}, {}", i, quoted(image["name"]), image["format"].get<std::string>(),
               bytes > 0 ? std::to_string(bytes) + " bytes" : "by reference, " + quoted(image["uri"]));
    if (image.contains("fallback")) fmt::print(", fallback image {}", image["fallback"].get<int>());
    fmt::print("\n");
  }
}

void print_nodes(const ordered_json& r) {
  for (std::size_t i = 0; i < r["nodes"].size(); ++i) {
    const auto& n = r["nodes"][i];
    fmt::print("node {} {}: {}\n", i, quoted(n["name"]),
               n["joint"].is_null() ? "fixed in the scene" : "on joint " + quoted(n["joint_name"]));
    for (const auto& p : n["properties"]) fmt::print("  {} = {}\n", quoted(p["name"]), quoted(p["value"]));
  }
}

ordered_json describe_roles(const File& file, std::uint32_t skeleton) {
  const Roles roles = file.roles(skeleton);
  const Skeleton of = file.skeleton(skeleton);
  const auto name = [&](std::uint16_t joint) { return file.text(of.names[joint]); };
  ordered_json found = ordered_json::array(), missing = ordered_json::array(), pairs = ordered_json::array(),
               soles = ordered_json::array();
  for (std::uint32_t r = 1; r < kRoleCount && !roles.roles.empty(); ++r) {
    const auto role = static_cast<Role>(r);
    if (joint_of(roles, role) == kNoJoint && role != Role::tail) missing.push_back(role_name(role));
    for (const JointRole& j : roles.roles)
      if (j.role == role) found.push_back({{"role", role_name(role)}, {"joint", name(j.joint)}});
  }
  for (const JointPair& p : roles.pairs) pairs.push_back({name(p.left), name(p.right)});
  for (const JointSole& s : roles.soles)
    soles.push_back({{"joint", name(s.joint)}, {"place", {s.place[0], s.place[1], s.place[2]}}});
  return {{"roles", found}, {"missing", missing}, {"pairs", pairs}, {"soles", soles}};
}

std::string summary_of_roles(const ordered_json& roles) {
  if (roles["roles"].empty()) return "";
  return fmt::format("{} joints with roles, {} pairs, {} soles", roles["roles"].size(), roles["pairs"].size(),
                     roles["soles"].size());
}

void print_roles(const ordered_json& description) {
  for (const ordered_json& skeleton : description["skeletons"]) {
    const ordered_json& roles = skeleton["roles"];
    const std::string summary = summary_of_roles(roles);
    fmt::print("skeleton \"{}\": {}\n", skeleton["name"].get<std::string>(),
               summary.empty() ? "no joints with roles" : summary);
    std::size_t width = 0;
    for (const ordered_json& r : roles["roles"]) width = std::max(width, r["role"].get<std::string>().size());
    for (const ordered_json& r : roles["roles"])
      fmt::print("  {:<{}}  {}\n", r["role"].get<std::string>(), width, r["joint"].get<std::string>());
    if (!roles["missing"].empty())
      fmt::print("  missing: {}\n", fmt::join(roles["missing"].get<std::vector<std::string>>(), ", "));
    for (const ordered_json& p : roles["pairs"])
      fmt::print("  pair {} | {}\n", p[0].get<std::string>(), p[1].get<std::string>());
    for (const ordered_json& s : roles["soles"])
      fmt::print("  sole of {} at {} {} {}, in its space\n", s["joint"].get<std::string>(),
                 plain_number(s["place"][0].get<double>()), plain_number(s["place"][1].get<double>()),
                 plain_number(s["place"][2].get<double>()));
  }
}

ordered_json describe_motion(const File& file, const ClipMotion& motion) {
  ordered_json events = ordered_json::array(), marks = ordered_json::array(), speed, heading;
  for (const ClipEvent& e : motion.events)
    events.push_back({{"name", file.text(e.name)}, {"from_s", e.time_s}, {"until_s", e.until_s}, {"number", e.number}});
  for (const float mark : motion.phase_marks) marks.push_back(mark);
  if (motion.speed_m_s > 0) {
    speed = motion.speed_m_s;
    heading = {motion.heading[0], motion.heading[1], motion.heading[2]};
  }
  return {{"speed_m_s", speed},
          {"heading", heading},
          {"events", events},
          {"phase_marks", marks},
          {"root", describe_root(motion)}};
}

std::string summary_of_motion(const ordered_json& motion) {
  std::string out;
  if (!motion["speed_m_s"].is_null()) out = fmt::format(", moves at {:.3g} m/s", motion["speed_m_s"].get<double>());
  const std::size_t count = motion["events"].size();
  if (count > 0) out += fmt::format(", {} event{}", count, count == 1 ? "" : "s");
  return out;
}

void print_motions(const ordered_json& description) {
  for (const ordered_json& clip : description["clips"]) print_motion(clip);
}

}  // namespace marrow::tools
