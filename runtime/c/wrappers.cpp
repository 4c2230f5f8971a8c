// Made by tools/c_api from the descriptions in runtime/c: one line of C++ a function. Do not edit.
#include "c/twin.h"

#include "marrow/animator.h"
#include "marrow/blend.h"
#include "marrow/blend_space.h"
#include "marrow/block.h"
#include "marrow/bounds.h"
#include "marrow/call_error.h"
#include "marrow/character.h"
#include "marrow/clip_motion.h"
#include "marrow/clip_pack.h"
#include "marrow/curve.h"
#include "marrow/debug_lines.h"
#include "marrow/events.h"
#include "marrow/example_space.h"
#include "marrow/feet.h"
#include "marrow/file.h"
#include "marrow/ik.h"
#include "marrow/ik_solve.h"
#include "marrow/limits.h"
#include "marrow/local_to_model.h"
#include "marrow/math.h"
#include "marrow/mesh.h"
#include "marrow/morph.h"
#include "marrow/outfit.h"
#include "marrow/palette.h"
#include "marrow/phase.h"
#include "marrow/playback.h"
#include "marrow/pose.h"
#include "marrow/pose_map.h"
#include "marrow/roles.h"
#include "marrow/root_motion.h"
#include "marrow/sample.h"
#include "marrow/skeleton.h"
#include "marrow/skin.h"
#include "marrow/springs.h"
#include "marrow/status.h"
#include "marrow/transition.h"
#include "marrow/unpack.h"

// clang-format off
using namespace marrow;
using namespace marrow::c;

extern "C" {

uint32_t mrw_abi(void) {
  return MRW_ABI;
}

void mrw_data_error_init(mrw_data_error* out) {
  MRW_NEEDS(leads_to<DataError>(out), );
  to<DataError>(out) = DataError{};
}

void mrw_bytes_init(mrw_bytes* out) {
  MRW_NEEDS(leads_to<Span<const std::byte>>(out), );
  to<Span<const std::byte>>(out) = Span<const std::byte>{};
}

void mrw_unpacking_init(mrw_unpacking* out) {
  MRW_NEEDS(leads_to<Unpacking>(out), );
  to<Unpacking>(out) = Unpacking{};
}

void mrw_joint_transform_init(mrw_joint_transform* out) {
  MRW_NEEDS(leads_to<JointTransform>(out), );
  to<JointTransform>(out) = JointTransform{};
}

void mrw_rate_limit_init(mrw_rate_limit* out) {
  MRW_NEEDS(leads_to<RateLimit>(out), );
  to<RateLimit>(out) = RateLimit{};
}

void mrw_joint_limit_init(mrw_joint_limit* out) {
  MRW_NEEDS(leads_to<JointLimit>(out), );
  to<JointLimit>(out) = JointLimit{};
}

void mrw_spring_joint_init(mrw_spring_joint* out) {
  MRW_NEEDS(leads_to<SpringJoint>(out), );
  to<SpringJoint>(out) = SpringJoint{};
}

void mrw_spring_chain_init(mrw_spring_chain* out) {
  MRW_NEEDS(leads_to<SpringChain>(out), );
  to<SpringChain>(out) = SpringChain{};
}

void mrw_spring_collider_init(mrw_spring_collider* out) {
  MRW_NEEDS(leads_to<SpringCollider>(out), );
  to<SpringCollider>(out) = SpringCollider{};
}

void mrw_rig_step_init(mrw_rig_step* out) {
  MRW_NEEDS(leads_to<RigStep>(out), );
  to<RigStep>(out) = RigStep{};
}

void mrw_mapped_turn_init(mrw_mapped_turn* out) {
  MRW_NEEDS(leads_to<MappedTurn>(out), );
  to<MappedTurn>(out) = MappedTurn{};
}

void mrw_mapped_place_init(mrw_mapped_place* out) {
  MRW_NEEDS(leads_to<MappedPlace>(out), );
  to<MappedPlace>(out) = MappedPlace{};
}

void mrw_clip_event_init(mrw_clip_event* out) {
  MRW_NEEDS(leads_to<ClipEvent>(out), );
  to<ClipEvent>(out) = ClipEvent{};
}

void mrw_clip_motion_init(mrw_clip_motion* out) {
  MRW_NEEDS(leads_to<ClipMotion>(out), );
  to<ClipMotion>(out) = ClipMotion{};
}

void mrw_helper_init(mrw_helper* out) {
  MRW_NEEDS(leads_to<Helper>(out), );
  to<Helper>(out) = Helper{};
}

void mrw_plane_triangle_init(mrw_plane_triangle* out) {
  MRW_NEEDS(leads_to<PlaneTriangle>(out), );
  to<PlaneTriangle>(out) = PlaneTriangle{};
}

void mrw_file_init(mrw_file* out) {
  MRW_NEEDS(leads_to<File>(out), );
  to<File>(out) = File{};
}

void mrw_playback_init(mrw_playback* out) {
  MRW_NEEDS(leads_to<Playback>(out), );
  to<Playback>(out) = Playback{};
}

void mrw_event_hit_init(mrw_event_hit* out) {
  MRW_NEEDS(leads_to<EventHit>(out), );
  to<EventHit>(out) = EventHit{};
}

void mrw_rigid_step_init(mrw_rigid_step* out) {
  MRW_NEEDS(leads_to<RigidStep>(out), );
  to<RigidStep>(out) = RigidStep{};
}

void mrw_root_place_init(mrw_root_place* out) {
  MRW_NEEDS(leads_to<RootPlace>(out), );
  to<RootPlace>(out) = RootPlace{};
}

void mrw_phase_init(mrw_phase* out) {
  MRW_NEEDS(leads_to<Phase>(out), );
  to<Phase>(out) = Phase{};
}

void mrw_phase_clip_init(mrw_phase_clip* out) {
  MRW_NEEDS(leads_to<PhaseClip>(out), );
  to<PhaseClip>(out) = PhaseClip{};
}

void mrw_plane_point_init(mrw_plane_point* out) {
  MRW_NEEDS(leads_to<PlanePoint>(out), );
  to<PlanePoint>(out) = PlanePoint{};
}

void mrw_speed_point_init(mrw_speed_point* out) {
  MRW_NEEDS(leads_to<SpeedPoint>(out), );
  to<SpeedPoint>(out) = SpeedPoint{};
}

void mrw_sample_options_init(mrw_sample_options* out) {
  MRW_NEEDS(leads_to<SampleOptions>(out), );
  to<SampleOptions>(out) = SampleOptions{};
}

void mrw_sample_cache_init(mrw_sample_cache* out) {
  MRW_NEEDS(leads_to<SampleCache>(out), );
  to<SampleCache>(out) = SampleCache{};
}

void mrw_curve_init(mrw_curve* out) {
  MRW_NEEDS(leads_to<Curve>(out), );
  to<Curve>(out) = Curve{};
}

void mrw_arc_length_init(mrw_arc_length* out) {
  MRW_NEEDS(leads_to<ArcLength>(out), );
  to<ArcLength>(out) = ArcLength{};
}

void mrw_cubic_bezier_ease_init(mrw_cubic_bezier_ease* out) {
  MRW_NEEDS(leads_to<CubicBezierEase>(out), );
  to<CubicBezierEase>(out) = CubicBezierEase{};
}

void mrw_blend_layer_init(mrw_blend_layer* out) {
  MRW_NEEDS(leads_to<BlendLayer>(out), );
  to<BlendLayer>(out) = BlendLayer{};
}

void mrw_additive_layer_init(mrw_additive_layer* out) {
  MRW_NEEDS(leads_to<AdditiveLayer>(out), );
  to<AdditiveLayer>(out) = AdditiveLayer{};
}

void mrw_inertia_init(mrw_inertia* out) {
  MRW_NEEDS(leads_to<Inertia>(out), );
  to<Inertia>(out) = Inertia{};
}

void mrw_inertial_start_init(mrw_inertial_start* out) {
  MRW_NEEDS(leads_to<InertialStart>(out), );
  to<InertialStart>(out) = InertialStart{};
}

void mrw_pose_init(mrw_pose* out) {
  MRW_NEEDS(leads_to<Pose>(out), );
  to<Pose>(out) = Pose{};
}

void mrw_limit_description_init(mrw_limit_description* out) {
  MRW_NEEDS(leads_to<LimitDescription>(out), );
  to<LimitDescription>(out) = LimitDescription{};
}

void mrw_rotation_follower_init(mrw_rotation_follower* out) {
  MRW_NEEDS(leads_to<RotationFollower>(out), );
  to<RotationFollower>(out) = RotationFollower{};
}

void mrw_point_follower_init(mrw_point_follower* out) {
  MRW_NEEDS(leads_to<PointFollower>(out), );
  to<PointFollower>(out) = PointFollower{};
}

void mrw_two_bone_init(mrw_two_bone* out) {
  MRW_NEEDS(leads_to<TwoBone>(out), );
  to<TwoBone>(out) = TwoBone{};
}

void mrw_two_bone_joints_init(mrw_two_bone_joints* out) {
  MRW_NEEDS(leads_to<TwoBoneJoints>(out), );
  to<TwoBoneJoints>(out) = TwoBoneJoints{};
}

void mrw_two_bone_limb_init(mrw_two_bone_limb* out) {
  MRW_NEEDS(leads_to<TwoBoneLimb>(out), );
  to<TwoBoneLimb>(out) = TwoBoneLimb{};
}

void mrw_aim_init(mrw_aim* out) {
  MRW_NEEDS(leads_to<Aim>(out), );
  to<Aim>(out) = Aim{};
}

void mrw_ik_goal_init(mrw_ik_goal* out) {
  MRW_NEEDS(leads_to<IkGoal>(out), );
  to<IkGoal>(out) = IkGoal{};
}

void mrw_ik_problem_init(mrw_ik_problem* out) {
  MRW_NEEDS(leads_to<IkProblem>(out), );
  to<IkProblem>(out) = IkProblem{};
}

void mrw_ik_options_init(mrw_ik_options* out) {
  MRW_NEEDS(leads_to<IkOptions>(out), );
  to<IkOptions>(out) = IkOptions{};
}

void mrw_foot_init(mrw_foot* out) {
  MRW_NEEDS(leads_to<Foot>(out), );
  to<Foot>(out) = Foot{};
}

void mrw_feet_init(mrw_feet* out) {
  MRW_NEEDS(leads_to<Feet>(out), );
  to<Feet>(out) = Feet{};
}

void mrw_foot_ground_init(mrw_foot_ground* out) {
  MRW_NEEDS(leads_to<FootGround>(out), );
  to<FootGround>(out) = FootGround{};
}

void mrw_foot_motion_init(mrw_foot_motion* out) {
  MRW_NEEDS(leads_to<FootMotion>(out), );
  to<FootMotion>(out) = FootMotion{};
}

void mrw_feet_frame_init(mrw_feet_frame* out) {
  MRW_NEEDS(leads_to<FeetFrame>(out), );
  to<FeetFrame>(out) = FeetFrame{};
}

void mrw_springs_init(mrw_springs* out) {
  MRW_NEEDS(leads_to<Springs>(out), );
  to<Springs>(out) = Springs{};
}

void mrw_spring_frame_init(mrw_spring_frame* out) {
  MRW_NEEDS(leads_to<SpringFrame>(out), );
  to<SpringFrame>(out) = SpringFrame{};
}

void mrw_debug_line_init(mrw_debug_line* out) {
  MRW_NEEDS(leads_to<DebugLine>(out), );
  to<DebugLine>(out) = DebugLine{};
}

void mrw_debug_lines_init(mrw_debug_lines* out) {
  MRW_NEEDS(leads_to<DebugLines>(out), );
  to<DebugLines>(out) = DebugLines{};
}

void mrw_skin_output_init(mrw_skin_output* out) {
  MRW_NEEDS(leads_to<SkinOutput>(out), );
  to<SkinOutput>(out) = SkinOutput{};
}

void mrw_as_part_init(mrw_as_part* out) {
  MRW_NEEDS(leads_to<AsPart>(out), );
  to<AsPart>(out) = AsPart{};
}

void mrw_character_options_init(mrw_character_options* out) {
  MRW_NEEDS(leads_to<CharacterOptions>(out), );
  to<CharacterOptions>(out) = CharacterOptions{};
}

void mrw_animation_layer_init(mrw_animation_layer* out) {
  MRW_NEEDS(leads_to<AnimationLayer>(out), );
  to<AnimationLayer>(out) = AnimationLayer{};
}

void mrw_animator_step_init(mrw_animator_step* out) {
  MRW_NEEDS(leads_to<AnimatorStep>(out), );
  to<AnimatorStep>(out) = AnimatorStep{};
}

void mrw_animator_options_init(mrw_animator_options* out) {
  MRW_NEEDS(leads_to<AnimatorOptions>(out), );
  to<AnimatorOptions>(out) = AnimatorOptions{};
}

const char* mrw_status_text(mrw_status status) {
  return marrow::to_string(static_cast<Status>(status));
}

mrw_call_error_handler mrw_set_call_error_handler(mrw_call_error_handler handler) {
  return marrow::set_call_error_handler(handler);
}

mrw_call_error_handler mrw_get_call_error_handler(void) {
  return marrow::call_error_handler();
}

size_t mrw_block_bytes(size_t bytes) {
  return marrow::block_bytes(bytes);
}

bool mrw_is_on_boundary(const void* first) {
  return marrow::is_on_boundary(first);
}

mrw_status mrw_block_in(void* memory, size_t memory_bytes, mrw_block* out) {
  MRW_NEEDS(is_list<std::byte>(memory, memory_bytes) && leads_to<Span<std::byte>>(out), MRW_BAD_ARGUMENT);
  give<Span<std::byte>>(out, marrow::block_in(span<std::byte>(memory, memory_bytes)));
  return MRW_OK;
}

bool mrw_is_packed(const void* bytes, size_t byte_count) {
  MRW_NEEDS(is_list<std::byte>(bytes, byte_count), false);
  return marrow::is_packed(span<const std::byte>(bytes, byte_count));
}

mrw_status mrw_find_unpack_sizes(const void* packed, size_t packed_bytes, mrw_unpack_sizes* out,
    mrw_data_error* error) {
  MRW_NEEDS(is_list<std::byte>(packed, packed_bytes) && leads_to<UnpackSizes>(out) && leads_to_if_any<DataError>(error), MRW_BAD_ARGUMENT);
  return code(marrow::unpack_sizes(span<const std::byte>(packed, packed_bytes), to<UnpackSizes>(out), static_cast<DataError*>(static_cast<void*>(error))));
}

mrw_status mrw_unpack(const void* packed, size_t packed_bytes, const mrw_mesh_decoder* decoders, size_t decoder_count,
    void* memory, size_t memory_bytes, mrw_bytes* file, mrw_data_error* error) {
  MRW_NEEDS(is_list<std::byte>(packed, packed_bytes) && is_list<MeshDecoder>(decoders, decoder_count) && is_list<std::byte>(memory, memory_bytes) && leads_to<Span<const std::byte>>(file) && leads_to_if_any<DataError>(error), MRW_BAD_ARGUMENT);
  return code(marrow::unpack(span<const std::byte>(packed, packed_bytes), span<const MeshDecoder>(decoders, decoder_count), span<std::byte>(memory, memory_bytes), to<Span<const std::byte>>(file), static_cast<DataError*>(static_cast<void*>(error))));
}

mrw_status mrw_begin_unpack(const void* packed, size_t packed_bytes, const mrw_mesh_decoder* decoders,
    size_t decoder_count, void* memory, size_t memory_bytes, mrw_unpacking* out, mrw_data_error* error) {
  MRW_NEEDS(is_list<std::byte>(packed, packed_bytes) && is_list<MeshDecoder>(decoders, decoder_count) && is_list<std::byte>(memory, memory_bytes) && leads_to<Unpacking>(out) && leads_to_if_any<DataError>(error), MRW_BAD_ARGUMENT);
  return code(marrow::begin_unpack(span<const std::byte>(packed, packed_bytes), span<const MeshDecoder>(decoders, decoder_count), span<std::byte>(memory, memory_bytes), to<Unpacking>(out), static_cast<DataError*>(static_cast<void*>(error))));
}

mrw_status mrw_unpack_step(mrw_unpacking* unpacking, mrw_data_error* error) {
  MRW_NEEDS(leads_to<Unpacking>(unpacking) && leads_to_if_any<DataError>(error), MRW_BAD_ARGUMENT);
  return code(marrow::unpack_step(to<Unpacking>(unpacking), static_cast<DataError*>(static_cast<void*>(error))));
}

size_t mrw_soa_count(size_t joint_count) {
  return marrow::soa_count(joint_count);
}

mrw_status mrw_get_joint(const mrw_soa_transform* local, size_t local_count, uint32_t joint, mrw_joint_transform* out) {
  MRW_NEEDS(is_list<SoaTransform>(local, local_count) && leads_to<JointTransform>(out), MRW_BAD_ARGUMENT);
  return code(marrow::get_joint(span<const SoaTransform>(local, local_count), joint, to<JointTransform>(out)));
}

mrw_status mrw_set_joint(mrw_soa_transform* local, size_t local_count, uint32_t joint,
    const mrw_joint_transform* transform) {
  MRW_NEEDS(is_list<SoaTransform>(local, local_count) && leads_to<JointTransform>(transform), MRW_BAD_ARGUMENT);
  return code(marrow::set_joint(span<SoaTransform>(local, local_count), joint, of<JointTransform>(transform)));
}

mrw_status mrw_affine_of(const mrw_joint_transform* transform, mrw_affine* out) {
  MRW_NEEDS(leads_to<JointTransform>(transform) && leads_to<Affine>(out), MRW_BAD_ARGUMENT);
  give<Affine>(out, marrow::affine_of(of<JointTransform>(transform)));
  return MRW_OK;
}

mrw_status mrw_compose(const mrw_affine* a, const mrw_affine* b, mrw_affine* out) {
  MRW_NEEDS(leads_to<Affine>(a) && leads_to<Affine>(b) && leads_to<Affine>(out), MRW_BAD_ARGUMENT);
  give<Affine>(out, marrow::compose(of<Affine>(a), of<Affine>(b)));
  return MRW_OK;
}

mrw_status mrw_invert(const mrw_affine* map, mrw_affine* out) {
  MRW_NEEDS(leads_to<Affine>(map) && leads_to<Affine>(out), MRW_BAD_ARGUMENT);
  return code(marrow::invert(of<Affine>(map), to<Affine>(out)));
}

void mrw_transform_point(const mrw_affine* map, const float point[3], float out[3]) {
  MRW_NEEDS(leads_to<Affine>(map) && leads_to<float>(point) && leads_to<float>(out), );
  marrow::transform_point(of<Affine>(map), array<const float, 3>(point), array<float, 3>(out));
}

void mrw_transform_direction(const mrw_affine* map, const float direction[3], float out[3]) {
  MRW_NEEDS(leads_to<Affine>(map) && leads_to<float>(direction) && leads_to<float>(out), );
  marrow::transform_direction(of<Affine>(map), array<const float, 3>(direction), array<float, 3>(out));
}

mrw_status mrw_direction_in_joint(const mrw_affine* model_from_joint, const float direction[3], float out[3]) {
  MRW_NEEDS(leads_to<Affine>(model_from_joint) && leads_to<float>(direction) && leads_to<float>(out), MRW_BAD_ARGUMENT);
  return code(marrow::direction_in_joint(of<Affine>(model_from_joint), array<const float, 3>(direction), array<float, 3>(out)));
}

bool mrw_is_valid(const mrw_joint_limit* limit) {
  MRW_NEEDS(leads_to<JointLimit>(limit), false);
  return marrow::is_valid(of<JointLimit>(limit));
}

size_t mrw_skeleton_soa_size(const mrw_skeleton* skeleton) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton), 0);
  return of<Skeleton>(skeleton).soa_size();
}

