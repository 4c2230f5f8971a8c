#include "options/option_lists.h"

namespace marrow::cook {
namespace {

constexpr Named<Images> kImages[] = {
    {"reference", Images::reference}, {"embed", Images::embed}, {"none", Images::none}};

constexpr Named<Effort> kEfforts[] = {{"default", Effort::normal}, {"fast", Effort::fast}, {"best", Effort::best}};

constexpr Option kSceneOptions[] = {
    {"effort", OptionKind::text, "TEXT",
     "how long to look for fewer bytes within the same errors: fast, for drafts; default; best, for what is shipped",
     names_in<kEfforts>, [](CookOptions& o, const Value& v) { o.effort = *value_of(kEfforts, v.text); }},
    {"images", OptionKind::text, "TEXT",
     "reference: materials name their images as the source does; embed: the picture files as they are; none: "
     "neither",
     names_in<kImages>, [](CookOptions& o, const Value& v) { o.images = *value_of(kImages, v.text); }},
    {"scene",
     OptionKind::text,
     "NAME|INDEX",
     "the scene to cook, by its name or its number in the file; without it the default one, else the first",
     {},
     [](CookOptions& options, const Value& value) {
       options.scene = {value.text, value.origin};
     }},
    {"strict",
     OptionKind::flag,
     "",
     "refuse glTF that breaks the specification where it would be mended",
     {},
     [](CookOptions& options, const Value&) { options.strict = true; }},
    {"keep",
     OptionKind::list,
     "GLOB",
     "keep nodes by name, as sockets, and their extras; GLOB may have * and ?; repeatable",
     {},
     [](CookOptions& options, const Value& value) { options.keep.push_back(value.text); }},
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
     [](CookOptions& options, const Value&) { options.keep_vertex_order = true; }},
};

}  // namespace

std::span<const Option> scene_options() {
  return kSceneOptions;
}

}  // namespace marrow::cook
