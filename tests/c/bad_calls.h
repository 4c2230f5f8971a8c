// Made by tools/c_api from the descriptions in runtime/c: do not edit.
// Of every function a call; what it is given, bad_calls.c says.
// clang-format off
static int call_data_error_init(const Round* r) {
  mrw_data_error_init(at(r, 0));
  return -1;
}
static int call_status_text(const Round* r) {
  (void)r;
  (void)mrw_status_text((mrw_status)whole(r));
  return -1;
}
static int call_get_call_error_handler(const Round* r) {
  (void)r;
  (void)mrw_get_call_error_handler();
  return -1;
}
static int call_block_bytes(const Round* r) {
  (void)r;
  (void)mrw_block_bytes((uint32_t)whole(r));
  return -1;
}
static int call_is_on_boundary(const Round* r) {
  (void)r;
  (void)mrw_is_on_boundary(at(r, 0));
  return -1;
}
static int call_block_in(const Round* r) {
  (void)r;
  return mrw_block_in(list(r, 0), count(r), at(r, 1));
}
static int call_bytes_init(const Round* r) {
  mrw_bytes_init(at(r, 0));
  return -1;
}
static int call_is_packed(const Round* r) {
  (void)r;
  (void)mrw_is_packed(list(r, 0), count(r));
  return -1;
}
static int call_find_unpack_sizes(const Round* r) {
  (void)r;
  return mrw_find_unpack_sizes(list(r, 0), count(r), at(r, 1), at(r, 2));
}
static int call_unpack(const Round* r) {
  (void)r;
  return mrw_unpack(list(r, 0), count(r), list(r, 1), count(r), list(r, 2), count(r), at(r, 3), at(r, 4));
}
static int call_unpacking_init(const Round* r) {
  mrw_unpacking_init(at(r, 0));
  return -1;
}
static int call_begin_unpack(const Round* r) {
  (void)r;
  return mrw_begin_unpack(list(r, 0), count(r), list(r, 1), count(r), list(r, 2), count(r), at(r, 3), at(r, 4));
}
static int call_unpack_step(const Round* r) {
  (void)r;
  return mrw_unpack_step(at(r, 0), at(r, 1));
}
static int call_joint_transform_init(const Round* r) {
  mrw_joint_transform_init(at(r, 0));
  return -1;
}
static int call_soa_count(const Round* r) {
  (void)r;
  (void)mrw_soa_count((uint32_t)whole(r));
  return -1;
}
static int call_get_joint(const Round* r) {
  (void)r;
  return mrw_get_joint(list(r, 0), count(r), (uint32_t)whole(r), at(r, 2));
}
static int call_set_joint(const Round* r) {
  (void)r;
  return mrw_set_joint(list(r, 0), count(r), (uint32_t)whole(r), at(r, 2));
}
static int call_rate_limit_init(const Round* r) {
  mrw_rate_limit_init(at(r, 0));
  return -1;
}
static int call_joint_limit_init(const Round* r) {
  mrw_joint_limit_init(at(r, 0));
  return -1;
}
static int call_spring_joint_init(const Round* r) {
  mrw_spring_joint_init(at(r, 0));
  return -1;
}
static int call_spring_chain_init(const Round* r) {
  mrw_spring_chain_init(at(r, 0));
  return -1;
}
static int call_spring_collider_init(const Round* r) {
  mrw_spring_collider_init(at(r, 0));
  return -1;
}
static int call_helper_init(const Round* r) {
  mrw_helper_init(at(r, 0));
  return -1;
}
static int call_is_valid(const Round* r) {
  (void)r;
  (void)mrw_is_valid(at(r, 0));
  return -1;
}
static int call_file_init(const Round* r) {
  mrw_file_init(at(r, 0));
  return -1;
}
static int call_load(const Round* r) {
  (void)r;
  return mrw_load(list(r, 0), count(r), at(r, 1), at(r, 2));
}
static int call_file_skeleton_count(const Round* r) {
  (void)r;
  (void)mrw_file_skeleton_count(at(r, 0));
  return -1;
}
static int call_file_reference_count(const Round* r) {
  (void)r;
  (void)mrw_file_reference_count(at(r, 0));
  return -1;
}
static int call_file_clip_count(const Round* r) {
  (void)r;
  (void)mrw_file_clip_count(at(r, 0));
  return -1;
}
static int call_file_mesh_count(const Round* r) {
  (void)r;
  (void)mrw_file_mesh_count(at(r, 0));
  return -1;
}
static int call_file_material_count(const Round* r) {
  (void)r;
  (void)mrw_file_material_count(at(r, 0));
  return -1;
}
static int call_file_image_count(const Round* r) {
  (void)r;
  (void)mrw_file_image_count(at(r, 0));
  return -1;
}
static int call_file_node_count(const Round* r) {
  (void)r;
  (void)mrw_file_node_count(at(r, 0));
  return -1;
}
static int call_file_skeleton(const Round* r) {
  (void)r;
  return mrw_file_skeleton(at(r, 0), (uint32_t)whole(r), at(r, 2));
}
static int call_file_reference(const Round* r) {
  (void)r;
  return mrw_file_reference(at(r, 0), (uint32_t)whole(r), at(r, 2));
}
static int call_file_clip(const Round* r) {
  (void)r;
  return mrw_file_clip(at(r, 0), (uint32_t)whole(r), at(r, 2));
}
static int call_file_mesh(const Round* r) {
  (void)r;
  return mrw_file_mesh(at(r, 0), (uint32_t)whole(r), (uint32_t)whole(r), at(r, 3));
}
static int call_file_material(const Round* r) {
  (void)r;
  return mrw_file_material(at(r, 0), (uint32_t)whole(r), at(r, 2));
}
static int call_file_image(const Round* r) {
  (void)r;
  return mrw_file_image(at(r, 0), (uint32_t)whole(r), at(r, 2));
}
static int call_file_node(const Round* r) {
  (void)r;
  return mrw_file_node(at(r, 0), (uint32_t)whole(r), at(r, 2));
}
static int call_file_bounds(const Round* r) {
  (void)r;
  return mrw_file_bounds(at(r, 0), (uint32_t)whole(r), (uint32_t)whole(r), at(r, 3));
}
static int call_file_spring_count(const Round* r) {
  (void)r;
  (void)mrw_file_spring_count(at(r, 0), (uint32_t)whole(r));
  return -1;
}
static int call_file_spring(const Round* r) {
  (void)r;
  return mrw_file_spring(at(r, 0), (uint32_t)whole(r), (uint32_t)whole(r), at(r, 3));
}
static int call_file_spring_colliders(const Round* r) {
  (void)r;
  return mrw_file_spring_colliders(at(r, 0), (uint32_t)whole(r), at(r, 2));
}
static int call_file_example_space_count(const Round* r) {
  (void)r;
  (void)mrw_file_example_space_count(at(r, 0));
  return -1;
}
static int call_file_example_space(const Round* r) {
  (void)r;
  return mrw_file_example_space(at(r, 0), (uint32_t)whole(r), at(r, 2), at(r, 3));
}
static int call_file_find_skeleton(const Round* r) {
  (void)r;
  (void)mrw_file_find_skeleton(at(r, 0), text(r));
  return -1;
}
static int call_file_find_joint(const Round* r) {
  (void)r;
  (void)mrw_file_find_joint(at(r, 0), at(r, 1), text(r));
  return -1;
}
static int call_file_find_mesh(const Round* r) {
  (void)r;
  (void)mrw_file_find_mesh(at(r, 0), text(r));
  return -1;
}
static int call_file_find_clip(const Round* r) {
  (void)r;
  (void)mrw_file_find_clip(at(r, 0), text(r));
  return -1;
}
static int call_file_find_clip_of(const Round* r) {
  (void)r;
  (void)mrw_file_find_clip_of(at(r, 0), text(r), (uint32_t)whole(r));
  return -1;
}
static int call_file_find_channel(const Round* r) {
  (void)r;
  (void)mrw_file_find_channel(at(r, 0), at(r, 1), text(r));
  return -1;
}
static int call_file_find_node(const Round* r) {
  (void)r;
  (void)mrw_file_find_node(at(r, 0), text(r));
  return -1;
}
static int call_file_node_property(const Round* r) {
  (void)r;
  (void)mrw_file_node_property(at(r, 0), at(r, 1), text(r));
  return -1;
}
static int call_file_text(const Round* r) {
  (void)r;
  (void)mrw_file_text(at(r, 0), (uint32_t)whole(r));
  return -1;
}
static int call_property_text(const Round* r) {
  (void)r;
  (void)mrw_property_text(at(r, 0));
  return -1;
}
static int call_skeleton_soa_size(const Round* r) {
  (void)r;
  (void)mrw_skeleton_soa_size(at(r, 0));
  return -1;
}
static int call_mesh_palette_size(const Round* r) {
  (void)r;
  (void)mrw_mesh_palette_size(at(r, 0));
  return -1;
}
static int call_bounds_is_empty(const Round* r) {
  (void)r;
  (void)mrw_bounds_is_empty(at(r, 0));
  return -1;
}
static int call_skeleton_hash(const Round* r) {
  (void)r;
  (void)mrw_skeleton_hash(at(r, 0), (uint32_t)whole(r));
  return -1;
}
static int call_bind_clips(const Round* r) {
  (void)r;
  return mrw_bind_clips(at(r, 0), (uint32_t)whole(r), at(r, 2), (uint32_t)whole(r), list(r, 4), count(r), at(r, 5));
}
static int call_bind_outfit(const Round* r) {
  (void)r;
  return mrw_bind_outfit(at(r, 0), (uint32_t)whole(r), at(r, 2), (uint32_t)whole(r), list(r, 4), count(r), list(r, 5), count(r), at(r, 6));
}
static int call_follow_body(const Round* r) {
  (void)r;
  return mrw_follow_body(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), list(r, 3), count(r), list(r, 4), count(r));
}
static int call_playback_init(const Round* r) {
  mrw_playback_init(at(r, 0));
  return -1;
}
static int call_advance(const Round* r) {
  (void)r;
  return mrw_advance(at(r, 0), real(r), real(r));
}
static int call_clip_time(const Round* r) {
  (void)r;
  (void)mrw_clip_time(at(r, 0));
  return -1;
}
static int call_finished(const Round* r) {
  (void)r;
  (void)mrw_finished(at(r, 0), real(r));
  return -1;
}
static int call_sample_options_init(const Round* r) {
  mrw_sample_options_init(at(r, 0));
  return -1;
}
static int call_sample(const Round* r) {
  (void)r;
  return mrw_sample(at(r, 0), at(r, 1), real(r), list(r, 3), count(r), at(r, 4));
}
static int call_sample_cache_init(const Round* r) {
  mrw_sample_cache_init(at(r, 0));
  return -1;
}
static int call_sample_cache_bytes(const Round* r) {
  (void)r;
  (void)mrw_sample_cache_bytes(at(r, 0));
  return -1;
}
static int call_sample_cached(const Round* r) {
  (void)r;
  return mrw_sample_cached(at(r, 0), at(r, 1), real(r), list(r, 3), count(r), at(r, 4));
}
static int call_sample_additive(const Round* r) {
  (void)r;
  return mrw_sample_additive(at(r, 0), at(r, 1), real(r), list(r, 3), count(r));
}
static int call_sample_channels(const Round* r) {
  (void)r;
  return mrw_sample_channels(at(r, 0), real(r), list(r, 2), count(r));
}
static int call_curve_init(const Round* r) {
  mrw_curve_init(at(r, 0));
  return -1;
}
static int call_arc_length_init(const Round* r) {
  mrw_arc_length_init(at(r, 0));
  return -1;
}
static int call_cubic_bezier_ease_init(const Round* r) {
  mrw_cubic_bezier_ease_init(at(r, 0));
  return -1;
}
static int call_curve_value_count(const Round* r) {
  (void)r;
  (void)mrw_curve_value_count((mrw_curve_kind)whole(r), (uint32_t)whole(r), (uint32_t)whole(r));
  return -1;
}
static int call_check_curve(const Round* r) {
  (void)r;
  return mrw_check_curve(at(r, 0));
}
static int call_evaluate_curve(const Round* r) {
  (void)r;
  return mrw_evaluate_curve(at(r, 0), real(r), list(r, 2), count(r));
}
static int call_curve_velocity(const Round* r) {
  (void)r;
  return mrw_curve_velocity(at(r, 0), real(r), list(r, 2), count(r));
}
static int call_natural_spline(const Round* r) {
  (void)r;
  return mrw_natural_spline(at(r, 0), list(r, 1), count(r));
}
static int call_clamped_spline(const Round* r) {
  (void)r;
  return mrw_clamped_spline(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), list(r, 3), count(r));
}
static int call_bezier(const Round* r) {
  (void)r;
  return mrw_bezier(list(r, 0), count(r), (uint32_t)whole(r), real(r), list(r, 3), count(r), list(r, 4), count(r));
}
static int call_bezier_rotation(const Round* r) {
  (void)r;
  return mrw_bezier_rotation(list(r, 0), count(r), real(r), list(r, 2), count(r), list(r, 3), count(r));
}
static int call_bicubic_patch(const Round* r) {
  (void)r;
  return mrw_bicubic_patch((mrw_patch_basis)whole(r), list(r, 1), count(r), (uint32_t)whole(r), real(r), real(r), list(r, 5), count(r));
}
static int call_arc_length_count(const Round* r) {
  (void)r;
  (void)mrw_arc_length_count((uint32_t)whole(r), (uint32_t)whole(r));
  return -1;
}
static int call_build_arc_length(const Round* r) {
  (void)r;
  return mrw_build_arc_length(at(r, 0), (uint32_t)whole(r), list(r, 2), count(r));
}
static int call_time_at_distance(const Round* r) {
  (void)r;
  return mrw_time_at_distance(at(r, 0), at(r, 1), real(r), at(r, 3));
}
static int call_ease(const Round* r) {
  (void)r;
  (void)mrw_ease((mrw_easing)whole(r), (mrw_ease_mode)whole(r), real(r));
  return -1;
}
static int call_ease_by_curve(const Round* r) {
  (void)r;
  return mrw_ease_by_curve(at(r, 0), real(r), at(r, 2));
}
static int call_blend_layer_init(const Round* r) {
  mrw_blend_layer_init(at(r, 0));
  return -1;
}
static int call_additive_layer_init(const Round* r) {
  mrw_additive_layer_init(at(r, 0));
  return -1;
}
static int call_blend(const Round* r) {
  (void)r;
  return mrw_blend(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), real(r));
}
static int call_overlay(const Round* r) {
  (void)r;
  return mrw_overlay(at(r, 0), at(r, 1), list(r, 2), count(r));
}
static int call_make_additive(const Round* r) {
  (void)r;
  return mrw_make_additive(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), list(r, 3), count(r));
}
static int call_add(const Round* r) {
  (void)r;
  return mrw_add(at(r, 0), at(r, 1), list(r, 2), count(r));
}
static int call_inertia_init(const Round* r) {
  mrw_inertia_init(at(r, 0));
  return -1;
}
static int call_inertial_start_init(const Round* r) {
  mrw_inertial_start_init(at(r, 0));
  return -1;
}
static int call_fade_weight(const Round* r) {
  (void)r;
  (void)mrw_fade_weight((mrw_fade)whole(r), real(r), real(r));
  return -1;
}
static int call_cross_fade(const Round* r) {
  (void)r;
  return mrw_cross_fade(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), real(r), list(r, 4), count(r));
}
static int call_begin_inertia(const Round* r) {
  (void)r;
  return mrw_begin_inertia(at(r, 0), at(r, 1), real(r), at(r, 3));
}
static int call_apply_inertia(const Round* r) {
  (void)r;
  return mrw_apply_inertia(at(r, 0), at(r, 1), real(r), list(r, 3), count(r));
}
static int call_local_to_model(const Round* r) {
  (void)r;
  return mrw_local_to_model(at(r, 0), list(r, 1), count(r), list(r, 2), count(r));
}
static int call_local_to_model_first(const Round* r) {
  (void)r;
  return mrw_local_to_model_first(at(r, 0), list(r, 1), count(r), (uint32_t)whole(r), list(r, 3), count(r));
}
static int call_local_to_model_below(const Round* r) {
  (void)r;
  return mrw_local_to_model_below(at(r, 0), list(r, 1), count(r), (uint32_t)whole(r), list(r, 3), count(r));
}
static int call_limit_description_init(const Round* r) {
  mrw_limit_description_init(at(r, 0));
  return -1;
}
static int call_rotation_follower_init(const Round* r) {
  mrw_rotation_follower_init(at(r, 0));
  return -1;
}
static int call_point_follower_init(const Round* r) {
  mrw_point_follower_init(at(r, 0));
  return -1;
}
static int call_make_angle_range(const Round* r) {
  (void)r;
  return mrw_make_angle_range(real(r), real(r), at(r, 2));
}
static int call_make_limit(const Round* r) {
  (void)r;
  return mrw_make_limit(at(r, 0), (uint32_t)whole(r), at(r, 2));
}
static int call_clamp_rotation(const Round* r) {
  (void)r;
  return mrw_clamp_rotation(at(r, 0), at(r, 1));
}
static int call_limit_excess(const Round* r) {
  (void)r;
  (void)mrw_limit_excess(at(r, 0), at(r, 1));
  return -1;
}
static int call_limit_pose(const Round* r) {
  (void)r;
  return mrw_limit_pose(list(r, 0), count(r), list(r, 1), count(r));
}
static int call_find_limit(const Round* r) {
  (void)r;
  (void)mrw_find_limit(list(r, 0), count(r), (uint32_t)whole(r));
  return -1;
}
static int call_follow_rotation(const Round* r) {
  (void)r;
  return mrw_follow_rotation(at(r, 0), at(r, 1), real(r), at(r, 3));
}
static int call_follow_point(const Round* r) {
  (void)r;
  return mrw_follow_point(at(r, 0), at(r, 1), real(r), at(r, 3));
}
static int call_follow_pose(const Round* r) {
  (void)r;
  return mrw_follow_pose(list(r, 0), count(r), list(r, 1), count(r), real(r), list(r, 3), count(r));
}
static int call_two_bone_init(const Round* r) {
  mrw_two_bone_init(at(r, 0));
  return -1;
}
static int call_two_bone_joints_init(const Round* r) {
  mrw_two_bone_joints_init(at(r, 0));
  return -1;
}
static int call_two_bone_limb_init(const Round* r) {
  mrw_two_bone_limb_init(at(r, 0));
  return -1;
}
static int call_aim_init(const Round* r) {
  mrw_aim_init(at(r, 0));
  return -1;
}
static int call_turn_two_bone(const Round* r) {
  (void)r;
  return mrw_turn_two_bone(at(r, 0), at(r, 1), at(r, 2));
}
static int call_turn_two_bone_x4(const Round* r) {
  (void)r;
  return mrw_turn_two_bone_x4(at(r, 0), at(r, 1), at(r, 2));
}
static int call_solve_two_bone(const Round* r) {
  (void)r;
  return mrw_solve_two_bone(at(r, 0), at(r, 1), at(r, 2), list(r, 3), count(r), list(r, 4), count(r), at(r, 5));
}
static int call_turn_aim(const Round* r) {
  (void)r;
  return mrw_turn_aim(at(r, 0), at(r, 1), at(r, 2));
}
static int call_solve_aim(const Round* r) {
  (void)r;
  return mrw_solve_aim(at(r, 0), (uint32_t)whole(r), at(r, 2), list(r, 3), count(r), list(r, 4), count(r), at(r, 5));
}
static int call_solve_look_at(const Round* r) {
  (void)r;
  return mrw_solve_look_at(at(r, 0), list(r, 1), count(r), at(r, 2), real(r), list(r, 4), count(r), list(r, 5), count(r), at(r, 6));
}
static int call_ik_goal_init(const Round* r) {
  mrw_ik_goal_init(at(r, 0));
  return -1;
}
static int call_ik_problem_init(const Round* r) {
  mrw_ik_problem_init(at(r, 0));
  return -1;
}
static int call_ik_options_init(const Round* r) {
  mrw_ik_options_init(at(r, 0));
  return -1;
}
static int call_ik_scratch_bytes(const Round* r) {
  (void)r;
  (void)mrw_ik_scratch_bytes(at(r, 0), at(r, 1), at(r, 2));
  return -1;
}
static int call_solve_ik(const Round* r) {
  (void)r;
  return mrw_solve_ik(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), at(r, 3), at(r, 4), list(r, 5), count(r), at(r, 6));
}
static int call_solve_ik_chain(const Round* r) {
  (void)r;
  return mrw_solve_ik_chain(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), at(r, 3), at(r, 4), list(r, 5), count(r), at(r, 6));
}
static int call_solve_ik_body(const Round* r) {
  (void)r;
  return mrw_solve_ik_body(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), at(r, 3), at(r, 4), list(r, 5), count(r), at(r, 6));
}
static int call_ik_genetic_scratch_bytes(const Round* r) {
  (void)r;
  (void)mrw_ik_genetic_scratch_bytes(at(r, 0), at(r, 1));
  return -1;
}
static int call_solve_ik_genetic(const Round* r) {
  (void)r;
  return mrw_solve_ik_genetic(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), at(r, 3), at(r, 4), list(r, 5), count(r), at(r, 6));
}
static int call_foot_init(const Round* r) {
  mrw_foot_init(at(r, 0));
  return -1;
}
static int call_feet_init(const Round* r) {
  mrw_feet_init(at(r, 0));
  return -1;
}
static int call_foot_ground_init(const Round* r) {
  mrw_foot_ground_init(at(r, 0));
  return -1;
}
static int call_foot_motion_init(const Round* r) {
  mrw_foot_motion_init(at(r, 0));
  return -1;
}
static int call_feet_frame_init(const Round* r) {
  mrw_feet_frame_init(at(r, 0));
  return -1;
}
static int call_foot_sole(const Round* r) {
  (void)r;
  return mrw_foot_sole(at(r, 0), at(r, 1), list(r, 2), count(r), at(r, 3));
}
static int call_place_feet(const Round* r) {
  (void)r;
  return mrw_place_feet(at(r, 0), at(r, 1), at(r, 2), list(r, 3), count(r), list(r, 4), count(r), list(r, 5), count(r), list(r, 6), count(r));
}
static int call_springs_init(const Round* r) {
  mrw_springs_init(at(r, 0));
  return -1;
}
static int call_spring_frame_init(const Round* r) {
  mrw_spring_frame_init(at(r, 0));
  return -1;
}
static int call_springs_bytes(const Round* r) {
  (void)r;
  (void)mrw_springs_bytes(at(r, 0), list(r, 1), count(r));
  return -1;
}
static int call_make_springs(const Round* r) {
  (void)r;
  return mrw_make_springs(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), at(r, 3));
}
static int call_set_springs(const Round* r) {
  (void)r;
  return mrw_set_springs(at(r, 0), list(r, 1), count(r), at(r, 2));
}
static int call_reset_springs(const Round* r) {
  (void)r;
  (void)mrw_reset_springs(at(r, 0));
  return -1;
}
static int call_simulate_springs(const Round* r) {
  (void)r;
  return mrw_simulate_springs(at(r, 0), at(r, 1), at(r, 2), list(r, 3), count(r), list(r, 4), count(r));
}
static int call_find_weight_channels(const Round* r) {
  (void)r;
  return mrw_find_weight_channels(at(r, 0), at(r, 1), at(r, 2), at(r, 3), list(r, 4), count(r));
}
static int call_morph_weights(const Round* r) {
  (void)r;
  return mrw_morph_weights(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), list(r, 3), count(r));
}
static int call_morphed_bytes(const Round* r) {
  (void)r;
  (void)mrw_morphed_bytes(at(r, 0));
  return -1;
}
static int call_make_morphed(const Round* r) {
  (void)r;
  return mrw_make_morphed(at(r, 0), list(r, 1), count(r), at(r, 2));
}
static int call_morph(const Round* r) {
  (void)r;
  return mrw_morph(list(r, 0), count(r), at(r, 1));
}
static int call_morph_coordinates(const Round* r) {
  (void)r;
  return mrw_morph_coordinates(at(r, 0), list(r, 1), count(r));
}
static int call_find_example_channels(const Round* r) {
  (void)r;
  return mrw_find_example_channels(at(r, 0), at(r, 1), at(r, 2), at(r, 3), list(r, 4), count(r));
}
static int call_evaluate_examples(const Round* r) {
  (void)r;
  return mrw_evaluate_examples(at(r, 0), list(r, 1), count(r), list(r, 2), count(r));
}
static int call_debug_line_init(const Round* r) {
  mrw_debug_line_init(at(r, 0));
  return -1;
}
static int call_debug_lines_init(const Round* r) {
  mrw_debug_lines_init(at(r, 0));
  return -1;
}
static int call_joint_lines(const Round* r) {
  (void)r;
  return mrw_joint_lines(at(r, 0), list(r, 1), count(r), real(r), at(r, 3));
}
static int call_limit_lines(const Round* r) {
  (void)r;
  return mrw_limit_lines(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), list(r, 3), count(r), real(r), at(r, 5));
}
static int call_goal_lines(const Round* r) {
  (void)r;
  return mrw_goal_lines(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), real(r), real(r), at(r, 5));
}
static int call_spring_lines(const Round* r) {
  (void)r;
  return mrw_spring_lines(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), at(r, 3));
}
static int call_collider_lines(const Round* r) {
  (void)r;
  return mrw_collider_lines(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), at(r, 3));
}
static int call_bounds_lines(const Round* r) {
  (void)r;
  return mrw_bounds_lines(at(r, 0), at(r, 1));
}
static int call_build_palette_of_joints(const Round* r) {
  (void)r;
  return mrw_build_palette_of_joints(list(r, 0), count(r), list(r, 1), count(r), list(r, 2), count(r), list(r, 3), count(r), list(r, 4), count(r), list(r, 5), count(r));
}
static int call_build_palette(const Round* r) {
  (void)r;
  return mrw_build_palette(at(r, 0), list(r, 1), count(r), list(r, 2), count(r));
}
static int call_turns_inside_out(const Round* r) {
  (void)r;
  (void)mrw_turns_inside_out(at(r, 0));
  return -1;
}
static int call_palette_turns_inside_out(const Round* r) {
  (void)r;
  (void)mrw_palette_turns_inside_out(list(r, 0), count(r));
  return -1;
}
static int call_reach_bytes(const Round* r) {
  (void)r;
  (void)mrw_reach_bytes(at(r, 0));
  return -1;
}
static int call_make_reach(const Round* r) {
  (void)r;
  return mrw_make_reach(at(r, 0), list(r, 1), count(r), at(r, 2));
}
static int call_palette_bounds(const Round* r) {
  (void)r;
  return mrw_palette_bounds(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), at(r, 3));
}
static int call_skin_output_init(const Round* r) {
  mrw_skin_output_init(at(r, 0));
  return -1;
}
static int call_as_part_init(const Round* r) {
  mrw_as_part_init(at(r, 0));
  return -1;
}
static int call_skin_rigid(const Round* r) {
  (void)r;
  return mrw_skin_rigid(at(r, 0), list(r, 1), count(r), at(r, 2));
}
static int call_skin_ssd(const Round* r) {
  (void)r;
  return mrw_skin_ssd(at(r, 0), list(r, 1), count(r), at(r, 2));
}
static int call_as_coordinate_count(const Round* r) {
  (void)r;
  (void)mrw_as_coordinate_count(at(r, 0));
  return -1;
}
static int call_as_coordinates(const Round* r) {
  (void)r;
  return mrw_as_coordinates(at(r, 0), list(r, 1), count(r));
}
static int call_as_tangent_count(const Round* r) {
  (void)r;
  (void)mrw_as_tangent_count(at(r, 0));
  return -1;
}
static int call_as_tangent_scratch_bytes(const Round* r) {
  (void)r;
  (void)mrw_as_tangent_scratch_bytes(list(r, 0), count(r));
  return -1;
}
static int call_as_tangents(const Round* r) {
  (void)r;
  return mrw_as_tangents(list(r, 0), count(r), list(r, 1), count(r));
}
static int call_skin_as(const Round* r) {
  (void)r;
  return mrw_skin_as(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), at(r, 3), list(r, 4), count(r));
}
static int call_skin_mwe(const Round* r) {
  (void)r;
  return mrw_skin_mwe(at(r, 0), list(r, 1), count(r), at(r, 2));
}
static int call_psd_distance_count(const Round* r) {
  (void)r;
  (void)mrw_psd_distance_count(at(r, 0));
  return -1;
}
static int call_psd_distances(const Round* r) {
  (void)r;
  return mrw_psd_distances(at(r, 0), list(r, 1), count(r), list(r, 2), count(r));
}
static int call_skin_psd(const Round* r) {
  (void)r;
  return mrw_skin_psd(at(r, 0), list(r, 1), count(r), list(r, 2), count(r), at(r, 3));
}
static int call_character_options_init(const Round* r) {
  mrw_character_options_init(at(r, 0));
  return -1;
}
static int call_animation_layer_init(const Round* r) {
  mrw_animation_layer_init(at(r, 0));
  return -1;
}
static int call_animations_bytes(const Round* r) {
  (void)r;
  (void)mrw_animations_bytes(at(r, 0), at(r, 1));
  return -1;
}
static int call_make_animations(const Round* r) {
  (void)r;
  return mrw_make_animations(at(r, 0), at(r, 1), list(r, 2), count(r), at(r, 3));
}
static int call_find_animation(const Round* r) {
  (void)r;
  (void)mrw_find_animation(at(r, 0), text(r));
  return -1;
}
static int call_character_bytes(const Round* r) {
  (void)r;
  (void)mrw_character_bytes(at(r, 0), at(r, 1));
  return -1;
}
static int call_make_character(const Round* r) {
  (void)r;
  return mrw_make_character(at(r, 0), at(r, 1), list(r, 2), count(r), at(r, 3));
}
static int call_sample_character(const Round* r) {
  (void)r;
  return mrw_sample_character(at(r, 0), list(r, 1), count(r));
}
static int call_character_to_model(const Round* r) {
  (void)r;
  return mrw_character_to_model(at(r, 0));
}
static int call_pose_character(const Round* r) {
  (void)r;
  return mrw_pose_character(at(r, 0), list(r, 1), count(r));
}
static int call_add_expression(const Round* r) {
  (void)r;
  return mrw_add_expression(at(r, 0), at(r, 1));
}
static int call_finish_character(const Round* r) {
  (void)r;
  return mrw_finish_character(at(r, 0));
}
static int call_outfit_bytes(const Round* r) {
  (void)r;
  (void)mrw_outfit_bytes(at(r, 0));
  return -1;
}
static int call_make_outfit(const Round* r) {
  (void)r;
  return mrw_make_outfit(at(r, 0), at(r, 1), list(r, 2), count(r), at(r, 3));
}
static int call_character_follow_body(const Round* r) {
  (void)r;
  return mrw_character_follow_body(at(r, 0), at(r, 1), at(r, 2));
}

