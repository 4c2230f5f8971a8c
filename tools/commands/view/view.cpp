#include "commands/view/view.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <imgui.h>

#include <backends/imgui_impl_glfw.h>

#include "commands/view/first_settings.h"
#include "commands/view/keys.h"
#include "commands/view/opening.h"
#include "commands/view/overlay/picture.h"
#include "commands/view/panel/panel.h"
#include "commands/view/view_actor.h"
#include "commands/view/window.h"
#include "common/failure.h"
#include "common/formats.h"
#include "disk/files.h"
#include "stage/actor.h"
#include "stage/among_figures.h"
#include "stage/recording.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::tools {
namespace {

constexpr float kFirstBrush = 0.12f;             // of the figure's radius
constexpr float kLongestStep = 0.5f;             // seconds: who stops the program does not miss the clip
constexpr float kScreenshotStep = 1.0f / 60.0f;  // seconds a frame

class PanelContext {
 public:
  explicit PanelContext(const Window& window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // no files in the working directory
    ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    set_panel_style(window.scale());
    ImGui_ImplGlfw_InitForOther(window.glfw(), true);
  }
  ~PanelContext() {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  PanelContext(const PanelContext&) = delete;
  PanelContext& operator=(const PanelContext&) = delete;
};

// Drivers without a graphics processor, by their names.
bool drawn_by_processor(const Gl& gl) {
  const auto named = [&](const char* name) { return gl.driver().find(name) != std::string::npos; };
  return named("llvmpipe") || named("softpipe") || named("SwiftShader");
}

std::vector<std::string> packs_of(const ViewArguments& arguments) {
  if (arguments.by_graph) return arguments.behaviour.clips;
  return arguments.choice.clips.empty() ? std::vector<std::string>() : std::vector<std::string>{arguments.choice.clips};
}

// The window's name says what is in it.
std::string title_of(const Source& source) {
  return "marrow: " + std::filesystem::path(source.path).filename().string() +
         (source.cooked_here ? " (cooked in memory)" : "");
}

class View {
 public:
  // What can be wrong with the arguments is found before there is a window.
  // settings: to begin with; none: the arguments'.
  View(const ViewArguments& arguments, const std::optional<ViewSettings>& settings)
      : arguments_(arguments),
        size_(parse_size(arguments.size)),
        pair_(parse_pair(arguments.heatmap)),
        opening_(arguments.images_from, arguments.by_graph ? Opens::models_by_graph : Opens::models,
                 packs_of(arguments), !arguments.screenshot.empty()),
        source_(opening_.open(arguments.file)),
        chosen_(choose_first()),
        window_(title_of(source_), size_.first, size_.second, arguments.screenshot.empty()),
        context_(window_),
        gl_(Window::load_proc),
        painter_(gl_),
        studio_(gl_, 1, 1),
        strokes_(gl_),
        actor_(std::make_unique<ViewActor>(gl_, studio_.programs(), arguments.choice, std::move(source_),
                                           std::move(chosen_))),
        graph_(first_graph()),
        settings_(settings ? *settings : first_settings(arguments, pair_, *actor_)) {
    // The processor draws a quarter of a million soft shadows in a second or so.
    if (!settings && arguments.screenshot.empty() && drawn_by_processor(gl_)) settings_.coarseness = 3;
  }

  void run() {
    while (true) {
      frame(passed_s());
      window_.swap();
      if (window_.closed() && may_close()) return;
    }
  }

  // Time goes in even steps, so that the same pictures come out.
  Image run_for(int frames) {
    for (int i = 0; i < frames; ++i) {
      if (i > 0) window_.swap();
      passed_s();
      frame(i == 0 ? 0 : kScreenshotStep);
    }
    const auto [width, height] = window_.pixels();
    return read_pixels(gl_, 0, width, height);
  }
  const Gl& gl() const { return gl_; }
  const ViewSettings& settings() const { return settings_; }
  // With the file that is on show now.
  const ViewArguments& arguments() const { return arguments_; }
  int frames() const { return frames_; }

