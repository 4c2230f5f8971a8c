// A graph as its author wrote it (docs/stages/animator.md), with the place of each name.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "marrow/graph.h"

namespace marrow::cook {

using TextPlace = toml::source_region;

// A name where it is used.
struct NameText {
  std::string name;
  TextPlace at;
};

struct ParameterText {
  std::string name;
  GraphParameter values;
  TextPlace at;
};

struct ConditionText {
  NameText parameter;
  ConditionTest test = ConditionTest::set;
  float value = 0;
};

struct MaskPartText {
  std::optional<Role> role;
  std::string joint;
  std::uint32_t falloff = 0;
};

struct PointText {
  NameText pose;
  std::vector<float> at;  // one or two numbers; none: the clip's own speed
};

struct StateText {
  std::string name;
  std::optional<NameText> pose;
  TextPlace at;
};

struct TransitionText {
  std::vector<NameText> from;  // none: any
  std::vector<NameText> to;    // of several one is chosen
  std::vector<ConditionText> when;
  GraphTransition values;  // all but numbers of states and conditions
  TextPlace at;
};

enum class NodeType { clip, space, machine, layer, add, one_shot, pick, given };

// What a node of any type has; the others are as they are without.
struct NodeText {
  std::string name;
  NodeType type = NodeType::clip;
  TextPlace at;
  NameText clip;  // of clip
  GraphClip play;
  std::optional<PlayMode> mode;
  std::vector<NameText> by;  // of space
  std::vector<PointText> points;
  bool match_speed = false, sync = false;
  NameText start;  // of machine
  std::vector<StateText> states;
  std::vector<TransitionText> transitions;
  NameText base, pose;  // of layer, add and one_shot
  std::vector<MaskPartText> mask;
  std::optional<NameText> weight_by;
  float weight = 1, fade_s = 0;
  bool in_model_space = false;
  std::vector<ConditionText> when;  // of one_shot
  float fade_in_s = 0, fade_out_s = 0;
  bool is_inertial = false;
  std::vector<NameText> poses;  // of pick
  bool in_turn = false;
};

struct GraphText {
  std::string path, name;
  NameText output;
  std::vector<ParameterText> parameters;  // in the order in which they are written, as the nodes
  std::vector<NodeText> nodes;
};

// Throws tools::Failure (usage) at the line and column of what is wrong.
GraphText parse_graph(const std::string& path, std::string_view text);

}  // namespace marrow::cook
