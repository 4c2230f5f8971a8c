/* The road of a character that the GPU skins, after tests/examples/draw.c: linked for its size, and not run. */
#include <marrow/c_gles3.h>

#define TRY(call) \
  if ((call) != MRW_OK) return -__LINE__

long road(const void* bytes, size_t byte_count, float time_s, char* memory, mrw_gles3_load_proc load,
          const char* const shaders[2], void (*use)(uint32_t program)) {
  static mrw_gles3_program_set programs;
  static mrw_gles3_skinner skinners[16];
  mrw_file file;
  mrw_gles3_api api;
  mrw_gles3_caps caps;
  mrw_gles3_skinner_options options;
  mrw_character_options posed;
  mrw_character character;
  mrw_animations animations;
  mrw_animation_layer layer;
  size_t size, i;
  TRY(mrw_load(bytes, byte_count, &file, NULL));
  size = mrw_animations_bytes(&file, &file);
  TRY(mrw_make_animations(&file, &file, memory, size, &animations));
  memory += size;
  mrw_character_options_init(&posed);
  posed.skin = false;
  size = mrw_character_bytes(&file, &posed);
  TRY(mrw_make_character(&file, &posed, memory, size, &character));
  memory += size;
  TRY(mrw_gles3_load_api(&api, load, NULL));
  TRY(mrw_gles3_query_caps(&api, &caps));
  mrw_gles3_program_set_init(&programs);
  programs.roles[0].vertex = shaders[0];
  programs.roles[0].fragment = shaders[1];
  mrw_gles3_skinner_options_init(&options);
  mrw_animation_layer_init(&layer);
  layer.animation = mrw_find_animation(&animations, "walk");
  layer.time_s = time_s;
  TRY(mrw_pose_character(&character, &layer, 1));
  for (i = 0; i < character.mesh_count && i < 16; ++i) {
    const mrw_character_mesh* const m = &character.meshes[i];
    const mrw_pose* const pose = &character.skeletons[m->mesh.skeleton].pose;
    const mrw_gles3_program* program;
    size = mrw_gles3_skinner_bytes(&m->mesh, &options);
    TRY(mrw_gles3_create_skinner(&api, &caps, &m->mesh, &options, &programs, memory, size, &skinners[i]));
    memory += size;
    TRY(mrw_gles3_pose(&skinners[i], 0, pose->model_from_joint, pose->model_from_joint_count, m->weights, m->weight_count));
    TRY(mrw_gles3_update(&api, &skinners[i], &programs, 1));
    program = mrw_gles3_program_of(&skinners[i], &programs, 0);
    use(program->id);
    TRY(mrw_gles3_draw(&api, &skinners[i], &programs, program, 0, 1));
  }
  return 0;
}
