// Made by tools/c_api from the descriptions in runtime/c: do not edit.
// Of every function a call; what it is given, bad_calls.c says.
// clang-format off
static int call_gles3_error_watch_init(const Round* r) {
  mrw_gles3_error_watch_init(at(r, 0));
  return -1;
}
static int call_gles3_caps_init(const Round* r) {
  mrw_gles3_caps_init(at(r, 0));
  return -1;
}
static int call_gles3_vertex_layout_init(const Round* r) {
  mrw_gles3_vertex_layout_init(at(r, 0));
  return -1;
}
static int call_gles3_gpu_mesh_init(const Round* r) {
  mrw_gles3_gpu_mesh_init(at(r, 0));
  return -1;
}
static int call_gles3_prepare_options_init(const Round* r) {
  mrw_gles3_prepare_options_init(at(r, 0));
  return -1;
}
static int call_gles3_program_key_init(const Round* r) {
  mrw_gles3_program_key_init(at(r, 0));
  return -1;
}
static int call_gles3_program_source_init(const Round* r) {
  mrw_gles3_program_source_init(at(r, 0));
  return -1;
}
static int call_gles3_program_init(const Round* r) {
  mrw_gles3_program_init(at(r, 0));
  return -1;
}
static int call_gles3_palette_ring_init(const Round* r) {
  mrw_gles3_palette_ring_init(at(r, 0));
  return -1;
}
static int call_gles3_palette_texture_init(const Round* r) {
  mrw_gles3_palette_texture_init(at(r, 0));
  return -1;
}
static int call_gles3_load_api(const Round* r) {
  (void)r;
  return mrw_gles3_load_api(at(r, 0), gles3_load_proc(r), at(r, 2));
}
static int call_gles3_context_was_reset(const Round* r) {
  (void)r;
  (void)mrw_gles3_context_was_reset(ready(r, 0));
  return -1;
}
static int call_gles3_watch_errors(const Round* r) {
  (void)r;
  (void)mrw_gles3_watch_errors(at(r, 0), at(r, 1));
  return -1;
}
static int call_gles3_query_caps(const Round* r) {
  (void)r;
  return mrw_gles3_query_caps(ready(r, 0), at(r, 1));
}
static int call_gles3_prepare_scratch_bytes(const Round* r) {
  (void)r;
  (void)mrw_gles3_prepare_scratch_bytes(at(r, 0), at(r, 1));
  return -1;
}
static int call_gles3_prepare(const Round* r) {
  (void)r;
  return mrw_gles3_prepare(ready(r, 0), at(r, 1), at(r, 2), at(r, 3), list(r, 4), count(r), list(r, 5), count(r), at(r, 6));
}
static int call_gles3_destroy_mesh(const Round* r) {
  (void)r;
  (void)mrw_gles3_destroy_mesh(ready(r, 0), at(r, 1));
  return -1;
}
static int call_gles3_build_program(const Round* r) {
  (void)r;
  return mrw_gles3_build_program(ready(r, 0), at(r, 1), at(r, 2), (uint32_t)whole(r), at(r, 4), list(r, 5), count(r));
}
static int call_gles3_destroy_program(const Round* r) {
  (void)r;
  (void)mrw_gles3_destroy_program(ready(r, 0), at(r, 1));
  return -1;
}
static int call_gles3_create_palette_ring(const Round* r) {
  (void)r;
  return mrw_gles3_create_palette_ring(ready(r, 0), at(r, 1), (uint32_t)whole(r), (uint32_t)whole(r), at(r, 4));
}
static int call_gles3_destroy_palette_ring(const Round* r) {
  (void)r;
  (void)mrw_gles3_destroy_palette_ring(ready(r, 0), at(r, 1));
  return -1;
}
static int call_gles3_begin_frame(const Round* r) {
  (void)r;
  (void)mrw_gles3_begin_frame(ready(r, 0), at(r, 1));
  return -1;
}
static int call_gles3_push_palette(const Round* r) {
  (void)r;
  return mrw_gles3_push_palette(ready(r, 0), at(r, 1), list(r, 2), count(r), at(r, 3));
}
static int call_gles3_bind_palette(const Round* r) {
  (void)r;
  (void)mrw_gles3_bind_palette(ready(r, 0), at(r, 1), (uint32_t)whole(r), (uint32_t)whole(r));
  return -1;
}
static int call_gles3_create_palette_texture(const Round* r) {
  (void)r;
  return mrw_gles3_create_palette_texture(ready(r, 0), at(r, 1), (uint32_t)whole(r), at(r, 3));
}
static int call_gles3_destroy_palette_texture(const Round* r) {
  (void)r;
  (void)mrw_gles3_destroy_palette_texture(ready(r, 0), at(r, 1));
  return -1;
}
static int call_gles3_upload_palettes(const Round* r) {
  (void)r;
  return mrw_gles3_upload_palettes(ready(r, 0), at(r, 1), list(r, 2), count(r));
}
static int call_gles3_bind_texture_palette(const Round* r) {
  (void)r;
  return mrw_gles3_bind_texture_palette(ready(r, 0), at(r, 1), (uint32_t)whole(r), (uint32_t)whole(r), (uint32_t)whole(r), at(r, 5));
}
static int call_gles3_bind_previous_palette(const Round* r) {
  (void)r;
  return mrw_gles3_bind_previous_palette(ready(r, 0), at(r, 1), (uint32_t)whole(r), (uint32_t)whole(r), whole(r) != 0, (uint32_t)whole(r), at(r, 6));
}
static int call_gles3_set_morphs(const Round* r) {
  (void)r;
  return mrw_gles3_set_morphs(ready(r, 0), at(r, 1), at(r, 2), list(r, 3), count(r), (uint32_t)whole(r), at(r, 5));
}
static int call_gles3_set_previous_morphs(const Round* r) {
  (void)r;
  return mrw_gles3_set_previous_morphs(ready(r, 0), at(r, 1), at(r, 2), list(r, 3), count(r), at(r, 4));
}
static int call_gles3_distance_matrices(const Round* r) {
  (void)r;
  (void)mrw_gles3_distance_matrices(at(r, 0));
  return -1;
}
static int call_gles3_pack_distances(const Round* r) {
  (void)r;
  return mrw_gles3_pack_distances(at(r, 0), list(r, 1), count(r), list(r, 2), count(r));
}
static int call_gles3_bind_examples(const Round* r) {
  (void)r;
  return mrw_gles3_bind_examples(ready(r, 0), at(r, 1), at(r, 2), (uint32_t)whole(r), (uint32_t)whole(r), at(r, 5));
}
static int call_gles3_bind_previous_distances(const Round* r) {
  (void)r;
  return mrw_gles3_bind_previous_distances(ready(r, 0), at(r, 1), at(r, 2), (uint32_t)whole(r), whole(r) != 0, (uint32_t)whole(r), at(r, 6));
}
static int call_gles3_draw_mesh(const Round* r) {
  (void)r;
  return mrw_gles3_draw_mesh(ready(r, 0), at(r, 1), (mrw_gles3_deformer)whole(r), at(r, 3), (uint32_t)whole(r));
}
static int call_gles3_skinned_mesh_init(const Round* r) {
  mrw_gles3_skinned_mesh_init(at(r, 0));
  return -1;
}
static int call_gles3_create_skinned(const Round* r) {
  (void)r;
  return mrw_gles3_create_skinned(ready(r, 0), at(r, 1), at(r, 2));
}
static int call_gles3_destroy_skinned(const Round* r) {
  (void)r;
  (void)mrw_gles3_destroy_skinned(ready(r, 0), at(r, 1));
  return -1;
}
static int call_gles3_upload_skinned(const Round* r) {
  (void)r;
  return mrw_gles3_upload_skinned(ready(r, 0), at(r, 1), at(r, 2));
}
static int call_gles3_build_preskin(const Round* r) {
  (void)r;
  return mrw_gles3_build_preskin(ready(r, 0), at(r, 1), at(r, 2), (mrw_gles3_preskin)whole(r), (uint32_t)whole(r), at(r, 5), list(r, 6), count(r));
}
static int call_gles3_preskin_mesh(const Round* r) {
  (void)r;
  return mrw_gles3_preskin_mesh(ready(r, 0), at(r, 1), (mrw_gles3_deformer)whole(r), at(r, 3), at(r, 4));
}
static int call_gles3_set_previous(const Round* r) {
  (void)r;
  return mrw_gles3_set_previous(ready(r, 0), at(r, 1), at(r, 2));
}
static int call_gles3_draw_skinned(const Round* r) {
  (void)r;
  (void)mrw_gles3_draw_skinned(ready(r, 0), at(r, 1), at(r, 2));
  return -1;
}
static int call_gles3_program_set_init(const Round* r) {
  mrw_gles3_program_set_init(at(r, 0));
  return -1;
}
static int call_gles3_skinner_options_init(const Round* r) {
  mrw_gles3_skinner_options_init(at(r, 0));
  return -1;
}
static int call_gles3_skinning_path_text(const Round* r) {
  (void)r;
  (void)mrw_gles3_skinning_path_text((mrw_gles3_skinning_path)whole(r));
  return -1;
}
static int call_gles3_destroy_programs(const Round* r) {
  (void)r;
  (void)mrw_gles3_destroy_programs(ready(r, 0), at(r, 1));
  return -1;
}
static int call_gles3_skinner_bytes(const Round* r) {
  (void)r;
  (void)mrw_gles3_skinner_bytes(at(r, 0), at(r, 1));
  return -1;
}
static int call_gles3_create_skinner(const Round* r) {
  (void)r;
  return mrw_gles3_create_skinner(ready(r, 0), at(r, 1), at(r, 2), at(r, 3), at(r, 4), list(r, 5), count(r), at(r, 6));
}
static int call_gles3_destroy_skinner(const Round* r) {
  (void)r;
  (void)mrw_gles3_destroy_skinner(ready(r, 0), at(r, 1));
  return -1;
}
static int call_gles3_pose(const Round* r) {
  (void)r;
  return mrw_gles3_pose(at(r, 0), (uint32_t)whole(r), list(r, 2), count(r), list(r, 3), count(r));
}
static int call_gles3_reset_motion(const Round* r) {
  (void)r;
  return mrw_gles3_reset_motion(at(r, 0), (uint32_t)whole(r));
}
static int call_gles3_update(const Round* r) {
  (void)r;
  return mrw_gles3_update(ready(r, 0), at(r, 1), at(r, 2), (uint32_t)whole(r));
}
static int call_gles3_program_of(const Round* r) {
  (void)r;
  (void)mrw_gles3_program_of(at(r, 0), at(r, 1), (uint32_t)whole(r));
  return -1;
}
static int call_gles3_draw(const Round* r) {
  (void)r;
  return mrw_gles3_draw(ready(r, 0), at(r, 1), at(r, 2), at(r, 3), (uint32_t)whole(r), (uint32_t)whole(r));
}
static int call_gles3_programs_on_context_lost(const Round* r) {
  (void)r;
  (void)mrw_gles3_programs_on_context_lost(at(r, 0));
  return -1;
}
static int call_gles3_skinner_on_context_lost(const Round* r) {
  (void)r;
  (void)mrw_gles3_skinner_on_context_lost(at(r, 0));
  return -1;
}
static int call_gles3_programs_on_context_restored(const Round* r) {
  (void)r;
  return mrw_gles3_programs_on_context_restored(ready(r, 0), at(r, 1), at(r, 2));
}
static int call_gles3_skinner_on_context_restored(const Round* r) {
  (void)r;
  return mrw_gles3_skinner_on_context_restored(ready(r, 0), at(r, 1), at(r, 2));
}
static int call_gles3_crowd_source_init(const Round* r) {
  mrw_gles3_crowd_source_init(at(r, 0));
  return -1;
}
static int call_gles3_crowd_clip_init(const Round* r) {
  mrw_gles3_crowd_clip_init(at(r, 0));
  return -1;
}
static int call_gles3_crowd_frames_init(const Round* r) {
  mrw_gles3_crowd_frames_init(at(r, 0));
  return -1;
}
static int call_gles3_crowd_play_init(const Round* r) {
  mrw_gles3_crowd_play_init(at(r, 0));
  return -1;
}
static int call_gles3_crowd_instance_init(const Round* r) {
  mrw_gles3_crowd_instance_init(at(r, 0));
  return -1;
}
static int call_gles3_crowd_mesh_init(const Round* r) {
  mrw_gles3_crowd_mesh_init(at(r, 0));
  return -1;
}
static int call_gles3_crowd_init(const Round* r) {
  mrw_gles3_crowd_init(at(r, 0));
  return -1;
}
static int call_gles3_plan_crowd(const Round* r) {
  (void)r;
  return mrw_gles3_plan_crowd(list(r, 0), count(r), real(r), list(r, 2), count(r), at(r, 3));
}
static int call_gles3_bake_crowd(const Round* r) {
  (void)r;
  return mrw_gles3_bake_crowd(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), list(r, 3), count(r), list(r, 4), count(r), at(r, 5));
}
static int call_gles3_crowd_joint(const Round* r) {
  (void)r;
  return mrw_gles3_crowd_joint(at(r, 0), at(r, 1), real(r), (uint32_t)whole(r), at(r, 4));
}
static int call_gles3_crowd_pose(const Round* r) {
  (void)r;
  return mrw_gles3_crowd_pose(at(r, 0), at(r, 1), real(r), list(r, 3), count(r));
}
static int call_gles3_crowd_palettes_that_fit(const Round* r) {
  (void)r;
  (void)mrw_gles3_crowd_palettes_that_fit(at(r, 0), (uint32_t)whole(r));
  return -1;
}
static int call_gles3_crowd_mesh_bytes(const Round* r) {
  (void)r;
  (void)mrw_gles3_crowd_mesh_bytes(at(r, 0), at(r, 1));
  return -1;
}
static int call_gles3_create_crowd_mesh(const Round* r) {
  (void)r;
  return mrw_gles3_create_crowd_mesh(ready(r, 0), at(r, 1), at(r, 2), at(r, 3), at(r, 4), (uint32_t)whole(r), list(r, 6), count(r), at(r, 7), whole(r) != 0);
}
static int call_gles3_destroy_crowd_mesh(const Round* r) {
  (void)r;
  (void)mrw_gles3_destroy_crowd_mesh(ready(r, 0), at(r, 1));
  return -1;
}
static int call_gles3_create_crowd(const Round* r) {
  (void)r;
  return mrw_gles3_create_crowd(ready(r, 0), at(r, 1), (uint32_t)whole(r), list(r, 3), count(r), at(r, 4));
}
static int call_gles3_destroy_crowd(const Round* r) {
  (void)r;
  (void)mrw_gles3_destroy_crowd(ready(r, 0), at(r, 1));
  return -1;
}
static int call_gles3_set_instances(const Round* r) {
  (void)r;
  return mrw_gles3_set_instances(ready(r, 0), at(r, 1), at(r, 2), (uint32_t)whole(r), list(r, 4), count(r));
}
static int call_gles3_build_crowd_program(const Round* r) {
  (void)r;
  return mrw_gles3_build_crowd_program(ready(r, 0), at(r, 1), list(r, 2), count(r));
}
static int call_gles3_build_crowd_programs(const Round* r) {
  (void)r;
  return mrw_gles3_build_crowd_programs(ready(r, 0), at(r, 1), at(r, 2), (mrw_gles3_deformer)whole(r), (uint32_t)whole(r), at(r, 5));
}
static int call_gles3_crowd_program_of(const Round* r) {
  (void)r;
  (void)mrw_gles3_crowd_program_of(at(r, 0), (mrw_gles3_deformer)whole(r), (uint32_t)whole(r), at(r, 3), (uint32_t)whole(r));
  return -1;
}
static int call_gles3_blending_program_of(const Round* r) {
  (void)r;
  (void)mrw_gles3_blending_program_of(at(r, 0));
  return -1;
}
static int call_gles3_begin_crowd_frame(const Round* r) {
  (void)r;
  (void)mrw_gles3_begin_crowd_frame(at(r, 0));
  return -1;
}
static int call_gles3_blend_previous_crowd(const Round* r) {
  (void)r;
  return mrw_gles3_blend_previous_crowd(ready(r, 0), at(r, 1), at(r, 2), (uint32_t)whole(r), (uint32_t)whole(r), real(r), (uint32_t)whole(r), at(r, 7));
}
static int call_gles3_blend_crowd(const Round* r) {
  (void)r;
  return mrw_gles3_blend_crowd(ready(r, 0), at(r, 1), at(r, 2), (uint32_t)whole(r), (uint32_t)whole(r), real(r), (uint32_t)whole(r), at(r, 7));
}
static int call_gles3_bind_crowd(const Round* r) {
  (void)r;
  return mrw_gles3_bind_crowd(ready(r, 0), at(r, 1), at(r, 2), (uint32_t)whole(r), (uint32_t)whole(r), (uint32_t)whole(r), at(r, 6));
}
static int call_gles3_crowd_mesh_on_context_lost(const Round* r) {
  (void)r;
  (void)mrw_gles3_crowd_mesh_on_context_lost(at(r, 0));
  return -1;
}
static int call_gles3_crowd_on_context_lost(const Round* r) {
  (void)r;
  (void)mrw_gles3_crowd_on_context_lost(at(r, 0));
  return -1;
}
static int call_gles3_crowd_mesh_on_context_restored(const Round* r) {
  (void)r;
  return mrw_gles3_crowd_mesh_on_context_restored(ready(r, 0), at(r, 1), at(r, 2));
}
static int call_gles3_crowd_on_context_restored(const Round* r) {
  (void)r;
  return mrw_gles3_crowd_on_context_restored(ready(r, 0), at(r, 1), at(r, 2));
}
static int call_gles3_path_result_init(const Round* r) {
  mrw_gles3_path_result_init(at(r, 0));
  return -1;
}
static int call_gles3_self_test_init(const Round* r) {
  mrw_gles3_self_test_init(at(r, 0));
  return -1;
}
static int call_gles3_self_test_options_init(const Round* r) {
  mrw_gles3_self_test_options_init(at(r, 0));
  return -1;
}
static int call_gles3_path_need_init(const Round* r) {
  mrw_gles3_path_need_init(at(r, 0));
  return -1;
}
static int call_gles3_verdict_text(const Round* r) {
  (void)r;
  (void)mrw_gles3_verdict_text((mrw_gles3_verdict)whole(r));
  return -1;
}
static int call_gles3_self_test_bytes(const Round* r) {
  (void)r;
  (void)mrw_gles3_self_test_bytes(at(r, 0));
  return -1;
}
static int call_gles3_run_self_test(const Round* r) {
  (void)r;
  return mrw_gles3_run_self_test(ready(r, 0), at(r, 1), at(r, 2), list(r, 3), count(r), at(r, 4));
}
static int call_gles3_choose(const Round* r) {
  (void)r;
  return mrw_gles3_choose(at(r, 0), at(r, 1), at(r, 2));
}
static int call_gles3_save(const Round* r) {
  (void)r;
  return mrw_gles3_save(at(r, 0), list(r, 1), count(r));
}
static int call_gles3_restore(const Round* r) {
  (void)r;
  return mrw_gles3_restore(ready(r, 0), at(r, 1), at(r, 2), list(r, 3), count(r), at(r, 4));
}

