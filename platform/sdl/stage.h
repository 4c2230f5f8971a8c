// What any game by SDL has around its characters: a window with a context, a camera, the sun, the ground, a clock.
#pragma once

#include <marrow/gles3_skinner.h>

#include <SDL.h>
#include <SDL_opengles2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

namespace gles3 = marrow::gles3;

// What the command line asks for.
struct Options {
  std::string file = "newt.mrw", shot;  // shot: a picture of the last frame, as BMP
  long frames = 0;                      // after so many the game ends; 0: it goes on
  long lose = -1;                       // in this frame the context is lost
  double step_s = 0;                    // the time from frame to frame; 0: what it takes
  int width = 960, height = 540;        // of the window
  bool watch = false;                   // tells of every GL error, and which call it was
};
inline Options options;

// Ends the game with a message. One that somebody watches shows it in a box, too.
[[noreturn]] inline void fail(const std::string& what) {
  std::fprintf(stderr, "game: %s\n", what.c_str());
  if (options.frames == 0)
    SDL_ShowSimpleMessageBox(SDL_MESSAGEBOX_ERROR, "The game cannot go on", what.c_str(), nullptr);
  std::exit(1);
}
inline void must(marrow::Status status, const char* doing, const char* log = "") {
  if (status != marrow::Status::ok) fail(std::string(doing) + ": " + to_string(status) + (*log ? ". " : "") + log);
}

inline void read_options(int argc, char** argv) {
  const auto refuse = [](const std::string& what) {  // whoever types options reads what is wrong where they were typed
    std::fprintf(stderr,
                 "game: %s; usage: game [FILE.mrw] [--frames N] [--shot OUT.bmp] [--lose FRAME] "
                 "[--step SECONDS, or 1/60] [--size WIDTHxHEIGHT] [--watch]\n",
                 what.c_str());
    std::exit(1);
  };
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name.compare(0, 2, "--") != 0) {
      options.file = name;
      continue;
    }
    if (name == "--watch") {
      options.watch = true;
      continue;
    }
    if (++i == argc) refuse(name + ": a value is missing");
    char* end = argv[i] + std::strlen(argv[i]);
    if (name == "--frames")
      options.frames = std::strtol(argv[i], &end, 10);
    else if (name == "--lose")
      options.lose = std::strtol(argv[i], &end, 10);
    else if (name == "--step") {
      options.step_s = std::strtod(argv[i], &end);
      if (*end == '/') options.step_s /= std::strtod(end + 1, &end);
    } else if (name == "--size") {
      options.width = int(std::strtol(argv[i], &end, 10));
      if (*end == 'x') options.height = int(std::strtol(end + 1, &end, 10));
    } else if (name == "--shot")
      options.shot = argv[i];
    else
      refuse(name + ": no such option");
    if (*end != 0 || !(options.step_s >= 0 && options.step_s < 10)) refuse(name + " " + argv[i] + ": no number");
  }
}

// The ground, by one text in C++ and in the shader: a bumpy bank along z, terraces to both sides. Metres, y is up.
#define STAGE_HILL                                                                                     \
  float hill(float x, float z) {                                                                       \
    float across = x < -1.2f ? -1.2f : x > 1.2f ? 1.2f : x, away = x < 0.0f ? -x : x;                  \
    float bank = across / 1.2f, bumps = (1.0f - bank * bank) * (1.0f - bank * bank);                   \
    float steps = away < 1.4f ? 0.0f : (away - 1.4f) / 1.6f, rise = (steps - floor(steps)) * 4.0f;     \
    float part = rise > 1.0f ? 1.0f : rise, level = floor(steps) + part * part * (3.0f - 2.0f * part); \
    return 0.2f * across + 0.35f * level + bumps * (0.10f * sin(1.7f * z) + 0.03f * sin(4.1f * z));    \
  }
#define STAGE_QUOTE(...) #__VA_ARGS__
#define STAGE_TEXT(...) STAGE_QUOTE(__VA_ARGS__)
using std::floor, std::sin;
inline STAGE_HILL;

