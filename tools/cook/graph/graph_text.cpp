#include "cook/graph/graph_text.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "marrow/roles.h"
#include "text/nearest.h"
#include "toml/toml_reader.h"

namespace marrow::cook {
namespace {

constexpr std::size_t kLargestGraph = 1024 * 1024;
constexpr double kMostSeconds = 1e6, kMostNumber = 1e12;

using Keys = std::vector<std::string>;

// Entries in the order in which they are written.
std::vector<std::pair<const toml::key*, const toml::node*>> written(const toml::table& table) {
  std::vector<std::pair<const toml::key*, const toml::node*>> out;
  for (const auto& [key, value] : table) out.emplace_back(&key, &value);
  std::ranges::sort(out, [](const auto& a, const auto& b) {
    const toml::source_position &x = a.first->source().begin, &y = b.first->source().begin;
    return x.line != y.line ? x.line < y.line : x.column < y.column;
  });
  return out;
}

class GraphReader {
 public:
  explicit GraphReader(const std::string& path) : read_(path) {}

  GraphText read(std::string_view text) const {
    const toml::table root = read_.parse(text, kLargestGraph);
    read_.table(root, "a graph", {"output", "parameters", "node"});
    GraphText out;
    out.path = read_.path();
    out.name = std::filesystem::path(read_.path()).stem().stem().string();
    out.output = name(read_.needed(root, "a graph", "output"), "output");
    if (const toml::node* const parameters = root.get("parameters"))
      for (const auto& [key, value] : written(table_as(*parameters, "[parameters]", "write [parameters]")))
        out.parameters.push_back(parameter(*key, *value));
    if (out.parameters.size() > 256)
      read_.fail(out.parameters[256].at, "more than 256 parameters", "make two graphs of it");
    if (const toml::node* const nodes = root.get("node"))
      for (const auto& [key, value] : written(table_as(*nodes, "[node]", "write [node.NAME]")))
        out.nodes.push_back(node(*key, *value));
    return out;
  }

 private:
  // example: how such a table is written.
  const toml::table& table_as(const toml::node& node, const char* what, const char* example) const {
    if (!node.is_table()) read_.fail(node, fmt::format("{} must be a table", what), example);
    return *node.as_table();
  }
  const toml::table& table_as(const toml::node& node, const char* what, const char* example, const Keys& keys) const {
    return read_.table(table_as(node, what, example), what, keys);
  }
  // What runtimes read ends at a NUL.
  std::string whole(const toml::source_region& at, const char* what, std::string given) const {
    if (given.find('\0') != std::string::npos) read_.fail(at, fmt::format("{} with a NUL in it", what), "leave it out");
    return given;
  }
  NameText name(const toml::node& node, const char* key) const {
    return {whole(node.source(), "a name", read_.text(node, key)), node.source()};
  }
  // Of what is named by its key. reserved: what stands for something else where it would be used.
  std::string own_name(const toml::key& key, const char* what, bool is_reserved, const char* advice) const {
    if (key.str().empty()) read_.fail(key.source(), fmt::format("{} without a name", what), "give it one");
    if (is_reserved) read_.fail(key.source(), fmt::format("{} called \"{}\"", what, key.str()), advice);
    return whole(key.source(), what, std::string(key.str()));
  }
  float seconds(const toml::table& table, const char* key, float otherwise = 0) const {
    const toml::node* const found = table.get(key);
    return found != nullptr ? read_.number(*found, key, 0, kMostSeconds) : otherwise;
  }
  bool flag(const toml::table& table, const char* key) const {
    const toml::node* const found = table.get(key);
    return found != nullptr && read_.flag(*found, key);
  }
  std::vector<NameText> names(const toml::node& node, const char* key) const {
    if (node.is_string()) return {name(node, key)};
    if (!node.is_array()) read_.fail(node, fmt::format("\"{}\" must be a name, or a list of names", key), "quote it");
    std::vector<NameText> out;
    for (const toml::node& element : *node.as_array()) out.push_back(name(element, key));
    if (out.empty()) read_.fail(node, fmt::format("\"{}\" names nothing", key), "give a name");
    return out;
  }
  // One of several words.
  std::size_t word(const toml::node& node, const char* key, const Keys& words) const {
    const std::string given = read_.text(node, key);
    const auto found = std::ranges::find(words, given);
    if (found == words.end())
      read_.fail(node, fmt::format("there is no {} \"{}\"", key, given), tools::suggestion(given, words));
    return static_cast<std::size_t>(found - words.begin());
  }

