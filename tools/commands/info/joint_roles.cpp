#include "commands/info/joint_roles.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "marrow/roles.h"
#include "text/quantity.h"

namespace marrow::tools {

using nlohmann::ordered_json;

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

}  // namespace marrow::tools
