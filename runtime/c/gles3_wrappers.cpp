// Made by tools/c_api from the descriptions in runtime/c: one line of C++ a function. Do not edit.
#include "c/gles3_twin.h"

#include "marrow/gles3.h"
#include "marrow/gles3_crowd.h"
#include "marrow/gles3_self_test.h"
#include "marrow/gles3_skinner.h"

// clang-format off
using namespace marrow;
using namespace marrow::c;

extern "C" {

uint32_t mrw_gles3_abi(void) {
  return MRW_GLES3_ABI;
}

void mrw_gles3_error_watch_init(mrw_gles3_error_watch* out) {
  MRW_NEEDS(leads_to<gles3::ErrorWatch>(out), );
  to<gles3::ErrorWatch>(out) = gles3::ErrorWatch{};
}

void mrw_gles3_caps_init(mrw_gles3_caps* out) {
  MRW_NEEDS(leads_to<gles3::Caps>(out), );
  to<gles3::Caps>(out) = gles3::Caps{};
}

void mrw_gles3_program_source_init(mrw_gles3_program_source* out) {
  MRW_NEEDS(leads_to<gles3::ProgramSource>(out), );
  to<gles3::ProgramSource>(out) = gles3::ProgramSource{};
}

void mrw_gles3_program_init(mrw_gles3_program* out) {
  MRW_NEEDS(leads_to<gles3::Program>(out), );
  to<gles3::Program>(out) = gles3::Program{};
}

void mrw_gles3_program_set_init(mrw_gles3_program_set* out) {
  MRW_NEEDS(leads_to<gles3::ProgramSet>(out), );
  to<gles3::ProgramSet>(out) = gles3::ProgramSet{};
}

void mrw_gles3_skinned_mesh_init(mrw_gles3_skinned_mesh* out) {
  MRW_NEEDS(leads_to<gles3::SkinnedMesh>(out), );
  to<gles3::SkinnedMesh>(out) = gles3::SkinnedMesh{};
}

void mrw_gles3_skinner_options_init(mrw_gles3_skinner_options* out) {
  MRW_NEEDS(leads_to<gles3::SkinnerOptions>(out), );
  to<gles3::SkinnerOptions>(out) = gles3::SkinnerOptions{};
}

void mrw_gles3_skinner_init(mrw_gles3_skinner* out) {
  MRW_NEEDS(leads_to<gles3::Skinner>(out), );
  to<gles3::Skinner>(out) = gles3::Skinner{};
}

void mrw_gles3_crowd_source_init(mrw_gles3_crowd_source* out) {
  MRW_NEEDS(leads_to<gles3::CrowdSource>(out), );
  to<gles3::CrowdSource>(out) = gles3::CrowdSource{};
}

void mrw_gles3_crowd_clip_init(mrw_gles3_crowd_clip* out) {
  MRW_NEEDS(leads_to<gles3::CrowdClip>(out), );
  to<gles3::CrowdClip>(out) = gles3::CrowdClip{};
}

void mrw_gles3_crowd_frames_init(mrw_gles3_crowd_frames* out) {
  MRW_NEEDS(leads_to<gles3::CrowdFrames>(out), );
  to<gles3::CrowdFrames>(out) = gles3::CrowdFrames{};
}

void mrw_gles3_crowd_play_init(mrw_gles3_crowd_play* out) {
  MRW_NEEDS(leads_to<gles3::CrowdPlay>(out), );
  to<gles3::CrowdPlay>(out) = gles3::CrowdPlay{};
}

void mrw_gles3_crowd_instance_init(mrw_gles3_crowd_instance* out) {
  MRW_NEEDS(leads_to<gles3::CrowdInstance>(out), );
  to<gles3::CrowdInstance>(out) = gles3::CrowdInstance{};
}

void mrw_gles3_crowd_mesh_options_init(mrw_gles3_crowd_mesh_options* out) {
  MRW_NEEDS(leads_to<gles3::CrowdMeshOptions>(out), );
  to<gles3::CrowdMeshOptions>(out) = gles3::CrowdMeshOptions{};
}

void mrw_gles3_crowd_mesh_init(mrw_gles3_crowd_mesh* out) {
  MRW_NEEDS(leads_to<gles3::CrowdMesh>(out), );
  to<gles3::CrowdMesh>(out) = gles3::CrowdMesh{};
}

void mrw_gles3_crowd_init(mrw_gles3_crowd* out) {
  MRW_NEEDS(leads_to<gles3::Crowd>(out), );
  to<gles3::Crowd>(out) = gles3::Crowd{};
}

void mrw_gles3_path_result_init(mrw_gles3_path_result* out) {
  MRW_NEEDS(leads_to<gles3::PathResult>(out), );
  to<gles3::PathResult>(out) = gles3::PathResult{};
}

void mrw_gles3_self_test_init(mrw_gles3_self_test* out) {
  MRW_NEEDS(leads_to<gles3::SelfTest>(out), );
  to<gles3::SelfTest>(out) = gles3::SelfTest{};
}

void mrw_gles3_self_test_options_init(mrw_gles3_self_test_options* out) {
  MRW_NEEDS(leads_to<gles3::SelfTestOptions>(out), );
  to<gles3::SelfTestOptions>(out) = gles3::SelfTestOptions{};
}

void mrw_gles3_path_need_init(mrw_gles3_path_need* out) {
  MRW_NEEDS(leads_to<gles3::PathNeed>(out), );
  to<gles3::PathNeed>(out) = gles3::PathNeed{};
}

mrw_status mrw_gles3_load_api(mrw_gles3_api* api, mrw_gles3_load_proc load_proc, const char** missing) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && leads_to_if_any<const char*>(missing), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::load_api(to<gles3::Api>(api), load_proc, missing));
}