  // What is painted and not saved; empty: nothing.
  std::vector<cook::PaintedMesh> unsaved_paint() {
    Painting* const painting = actor_->painting();
    return painting == nullptr || painting->saved() ? std::vector<cook::PaintedMesh>{} : painting->painted();
  }
  const Rehearsal* rehearsal() const { return actor_->rehearsal(); }
  // What is set of a graph, and where it has come to; nothing where none plays.
  std::optional<Rehearsal::Kept> rehearsed() const {
    return actor_->rehearsal() == nullptr ? std::nullopt : std::optional(actor_->rehearsal()->kept());
  }
  void rehearse(const std::optional<Rehearsal::Kept>& kept) {
    if (kept && actor_->rehearsal() != nullptr) actor_->rehearsal()->take(*kept);
  }
  void paint(const std::vector<cook::PaintedMesh>& painted) {
    if (!painted.empty()) actor_->painting(settings_).add(painted);
  }

 private:
  // The first time not, if it would lose what is painted.
  bool may_close() {
    if (unsaved_paint().empty() || warned_) return true;
    warned_ = true;
    opening_.set_error("What is painted is not saved: press Ctrl S, or close the window again to lose it.");
    window_.stay_open();
    return false;
  }

  Chosen choose_first() {
    expect_level(arguments_.file, source_.file(), arguments_.lod);
    const Reach goals(source_.file(), arguments_.reach);  // throws what is wrong with them
    if (arguments_.by_graph)
      const Behaviour tried(arguments_.file, source_.file(),
                            find_graph(arguments_.file, source_.file(), arguments_.behaviour.graph),
                            arguments_.behaviour.clips);  // likewise
    return choose(arguments_.file, source_.file(), arguments_.choice);
  }

  // What the arguments say, which the actor plays then.
  std::optional<GraphOnDisk> first_graph() {
    if (!arguments_.by_graph) return std::nullopt;
    GraphOnDisk out(arguments_.behaviour.graph, !arguments_.screenshot.empty());
    actor_->rehearse(out.read(arguments_.file, actor_->file()), arguments_.behaviour.clips);
    return out;
  }

  // Its text may have changed. What cannot be played is said, and the last good one plays on.
  void look_for_graph() {
    if (!graph_) return;
    std::optional<FoundGraph> found = graph_->poll(arguments_.file, actor_->file());
    if (!found) return;
    try {
      actor_->rehearse(std::move(*found), arguments_.behaviour.clips);
      settings_.parameter = first_number(actor_->rehearsal()->behaviour().graph());
    } catch (const Failure& why) {
      graph_->set_error(why.what());
    }
  }

  // Since the last call.
  float passed_s() {
    const auto now = std::chrono::steady_clock::now();
    const float seconds = std::chrono::duration<float>(now - last_).count();
    last_ = now;
    if (!first_) times_.add(1e3f * seconds);
    first_ = false;
    return std::min(seconds, kLongestStep);
  }