static const Row rows[] = {
    {"mrw_gles3_error_watch_init", call_gles3_error_watch_init, 0, 0},
    {"mrw_gles3_caps_init", call_gles3_caps_init, 0, 0},
    {"mrw_gles3_vertex_layout_init", call_gles3_vertex_layout_init, 0, 0},
    {"mrw_gles3_gpu_mesh_init", call_gles3_gpu_mesh_init, 0, 0},
    {"mrw_gles3_prepare_options_init", call_gles3_prepare_options_init, 0, 0},
    {"mrw_gles3_program_key_init", call_gles3_program_key_init, 0, 0},
    {"mrw_gles3_program_source_init", call_gles3_program_source_init, 0, 0},
    {"mrw_gles3_program_init", call_gles3_program_init, 0, 0},
    {"mrw_gles3_palette_ring_init", call_gles3_palette_ring_init, 0, 0},
    {"mrw_gles3_palette_texture_init", call_gles3_palette_texture_init, 0, 0},
    {"mrw_gles3_load_api", call_gles3_load_api, 1, 0},
    {"mrw_gles3_context_was_reset", call_gles3_context_was_reset, 1, 0},
    {"mrw_gles3_watch_errors", call_gles3_watch_errors, 1, 0},
    {"mrw_gles3_query_caps", call_gles3_query_caps, 1, 0},
    {"mrw_gles3_prepare_scratch_bytes", call_gles3_prepare_scratch_bytes, 1, 0},
    {"mrw_gles3_prepare", call_gles3_prepare, 1, 1},
    {"mrw_gles3_destroy_mesh", call_gles3_destroy_mesh, 1, 0},
    {"mrw_gles3_build_program", call_gles3_build_program, 1, 1},
    {"mrw_gles3_destroy_program", call_gles3_destroy_program, 1, 0},
    {"mrw_gles3_create_palette_ring", call_gles3_create_palette_ring, 1, 0},
    {"mrw_gles3_destroy_palette_ring", call_gles3_destroy_palette_ring, 1, 0},
    {"mrw_gles3_begin_frame", call_gles3_begin_frame, 1, 0},
    {"mrw_gles3_push_palette", call_gles3_push_palette, 1, 1},
    {"mrw_gles3_bind_palette", call_gles3_bind_palette, 1, 0},
    {"mrw_gles3_create_palette_texture", call_gles3_create_palette_texture, 1, 0},
    {"mrw_gles3_destroy_palette_texture", call_gles3_destroy_palette_texture, 1, 0},
    {"mrw_gles3_upload_palettes", call_gles3_upload_palettes, 1, 1},
    {"mrw_gles3_bind_texture_palette", call_gles3_bind_texture_palette, 1, 0},
    {"mrw_gles3_bind_previous_palette", call_gles3_bind_previous_palette, 1, 0},
    {"mrw_gles3_set_morphs", call_gles3_set_morphs, 1, 1},
    {"mrw_gles3_set_previous_morphs", call_gles3_set_previous_morphs, 1, 1},
    {"mrw_gles3_distance_matrices", call_gles3_distance_matrices, 1, 0},
    {"mrw_gles3_pack_distances", call_gles3_pack_distances, 1, 1},
    {"mrw_gles3_bind_examples", call_gles3_bind_examples, 1, 0},
    {"mrw_gles3_bind_previous_distances", call_gles3_bind_previous_distances, 1, 0},
    {"mrw_gles3_draw_mesh", call_gles3_draw_mesh, 1, 0},
    {"mrw_gles3_skinned_mesh_init", call_gles3_skinned_mesh_init, 0, 0},
    {"mrw_gles3_create_skinned", call_gles3_create_skinned, 1, 0},
    {"mrw_gles3_destroy_skinned", call_gles3_destroy_skinned, 1, 0},
    {"mrw_gles3_upload_skinned", call_gles3_upload_skinned, 1, 0},
    {"mrw_gles3_build_preskin", call_gles3_build_preskin, 1, 1},
    {"mrw_gles3_preskin_mesh", call_gles3_preskin_mesh, 1, 0},
    {"mrw_gles3_set_previous", call_gles3_set_previous, 1, 0},
    {"mrw_gles3_draw_skinned", call_gles3_draw_skinned, 1, 0},
    {"mrw_gles3_program_set_init", call_gles3_program_set_init, 0, 0},
    {"mrw_gles3_skinner_options_init", call_gles3_skinner_options_init, 0, 0},
    {"mrw_gles3_skinning_path_text", call_gles3_skinning_path_text, 0, 0},
    {"mrw_gles3_destroy_programs", call_gles3_destroy_programs, 1, 0},
    {"mrw_gles3_skinner_bytes", call_gles3_skinner_bytes, 1, 0},
    {"mrw_gles3_create_skinner", call_gles3_create_skinner, 1, 1},
    {"mrw_gles3_destroy_skinner", call_gles3_destroy_skinner, 1, 0},
    {"mrw_gles3_pose", call_gles3_pose, 1, 1},
    {"mrw_gles3_reset_motion", call_gles3_reset_motion, 1, 0},
    {"mrw_gles3_update", call_gles3_update, 1, 0},
    {"mrw_gles3_program_of", call_gles3_program_of, 1, 0},
    {"mrw_gles3_draw", call_gles3_draw, 1, 0},
    {"mrw_gles3_programs_on_context_lost", call_gles3_programs_on_context_lost, 1, 0},
    {"mrw_gles3_skinner_on_context_lost", call_gles3_skinner_on_context_lost, 1, 0},
    {"mrw_gles3_programs_on_context_restored", call_gles3_programs_on_context_restored, 1, 0},
    {"mrw_gles3_skinner_on_context_restored", call_gles3_skinner_on_context_restored, 1, 0},
    {"mrw_gles3_crowd_source_init", call_gles3_crowd_source_init, 0, 0},
    {"mrw_gles3_crowd_clip_init", call_gles3_crowd_clip_init, 0, 0},
    {"mrw_gles3_crowd_frames_init", call_gles3_crowd_frames_init, 0, 0},
    {"mrw_gles3_crowd_play_init", call_gles3_crowd_play_init, 0, 0},
    {"mrw_gles3_crowd_instance_init", call_gles3_crowd_instance_init, 0, 0},
    {"mrw_gles3_crowd_mesh_init", call_gles3_crowd_mesh_init, 0, 0},
    {"mrw_gles3_crowd_init", call_gles3_crowd_init, 0, 0},
    {"mrw_gles3_plan_crowd", call_gles3_plan_crowd, 0, 1},
    {"mrw_gles3_bake_crowd", call_gles3_bake_crowd, 1, 1},
    {"mrw_gles3_crowd_joint", call_gles3_crowd_joint, 1, 0},
    {"mrw_gles3_crowd_pose", call_gles3_crowd_pose, 1, 1},
    {"mrw_gles3_crowd_palettes_that_fit", call_gles3_crowd_palettes_that_fit, 1, 0},
    {"mrw_gles3_crowd_mesh_bytes", call_gles3_crowd_mesh_bytes, 1, 0},
    {"mrw_gles3_create_crowd_mesh", call_gles3_create_crowd_mesh, 1, 1},
    {"mrw_gles3_destroy_crowd_mesh", call_gles3_destroy_crowd_mesh, 1, 0},
    {"mrw_gles3_create_crowd", call_gles3_create_crowd, 1, 1},
    {"mrw_gles3_destroy_crowd", call_gles3_destroy_crowd, 1, 0},
    {"mrw_gles3_set_instances", call_gles3_set_instances, 1, 1},
    {"mrw_gles3_build_crowd_program", call_gles3_build_crowd_program, 1, 1},
    {"mrw_gles3_build_crowd_programs", call_gles3_build_crowd_programs, 1, 0},
    {"mrw_gles3_crowd_program_of", call_gles3_crowd_program_of, 1, 0},
    {"mrw_gles3_blending_program_of", call_gles3_blending_program_of, 1, 0},
    {"mrw_gles3_begin_crowd_frame", call_gles3_begin_crowd_frame, 1, 0},
    {"mrw_gles3_blend_previous_crowd", call_gles3_blend_previous_crowd, 1, 0},
    {"mrw_gles3_blend_crowd", call_gles3_blend_crowd, 1, 0},
    {"mrw_gles3_bind_crowd", call_gles3_bind_crowd, 1, 0},
    {"mrw_gles3_crowd_mesh_on_context_lost", call_gles3_crowd_mesh_on_context_lost, 1, 0},
    {"mrw_gles3_crowd_on_context_lost", call_gles3_crowd_on_context_lost, 1, 0},
    {"mrw_gles3_crowd_mesh_on_context_restored", call_gles3_crowd_mesh_on_context_restored, 1, 0},
    {"mrw_gles3_crowd_on_context_restored", call_gles3_crowd_on_context_restored, 1, 0},
    {"mrw_gles3_path_result_init", call_gles3_path_result_init, 0, 0},
    {"mrw_gles3_self_test_init", call_gles3_self_test_init, 0, 0},
    {"mrw_gles3_self_test_options_init", call_gles3_self_test_options_init, 0, 0},
    {"mrw_gles3_path_need_init", call_gles3_path_need_init, 0, 0},
    {"mrw_gles3_verdict_text", call_gles3_verdict_text, 0, 0},
    {"mrw_gles3_self_test_bytes", call_gles3_self_test_bytes, 1, 0},
    {"mrw_gles3_run_self_test", call_gles3_run_self_test, 1, 1},
    {"mrw_gles3_choose", call_gles3_choose, 1, 0},
    {"mrw_gles3_save", call_gles3_save, 1, 1},
    {"mrw_gles3_restore", call_gles3_restore, 1, 1},
};