// Texts of shaders. What all share is the light: a warm sun with shadows, a cool sky, haze far away; sRGB goes out.
inline const std::string kLight = R"(
precision highp float;
uniform highp sampler2DShadow shadows;
uniform mat4 sun_from_model;
uniform vec3 eye, to_sun;
out vec4 pixel;
const vec3 kHaze = vec3(0.95, 0.66, 0.46);
void put(vec3 c) {
  c = 1.25 * c / (1.0 + 0.7 * c);
  pixel = vec4(mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308))), 1.0);
}
void show(vec3 colour, vec3 at, vec3 normal, float gloss) {
  vec3 spot = 0.5 + 0.5 * (sun_from_model * vec4(at + 0.015 * normal, 1.0)).xyz;
  float lit = 0.0;
  for (int i = 0; i < 4; ++i) {
    vec3 beside = vec3(i % 2 == 0 ? 1.0 : -1.0, i / 2 == 0 ? 1.0 : -1.0, 0.0) / 3000.0;
    lit += 0.25 * texture(shadows, spot + beside);
  }
  vec3 to_eye = normalize(eye - at);
  float sky = 0.5 + 0.5 * normal.y, rim = pow(1.0 - max(dot(normal, to_eye), 0.0), 4.0) * sky;
  float shine = lit * pow(max(dot(normal, normalize(to_sun + to_eye)), 0.0), mix(18.0, 220.0, gloss));
  vec3 sun = lit * max(dot(normal, to_sun), 0.0) * vec3(2.1, 1.65, 1.15);
  vec3 c = colour * (sun + mix(vec3(0.20, 0.14, 0.12), vec3(0.26, 0.34, 0.54), sky));
  c += shine * mix(0.08, 0.9, gloss) * vec3(1.0, 0.95, 0.85) + 0.12 * rim * vec3(0.8, 0.9, 1.0);
  put(mix(kHaze, c, exp(-0.0012 * dot(eye - at, eye - at))));
}
)";
inline const std::string kSkinVertex = R"(
uniform mat4 clip_from_model;
out vec3 at, normal, colour, hue;
void main() {
  MarrowVertex v = marrow_skin();
  at = v.position;
  normal = v.normal;
  colour = vec3(1.0);
#if MARROW_COLOUR
  colour = in_colour.rgb;
#endif
  hue = vec3(1.0) - marrow_instance_colour().rgb;
  gl_Position = clip_from_model * vec4(at, 1.0);
}
)";
inline const std::string kSkinFragment = kLight + R"(
uniform vec3 base_colour;
uniform float gloss;
in vec3 at, normal, colour, hue;
void main() {
  // Not of each is the body teal.
  vec3 c = gloss > 0.5 ? colour : mix(mix(colour, colour.brg, hue.r), colour.gbr, hue.g);
  show(c * base_colour, at, normalize(normal), gloss);
}
)";
inline const char* const kShadowVertex = R"(
uniform mat4 clip_from_model;
void main() { gl_Position = clip_from_model * vec4(marrow_skin().position, 1.0); }
)";
inline const char* const kShadowFragment = "void main() {}\n";
// A grid without buffers. It moves by whole cells, so that its corners stay where they are in the world.
inline const char* const kGroundVertex = "#version 300 es\nprecision highp float;\n" STAGE_TEXT(STAGE_HILL) R"(
uniform mat4 clip_from_model;
uniform float walked;
out vec3 at;
void main() {
  int cell = gl_VertexID / 6, corner = gl_VertexID % 6;
  bool right = corner == 1 || corner == 3 || corner == 4, back = corner == 2 || corner == 4 || corner == 5;
  ivec2 place = ivec2(cell % 120, cell / 120) + ivec2(right, back);
  at.xz = 0.25 * vec2(place) - vec2(15.0, 31.0 + mod(walked, 0.25));
  at.y = hill(at.x, at.z + walked);
  gl_Position = clip_from_model * vec4(at, 1.0);
}
)";
inline const std::string kGroundFragment = "#version 300 es\n" + kLight + STAGE_TEXT(STAGE_HILL) + R"(
uniform float walked;
in vec3 at;
void main() {
  float z = at.z + walked;
  vec2 slope = vec2(hill(at.x + 0.02, z) - hill(at.x - 0.02, z), hill(at.x, z + 0.02) - hill(at.x, z - 0.02)) / 0.04;
  vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
  float grain = sin(5.0 * at.x + 2.0 * sin(3.1 * z)) * sin(4.3 * z + 2.0 * sin(2.7 * at.x));
  float fine = sin(31.0 * at.x + 5.0 * grain) * sin(27.0 * z + 4.0 * sin(9.0 * at.x));
  float path = 1.0 - smoothstep(0.95, 1.25, abs(at.x) + 0.10 * grain);
  float furrow = path * (1.0 - smoothstep(0.05, 0.16, abs(fract(2.5 * z + 0.12 * grain) - 0.5)));
  vec3 c = mix(vec3(0.25, 0.15, 0.09), vec3(0.14, 0.22, 0.06), smoothstep(0.86, 0.99, normal.y));
  c = mix(c, vec3(0.42, 0.28, 0.17), path) * (1.0 - 0.20 * furrow);
  show(c * (1.0 + 0.08 * grain + 0.05 * fine), at, normal, 0.0);
}
)";