uint16_t mrw_joint_of(const mrw_roles* roles, mrw_role role) {
  MRW_NEEDS(leads_to<Roles>(roles), 0);
  return marrow::joint_of(of<Roles>(roles), static_cast<Role>(role));
}

mrw_role mrw_role_of(const mrw_roles* roles, uint32_t joint) {
  MRW_NEEDS(leads_to<Roles>(roles), 0);
  return static_cast<mrw_role>(marrow::role_of(of<Roles>(roles), joint));
}

uint16_t mrw_mirror_of(const mrw_roles* roles, uint32_t joint) {
  MRW_NEEDS(leads_to<Roles>(roles), 0);
  return marrow::mirror_of(of<Roles>(roles), joint);
}

const mrw_joint_sole* mrw_sole_of(const mrw_roles* roles, uint32_t joint) {
  MRW_NEEDS(leads_to<Roles>(roles), nullptr);
  return to_c<const mrw_joint_sole>(marrow::sole_of(of<Roles>(roles), joint));
}

const char* mrw_role_name(mrw_role role) {
  return marrow::role_name(static_cast<Role>(role));
}

mrw_role mrw_find_role(const char* name) {
  return static_cast<mrw_role>(marrow::find_role(name));
}

mrw_status mrw_retarget_pose(const mrw_pose_map* map, const mrw_soa_transform* rig, size_t rig_count,
    const mrw_skeleton* skeleton, mrw_soa_transform* out, size_t out_count) {
  MRW_NEEDS(leads_to<PoseMap>(map) && is_list<SoaTransform>(rig, rig_count) && leads_to<Skeleton>(skeleton) && is_list<SoaTransform>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::retarget_pose(of<PoseMap>(map), span<const SoaTransform>(rig, rig_count), of<Skeleton>(skeleton), span<SoaTransform>(out, out_count)));
}

bool mrw_clip_motion_is_valid(const mrw_clip_motion* motion) {
  MRW_NEEDS(leads_to<ClipMotion>(motion), false);
  return marrow::is_valid(of<ClipMotion>(motion));
}

uint32_t mrw_mesh_palette_size(const mrw_mesh* mesh) {
  MRW_NEEDS(leads_to<Mesh>(mesh), 0);
  return of<Mesh>(mesh).palette_size();
}

bool mrw_bounds_is_empty(const mrw_bounds* bounds) {
  MRW_NEEDS(leads_to<Bounds>(bounds), false);
  return of<Bounds>(bounds).is_empty();
}

mrw_status mrw_load(const void* block, size_t block_bytes, mrw_file* out, mrw_data_error* error) {
  MRW_NEEDS(is_list<std::byte>(block, block_bytes) && leads_to<File>(out) && leads_to_if_any<DataError>(error), MRW_BAD_ARGUMENT);
  return code(marrow::load(span<const std::byte>(block, block_bytes), to<File>(out), static_cast<DataError*>(static_cast<void*>(error))));
}

uint32_t mrw_file_skeleton_count(const mrw_file* file) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).skeleton_count();
}

uint32_t mrw_file_reference_count(const mrw_file* file) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).reference_count();
}

