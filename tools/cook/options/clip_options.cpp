#include "cook/options/option_lists.h"

namespace marrow::cook {
namespace {

constexpr Named<bool> kClipCodecs[] = {{"segments", false}, {"raw", true}};

// An amount; in front "JOINT=", or for all joints.
void set_clip_error(CookOptions& options, const Value& given) {
  const std::string& text = given.text;
  const std::size_t divide = text.rfind('=');
  ClipErrorRule rule;
  if (divide != std::string::npos) rule.joints = text.substr(0, divide);
  Amount amount;
  if (!read_amount(std::string_view(text).substr(divide == std::string::npos ? 0 : divide + 1), amount) || divide == 0)
    refuse(given, "\"" + text + "\" is not an error",
           "give a length or a share of the skeleton, as in 0.1mm, 0.0001m, 0.05% or hand*=0.02mm");
  rule.error = amount.value;
  rule.is_share = amount.is_share;
  rule.origin = given.origin;
  options.clips.error.push_back(rule);
}

// "vertices", or a length.
void set_clip_shell(CookOptions& options, const Value& given) {
  options.clips.shell.reset();
  if (given.text == "vertices") return;
  Amount amount;
  if (!read_amount(given.text, amount) || amount.is_share)
    refuse(given, "\"" + given.text + "\" is no shell", "give vertices, or a length as in 3cm or 0.03m");
  options.clips.shell = amount.value;
}

// "CLIP" or "CLIP=REFERENCE", divided at the last "=".
void set_additive(CookOptions& options, const Value& given) {
  const std::size_t divide = given.text.rfind('=');
  AdditiveRule rule;
  rule.clips = given.text.substr(0, divide);
  if (divide != std::string::npos) rule.reference = given.text.substr(divide + 1);
  if (rule.clips.empty() || rule.reference.empty())
    refuse(given, "\"" + given.text + "\" names no clip or no reference",
           "give CLIP or CLIP=REFERENCE, as in aim=rest");
  rule.origin = given.origin;
  options.clips.additive.push_back(rule);
}

// "FILE" or "FILE=MAP.toml", divided at the last "=".
void add_rig(std::vector<RetargetRule>& rules, const Value& given) {
  const std::size_t divide = given.text.rfind('=');
  RetargetRule rule{given.text.substr(0, divide), "", given.origin};
  if (divide != std::string::npos) rule.map = given.text.substr(divide + 1);
  if (rule.file.empty() || (divide != std::string::npos && rule.map.empty()))
    refuse(given, "\"" + given.text + "\" names no file or no map",
           "give FILE or FILE=MAP.toml, as in walk.glb=walk.toml");
  for (const RetargetRule& other : rules)
    if (other.file == rule.file) refuse(given, "\"" + rule.file + "\" a second time", "leave it out");
  rules.push_back(std::move(rule));
}

// "NEW=CLIP", divided at the first "=".
void set_mirror(CookOptions& options, const Value& given) {
  const std::size_t divide = given.text.find('=');
  if (divide == std::string::npos || divide == 0 || divide + 1 == given.text.size())
    refuse(given, "\"" + given.text + "\" names no clip", "give NEW=CLIP, as in walk_left=walk_right");
  options.retarget.mirror.push_back({given.text.substr(0, divide), given.text.substr(divide + 1), given.origin});
}

constexpr Option kClipOptions[] = {
    {"clip-error",
     OptionKind::list,
     "[JOINT=]E",
     "how far clips may stray, at every vertex and on a shell of 3 cm round each joint: 0.1mm (the default), 0.0001m "
     "or "
     "0.05% of the skeleton; with JOINT= for some joints only, JOINT may have * and ?; repeatable, the last that fits "
     "counts",
     {},
     set_clip_error},
    {"clip-shell",
     OptionKind::text,
     "WHERE",
     "vertices: --clip-error holds at every vertex too (the default); a length, as 3cm: only on a shell of that radius "
     "round each joint, to compare with others",
     {},
     set_clip_shell},
    {"clip-codec", OptionKind::text, "TEXT", "segments: compressed within --clip-error; raw: without loss",
     names_in<kClipCodecs>, [](CookOptions& o, const Value& v) { o.clips.raw = *value_of(kClipCodecs, v.text); }},
    {"additive",
     OptionKind::list,
     "CLIP[=REFERENCE]",
     "make clips additive, as changes from a reference: first (their first frame, the default), rest, or another "
     "clip's first frame; CLIP may have * and ?; repeatable",
     {},
     set_additive},
    {"retarget",
     OptionKind::list,
     "FILE[=MAP]",
     "put the clips of another rig onto this skeleton: glTF, .bvh or .mrw; joints are paired by roles and names, or "
     "as a MAP.toml says, see marrow retarget; with --clips-only the pack has these clips alone; repeatable",
     {},
     [](CookOptions& options, const Value& value) { add_rig(options.retarget.clips, value); }},
    {"pose-map",
     OptionKind::list,
     "RIG[=MAP]",
     "let a game put poses of another rig onto this skeleton while it runs, see retarget_pose(): glTF, .bvh or .mrw; "
     "joints are paired as by --retarget; the map is called as the file; repeatable",
     {},
     [](CookOptions& options, const Value& value) { add_rig(options.retarget.poses, value); }},
    {"mirror",
     OptionKind::list,
     "NEW=CLIP",
     "add a clip NEW, which is CLIP with left and right exchanged; repeatable",
     {},
     set_mirror},
};

}  // namespace

std::span<const Option> clip_options() {
  return kClipOptions;
}

}  // namespace marrow::cook
