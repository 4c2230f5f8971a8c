// From step 2 on: a window with OpenGL ES 3.0, a camera, a clock. Nothing in here is about skeletons.
#pragma once

#include <marrow/gles3.h>

#define GLFW_INCLUDE_ES3
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "load.h"

namespace gles3 = marrow::gles3;

struct Vec3 {
  float x = 0, y = 0, z = 0;
};
inline float dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vec3 unit(Vec3 a) {
  return {a.x / std::sqrt(dot(a, a)), a.y / std::sqrt(dot(a, a)), a.z / std::sqrt(dot(a, a))};
}

// What all of the tutorial's characters are lit by: a sun and a sky.
inline const char* const kFragment = R"(
precision highp float;
uniform vec3 base_colour;
in vec3 normal, colour;
out vec4 pixel;
void main() {
  vec3 n = normalize(normal);
  float sun = max(dot(n, normalize(vec3(-0.4, 0.7, 0.6))), 0.0), sky = 0.5 + 0.5 * n.y;
  vec3 light = sun * vec3(0.9, 0.8, 0.65) + sky * vec3(0.2, 0.25, 0.35);
  pixel = vec4(pow(base_colour * colour * light, vec3(1.0 / 2.2)), 1.0);
}
)";

class Window {
 public:
  gles3::Api gl;
  gles3::Caps caps;
  std::string file = "hero.mrw";
  Vec3 eye = {0.9f, 1.0f, 2.0f}, at = {0, 0.68f, 0};  // the camera
  int frame = 0, lose = -1;                           // lose: see step 8

  Window(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      if (word == "--frames" && i + 1 < argc)
        frames_ = std::atoi(argv[++i]);
      else if (word == "--picture" && i + 1 < argc)
        picture_ = argv[++i];
      else if (word == "--lose" && i + 1 < argc)
        lose = std::atoi(argv[++i]);
      else
        file = word;
    }
    glfwSetErrorCallback([](int, const char* text) { why() = text; });
    if (glfwInit() != GLFW_TRUE) fail("there is no screen: " + why());
    open();
  }

  // The window and its context, new. Step 8 calls it again.
  void open() {
    if (window_ != nullptr) glfwDestroyWindow(window_);
    window_ = nullptr;
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_SAMPLES, 4);
    for (const int robustness : {GLFW_LOSE_CONTEXT_ON_RESET, GLFW_NO_ROBUSTNESS}) {  // not every driver tells of resets
      glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, robustness);
      if (window_ == nullptr) window_ = glfwCreateWindow(640, 400, "Marrow", nullptr, nullptr);
    }
    if (window_ == nullptr) fail("there is no window with OpenGL ES 3.0: " + why());
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    must(load_api(gl, load_proc), "the driver's functions");
    must(query_caps(gl, caps), "what the driver can do");
  }

  // Begins a frame: false when the window is closed or the frames are over.
  bool begin(float& dt_s) {
    glfwPollEvents();
    if (glfwWindowShouldClose(window_) || (frames_ > 0 && frame == frames_)) return false;
    const double now = glfwGetTime(), passed = now - then_;
    then_ = now;
    dt_s = frames_ > 0 || frame == 0 ? 1.0f / 60 : float(std::min(passed, 0.1));
    ++frame;
    return true;
  }

  // The screen, empty. Call it after what draws into textures.
  void clear() {
    glfwGetFramebufferSize(window_, &width_, &height_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.Viewport(0, 0, width_, height_);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_CULL_FACE);
    reinterpret_cast<PFNGLCLEARCOLORPROC>(load_proc("glClearColor"))(0.55f, 0.7f, 0.8f, 1);
    reinterpret_cast<PFNGLCLEARPROC>(load_proc("glClear"))(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }

  // A program in use, with the camera.
  void use(unsigned program, const float* base_colour) const {
    const Vec3 z = unit({eye.x - at.x, eye.y - at.y, eye.z - at.z}), x = unit(cross({0, 1, 0}, z)), y = cross(z, x);
    const float tall = 1 / 0.36f, wide = tall * float(height_) / float(std::max(width_, 1));
    const float a = -60.1f / 59.9f, b = -2 * 60 * 0.1f / 59.9f;  // from 0.1 to 60 m
    // Column after column, as GL takes it.
    const float clip_from_model[4][4] = {{wide * x.x, tall * y.x, a * z.x, -z.x},
                                         {wide * x.y, tall * y.y, a * z.y, -z.y},
                                         {wide * x.z, tall * y.z, a * z.z, -z.z},
                                         {-wide * dot(x, eye), -tall * dot(y, eye), b - a * dot(z, eye), dot(z, eye)}};
    gl.UseProgram(program);
    gl.UniformMatrix4fv(gl.GetUniformLocation(program, "clip_from_model"), 1, GL_FALSE, clip_from_model[0]);
    gl.Uniform3fv(gl.GetUniformLocation(program, "base_colour"), 1, base_colour);
  }

  // Ends a frame: saves the last as a picture (PPM), and shows it.
  void end() {
    if (frame == frames_ && !picture_.empty()) {
      std::vector<char> rows(4 * std::size_t(width_) * std::size_t(height_));
      gl.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
      std::ofstream out(picture_, std::ios::binary);
      out << "P6 " << width_ << " " << height_ << " 255\n";
      for (int y = height_ - 1; y >= 0; --y)  // GL begins at the bottom
        for (int x = 0; x < width_; ++x) out.write(&rows[4 * std::size_t(y * width_ + x)], 3);
      if (!out.flush()) fail(picture_ + ": cannot be written");
    }
    glfwSwapBuffers(window_);
  }

  unsigned compile(const std::string& vertex, const std::string& fragment) const {
    const unsigned program = gl.CreateProgram();
    for (const GLenum kind : {GLenum{GL_VERTEX_SHADER}, GLenum{GL_FRAGMENT_SHADER}}) {
      const std::string text = "#version 300 es\n" + (kind == GL_VERTEX_SHADER ? vertex : fragment);
      const char* const begin = text.c_str();
      const unsigned shader = gl.CreateShader(kind);
      gl.ShaderSource(shader, 1, &begin, nullptr);
      gl.CompileShader(shader);
      gl.AttachShader(program, shader);
      gl.DeleteShader(shader);
    }
    gl.LinkProgram(program);
    int linked = 0;
    char log[512] = "";
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    gl.GetProgramInfoLog(program, sizeof log, nullptr, log);
    if (!linked) fail(std::string("a shader does not compile: ") + log);
    return program;
  }

  bool pressed(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }

 private:
  static void* load_proc(const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); }

  static std::string& why() {
    static std::string text;
    return text;
  }

  GLFWwindow* window_ = nullptr;
  std::string picture_;
  int frames_ = 0, width_ = 0, height_ = 0;
  double then_ = 0;
};