bool mrw_gles3_context_was_reset(const mrw_gles3_api* api) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)), false);
  return marrow::gles3::context_was_reset(of<gles3::Api>(api));
}

void mrw_gles3_watch_errors(mrw_gles3_api* api, mrw_gles3_error_watch* watch) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && leads_to_if_any<gles3::ErrorWatch>(watch), );
  marrow::gles3::watch_errors(to<gles3::Api>(api), static_cast<gles3::ErrorWatch*>(static_cast<void*>(watch)));
}

mrw_status mrw_gles3_query_caps(const mrw_gles3_api* api, mrw_gles3_caps* caps) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Caps>(caps), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::query_caps(of<gles3::Api>(api), to<gles3::Caps>(caps)));
}

const char* mrw_gles3_skinning_path_text(mrw_gles3_skinning_path path) {
  return marrow::gles3::to_string(static_cast<gles3::SkinningPath>(path));
}

void mrw_gles3_destroy_programs(const mrw_gles3_api* api, mrw_gles3_program_set* programs) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::ProgramSet>(programs), );
  marrow::gles3::destroy(of<gles3::Api>(api), to<gles3::ProgramSet>(programs));
}

size_t mrw_gles3_skinner_bytes(const mrw_mesh* mesh, const mrw_gles3_skinner_options* options) {
  MRW_NEEDS(leads_to<Mesh>(mesh) && leads_to<gles3::SkinnerOptions>(options), 0);
  return marrow::gles3::skinner_bytes(of<Mesh>(mesh), of<gles3::SkinnerOptions>(options));
}

mrw_status mrw_gles3_create_skinner(const mrw_gles3_api* api, const mrw_gles3_caps* caps, const mrw_mesh* mesh,
    const mrw_gles3_skinner_options* options, mrw_gles3_program_set* programs, void* memory, size_t memory_bytes,
    mrw_gles3_skinner* out) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Caps>(caps) && leads_to<Mesh>(mesh) && leads_to<gles3::SkinnerOptions>(options) && leads_to<gles3::ProgramSet>(programs) && is_list<std::byte>(memory, memory_bytes) && leads_to<gles3::Skinner>(out), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::create_skinner(of<gles3::Api>(api), of<gles3::Caps>(caps), of<Mesh>(mesh), of<gles3::SkinnerOptions>(options), to<gles3::ProgramSet>(programs), span<std::byte>(memory, memory_bytes), to<gles3::Skinner>(out)));
}

void mrw_gles3_destroy_skinner(const mrw_gles3_api* api, mrw_gles3_skinner* skinner) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Skinner>(skinner), );
  marrow::gles3::destroy(of<gles3::Api>(api), to<gles3::Skinner>(skinner));
}

