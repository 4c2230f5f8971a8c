// Step 2: a walking character in a window. The CPU skins it; OpenGL ES draws what comes out.
#include "window.h"

const char* const kVertex = R"(
layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_colour;
uniform mat4 clip_from_model;
out vec3 normal, colour;
void main() {
  normal = in_normal;
  colour = in_colour.rgb;
  gl_Position = clip_from_model * vec4(in_position, 1.0);
}
)";

// A mesh in buffers. Positions and normals are new in every frame; colours and triangles stay.
struct Drawn {
  unsigned array = 0, positions = 0, normals = 0;
  std::vector<float> skinned_positions, skinned_normals;
};

unsigned buffer(const gles3::Api& gl, unsigned target, const void* data, std::size_t bytes) {
  unsigned name = 0;
  gl.GenBuffers(1, &name);
  gl.BindBuffer(target, name);
  gl.BufferData(target, std::ptrdiff_t(bytes), data, data == nullptr ? GL_STREAM_DRAW : GL_STATIC_DRAW);
  return name;
}

Drawn upload(const gles3::Api& gl, const marrow::Geometry& geometry) {
  Drawn out;
  const std::size_t slots = geometry.slot_count;
  out.skinned_positions.resize(3 * slots);
  out.skinned_normals.resize(3 * slots);
  gl.GenVertexArrays(1, &out.array);
  gl.BindVertexArray(out.array);
  for (unsigned location = 0; location < 3; ++location) gl.EnableVertexAttribArray(location);
  out.positions = buffer(gl, GL_ARRAY_BUFFER, nullptr, 12 * slots);
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  out.normals = buffer(gl, GL_ARRAY_BUFFER, nullptr, 12 * slots);
  gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  buffer(gl, GL_ARRAY_BUFFER, geometry.colours, 4 * slots);
  gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr);
  buffer(gl, GL_ELEMENT_ARRAY_BUFFER, geometry.indices, std::size_t(geometry.index_bytes) * geometry.index_count);
  return out;
}

void draw(const gles3::Api& gl, const marrow::CharacterMesh& m, Drawn& to) {
  must(skin_ssd(m.mesh, m.palette,
                {.positions = to.skinned_positions,
                 .normals = to.skinned_normals,
                 .normal_transform = marrow::NormalTransform::blended_matrix}),
       "skinning");
  for (const bool normals : {false, true}) {
    const std::vector<float>& from = normals ? to.skinned_normals : to.skinned_positions;
    gl.BindBuffer(GL_ARRAY_BUFFER, normals ? to.normals : to.positions);
    gl.BufferData(GL_ARRAY_BUFFER, std::ptrdiff_t(4 * from.size()), from.data(), GL_STREAM_DRAW);
  }
  (m.mesh.double_sided ? gl.Disable : gl.Enable)(GL_CULL_FACE);
  gl.BindVertexArray(to.array);
  const unsigned index = m.mesh.geometry.index_bytes == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
  gl.DrawElements(GL_TRIANGLES, int(m.mesh.geometry.index_count), index, nullptr);
}

int main(int argc, char** argv) {
  Window window(argc, argv);
  const marrow::File file = load_file(window.file);
  marrow::Animations animations;
  must(make_animations(file, file, memory_of(animations_bytes(file, file)), animations), "animations");
  const marrow::Animation& walk = find(animations, "walk");
  marrow::Character newt;
  must(make_character(file, {}, memory_of(character_bytes(file, {})), newt), "character");

  const unsigned program = window.compile(kVertex, kFragment);
  std::vector<Drawn> drawn;
  for (const marrow::CharacterMesh& m : newt.meshes) drawn.push_back(upload(window.gl, m.mesh.geometry));

  marrow::Playback playback;
  for (float dt_s; window.begin(dt_s); window.end()) {
    must(advance(playback, walk.duration_s, dt_s), "time");
    must(pose_character(newt, {{&walk, clip_time(playback)}}), "pose");
    must(finish_character(newt), "palettes");
    window.clear();
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      window.use(program, newt.meshes[i].mesh.base_colour);
      draw(window.gl, newt.meshes[i], drawn[i]);
    }
  }
}
