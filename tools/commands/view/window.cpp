#include "commands/view/window.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "common/failure.h"
#include "gles3/mesh/gpu_mesh.h"
#include "gles3/program.h"

static_assert(GLFW_KEY_SPACE == marrow::tools::kKeySpace && GLFW_KEY_RIGHT == marrow::tools::kKeyRight &&
              GLFW_KEY_LEFT == marrow::tools::kKeyLeft && GLFW_KEY_HOME == marrow::tools::kKeyHome &&
              GLFW_KEY_END == marrow::tools::kKeyEnd && GLFW_KEY_DOWN == marrow::tools::kKeyDown &&
              GLFW_KEY_UP == marrow::tools::kKeyUp && GLFW_KEY_1 == marrow::tools::kKeyOne &&
              GLFW_KEY_9 == marrow::tools::kKeyOne + 8 && GLFW_KEY_S == marrow::tools::kKeyS &&
              GLFW_KEY_Y == marrow::tools::kKeyY && GLFW_KEY_Z == marrow::tools::kKeyZ &&
              GLFW_KEY_LEFT_BRACKET == marrow::tools::kKeySmaller &&
              GLFW_KEY_RIGHT_BRACKET == marrow::tools::kKeyLarger);

namespace marrow::embedded {
extern const unsigned char shader_panel_vert[], shader_panel_frag[];
}

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

const char* shader_text(const unsigned char* embedded) {
  return reinterpret_cast<const char*>(embedded);
}

// As OpenGL takes offsets into buffers.
const void* offset_pointer(std::size_t offset) {
  return reinterpret_cast<const void*>(static_cast<std::uintptr_t>(offset));
}

void point_attribute(const Gl& gl, GLuint location, int size, GLenum type, bool normalised, std::size_t offset) {
  gl.EnableVertexAttribArray(location);
  gl.VertexAttribPointer(location, size, type, normalised, sizeof(ImDrawVert), offset_pointer(offset));
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

Painter::Painter(const Gl& gl) : gl_(gl), font_(gl), vertices_(gl), indices_(gl), array_(gl) {
  std::array<char, 1024> log{};
  const gles3::ProgramSource source{
      shader_text(embedded::shader_panel_vert), shader_text(embedded::shader_panel_frag), {}};
  constexpr std::uint8_t kReads = gles3::kUvs | gles3::kColours;
  if (gles3::create_program(gl, {gles3::Deformer::none, 4, kReads}, source, 0, program_, log) != Status::ok)
    throw Failure(Exit::internal, "shader", "", log.data(), "please report this with the driver: " + gl.driver());
  gl.BindVertexArray(array_);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  gl.BindVertexArray(0);
  upload_fonts();
  gl.check("preparing the panel");
}

Painter::~Painter() {
  gles3::destroy(gl_, program_);
}

void Painter::upload_fonts() {
  unsigned char* rgba = nullptr;
  int width = 0, height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&rgba, &width, &height);
  gl_.BindTexture(GL_TEXTURE_2D, font_);
  gl_.TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, width, height);
  gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
}

void Painter::draw(const ImDrawData& data, const ImDrawCmd& command, int height) {
  // From points to pixels, and from the upper left to GL's lower left.
  const ImVec2 origin = data.DisplayPos, scale = data.FramebufferScale;
  const int left = static_cast<int>((command.ClipRect.x - origin.x) * scale.x);
  const int top = static_cast<int>((command.ClipRect.y - origin.y) * scale.y);
  const int right = static_cast<int>((command.ClipRect.z - origin.x) * scale.x);
  const int bottom = static_cast<int>((command.ClipRect.w - origin.y) * scale.y);
  if (right <= left || bottom <= top || command.UserCallback != nullptr) return;
  const std::size_t first = std::size_t{command.VtxOffset} * sizeof(ImDrawVert);
  point_attribute(gl_, gles3::kPositionLocation, 2, GL_FLOAT, false, first + offsetof(ImDrawVert, pos));
  point_attribute(gl_, gles3::kUvLocation, 2, GL_FLOAT, false, first + offsetof(ImDrawVert, uv));
  point_attribute(gl_, gles3::kColourLocation, 4, GL_UNSIGNED_BYTE, true, first + offsetof(ImDrawVert, col));
  gl_.Scissor(left, height - bottom, right - left, bottom - top);
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                   sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                   offset_pointer(std::size_t{command.IdxOffset} * sizeof(ImDrawIdx)));
}

void Painter::paint(const ImDrawData& data) {
  const int width = static_cast<int>(data.DisplaySize.x * data.FramebufferScale.x);
  const int height = static_cast<int>(data.DisplaySize.y * data.FramebufferScale.y);
  if (width <= 0 || height <= 0) return;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl_.Viewport(0, 0, width, height);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Enable(GL_BLEND);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.UseProgram(program_.id);
  const std::array<float, 4> window = {data.DisplayPos.x, data.DisplayPos.y, data.DisplaySize.x, data.DisplaySize.y};
  gl_.Uniform4fv(gl_.GetUniformLocation(program_.id, "window"), 1, window.data());
  gl_.Uniform1i(gl_.GetUniformLocation(program_.id, "font"), 0);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, font_);
  gl_.BindVertexArray(array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    gl_.BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data, GL_STREAM_DRAW);
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data, GL_STREAM_DRAW);
    for (const ImDrawCmd& command : list.CmdBuffer) draw(data, command, height);
  }
  gl_.BindVertexArray(0);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
  gl_.UseProgram(0);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Disable(GL_BLEND);
}

}  // namespace marrow::tools
