// What the Unity package's safe C# must make of a file, in C99: thirty frames of walk, from the tenth on blended with
// idle, as a hash of poses and skinned vertices. Core.cs does the same. Or, with a second argument, of a file with
// tests/examples/stages/animator.anim.toml two seconds of it, and one that is played again: Graphs.cs.
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <marrow/c.h>

#define TRY(call)                                                                                 \
  do {                                                                                            \
    const mrw_status status = (call);                                                             \
    if (status != MRW_OK) exit((fprintf(stderr, "%s: %s\n", #call, mrw_status_text(status)), 1)); \
  } while (0)

static uint32_t hash = 2166136261u;
static void add(const void* words, size_t count) {
  size_t i;
  for (i = 0; i < count; ++i) hash = (hash ^ ((const uint32_t*)words)[i]) * 16777619u;
}

static void* block_of(size_t bytes) {
  static void* taken[32];  // reachable to the end
  static int count = 0;
  mrw_block block;
  if (count == 32 || (taken[count] = malloc(mrw_block_bytes(bytes))) == NULL) exit(1);
  TRY(mrw_block_in(taken[count++], mrw_block_bytes(bytes), &block));
  return block.data;
}

static mrw_bytes read_file(const char* name) {
  mrw_mesh_decoder decoders[2];
  mrw_unpack_sizes sizes;
  mrw_bytes out;
  FILE* const file = fopen(name, "rb");
  void* block;
  if (file == NULL || fseek(file, 0, SEEK_END) != 0) exit(1);
  out.size = (size_t)ftell(file);
  out.data = block = block_of(out.size);
  rewind(file);
  if (fread(block, 1, out.size, file) != out.size) exit(1);
  fclose(file);
  if (!mrw_is_packed(out.data, out.size)) return out;
  TRY(mrw_draco_decoder(&decoders[0]));
  TRY(mrw_meshopt_decoder(&decoders[1]));
  TRY(mrw_find_unpack_sizes(out.data, out.size, &sizes, NULL));
  TRY(mrw_unpack(out.data, out.size, decoders, 2, block_of(sizes.memory_bytes), sizes.memory_bytes, &out, NULL));
  return out;
}

static void add_frame(mrw_character* character, float* positions, float* normals) {
  const mrw_pose* const pose = &character->skeletons[0].pose;
  size_t i, floats;
  for (i = 0; i < pose->skeleton.joint_count; ++i) {
    mrw_joint_transform t;
    TRY(mrw_get_joint(pose->local, pose->local_count, (uint32_t)i, &t));
    add(t.translation, 3);
    add(t.rotation, 4);
    add(t.scale, 3);
    add(pose->model_from_joint[i].rows, 12);
  }
  for (i = 0; i < character->mesh_count; ++i) {
    const mrw_character_mesh* const m = &character->meshes[i];
    mrw_skin_output out;
    mrw_skin_output_init(&out);
    floats = 3 * (size_t)m->mesh.geometry.slot_count;
    out.positions = positions;
    out.normals = normals;
    out.position_count = out.normal_count = floats;
    TRY(mrw_skin_ssd(&m->mesh, m->palette, m->palette_count, &out));
    add(positions, floats);
    add(normals, floats);
  }
}

static void add_step(mrw_animator* animator, mrw_character* character, float* floats, size_t most) {
  mrw_animator_step step;
  size_t i;
  mrw_animator_step_init(&step);
  TRY(mrw_update_animator(animator, 1.0f / 60, &step));
  add(step.root.translation, 3);
  add(step.root.rotation, 4);
  for (i = 0; i < step.event_count; ++i) {
    add(&step.events[i].id, 1);
    add(&step.events[i].number, 1);
    add(&step.events[i].time_s, 1);
  }
  TRY(mrw_pose_animated(character, animator, NULL, 0));
  TRY(mrw_finish_character(character));
  add_frame(character, floats, floats + 3 * most);
}

static void play_graph(const mrw_file* file, const mrw_animations* animations) {
  mrw_graph graph;
  mrw_graph_binding binding;
  mrw_animator animator;
  mrw_character character;
  mrw_character_options options;
  uint8_t saved[1024];
  size_t size, i, most = 0;
  float* floats;
  TRY(mrw_file_graph(file, 0, &graph, NULL));
  size = mrw_graph_binding_bytes(&graph, file);
  TRY(mrw_bind_graph(file, &graph, file, animations, 1, block_of(size), size, &binding, NULL));
  size = mrw_animator_bytes(&binding, NULL);
  TRY(mrw_make_animator(&binding, NULL, block_of(size), size, &animator));
  mrw_character_options_init(&options);
  options.layers = graph.nodes[0].poses > 2 ? graph.nodes[0].poses : 2;
  size = mrw_character_bytes(file, &options);
  TRY(mrw_make_character(file, &options, block_of(size), size, &character));
  for (i = 0; i < character.mesh_count; ++i)
    if (character.meshes[i].mesh.geometry.slot_count > most) most = character.meshes[i].mesh.geometry.slot_count;
  floats = block_of(24 * most);
  TRY(mrw_set_number(&animator, mrw_find_parameter(&binding, "speed"), 0.3f));
  for (i = 0; i < 120; ++i) {
    if (i == 60) memcpy(saved, animator.state, animator.state_bytes);
    if (i == 60) TRY(mrw_set_number(&animator, mrw_find_parameter(&binding, "speed"), 0));
    if (i == 60) TRY(mrw_fire_trigger(&animator, mrw_find_parameter(&binding, "reach")));
    add_step(&animator, &character, floats, most);
  }
  TRY(mrw_restore_animator(&animator, saved, animator.state_bytes));
  for (i = 0; i < 60; ++i) add_step(&animator, &character, floats, most);
}

int main(int argc, char** argv) {
  const mrw_bytes bytes = read_file(argc > 1 ? argv[1] : "newt.mrw");
  mrw_file file;
  mrw_animations animations;
  mrw_character character;
  mrw_playback playback;
  mrw_animation_layer layers[2];
  size_t size, most = 0, i;
  float* floats;
  TRY(mrw_load(bytes.data, bytes.size, &file, NULL));
  size = mrw_animations_bytes(&file, &file);
  TRY(mrw_make_animations(&file, &file, block_of(size), size, &animations));
  if (argc > 2) {
    play_graph(&file, &animations);
    printf("%08x\n", (unsigned)hash);
    return 0;
  }
  size = mrw_character_bytes(&file, NULL);
  TRY(mrw_make_character(&file, NULL, block_of(size), size, &character));
  for (i = 0; i < 2; ++i) mrw_animation_layer_init(&layers[i]);
  layers[0].animation = mrw_find_animation(&animations, "walk");
  layers[1].animation = mrw_find_animation(&animations, "idle");
  if (layers[0].animation == NULL || layers[1].animation == NULL) return 1;
  for (i = 0; i < character.mesh_count; ++i)
    if (character.meshes[i].mesh.geometry.slot_count > most) most = character.meshes[i].mesh.geometry.slot_count;
  floats = block_of(24 * most);
  mrw_playback_init(&playback);
  for (i = 0; i < 30; ++i) {
    TRY(mrw_advance(&playback, layers[0].animation->duration_s, 1.0f / 60));
    layers[0].time_s = layers[1].time_s = mrw_clip_time(&playback);
    layers[1].weight = 0.25f;
    TRY(mrw_pose_character(&character, layers, i < 10 ? 1 : 2));
    TRY(mrw_finish_character(&character));
    add_frame(&character, floats, floats + 3 * most);
  }
  printf("%08x\n", (unsigned)hash);
  return 0;
}
