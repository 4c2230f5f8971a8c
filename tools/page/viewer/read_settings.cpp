#include "page/viewer/read_settings.h"

#include <algorithm>
#include <cmath>

#include "common/failure.h"

namespace marrow::tools {
namespace {

using nlohmann::json;

constexpr Named<Colours> kColours[] = {
    {"surface", Colours::surface}, {"distance", Colours::distance}, {"weights", Colours::weights}, {"uv", Colours::uv}};

template <class Table>
void read_name(const json& in, const Table& table, auto& out) {
  const auto value = value_of(table, in.get<std::string>());
  if (!value)
    throw Failure(Exit::usage, "settings", "", "no \"" + in.get<std::string>() + "\"", "it is none of the choices");
  out = *value;
}

// What is not finite stays as it is.
void read_number(const json& in, float least, float most, float& out) {
  const auto value = in.get<float>();
  if (std::isfinite(value)) out = std::clamp(value, least, most);
}

// A deformer, or "plain": by linear blend skinning of the plain file.
void read_half(const json& in, Deformer& deformer, bool& plain) {
  plain = in.get<std::string>() == "plain";
  if (plain) deformer = Deformer::ssd;
  if (!plain) read_name(in, kDeformers, deformer);
}

std::size_t index_of(const json& in, std::size_t count) {
  const auto value = in.get<std::int64_t>();
  return value >= 0 && static_cast<std::size_t>(value) < count ? static_cast<std::size_t>(value) : 0;
}

void read_playback(const json& w, const Actor& actor, PageSettings& s) {
  if (w.contains("clip")) s.clip = index_of(w["clip"], actor.plays().size());
  if (w.contains("second")) s.second = index_of(w["second"], actor.plays().size());
  if (w.contains("second_weight")) read_number(w["second_weight"], 0, 1, s.second_weight);
  if (w.contains("playing")) s.playing = w["playing"].get<bool>();
  if (w.contains("speed")) read_number(w["speed"], -4, 4, s.playback.speed);
  if (w.contains("loop")) s.playback.mode = w["loop"].get<bool>() ? PlayMode::loop : PlayMode::once;
  if (!w.contains("time_s")) return;
  auto time_s = static_cast<float>(s.playback.time_s);
  read_number(w["time_s"], 0, actor.plays()[s.clip].play.duration_s, time_s);
  s.playback.time_s = static_cast<double>(time_s);
}

void read_look(const json& w, const Actor& actor, PageSettings& s) {
  if (w.contains("deformer")) read_half(w["deformer"], s.deformer, s.plain);
  if (w.contains("other")) read_half(w["other"], s.other, s.plain_other);
  if (w.contains("split")) read_number(w["split"], 0, 1, s.divide);
  if (w.contains("normals")) read_name(w["normals"], kAsNormals, s.normals);
  if (w.contains("level")) s.lod = std::clamp(w["level"].get<int>(), 0, actor.coarsest_lod());
  if (w.contains("colours")) read_name(w["colours"], kColours, s.colours);
  if (w.contains("pair")) {
    read_name(w["pair"].at(0), kDeformers, s.pair.first);
    read_name(w["pair"].at(1), kDeformers, s.pair.second);
  }
  if (w.contains("wireframe")) s.overlays.wireframe = w["wireframe"].get<bool>();
  if (w.contains("show_normals")) s.overlays.normals = w["show_normals"].get<bool>();
  if (w.contains("grid")) s.overlays.grid = w["grid"].get<bool>();
  if (w.contains("steps")) s.overlays.steps = w["steps"].get<bool>();
  if (w.contains("ghosts")) s.overlays.ghosts = std::clamp(w["ghosts"].get<int>(), 0, 4);
  if (w.contains("coarseness")) s.coarseness = std::clamp(w["coarseness"].get<int>(), 1, 8);
  // By a deformer that the file has nothing for.
  for (Deformer* const chosen : {&s.deformer, &s.other, &s.pair.first, &s.pair.second})
    expect_deformer(actor.path(), actor.file(), *chosen);
}

void read_hands(const json& w, const Actor& actor, PageSettings& s) {
  const std::size_t joints = actor.joints().size();
  if (w.contains("joint")) s.joint = index_of(w["joint"], std::max<std::size_t>(joints, 1));
  if (w.contains("picked")) s.picked = w["picked"].get<bool>();
  if (w.contains("solver")) {
    const auto name = w["solver"].get<std::string>();
    if (name == "auto") {
      s.reach.solver = {};
    } else {
      read_name(w["solver"], kIkSolvers, s.reach.solver);
    }
  }
  if (w.contains("chain")) s.reach.joints = static_cast<std::uint32_t>(std::clamp(w["chain"].get<int>(), 1, 64));
  if (w.contains("limits")) s.limits = w["limits"].get<bool>();
  if (w.contains("springs")) s.springs = w["springs"].get<bool>();
  if (w.contains("turns")) {
    s.turns.clear();
    for (const json& turn : w["turns"])
      s.turns.push_back({index_of(turn["joint"], std::max<std::size_t>(joints, 1)), point_of(turn["degrees"])});
  }
  if (w.contains("weights")) {
    s.weights.clear();
    for (const json& weight : w["weights"])
      read_number(weight["weight"], -10, 10, s.weights[static_cast<std::size_t>(weight["morph"].get<std::uint32_t>())]);
  }
  if (w.contains("parameters")) {
    s.parameters.clear();
    for (const json& p : w["parameters"])
      read_number(p["value"], -1e6f, 1e6f, s.parameters[p["name"].get<std::string>()]);
  }
}

}  // namespace

glm::vec3 point_of(const json& numbers) {
  glm::vec3 out(0);
  for (int i = 0; i < 3; ++i) read_number(numbers.at(static_cast<std::size_t>(i)), -1e6f, 1e6f, out[i]);
  return out;
}

void read_settings(const json& wanted, const Actor& actor, PageSettings& s) {
  read_playback(wanted, actor, s);
  read_look(wanted, actor, s);
  read_hands(wanted, actor, s);
  if (!wanted.contains("orbit")) return;
  const json& orbit = wanted["orbit"];
  s.framed = !orbit.is_null();
  if (orbit.is_null()) return;
  s.orbit.target = point_of(orbit["target"]);
  read_number(orbit["yaw"], -7, 7, s.orbit.yaw);
  read_number(orbit["pitch"], -1.5f, 1.5f, s.orbit.pitch);
  read_number(orbit["distance"], 1e-6f, 1e9f, s.orbit.distance);
}

void set_parameters_of(const json& values, Rehearsal& rehearsal) {
  for (const json& value : values) {
    const Behaviour& behaviour = rehearsal.behaviour();
    const std::uint32_t parameter = behaviour.parameter(value["name"].get<std::string>());
    const GraphParameter& of = behaviour.graph().parameters[parameter];
    float number = behaviour.wanted(parameter);
    const bool is_number = of.kind == ParameterKind::number;
    read_number(value["value"], is_number ? of.least : 0, is_number ? of.most : 1, number);
    rehearsal.set(parameter, number);
  }
}

}  // namespace marrow::tools
