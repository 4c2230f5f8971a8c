#include "cook/gltf/document/animation_pointer.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace marrow::cook::gltf {
namespace {

// The steps of a JSON pointer, unescaped as RFC 6901 says; nullopt if it is none.
std::optional<std::vector<std::string>> split_pointer(std::string_view pointer) {
  if (pointer.empty() || pointer.front() != '/') return std::nullopt;
  std::vector<std::string> steps;
  for (std::size_t i = 0; i < pointer.size(); ++i) {
    if (pointer[i] == '/') {
      steps.emplace_back();
    } else if (pointer[i] != '~') {
      steps.back() += pointer[i];
    } else if (++i < pointer.size() && (pointer[i] == '0' || pointer[i] == '1')) {
      steps.back() += pointer[i] == '0' ? '~' : '/';
    } else {
      return std::nullopt;
    }
  }
  return steps;
}

// The member or element of `value`; null if there is none.
const Json* step_into(const Json& value, const std::string& step) {
  if (value.is_object()) {
    const auto member = value.find(step);
    return member == value.end() ? nullptr : &*member;
  }
  std::size_t index = 0;
  const char* const end = step.data() + step.size();
  const auto [stop, error] = std::from_chars(step.data(), end, index);
  const bool plain = error == std::errc() && stop == end && (step.size() == 1 || step.front() != '0');
  return value.is_array() && plain && index < value.size() ? &value[index] : nullptr;
}

// How many steps lead to the owner of the extras; nullopt if they lead elsewhere.
std::optional<std::size_t> owner_steps(const Json& root, const std::vector<std::string>& steps) {
  if (steps.size() > 1 && steps[0] == "extras") return 0;
  if (steps.size() > 2 && steps[0] == "asset" && steps[1] == "extras") return 1;
  if (steps.size() <= 3 || steps[2] != "extras") return std::nullopt;
  const Json* const collection = step_into(root, steps[0]);
  if (collection == nullptr || !collection->is_array()) return std::nullopt;
  return 2;
}

bool is_animated_property(std::string_view name) {
  return name == "translation" || name == "rotation" || name == "scale" || name == "weights";
}

std::string owner_name(const Json& owner, const std::vector<std::string>& steps, std::size_t count) {
  if (count < 2) return {};
  const auto name = owner.is_object() ? owner.find("name") : owner.end();
  const bool named = name != owner.end() && name->is_string() && !name->get_ref<const std::string&>().empty();
  return named ? name->get<std::string>() : steps[0] + '[' + steps[1] + ']';
}

std::optional<UserNumber> resolve(const Json& root, const std::string& pointer) {
  const auto steps = split_pointer(pointer);
  const auto owner = steps ? owner_steps(root, *steps) : std::nullopt;
  if (!owner) return std::nullopt;
  UserNumber out;
  out.pointer = pointer;
  const Json* at = &root;
  for (std::size_t i = 0; i < steps->size(); ++i) {
    if (i == *owner) out.name = owner_name(*at, *steps, i);
    const bool in_list = at->is_array();
    at = step_into(*at, (*steps)[i]);
    if (at == nullptr) return std::nullopt;
    if (i <= *owner) continue;
    out.name += in_list ? '[' + (*steps)[i] + ']' : (out.name.empty() ? "" : ".") + (*steps)[i];
  }
  if (!at->is_number()) return std::nullopt;
  out.rest = static_cast<float>(at->get<double>());
  return std::isfinite(out.rest) ? std::optional(out) : std::nullopt;
}

// Where a channel points to; null if it does not.
const std::string* pointer_of(const Json& channel) {
  const Json& target = channel.at("target");
  if (target.at("path") != "pointer") return nullptr;
  const auto extensions = target.find("extensions");
  if (extensions == target.end()) return nullptr;
  const auto extension = extensions->find("KHR_animation_pointer");
  return extension == extensions->end() ? nullptr : &extension->at("pointer").get_ref<const std::string&>();
}

bool is_animated(const Json& channel, const std::string& where, Report& report) {
  const Json& target = channel.at("target");
  const auto& path = target.at("path").get_ref<const std::string&>();
  const auto leave_out = [&](const std::string& at, const char* rule, const std::string& why) {
    report.warn(at, rule, why);
    return false;
  };
  if (path == "pointer") {
    const std::string* const to = pointer_of(channel);
    if (to != nullptr && to->ends_with("/extensions/KHR_node_visibility/visible"))
      return leave_out(under(where, "target", "path"), "visibility-not-animated",
                       *to + ": a node stays as it rests, shown or hidden; left out");
    return leave_out(under(where, "target", "path"), "channel-dropped",
                     (to == nullptr ? "it points nowhere" : "it points at " + *to) +
                         ": neither a node's transform or weights, nor a number in extras; left out");
  }
  if (!is_animated_property(path))
    return leave_out(under(where, "target", "path"), "channel-dropped", "nothing that Marrow animates; left out");
  if (!target.contains("node"))
    return leave_out(under(where, "target"), "channel-dropped", "it names no node; left out");
  return true;
}

}  // namespace

void aim_at_nodes(Json& root) {
  const auto animations = root.find("animations");
  if (animations == root.end()) return;
  for (Json& animation : *animations) {
    for (Json& channel : animation.at("channels")) {
      const std::string* const to = pointer_of(channel);
      const auto steps = to == nullptr ? std::nullopt : split_pointer(*to);
      if (!steps || steps->size() != 3 || (*steps)[0] != "nodes" || !is_animated_property((*steps)[2])) continue;
      const Json* const nodes = step_into(root, "nodes");
      const Json* const node = nodes == nullptr ? nullptr : step_into(*nodes, (*steps)[1]);
      if (node == nullptr) continue;
      channel["target"] = {{"node", node - &nodes->front()}, {"path", (*steps)[2]}};
    }
  }
}

UserNumbers find_user_numbers(const Json& root) {
  UserNumbers out;
  const auto animations = root.find("animations");
  if (animations == root.end()) return out;
  for (std::size_t a = 0; a < animations->size(); ++a) {
    const Json& channels = (*animations)[a].at("channels");
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const std::string* const pointer = pointer_of(channels[c]);
      if (pointer == nullptr) continue;
      if (std::optional<UserNumber> number = resolve(root, *pointer)) out.emplace(std::pair(a, c), std::move(*number));
    }
  }
  return out;
}

void drop_idle_channels(Json& root, const UserNumbers& user_numbers, Report& report) {
  const auto animations = root.find("animations");
  if (animations == root.end()) return;
  for (std::size_t a = 0; a < animations->size(); ++a) {
    Json& channels = (*animations)[a].at("channels");
    for (std::size_t c = 0; c < channels.size(); ++c)
      if (!user_numbers.contains({a, c}) && !is_animated(channels[c], pointer("animations", a, "channels", c), report))
        channels[c].at("target").at("path") = "";
  }
}

}  // namespace marrow::cook::gltf