uint32_t mrw_file_clip_count(const mrw_file* file) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).clip_count();
}

uint32_t mrw_file_mesh_count(const mrw_file* file) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).mesh_count();
}

uint32_t mrw_file_material_count(const mrw_file* file) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).material_count();
}

uint32_t mrw_file_image_count(const mrw_file* file) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).image_count();
}

uint32_t mrw_file_node_count(const mrw_file* file) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).node_count();
}

mrw_status mrw_file_skeleton(const mrw_file* file, uint32_t index, mrw_skeleton* out) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<Skeleton>(out), MRW_BAD_ARGUMENT);
  give<Skeleton>(out, of<File>(file).skeleton(index));
  return MRW_OK;
}

mrw_status mrw_file_reference(const mrw_file* file, uint32_t index, mrw_skeleton_reference* out) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<SkeletonReference>(out), MRW_BAD_ARGUMENT);
  give<SkeletonReference>(out, of<File>(file).reference(index));
  return MRW_OK;
}

mrw_status mrw_file_clip(const mrw_file* file, uint32_t index, mrw_clip* out) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<Clip>(out), MRW_BAD_ARGUMENT);
  give<Clip>(out, of<File>(file).clip(index));
  return MRW_OK;
}

mrw_status mrw_file_mesh(const mrw_file* file, uint32_t index, uint32_t level, mrw_mesh* out) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<Mesh>(out), MRW_BAD_ARGUMENT);
  give<Mesh>(out, of<File>(file).mesh(index, level));
  return MRW_OK;
}

mrw_status mrw_file_material(const mrw_file* file, uint32_t index, mrw_material* out) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<Material>(out), MRW_BAD_ARGUMENT);
  give<Material>(out, of<File>(file).material(index));
  return MRW_OK;
}

mrw_status mrw_file_image(const mrw_file* file, uint32_t index, mrw_image* out) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<Image>(out), MRW_BAD_ARGUMENT);
  give<Image>(out, of<File>(file).image(index));
  return MRW_OK;
}

mrw_status mrw_file_node(const mrw_file* file, uint32_t index, mrw_node* out) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<Node>(out), MRW_BAD_ARGUMENT);
  give<Node>(out, of<File>(file).node(index));
  return MRW_OK;
}

mrw_status mrw_file_bounds(const mrw_file* file, uint32_t clip, uint32_t mesh, mrw_bounds* out) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<Bounds>(out), MRW_BAD_ARGUMENT);
  give<Bounds>(out, of<File>(file).bounds(clip, mesh));
  return MRW_OK;
}

uint32_t mrw_file_spring_count(const mrw_file* file, uint32_t skeleton) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).spring_count(skeleton);
}

mrw_status mrw_file_spring(const mrw_file* file, uint32_t skeleton, uint32_t index, mrw_spring_chain* out) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<SpringChain>(out), MRW_BAD_ARGUMENT);
  give<SpringChain>(out, of<File>(file).spring(skeleton, index));
  return MRW_OK;
}

mrw_status mrw_file_spring_colliders(const mrw_file* file, uint32_t skeleton, mrw_spring_collider_list* out) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<Span<const SpringCollider>>(out), MRW_BAD_ARGUMENT);
  give<Span<const SpringCollider>>(out, of<File>(file).spring_colliders(skeleton));
  return MRW_OK;
}

mrw_status mrw_file_roles(const mrw_file* file, uint32_t skeleton, mrw_roles* out) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<Roles>(out), MRW_BAD_ARGUMENT);
  give<Roles>(out, of<File>(file).roles(skeleton));
  return MRW_OK;
}

mrw_status mrw_file_motion(const mrw_file* file, uint32_t clip, mrw_clip_motion* out) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<ClipMotion>(out), MRW_BAD_ARGUMENT);
  give<ClipMotion>(out, of<File>(file).motion(clip));
  return MRW_OK;
}

uint32_t mrw_file_pose_map_count(const mrw_file* file) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).pose_map_count();
}

mrw_status mrw_file_pose_map(const mrw_file* file, uint32_t index, mrw_pose_map* out) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<PoseMap>(out), MRW_BAD_ARGUMENT);
  give<PoseMap>(out, of<File>(file).pose_map(index));
  return MRW_OK;
}

uint32_t mrw_file_example_space_count(const mrw_file* file) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).example_space_count();
}

mrw_status mrw_file_example_space(const mrw_file* file, uint32_t index, mrw_example_space* out, mrw_data_error* error) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<ExampleSpace>(out) && leads_to_if_any<DataError>(error), MRW_BAD_ARGUMENT);
  return code(of<File>(file).example_space(index, to<ExampleSpace>(out), static_cast<DataError*>(static_cast<void*>(error))));
}

uint32_t mrw_file_graph_count(const mrw_file* file) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).graph_count();
}

mrw_status mrw_file_graph(const mrw_file* file, uint32_t index, mrw_graph* out, mrw_data_error* error) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<Graph>(out) && leads_to_if_any<DataError>(error), MRW_BAD_ARGUMENT);
  return code(of<File>(file).graph(index, to<Graph>(out), static_cast<DataError*>(static_cast<void*>(error))));
}

uint32_t mrw_file_find_skeleton(const mrw_file* file, const char* name) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).find_skeleton(name);
}

uint32_t mrw_file_find_joint(const mrw_file* file, const mrw_skeleton* skeleton, const char* name) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<Skeleton>(skeleton), 0);
  return of<File>(file).find_joint(of<Skeleton>(skeleton), name);
}

uint32_t mrw_file_find_mesh(const mrw_file* file, const char* name) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).find_mesh(name);
}

uint32_t mrw_file_find_clip(const mrw_file* file, const char* name) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).find_clip(name);
}

uint32_t mrw_file_find_clip_of(const mrw_file* file, const char* name, uint32_t skeleton) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).find_clip(name, skeleton);
}

uint32_t mrw_file_find_channel(const mrw_file* file, const mrw_clip* clip, const char* name) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<Clip>(clip), 0);
  return of<File>(file).find_channel(of<Clip>(clip), name);
}

uint32_t mrw_file_find_event(const mrw_file* file, const mrw_clip_motion* motion, const char* name) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<ClipMotion>(motion), 0);
  return of<File>(file).find_event(of<ClipMotion>(motion), name);
}

uint32_t mrw_file_find_pose_map(const mrw_file* file, const char* name) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).find_pose_map(name);
}

uint32_t mrw_file_find_node(const mrw_file* file, const char* name) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return of<File>(file).find_node(name);
}

const mrw_property* mrw_file_node_property(const mrw_file* file, const mrw_node* node, const char* name) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<Node>(node), nullptr);
  return to_c<const mrw_property>(of<File>(file).node_property(of<Node>(node), name));
}

const char* mrw_file_text(const mrw_file* file, uint32_t name) {
  MRW_NEEDS(leads_to<File>(file), "");
  return of<File>(file).text(name);
}

uint32_t mrw_property_text(const mrw_property* property) {
  MRW_NEEDS(leads_to<Property>(property), 0);
  return of<Property>(property).text;
}

uint64_t mrw_skeleton_hash(const mrw_file* file, uint32_t skeleton) {
  MRW_NEEDS(leads_to<File>(file), 0);
  return marrow::skeleton_hash(of<File>(file), skeleton);
}

mrw_status mrw_bind_clips(const mrw_file* pack, uint32_t reference, const mrw_file* character, uint32_t skeleton,
    mrw_joint_misfit* misfits, size_t misfit_count, size_t* misfits_there) {
  MRW_NEEDS(leads_to<File>(pack) && leads_to<File>(character) && is_list<JointMisfit>(misfits, misfit_count) && leads_to_if_any<std::size_t>(misfits_there), MRW_BAD_ARGUMENT);
  return code(marrow::bind_clips(of<File>(pack), reference, of<File>(character), skeleton, span<JointMisfit>(misfits, misfit_count), misfits_there));
}

mrw_status mrw_bind_outfit(const mrw_file* outfit, uint32_t skeleton, const mrw_file* body, uint32_t body_skeleton,
    uint16_t* body_joints, size_t body_joint_count, mrw_joint_misfit* misfits, size_t misfit_count,
    size_t* misfits_there) {
  MRW_NEEDS(leads_to<File>(outfit) && leads_to<File>(body) && is_list<std::uint16_t>(body_joints, body_joint_count) && is_list<JointMisfit>(misfits, misfit_count) && leads_to_if_any<std::size_t>(misfits_there), MRW_BAD_ARGUMENT);
  return code(marrow::bind_outfit(of<File>(outfit), skeleton, of<File>(body), body_skeleton, span<std::uint16_t>(body_joints, body_joint_count), span<JointMisfit>(misfits, misfit_count), misfits_there));
}

mrw_status mrw_follow_body(const mrw_skeleton* skeleton, const uint16_t* body_joints, size_t body_joint_count,
    const mrw_affine* body_model_from_joint, size_t body_model_from_joint_count, const mrw_soa_transform* local,
    size_t local_count, mrw_affine* model_from_joint, size_t model_from_joint_count) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<std::uint16_t>(body_joints, body_joint_count) && is_list<Affine>(body_model_from_joint, body_model_from_joint_count) && is_list<SoaTransform>(local, local_count) && is_list<Affine>(model_from_joint, model_from_joint_count), MRW_BAD_ARGUMENT);
  return code(marrow::follow_body(of<Skeleton>(skeleton), span<const std::uint16_t>(body_joints, body_joint_count), span<const Affine>(body_model_from_joint, body_model_from_joint_count), span<const SoaTransform>(local, local_count), span<Affine>(model_from_joint, model_from_joint_count)));
}

mrw_status mrw_advance(mrw_playback* playback, float duration_s, float dt_s) {
  MRW_NEEDS(leads_to<Playback>(playback), MRW_BAD_ARGUMENT);
  return code(marrow::advance(to<Playback>(playback), duration_s, dt_s));
}

float mrw_clip_time(const mrw_playback* playback) {
  MRW_NEEDS(leads_to<Playback>(playback), 0);
  return marrow::clip_time(of<Playback>(playback));
}

bool mrw_finished(const mrw_playback* playback, float duration_s) {
  MRW_NEEDS(leads_to<Playback>(playback), false);
  return marrow::finished(of<Playback>(playback), duration_s);
}

mrw_status mrw_events_between(const mrw_clip_motion* motion, const mrw_playback* before, const mrw_playback* after,
    bool first, mrw_event_hit* out, size_t out_count, size_t* met) {
  MRW_NEEDS(leads_to<ClipMotion>(motion) && leads_to<Playback>(before) && leads_to<Playback>(after) && is_list<EventHit>(out, out_count) && leads_to<std::size_t>(met), MRW_BAD_ARGUMENT);
  return code(marrow::events_between(of<ClipMotion>(motion), of<Playback>(before), of<Playback>(after), first, span<EventHit>(out, out_count), *met));
}

bool mrw_is_within(const mrw_clip_event* event, float time_s, float duration_s) {
  MRW_NEEDS(leads_to<ClipEvent>(event), false);
  return marrow::is_within(of<ClipEvent>(event), time_s, duration_s);
}

mrw_status mrw_sample_root(const mrw_clip_motion* motion, float time_s, mrw_rigid_step* out) {
  MRW_NEEDS(leads_to<ClipMotion>(motion) && leads_to<RigidStep>(out), MRW_BAD_ARGUMENT);
  return code(marrow::sample_root(of<ClipMotion>(motion), time_s, to<RigidStep>(out)));
}