inline const char* const kSkyVertex = R"(#version 300 es
out vec2 at;
void main() {
  at = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
  gl_Position = vec4(at, 0.0, 1.0);
}
)";
inline const std::string kSkyFragment = "#version 300 es\n" + kLight + R"(
in vec2 at;
void main() { put(mix(kHaze, vec3(0.20, 0.34, 0.52), smoothstep(0.3, 1.5, at.y + 0.2 * at.x))); }
)";

// Column after column, as GL takes them.
struct Matrix {
  float m[16];
};
struct Vector {
  float v[3];
};
inline float dot(const Vector& a, const Vector& b) {
  return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {{a.v[1] * b.v[2] - a.v[2] * b.v[1], a.v[2] * b.v[0] - a.v[0] * b.v[2], a.v[0] * b.v[1] - a.v[1] * b.v[0]}};
}
inline Vector unit(const Vector& a) {
  const float length = std::sqrt(dot(a, a));
  return {{a.v[0] / length, a.v[1] / length, a.v[2] / length}};
}

// Looks along -back from `eye`. wide, tall: what half of the picture is as a tangent, or in metres without perspective.
inline Matrix look(const Vector& eye, const Vector& back, float wide, float tall, float nearest, float farthest,
                   bool perspective) {
  const Vector z = unit(back), x = unit(cross({{0, 1, 0}}, z)), y = cross(z, x);
  const float a = perspective ? -(farthest + nearest) / (farthest - nearest) : -2 / (farthest - nearest);
  const float b =
      perspective ? -2 * farthest * nearest / (farthest - nearest) : -(farthest + nearest) / (farthest - nearest);
  Matrix out = {};
  for (int i = 0; i < 3; ++i) {
    out.m[4 * i] = x.v[i] / wide;
    out.m[4 * i + 1] = y.v[i] / tall;
    out.m[4 * i + 2] = a * z.v[i];
    out.m[4 * i + 3] = perspective ? -z.v[i] : 0;
  }
  out.m[12] = -dot(x, eye) / wide;
  out.m[13] = -dot(y, eye) / tall;
  out.m[14] = b - a * dot(z, eye);
  out.m[15] = perspective ? dot(z, eye) : 1;
  return out;
}

enum Role : std::uint32_t { kColour, kShadow };
constexpr int kShadowSide = 2048;
constexpr int kShadowUnit = 7;  // of textures; Marrow takes those that it is given

struct Stage {
  SDL_Window* window = nullptr;
  SDL_GLContext context = nullptr;
  gles3::Api gl;
  gles3::Caps caps;
  gles3::ErrorWatch watch;
  long gl_errors = 0;
  void (*clear)(unsigned) = nullptr;  // Marrow needs none, so its Api has it not
  int width = 0, height = 0;          // pixels
  int screen = 0;                     // its framebuffer, which on iOS is not 0
  unsigned sky = 0, ground = 0, shadow_map = 0, shadow_target = 0;
  Vector eye = {{1.2f, 1.55f, 3.3f}}, to_sun = unit({{-0.62f, 0.75f, 0.42f}});
  Matrix clip_from_model = {}, sun_from_model = {};

  void open();
  void open_context();
  void reopen(bool there_is_another);
  unsigned compile(const char* vertex, const char* fragment);
  void begin_shadows();
  void begin_picture(float walked);
  void use(unsigned program, Role role) const;
  void use(const gles3::Program& program, const marrow::Mesh& mesh, Role role) const;
  void save(const std::string& path) const;
};

