#include "cook/options/option_lists.h"
#include "text/nearest.h"

namespace marrow::cook {
namespace {

constexpr Named<Images> kImages[] = {
    {"reference", Images::reference}, {"embed", Images::embed}, {"none", Images::none}};

constexpr Named<Effort> kEfforts[] = {{"default", Effort::normal}, {"fast", Effort::fast}, {"best", Effort::best}};

// "ROLE=JOINT", divided at the first "=".
void set_role(CookOptions& options, const Value& given) {
  const std::size_t divide = given.text.find('=');
  if (divide == std::string::npos)
    refuse(given, "\"" + given.text + "\" names no joint",
           "give ROLE=JOINT, as in left_foot=FootL, or ROLE= for no joint");
  const std::string name = given.text.substr(0, divide);
  const Role role = find_role(name.c_str());
  if (role == Role::none) {
    std::vector<std::string> names;
    for (std::uint32_t r = 1; r < kRoleCount; ++r) names.emplace_back(role_name(static_cast<Role>(r)));
    refuse(given, "there is no role \"" + name + "\"", tools::suggestion(name, names));
  }
  const std::string joint = given.text.substr(divide + 1);
  for (const RoleRule& other : options.roles)
    if (other.role == role || (!joint.empty() && other.joint == joint))
      refuse(given, "\"" + given.text + "\" after \"" + role_name(other.role) + "=" + other.joint + "\"",
             "a role has one joint, and a joint one role; leave out one of them");
  options.roles.push_back({role, joint, given.origin});
}

constexpr Option kSceneOptions[] = {
    {"effort", OptionKind::text, "TEXT",
     "how long to look for fewer bytes within the same errors: fast, for drafts; default; best, for what is shipped",
     names_in<kEfforts>, [](CookOptions& o, const Value& v) { o.clips.effort = *value_of(kEfforts, v.text); }},
    {"images", OptionKind::text, "TEXT",
     "reference: materials name their images as the source does; embed: the picture files as they are; none: "
     "neither",
     names_in<kImages>, [](CookOptions& o, const Value& v) { o.source.images = *value_of(kImages, v.text); }},
    {"scene",
     OptionKind::text,
     "NAME|INDEX",
     "the scene to cook, by its name or its number in the file; without it the default one, else the first",
     {},
     [](CookOptions& options, const Value& value) {
       options.source.scene = {value.text, value.origin};
     }},
    {"strict",
     OptionKind::flag,
     "",
     "refuse glTF that breaks the specification where it would be mended",
     {},
     [](CookOptions& options, const Value&) { options.source.strict = true; }},
    {"keep",
     OptionKind::list,
     "GLOB",
     "keep nodes by name, as sockets, and their extras; GLOB may have * and ?; repeatable",
     {},
     [](CookOptions& options, const Value& value) { options.prepare.keep.push_back(value.text); }},
    {"roles",
     OptionKind::table,
     "ROLE=JOINT",
     "which joint has a role, as left_foot=FootL, in place of what is found; without JOINT none has; repeatable",
     {},
     set_role},
    {"clips-only",
     OptionKind::flag,
     "",
     "a clip pack: only the clips, for the skeletons of this file",
     {},
     [](CookOptions& options, const Value&) { options.clips_only = true; }},
    {"skeleton",
     OptionKind::text,
     "CHARACTER",
     "the character, cooked or glTF, that hair and clothes or, without meshes or with --clips-only, clips are for; "
     "nodes are matched with its joints by name, and motion capture (.bvh) is fitted to its proportions and rest pose",
     {},
     [](CookOptions& options, const Value& value) { options.skeleton_file = value.text; }},
    {"keep-vertex-order",
     OptionKind::flag,
     "",
     "remember the source's vertex order, for `marrow pose` and for comparing with other evaluators",
     {},
     [](CookOptions& options, const Value&) { options.mesh.keep_vertex_order = true; }},
};

}  // namespace

std::span<const Option> scene_options() {
  return kSceneOptions;
}

}  // namespace marrow::cook
