// Where a game has a window, the examples of docs/gles have a texture that they look at afterwards.
#pragma once

#include <marrow/egl.h>
#include <marrow/gles3_skinner.h>
#include <marrow/marrow.h>

#include <GLES3/gl3.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace gles3 = marrow::gles3;

inline void must(marrow::Status status, const char* doing, const char* log = "") {
  if (status == marrow::Status::ok) return;
  std::printf("%s: %s %s\n", doing, to_string(status), log);
  std::exit(1);
}

struct Stage {
  static constexpr int kSide = 512;

  marrow::egl::HeadlessContext context;
  gles3::Api gl;
  gles3::Caps caps;
  unsigned framebuffer = 0;

  void open() {
    must(context.create(), context.error());
    const char* missing = "no loader";
    must(load_api(gl, marrow::egl::load_proc, &missing), missing);
    must(query_caps(gl, caps), "caps");
    unsigned textures[2] = {};
    gl.GenTextures(2, textures);
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.BindTexture(GL_TEXTURE_2D, textures[0]);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSide, kSide, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures[0], 0);
    gl.BindTexture(GL_TEXTURE_2D, textures[1]);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kSide, kSide, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                  nullptr);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, textures[1], 0);
    gl.BindTexture(GL_TEXTURE_2D, 0);
  }
  // What blend_crowd() and self_test() change, a frame sets anyway.
  void begin_pass() {
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.Viewport(0, 0, kSide, kSide);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_CULL_FACE);
    reinterpret_cast<PFNGLCLEARPROC>(marrow::egl::load_proc("glClear"))(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
  std::vector<unsigned char> read() {
    std::vector<unsigned char> rgba(4 * kSide * kSide);
    gl.ReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return rgba;
  }
  // On how many pixels something was drawn.
  int covered() {
    int count = 0;
    const std::vector<unsigned char> rgba = read();
    for (std::size_t i = 3; i < rgba.size(); i += 4) count += rgba[i] != 0;
    return count;
  }
  // The picture as a PPM file, for whoever wants to look.
  void save(const char* folder, const char* name) {
    if (folder == nullptr) return;
    std::ofstream out(std::string(folder) + "/" + name + ".ppm", std::ios::binary);
    out << "P6 " << kSide << ' ' << kSide << " 255\n";
    const std::vector<unsigned char> rgba = read();
    for (int y = kSide; y-- > 0;)
      for (int x = 0; x < kSide; ++x)
        out.write(reinterpret_cast<const char*>(&rgba[std::size_t(4 * (y * kSide + x))]), 3);
  }
};

// A file that is not packed, and what is made of it once.
struct Asset {
  std::vector<char> bytes;
  marrow::File file;
  std::vector<std::byte> shared;
  marrow::Animations animations;

  explicit Asset(const char* path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) std::perror(path);
    bytes.assign(std::istreambuf_iterator<char>(stream), {});
    must(load({reinterpret_cast<const std::byte*>(bytes.data()), bytes.size()}, file), path);
    shared.resize(animations_bytes(file, file));
    must(make_animations(file, file, shared, animations), "animations");
  }
};