mrw_status mrw_root_step(const mrw_clip_motion* motion, const mrw_playback* before, const mrw_playback* after,
    mrw_rigid_step* out) {
  MRW_NEEDS(leads_to<ClipMotion>(motion) && leads_to<Playback>(before) && leads_to<Playback>(after) && leads_to<RigidStep>(out), MRW_BAD_ARGUMENT);
  return code(marrow::root_step(of<ClipMotion>(motion), of<Playback>(before), of<Playback>(after), to<RigidStep>(out)));
}

mrw_status mrw_blend_root_steps(const mrw_rigid_step* steps, size_t step_count, const float* weights,
    size_t weight_count, mrw_rigid_step* out) {
  MRW_NEEDS(is_list<RigidStep>(steps, step_count) && is_list<float>(weights, weight_count) && leads_to<RigidStep>(out), MRW_BAD_ARGUMENT);
  return code(marrow::blend_root_steps(span<const RigidStep>(steps, step_count), span<const float>(weights, weight_count), to<RigidStep>(out)));
}

mrw_status mrw_move_root(const mrw_affine* world_from_model, const mrw_rigid_step* step, mrw_affine* out) {
  MRW_NEEDS(leads_to<Affine>(world_from_model) && leads_to<RigidStep>(step) && leads_to<Affine>(out), MRW_BAD_ARGUMENT);
  give<Affine>(out, marrow::move_root(of<Affine>(world_from_model), of<RigidStep>(step)));
  return MRW_OK;
}

mrw_status mrw_move_place(const mrw_root_place* place, const mrw_rigid_step* step, mrw_root_place* out) {
  MRW_NEEDS(leads_to<RootPlace>(place) && leads_to<RigidStep>(step) && leads_to<RootPlace>(out), MRW_BAD_ARGUMENT);
  give<RootPlace>(out, marrow::move_root(of<RootPlace>(place), of<RigidStep>(step)));
  return MRW_OK;
}

mrw_status mrw_world_from_model(const mrw_root_place* place, mrw_affine* out) {
  MRW_NEEDS(leads_to<RootPlace>(place) && leads_to<Affine>(out), MRW_BAD_ARGUMENT);
  give<Affine>(out, marrow::world_from_model(of<RootPlace>(place)));
  return MRW_OK;
}

mrw_status mrw_phase_at(const mrw_clip_motion* motion, float time_s, mrw_phase* out) {
  MRW_NEEDS(leads_to<ClipMotion>(motion) && leads_to<Phase>(out), MRW_BAD_ARGUMENT);
  return code(marrow::phase_at(of<ClipMotion>(motion), time_s, to<Phase>(out)));
}

mrw_status mrw_advance_phase(const mrw_phase_clip* clips, size_t clip_count, float dt_s, mrw_phase* phase) {
  MRW_NEEDS(is_list<PhaseClip>(clips, clip_count) && leads_to<Phase>(phase), MRW_BAD_ARGUMENT);
  return code(marrow::advance_phase(span<const PhaseClip>(clips, clip_count), dt_s, to<Phase>(phase)));
}

mrw_status mrw_follow_phase(const mrw_clip_motion* motion, const mrw_phase* before, const mrw_phase* after,
    mrw_playback* was, mrw_playback* now) {
  MRW_NEEDS(leads_to<ClipMotion>(motion) && leads_to<Phase>(before) && leads_to<Phase>(after) && leads_to<Playback>(was) && leads_to<Playback>(now), MRW_BAD_ARGUMENT);
  return code(marrow::follow_phase(of<ClipMotion>(motion), of<Phase>(before), of<Phase>(after), to<Playback>(was), to<Playback>(now)));
}

mrw_status mrw_line_weights(const float* points, size_t point_count, float at, float* weights, size_t weight_count) {
  MRW_NEEDS(is_list<float>(points, point_count) && is_list<float>(weights, weight_count), MRW_BAD_ARGUMENT);
  return code(marrow::line_weights(span<const float>(points, point_count), at, span<float>(weights, weight_count)));
}

mrw_status mrw_plane_weights(const mrw_plane_point* points, size_t point_count, const mrw_plane_triangle* triangles,
    size_t triangle_count, const mrw_plane_point* at, float* weights, size_t weight_count) {
  MRW_NEEDS(is_list<PlanePoint>(points, point_count) && is_list<PlaneTriangle>(triangles, triangle_count) && leads_to<PlanePoint>(at) && is_list<float>(weights, weight_count), MRW_BAD_ARGUMENT);
  return code(marrow::plane_weights(span<const PlanePoint>(points, point_count), span<const PlaneTriangle>(triangles, triangle_count), of<PlanePoint>(at), span<float>(weights, weight_count)));
}

mrw_status mrw_match_speed(const mrw_speed_point* points, size_t point_count, float speed_m_s, float* weights,
    size_t weight_count, float* rate) {
  MRW_NEEDS(is_list<SpeedPoint>(points, point_count) && is_list<float>(weights, weight_count) && leads_to<float>(rate), MRW_BAD_ARGUMENT);
  return code(marrow::match_speed(span<const SpeedPoint>(points, point_count), speed_m_s, span<float>(weights, weight_count), *rate));
}

mrw_status mrw_sample(const mrw_skeleton* skeleton, const mrw_clip* clip, float time_s, mrw_soa_transform* out,
    size_t out_count, const mrw_sample_options* options) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && leads_to<Clip>(clip) && is_list<SoaTransform>(out, out_count) && leads_to_if_any<SampleOptions>(options), MRW_BAD_ARGUMENT);
  return code(marrow::sample(of<Skeleton>(skeleton), of<Clip>(clip), time_s, span<SoaTransform>(out, out_count), or_default<SampleOptions>(options)));
}

size_t mrw_sample_cache_bytes(const mrw_clip* clip) {
  MRW_NEEDS(leads_to<Clip>(clip), 0);
  return marrow::sample_cache_bytes(of<Clip>(clip));
}

mrw_status mrw_sample_cached(const mrw_skeleton* skeleton, const mrw_clip* clip, float time_s, mrw_soa_transform* out,
    size_t out_count, mrw_sample_cache* cache) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && leads_to<Clip>(clip) && is_list<SoaTransform>(out, out_count) && leads_to<SampleCache>(cache), MRW_BAD_ARGUMENT);
  return code(marrow::sample_cached(of<Skeleton>(skeleton), of<Clip>(clip), time_s, span<SoaTransform>(out, out_count), to<SampleCache>(cache)));
}

mrw_status mrw_sample_additive(const mrw_skeleton* skeleton, const mrw_clip* clip, float time_s,
    mrw_additive_transform* out, size_t out_count) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && leads_to<Clip>(clip) && is_list<AdditiveTransform>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::sample_additive(of<Skeleton>(skeleton), of<Clip>(clip), time_s, span<AdditiveTransform>(out, out_count)));
}

mrw_status mrw_sample_channels(const mrw_clip* clip, float time_s, float* out, size_t out_count) {
  MRW_NEEDS(leads_to<Clip>(clip) && is_list<float>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::sample_channels(of<Clip>(clip), time_s, span<float>(out, out_count)));
}

size_t mrw_curve_value_count(mrw_curve_kind kind, uint32_t components, size_t key_count) {
  return marrow::curve_value_count(static_cast<CurveKind>(kind), components, key_count);
}

mrw_status mrw_check_curve(const mrw_curve* curve) {
  MRW_NEEDS(leads_to<Curve>(curve), MRW_BAD_ARGUMENT);
  return code(marrow::check_curve(of<Curve>(curve)));
}

mrw_status mrw_evaluate_curve(const mrw_curve* curve, float time_s, float* out, size_t out_count) {
  MRW_NEEDS(leads_to<Curve>(curve) && is_list<float>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::evaluate_curve(of<Curve>(curve), time_s, span<float>(out, out_count)));
}

mrw_status mrw_curve_velocity(const mrw_curve* curve, float time_s, float* out, size_t out_count) {
  MRW_NEEDS(leads_to<Curve>(curve) && is_list<float>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::curve_velocity(of<Curve>(curve), time_s, span<float>(out, out_count)));
}

mrw_status mrw_natural_spline(const mrw_curve* keys, float* out, size_t out_count) {
  MRW_NEEDS(leads_to<Curve>(keys) && is_list<float>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::natural_spline(of<Curve>(keys), span<float>(out, out_count)));
}

mrw_status mrw_clamped_spline(const mrw_curve* keys, const float* first_velocity, size_t first_velocity_count,
    const float* last_velocity, size_t last_velocity_count, float* out, size_t out_count) {
  MRW_NEEDS(leads_to<Curve>(keys) && is_list<float>(first_velocity, first_velocity_count) && is_list<float>(last_velocity, last_velocity_count) && is_list<float>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::clamped_spline(of<Curve>(keys), span<const float>(first_velocity, first_velocity_count), span<const float>(last_velocity, last_velocity_count), span<float>(out, out_count)));
}

mrw_status mrw_bezier(const float* points, size_t point_count, uint32_t components, float u, float* scratch,
    size_t scratch_count, float* out, size_t out_count) {
  MRW_NEEDS(is_list<float>(points, point_count) && is_list<float>(scratch, scratch_count) && is_list<float>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::bezier(span<const float>(points, point_count), components, u, span<float>(scratch, scratch_count), span<float>(out, out_count)));
}

mrw_status mrw_bezier_rotation(const float* quaternions, size_t quaternion_count, float u, float* scratch,
    size_t scratch_count, float* out, size_t out_count) {
  MRW_NEEDS(is_list<float>(quaternions, quaternion_count) && is_list<float>(scratch, scratch_count) && is_list<float>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::bezier_rotation(span<const float>(quaternions, quaternion_count), u, span<float>(scratch, scratch_count), span<float>(out, out_count)));
}

mrw_status mrw_bicubic_patch(mrw_patch_basis basis, const float* points, size_t point_count, uint32_t components,
    float u, float v, float* out, size_t out_count) {
  MRW_NEEDS(is_list<float>(points, point_count) && is_list<float>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::bicubic_patch(static_cast<PatchBasis>(basis), span<const float>(points, point_count), components, u, v, span<float>(out, out_count)));
}

size_t mrw_arc_length_count(size_t key_count, uint32_t steps) {
  return marrow::arc_length_count(key_count, steps);
}

mrw_status mrw_make_arc_length(const mrw_curve* curve, uint32_t steps, float* out, size_t out_count) {
  MRW_NEEDS(leads_to<Curve>(curve) && is_list<float>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::make_arc_length(of<Curve>(curve), steps, span<float>(out, out_count)));
}

mrw_status mrw_time_at_distance(const mrw_curve* curve, const mrw_arc_length* table, float distance, float* time_s) {
  MRW_NEEDS(leads_to<Curve>(curve) && leads_to<ArcLength>(table) && leads_to<float>(time_s), MRW_BAD_ARGUMENT);
  return code(marrow::time_at_distance(of<Curve>(curve), of<ArcLength>(table), distance, *time_s));
}

float mrw_ease(mrw_easing easing, mrw_ease_mode mode, float u) {
  return marrow::ease(static_cast<Easing>(easing), static_cast<EaseMode>(mode), u);
}

mrw_status mrw_ease_by_curve(const mrw_cubic_bezier_ease* curve, float u, float* out) {
  MRW_NEEDS(leads_to<CubicBezierEase>(curve) && leads_to<float>(out), MRW_BAD_ARGUMENT);
  return code(marrow::ease(of<CubicBezierEase>(curve), u, *out));
}