mrw_status mrw_gles3_pose(mrw_gles3_skinner* skinner, uint32_t instance, const mrw_affine* model_from_joint,
    size_t model_from_joint_count, const float* weights, size_t weight_count) {
  MRW_NEEDS(leads_to<gles3::Skinner>(skinner) && is_list<Affine>(model_from_joint, model_from_joint_count) && is_list<float>(weights, weight_count), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::pose(to<gles3::Skinner>(skinner), instance, span<const Affine>(model_from_joint, model_from_joint_count), span<const float>(weights, weight_count)));
}

mrw_status mrw_gles3_reset_motion(mrw_gles3_skinner* skinner, uint32_t instance) {
  MRW_NEEDS(leads_to<gles3::Skinner>(skinner), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::reset_motion(to<gles3::Skinner>(skinner), instance));
}

mrw_status mrw_gles3_update(const mrw_gles3_api* api, mrw_gles3_skinner* skinner, const mrw_gles3_program_set* programs,
    uint32_t count) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Skinner>(skinner) && leads_to<gles3::ProgramSet>(programs), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::update(of<gles3::Api>(api), to<gles3::Skinner>(skinner), of<gles3::ProgramSet>(programs), count));
}

const mrw_gles3_program* mrw_gles3_program_of(const mrw_gles3_skinner* skinner, const mrw_gles3_program_set* programs,
    uint32_t role) {
  MRW_NEEDS(leads_to<gles3::Skinner>(skinner) && leads_to<gles3::ProgramSet>(programs), nullptr);
  return to_c<const mrw_gles3_program>(&marrow::gles3::program_of(of<gles3::Skinner>(skinner), of<gles3::ProgramSet>(programs), role));
}

mrw_status mrw_gles3_draw(const mrw_gles3_api* api, const mrw_gles3_skinner* skinner,
    const mrw_gles3_program_set* programs, const mrw_gles3_program* program, uint32_t first, uint32_t count) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Skinner>(skinner) && leads_to<gles3::ProgramSet>(programs) && leads_to<gles3::Program>(program), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::draw(of<gles3::Api>(api), of<gles3::Skinner>(skinner), of<gles3::ProgramSet>(programs), of<gles3::Program>(program), first, count));
}

void mrw_gles3_programs_on_context_lost(mrw_gles3_program_set* programs) {
  MRW_NEEDS(leads_to<gles3::ProgramSet>(programs), );
  marrow::gles3::on_context_lost(to<gles3::ProgramSet>(programs));
}

void mrw_gles3_skinner_on_context_lost(mrw_gles3_skinner* skinner) {
  MRW_NEEDS(leads_to<gles3::Skinner>(skinner), );
  marrow::gles3::on_context_lost(to<gles3::Skinner>(skinner));
}

mrw_status mrw_gles3_programs_on_context_restored(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    mrw_gles3_program_set* programs) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Caps>(caps) && leads_to<gles3::ProgramSet>(programs), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::on_context_restored(of<gles3::Api>(api), of<gles3::Caps>(caps), to<gles3::ProgramSet>(programs)));
}

mrw_status mrw_gles3_skinner_on_context_restored(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    mrw_gles3_skinner* skinner) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Caps>(caps) && leads_to<gles3::Skinner>(skinner), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::on_context_restored(of<gles3::Api>(api), of<gles3::Caps>(caps), to<gles3::Skinner>(skinner)));
}

mrw_status mrw_gles3_plan_crowd(const mrw_gles3_crowd_source* sources, size_t source_count, float rate_hz,
    mrw_gles3_crowd_clip* out, size_t out_count, uint32_t* frame_count) {
  MRW_NEEDS(is_list<gles3::CrowdSource>(sources, source_count) && is_list<gles3::CrowdClip>(out, out_count) && leads_to<std::uint32_t>(frame_count), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::plan_crowd(span<const gles3::CrowdSource>(sources, source_count), rate_hz, span<gles3::CrowdClip>(out, out_count), *frame_count));
}