static const Row rows[] = {
    {"mrw_data_error_init", call_data_error_init, 0, 0},
    {"mrw_status_text", call_status_text, 0, 0},
    {"mrw_get_call_error_handler", call_get_call_error_handler, 0, 0},
    {"mrw_block_bytes", call_block_bytes, 0, 0},
    {"mrw_is_on_boundary", call_is_on_boundary, 0, 0},
    {"mrw_block_in", call_block_in, 0, 1},
    {"mrw_bytes_init", call_bytes_init, 0, 0},
    {"mrw_is_packed", call_is_packed, 0, 1},
    {"mrw_find_unpack_sizes", call_find_unpack_sizes, 1, 1},
    {"mrw_unpack", call_unpack, 1, 1},
    {"mrw_unpacking_init", call_unpacking_init, 0, 0},
    {"mrw_begin_unpack", call_begin_unpack, 1, 1},
    {"mrw_unpack_step", call_unpack_step, 1, 0},
    {"mrw_joint_transform_init", call_joint_transform_init, 0, 0},
    {"mrw_soa_count", call_soa_count, 0, 0},
    {"mrw_get_joint", call_get_joint, 1, 1},
    {"mrw_set_joint", call_set_joint, 1, 1},
    {"mrw_rate_limit_init", call_rate_limit_init, 0, 0},
    {"mrw_joint_limit_init", call_joint_limit_init, 0, 0},
    {"mrw_spring_joint_init", call_spring_joint_init, 0, 0},
    {"mrw_spring_chain_init", call_spring_chain_init, 0, 0},
    {"mrw_spring_collider_init", call_spring_collider_init, 0, 0},
    {"mrw_helper_init", call_helper_init, 0, 0},
    {"mrw_is_valid", call_is_valid, 1, 0},
    {"mrw_file_init", call_file_init, 0, 0},
    {"mrw_load", call_load, 1, 1},
    {"mrw_file_skeleton_count", call_file_skeleton_count, 1, 0},
    {"mrw_file_reference_count", call_file_reference_count, 1, 0},
    {"mrw_file_clip_count", call_file_clip_count, 1, 0},
    {"mrw_file_mesh_count", call_file_mesh_count, 1, 0},
    {"mrw_file_material_count", call_file_material_count, 1, 0},
    {"mrw_file_image_count", call_file_image_count, 1, 0},
    {"mrw_file_node_count", call_file_node_count, 1, 0},
    {"mrw_file_skeleton", call_file_skeleton, 1, 0},
    {"mrw_file_reference", call_file_reference, 1, 0},
    {"mrw_file_clip", call_file_clip, 1, 0},
    {"mrw_file_mesh", call_file_mesh, 1, 0},
    {"mrw_file_material", call_file_material, 1, 0},
    {"mrw_file_image", call_file_image, 1, 0},
    {"mrw_file_node", call_file_node, 1, 0},
    {"mrw_file_bounds", call_file_bounds, 1, 0},
    {"mrw_file_spring_count", call_file_spring_count, 1, 0},
    {"mrw_file_spring", call_file_spring, 1, 0},
    {"mrw_file_spring_colliders", call_file_spring_colliders, 1, 0},
    {"mrw_file_example_space_count", call_file_example_space_count, 1, 0},
    {"mrw_file_example_space", call_file_example_space, 1, 0},
    {"mrw_file_find_skeleton", call_file_find_skeleton, 1, 0},
    {"mrw_file_find_joint", call_file_find_joint, 1, 0},
    {"mrw_file_find_mesh", call_file_find_mesh, 1, 0},
    {"mrw_file_find_clip", call_file_find_clip, 1, 0},
    {"mrw_file_find_clip_of", call_file_find_clip_of, 1, 0},
    {"mrw_file_find_channel", call_file_find_channel, 1, 0},
    {"mrw_file_find_node", call_file_find_node, 1, 0},
    {"mrw_file_node_property", call_file_node_property, 1, 0},
    {"mrw_file_text", call_file_text, 1, 0},
    {"mrw_property_text", call_property_text, 1, 0},
    {"mrw_skeleton_soa_size", call_skeleton_soa_size, 1, 0},
    {"mrw_mesh_palette_size", call_mesh_palette_size, 1, 0},
    {"mrw_bounds_is_empty", call_bounds_is_empty, 1, 0},
    {"mrw_skeleton_hash", call_skeleton_hash, 1, 0},
    {"mrw_bind_clips", call_bind_clips, 1, 1},
    {"mrw_bind_outfit", call_bind_outfit, 1, 1},
    {"mrw_follow_body", call_follow_body, 1, 1},
    {"mrw_playback_init", call_playback_init, 0, 0},
    {"mrw_advance", call_advance, 1, 0},
    {"mrw_clip_time", call_clip_time, 1, 0},
    {"mrw_finished", call_finished, 1, 0},
    {"mrw_sample_options_init", call_sample_options_init, 0, 0},
    {"mrw_sample", call_sample, 1, 1},
    {"mrw_sample_cache_init", call_sample_cache_init, 0, 0},
    {"mrw_sample_cache_bytes", call_sample_cache_bytes, 1, 0},
    {"mrw_sample_cached", call_sample_cached, 1, 1},
    {"mrw_sample_additive", call_sample_additive, 1, 1},
    {"mrw_sample_channels", call_sample_channels, 1, 1},
    {"mrw_curve_init", call_curve_init, 0, 0},
    {"mrw_arc_length_init", call_arc_length_init, 0, 0},
    {"mrw_cubic_bezier_ease_init", call_cubic_bezier_ease_init, 0, 0},
    {"mrw_curve_value_count", call_curve_value_count, 0, 0},
    {"mrw_check_curve", call_check_curve, 1, 0},
    {"mrw_evaluate_curve", call_evaluate_curve, 1, 1},
    {"mrw_curve_velocity", call_curve_velocity, 1, 1},
    {"mrw_natural_spline", call_natural_spline, 1, 1},
    {"mrw_clamped_spline", call_clamped_spline, 1, 1},
    {"mrw_bezier", call_bezier, 0, 1},
    {"mrw_bezier_rotation", call_bezier_rotation, 0, 1},
    {"mrw_bicubic_patch", call_bicubic_patch, 0, 1},
    {"mrw_arc_length_count", call_arc_length_count, 0, 0},
    {"mrw_build_arc_length", call_build_arc_length, 1, 1},
    {"mrw_time_at_distance", call_time_at_distance, 1, 0},
    {"mrw_ease", call_ease, 0, 0},
    {"mrw_ease_by_curve", call_ease_by_curve, 1, 0},
    {"mrw_blend_layer_init", call_blend_layer_init, 0, 0},
    {"mrw_additive_layer_init", call_additive_layer_init, 0, 0},
    {"mrw_blend", call_blend, 1, 1},
    {"mrw_overlay", call_overlay, 1, 1},
    {"mrw_make_additive", call_make_additive, 1, 1},
    {"mrw_add", call_add, 1, 1},
    {"mrw_inertia_init", call_inertia_init, 0, 0},
    {"mrw_inertial_start_init", call_inertial_start_init, 0, 0},
    {"mrw_fade_weight", call_fade_weight, 0, 0},
    {"mrw_cross_fade", call_cross_fade, 1, 1},
    {"mrw_begin_inertia", call_begin_inertia, 1, 0},
    {"mrw_apply_inertia", call_apply_inertia, 1, 1},
    {"mrw_local_to_model", call_local_to_model, 1, 1},
    {"mrw_local_to_model_first", call_local_to_model_first, 1, 1},
    {"mrw_local_to_model_below", call_local_to_model_below, 1, 1},
    {"mrw_limit_description_init", call_limit_description_init, 0, 0},
    {"mrw_rotation_follower_init", call_rotation_follower_init, 0, 0},
    {"mrw_point_follower_init", call_point_follower_init, 0, 0},
    {"mrw_make_angle_range", call_make_angle_range, 0, 0},
    {"mrw_make_limit", call_make_limit, 1, 0},
    {"mrw_clamp_rotation", call_clamp_rotation, 1, 0},
    {"mrw_limit_excess", call_limit_excess, 1, 0},
    {"mrw_limit_pose", call_limit_pose, 0, 1},
    {"mrw_find_limit", call_find_limit, 0, 1},
    {"mrw_follow_rotation", call_follow_rotation, 1, 0},
    {"mrw_follow_point", call_follow_point, 1, 0},
    {"mrw_follow_pose", call_follow_pose, 0, 1},
    {"mrw_two_bone_init", call_two_bone_init, 0, 0},
    {"mrw_two_bone_joints_init", call_two_bone_joints_init, 0, 0},
    {"mrw_two_bone_limb_init", call_two_bone_limb_init, 0, 0},
    {"mrw_aim_init", call_aim_init, 0, 0},
    {"mrw_turn_two_bone", call_turn_two_bone, 1, 0},
    {"mrw_turn_two_bone_x4", call_turn_two_bone_x4, 1, 0},
    {"mrw_solve_two_bone", call_solve_two_bone, 1, 1},
    {"mrw_turn_aim", call_turn_aim, 1, 0},
    {"mrw_solve_aim", call_solve_aim, 1, 1},
    {"mrw_solve_look_at", call_solve_look_at, 1, 1},
    {"mrw_ik_goal_init", call_ik_goal_init, 0, 0},
    {"mrw_ik_problem_init", call_ik_problem_init, 0, 0},
    {"mrw_ik_options_init", call_ik_options_init, 0, 0},
    {"mrw_ik_scratch_bytes", call_ik_scratch_bytes, 1, 0},
    {"mrw_solve_ik", call_solve_ik, 1, 1},
    {"mrw_solve_ik_chain", call_solve_ik_chain, 1, 1},
    {"mrw_solve_ik_body", call_solve_ik_body, 1, 1},
    {"mrw_ik_genetic_scratch_bytes", call_ik_genetic_scratch_bytes, 1, 0},
    {"mrw_solve_ik_genetic", call_solve_ik_genetic, 1, 1},
    {"mrw_foot_init", call_foot_init, 0, 0},
    {"mrw_feet_init", call_feet_init, 0, 0},
    {"mrw_foot_ground_init", call_foot_ground_init, 0, 0},
    {"mrw_foot_motion_init", call_foot_motion_init, 0, 0},
    {"mrw_feet_frame_init", call_feet_frame_init, 0, 0},
    {"mrw_foot_sole", call_foot_sole, 1, 1},
    {"mrw_place_feet", call_place_feet, 1, 1},
    {"mrw_springs_init", call_springs_init, 0, 0},
    {"mrw_spring_frame_init", call_spring_frame_init, 0, 0},
    {"mrw_springs_bytes", call_springs_bytes, 1, 1},
    {"mrw_make_springs", call_make_springs, 1, 1},
    {"mrw_set_springs", call_set_springs, 1, 1},
    {"mrw_reset_springs", call_reset_springs, 1, 0},
    {"mrw_simulate_springs", call_simulate_springs, 1, 1},
    {"mrw_find_weight_channels", call_find_weight_channels, 1, 1},
    {"mrw_morph_weights", call_morph_weights, 1, 1},
    {"mrw_morphed_bytes", call_morphed_bytes, 1, 0},
    {"mrw_make_morphed", call_make_morphed, 1, 1},
    {"mrw_morph", call_morph, 1, 1},
    {"mrw_morph_coordinates", call_morph_coordinates, 1, 1},
    {"mrw_find_example_channels", call_find_example_channels, 1, 1},
    {"mrw_evaluate_examples", call_evaluate_examples, 1, 1},
    {"mrw_debug_line_init", call_debug_line_init, 0, 0},
    {"mrw_debug_lines_init", call_debug_lines_init, 0, 0},
    {"mrw_joint_lines", call_joint_lines, 1, 1},
    {"mrw_limit_lines", call_limit_lines, 1, 1},
    {"mrw_goal_lines", call_goal_lines, 1, 1},
    {"mrw_spring_lines", call_spring_lines, 1, 1},
    {"mrw_collider_lines", call_collider_lines, 1, 1},
    {"mrw_bounds_lines", call_bounds_lines, 1, 0},
    {"mrw_build_palette_of_joints", call_build_palette_of_joints, 0, 1},
    {"mrw_build_palette", call_build_palette, 1, 1},
    {"mrw_turns_inside_out", call_turns_inside_out, 1, 0},
    {"mrw_palette_turns_inside_out", call_palette_turns_inside_out, 0, 1},
    {"mrw_reach_bytes", call_reach_bytes, 1, 0},
    {"mrw_make_reach", call_make_reach, 1, 1},
    {"mrw_palette_bounds", call_palette_bounds, 1, 1},
    {"mrw_skin_output_init", call_skin_output_init, 0, 0},
    {"mrw_as_part_init", call_as_part_init, 0, 0},
    {"mrw_skin_rigid", call_skin_rigid, 1, 1},
    {"mrw_skin_ssd", call_skin_ssd, 1, 1},
    {"mrw_as_coordinate_count", call_as_coordinate_count, 1, 0},
    {"mrw_as_coordinates", call_as_coordinates, 1, 1},
    {"mrw_as_tangent_count", call_as_tangent_count, 1, 0},
    {"mrw_as_tangent_scratch_bytes", call_as_tangent_scratch_bytes, 0, 1},
    {"mrw_as_tangents", call_as_tangents, 0, 1},
    {"mrw_skin_as", call_skin_as, 1, 1},
    {"mrw_skin_mwe", call_skin_mwe, 1, 1},
    {"mrw_psd_distance_count", call_psd_distance_count, 1, 0},
    {"mrw_psd_distances", call_psd_distances, 1, 1},
    {"mrw_skin_psd", call_skin_psd, 1, 1},
    {"mrw_character_options_init", call_character_options_init, 0, 0},
    {"mrw_animation_layer_init", call_animation_layer_init, 0, 0},
    {"mrw_animations_bytes", call_animations_bytes, 1, 0},
    {"mrw_make_animations", call_make_animations, 1, 1},
    {"mrw_find_animation", call_find_animation, 1, 0},
    {"mrw_character_bytes", call_character_bytes, 1, 0},
    {"mrw_make_character", call_make_character, 1, 1},
    {"mrw_sample_character", call_sample_character, 1, 1},
    {"mrw_character_to_model", call_character_to_model, 1, 0},
    {"mrw_pose_character", call_pose_character, 1, 1},
    {"mrw_add_expression", call_add_expression, 1, 0},
    {"mrw_finish_character", call_finish_character, 1, 0},
    {"mrw_outfit_bytes", call_outfit_bytes, 1, 0},
    {"mrw_make_outfit", call_make_outfit, 1, 1},
    {"mrw_character_follow_body", call_character_follow_body, 1, 0},
};
