#include "page/viewer/show.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/failure.h"
#include "page/viewer/page_gl.h"
#include "page/viewer/read_settings.h"
#include "stage/among_figures.h"
#include "stage/moves.h"

namespace marrow::tools {
namespace {

LoadedFile with_meshes(const std::string& name, LoadedFile loaded) {
  if (loaded.file.mesh_count() == 0)
    throw Failure(Exit::invalid, name, "", "no mesh", "drop the character that it is for");
  return loaded;
}

}  // namespace

Show::Show(std::string name, LoadedFile loaded, Images& images)
    : gl_(load_page_gl),
      studio_(gl_, 1, 1),
      strokes_(gl_),
      actor_(gl_, studio_.programs(), name, with_meshes(name, std::move(loaded)), images) {
  settings_.clip = actor_.plays().size() > 1 ? 1 : 0;
  settings_.normals = AsNormals::tangents;
  settings_.playback.mode = PlayMode::loop;
}

bool Show::add_plain(LoadedFile loaded, Images& images) {
  if (!Plain::fits(loaded.file, actor_.file())) return false;
  plain_ = std::make_unique<Plain>(gl_, studio_.programs(), std::move(loaded), images);
  return true;
}

void Show::set(const nlohmann::json& wanted) {
  const std::size_t clip = settings_.clip;
  if (wanted.contains("graph")) set_graph(wanted["graph"].get<int>());
  read_settings(wanted, actor_, settings_);
  if (wanted.contains("goals")) set_goals(wanted["goals"]);
  if (settings_.clip != clip && !wanted.contains("time_s")) settings_.playback.time_s = 0;
  if (wanted.contains("set") && actor_.rehearsal() != nullptr) set_parameters_of(wanted["set"], *actor_.rehearsal());
}

void Show::set_graph(int graph) {
  if (graph == settings_.graph) return;
  const std::vector<Graph> all = graphs_of(actor_.path(), actor_.file());
  if (graph < -1 || graph >= static_cast<int>(all.size()))
    throw Failure(Exit::usage, actor_.path(), "", "no graph " + std::to_string(graph), "the file has not so many");
  if (graph < 0) {
    actor_.stop_rehearsal();
  } else {
    const Graph& chosen = all[static_cast<std::size_t>(graph)];
    actor_.rehearse({actor_.path(), actor_.file(), chosen}, {});
  }
  settings_.graph = graph;
  settings_.overlays.steps = graph >= 0;
  settings_.framed = false;
}

// Those that can be reached for.
void Show::set_goals(const nlohmann::json& goals) {
  settings_.reach.goals.clear();
  trouble_.clear();
  const std::uint32_t least = settings_.reach.solver.method ? 1 : 2;
  for (const nlohmann::json& goal : goals) {
    const auto index = goal["joint"].get<std::size_t>();
    if (index >= actor_.joints().size()) continue;
    const NamedJoint& joint = actor_.joints()[index];
    const Skeleton skeleton = actor_.file().skeleton(joint.skeleton);
    const std::string name = actor_.file().text(skeleton.names[joint.joint]);
    if (bending_joints_above(actor_.file(), skeleton, joint.joint, least) < least) {
      trouble_ = name + " has too few joints above it to be pulled";
      continue;
    }
    settings_.reach.goals.push_back(goal_text(name, point_of(goal["at"])));
  }
}

void Show::turn(float dx, float dy) {
  turn_orbit(settings_.orbit, dx, dy);
}

void Show::move(float dx, float dy, float height) {
  settings_.orbit.target -= dragged_by(settings_.orbit, dx, dy, std::max(height, 1.0f), settings_.orbit.distance);
}

void Show::zoom(float steps) {
  zoom_orbit(settings_.orbit, steps, actor_.performance().radius());
}

glm::vec3 Show::drag_goal(std::size_t goal, float dx, float dy, float height) {
  if (goal >= settings_.reach.goals.size()) return glm::vec3(0);
  std::string& text = settings_.reach.goals[goal];
  const glm::vec3 from = goal_point(text);
  Orbit orbit = settings_.orbit;
  orbit.target += actor_.performance().followed(actor_.character());
  const glm::vec3 to = from + dragged_by(orbit, dx, dy, std::max(height, 1.0f), depth_of(orbit, from));
  text = goal_text(goal_name(text), to);
  return to;
}

nlohmann::ordered_json Show::frame(float dt_s, int width, int height) {
  if (settings_.playing && actor_.rehearsal() != nullptr) {
    if (dt_s > 0) actor_.rehearsal()->move_on(dt_s * settings_.playback.speed);
  } else if (settings_.playing) {
    check(advance(settings_.playback, actor_.plays()[settings_.clip].play.duration_s, dt_s));
  }
  actor_.pose(settings_, dt_s);
  draw(width, height);
  return now();
}

void Show::draw(int width, int height) {
  const Performance& performance = actor_.performance();
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  if (!settings_.framed) settings_.orbit = performance.orbit(aspect, kFrameMargin);
  settings_.framed = true;
  Orbit orbit = settings_.orbit;
  orbit.target += performance.followed(actor_.character());
  const Shot shot = performance.shot_by(camera_on(orbit, aspect, performance.radius()));
  const int n = settings_.coarseness;
  studio_.resize((width + n - 1) / n, (height + n - 1) / n);
  const auto left = static_cast<int>(std::lround(settings_.divide * static_cast<float>(width)));
  const bool halves = left < width && settings_.colours == Colours::surface;
  const auto show_from = [&](int from, int to) {
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Scissor(from, 0, to - from, height);
    studio_.show(0, 0, 0, width, height);
    gl_.Disable(GL_SCISSOR_TEST);
  };
  if (!halves || left > 0) {
    take_half(settings_.deformer, settings_.plain, shot);
    show_from(0, halves ? left : width);
  }
  if (halves) {
    take_half(settings_.other, settings_.plain_other, shot);
    show_from(left, width);
  }
  gl_.check("drawing");
  keep_places(shot.camera);
}

void Show::take_half(Deformer deformer, bool plain, Shot shot) {
  const Deformer before = std::exchange(settings_.deformer, deformer);
  // A picture that stands is as `marrow render` takes it.
  if (!settings_.playing) shot.box = box_of(actor_.posed(deformer));
  std::vector<Drawable> drawables = actor_.drawables(settings_, shot);
  const Overlays overlays = settings_.overlays;
  if (plain && plain_ && settings_.colours == Colours::surface) {
    drawables = plain_->drawables(actor_.character());
    settings_.overlays.wireframe = settings_.overlays.normals = false;  // they are the other's
  }
  add_strokes(actor_, settings_, shot, strokes_);
  settings_.overlays = overlays;
  studio_.take(shot, drawables, &strokes_);
  settings_.deformer = before;
}

void Show::keep_places(const Camera& camera) {
  places_.clear();
  const auto add = [&](glm::vec3 place) {
    const glm::vec4 clip = camera.clip_from_model * glm::vec4(place, 1);
    const float w = std::abs(clip.w) > 1e-20f ? clip.w : 1e-20f;
    places_.insert(places_.end(), {0.5f + 0.5f * clip.x / w, 0.5f - 0.5f * clip.y / w, clip.w});
  };
  for (std::size_t i = 0; i < actor_.joints().size(); ++i) add(joint_at(i));
  for (const std::string& goal : settings_.reach.goals) add(goal_point(goal));
}

glm::vec3 Show::joint_at(std::size_t joint) const {
  if (joint >= actor_.joints().size()) return glm::vec3(0);
  const NamedJoint& named = actor_.joints()[joint];
  const Affine& m = actor_.character().model_from_joint(named.skeleton)[named.joint];
  return {m.rows[0][3], m.rows[1][3], m.rows[2][3]};
}

nlohmann::ordered_json Show::now() const {
  const Orbit& orbit = settings_.orbit;
  nlohmann::ordered_json out = {{"time_s", settings_.playback.time_s},
                                {"duration_s", actor_.plays()[settings_.clip].play.duration_s},
                                {"orbit",
                                 {{"target", {orbit.target.x, orbit.target.y, orbit.target.z}},
                                  {"yaw", orbit.yaw},
                                  {"pitch", orbit.pitch},
                                  {"distance", orbit.distance}}},
                                {"heat_m", actor_.heat_scale()},
                                {"trouble", trouble_.empty() ? actor_.rig().trouble() : trouble_},
                                {"states", nlohmann::ordered_json::array()},
                                {"values", nlohmann::ordered_json::array()},
                                {"events", nlohmann::ordered_json::array()},
                                {"pose_ms", actor_.times().pose},
                                {"skin_ms", actor_.times().skin}};
  if (actor_.rehearsal() == nullptr) return out;
  const Rehearsal& rehearsal = *actor_.rehearsal();
  out["time_s"] = rehearsal.time_s();
  for (const MachineNow& m : rehearsal.behaviour().machines())
    out["states"].push_back({{"machine", m.machine}, {"state", m.state}, {"seconds", m.seconds}});
  for (std::uint32_t p = 0; p < rehearsal.behaviour().graph().parameters.size; ++p)
    out["values"].push_back(rehearsal.behaviour().wanted(p));
  for (const Rehearsal::Event& event : rehearsal.events())
    if (event.at_s > rehearsal.time_s() - 1) out["events"].push_back({{"name", event.name}, {"time_s", event.at_s}});
  return out;
}

}  // namespace marrow::tools