  // The word of "type"; a key that is nearly called so is meant.
  std::size_t type_of(const toml::table& table, const char* what, const Keys& words) const {
    if (table.get("type") == nullptr)
      for (const auto& [key, value] : table)
        if (key.str().size() == 4 && !tools::did_you_mean(key.str(), {"type"}).empty())
          read_.fail(key.source(), fmt::format("{} has no \"{}\"", what, key.str()), "did you mean \"type\"?");
    return word(read_.needed(table, what, "type"), "type", words);
  }

  ParameterText parameter(const toml::key& key, const toml::node& value) const {
    const std::string_view given = key.str();
    const bool is_unsayable = given.starts_with("not ") || given.find_first_of("<>=!&|") != std::string_view::npos ||
                              given.find(" or ") != given.npos || given.find(" and ") != given.npos ||
                              given.starts_with(' ') || given.ends_with(' ');
    ParameterText out{own_name(key, "a parameter", is_unsayable, "no condition could name it"), {}, key.source()};
    const toml::table& table = table_as(value, "a parameter", "write { type = \"flag\" }");
    const std::size_t kind = type_of(table, "a parameter", {"number", "flag", "trigger"});
    out.values.kind = static_cast<ParameterKind>(kind);
    switch (out.values.kind) {
      case ParameterKind::number:
        read_number(table, out.values);
        break;
      case ParameterKind::flag:
        read_.table(value, "a flag", {"type", "initial"});
        out.values.initial = flag(table, "initial") ? 1.0f : 0.0f;
        break;
      case ParameterKind::trigger:
        read_.table(value, "a trigger", {"type", "hold"});
        out.values.seconds = seconds(table, "hold");
        break;
    }
    return out;
  }
  void read_number(const toml::table& table, GraphParameter& out) const {
    read_.table(table, "a number", {"type", "range", "initial", "half_life"});
    const toml::array& range = read_.list(read_.needed(table, "a number", "range"), "range");
    if (range.size() != 2) read_.fail(range, "\"range\" must be two numbers", "write [0, 6]");
    out.least = read_.number(*range.get(0), "range", -kMostNumber, kMostNumber);
    out.most = read_.number(*range.get(1), "range", -kMostNumber, kMostNumber);
    if (!(out.least <= out.most)) read_.fail(range, "a range that ends below its begin", "exchange the two");
    const toml::node* const initial = table.get("initial");
    out.initial = initial != nullptr
                      ? read_.number(*initial, "initial", static_cast<double>(out.least), static_cast<double>(out.most))
                      : std::clamp(0.0f, out.least, out.most);
    out.seconds = seconds(table, "half_life");
  }

  // What other languages have is not one condition.
  void expect_one(const toml::node& node, const std::string& text) const {
    const auto has = [&](const char* word) { return text.find(word) != std::string::npos; };
    if (has(" or ") || has("|"))
      read_.fail(node, fmt::format("\"{}\" is two conditions of which one must hold", text),
                 "write a transition for each; a one_shot has one trigger for all");
    if (has(" and ") || has("&"))
      read_.fail(node, fmt::format("\"{}\" is two conditions in one", text), "write a list: [\"jump\", \"not armed\"]");
    if (has("=>") || has("=<"))
      read_.fail(node, fmt::format("\"{}\" has its sign the wrong way round", text), "write >= or <=");
    if (has("!=") || has("==") || (has("=") && !has(">=") && !has("<=")))
      read_.fail(node, fmt::format("\"{}\" asks whether something is equal", text),
                 "a flag is \"armed\" or \"not armed\"; numbers compare with >, <, >= and <=");
    if (has("!")) read_.fail(node, fmt::format("\"{}\" has a \"!\"", text), "write \"not armed\"");
  }