  // What was dropped, and what has changed on the disk.
  void look_for_files() {
    const std::string dropped = window_.dropped();
    if (!dropped.empty() && dropped != arguments_.file && !unsaved_paint().empty()) {
      opening_.set_error("What is painted is not saved: press Ctrl S, or undo it, before another file is opened.");
    } else if (!dropped.empty()) {
      opening_.drop(dropped);
    }
    std::optional<Source> source = opening_.poll();
    if (!source) return;
    const bool same = source->path == arguments_.file;
    const std::string source_path = source->path;
    Choice choice = same ? arguments_.choice : Choice();
    if (choice.clips.empty()) choice.clip.clear();
    try {
      Chosen chosen = choose(source->path, source->file(), choice);
      auto next = std::make_unique<ViewActor>(gl_, studio_.programs(), choice, std::move(*source), std::move(chosen));
      if (graph_) {
        next->rehearse(graph_->read(source_path, next->file()), arguments_.behaviour.clips);
        next->rehearsal()->take(actor_->rehearsal()->kept());
      }
      if (same && !unsaved_paint().empty()) next->painting(settings_).add(unsaved_paint());
      carry_over(*actor_, *next, settings_);
      if (!same) settings_.paint_file.clear();
      actor_ = std::move(next);
    } catch (const ContextLost&) {
      throw;
    } catch (const Failure& why) {
      return opening_.set_error(why.what());
    }
    if (!same) {
      settings_.framed = false;
      settings_.reach.goals.clear();
      settings_.weights.clear();
      settings_.parameters.clear();
    }
    arguments_.file = actor_->source().path;
    arguments_.choice = choice;
    window_.set_title(title_of(actor_->source()));
  }

  void save_paint() {
    if (!std::exchange(settings_.save_paint, false) || !actor_->paints(settings_)) return;
    warned_ = false;
    try {
      actor_->painting(settings_).save();
      opening_.set_error("");
    } catch (const Failure& why) {
      opening_.set_error(why.what());
    }
  }

  // After the first pose: before it, nobody knows how large the figure is.
  void choose_brush() {
    ViewSettings& s = settings_;
    if (s.painting && !(s.brush.radius > 0)) s.brush.radius = kFirstBrush * actor_->performance().radius();
  }

  void frame(float step_s) {
    look_for_files();
    look_for_graph();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    const auto [width, height] = window_.pixels();
    const float left = std::min(panel_width(window_.scale()), ImGui::GetIO().DisplaySize.x);
    const int panel_pixels = static_cast<int>(left * ImGui::GetIO().DisplayFramebufferScale.x);
    if (!ImGui::GetIO().WantTextInput) use_keys(window_, *actor_, settings_);
    if (settings_.playing) play(step_s);
    if (settings_.painting) settings_.lod = 0;
    pose(step_s);
    choose_brush();
    if (width > panel_pixels && height > 0) draw_picture(panel_pixels, width - panel_pixels, height, left);
    show_panel({times_, window_.scale()}, *actor_, settings_);
    save_paint();
    const bool graph_is_wrong = graph_ && !graph_->error().empty();
    show_notes(opening_.busy_with(), graph_is_wrong ? graph_->error() : opening_.error(), left, window_.scale());
    ImGui::Render();
    painter_.paint(*ImGui::GetDrawData());
    gl_.check("drawing the panel");
    ++frames_;
  }

  void play(float step_s) {
    if (actor_->rehearsal() == nullptr)
      return check(advance(settings_.playback, actor_->plays()[settings_.clip].play.duration_s, step_s));
    if (step_s > 0) actor_->rehearsal()->move_on(step_s * settings_.playback.speed);
  }

  // Goals beyond what can be solved, and the like, are said in the window, and go.
  void pose(float step_s) {
    try {
      actor_->pose(settings_, step_s);
    } catch (const ContextLost&) {
      throw;
    } catch (const Failure& why) {
      if (settings_.reach.goals.empty()) throw;
      opening_.set_error(why.what());
      settings_.reach.goals.clear();
      actor_->pose(settings_, step_s);
    }
  }