mrw_status mrw_blend(const mrw_skeleton* skeleton, const mrw_blend_layer* layers, size_t layer_count,
    mrw_soa_transform* out, size_t out_count, float threshold) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<BlendLayer>(layers, layer_count) && is_list<SoaTransform>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::blend(of<Skeleton>(skeleton), span<const BlendLayer>(layers, layer_count), span<SoaTransform>(out, out_count), threshold));
}

mrw_status mrw_overlay(const mrw_skeleton* skeleton, const mrw_blend_layer* layer, mrw_soa_transform* pose,
    size_t pose_count) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && leads_to<BlendLayer>(layer) && is_list<SoaTransform>(pose, pose_count), MRW_BAD_ARGUMENT);
  return code(marrow::overlay(of<Skeleton>(skeleton), of<BlendLayer>(layer), span<SoaTransform>(pose, pose_count)));
}

mrw_status mrw_overlay_in_model_space(const mrw_skeleton* skeleton, const mrw_blend_layer* layer,
    mrw_soa_transform* pose, size_t pose_count, mrw_affine* scratch, size_t scratch_count) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && leads_to<BlendLayer>(layer) && is_list<SoaTransform>(pose, pose_count) && is_list<Affine>(scratch, scratch_count), MRW_BAD_ARGUMENT);
  return code(marrow::overlay_in_model_space(of<Skeleton>(skeleton), of<BlendLayer>(layer), span<SoaTransform>(pose, pose_count), span<Affine>(scratch, scratch_count)));
}

mrw_status mrw_mask_below(const mrw_skeleton* skeleton, uint32_t joint, uint32_t falloff, float* mask,
    size_t mask_count) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<float>(mask, mask_count), MRW_BAD_ARGUMENT);
  return code(marrow::mask_below(of<Skeleton>(skeleton), joint, falloff, span<float>(mask, mask_count)));
}

mrw_status mrw_make_additive(const mrw_skeleton* skeleton, const mrw_soa_transform* pose, size_t pose_count,
    const mrw_soa_transform* reference, size_t reference_count, mrw_additive_transform* out, size_t out_count) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<SoaTransform>(pose, pose_count) && is_list<SoaTransform>(reference, reference_count) && is_list<AdditiveTransform>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::make_additive(of<Skeleton>(skeleton), span<const SoaTransform>(pose, pose_count), span<const SoaTransform>(reference, reference_count), span<AdditiveTransform>(out, out_count)));
}

mrw_status mrw_add(const mrw_skeleton* skeleton, const mrw_additive_layer* layer, mrw_soa_transform* pose,
    size_t pose_count) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && leads_to<AdditiveLayer>(layer) && is_list<SoaTransform>(pose, pose_count), MRW_BAD_ARGUMENT);
  return code(marrow::add(of<Skeleton>(skeleton), of<AdditiveLayer>(layer), span<SoaTransform>(pose, pose_count)));
}

float mrw_fade_weight(mrw_fade shape, float time_s, float duration_s) {
  return marrow::fade_weight(static_cast<Fade>(shape), time_s, duration_s);
}

mrw_status mrw_cross_fade(const mrw_skeleton* skeleton, const mrw_soa_transform* from, size_t from_count,
    const mrw_soa_transform* to, size_t to_count, float weight, mrw_soa_transform* out, size_t out_count) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<SoaTransform>(from, from_count) && is_list<SoaTransform>(to, to_count) && is_list<SoaTransform>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::cross_fade(of<Skeleton>(skeleton), span<const SoaTransform>(from, from_count), span<const SoaTransform>(to, to_count), weight, span<SoaTransform>(out, out_count)));
}

mrw_status mrw_begin_inertia(const mrw_skeleton* skeleton, const mrw_inertial_start* start, float duration_s,
    mrw_inertia* inertia) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && leads_to<InertialStart>(start) && leads_to<Inertia>(inertia), MRW_BAD_ARGUMENT);
  return code(marrow::begin_inertia(of<Skeleton>(skeleton), of<InertialStart>(start), duration_s, to<Inertia>(inertia)));
}

mrw_status mrw_apply_inertia(const mrw_skeleton* skeleton, const mrw_inertia* inertia, float time_s,
    mrw_soa_transform* pose, size_t pose_count) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && leads_to<Inertia>(inertia) && is_list<SoaTransform>(pose, pose_count), MRW_BAD_ARGUMENT);
  return code(marrow::apply_inertia(of<Skeleton>(skeleton), of<Inertia>(inertia), time_s, span<SoaTransform>(pose, pose_count)));
}

mrw_status mrw_local_to_model(const mrw_skeleton* skeleton, const mrw_soa_transform* local, size_t local_count,
    mrw_affine* out, size_t out_count) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<SoaTransform>(local, local_count) && is_list<Affine>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::local_to_model(of<Skeleton>(skeleton), span<const SoaTransform>(local, local_count), span<Affine>(out, out_count)));
}

mrw_status mrw_local_to_model_first(const mrw_skeleton* skeleton, const mrw_soa_transform* local, size_t local_count,
    uint32_t joint_count, mrw_affine* out, size_t out_count) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<SoaTransform>(local, local_count) && is_list<Affine>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::local_to_model_first(of<Skeleton>(skeleton), span<const SoaTransform>(local, local_count), joint_count, span<Affine>(out, out_count)));
}

mrw_status mrw_local_to_model_below(const mrw_skeleton* skeleton, const mrw_soa_transform* local, size_t local_count,
    uint32_t joint, mrw_affine* out, size_t out_count) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<SoaTransform>(local, local_count) && is_list<Affine>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::local_to_model_below(of<Skeleton>(skeleton), span<const SoaTransform>(local, local_count), joint, span<Affine>(out, out_count)));
}

mrw_status mrw_make_angle_range(float least_rad, float most_rad, mrw_angle_range* out) {
  MRW_NEEDS(leads_to<AngleRange>(out), MRW_BAD_ARGUMENT);
  give<AngleRange>(out, marrow::angle_range(least_rad, most_rad));
  return MRW_OK;
}

mrw_status mrw_make_limit(const mrw_limit_description* description, uint16_t joint, mrw_joint_limit* out) {
  MRW_NEEDS(leads_to<LimitDescription>(description) && leads_to<JointLimit>(out), MRW_BAD_ARGUMENT);
  return code(marrow::make_limit(of<LimitDescription>(description), joint, to<JointLimit>(out)));
}

mrw_status mrw_clamp_rotation(const mrw_joint_limit* limit, float local[4]) {
  MRW_NEEDS(leads_to<JointLimit>(limit) && leads_to<float>(local), MRW_BAD_ARGUMENT);
  return code(marrow::clamp_rotation(of<JointLimit>(limit), array<float, 4>(local)));
}

float mrw_limit_excess(const mrw_joint_limit* limit, const float local[4]) {
  MRW_NEEDS(leads_to<JointLimit>(limit) && leads_to<float>(local), 0);
  return marrow::limit_excess(of<JointLimit>(limit), array<const float, 4>(local));
}

mrw_status mrw_limit_pose(const mrw_joint_limit* limits, size_t limit_count, mrw_soa_transform* local,
    size_t local_count) {
  MRW_NEEDS(is_list<JointLimit>(limits, limit_count) && is_list<SoaTransform>(local, local_count), MRW_BAD_ARGUMENT);
  return code(marrow::limit_pose(span<const JointLimit>(limits, limit_count), span<SoaTransform>(local, local_count)));
}

const mrw_joint_limit* mrw_find_limit(const mrw_joint_limit* limits, size_t limit_count, uint32_t joint) {
  MRW_NEEDS(is_list<JointLimit>(limits, limit_count), nullptr);
  return to_c<const mrw_joint_limit>(marrow::find_limit(span<const JointLimit>(limits, limit_count), joint));
}

mrw_status mrw_follow_rotation(mrw_rotation_follower* state, const float target[4], float dt_s,
    const mrw_rate_limit* limit) {
  MRW_NEEDS(leads_to<RotationFollower>(state) && leads_to<float>(target) && leads_to<RateLimit>(limit), MRW_BAD_ARGUMENT);
  return code(marrow::follow_rotation(to<RotationFollower>(state), array<const float, 4>(target), dt_s, of<RateLimit>(limit)));
}

mrw_status mrw_follow_point(mrw_point_follower* state, const float target[3], float dt_s, const mrw_rate_limit* limit) {
  MRW_NEEDS(leads_to<PointFollower>(state) && leads_to<float>(target) && leads_to<RateLimit>(limit), MRW_BAD_ARGUMENT);
  return code(marrow::follow_point(to<PointFollower>(state), array<const float, 3>(target), dt_s, of<RateLimit>(limit)));
}

mrw_status mrw_follow_pose(const mrw_joint_limit* limits, size_t limit_count, mrw_rotation_follower* states,
    size_t state_count, float dt_s, mrw_soa_transform* local, size_t local_count) {
  MRW_NEEDS(is_list<JointLimit>(limits, limit_count) && is_list<RotationFollower>(states, state_count) && is_list<SoaTransform>(local, local_count), MRW_BAD_ARGUMENT);
  return code(marrow::follow_pose(span<const JointLimit>(limits, limit_count), span<RotationFollower>(states, state_count), dt_s, span<SoaTransform>(local, local_count)));
}

mrw_status mrw_turn_two_bone(const mrw_two_bone_joints* joints, const mrw_two_bone* goal, mrw_two_bone_turns* out) {
  MRW_NEEDS(leads_to<TwoBoneJoints>(joints) && leads_to<TwoBone>(goal) && leads_to<TwoBoneTurns>(out), MRW_BAD_ARGUMENT);
  return code(marrow::two_bone(of<TwoBoneJoints>(joints), of<TwoBone>(goal), to<TwoBoneTurns>(out)));
}

mrw_status mrw_turn_two_bone_x4(const mrw_two_bone_joints joints[4], const mrw_two_bone goals[4],
    mrw_two_bone_turns out[4]) {
  MRW_NEEDS(leads_to<TwoBoneJoints>(joints) && leads_to<TwoBone>(goals) && leads_to<TwoBoneTurns>(out), MRW_BAD_ARGUMENT);
  return code(marrow::two_bone_x4(array<const TwoBoneJoints, 4>(joints), array<const TwoBone, 4>(goals), array<TwoBoneTurns, 4>(out)));
}

mrw_status mrw_solve_two_bone(const mrw_pose* pose, const mrw_two_bone_limb* limb, const mrw_two_bone* goal,
    bool* reached) {
  MRW_NEEDS(leads_to<Pose>(pose) && leads_to<TwoBoneLimb>(limb) && leads_to<TwoBone>(goal) && leads_to_if_any<bool>(reached), MRW_BAD_ARGUMENT);
  return code(marrow::solve_two_bone(of<Pose>(pose), of<TwoBoneLimb>(limb), of<TwoBone>(goal), reached));
}

mrw_status mrw_turn_aim(const mrw_affine* joint, const mrw_aim* goal, mrw_aim_turn* out) {
  MRW_NEEDS(leads_to<Affine>(joint) && leads_to<Aim>(goal) && leads_to<AimTurn>(out), MRW_BAD_ARGUMENT);
  return code(marrow::aim(of<Affine>(joint), of<Aim>(goal), to<AimTurn>(out)));
}

mrw_status mrw_solve_aim(const mrw_pose* pose, uint32_t joint, const mrw_aim* goal, bool* reached) {
  MRW_NEEDS(leads_to<Pose>(pose) && leads_to<Aim>(goal) && leads_to_if_any<bool>(reached), MRW_BAD_ARGUMENT);
  return code(marrow::solve_aim(of<Pose>(pose), joint, of<Aim>(goal), reached));
}

