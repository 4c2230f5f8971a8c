// From step 4 on: ground to stand on, in squares of an eighth of a metre. It repeats itself every 2 m along z.
#pragma once

#include "window.h"

using Height = float (*)(float x, float z);

inline float level(float, float) {
  return 0;
}
inline float hills(float x, float z) {
  const float turn = 3.14159265f * z;
  return 0.25f * x + 0.07f * std::sin(turn + x) + 0.02f * std::sin(2 * turn);
}

inline Vec3 normal_of(Height height, float x, float z) {
  const float d = 0.01f;
  return unit({height(x - d, z) - height(x + d, z), 2 * d, height(x, z - d) - height(x, z + d)});
}

inline const char* const kGroundVertex = R"(
layout(location = 0) in vec3 in_position;
layout(location = 1) in vec4 in_normal;
uniform mat4 clip_from_model;
uniform float walked;
out vec3 normal, colour;
void main() {
  normal = in_normal.xyz;
  colour = vec3(0.30, 0.36, 0.16) * in_normal.w;
  gl_Position = clip_from_model * vec4(in_position - vec3(0.0, 0.0, mod(walked, 2.0)), 1.0);
}
)";

struct Ground {
  Height height;
  unsigned program = 0, array = 0;
  int count = 0;

  explicit Ground(Height of) : height(of) {}

  void upload(const Window& window) {
    constexpr int kColumns = 80, kRows = 160;
    constexpr float kSide = 0.125f;
    std::vector<float> vertices;
    for (int cell = 0; cell < kColumns * kRows; ++cell)
      for (const int corner : {0, 2, 1, 1, 2, 3}) {
        const int column = cell % kColumns + corner % 2, row = cell / kColumns + corner / 2;
        const float x = kSide * float(column - kColumns / 2), z = kSide * float(row - 112);
        const Vec3 n = normal_of(height, x, z);
        const float shade = (cell / kColumns + cell % kColumns) % 2 == 0 ? 1.0f : 0.8f;
        vertices.insert(vertices.end(), {x, height(x, z), z, n.x, n.y, n.z, shade});
      }
    count = 6 * kColumns * kRows;
    const gles3::Api& gl = window.gl;
    program = window.compile(kGroundVertex, kFragment);
    unsigned buffer = 0;
    gl.GenVertexArrays(1, &array);
    gl.GenBuffers(1, &buffer);
    gl.BindVertexArray(array);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, std::ptrdiff_t(4 * vertices.size()), vertices.data(), GL_STATIC_DRAW);
    gl.EnableVertexAttribArray(0);
    gl.EnableVertexAttribArray(1);
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 28, nullptr);
    gl.VertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, 28, reinterpret_cast<const void*>(12));
  }

  // walked: by how many metres the scene has moved over the ground.
  void draw(const Window& window, float walked) const {
    const float white[] = {1, 1, 1};
    window.use(program, white);
    window.gl.Uniform1f(window.gl.GetUniformLocation(program, "walked"), walked);
    window.gl.BindVertexArray(array);
    window.gl.DrawArrays(GL_TRIANGLES, 0, count);
  }
};
