// A window with an OpenGL ES 3.0 context, by GLFW.
#pragma once

#include <string>
#include <utility>

struct GLFWwindow;

namespace marrow::tools {

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
  void swap();  // and hear what the user did
  std::pair<int, int> pixels() const;
  // How much larger than usual text has to be here.
  float scale() const;
  // Whether the space bar went down since the last call.
  bool space_pressed();
  GLFWwindow* glfw() const { return window_; }

 private:
  GLFWwindow* window_ = nullptr;
  bool space_down_ = false;
};

}  // namespace marrow::tools