  // "jump", "not armed", "speed >= 0.5".
  ConditionText condition(const toml::node& node) const {
    static const std::pair<const char*, ConditionTest> kTests[] = {{">=", ConditionTest::at_least},
                                                                   {"<=", ConditionTest::at_most},
                                                                   {">", ConditionTest::above},
                                                                   {"<", ConditionTest::below}};
    const auto trimmed = [](std::string s) {
      s.erase(0, s.find_first_not_of(' '));
      return s.erase(s.find_last_not_of(' ') + 1);
    };
    const std::string text = trimmed(whole(node.source(), "a condition", read_.text(node, "when")));
    expect_one(node, text);
    ConditionText out{{text, node.source()}, ConditionTest::set, 0};
    for (const auto& [sign, test] : kTests) {
      const std::size_t at = text.find(sign);
      if (at == std::string::npos) continue;
      const std::string number = trimmed(text.substr(at + std::string_view(sign).size()));
      char* end = nullptr;
      out.value = std::strtof(number.c_str(), &end);
      if (number.empty() || *end != '\0' || !(std::abs(out.value) <= 1e12f))
        read_.fail(node, fmt::format("\"{}\" compares with no number", text), "as in \"speed > 0.5\"");
      out.test = test;
      out.parameter.name = trimmed(text.substr(0, at));
      if (out.parameter.name.empty())
        read_.fail(node, fmt::format("\"{}\" compares no parameter", text), "as in \"speed > 0.5\"");
      if (out.parameter.name.starts_with("not "))
        read_.fail(node, fmt::format("\"{}\" turns a comparison round", text), "exchange < and >=, or > and <=");
      return out;
    }
    if (text.starts_with("not ")) {
      out.test = ConditionTest::not_set;
      out.parameter.name = trimmed(text.substr(4));
    }
    return out;
  }
  std::vector<ConditionText> conditions(const toml::table& table) const {
    std::vector<ConditionText> out;
    const toml::node* const when = table.get("when");
    if (when == nullptr) return out;
    if (when->is_string()) return {condition(*when)};
    if (!when->is_array())
      read_.fail(*when, "\"when\" must be a condition, or a list of them", "quote it, as \"jump\" or \"speed > 0.5\"");
    for (const toml::node& element : *when->as_array()) out.push_back(condition(element));
    return out;
  }

  std::vector<MaskPartText> mask(const toml::table& table) const {
    std::vector<MaskPartText> out;
    const toml::node* const found = table.get("mask");
    if (found == nullptr) return out;
    if (found->is_table()) return {mask_part(*found)};
    for (const toml::node& element : read_.list(*found, "mask")) out.push_back(mask_part(element));
    if (out.size() > 64) read_.fail(*found, "a mask of more than 64 joints", "name those that they hang on");
    if (out.empty()) read_.fail(*found, "a mask of no joints", "{ role = \"chest\" }, or leave it out");
    return out;
  }
  MaskPartText mask_part(const toml::node& node) const {
    const toml::table& table = table_as(node, "a mask", "write { role = \"chest\" } or { joint = \"spine_02\" }",
                                        {"role", "joint", "falloff"});
    MaskPartText out;
    const toml::node *const role = table.get("role"), *const joint = table.get("joint");
    if ((role == nullptr) == (joint == nullptr)) read_.fail(node, "a mask needs a role or a joint", "give one of them");
    if (role != nullptr) {
      const std::string given = read_.text(*role, "role");
      out.role = find_role(given.c_str());
      if (*out.role == Role::none) {
        Keys roles;
        for (std::uint32_t r = 1; r < kRoleCount; ++r) roles.emplace_back(role_name(static_cast<Role>(r)));
        read_.fail(*role, fmt::format("there is no role \"{}\"", given), tools::suggestion(given, roles));
      }
    } else {
      out.joint = name(*joint, "joint").name;
    }
    if (const toml::node* const falloff = table.get("falloff")) {
      const float joints = read_.number(*falloff, "falloff", 0, 65535);
      out.falloff = static_cast<std::uint32_t>(joints);
      if (static_cast<float>(out.falloff) != joints)
        read_.fail(*falloff, "\"falloff\" counts joints", "write a whole number");
    }
    return out;
  }