mrw_status mrw_solve_look_at(const mrw_pose* pose, const uint32_t* joints, size_t joint_count, const mrw_aim* goal,
    float falloff, bool* reached) {
  MRW_NEEDS(leads_to<Pose>(pose) && is_list<std::uint32_t>(joints, joint_count) && leads_to<Aim>(goal) && leads_to_if_any<bool>(reached), MRW_BAD_ARGUMENT);
  return code(marrow::solve_look_at(of<Pose>(pose), span<const std::uint32_t>(joints, joint_count), of<Aim>(goal), falloff, reached));
}

size_t mrw_ik_scratch_bytes(const mrw_skeleton* skeleton, const mrw_ik_problem* problem,
    const mrw_ik_options* options) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && leads_to<IkProblem>(problem) && leads_to_if_any<IkOptions>(options), 0);
  return marrow::ik_scratch_bytes(of<Skeleton>(skeleton), of<IkProblem>(problem), or_default<IkOptions>(options));
}

mrw_status mrw_solve_ik(const mrw_pose* pose, const mrw_ik_problem* problem, const mrw_ik_options* options,
    void* scratch, size_t scratch_bytes, mrw_ik_report* report) {
  MRW_NEEDS(leads_to<Pose>(pose) && leads_to<IkProblem>(problem) && leads_to_if_any<IkOptions>(options) && is_list<std::byte>(scratch, scratch_bytes) && leads_to_if_any<IkReport>(report), MRW_BAD_ARGUMENT);
  return code(marrow::solve_ik(of<Pose>(pose), of<IkProblem>(problem), or_default<IkOptions>(options), span<std::byte>(scratch, scratch_bytes), static_cast<IkReport*>(static_cast<void*>(report))));
}

mrw_status mrw_solve_ik_chain(const mrw_pose* pose, const mrw_ik_problem* problem, const mrw_ik_options* options,
    void* scratch, size_t scratch_bytes, mrw_ik_report* report) {
  MRW_NEEDS(leads_to<Pose>(pose) && leads_to<IkProblem>(problem) && leads_to_if_any<IkOptions>(options) && is_list<std::byte>(scratch, scratch_bytes) && leads_to_if_any<IkReport>(report), MRW_BAD_ARGUMENT);
  return code(marrow::solve_ik_chain(of<Pose>(pose), of<IkProblem>(problem), or_default<IkOptions>(options), span<std::byte>(scratch, scratch_bytes), static_cast<IkReport*>(static_cast<void*>(report))));
}

mrw_status mrw_solve_ik_body(const mrw_pose* pose, const mrw_ik_problem* problem, const mrw_ik_options* options,
    void* scratch, size_t scratch_bytes, mrw_ik_report* report) {
  MRW_NEEDS(leads_to<Pose>(pose) && leads_to<IkProblem>(problem) && leads_to_if_any<IkOptions>(options) && is_list<std::byte>(scratch, scratch_bytes) && leads_to_if_any<IkReport>(report), MRW_BAD_ARGUMENT);
  return code(marrow::solve_ik_body(of<Pose>(pose), of<IkProblem>(problem), or_default<IkOptions>(options), span<std::byte>(scratch, scratch_bytes), static_cast<IkReport*>(static_cast<void*>(report))));
}

size_t mrw_ik_genetic_scratch_bytes(const mrw_skeleton* skeleton, const mrw_ik_problem* problem) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && leads_to<IkProblem>(problem), 0);
  return marrow::ik_genetic_scratch_bytes(of<Skeleton>(skeleton), of<IkProblem>(problem));
}

mrw_status mrw_solve_ik_genetic(const mrw_pose* pose, const mrw_ik_problem* problem, const mrw_ik_options* options,
    void* scratch, size_t scratch_bytes, mrw_ik_report* report) {
  MRW_NEEDS(leads_to<Pose>(pose) && leads_to<IkProblem>(problem) && leads_to_if_any<IkOptions>(options) && is_list<std::byte>(scratch, scratch_bytes) && leads_to_if_any<IkReport>(report), MRW_BAD_ARGUMENT);
  return code(marrow::solve_ik_genetic(of<Pose>(pose), of<IkProblem>(problem), or_default<IkOptions>(options), span<std::byte>(scratch, scratch_bytes), static_cast<IkReport*>(static_cast<void*>(report))));
}

mrw_status mrw_foot_of(const mrw_roles* roles, mrw_role role, mrw_foot* out) {
  MRW_NEEDS(leads_to<Roles>(roles) && leads_to<Foot>(out), MRW_BAD_ARGUMENT);
  return code(marrow::foot_of(of<Roles>(roles), static_cast<Role>(role), to<Foot>(out)));
}

mrw_status mrw_foot_sole(const mrw_foot* foot, const mrw_affine* world_from_model, const mrw_affine* model_from_joint,
    size_t model_from_joint_count, float sole_world[3]) {
  MRW_NEEDS(leads_to<Foot>(foot) && leads_to<Affine>(world_from_model) && is_list<Affine>(model_from_joint, model_from_joint_count) && leads_to<float>(sole_world), MRW_BAD_ARGUMENT);
  return code(marrow::foot_sole(of<Foot>(foot), of<Affine>(world_from_model), span<const Affine>(model_from_joint, model_from_joint_count), array<float, 3>(sole_world)));
}

mrw_status mrw_place_feet(const mrw_pose* pose, const mrw_feet* feet, const mrw_feet_frame* frame,
    const mrw_foot_ground* ground, size_t ground_count, mrw_foot_motion* motion, size_t motion_count) {
  MRW_NEEDS(leads_to<Pose>(pose) && leads_to<Feet>(feet) && leads_to<FeetFrame>(frame) && is_list<FootGround>(ground, ground_count) && is_list<FootMotion>(motion, motion_count), MRW_BAD_ARGUMENT);
  return code(marrow::place_feet(of<Pose>(pose), of<Feet>(feet), of<FeetFrame>(frame), span<const FootGround>(ground, ground_count), span<FootMotion>(motion, motion_count)));
}

size_t mrw_springs_bytes(const mrw_skeleton* skeleton, const mrw_spring_chain* chains, size_t chain_count) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<SpringChain>(chains, chain_count), 0);
  return marrow::springs_bytes(of<Skeleton>(skeleton), span<const SpringChain>(chains, chain_count));
}

mrw_status mrw_make_springs(const mrw_skeleton* skeleton, const mrw_spring_chain* chains, size_t chain_count,
    void* memory, size_t memory_bytes, mrw_springs* out) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<SpringChain>(chains, chain_count) && is_list<std::byte>(memory, memory_bytes) && leads_to<Springs>(out), MRW_BAD_ARGUMENT);
  return code(marrow::make_springs(of<Skeleton>(skeleton), span<const SpringChain>(chains, chain_count), span<std::byte>(memory, memory_bytes), to<Springs>(out)));
}

mrw_status mrw_set_springs(const mrw_skeleton* skeleton, const mrw_spring_chain* chains, size_t chain_count,
    mrw_springs* springs) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<SpringChain>(chains, chain_count) && leads_to<Springs>(springs), MRW_BAD_ARGUMENT);
  return code(marrow::set_springs(of<Skeleton>(skeleton), span<const SpringChain>(chains, chain_count), to<Springs>(springs)));
}

void mrw_reset_springs(mrw_springs* springs) {
  MRW_NEEDS(leads_to<Springs>(springs), );
  marrow::reset_springs(to<Springs>(springs));
}

mrw_status mrw_simulate_springs(const mrw_pose* pose, const mrw_spring_frame* frame, mrw_springs* springs) {
  MRW_NEEDS(leads_to<Pose>(pose) && leads_to<SpringFrame>(frame) && leads_to<Springs>(springs), MRW_BAD_ARGUMENT);
  return code(marrow::simulate_springs(of<Pose>(pose), of<SpringFrame>(frame), to<Springs>(springs)));
}

mrw_status mrw_find_weight_channels(const mrw_file* file, const mrw_mesh* mesh, const mrw_file* clips,
    const mrw_clip* clip, uint32_t* out, size_t out_count) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<Mesh>(mesh) && leads_to<File>(clips) && leads_to<Clip>(clip) && is_list<std::uint32_t>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::find_weight_channels(of<File>(file), of<Mesh>(mesh), of<File>(clips), of<Clip>(clip), span<std::uint32_t>(out, out_count)));
}

mrw_status mrw_morph_weights(const mrw_mesh* mesh, const uint32_t* channels, size_t channel_count, const float* values,
    size_t value_count, float* out, size_t out_count) {
  MRW_NEEDS(leads_to<Mesh>(mesh) && is_list<std::uint32_t>(channels, channel_count) && is_list<float>(values, value_count) && is_list<float>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::morph_weights(of<Mesh>(mesh), span<const std::uint32_t>(channels, channel_count), span<const float>(values, value_count), span<float>(out, out_count)));
}

size_t mrw_morphed_bytes(const mrw_geometry* geometry) {
  MRW_NEEDS(leads_to<Geometry>(geometry), 0);
  return marrow::morphed_bytes(of<Geometry>(geometry));
}

mrw_status mrw_make_morphed(const mrw_geometry* geometry, void* memory, size_t memory_bytes,
    mrw_morphed_geometry* out) {
  MRW_NEEDS(leads_to<Geometry>(geometry) && is_list<std::byte>(memory, memory_bytes) && leads_to<MorphedGeometry>(out), MRW_BAD_ARGUMENT);
  return code(marrow::make_morphed(of<Geometry>(geometry), span<std::byte>(memory, memory_bytes), to<MorphedGeometry>(out)));
}

mrw_status mrw_morph(const float* weights, size_t weight_count, mrw_morphed_geometry* morphed) {
  MRW_NEEDS(is_list<float>(weights, weight_count) && leads_to<MorphedGeometry>(morphed), MRW_BAD_ARGUMENT);
  return code(marrow::morph(span<const float>(weights, weight_count), to<MorphedGeometry>(morphed)));
}

mrw_status mrw_morph_coordinates(mrw_morphed_geometry* morphed, float* coordinates, size_t coordinate_count) {
  MRW_NEEDS(leads_to<MorphedGeometry>(morphed) && is_list<float>(coordinates, coordinate_count), MRW_BAD_ARGUMENT);
  return code(marrow::morph_coordinates(to<MorphedGeometry>(morphed), span<float>(coordinates, coordinate_count)));
}

mrw_status mrw_find_example_channels(const mrw_file* file, const mrw_example_space* space, const mrw_file* clips,
    const mrw_clip* clip, uint32_t* out, size_t out_count) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<ExampleSpace>(space) && leads_to<File>(clips) && leads_to<Clip>(clip) && is_list<std::uint32_t>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::find_example_channels(of<File>(file), of<ExampleSpace>(space), of<File>(clips), of<Clip>(clip), span<std::uint32_t>(out, out_count)));
}

mrw_status mrw_evaluate_examples(const mrw_example_space* space, const float* parameters, size_t parameter_count,
    float* weights, size_t weight_count) {
  MRW_NEEDS(leads_to<ExampleSpace>(space) && is_list<float>(parameters, parameter_count) && is_list<float>(weights, weight_count), MRW_BAD_ARGUMENT);
  return code(marrow::evaluate_examples(of<ExampleSpace>(space), span<const float>(parameters, parameter_count), span<float>(weights, weight_count)));
}

