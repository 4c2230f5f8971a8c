#include "commands/view/first_settings.h"

#include <algorithm>

#include "common/failure.h"
#include "text/nearest.h"

namespace marrow::tools {
namespace {

std::vector<std::string> joint_names(const Actor& actor) {
  std::vector<std::string> out;
  for (const NamedJoint& joint : actor.joints()) out.push_back(joint.name);
  return out;
}

// Throws Failure (usage) if there is none.
std::size_t find_joint(const Actor& actor, const std::string& file, const std::string& name) {
  const auto joint = std::ranges::find(actor.joints(), name, &NamedJoint::name);
  if (joint == actor.joints().end())
    throw Failure(Exit::usage, file, "", "no joint \"" + name + "\"", suggestion(name, joint_names(actor)));
  return static_cast<std::size_t>(joint - actor.joints().begin());
}

void set_overlays(const ViewArguments& arguments, Settings& s) {
  for (const std::string& name : arguments.show) {
    if (name == "uv") s.colours = Colours::uv;
    if (const auto flag = value_of(kOverlays, name)) s.overlays.*(*flag) = true;
  }
  s.overlays.bones |= arguments.bones;
  s.overlays.steps |= arguments.by_graph;
  s.overlays.ghosts = arguments.ghosts;
}

}  // namespace

ViewSettings first_settings(const ViewArguments& arguments, const std::optional<DeformerPair>& pair,
                            const ViewActor& actor) {
  ViewSettings s;
  s.clip = actor.chosen();
  // Without --clip the first there is.
  if (!arguments.by_graph && arguments.choice.clip.empty() && actor.plays().size() > 1) s.clip = 1;
  if (actor.rehearsal() != nullptr) s.parameter = first_number(actor.rehearsal()->behaviour().graph());
  const float duration_s = actor.plays()[s.clip].play.duration_s;
  s.playback.time_s = static_cast<double>(std::clamp(arguments.choice.time_s, 0.0f, duration_s));
  s.playing = !arguments.held;
  s.deformer = arguments.deformer;
  s.path = arguments.path;
  s.normals = arguments.normals;
  s.lod = static_cast<int>(arguments.lod);
  s.reach = arguments.reach;
  s.limits = arguments.limits;
  s.parameters = set_parameters(arguments.file, actor.file(), arguments.choice);
  s.springs = arguments.springs;
  if (s.springs && arguments.joint.empty() && !actor.rig().has_springs())
    throw Failure(Exit::usage, "--springs", "", "the file has no springs", "say with --joint which joints swing");
  set_overlays(arguments, s);
  s.painting = arguments.paints;
  s.paint_file = arguments.paint_file;
  s.playing &= !s.painting;
  if (pair) {
    s.colours = Colours::distance;
    s.pair = *pair;
  }
  if (!arguments.weights.empty()) {
    s.colours = Colours::weights;
    s.joint = find_joint(actor, arguments.file, arguments.weights);
  }
  if (!arguments.joint.empty()) {
    s.joint = find_joint(actor, arguments.file, arguments.joint);
    s.picked = s.show_joint = true;
  }
  return s;
}

void carry_over(const Actor& from, const Actor& to, Settings& s) {
  const auto clip = [&](std::size_t which, std::size_t otherwise) {
    const auto found = std::ranges::find(to.plays(), from.plays()[which].name, &NamedPlay::name);
    return found == to.plays().end() ? otherwise : static_cast<std::size_t>(found - to.plays().begin());
  };
  s.clip = clip(s.clip, to.plays().size() > 1 ? 1 : 0);
  s.second = clip(s.second, 0);
  s.playback.time_s = std::clamp(s.playback.time_s, 0.0, static_cast<double>(to.plays()[s.clip].play.duration_s));
  s.lod = std::min(s.lod, to.coarsest_lod());
  const auto joint = from.joints().empty()
                         ? to.joints().end()
                         : std::ranges::find(to.joints(), from.joints()[s.joint].name, &NamedJoint::name);
  const bool known = joint != to.joints().end();
  s.joint = known ? static_cast<std::size_t>(joint - to.joints().begin()) : 0;
  s.picked &= known;
  s.springs &= known || to.rig().has_springs();
  if (!known && s.colours == Colours::weights) s.colours = Colours::surface;
}

}  // namespace marrow::tools