  NodeText node(const toml::key& key, const toml::node& value) const {
    NodeText out;
    out.name = own_name(key, "a node", false, "");
    out.at = key.source();
    const toml::table& table = table_as(value, "a node", "write [node.NAME], and its keys below");
    out.type = static_cast<NodeType>(
        type_of(table, "a node", {"clip", "space", "machine", "layer", "add", "one_shot", "pick", "given"}));
    switch (out.type) {
      case NodeType::clip:
        read_clip(table, out);
        break;
      case NodeType::space:
        read_space(table, out);
        break;
      case NodeType::machine:
        read_machine(table, out);
        break;
      case NodeType::layer:
        read_layer(table, {"type", "base", "pose", "mask", "weight", "fade", "space"}, out);
        break;
      case NodeType::add:
        read_layer(table, {"type", "base", "pose", "mask", "weight", "fade"}, out);
        break;
      case NodeType::one_shot:
        read_one_shot(table, out);
        break;
      case NodeType::pick:
        read_pick(table, out);
        break;
      case NodeType::given:
        read_.table(table, "a given pose", {"type"});
        break;
    }
    return out;
  }

  void read_clip(const toml::table& table, NodeText& out) const {
    read_.table(table, "a clip", {"type", "clip", "speed", "play"});
    out.clip = name(read_.needed(table, "a clip", "clip"), "clip");
    if (const toml::node* const speed = table.get("speed")) out.play.speed = read_.number(*speed, "speed", -64, 64);
    if (const toml::node* const play = table.get("play"))
      out.mode = static_cast<PlayMode>(word(*play, "play", {"once", "loop", "ping_pong"}));
  }

  void read_space(const toml::table& table, NodeText& out) const {
    read_.table(table, "a space", {"type", "by", "points", "match_speed", "sync"});
    out.by = names(read_.needed(table, "a space", "by"), "by");
    if (out.by.size() > 2) read_.fail(*table.get("by"), "a space by more than two numbers", "one or two");
    for (const toml::node& element : read_.list(read_.needed(table, "a space", "points"), "points"))
      out.points.push_back(point(element, out.by.size()));
    if (out.points.empty() || out.points.size() > 64)
      read_.fail(*table.get("points"), "a space of no points, or of more than 64", "one at least, 64 at most");
    out.match_speed = flag(table, "match_speed");
    out.sync = flag(table, "sync");
    if (out.match_speed && out.by.size() == 2)
      read_.fail(*table.get("match_speed"), "match_speed is for spaces by one number", "leave it out");
    if (out.match_speed && !out.sync)
      read_.fail(*table.get("match_speed"), "match_speed is for clips in step", "sync = true");
  }
  PointText point(const toml::node& node, std::size_t numbers) const {
    const toml::table& table = table_as(node, "a point", "write { at = 0, pose = \"idle\" }", {"at", "pose"});
    PointText out{name(read_.needed(table, "a point", "pose"), "pose"), {}};
    const toml::node* const at = table.get("at");
    if (at == nullptr && numbers == 1) return out;
    if (at == nullptr) read_.fail(node, "a point of a plane without \"at\"", "at = [0, 1]");
    if (numbers == 1) {
      if (at->is_array()) read_.fail(*at, "a point of a line has one number", "at = 1.5, or give \"by\" two");
      out.at.push_back(read_.number(*at, "at", -kMostNumber, kMostNumber));
      return out;
    }
    if (!at->is_array()) read_.fail(*at, "a point of a plane has two numbers", "at = [0, 1], or give \"by\" one");
    for (const toml::node& element : *at->as_array())
      out.at.push_back(read_.number(element, "at", -kMostNumber, kMostNumber));
    if (out.at.size() != 2) read_.fail(*at, "\"at\" must be two numbers", "as \"by\" is two");
    return out;
  }

