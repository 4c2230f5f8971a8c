/* Plays an animation on the CPU, in C99. */
#include <marrow/c.h>

#include <stdio.h>
#include <stdlib.h>

/* All memory, which goes back as the program ends. */
static void* taken[16];
static int taken_count = 0;

static void give_back(void) {
  while (taken_count > 0) free(taken[--taken_count]);
}

/* Memory that the runtime works in begins on a boundary of 16 bytes. */
static void* block_of(size_t bytes) {
  void* const memory = malloc(mrw_block_bytes(bytes));
  mrw_block block = {NULL, 0};
  if (memory == NULL || taken_count == 16) exit(1);
  if (taken_count == 0) atexit(give_back);
  taken[taken_count++] = memory;
  if (mrw_block_in(memory, mrw_block_bytes(bytes), &block) != MRW_OK) exit(1);
  return block.data;
}

static void must(mrw_status status) {
  if (status == MRW_OK) return;
  fprintf(stderr, "%s\n", mrw_status_text(status));
  exit(1);
}

static mrw_bytes read_file(const char* name) {
  mrw_bytes out = {NULL, 0};
  FILE* const file = fopen(name, "rb");
  if (file == NULL || fseek(file, 0, SEEK_END) != 0) {
    perror(name);
    exit(1);
  }
  out.size = (size_t)ftell(file);
  out.data = block_of(out.size);
  rewind(file);
  if (fread((void*)out.data, 1, out.size, file) != out.size) exit(1);
  fclose(file);
  return out;
}

int main(int argc, char** argv) {
  mrw_bytes bytes = read_file(argc > 1 ? argv[1] : "character.mrw");
  mrw_file file;
  mrw_animations animations;
  mrw_character character;
  mrw_playback playback;
  mrw_animation_layer layer;
  mrw_skin_output out;
  const mrw_animation* walk;
  const mrw_character_mesh* body;
  size_t size;
  int frame;

  if (mrw_abi() != MRW_ABI) return 1; /* the library is not that of this header */
  if (mrw_is_packed(bytes.data, bytes.size)) {
    mrw_mesh_decoder draco;
    mrw_unpack_sizes sizes;
    must(mrw_draco_decoder(&draco));
    must(mrw_find_unpack_sizes(bytes.data, bytes.size, &sizes, NULL));
    must(mrw_unpack(bytes.data, bytes.size, &draco, 1, block_of(sizes.memory_bytes), sizes.memory_bytes, &bytes, NULL));
  }
  must(mrw_load(bytes.data, bytes.size, &file, NULL));
  size = mrw_animations_bytes(&file, &file);
  must(mrw_make_animations(&file, &file, block_of(size), size, &animations));
  size = mrw_character_bytes(&file, NULL); /* NULL: options as C++ has them by default */
  must(mrw_make_character(&file, NULL, block_of(size), size, &character));
  walk = mrw_find_animation(&animations, "walk");
  if (walk == NULL || character.mesh_count == 0) return 1;
  body = &character.meshes[0];

  mrw_skin_output_init(&out);
  out.position_count = 3 * (size_t)body->mesh.geometry.slot_count;
  out.positions = block_of(out.position_count * sizeof(float));
  mrw_playback_init(&playback);
  mrw_animation_layer_init(&layer);
  layer.animation = walk;
  for (frame = 0; frame < 60; ++frame) { /* nothing here allocates */
    must(mrw_advance(&playback, walk->duration_s, 1.0f / 60));
    layer.time_s = mrw_clip_time(&playback);
    must(mrw_pose_character(&character, &layer, 1));
    /* Here the game reaches, looks, places feet. */
    must(mrw_finish_character(&character));
    must(mrw_skin_ssd(&body->mesh, body->palette, body->palette_count, &out));
  }
  printf("%s: vertex 0 at %g %g %g m\n", body->mesh.name, out.positions[0], out.positions[1], out.positions[2]);
  return 0;
}
