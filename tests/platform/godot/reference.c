/* What the engines must show of a cooked file, by the C interface alone: poses as translation, rotation and scale of
 * each joint, joints in the scene, and skinned vertices. usage: reference FILE.mrw OUT_FOLDER */
#include <marrow/c.h>

#include <stdio.h>
#include <stdlib.h>

enum { kSteps = 30 };

static void must(bool good, const char* what) {
  if (good) return;
  fprintf(stderr, "reference: %s\n", what);
  exit(1);
}

static void ok(mrw_status status) { must(status == MRW_OK, mrw_status_text(status)); }

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

int main(int argc, char** argv) {
  mrw_bytes bytes;
  mrw_file file;
  mrw_skeleton skeleton;
  mrw_soa_transform* local;
  mrw_affine* joints;
  FILE *poses, *scene, *skinned;
  uint32_t i, step;
  must(argc == 3, "usage: reference FILE.mrw OUT_FOLDER");
  bytes = read_file(argv[1]);
  if (mrw_is_packed(bytes.data, bytes.size)) {
    mrw_mesh_decoder draco;
    mrw_unpack_sizes sizes;
    ok(mrw_draco_decoder(&draco));
    ok(mrw_find_unpack_sizes(bytes.data, bytes.size, &sizes, NULL));
    ok(mrw_unpack(bytes.data, bytes.size, &draco, 1, block_of(sizes.memory_bytes), sizes.memory_bytes, &bytes, NULL));
  }
  ok(mrw_load(bytes.data, bytes.size, &file, NULL));
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
  return 0;
}