inline void Stage::open() {
  SDL_SetHint(SDL_HINT_OPENGL_ES_DRIVER, "1");
  if (SDL_Init(SDL_INIT_VIDEO) != 0) fail(std::string("there is no screen: ") + SDL_GetError());
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
  SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
  for (int samples = 4; samples >= 0 && window == nullptr; samples -= 4) {
    SDL_GL_SetAttribute(SDL_GL_MULTISAMPLEBUFFERS, samples > 0);
    SDL_GL_SetAttribute(SDL_GL_MULTISAMPLESAMPLES, samples);
    window = SDL_CreateWindow("Marrow", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, options.width, options.height,
                              SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
  }
  open_context();
}

// The window's context, new and current, with all that is the stage's own in it.
inline void Stage::open_context() {
  // One that tells of resets, see gles3::context_was_reset(), or else any.
  for (const int reset : {SDL_GL_CONTEXT_RESET_LOSE_CONTEXT, SDL_GL_CONTEXT_RESET_NO_NOTIFICATION}) {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_RESET_NOTIFICATION, reset);
    if (context == nullptr && window != nullptr) context = SDL_GL_CreateContext(window);
  }
  if (context == nullptr)
    fail(std::string("no window with OpenGL ES 3.0: ") + SDL_GetError() +
         ". Update the graphics driver, or install Mesa's");
  const char* missing = "";
  if (load_api(gl, SDL_GL_GetProcAddress, &missing) != marrow::Status::ok)
    fail(std::string("the driver has no ") + missing + ", so no OpenGL ES 3.0. Update the graphics driver");
  watch = {[](void* count, const char* call, unsigned error) {
             std::fprintf(stderr, "game: %s: GL error 0x%04X\n", call, error);
             ++*static_cast<long*>(count);
           },
           &gl_errors};
  if (options.watch) watch_errors(gl, &watch);
  must(query_caps(gl, caps), "asking what the driver can do");
  clear = reinterpret_cast<void (*)(unsigned)>(SDL_GL_GetProcAddress("glClear"));
  constexpr unsigned kFramebufferBinding = 0x8CA6;
  gl.GetIntegerv(kFramebufferBinding, &screen);
  SDL_GL_SetSwapInterval(1);
  sky = compile(kSkyVertex, kSkyFragment.c_str());
  ground = compile(kGroundVertex, kGroundFragment.c_str());

  constexpr unsigned kDepthComponent24 = 0x81A6, kCompareMode = 0x884C, kCompareToTexture = 0x884E;
  gl.GenTextures(1, &shadow_map);
  gl.BindTexture(GL_TEXTURE_2D, shadow_map);
  gl.TexImage2D(GL_TEXTURE_2D, 0, kDepthComponent24, kShadowSide, kShadowSide, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, kCompareMode, kCompareToTexture);
  gl.GenFramebuffers(1, &shadow_target);
  gl.BindFramebuffer(GL_FRAMEBUFFER, shadow_target);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, shadow_map, 0);
}

// After the context is lost; what was in it went with it.
inline void Stage::reopen(bool there_is_another) {
  if (!there_is_another) SDL_GL_DeleteContext(context);
  context = there_is_another ? SDL_GL_GetCurrentContext() : nullptr;
  open_context();
}

inline unsigned Stage::compile(const char* vertex, const char* fragment) {
  const unsigned program = gl.CreateProgram();
  for (const GLenum kind : {GLenum{GL_VERTEX_SHADER}, GLenum{GL_FRAGMENT_SHADER}}) {
    const unsigned shader = gl.CreateShader(kind);
    gl.ShaderSource(shader, 1, kind == GL_VERTEX_SHADER ? &vertex : &fragment, nullptr);
    gl.CompileShader(shader);
    gl.AttachShader(program, shader);
    gl.DeleteShader(shader);
  }
  gl.LinkProgram(program);
  char log[512] = "";
  gl.GetProgramInfoLog(program, sizeof log, nullptr, log);
  int linked = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked) fail(std::string("the ground's shader does not compile: ") + log);
  return program;
}

inline void Stage::begin_shadows() {
  constexpr Vector middle = {{0, 0.6f, -5.5f}};
  Vector sun = middle;
  for (int i = 0; i < 3; ++i) sun.v[i] += 20 * to_sun.v[i];
  sun_from_model = look(sun, to_sun, 10.5f, 10.5f, 1, 40, false);
  gl.BindFramebuffer(GL_FRAMEBUFFER, shadow_target);
  gl.Viewport(0, 0, kShadowSide, kShadowSide);
  gl.Enable(GL_DEPTH_TEST);
  clear(GL_DEPTH_BUFFER_BIT);
}

