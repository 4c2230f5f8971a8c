// The road of a character in C99: unpack, load, clips by name, pose, reach, springs, palettes, skin. Prints a hash of
// all that comes of it. road.cpp does the same in C++, and the bindings' tests in their languages.
#include <inttypes.h>
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

// All memory, which goes back as the program ends.
static void* taken[256];
static size_t taken_count = 0;

static void give_back(void) {
  while (taken_count > 0) free(taken[--taken_count]);
}

static mrw_block block_of(size_t bytes) {
  mrw_block block;
  void* const memory = malloc(mrw_block_bytes(bytes));
  if (memory == NULL || taken_count == sizeof taken / sizeof taken[0]) exit(1);
  if (taken_count == 0) atexit(give_back);
  taken[taken_count++] = memory;
  TRY(mrw_block_in(memory, mrw_block_bytes(bytes), &block));
  return block;
}

static mrw_bytes read_file(const char* name) {
  mrw_bytes out;
  mrw_block block = {NULL, 0};
  FILE* const file = fopen(name, "rb");
  long size = 0;
  if (file == NULL || fseek(file, 0, SEEK_END) != 0 || (size = ftell(file)) < 0) exit(1);
  rewind(file);
  block = block_of((size_t)size);
  if (fread(block.data, 1, (size_t)size, file) != (size_t)size) exit(1);
  fclose(file);
  out.data = block.data;
  out.size = (size_t)size;
  return out;
}

static mrw_bytes unpacked(mrw_bytes bytes) {
  mrw_mesh_decoder decoders[2];
  mrw_unpack_sizes sizes;
  if (!mrw_is_packed(bytes.data, bytes.size)) return bytes;
  TRY(mrw_draco_decoder(&decoders[0]));
  TRY(mrw_meshopt_decoder(&decoders[1]));
  TRY(mrw_find_unpack_sizes(bytes.data, bytes.size, &sizes, NULL));
  TRY(mrw_unpack(bytes.data, bytes.size, decoders, 2, block_of(sizes.memory_bytes).data, sizes.memory_bytes, &bytes,
                 NULL));
  return bytes;
}

static mrw_springs tail_of(const mrw_file* file, const mrw_skeleton* skeleton) {
  mrw_spring_joint joints[4];
  mrw_spring_chain chain;
  mrw_springs springs;
  size_t bytes;
  int i;
  mrw_spring_chain_init(&chain);
  for (i = 0; i < 4; ++i) {
    char name[] = "tail_3";
    name[5] = (char)('3' + i);
    mrw_spring_joint_init(&joints[i]);
    joints[i].joint = (uint16_t)mrw_file_find_joint(file, skeleton, name);
  }
  chain.joints = joints;
  chain.joint_count = 4;
  bytes = mrw_springs_bytes(skeleton, &chain, 1);
  TRY(mrw_make_springs(skeleton, &chain, 1, block_of(bytes).data, bytes, &springs));
  return springs;
}

// The head looks at a point, the left foot is lifted, the tail swings.
static void reach(const mrw_file* file, const mrw_pose* pose, mrw_springs* springs, float dt_s) {
  const uint32_t neck[2] = {mrw_file_find_joint(file, &pose->skeleton, "neck"),
                            mrw_file_find_joint(file, &pose->skeleton, "head")};
  mrw_two_bone_limb leg;
  mrw_aim look;
  mrw_two_bone step;
  mrw_spring_frame frame;
  float(*foot)[4];
  int i;
  mrw_aim_init(&look);
  look.target[0] = 0.5f;
  look.target[1] = 1.25f;
  look.target[2] = 2;
  look.weight = 0.5f;
  TRY(mrw_solve_look_at(pose, neck, 2, &look, 0.5f, NULL));
  leg.start = mrw_file_find_joint(file, &pose->skeleton, "thigh.L");
  leg.mid = mrw_file_find_joint(file, &pose->skeleton, "shin.L");
  leg.end = mrw_file_find_joint(file, &pose->skeleton, "foot.L");
  if (leg.end == pose->skeleton.joint_count) exit(1);
  foot = pose->model_from_joint[leg.end].rows;
  mrw_two_bone_init(&step);
  for (i = 0; i < 3; ++i) step.target[i] = foot[i][3] + 0.0625f;
  TRY(mrw_solve_two_bone(pose, &leg, &step, NULL));
  mrw_spring_frame_init(&frame);
  frame.dt_s = dt_s;
  TRY(mrw_simulate_springs(pose, &frame, springs));
}

static void skin(const mrw_character_mesh* m, float* positions, float* normals) {
  const size_t floats = 3 * (size_t)m->mesh.geometry.slot_count;
  mrw_skin_output out;
  mrw_skin_output_init(&out);
  out.positions = positions;
  out.position_count = floats;
  out.normals = normals;
  out.normal_count = floats;
  TRY(mrw_skin_ssd(&m->mesh, m->palette, m->palette_count, &out));
  add(m->palette, 12 * m->palette_count);
  add(positions, floats);
  add(normals, floats);
  out.normal_count = 0;
  TRY(mrw_skin_as(&m->mesh, m->coordinates, m->coordinate_count, m->palette, m->palette_count, &out, NULL, 0));
  add(positions, floats);
}