mrw_status mrw_gles3_bake_crowd(const mrw_skeleton* skeleton, const mrw_gles3_crowd_source* sources,
    size_t source_count, const mrw_gles3_crowd_clip* clips, size_t clip_count, mrw_soa_transform* scratch,
    size_t scratch_count, mrw_affine* matrices, size_t matrice_count, mrw_gles3_crowd_frames* out) {
  MRW_NEEDS(leads_to<Skeleton>(skeleton) && is_list<gles3::CrowdSource>(sources, source_count) && is_list<gles3::CrowdClip>(clips, clip_count) && is_list<SoaTransform>(scratch, scratch_count) && is_list<Affine>(matrices, matrice_count) && leads_to<gles3::CrowdFrames>(out), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::bake_crowd(of<Skeleton>(skeleton), span<const gles3::CrowdSource>(sources, source_count), span<const gles3::CrowdClip>(clips, clip_count), span<SoaTransform>(scratch, scratch_count), span<Affine>(matrices, matrice_count), to<gles3::CrowdFrames>(out)));
}

mrw_status mrw_gles3_crowd_joint(const mrw_gles3_crowd_frames* frames, const mrw_gles3_crowd_instance* instance,
    double time_s, uint32_t joint, mrw_affine* model_from_joint) {
  MRW_NEEDS(leads_to<gles3::CrowdFrames>(frames) && leads_to<gles3::CrowdInstance>(instance) && leads_to<Affine>(model_from_joint), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::crowd_joint(of<gles3::CrowdFrames>(frames), of<gles3::CrowdInstance>(instance), time_s, joint, to<Affine>(model_from_joint)));
}

size_t mrw_gles3_crowd_mesh_bytes(const mrw_mesh* mesh, const mrw_gles3_crowd_mesh_options* options) {
  MRW_NEEDS(leads_to<Mesh>(mesh) && leads_to_if_any<gles3::CrowdMeshOptions>(options), 0);
  return marrow::gles3::crowd_mesh_bytes(of<Mesh>(mesh), or_default<gles3::CrowdMeshOptions>(options));
}

mrw_status mrw_gles3_create_crowd_mesh(const mrw_gles3_api* api, const mrw_gles3_caps* caps, const mrw_mesh* mesh,
    const mrw_gles3_crowd_mesh_options* options, const mrw_gles3_crowd_frames* frames, uint32_t capacity, void* memory,
    size_t memory_bytes, mrw_gles3_crowd_mesh* out, bool motion) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Caps>(caps) && leads_to<Mesh>(mesh) && leads_to_if_any<gles3::CrowdMeshOptions>(options) && leads_to<gles3::CrowdFrames>(frames) && is_list<std::byte>(memory, memory_bytes) && leads_to<gles3::CrowdMesh>(out), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::create_crowd_mesh(of<gles3::Api>(api), of<gles3::Caps>(caps), of<Mesh>(mesh), or_default<gles3::CrowdMeshOptions>(options), of<gles3::CrowdFrames>(frames), capacity, span<std::byte>(memory, memory_bytes), to<gles3::CrowdMesh>(out), motion));
}

void mrw_gles3_destroy_crowd_mesh(const mrw_gles3_api* api, mrw_gles3_crowd_mesh* mesh) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::CrowdMesh>(mesh), );
  marrow::gles3::destroy(of<gles3::Api>(api), to<gles3::CrowdMesh>(mesh));
}

mrw_status mrw_gles3_create_crowd(const mrw_gles3_api* api, const mrw_gles3_caps* caps, uint32_t capacity, void* memory,
    size_t memory_bytes, mrw_gles3_crowd* out) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Caps>(caps) && is_list<std::byte>(memory, memory_bytes) && leads_to<gles3::Crowd>(out), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::create_crowd(of<gles3::Api>(api), of<gles3::Caps>(caps), capacity, span<std::byte>(memory, memory_bytes), to<gles3::Crowd>(out)));
}

void mrw_gles3_destroy_crowd(const mrw_gles3_api* api, mrw_gles3_crowd* crowd) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Crowd>(crowd), );
  marrow::gles3::destroy(of<gles3::Api>(api), to<gles3::Crowd>(crowd));
}