inline void Stage::begin_picture(float walked) {
  SDL_GL_GetDrawableSize(window, &width, &height);  // of a screen with small pixels, more than the window's size
  const float tall = 0.36f, wide = tall * float(width) / float(std::max(height, 1));
  clip_from_model = look(eye, {{0.27f, 0.2f, 1}}, wide, tall, 0.2f, 80, true);
  gl.BindFramebuffer(GL_FRAMEBUFFER, unsigned(screen));
  gl.Viewport(0, 0, width, height);
  clear(GL_DEPTH_BUFFER_BIT);
  gl.Disable(GL_CULL_FACE);
  gl.BindVertexArray(0);
  gl.Disable(GL_DEPTH_TEST);
  gl.UseProgram(sky);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.Enable(GL_DEPTH_TEST);
  use(ground, kColour);
  gl.Uniform1f(gl.GetUniformLocation(ground, "walked"), walked);
  gl.DrawArrays(GL_TRIANGLES, 0, 120 * 144 * 6);
}

// A program in use, with camera and light.
inline void Stage::use(unsigned program, Role role) const {
  gl.UseProgram(program);
  const auto place = [&](const char* name) { return gl.GetUniformLocation(program, name); };
  gl.UniformMatrix4fv(place("clip_from_model"), 1, GL_FALSE, (role == kShadow ? sun_from_model : clip_from_model).m);
  if (role == kShadow) return;
  gl.UniformMatrix4fv(place("sun_from_model"), 1, GL_FALSE, sun_from_model.m);
  gl.Uniform3fv(place("eye"), 1, eye.v);
  gl.Uniform3fv(place("to_sun"), 1, to_sun.v);
  gl.Uniform1i(place("shadows"), kShadowUnit);
  gl.ActiveTexture(GL_TEXTURE0 + kShadowUnit);
  gl.BindTexture(GL_TEXTURE_2D, shadow_map);
}

// A program of Marrow's, for one mesh.
inline void Stage::use(const gles3::Program& program, const marrow::Mesh& mesh, Role role) const {
  use(program.id, role);
  (mesh.double_sided ? gl.Disable : gl.Enable)(GL_CULL_FACE);
  if (role == kShadow) return;
  gl.Uniform3fv(gl.GetUniformLocation(program.id, "base_colour"), 1, mesh.base_colour);
  gl.Uniform1f(gl.GetUniformLocation(program.id, "gloss"), std::strcmp(mesh.material, "gloss") == 0 ? 1.0f : 0.0f);
}

// What has been drawn, before it is swapped.
inline void Stage::save(const std::string& path) const {
  SDL_Surface* const picture = SDL_CreateRGBSurfaceWithFormat(0, width, height, 32, SDL_PIXELFORMAT_RGBA32);
  if (picture == nullptr) fail(path + ": " + SDL_GetError());
  char* const pixels = static_cast<char*>(picture->pixels);
  for (int y = 0; y < height; ++y)  // GL begins at the bottom
    gl.ReadPixels(0, height - 1 - y, width, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels + y * picture->pitch);
  if (SDL_SaveBMP(picture, path.c_str()) != 0) fail(path + ": " + SDL_GetError() + ". Is the folder there?");
  SDL_FreeSurface(picture);
}

// How long the last frames took.
struct Times {
  std::array<double, 4096> ms = {};
  std::size_t count = 0;

  void add(Uint64 ticks) { ms[count++ % ms.size()] = 1000 * double(ticks) / double(SDL_GetPerformanceFrequency()); }
  void print(const char* what) {
    const std::size_t kept = std::min(count, ms.size());
    if (kept == 0) return;
    std::sort(ms.begin(), ms.begin() + kept);
    const auto share = [&](double s) { return ms[std::size_t(s * double(kept - 1) + 0.5)]; };
    std::printf("%-24s %8.2f %8.2f %8.2f %8.2f\n", what, share(0.5), share(0.95), share(0.99), ms[kept - 1]);
  }
};

// The time from frame to frame.
struct Clock {
  Uint64 then = 0;
  Times frames;

  void start() { then = SDL_GetPerformanceCounter(); }
  float tick() {
    const Uint64 now = SDL_GetPerformanceCounter(), passed = now - std::exchange(then, now);
    frames.add(passed);
    const double passed_s = double(passed) / double(SDL_GetPerformanceFrequency());
    // What took longer than a tenth of a second is not made up for: characters go on from where they are.
    return float(options.step_s > 0 ? options.step_s : std::min(passed_s, 0.1));
  }
};
