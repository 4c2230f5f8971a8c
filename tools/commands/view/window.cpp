#include "commands/view/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "common/failure.h"

static_assert(GLFW_KEY_SPACE == marrow::tools::kKeySpace && GLFW_KEY_RIGHT == marrow::tools::kKeyRight &&
              GLFW_KEY_LEFT == marrow::tools::kKeyLeft && GLFW_KEY_HOME == marrow::tools::kKeyHome &&
              GLFW_KEY_END == marrow::tools::kKeyEnd && GLFW_KEY_DOWN == marrow::tools::kKeyDown &&
              GLFW_KEY_UP == marrow::tools::kKeyUp && GLFW_KEY_1 == marrow::tools::kKeyOne &&
              GLFW_KEY_9 == marrow::tools::kKeyOne + 8 && GLFW_KEY_S == marrow::tools::kKeyS &&
              GLFW_KEY_Y == marrow::tools::kKeyY && GLFW_KEY_Z == marrow::tools::kKeyZ &&
              GLFW_KEY_LEFT_BRACKET == marrow::tools::kKeySmaller &&
              GLFW_KEY_RIGHT_BRACKET == marrow::tools::kKeyLarger);

namespace marrow::tools {
namespace {

std::string& last_error() {
  static std::string text;
  return text;
}

void keep_error(int, const char* text) {
  last_error() = text;
}

[[noreturn]] void refuse() {
  const std::string why = last_error().empty() ? "no window" : last_error();
  throw Failure(Exit::unsupported, "window", "", why,
                "run it where there is a display and OpenGL ES 3.0, or see `marrow render`");
}

}  // namespace

Window::Window(const std::string& title, int width, int height, bool wait_for_screen) {
  glfwSetErrorCallback(keep_error);
  if (glfwInit() == GLFW_FALSE) refuse();
  glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
  glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  // Told of resets, if the driver can.
  for (const int robustness : {GLFW_LOSE_CONTEXT_ON_RESET, GLFW_NO_ROBUSTNESS}) {
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, robustness);
    window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (window_ != nullptr) break;
  }
  if (window_ == nullptr) {
    glfwTerminate();
    refuse();
  }
  glfwMakeContextCurrent(window_);
  glfwSetWindowUserPointer(window_, this);
  // Before the panel's, which calls them in its turn.
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int mods) {
    const bool with_ctrl = (mods & GLFW_MOD_CONTROL) != 0;
    if (action != GLFW_RELEASE) ++static_cast<Window*>(glfwGetWindowUserPointer(window))->pressed_[{key, with_ctrl}];
  });
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    if (count > 0) static_cast<Window*>(glfwGetWindowUserPointer(window))->dropped_ = paths[0];
  });
  glfwSwapInterval(wait_for_screen ? 1 : 0);
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void* Window::load_proc(const char* name) {
  return reinterpret_cast<void*>(glfwGetProcAddress(name));
}

bool Window::closed() const {
  return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

void Window::stay_open() {
  glfwSetWindowShouldClose(window_, GLFW_FALSE);
}

void Window::swap() {
  glfwSwapBuffers(window_);
  glfwPollEvents();
}

std::pair<int, int> Window::pixels() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return {width, height};
}

float Window::scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return std::clamp(x, 1.0f, 4.0f);
}

void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}

bool Window::pressed(int key, bool with_ctrl) {
  return std::exchange(pressed_[{key, with_ctrl}], 0) > 0;
}

}  // namespace marrow::tools
