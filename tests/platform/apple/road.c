/* The road of a character without a C library: what an executable for iOS is linked of, measured by, and entered at. */
#include <marrow/c.h>

/* Places what it needs in `memory`, as the runtime wants it. */
static char* next;
static char* end;

static void* take(size_t bytes) {
  char* const out = next;
  bytes = (bytes + 15) / 16 * 16;
  if ((size_t)(end - next) < bytes) return NULL;
  next += bytes;
  return out;
}

#define TRY(call) \
  if ((call) != MRW_OK) return -__LINE__

/* Poses a clip at a moment and skins all meshes: `out` gets the positions of every slot, 3 floats each. Returns how
   many floats; below zero the line at which it stopped. `bytes` and `memory` begin on boundaries of 16 bytes. */
long road(const void* bytes, size_t byte_count, const char* clip, float time_s, void* memory, size_t memory_bytes,
          float* out, size_t out_count) {
  mrw_bytes cooked = {bytes, byte_count};
  mrw_file file;
  mrw_animations animations;
  mrw_character character;
  mrw_animation_layer layer;
  size_t size, mesh, written = 0;
  next = memory;
  end = next + memory_bytes;
  if (mrw_abi() != MRW_ABI) return -__LINE__;
  if (mrw_is_packed(cooked.data, cooked.size)) {
    mrw_unpack_sizes sizes;
    TRY(mrw_find_unpack_sizes(cooked.data, cooked.size, &sizes, NULL));
    TRY(mrw_unpack(cooked.data, cooked.size, NULL, 0, take(sizes.memory_bytes), sizes.memory_bytes, &cooked, NULL));
  }
  TRY(mrw_load(cooked.data, cooked.size, &file, NULL));
  size = mrw_animations_bytes(&file, &file);
  TRY(mrw_make_animations(&file, &file, take(size), size, &animations));
  size = mrw_character_bytes(&file, NULL);
  TRY(mrw_make_character(&file, NULL, take(size), size, &character));
  mrw_animation_layer_init(&layer);
  layer.animation = mrw_find_animation(&animations, clip);
  layer.time_s = time_s;
  if (layer.animation == NULL) return -__LINE__;
  TRY(mrw_pose_character(&character, &layer, 1));
  TRY(mrw_finish_character(&character));
  for (mesh = 0; mesh < character.mesh_count; ++mesh) {
    const mrw_character_mesh* const m = &character.meshes[mesh];
    mrw_skin_output skinned;
    mrw_skin_output_init(&skinned);
    skinned.position_count = 3 * (size_t)m->mesh.geometry.slot_count;
    if (out_count - written < skinned.position_count) return -__LINE__;
    skinned.positions = out + written;
    TRY(mrw_skin_ssd(&m->mesh, m->palette, m->palette_count, &skinned));
    written += skinned.position_count;
  }
  return (long)written;
}
