// `marrow info`: what cooked files hold.
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "commands/arguments.h"
#include "commands/command.h"
#include "commands/info/describe.h"
#include "commands/info/details.h"
#include "common/failure.h"
#include "text/quantity.h"

namespace marrow::tools {
namespace {

struct InfoArguments {
  std::vector<std::string> in;
  std::string source;  // the glTF file that one was cooked from, to show its bytes beside; may be empty
  bool json = false;
  bool roles = false;   // those of joints alone
  bool motion = false;  // of clips alone
};

using nlohmann::ordered_json;

struct Line {
  std::string label, bytes, source, words;
};

std::string text(const ordered_json& value) {
  return value.get<std::string>();
}

std::string size_of(const ordered_json& value) {
  return fmt::format("{} B", value.get<std::size_t>());
}

// How large all that the clip's meshes reach is, together: ", reaches 0.8 × 1.9 × 1.2".
std::string reach_of(const ordered_json& clip) {
  if (clip["bounds"].empty()) return "";
  double size[3];
  for (std::size_t c = 0; c < 3; ++c) {
    double least = clip["bounds"][0]["box_min"][c], most = clip["bounds"][0]["box_max"][c];
    for (const ordered_json& b : clip["bounds"]) {
      least = std::min(least, b["box_min"][c].get<double>());
      most = std::max(most, b["box_max"][c].get<double>());
    }
    size[c] = most - least;
  }
  return fmt::format(", reaches {} × {} × {}", plain_number(size[0]), plain_number(size[1]), plain_number(size[2]));
}

// "12 springs in 3 chains, 4 colliders, ", or nothing.
std::string springs_of(const ordered_json& skeleton) {
  const auto chains = skeleton["spring_chains"].get<int>();
  if (chains == 0) return "";
  return fmt::format("{} springs in {} chains, {} colliders, ", skeleton["spring_joints"].get<int>(), chains,
                     skeleton["spring_colliders"].get<int>());
}

constexpr const char* kGpuLegend =
    "GPU: what a vertex with all that its mesh has costs, by compilers: cycles of a Mali-G57, instructions of an "
    "Adreno "
    "660 and of a V3D 4.2";

// What a vertex costs phones' GPUs, or nothing where that is not known.
std::string gpu_cost_of(const ordered_json& mesh) {
  const ordered_json& gpu = mesh["gpu"];
  if (gpu["ssd"].is_null() || gpu["as"].is_null()) return "";
  const auto words = [&](const char* deformer) {
    const ordered_json& cost = gpu[deformer];
    return fmt::format("{:.0f}/{:.0f}/{:.0f}", cost["mali_cycles"].get<double>(),
                       cost["adreno_instructions"].get<double>(), cost["videocore_instructions"].get<double>());
  };
  const std::string psd = gpu["psd"].is_null() ? "" : fmt::format(", {} by PSD", words("psd"));
  return fmt::format(", GPU {} by SSD, {} by AS{}", words("ssd"), words("as"), psd);
}

// ", 12 helpers", or nothing.
std::string count_of_helpers(const ordered_json& mesh) {
  const std::size_t count = mesh["helpers"].size();
  return count == 0 ? "" : fmt::format(", {} helper{}", count, count == 1 ? "" : "s");
}

// Branches in the order in which they are added; a branch's leaves are added behind it.
class Tree {
 public:
  Tree(const ordered_json& r, const ordered_json& source) : r_(r), source_(source) {
    lines_.push_back({text(r["file"]), size_of(r["bytes"]), source_bytes("bytes"),
                      fmt::format("format version {}", r["version"].get<int>())});
    add_meshes();
    add_skeletons();
    add_clips();
    if (!r_["graphs"].empty()) branch("graphs", "graphs");
    if (r_["totals"]["images"] != 0 || !source_.is_null()) branch("images", "images");
    branch("names and structure", "names_and_structure", true);
  }

  // Columns as wide as the widest of each.
  void print() const {
    std::size_t label = 0, bytes = 0, source = 0;
    for (const Line& line : lines_) {
      label = std::max(label, width(line.label));
      bytes = std::max(bytes, line.bytes.size());
      source = std::max(source, line.source.size());
    }
    for (const Line& line : lines_) {
      std::string out = line.label + std::string(label - width(line.label), ' ');
      out += fmt::format("  {:>{}}", line.bytes, bytes);
      if (source > 0) out += fmt::format("  {:>{}}", line.source, source);
      if (!line.words.empty()) out += "  " + line.words;
      fmt::print("{}\n", out.substr(0, out.find_last_not_of(' ') + 1));
    }
  }

