#include "commands/view/view.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include <imgui.h>

#include <backends/imgui_impl_glfw.h>

#include "commands/view/actor.h"
#include "commands/view/painter.h"
#include "commands/view/panel.h"
#include "commands/view/window.h"
#include "common/failure.h"
#include "common/files.h"
#include "common/formats.h"
#include "text/nearest.h"

namespace marrow::tools {
namespace {

constexpr float kFrameMargin = 0.09f;
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

std::vector<std::string> joint_names(const Actor& actor) {
  std::vector<std::string> out;
  for (const NamedJoint& joint : actor.joints()) out.push_back(joint.name);
  return out;
}

Settings first_settings(const ViewArguments& arguments, const std::optional<DeformerPair>& pair, const Actor& actor) {
  Settings s;
  s.clip = actor.chosen();
  // Without --clip the first there is.
  if (arguments.choice.clip.empty() && actor.plays().size() > 1) s.clip = 1;
  const float duration_s = actor.plays()[s.clip].play.duration_s;
  s.playback.time_s = static_cast<double>(std::clamp(arguments.choice.time_s, 0.0f, duration_s));
  s.playing = !arguments.held;
  s.deformer = arguments.deformer;
  s.path = arguments.path;
  s.normals = arguments.normals;
  s.lod = static_cast<int>(arguments.lod);
  s.bones = arguments.bones;
  if (pair) {
    s.colours = Colours::distance;
    s.pair = *pair;
  }
  if (arguments.weights.empty()) return s;
  const auto joint = std::ranges::find(actor.joints(), arguments.weights, &NamedJoint::name);
  if (joint == actor.joints().end())
    throw Failure(Exit::usage, arguments.file, "", "no joint \"" + arguments.weights + "\"",
                  suggestion(arguments.weights, joint_names(actor)));
  s.colours = Colours::weights;
  s.joint = static_cast<std::size_t>(joint - actor.joints().begin());
  return s;
}

class View {
 public:
  // What can be wrong with the arguments is found before there is a window.
  // settings: to begin with; none: the arguments'.
  View(const ViewArguments& arguments, const std::optional<Settings>& settings)
      : arguments_(arguments),
        size_(parse_size(arguments.size)),
        pair_(parse_pair(arguments.heatmap)),
        loaded_(load_level(arguments.file, arguments.lod)),
        chosen_(choose(arguments.file, loaded_.file, arguments.choice)),
        window_("marrow: " + std::filesystem::path(arguments.file).filename().string(), size_.first, size_.second,
                arguments.screenshot.empty()),
        context_(window_),
        gl_(Window::load_proc),
        painter_(gl_),
        studio_(gl_, 1, 1),
        actor_(gl_, studio_.programs(), arguments, std::move(loaded_), std::move(chosen_)),
        settings_(settings ? *settings : first_settings(arguments, pair_, actor_)) {
    // The processor draws a quarter of a million soft shadows in a second or so.
    if (!settings && arguments.screenshot.empty() && drawn_by_processor(gl_)) settings_.coarseness = 3;
  }

  void run() {
    while (!window_.closed()) {
      frame(passed_s());
      window_.swap();
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
  const Settings& settings() const { return settings_; }
  int frames() const { return frames_; }

 private:
  // Since the last call.
  float passed_s() {
    const auto now = std::chrono::steady_clock::now();
    const float seconds = std::chrono::duration<float>(now - last_).count();
    last_ = now;
    if (!first_) times_.add(1e3f * seconds);
    first_ = false;
    return std::min(seconds, kLongestStep);
  }

  void frame(float step_s) {
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    const auto [width, height] = window_.pixels();
    const float left = std::min(panel_width(window_.scale()), ImGui::GetIO().DisplaySize.x);
    const int panel_pixels = static_cast<int>(left * ImGui::GetIO().DisplayFramebufferScale.x);
    if (window_.space_pressed()) settings_.playing = !settings_.playing;
    if (settings_.playing) check(advance(settings_.playback, actor_.plays()[settings_.clip].play.duration_s, step_s));
    actor_.pose(settings_);
    if (width > panel_pixels && height > 0) draw_picture(panel_pixels, width - panel_pixels, height, left);
    show_panel(arguments_.file, actor_, times_, window_.scale(), settings_);
    ImGui::Render();
    painter_.paint(*ImGui::GetDrawData());
    gl_.check("drawing the panel");
    ++frames_;
  }

  void draw_picture(int x, int width, int height, float left) {
    const Performance& performance = actor_.performance();
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    if (!settings_.framed) settings_.orbit = performance.orbit(aspect, kFrameMargin);
    settings_.framed = true;
    use_mouse(ImGui::GetIO().DisplaySize.y, performance.radius(), settings_);
    Orbit orbit = settings_.orbit;
    orbit.target += performance.followed(actor_.character());
    Shot shot = performance.shot_by(camera_on(orbit, aspect, performance.radius()));
    const std::vector<Drawable> drawables = actor_.drawables(settings_, shot);
    const int n = settings_.coarseness;
    studio_.resize((width + n - 1) / n, (height + n - 1) / n);
    studio_.take(shot, drawables);
    studio_.show(0, x, 0, width, height);
    if (settings_.bones) draw_bones(actor_, settings_, shot.camera, left);
  }

  const ViewArguments& arguments_;
  std::pair<int, int> size_;
  std::optional<DeformerPair> pair_;
  LoadedFile loaded_;  // for the actor
  Chosen chosen_;      // likewise
  Window window_;
  PanelContext context_;
  Gl gl_;
  Painter painter_;
  Studio studio_;
  Actor actor_;
  Settings settings_;
  FrameTimes times_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  bool first_ = true;
  int frames_ = 0;
};

void run_to_the_end(const ViewArguments& arguments, View& view) {
  if (arguments.screenshot.empty()) return view.run();
  const Image image = view.run_for(arguments.frames);
  write_png(arguments.screenshot, image);
  std::fprintf(stderr, "%s: %dx%d, %s\n", arguments.screenshot.c_str(), image.width, image.height,
               view.gl().driver().c_str());
}

}  // namespace

void run_view(const ViewArguments& arguments) {
  if (!arguments.screenshot.empty()) {
    expect_extension(arguments.screenshot, {".png"});
    expect_writable(arguments.screenshot);
  }
  std::optional<Settings> settings;
  while (true) {
    View view(arguments, settings);
    try {
      return run_to_the_end(arguments, view);
    } catch (const ContextLost& lost) {
      // GLFW cannot give a window another context. Without a frame between two losses it would go on for ever.
      if (view.frames() == 0) throw;
      std::fprintf(stderr, "%s: %s: the window is opened anew\n", lost.file().c_str(), lost.rule().c_str());
      settings = view.settings();
    }
  }
}

}  // namespace marrow::tools