mrw_status mrw_joint_lines(const mrw_skeleton* skeleton, const mrw_affine* model_from_joint,
    size_t model_from_joint_count, float axis_m, mrw_debug_lines* lines) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<Affine>(model_from_joint, model_from_joint_count) && leads_to<DebugLines>(lines), MRW_BAD_ARGUMENT);
  return code(marrow::joint_lines(of<Skeleton>(skeleton), span<const Affine>(model_from_joint, model_from_joint_count), axis_m, to<DebugLines>(lines)));
}

mrw_status mrw_limit_lines(const mrw_skeleton* skeleton, const mrw_joint_limit* limits, size_t limit_count,
    const mrw_soa_transform* local, size_t local_count, const mrw_affine* model_from_joint,
    size_t model_from_joint_count, float size_m, mrw_debug_lines* lines) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<JointLimit>(limits, limit_count) && is_list<SoaTransform>(local, local_count) && is_list<Affine>(model_from_joint, model_from_joint_count) && leads_to<DebugLines>(lines), MRW_BAD_ARGUMENT);
  return code(marrow::limit_lines(of<Skeleton>(skeleton), span<const JointLimit>(limits, limit_count), span<const SoaTransform>(local, local_count), span<const Affine>(model_from_joint, model_from_joint_count), size_m, to<DebugLines>(lines)));
}

mrw_status mrw_goal_lines(const mrw_skeleton* skeleton, const mrw_ik_goal* goals, size_t goal_count,
    const mrw_affine* model_from_joint, size_t model_from_joint_count, float size_m, float tolerance_m,
    mrw_debug_lines* lines) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<IkGoal>(goals, goal_count) && is_list<Affine>(model_from_joint, model_from_joint_count) && leads_to<DebugLines>(lines), MRW_BAD_ARGUMENT);
  return code(marrow::goal_lines(of<Skeleton>(skeleton), span<const IkGoal>(goals, goal_count), span<const Affine>(model_from_joint, model_from_joint_count), size_m, tolerance_m, to<DebugLines>(lines)));
}

mrw_status mrw_spring_lines(const mrw_skeleton* skeleton, const mrw_spring_chain* chains, size_t chain_count,
    const mrw_affine* model_from_joint, size_t model_from_joint_count, mrw_debug_lines* lines) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<SpringChain>(chains, chain_count) && is_list<Affine>(model_from_joint, model_from_joint_count) && leads_to<DebugLines>(lines), MRW_BAD_ARGUMENT);
  return code(marrow::spring_lines(of<Skeleton>(skeleton), span<const SpringChain>(chains, chain_count), span<const Affine>(model_from_joint, model_from_joint_count), to<DebugLines>(lines)));
}

mrw_status mrw_collider_lines(const mrw_skeleton* skeleton, const mrw_spring_collider* colliders, size_t collider_count,
    const mrw_affine* model_from_joint, size_t model_from_joint_count, mrw_debug_lines* lines) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<SpringCollider>(colliders, collider_count) && is_list<Affine>(model_from_joint, model_from_joint_count) && leads_to<DebugLines>(lines), MRW_BAD_ARGUMENT);
  return code(marrow::collider_lines(of<Skeleton>(skeleton), span<const SpringCollider>(colliders, collider_count), span<const Affine>(model_from_joint, model_from_joint_count), to<DebugLines>(lines)));
}

mrw_status mrw_bounds_lines(const mrw_bounds* bounds, mrw_debug_lines* lines) {
  MRW_NEEDS(leads_to<Bounds>(bounds) && leads_to<DebugLines>(lines), MRW_BAD_ARGUMENT);
  return code(marrow::bounds_lines(of<Bounds>(bounds), to<DebugLines>(lines)));
}

mrw_status mrw_build_palette_of_joints(const uint16_t* joints, size_t joint_count, const mrw_affine* bind,
    size_t bind_count, const mrw_affine* model_from_joint, size_t model_from_joint_count, mrw_affine* out,
    size_t out_count, const mrw_helper* helpers, size_t helper_count, const float* centres, size_t centre_count) {
  MRW_NEEDS(is_list<std::uint16_t>(joints, joint_count) && is_list<Affine>(bind, bind_count) && is_list<Affine>(model_from_joint, model_from_joint_count) && is_list<Affine>(out, out_count) && is_list<Helper>(helpers, helper_count) && is_list<float>(centres, centre_count), MRW_BAD_ARGUMENT);
  return code(marrow::build_palette(span<const std::uint16_t>(joints, joint_count), span<const Affine>(bind, bind_count), span<const Affine>(model_from_joint, model_from_joint_count), span<Affine>(out, out_count), span<const Helper>(helpers, helper_count), span<const float>(centres, centre_count)));
}

mrw_status mrw_build_palette(const mrw_mesh* mesh, const mrw_affine* model_from_joint, size_t model_from_joint_count,
    mrw_affine* out, size_t out_count) {
  MRW_NEEDS(leads_to<Mesh>(mesh) && is_list<Affine>(model_from_joint, model_from_joint_count) && is_list<Affine>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::build_palette(of<Mesh>(mesh), span<const Affine>(model_from_joint, model_from_joint_count), span<Affine>(out, out_count)));
}

bool mrw_turns_inside_out(const mrw_affine* map) {
  MRW_NEEDS(leads_to<Affine>(map), false);
  return marrow::turns_inside_out(of<Affine>(map));
}

bool mrw_palette_turns_inside_out(const mrw_affine* palette, size_t palette_count) {
  MRW_NEEDS(is_list<Affine>(palette, palette_count), false);
  return marrow::turns_inside_out(span<const Affine>(palette, palette_count));
}

size_t mrw_extents_bytes(const mrw_mesh* mesh) {
  MRW_NEEDS(leads_to<Mesh>(mesh), 0);
  return marrow::extents_bytes(of<Mesh>(mesh));
}

mrw_status mrw_make_extents(const mrw_mesh* mesh, void* memory, size_t memory_bytes, mrw_mesh_extents* out) {
  MRW_NEEDS(leads_to<Mesh>(mesh) && is_list<std::byte>(memory, memory_bytes) && leads_to<MeshExtents>(out), MRW_BAD_ARGUMENT);
  return code(marrow::make_extents(of<Mesh>(mesh), span<std::byte>(memory, memory_bytes), to<MeshExtents>(out)));
}

mrw_status mrw_palette_bounds(const mrw_mesh_extents* extents, const mrw_affine* palette, size_t palette_count,
    const float* weights, size_t weight_count, mrw_bounds* out) {
  MRW_NEEDS(leads_to<MeshExtents>(extents) && is_list<Affine>(palette, palette_count) && is_list<float>(weights, weight_count) && leads_to<Bounds>(out), MRW_BAD_ARGUMENT);
  return code(marrow::palette_bounds(of<MeshExtents>(extents), span<const Affine>(palette, palette_count), span<const float>(weights, weight_count), to<Bounds>(out)));
}

mrw_status mrw_skin_rigid(const mrw_mesh* mesh, const mrw_affine* palette, size_t palette_count,
    const mrw_skin_output* out) {
  MRW_NEEDS(leads_to<Mesh>(mesh) && is_list<Affine>(palette, palette_count) && leads_to<SkinOutput>(out), MRW_BAD_ARGUMENT);
  return code(marrow::skin_rigid(of<Mesh>(mesh), span<const Affine>(palette, palette_count), of<SkinOutput>(out)));
}

mrw_status mrw_skin_ssd(const mrw_mesh* mesh, const mrw_affine* palette, size_t palette_count,
    const mrw_skin_output* out) {
  MRW_NEEDS(leads_to<Mesh>(mesh) && is_list<Affine>(palette, palette_count) && leads_to<SkinOutput>(out), MRW_BAD_ARGUMENT);
  return code(marrow::skin_ssd(of<Mesh>(mesh), span<const Affine>(palette, palette_count), of<SkinOutput>(out)));
}

size_t mrw_as_coordinate_count(const mrw_geometry* geometry) {
  MRW_NEEDS(leads_to<Geometry>(geometry), 0);
  return marrow::as_coordinate_count(of<Geometry>(geometry));
}

mrw_status mrw_as_coordinates(const mrw_geometry* geometry, float* out, size_t out_count) {
  MRW_NEEDS(leads_to<Geometry>(geometry) && is_list<float>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::as_coordinates(of<Geometry>(geometry), span<float>(out, out_count)));
}

size_t mrw_as_tangent_count(const mrw_geometry* geometry) {
  MRW_NEEDS(leads_to<Geometry>(geometry), 0);
  return marrow::as_tangent_count(of<Geometry>(geometry));
}

size_t mrw_as_tangent_scratch_bytes(const mrw_as_part* parts, size_t part_count) {
  MRW_NEEDS(is_list<AsPart>(parts, part_count), 0);
  return marrow::as_tangent_scratch_bytes(span<const AsPart>(parts, part_count));
}

mrw_status mrw_as_tangents(const mrw_as_part* parts, size_t part_count, void* scratch, size_t scratch_bytes) {
  MRW_NEEDS(is_list<AsPart>(parts, part_count) && is_list<std::byte>(scratch, scratch_bytes), MRW_BAD_ARGUMENT);
  return code(marrow::as_tangents(span<const AsPart>(parts, part_count), span<std::byte>(scratch, scratch_bytes)));
}

mrw_status mrw_skin_as(const mrw_mesh* mesh, const float* coordinates, size_t coordinate_count,
    const mrw_affine* palette, size_t palette_count, const mrw_skin_output* out, const float* tangents,
    size_t tangent_count) {
  MRW_NEEDS(leads_to<Mesh>(mesh) && is_list<float>(coordinates, coordinate_count) && is_list<Affine>(palette, palette_count) && leads_to<SkinOutput>(out) && is_list<float>(tangents, tangent_count), MRW_BAD_ARGUMENT);
  return code(marrow::skin_as(of<Mesh>(mesh), span<const float>(coordinates, coordinate_count), span<const Affine>(palette, palette_count), of<SkinOutput>(out), span<const float>(tangents, tangent_count)));
}

mrw_status mrw_skin_mwe(const mrw_mesh* mesh, const mrw_affine* palette, size_t palette_count,
    const mrw_skin_output* out) {
  MRW_NEEDS(leads_to<Mesh>(mesh) && is_list<Affine>(palette, palette_count) && leads_to<SkinOutput>(out), MRW_BAD_ARGUMENT);
  return code(marrow::skin_mwe(of<Mesh>(mesh), span<const Affine>(palette, palette_count), of<SkinOutput>(out)));
}

size_t mrw_psd_distance_count(const mrw_geometry* geometry) {
  MRW_NEEDS(leads_to<Geometry>(geometry), 0);
  return marrow::psd_distance_count(of<Geometry>(geometry));
}

mrw_status mrw_psd_distances(const mrw_geometry* geometry, const mrw_affine* palette, size_t palette_count, float* out,
    size_t out_count) {
  MRW_NEEDS(leads_to<Geometry>(geometry) && is_list<Affine>(palette, palette_count) && is_list<float>(out, out_count), MRW_BAD_ARGUMENT);
  return code(marrow::psd_distances(of<Geometry>(geometry), span<const Affine>(palette, palette_count), span<float>(out, out_count)));
}

mrw_status mrw_skin_psd(const mrw_mesh* mesh, const float* distances, size_t distance_count, const mrw_affine* palette,
    size_t palette_count, const mrw_skin_output* out) {
  MRW_NEEDS(leads_to<Mesh>(mesh) && is_list<float>(distances, distance_count) && is_list<Affine>(palette, palette_count) && leads_to<SkinOutput>(out), MRW_BAD_ARGUMENT);
  return code(marrow::skin_psd(of<Mesh>(mesh), span<const float>(distances, distance_count), span<const Affine>(palette, palette_count), of<SkinOutput>(out)));
}