mrw_status mrw_gles3_set_instances(const mrw_gles3_api* api, mrw_gles3_crowd* crowd,
    const mrw_gles3_crowd_frames* frames, uint32_t first, const mrw_gles3_crowd_instance* instances,
    size_t instance_count) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Crowd>(crowd) && leads_to<gles3::CrowdFrames>(frames) && is_list<gles3::CrowdInstance>(instances, instance_count), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::set_instances(of<gles3::Api>(api), to<gles3::Crowd>(crowd), of<gles3::CrowdFrames>(frames), first, span<const gles3::CrowdInstance>(instances, instance_count)));
}

mrw_status mrw_gles3_create_crowd_programs(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    const mrw_gles3_crowd_mesh* mesh, mrw_gles3_deformer deformer, uint8_t features, mrw_gles3_program_set* programs) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Caps>(caps) && leads_to<gles3::CrowdMesh>(mesh) && leads_to<gles3::ProgramSet>(programs), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::create_crowd_programs(of<gles3::Api>(api), of<gles3::Caps>(caps), of<gles3::CrowdMesh>(mesh), static_cast<gles3::Deformer>(deformer), features, to<gles3::ProgramSet>(programs)));
}

const mrw_gles3_program* mrw_gles3_crowd_program_of(const mrw_gles3_crowd_mesh* mesh, mrw_gles3_deformer deformer,
    uint8_t features, const mrw_gles3_program_set* programs, uint32_t role) {
  MRW_NEEDS(leads_to<gles3::CrowdMesh>(mesh) && leads_to<gles3::ProgramSet>(programs), nullptr);
  return to_c<const mrw_gles3_program>(&marrow::gles3::crowd_program_of(of<gles3::CrowdMesh>(mesh), static_cast<gles3::Deformer>(deformer), features, of<gles3::ProgramSet>(programs), role));
}

const mrw_gles3_program* mrw_gles3_blending_program_of(const mrw_gles3_program_set* programs) {
  MRW_NEEDS(leads_to<gles3::ProgramSet>(programs), nullptr);
  return to_c<const mrw_gles3_program>(&marrow::gles3::blending_program_of(of<gles3::ProgramSet>(programs)));
}

void mrw_gles3_begin_crowd_frame(mrw_gles3_crowd_mesh* mesh) {
  MRW_NEEDS(leads_to<gles3::CrowdMesh>(mesh), );
  marrow::gles3::begin_frame(to<gles3::CrowdMesh>(mesh));
}

mrw_status mrw_gles3_blend_previous_crowd(const mrw_gles3_api* api, const mrw_gles3_crowd* crowd,
    const mrw_gles3_crowd_mesh* mesh, uint32_t first, uint32_t count, double time_s, uint32_t texture_unit,
    const mrw_gles3_program* program) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Crowd>(crowd) && leads_to<gles3::CrowdMesh>(mesh) && leads_to<gles3::Program>(program), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::blend_previous_crowd(of<gles3::Api>(api), of<gles3::Crowd>(crowd), of<gles3::CrowdMesh>(mesh), first, count, time_s, texture_unit, of<gles3::Program>(program)));
}

mrw_status mrw_gles3_blend_crowd(const mrw_gles3_api* api, const mrw_gles3_crowd* crowd,
    const mrw_gles3_crowd_mesh* mesh, uint32_t first, uint32_t count, double time_s, uint32_t texture_unit,
    const mrw_gles3_program* program) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Crowd>(crowd) && leads_to<gles3::CrowdMesh>(mesh) && leads_to<gles3::Program>(program), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::blend_crowd(of<gles3::Api>(api), of<gles3::Crowd>(crowd), of<gles3::CrowdMesh>(mesh), first, count, time_s, texture_unit, of<gles3::Program>(program)));
}

mrw_status mrw_gles3_bind_crowd(const mrw_gles3_api* api, const mrw_gles3_crowd* crowd,
    const mrw_gles3_crowd_mesh* mesh, uint32_t first, uint32_t count, uint32_t texture_unit,
    const mrw_gles3_program* program) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Crowd>(crowd) && leads_to<gles3::CrowdMesh>(mesh) && leads_to<gles3::Program>(program), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::bind_crowd(of<gles3::Api>(api), of<gles3::Crowd>(crowd), of<gles3::CrowdMesh>(mesh), first, count, texture_unit, of<gles3::Program>(program)));
}