static int told;
static void on_call_error(const char* function, const char* condition) {
  told += function[0] != 0 && condition[0] != 0;
}

static void expect(mrw_status status, mrw_status wanted, const char* what) {
  if (status == wanted) return;
  fprintf(stderr, "%s: %s\n", what, mrw_status_text(status));
  exit(1);
}

// What is refused, and why; the bindings' tests ask the same.
static void refuse(mrw_bytes bytes, const mrw_file* file) {
  const mrw_block copy = block_of(bytes.size + 4);
  mrw_skeleton skeleton;
  mrw_pose zeros;
  mrw_clip clip;
  mrw_mesh mesh;
  mrw_file other;
  mrw_skin_output out;
  mrw_two_bone step;
  mrw_two_bone_limb limb = {0, 0, 0};
  mrw_soa_transform* const pose = block_of(sizeof *pose * 64).data;
  TRY(mrw_file_skeleton(file, 0, &skeleton));
  TRY(mrw_file_clip(file, 0, &clip));
  TRY(mrw_file_mesh(file, 0, 0, &mesh));
  mrw_skin_output_init(&out);
  mrw_two_bone_init(&step);
  memset(&zeros, 0, sizeof zeros);
  mrw_set_call_error_handler(on_call_error);
  expect(mrw_load(NULL, 0, &other, NULL), MRW_BAD_ARGUMENT, "no file");
  expect(mrw_load(NULL, 64, &other, NULL), MRW_BAD_ARGUMENT, "null with a size");
  expect(mrw_load(bytes.data, bytes.size, NULL, NULL), MRW_BAD_ARGUMENT, "nowhere to load to");
  expect(mrw_sample(&skeleton, &clip, 0, pose, mrw_skeleton_soa_size(&skeleton) - 1, NULL), MRW_BAD_ARGUMENT, "short");
  expect(mrw_solve_two_bone(&zeros, &limb, &step, NULL), MRW_BAD_ARGUMENT, "zeros");
  expect(mrw_skin_ssd(&mesh, NULL, 3, &out), MRW_BAD_ARGUMENT, "a null palette");
  memcpy((char*)copy.data + 4, bytes.data, bytes.size);
  expect(mrw_load((char*)copy.data + 4, bytes.size, &other, NULL), MRW_BAD_ARGUMENT, "off its boundary");
  memcpy(copy.data, bytes.data, bytes.size);
  expect(mrw_load(copy.data, bytes.size - 16, &other, NULL), MRW_TRUNCATED, "cut");
  ++((unsigned char*)copy.data)[4];
  expect(mrw_load(copy.data, bytes.size, &other, NULL), MRW_BAD_VERSION, "another version");
  mrw_set_call_error_handler(NULL);
  printf("9 refused, %d told\n", told);
}

int main(int argc, char** argv) {
  const float dt_s = 1.0f / 60;
  const mrw_bytes bytes = unpacked(read_file(argc > 1 ? argv[1] : "newt.mrw"));
  const mrw_animation *walk, *idle;
  mrw_file file;
  mrw_animations animations;
  mrw_character_options options;
  mrw_character character;
  mrw_springs tail;
  mrw_playback playback;
  mrw_animation_layer layers[2];
  float *positions, *normals;
  size_t size, most = 0, i;
  int frame;

  if (mrw_abi() != MRW_ABI) exit((fprintf(stderr, "the library is of another ABI\n"), 1));
  TRY(mrw_load(bytes.data, bytes.size, &file, NULL));
  refuse(bytes, &file);
  size = mrw_animations_bytes(&file, &file);
  TRY(mrw_make_animations(&file, &file, block_of(size).data, size, &animations));
  walk = mrw_find_animation(&animations, "walk");
  idle = mrw_find_animation(&animations, "idle");
  if (walk == NULL || idle == NULL) return 1;
  mrw_character_options_init(&options);
  options.animation_space = true;
  size = mrw_character_bytes(&file, &options);
  TRY(mrw_make_character(&file, &options, block_of(size).data, size, &character));
  tail = tail_of(&file, &character.skeletons[0].pose.skeleton);
  for (i = 0; i < character.mesh_count; ++i)
    if (character.meshes[i].mesh.geometry.slot_count > most) most = character.meshes[i].mesh.geometry.slot_count;
  positions = block_of(12 * most).data;
  normals = block_of(12 * most).data;

  mrw_playback_init(&playback);
  for (i = 0; i < 2; ++i) mrw_animation_layer_init(&layers[i]);
  for (frame = 0; frame < 30; ++frame) {
    const mrw_pose* const pose = &character.skeletons[0].pose;
    TRY(mrw_advance(&playback, walk->duration_s, dt_s));
    layers[0].animation = walk;
    layers[1].animation = idle;
    layers[0].time_s = layers[1].time_s = mrw_clip_time(&playback);
    layers[1].weight = 0.25f;
    TRY(mrw_pose_character(&character, layers, 2));
    reach(&file, pose, &tail, dt_s);
    TRY(mrw_finish_character(&character));
    add(pose->local, 40 * pose->local_count);
    add(pose->model_from_joint, 12 * pose->model_from_joint_count);
    for (i = 0; i < character.mesh_count; ++i) skin(&character.meshes[i], positions, normals);
  }
  printf("%08" PRIx32 "\n", hash);
  return 0;
}