size_t mrw_animations_bytes(const mrw_file* file, const mrw_file* clips) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<File>(clips), 0);
  return marrow::animations_bytes(of<File>(file), of<File>(clips));
}

mrw_status mrw_make_animations(const mrw_file* file, const mrw_file* clips, void* memory, size_t memory_bytes,
    mrw_animations* out) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<File>(clips) && is_list<std::byte>(memory, memory_bytes) && leads_to<Animations>(out), MRW_BAD_ARGUMENT);
  return code(marrow::make_animations(of<File>(file), of<File>(clips), span<std::byte>(memory, memory_bytes), to<Animations>(out)));
}

const mrw_animation* mrw_find_animation(const mrw_animations* animations, const char* name) {
  MRW_NEEDS(leads_to<Animations>(animations), nullptr);
  return to_c<const mrw_animation>(marrow::find_animation(of<Animations>(animations), name));
}

mrw_status mrw_clip_of(const mrw_animation* animation, uint32_t skeleton, mrw_clip* out) {
  MRW_NEEDS(leads_to<Animation>(animation) && leads_to<Clip>(out), MRW_BAD_ARGUMENT);
  give<Clip>(out, marrow::clip_of(of<Animation>(animation), skeleton));
  return MRW_OK;
}

size_t mrw_character_bytes(const mrw_file* file, const mrw_character_options* options) {
  MRW_NEEDS(leads_to<File>(file) && leads_to_if_any<CharacterOptions>(options), 0);
  return marrow::character_bytes(of<File>(file), or_default<CharacterOptions>(options));
}

mrw_status mrw_make_character(const mrw_file* file, const mrw_character_options* options, void* memory,
    size_t memory_bytes, mrw_character* out) {
  MRW_NEEDS(leads_to<File>(file) && leads_to_if_any<CharacterOptions>(options) && is_list<std::byte>(memory, memory_bytes) && leads_to<Character>(out), MRW_BAD_ARGUMENT);
  return code(marrow::make_character(of<File>(file), or_default<CharacterOptions>(options), span<std::byte>(memory, memory_bytes), to<Character>(out)));
}

mrw_status mrw_sample_character(mrw_character* character, const mrw_animation_layer* layers, size_t layer_count) {
  MRW_NEEDS(leads_to<Character>(character) && is_list<AnimationLayer>(layers, layer_count), MRW_BAD_ARGUMENT);
  return code(marrow::sample_character(to<Character>(character), span<const AnimationLayer>(layers, layer_count)));
}

mrw_status mrw_character_to_model(mrw_character* character) {
  MRW_NEEDS(leads_to<Character>(character), MRW_BAD_ARGUMENT);
  return code(marrow::local_to_model(to<Character>(character)));
}

mrw_status mrw_pose_character(mrw_character* character, const mrw_animation_layer* layers, size_t layer_count) {
  MRW_NEEDS(leads_to<Character>(character) && is_list<AnimationLayer>(layers, layer_count), MRW_BAD_ARGUMENT);
  return code(marrow::pose_character(to<Character>(character), span<const AnimationLayer>(layers, layer_count)));
}

mrw_status mrw_step_layer(const mrw_playback* before, const mrw_playback* after, mrw_animation_layer* layer) {
  MRW_NEEDS(leads_to<Playback>(before) && leads_to<Playback>(after) && leads_to<AnimationLayer>(layer), MRW_BAD_ARGUMENT);
  return code(marrow::step_layer(of<Playback>(before), of<Playback>(after), to<AnimationLayer>(layer)));
}

mrw_status mrw_character_root_step(const mrw_character* character, const mrw_animation_layer* layers,
    size_t layer_count, mrw_rigid_step* out) {
  MRW_NEEDS(leads_to<Character>(character) && is_list<AnimationLayer>(layers, layer_count) && leads_to<RigidStep>(out), MRW_BAD_ARGUMENT);
  return code(marrow::character_root_step(of<Character>(character), span<const AnimationLayer>(layers, layer_count), to<RigidStep>(out)));
}

mrw_status mrw_add_expression(mrw_character* character, const mrw_animation_layer* expression) {
  MRW_NEEDS(leads_to<Character>(character) && leads_to<AnimationLayer>(expression), MRW_BAD_ARGUMENT);
  return code(marrow::add_expression(to<Character>(character), of<AnimationLayer>(expression)));
}

mrw_status mrw_finish_character(mrw_character* character) {
  MRW_NEEDS(leads_to<Character>(character), MRW_BAD_ARGUMENT);
  return code(marrow::finish_character(to<Character>(character)));
}

size_t mrw_outfit_bytes(const mrw_file* outfit) {
  MRW_NEEDS(leads_to<File>(outfit), 0);
  return marrow::outfit_bytes(of<File>(outfit));
}

mrw_status mrw_make_outfit(const mrw_file* body, const mrw_file* outfit, void* memory, size_t memory_bytes,
    mrw_outfit* out) {
  MRW_NEEDS(leads_to<File>(body) && leads_to<File>(outfit) && is_list<std::byte>(memory, memory_bytes) && leads_to<Outfit>(out), MRW_BAD_ARGUMENT);
  return code(marrow::make_outfit(of<File>(body), of<File>(outfit), span<std::byte>(memory, memory_bytes), to<Outfit>(out)));
}

mrw_status mrw_character_follow_body(const mrw_outfit* outfit, const mrw_character* body, mrw_character* worn) {
  MRW_NEEDS(leads_to<Outfit>(outfit) && leads_to<Character>(body) && leads_to<Character>(worn), MRW_BAD_ARGUMENT);
  return code(marrow::follow_body(of<Outfit>(outfit), of<Character>(body), to<Character>(worn)));
}

size_t mrw_graph_binding_bytes(const mrw_graph* graph, const mrw_file* character) {
  MRW_NEEDS(leads_to<Graph>(graph) && leads_to<File>(character), 0);
  return marrow::graph_binding_bytes(of<Graph>(graph), of<File>(character));
}

mrw_status mrw_bind_graph(const mrw_file* file, const mrw_graph* graph, const mrw_file* character,
    const mrw_animations* animations, size_t animation_count, void* memory, size_t memory_bytes, mrw_graph_binding* out,
    mrw_graph_misfit* misfit) {
  MRW_NEEDS(leads_to<File>(file) && leads_to<Graph>(graph) && leads_to<File>(character) && is_list<Animations>(animations, animation_count) && is_list<std::byte>(memory, memory_bytes) && leads_to<GraphBinding>(out) && leads_to_if_any<GraphMisfit>(misfit), MRW_BAD_ARGUMENT);
  return code(marrow::bind_graph(of<File>(file), of<Graph>(graph), of<File>(character), span<const Animations>(animations, animation_count), span<std::byte>(memory, memory_bytes), to<GraphBinding>(out), static_cast<GraphMisfit*>(static_cast<void*>(misfit))));
}

uint32_t mrw_event_id(const char* name) {
  return marrow::event_id(name);
}

size_t mrw_animator_bytes(const mrw_graph_binding* binding, const mrw_animator_options* options) {
  MRW_NEEDS(leads_to<GraphBinding>(binding) && leads_to_if_any<AnimatorOptions>(options), 0);
  return marrow::animator_bytes(of<GraphBinding>(binding), or_default<AnimatorOptions>(options));
}

mrw_status mrw_make_animator(const mrw_graph_binding* binding, const mrw_animator_options* options, void* memory,
    size_t memory_bytes, mrw_animator* out) {
  MRW_NEEDS(leads_to<GraphBinding>(binding) && leads_to_if_any<AnimatorOptions>(options) && is_list<std::byte>(memory, memory_bytes) && leads_to<Animator>(out), MRW_BAD_ARGUMENT);
  return code(marrow::make_animator(of<GraphBinding>(binding), or_default<AnimatorOptions>(options), span<std::byte>(memory, memory_bytes), to<Animator>(out)));
}

uint32_t mrw_find_parameter(const mrw_graph_binding* binding, const char* name) {
  MRW_NEEDS(leads_to<GraphBinding>(binding), 0);
  return marrow::find_parameter(of<GraphBinding>(binding), name);
}

uint32_t mrw_find_graph_node(const mrw_graph_binding* binding, const char* name) {
  MRW_NEEDS(leads_to<GraphBinding>(binding), 0);
  return marrow::find_graph_node(of<GraphBinding>(binding), name);
}

uint32_t mrw_find_state(const mrw_graph_binding* binding, uint32_t node, const char* name) {
  MRW_NEEDS(leads_to<GraphBinding>(binding), 0);
  return marrow::find_state(of<GraphBinding>(binding), node, name);
}

mrw_status mrw_set_number(mrw_animator* animator, uint32_t parameter, float value) {
  MRW_NEEDS(leads_to<Animator>(animator), MRW_BAD_ARGUMENT);
  return code(marrow::set_number(to<Animator>(animator), parameter, value));
}

mrw_status mrw_set_flag(mrw_animator* animator, uint32_t parameter, bool value) {
  MRW_NEEDS(leads_to<Animator>(animator), MRW_BAD_ARGUMENT);
  return code(marrow::set_flag(to<Animator>(animator), parameter, value));
}

mrw_status mrw_fire_trigger(mrw_animator* animator, uint32_t parameter) {
  MRW_NEEDS(leads_to<Animator>(animator), MRW_BAD_ARGUMENT);
  return code(marrow::fire(to<Animator>(animator), parameter));
}

float mrw_value_of(const mrw_animator* animator, uint32_t parameter) {
  MRW_NEEDS(leads_to<Animator>(animator), 0);
  return marrow::value_of(of<Animator>(animator), parameter);
}

uint32_t mrw_state_of(const mrw_animator* animator, uint32_t node, float* seconds) {
  MRW_NEEDS(leads_to<Animator>(animator) && leads_to_if_any<float>(seconds), 0);
  return marrow::state_of(of<Animator>(animator), node, seconds);
}

mrw_status mrw_update_animator(mrw_animator* animator, float dt_s, mrw_animator_step* out) {
  MRW_NEEDS(leads_to<Animator>(animator) && leads_to<AnimatorStep>(out), MRW_BAD_ARGUMENT);
  return code(marrow::update_animator(to<Animator>(animator), dt_s, to<AnimatorStep>(out)));
}

mrw_status mrw_restore_animator(mrw_animator* animator, const void* snapshot, size_t snapshot_bytes) {
  MRW_NEEDS(leads_to<Animator>(animator) && is_list<std::byte>(snapshot, snapshot_bytes), MRW_BAD_ARGUMENT);
  return code(marrow::restore_animator(to<Animator>(animator), span<const std::byte>(snapshot, snapshot_bytes)));
}

mrw_status mrw_sample_animated(mrw_character* character, mrw_animator* animator, const mrw_given_pose* given,
    size_t given_count) {
  MRW_NEEDS(leads_to<Character>(character) && leads_to<Animator>(animator) && is_list<GivenPose>(given, given_count), MRW_BAD_ARGUMENT);
  return code(marrow::sample_character(to<Character>(character), to<Animator>(animator), span<const GivenPose>(given, given_count)));
}

mrw_status mrw_pose_animated(mrw_character* character, mrw_animator* animator, const mrw_given_pose* given,
    size_t given_count) {
  MRW_NEEDS(leads_to<Character>(character) && leads_to<Animator>(animator) && is_list<GivenPose>(given, given_count), MRW_BAD_ARGUMENT);
  return code(marrow::pose_character(to<Character>(character), to<Animator>(animator), span<const GivenPose>(given, given_count)));
}

}  // extern "C"