 private:
  // Characters, counted by what is no continuation byte of UTF-8.
  static std::size_t width(const std::string& s) {
    return static_cast<std::size_t>(std::count_if(s.begin(), s.end(), [](char c) { return (c & 0xC0) != 0x80; }));
  }
  std::string source_bytes(const char* field) const {
    return source_.is_null() || !source_.contains(field)
               ? ""
               : fmt::format("source {} B", source_[field].get<std::size_t>());
  }
  // Bytes of the source's element of the same name.
  std::string source_bytes(const char* list, const ordered_json& name) const {
    if (source_.is_null() || !source_[list].contains(text(name))) return "";
    return fmt::format("source {} B", source_[list][text(name)].get<std::size_t>());
  }

  void branch(const std::string& name, const char* total, bool last = false) {
    const auto bytes = r_["totals"][total].get<std::size_t>();
    const double share = 100.0 * static_cast<double>(bytes) / r_["bytes"].get<double>();
    lines_.push_back({(last ? "└─ " : "├─ ") + name, size_of(r_["totals"][total]), source_bytes(total),
                      fmt::format("{:.1f} %", share)});
  }
  void leaf(bool last, const std::string& label, const std::string& bytes, const std::string& source,
            const std::string& words) {
    lines_.push_back({std::string("│  ") + (last ? "└─ " : "├─ ") + label, bytes, source, words});
  }
  // last: the leaf is its branch's last.
  void below_leaf(bool last, const std::string& label, const std::string& bytes, const std::string& words) {
    lines_.push_back({fmt::format("│  {}  {}", last ? " " : "│", label), bytes, "", words});
  }

  void add_meshes() {
    branch("geometry", "geometry");
    for (std::size_t i = 0; i < r_["meshes"].size(); ++i) {
      const auto& m = r_["meshes"][i];
      leaf(i + 1 == r_["meshes"].size() && r_["shapes"].empty(), fmt::format("mesh {} \"{}\"", i, text(m["name"])),
           size_of(m["bytes"]), source_bytes("mesh_bytes", m["name"]),
           fmt::format("{} vertices in {} slots, {} triangles, {} joints{}, {} influences in {} sets, {}, {:.1f} B a "
                       "vertex, {}{}{}{}{}",
                       m["vertices"].get<int>(), m["slots"].get<int>(), m["triangles"].get<int>(),
                       m["joints"].get<int>(), count_of_helpers(m), m["influences"].get<int>(),
                       m["joint_sets"].get<int>(), text(m["as"]), m["bytes_per_vertex"].get<double>(), text(m["codec"]),
                       m["targets"].get<int>() > 0 ? fmt::format(", {} morph targets", m["targets"].get<int>()) : "",
                       m["next_part"].get<bool>() ? ", next part" : "", of_skeleton(m), gpu_cost_of(m)));
      add_helpers(m, i + 1 == r_["meshes"].size() && r_["shapes"].empty());
      add_levels(m, i + 1 == r_["meshes"].size() && r_["shapes"].empty());
    }
    add_shapes(r_["shapes"]);
  }

  // A line for each joint that has some, in their order: how many, and towards which joints.
  void add_helpers(const ordered_json& mesh, bool last) {
    ordered_json joints = ordered_json::object();
    for (const ordered_json& h : mesh["helpers"]) {
      ordered_json& count = joints[text(h["first"])][text(h["second"])];
      count = count.is_null() ? 1 : count.get<int>() + 1;
    }
    for (const auto& [joint, towards] : joints.items()) {
      std::string words;
      for (const auto& [other, count] : towards.items())
        words += fmt::format("{}{} towards \"{}\"", words.empty() ? "" : ", ", count.get<int>(), other);
      below_leaf(last, fmt::format("helpers of \"{}\"", joint), "", words);
    }
  }

  void add_levels(const ordered_json& mesh, bool last) {
    if (!mesh.contains("lods")) return;
    for (std::size_t level = 0; level < mesh["lods"].size(); ++level) {
      const auto& l = mesh["lods"][level];
      below_leaf(last, fmt::format("level {}", level + 1), size_of(l["bytes"]),
                 fmt::format("{} vertices, {} triangles, {} off", l["vertices"].get<int>(), l["triangles"].get<int>(),
                             length_text(l["error_m"].get<double>())));
    }
  }

  void add_shapes(const ordered_json& shapes) {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const auto& s = shapes[i];
      std::string by;
      for (const auto& p : s["parameters"]) by += fmt::format("{}\"{}\"", by.empty() ? "" : ", ", text(p["name"]));
      leaf(i + 1 == shapes.size(), fmt::format("shape \"{}\"", text(s["name"])), size_of(s["bytes"]), "",
           fmt::format("{} examples of {} morph targets by {}, of {}", s["examples"].get<int>(), s["targets"].size(),
                       by, fmt::format("mesh {}", fmt::join(s["meshes"].get<std::vector<int>>(), ", "))));
    }
  }

  // Which skeleton, where there are several.
  std::string of_skeleton(const ordered_json& o) const {
    const bool several = r_["skeletons"].size() + r_["references"].size() > 1;
    return several ? fmt::format(", skeleton {}", o["skeleton"].get<int>()) : std::string();
  }

