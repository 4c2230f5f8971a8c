/* What the engines must show of a cooked file, by the C interface alone: poses as translation, rotation and scale of
 * each joint, joints in the scene, and skinned vertices; and of a file with a graph, tests/examples/stages's, what is
 * played of it: steps, events, poses, and the names of events and states.
 * usage: reference FILE.mrw OUT_FOLDER [BEHAVING.mrw] */
#include <marrow/c.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* It walks, is asked to reach in frame kReach, and in frame kRestore is taken back to where it was then. */
enum { kSteps = 30, kReach = 120, kRestore = 240, kFrames = 300 };

static void must(bool good, const char* what) {
  if (good) return;
  fprintf(stderr, "reference: %s\n", what);
  exit(1);
}

static void ok(mrw_status status) {
  must(status == MRW_OK, mrw_status_text(status));
}

static void* block_of(size_t bytes) {
  void* const memory = malloc(mrw_block_bytes(bytes));
  mrw_block block = {NULL, 0};
  must(memory != NULL, "no memory");
  ok(mrw_block_in(memory, mrw_block_bytes(bytes), &block));
  return block.data;
}

static mrw_bytes read_file(const char* name) {
  FILE* const file = fopen(name, "rb");
  mrw_bytes out = {NULL, 0};
  must(file != NULL && fseek(file, 0, SEEK_END) == 0, name);
  out.size = (size_t)ftell(file);
  out.data = block_of(out.size);
  rewind(file);
  must(fread((void*)out.data, 1, out.size, file) == out.size, name);
  fclose(file);
  return out;
}

static FILE* make_file(const char* folder, const char* name) {
  char path[4096];
  FILE* out;
  snprintf(path, sizeof path, "%s/%s", folder, name);
  out = fopen(path, "wb");
  must(out != NULL, path);
  return out;
}

static void put(FILE* to, const float* from, size_t count) {
  must(fwrite(from, sizeof(float), count, to) == count, "cannot write");
}

static void put_pose(FILE* to, const mrw_skeleton* skeleton, const mrw_soa_transform* local) {
  uint32_t j;
  for (j = 0; j < skeleton->joint_count; ++j) {
    mrw_joint_transform joint;
    ok(mrw_get_joint(local, mrw_skeleton_soa_size(skeleton), j, &joint));
    put(to, joint.translation, 3);
    put(to, joint.rotation, 4);
    put(to, joint.scale, 3);
  }
}

static void put_skinned(FILE* to, const mrw_file* file, const mrw_affine* joints, uint32_t joint_count) {
  uint32_t i;
  for (i = 0; i < mrw_file_mesh_count(file); ++i) {
    mrw_mesh mesh;
    mrw_skin_output out;
    mrw_affine* palette;
    ok(mrw_file_mesh(file, i, 0, &mesh));
    palette = block_of(mrw_mesh_palette_size(&mesh) * sizeof(mrw_affine));
    ok(mrw_build_palette(&mesh, joints, joint_count, palette, mrw_mesh_palette_size(&mesh)));
    mrw_skin_output_init(&out);
    out.position_count = 3 * (size_t)mesh.geometry.slot_count;
    out.positions = block_of(out.position_count * sizeof(float));
    ok(mrw_skin_ssd(&mesh, palette, mrw_mesh_palette_size(&mesh), &out));
    put(to, out.positions, out.position_count);
  }
}

static void load(const char* name, mrw_file* file) {
  mrw_bytes bytes = read_file(name);
  if (mrw_is_packed(bytes.data, bytes.size)) {
    mrw_mesh_decoder draco;
    mrw_unpack_sizes sizes;
    ok(mrw_draco_decoder(&draco));
    ok(mrw_find_unpack_sizes(bytes.data, bytes.size, &sizes, NULL));
    ok(mrw_unpack(bytes.data, bytes.size, &draco, 1, block_of(sizes.memory_bytes), sizes.memory_bytes, &bytes, NULL));
  }
  ok(mrw_load(bytes.data, bytes.size, file, NULL));
}

/* graph.bin: of each frame the step's rotation and translation, the number and time of each event, the pose.
 * graph.txt: a line an event, and the state of the machine "body" where it changes. */
