// From step 3 on: a character whose vertices only the GPU knows.
#pragma once

#include <marrow/gles3_skinner.h>

#include "window.h"

inline const char* const kSkinnedVertex = R"(
uniform mat4 clip_from_model;
out vec3 normal, colour;
void main() {
  MarrowVertex v = marrow_skin();
  normal = v.normal;
  colour = in_colour.rgb;
  gl_Position = clip_from_model * vec4(v.position, 1.0);
}
)";

// The programs of a context. One role: the picture. A game with shadows has two.
struct Programs {
  gles3::ProgramSet set;
  char log[1024] = "";

  Programs() {
    set.roles[0] = {kSkinnedVertex, kFragment, {}};
    set.log = log;
  }
};

struct Actor {
  marrow::Animations animations;
  marrow::Character body;
  std::vector<gles3::Skinner> skinners;  // one a mesh

  // layers: poses that are blended at once.
  Actor(const marrow::File& file, const Window& window, Programs& programs, std::uint32_t layers = 1) {
    must(make_animations(file, file, memory_of(animations_bytes(file, file)), animations), "animations");
    const marrow::CharacterOptions on_gpu{.layers = layers, .level = 0, .skin = false, .animation_space = false};
    must(make_character(file, on_gpu, memory_of(character_bytes(file, on_gpu)), body), "character");
    for (const marrow::CharacterMesh& m : body.meshes)
      must(create_skinner(window.gl, window.caps, m.mesh, {}, programs.set, memory_of(gles3::skinner_bytes(m.mesh, {})),
                          skinners.emplace_back()),
           "putting a mesh on the GPU", programs.log);
  }

  void draw(const Window& window, const Programs& programs) {
    for (std::size_t i = 0; i < skinners.size(); ++i) {
      const marrow::CharacterMesh& m = body.meshes[i];
      must(pose(skinners[i], 0, body.skeletons[m.mesh.skeleton].pose.model_from_joint, m.weights), "posing");
      must(update(window.gl, skinners[i], programs.set, 1), "sending a pose");
      const gles3::Program& program = program_of(skinners[i], programs.set, 0);
      window.use(program.id, m.mesh.base_colour);
      (m.mesh.double_sided ? window.gl.Disable : window.gl.Enable)(GL_CULL_FACE);
      must(gles3::draw(window.gl, skinners[i], programs.set, program, 0, 1), "drawing");
    }
  }
};
