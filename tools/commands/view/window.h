// A window with an OpenGL ES 3.0 context, by GLFW, and the painter of its panel.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "render/gl.h"

struct GLFWwindow;
struct ImDrawData;
struct ImDrawCmd;

namespace marrow::tools {

// As GLFW numbers them.
inline constexpr int kKeySpace = 32, kKeyRight = 262, kKeyLeft = 263, kKeyHome = 268, kKeyEnd = 269;
inline constexpr int kKeyDown = 264, kKeyUp = 265, kKeyOne = 49;
inline constexpr int kKeyS = 83, kKeyY = 89, kKeyZ = 90, kKeySmaller = 91, kKeyLarger = 93;  // [ and ]

class Window {
 public:
  // Its context is current. Throws Failure (unsupported) where there is no display or no such context.
  Window(const std::string& title, int width, int height, bool wait_for_screen);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  // Of the context.
  static void* load_proc(const char* name);

  bool closed() const;
  void stay_open();  // though it was to be closed
  void swap();       // and hear what the user did
  std::pair<int, int> pixels() const;
  // How much larger than usual text has to be here.
  float scale() const;
  void set_title(const std::string& title);
  // Whether this key went down since the last call, or is held for so long that it repeats. With or without Ctrl held.
  bool pressed(int key, bool with_ctrl = false);
  // The file that was dropped on it since the last call, of several the first; empty: none.
  std::string dropped() { return std::exchange(dropped_, ""); }
  GLFWwindow* glfw() const { return window_; }

 private:
  GLFWwindow* window_ = nullptr;
  std::map<std::pair<int, bool>, int> pressed_;  // how often, by key and whether with Ctrl
  std::string dropped_;
};

// Draws what Dear ImGui leaves, by the tools' own OpenGL functions: its backend as packaged is built for desktop
// OpenGL.
class Painter {
 public:
  // After the fonts are chosen: they go up now. Throws Failure (internal) if the driver refuses. `gl` outlives it.
  explicit Painter(const Gl& gl);
  ~Painter();
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  // Into the window.
  void paint(const ImDrawData& data);

 private:
  void upload_fonts();
  void draw(const ImDrawData& data, const ImDrawCmd& command, int height);

  const Gl& gl_;
  gles3::Program program_;
  GlTexture font_;
  GlBuffer vertices_, indices_;
  GlVertexArray array_;
};

}  // namespace marrow::tools