  void draw_picture(int x, int width, int height, float left) {
    const Performance& performance = actor_->performance();
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    if (!settings_.framed) settings_.orbit = performance.orbit(aspect, kFrameMargin);
    settings_.framed = true;
    Orbit orbit = settings_.orbit;
    orbit.target += performance.followed(actor_->character());
    Shot shot = performance.shot_by(camera_on(orbit, aspect, performance.radius()));
    Drawer drawer(shot.camera, left);
    bool at_work = false;
    if (actor_->paints(settings_)) {
      const NamedJoint& joint = actor_->joints()[settings_.joint];
      actor_->painting(settings_).pose(actor_->character());
      at_work = use_brush(actor_->painting(settings_), shot.camera, left, joint.skeleton, joint.joint, settings_.brush,
                          hand_);
    }
    if (!at_work) use_mouse(*actor_, drawer, ImGui::GetIO().DisplaySize.y, dragging_, settings_);
    const std::vector<Drawable> drawables = actor_->drawables(settings_, shot);
    add_strokes(*actor_, settings_, shot, strokes_);
    const int n = settings_.coarseness;
    studio_.resize((width + n - 1) / n, (height + n - 1) / n);
    studio_.take(shot, drawables, &strokes_);
    studio_.show(0, x, 0, width, height);
    draw_joints(*actor_, settings_, drawer);
    if (actor_->paints(settings_)) draw_brush(hand_, settings_.brush, drawer);
  }

  ViewArguments arguments_;
  std::pair<int, int> size_;
  std::optional<DeformerPair> pair_;
  Opening opening_;
  Source source_;  // for the first actor
  Chosen chosen_;  // likewise
  Window window_;
  PanelContext context_;
  Gl gl_;
  Painter painter_;
  Studio studio_;
  Strokes strokes_;
  std::unique_ptr<ViewActor> actor_;
  std::optional<GraphOnDisk> graph_;  // none: clips play
  ViewSettings settings_;
  Dragging dragging_;
  BrushHand hand_;
  bool warned_ = false;  // of what is painted and would be lost
  FrameTimes times_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  bool first_ = true;
  int frames_ = 0;
};

// "hero at 1.650 s: body air 0.420 s", a machine each.
std::string what_happens(const Rehearsal& rehearsal) {
  std::string out = fmt::format("{} at {:.3f} s", rehearsal.behaviour().graph().name, rehearsal.time_s());
  const char* before = ": ";
  for (const MachineNow& machine : rehearsal.behaviour().machines()) {
    out += fmt::format("{}{} {} {:.3f} s", std::exchange(before, ", "), machine.machine,
                       machine.state.empty() ? "not shown" : machine.state, static_cast<double>(machine.seconds));
  }
  return printable(out);
}

void run_to_the_end(const ViewArguments& arguments, View& view) {
  if (arguments.screenshot.empty()) return view.run();
  const Image image = view.run_for(arguments.frames);
  write_png(arguments.screenshot, image);
  std::fprintf(stderr, "%s: %dx%d, %s\n", arguments.screenshot.c_str(), image.width, image.height,
               view.gl().driver().c_str());
  if (view.rehearsal() != nullptr) std::fprintf(stderr, "%s\n", what_happens(*view.rehearsal()).c_str());
}

}  // namespace

void run_view(const ViewArguments& arguments) {
  if (!arguments.screenshot.empty()) {
    expect_extension(arguments.screenshot, {".png"});
    expect_writable(arguments.screenshot);
  }
  if (!arguments.paint_file.empty()) {
    expect_extension(arguments.paint_file, {".json"});
    expect_writable(arguments.paint_file);
  }
  std::optional<ViewSettings> settings;
  std::vector<cook::PaintedMesh> painted;  // and not saved
  std::optional<Rehearsal::Kept> rehearsed;
  ViewArguments shown = arguments;
  while (true) {
    View view(shown, settings);
    try {
      view.paint(painted);
      view.rehearse(rehearsed);
      return run_to_the_end(shown, view);
    } catch (const ContextLost& lost) {
      // GLFW cannot give a window another context. Without a frame between two losses it would go on for ever.
      if (view.frames() == 0) throw;
      std::fprintf(stderr, "%s: %s: the window is opened anew\n", lost.file().c_str(), lost.rule().c_str());
      settings = view.settings();
      painted = view.unsaved_paint();
      rehearsed = view.rehearsed();
      shown = view.arguments();
    }
  }
}

}  // namespace marrow::tools