  void read_machine(const toml::table& table, NodeText& out) const {
    read_.table(table, "a machine", {"type", "start", "state", "transition"});
    for (const auto& [key, value] : written(
             table_as(read_.needed(table, "a machine", "state"), "state", "write state.NAME = { pose = \"idle\" }"))) {
      const bool is_any = key->str() == "*";
      StateText state{own_name(*key, "a state", is_any, "* is any state"), std::nullopt, key->source()};
      const toml::table& of = table_as(*value, "a state", "write { pose = \"idle\" }", {"pose"});
      if (const toml::node* const pose = of.get("pose")) state.pose = name(*pose, "pose");
      out.states.push_back(state);
    }
    if (out.states.empty() || out.states.size() > 64)
      read_.fail(table, "a machine of no states, or of more than 64", "one at least, 64 at most");
    out.start = name(read_.needed(table, "a machine", "start"), "start");
    if (const toml::node* const transitions = table.get("transition"))
      for (const toml::node& element : read_.list(*transitions, "transition"))
        out.transitions.push_back(transition(element));
  }
  TransitionText transition(const toml::node& node) const {
    const toml::table& table = table_as(node, "a transition", "write { from = \"a\", to = \"b\", when = \"c\" }",
                                        {"from", "to", "when", "fade", "kind", "after", "at_end", "enter", "choose"});
    TransitionText out;
    out.at = node.source();
    out.from = names(read_.needed(table, "a transition", "from"), "from");
    for (const NameText& from : out.from)
      if (from.name == "*" && out.from.size() > 1)
        read_.fail(from.at, "\"*\" among states", "it stands alone: any state");
    if (out.from[0].name == "*") out.from.clear();
    out.to = names(read_.needed(table, "a transition", "to"), "to");
    out.when = conditions(table);
    out.values.fade_s = seconds(table, "fade");
    out.values.after_s = seconds(table, "after");
    if (const toml::node* const kind = table.get("kind"))
      if (word(*kind, "kind", {"cross", "inertial"}) == 1) out.values.flags |= kFadeIsInertial;
    if (table.get("at_end") != nullptr) {
      out.values.flags |= kWaitsForEnd;
      out.values.at_end_s = seconds(table, "at_end");
    }
    if (const toml::node* const enter = table.get("enter")) read_enter(*enter, out.values);
    if (const toml::node* const choose = table.get("choose"))
      if (word(*choose, "choose", {"chance", "turn"}) == 1) out.values.flags |= kChooseInTurn;
    if (out.when.empty() && table.get("after") == nullptr && table.get("at_end") == nullptr)
      read_.fail(node, "a transition that would be taken at once", "give when, after or at_end");
    return out;
  }
  void read_enter(const toml::node& enter, GraphTransition& out) const {
    if (enter.is_number()) {
      out.enter_s = read_.number(enter, "enter", 0, kMostSeconds);
    } else if (word(enter, "enter", {"beginning", "same_phase"}) == 1) {
      out.flags |= kEnterInPhase;
    }
  }

  void read_layer(const toml::table& table, const Keys& keys, NodeText& out) const {
    read_.table(table, "a layer", keys);
    out.base = name(read_.needed(table, "a layer", "base"), "base");
    out.pose = name(read_.needed(table, "a layer", "pose"), "pose");
    out.mask = mask(table);
    out.fade_s = seconds(table, "fade");
    if (const toml::node* const space = table.get("space"))
      out.in_model_space = word(*space, "space", {"joint", "model"}) == 1;
    const toml::node* const weight = table.get("weight");
    if (weight == nullptr) return;
    if (weight->is_string()) {
      out.weight_by = name(*weight, "weight");
      if (out.weight_by->name.find_first_not_of("0123456789.") == std::string::npos)
        read_.fail(*weight, "\"weight\" is the name of a parameter, or a number", "write the number without quotes");
    } else
      out.weight = read_.number(*weight, "weight", 0, 1);
  }

  void read_one_shot(const toml::table& table, NodeText& out) const {
    read_.table(table, "a one_shot", {"type", "base", "pose", "when", "mask", "fade_in", "fade_out"});
    out.base = name(read_.needed(table, "a one_shot", "base"), "base");
    out.pose = name(read_.needed(table, "a one_shot", "pose"), "pose");
    read_.needed(table, "a one_shot", "when");
    out.when = conditions(table);
    if (out.when.empty()) read_.fail(*table.get("when"), "a one_shot that waits for nothing", "name a trigger");
    out.mask = mask(table);
    out.fade_in_s = seconds(table, "fade_in", 0.1f);
    out.fade_out_s = seconds(table, "fade_out", 0.2f);
  }

  void read_pick(const toml::table& table, NodeText& out) const {
    read_.table(table, "a pick", {"type", "poses", "choose", "fade"});
    out.poses = names(read_.needed(table, "a pick", "poses"), "poses");
    if (out.poses.size() > 64) read_.fail(*table.get("poses"), "a pick of more than 64", "64 at most");
    if (const toml::node* const choose = table.get("choose"))
      out.in_turn = word(*choose, "choose", {"chance", "turn"}) == 1;
    out.fade_s = seconds(table, "fade", 0.2f);
  }

  tools::TomlReader read_;
};

}  // namespace

GraphText parse_graph(const std::string& path, std::string_view text) {
  return GraphReader(path).read(text);
}

}  // namespace marrow::cook