mrw_status mrw_gles3_draw_crowd(const mrw_gles3_api* api, const mrw_gles3_crowd_mesh* mesh, mrw_gles3_deformer deformer,
    const mrw_gles3_program* program, uint32_t instances) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::CrowdMesh>(mesh) && leads_to<gles3::Program>(program), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::draw(of<gles3::Api>(api), of<gles3::CrowdMesh>(mesh), static_cast<gles3::Deformer>(deformer), of<gles3::Program>(program), instances));
}

void mrw_gles3_crowd_mesh_on_context_lost(mrw_gles3_crowd_mesh* mesh) {
  MRW_NEEDS(leads_to<gles3::CrowdMesh>(mesh), );
  marrow::gles3::on_context_lost(to<gles3::CrowdMesh>(mesh));
}

void mrw_gles3_crowd_on_context_lost(mrw_gles3_crowd* crowd) {
  MRW_NEEDS(leads_to<gles3::Crowd>(crowd), );
  marrow::gles3::on_context_lost(to<gles3::Crowd>(crowd));
}

mrw_status mrw_gles3_crowd_mesh_on_context_restored(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    mrw_gles3_crowd_mesh* mesh) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Caps>(caps) && leads_to<gles3::CrowdMesh>(mesh), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::on_context_restored(of<gles3::Api>(api), of<gles3::Caps>(caps), to<gles3::CrowdMesh>(mesh)));
}

mrw_status mrw_gles3_crowd_on_context_restored(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    mrw_gles3_crowd* crowd) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Caps>(caps) && leads_to<gles3::Crowd>(crowd), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::on_context_restored(of<gles3::Api>(api), of<gles3::Caps>(caps), to<gles3::Crowd>(crowd)));
}

const char* mrw_gles3_verdict_text(mrw_gles3_verdict verdict) {
  return marrow::gles3::to_string(static_cast<gles3::Verdict>(verdict));
}

size_t mrw_gles3_self_test_bytes(const mrw_gles3_self_test_options* options) {
  MRW_NEEDS(leads_to<gles3::SelfTestOptions>(options), 0);
  return marrow::gles3::self_test_bytes(of<gles3::SelfTestOptions>(options));
}

mrw_status mrw_gles3_run_self_test(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    const mrw_gles3_self_test_options* options, void* memory, size_t memory_bytes, mrw_gles3_self_test* out) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Caps>(caps) && leads_to<gles3::SelfTestOptions>(options) && is_list<std::byte>(memory, memory_bytes) && leads_to<gles3::SelfTest>(out), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::self_test(of<gles3::Api>(api), of<gles3::Caps>(caps), of<gles3::SelfTestOptions>(options), span<std::byte>(memory, memory_bytes), to<gles3::SelfTest>(out)));
}

mrw_status mrw_gles3_choose(const mrw_gles3_self_test* test, const mrw_gles3_path_need* need,
    mrw_gles3_skinning_path* out) {
  MRW_NEEDS(leads_to<gles3::SelfTest>(test) && leads_to<gles3::PathNeed>(need) && leads_to<gles3::SkinningPath>(out), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::choose(of<gles3::SelfTest>(test), of<gles3::PathNeed>(need), to<gles3::SkinningPath>(out)));
}

mrw_status mrw_gles3_save(const mrw_gles3_self_test* test, void* out, size_t out_bytes) {
  MRW_NEEDS(leads_to<gles3::SelfTest>(test) && is_list<std::byte>(out, out_bytes), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::save(of<gles3::SelfTest>(test), span<std::byte>(out, out_bytes)));
}

mrw_status mrw_gles3_restore(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    const mrw_gles3_self_test_options* options, const void* saved, size_t saved_bytes, mrw_gles3_self_test* out) {
  MRW_NEEDS(leads_to<gles3::Api>(api) && is_ready(of<gles3::Api>(api)) && leads_to<gles3::Caps>(caps) && leads_to<gles3::SelfTestOptions>(options) && is_list<std::byte>(saved, saved_bytes) && leads_to<gles3::SelfTest>(out), MRW_BAD_ARGUMENT);
  return code(marrow::gles3::restore(of<gles3::Api>(api), of<gles3::Caps>(caps), of<gles3::SelfTestOptions>(options), span<const std::byte>(saved, saved_bytes), to<gles3::SelfTest>(out)));
}

}  // extern "C"