  void add_skeletons() {
    branch("skeletons", "skeletons");
    for (std::size_t i = 0; i < r_["references"].size(); ++i) {
      const auto& s = r_["references"][i];
      leaf(i + 1 == r_["references"].size(), fmt::format("clip pack for skeleton \"{}\"", text(s["name"])),
           size_of(s["bytes"]), "", fmt::format("{} joints, hash {}", s["joints"].get<int>(), text(s["hash"])));
    }
    for (std::size_t i = 0; i < r_["skeletons"].size(); ++i) {
      const auto& s = r_["skeletons"][i];
      leaf(i + 1 == r_["skeletons"].size(), fmt::format("skeleton {} \"{}\"", i, text(s["name"])), size_of(s["bytes"]),
           "",
           fmt::format("{} joints, {} roots, {}{}{:.3g} m across", s["joints"].get<int>(), s["roots"].get<int>(),
                       s["limits"].get<int>() > 0 ? fmt::format("{} limits, ", s["limits"].get<int>()) : "",
                       springs_of(s), s["diagonal_m"].get<double>()));
      if (const std::string roles = summary_of_roles(s["roles"]); !roles.empty())
        below_leaf(i + 1 == r_["skeletons"].size(), "roles", "", roles);
      for (const auto& m : r_["pose_maps"])
        if (m["skeleton"] == i)
          below_leaf(i + 1 == r_["skeletons"].size(), fmt::format("pose map \"{}\"", text(m["name"])),
                     size_of(m["bytes"]),
                     fmt::format("{} joints turn as those of a rig of {} joints, hash {}", m["joints"].get<int>(),
                                 m["rig_joints"].get<int>(), text(m["rig_hash"])));
    }
  }

  void add_clips() {
    branch("clips", "clips");
    for (std::size_t i = 0; i < r_["clips"].size(); ++i) {
      const auto& c = r_["clips"][i];
      const bool last = i + 1 == r_["clips"].size();
      const char* const kind = !c["additive"].get<bool>()       ? ""
                               : text(c["reference"]) == "rest" ? ", additive over the rest pose"
                                                                : ", additive over a reference of its own";
      const int frames = c["frames"].get<int>();
      leaf(last, fmt::format("clip {} \"{}\"", i, text(c["name"])), size_of(c["bytes"]),
           source_bytes("clip_bytes", c["name"]),
           fmt::format("{:.3f} s, {}{} tracks, {}{}{}{}", c["duration_s"].get<double>(),
                       frames > 0 ? fmt::format("{} frames, ", frames) : "", c["tracks"].get<int>(), text(c["codec"]),
                       kind, reach_of(c), summary_of_motion(c["motion"]), of_skeleton(c)));
      for (const auto& channel : c["channels"]) below_leaf(last, fmt::format("channel \"{}\"", text(channel)), "", "");
    }
  }

  const ordered_json& r_;
  const ordered_json& source_;  // null: unknown
  std::vector<Line> lines_;
};

void print(const ordered_json& description, const ordered_json& source) {
  Tree(description, source).print();
  if (!description["meshes"].empty()) fmt::print("{}\n", kGpuLegend);
  print_graphs(description);
  print_looks(description);
  print_nodes(description);
}

// Throws Failure.
void run_info(const InfoArguments& a) {
  if (!a.source.empty() && a.in.size() > 1)
    throw Failure(Exit::usage, "--source", "", "several files", "name one, and the glTF file that it was cooked from");
  const ordered_json source = a.source.empty() ? ordered_json() : describe_source(a.source);
  ordered_json all = ordered_json::array();
  for (const std::string& in : a.in) {
    ordered_json description = describe(in, open_model(in).loaded);
    if (a.json) {
      if (!source.is_null()) description["source"] = source;
      all.push_back(std::move(description));
    } else if (a.roles || a.motion) {
      if (a.roles) print_roles(description);
      if (a.motion) print_motions(description);
    } else {
      if (&in != &a.in.front()) fmt::print("\n");
      print(description, source);
    }
  }
  if (!a.json) return;
  const ordered_json& out = a.in.size() == 1 ? all.front() : all;
  fmt::print("{}\n", out.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace

void add_info(CLI::App& app, int&) {
  static InfoArguments a;  // as long as the options that point at it
  CLI::App* const command =
      app.add_subcommand("info", "Say what cooked files hold, and what its vertices cost phones' GPUs");
  command->add_option("file", a.in, "cooked files")->required()->type_name("FILE...");
  command->add_option("--source", a.source, "the glTF file it was cooked from, to show its bytes beside")
      ->type_name("IN.glb");
  command->add_flag("--roles", a.roles, "only what joints are for, which mirror each other, and where feet stand");
  command->add_flag("--motion", a.motion, "only what clips do: their speeds, events, steps, and how their roots move");
  command->add_flag("--json", a.json, "as JSON; of several files as an array");
  command->callback([] { run_info(a); });
}

}  // namespace marrow::tools