static void put_frame(FILE* numbers, FILE* words, int frame, mrw_animator* animator, mrw_character* character) {
  static uint32_t before = MRW_NO_INDEX;
  const mrw_graph_binding* const b = animator->binding;
  const uint32_t body = mrw_find_graph_node(b, "body");
  mrw_animator_step step;
  uint32_t state;
  size_t i;
  mrw_animator_step_init(&step);
  ok(mrw_update_animator(animator, (float)(1.0 / 60), &step));
  put(numbers, step.root.rotation, 4);
  put(numbers, step.root.translation, 3);
  for (i = 0; i < step.event_count; ++i) {
    put(numbers, &step.events[i].number, 1);
    put(numbers, &step.events[i].time_s, 1);
    fprintf(words, "%d %s\n", frame, step.events[i].name);
  }
  ok(mrw_sample_animated(character, animator, NULL, 0));
  put_pose(numbers, &character->skeletons[0].pose.skeleton, character->skeletons[0].pose.local);
  state = mrw_state_of(animator, body, NULL);
  if (state != before)
    fprintf(words, "%d is in %s\n", frame,
            mrw_file_text(&b->file, b->graph.states[b->graph.machines[0].first_state + state].name));
  before = state;
}

static void play_graph(const mrw_file* file, const char* folder) {
  mrw_graph graph;
  mrw_graph_binding binding;
  mrw_animations animations;
  mrw_animator animator;
  mrw_character character;
  mrw_character_options options;
  FILE *const numbers = make_file(folder, "graph.bin"), *const words = make_file(folder, "graph.txt");
  void* saved;
  size_t size = mrw_animations_bytes(file, file);
  int frame;
  ok(mrw_make_animations(file, file, block_of(size), size, &animations));
  ok(mrw_file_graph(file, 0, &graph, NULL));
  size = mrw_graph_binding_bytes(&graph, file);
  ok(mrw_bind_graph(file, &graph, file, &animations, 1, block_of(size), size, &binding, NULL));
  size = mrw_animator_bytes(&binding, NULL);
  ok(mrw_make_animator(&binding, NULL, block_of(size), size, &animator));
  mrw_character_options_init(&options);
  options.layers = graph.nodes[0].poses;
  size = mrw_character_bytes(file, &options);
  ok(mrw_make_character(file, &options, block_of(size), size, &character));
  saved = block_of(animator.state_bytes);
  ok(mrw_set_number(&animator, mrw_find_parameter(&binding, "speed"), 0.3f));
  for (frame = 0; frame < kFrames; ++frame) {
    if (frame == kReach) {
      memcpy(saved, animator.state, animator.state_bytes);
      ok(mrw_set_number(&animator, mrw_find_parameter(&binding, "speed"), 0));
      ok(mrw_fire_trigger(&animator, mrw_find_parameter(&binding, "reach")));
    }
    if (frame == kRestore) ok(mrw_restore_animator(&animator, saved, animator.state_bytes));
    put_frame(numbers, words, frame, &animator, &character);
  }
  must(fclose(numbers) == 0 && fclose(words) == 0, "cannot write");
}

int main(int argc, char** argv) {
  mrw_file file;
  mrw_skeleton skeleton;
  mrw_soa_transform* local;
  mrw_affine* joints;
  FILE *poses, *scene, *skinned;
  uint32_t i, step;
  must(argc == 3 || argc == 4, "usage: reference FILE.mrw OUT_FOLDER [BEHAVING.mrw]");
  load(argv[1], &file);
  ok(mrw_file_skeleton(&file, 0, &skeleton));
  local = block_of(mrw_skeleton_soa_size(&skeleton) * sizeof *local);
  joints = block_of(skeleton.joint_count * sizeof *joints);
  poses = make_file(argv[2], "poses.bin");
  scene = make_file(argv[2], "scene.bin");
  skinned = make_file(argv[2], "skinned.bin");
  for (i = 0; i < mrw_file_clip_count(&file); ++i) {
    mrw_clip clip;
    ok(mrw_file_clip(&file, i, &clip));
    for (step = 0; step < kSteps; ++step) {
      ok(mrw_sample(&skeleton, &clip, (float)(step * 0.05), local, mrw_skeleton_soa_size(&skeleton), NULL));
      ok(mrw_local_to_model(&skeleton, local, mrw_skeleton_soa_size(&skeleton), joints, skeleton.joint_count));
      put_pose(poses, &skeleton, local);
      put(scene, &joints[0].rows[0][0], 12 * (size_t)skeleton.joint_count);
      if (step == 8) put_skinned(skinned, &file, joints, skeleton.joint_count);
    }
  }
  must(fclose(poses) == 0 && fclose(scene) == 0 && fclose(skinned) == 0, "cannot write");
  if (argc == 4) {
    load(argv[3], &file);
    play_graph(&file, argv[2]);
  }
  return 0;
}
