# Tests of the cooker and of the program; included where the tools are built.
# Tests of the tools wait for what they call: to optimise them saves nothing. What most of them include is read once.
add_library(marrow_tools_test_headers OBJECT support/headers.cpp)
target_link_libraries(marrow_tools_test_headers PUBLIC marrow_test_support fmt::fmt nlohmann_json::nlohmann_json)
target_compile_options(marrow_tools_test_headers PRIVATE -O0)
marrow_warnings(marrow_tools_test_headers)
target_precompile_headers(marrow_tools_test_headers PRIVATE <gtest/gtest.h> <nlohmann/json.hpp> <fmt/format.h> <algorithm>
  <array> <cmath> <filesystem> <fstream> <functional> <map> <memory> <optional> <set> <span> <sstream> <string>
  <unordered_map> <vector>)
function(marrow_tools_test name label)
  marrow_test_binary(${name} ${label} ${ARGN})
  target_link_libraries(${name} PRIVATE fmt::fmt nlohmann_json::nlohmann_json)  # as for the headers, or GCC takes none
  target_compile_options(${name} PRIVATE -O0)
  target_precompile_headers(${name} REUSE_FROM marrow_tools_test_headers)
endfunction()
# Names of their own that another test's file has as well.
set_source_files_properties(unit/deform/elastic_test.cpp road/channels_test.cpp road/characters_test.cpp
  road/codec_test.cpp road/export_test.cpp road/outfits_test.cpp
  road/stated_errors_test.cpp
  road/scenes/made_scene.cpp road/scenes/random_scene.cpp road/scenes/scene_measure.cpp road/scenes/scenes_test.cpp
  PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
marrow_tools_test(marrow_input_tests input
  unit/cook/clip/bvh_read_test.cpp unit/cook/gltf/chosen_scene_test.cpp unit/cook/gltf/clips_test.cpp
  unit/cook/gltf/draco_test.cpp unit/cook/gltf/files_test.cpp unit/cook/gltf/geometry_test.cpp
  unit/cook/gltf/meshopt_test.cpp unit/cook/gltf/meshopt_vertices_test.cpp unit/cook/gltf/refusals_test.cpp
  unit/cook/gltf/rules_test.cpp unit/cook/gltf/scene_test.cpp unit/cook/gltf/vrm_settings_test.cpp
  unit/options/settings_schema_test.cpp unit/options/settings_test.cpp unit/options/shape_settings_test.cpp
  unit/unpack/draco_bounds_test.cpp unit/unpack/memory_patterns_test.cpp
  unit/unpack/steps_test.cpp unit/unpack/tools_cap_test.cpp)
# Without the cooker, so that what runs under sanitizers each time compiles soon.
target_link_libraries(marrow_input_tests PRIVATE marrow_disk marrow_goldens nlohmann_json::nlohmann_json
  draco::draco meshoptimizer::meshoptimizer)

marrow_tools_test(marrow_cook_tests cook
  unit/cook/gltf/looks_test.cpp unit/cook/gltf/morphs_test.cpp unit/cook/gltf/vrm_test.cpp unit/cook/mesh/codec_test.cpp
  golden/golden_cook_test.cpp unit/cook/clip/additive_test.cpp unit/cook/clip/bounds_packer_test.cpp
  unit/cook/clip/channels_test.cpp unit/cook/clip/clip_measure_test.cpp unit/cook/clip/export_keys_test.cpp unit/cook/clip/clip_packer_test.cpp unit/cook/clip/clips_test.cpp unit/cook/clip/tiny_numbers_test.cpp unit/cook/clip/list_packer_test.cpp
  unit/cook/emptied_lists_test.cpp unit/cook/library_test.cpp
  unit/cook/keep_test.cpp unit/cook/learn/deformers_test.cpp
  unit/cook/learn/eigen_targets_test.cpp unit/cook/learn/examples_test.cpp unit/cook/learn/learn_deformers_test.cpp
  unit/cook/learn/kept_fit_test.cpp unit/cook/learn/learn_test.cpp unit/cook/learn/look_better_test.cpp unit/cook/learn/single_joints_test.cpp unit/cook/mesh/hung_test.cpp unit/cook/mesh/lod_test.cpp
  unit/cook/mesh/merge_runs_test.cpp unit/cook/mesh/residual_apart_test.cpp unit/cook/mesh/shapes_test.cpp
  unit/cook/mesh/skin_apart_test.cpp unit/cook/mesh/split_test.cpp unit/cook/mesh/subdivide_mesh_test.cpp
  unit/cook/mesh/subdivide_test.cpp unit/cook/prepare/add_skeleton_test.cpp unit/cook/prepare/bind_weights_test.cpp
  unit/cook/prepare/limits_test.cpp unit/cook/prepare/mirrors_test.cpp
  unit/cook/prepare/outfits_rules_test.cpp unit/cook/prepare/packs_test.cpp
  unit/cook/prepare/paint_file_test.cpp unit/cook/prepare/skeletons_test.cpp
  unit/cook/prepare/weights_over_time_test.cpp unit/cook/roles/role_bodies_test.cpp unit/cook/roles/role_models_test.cpp
  unit/cook/motion/contacts_test.cpp unit/cook/motion/event_text_test.cpp unit/cook/motion/root_track_test.cpp
  unit/cook/roles/role_names_test.cpp)
# Two halves side by side, as it takes as long as most other tests together. To cook twice, and the newt with a fit, takes
# minutes under a sanitizer, which sees the same code in all the others.
add_test(NAME cook.1 COMMAND marrow_cook_tests)
set_tests_properties(cook.1 PROPERTIES LABELS cook TIMEOUT 1200)
if(MARROW_SANITIZE)
  set(not_twice "GTEST_FILTER=-*.*SameBytesEveryTime:Learn.LeavesSsdAlone:CookSubdivide.SoItIsPacked")
endif()
set_tests_properties(cook PROPERTIES ENVIRONMENT "${not_twice};GTEST_TOTAL_SHARDS=2;GTEST_SHARD_INDEX=0")
set_tests_properties(cook.1 PROPERTIES ENVIRONMENT "${not_twice};GTEST_TOTAL_SHARDS=2;GTEST_SHARD_INDEX=1")
marrow_begin_first(cook cook.1)
target_link_libraries(marrow_cook_tests PRIVATE marrow_goldens)
target_link_libraries(marrow_cook_tests PRIVATE marrow_cook_on_disk marrow_options marrow_export marrow_pose marrow_sample draco::draco
  meshoptimizer::meshoptimizer)

# Clips of one rig on others.
marrow_tools_test(marrow_retarget_tests retarget
  unit/cook/retarget/add_clips_test.cpp unit/cook/retarget/mirror_clips_test.cpp unit/cook/retarget/retarget_feet_test.cpp
  unit/cook/retarget/make_pose_map_test.cpp unit/cook/retarget/retarget_map_test.cpp
  unit/cook/retarget/retarget_models_test.cpp
  unit/cook/retarget/retarget_pose_test.cpp
  unit/cook/retarget/retarget_test.cpp)
target_link_libraries(marrow_retarget_tests PRIVATE marrow_cook_on_disk marrow_options)

# Graphs of behaviour, and animators.
marrow_tools_test(marrow_graph_tests graph
  unit/graph/animator_test.cpp unit/graph/behaviours_acts_test.cpp unit/graph/behaviours_test.cpp unit/graph/graph_mistakes_test.cpp unit/graph/graph_morphs_test.cpp unit/graph/graph_text_test.cpp unit/graph/oracle.cpp unit/graph/oracle_cases_test.cpp unit/graph/oracle_machine.cpp unit/graph/oracle_motion.cpp
  unit/graph/oracle_pose.cpp unit/graph/oracle_random.cpp unit/graph/oracle_read.cpp unit/graph/oracle_test.cpp)
target_link_libraries(marrow_graph_tests PRIVATE marrow_cook_on_disk tomlplusplus::tomlplusplus nlohmann_json::nlohmann_json)
# It plays minutes.
set_source_files_properties(unit/graph/oracle.cpp unit/graph/oracle_machine.cpp unit/graph/oracle_motion.cpp
  unit/graph/oracle_pose.cpp PROPERTIES COMPILE_OPTIONS -O2 SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)

# Characters that behave by them, as commands have them, and the sample in the demo.
marrow_tools_test(marrow_behave_tests behave unit/behave/behaviour_test.cpp unit/behave/script_test.cpp
  unit/story/story_test.cpp)
target_link_libraries(marrow_behave_tests PRIVATE marrow_behave_on_disk marrow_cook_on_disk marrow_story)

# Options, settings, shared threads, the same bytes everywhere: what cooking many files leans on.
marrow_tools_test(marrow_workflow_tests workflow
  unit/common/elementary_test.cpp unit/common/heap_test.cpp unit/common/parallel_test.cpp unit/cook/growth_test.cpp unit/cook/workflow_test.cpp unit/terminal/progress_test.cpp
  unit/terminal/warnings_test.cpp unit/text/nearest_test.cpp unit/text/quantity_test.cpp)
target_link_libraries(marrow_workflow_tests PRIVATE marrow_jobs marrow_sample)
if(MARROW_SANITIZE)
  set_tests_properties(workflow PROPERTIES ENVIRONMENT "GTEST_FILTER=-SameBytes.*")
endif()

# What `marrow bench` runs; the command itself is tested with the program.
marrow_tools_test(marrow_bench_tests bench unit/bench/vertices_test.cpp unit/bench/workload_test.cpp)
target_link_libraries(marrow_bench_tests PRIVATE marrow_bench marrow_pose)

# Offline deformers and fits, against the papers' own properties.
marrow_tools_test(marrow_deform_tests deform
  unit/deform/animation_space_test.cpp unit/deform/auto_skeleton_test.cpp unit/deform/auto_weights_test.cpp
  unit/deform/before_ssd_test.cpp unit/deform/between_frames_test.cpp unit/deform/deformers_test.cpp
  unit/deform/eigen_skin_test.cpp unit/deform/elastic_test.cpp unit/deform/example_weights_test.cpp
  unit/deform/folds_test.cpp unit/deform/fit_test.cpp
  unit/deform/helpers_test.cpp unit/deform/multi_weight_test.cpp unit/deform/never_worse_test.cpp
  unit/deform/painted_weights_test.cpp unit/deform/pose_metric_test.cpp unit/deform/pose_space_test.cpp
  unit/deform/range_of_motion_test.cpp unit/deform/scaled_joints_test.cpp unit/deform/simplify_test.cpp
  unit/deform/subdivide_test.cpp unit/deform/tangents_test.cpp)
# compare's own reckoning stands beside what it judges.
if(MARROW_ALL_COMMANDS)
  target_sources(marrow_deform_tests PRIVATE unit/compare/thesis_test.cpp unit/compare/verdict_test.cpp)
  target_link_libraries(marrow_deform_tests PRIVATE marrow_compare)
  # A table to tune deformers by; no test, built when asked for.
  add_executable(marrow_folds_table EXCLUDE_FROM_ALL folds/folds_table.cpp)
  target_link_libraries(marrow_folds_table PRIVATE marrow_compare marrow_options)
  marrow_warnings(marrow_folds_table)
endif()
target_link_libraries(marrow_deform_tests PRIVATE marrow_deform)

# The reference evaluator, written from the glTF specification; it shares nothing with the cooker.
add_library(marrow_reference STATIC road/source.cpp road/reference.cpp)
target_include_directories(marrow_reference PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(marrow_reference PUBLIC nlohmann_json::nlohmann_json PRIVATE draco::draco)
target_compile_options(marrow_reference PRIVATE ${MARROW_NUMERIC_FLAGS})
marrow_warnings(marrow_reference)

marrow_tools_test(marrow_road_tests road
  road/bounds_test.cpp road/channels_test.cpp road/characters_test.cpp road/clip_test.cpp road/codec_test.cpp
  road/cooked.cpp road/export_test.cpp road/feet_test.cpp road/outfits_test.cpp road/reference_test.cpp
  road/road_test.cpp road/sample_test.cpp road/scenes/made_scene.cpp road/scenes/random_scene.cpp
  road/scenes/scene_measure.cpp road/scenes/scenes_test.cpp road/split_test.cpp road/stated_errors_test.cpp)
target_link_libraries(marrow_road_tests PRIVATE marrow_reference marrow_cook_on_disk marrow_export marrow_pose)

marrow_tools_test(marrow_cli_tests cli
  cli/bad_input_test.cpp cli/bench_test.cpp cli/between_test.cpp cli/compare_test.cpp cli/corpus_test.cpp
  cli/export_test.cpp cli/graph_test.cpp cli/info_test.cpp cli/kinds_test.cpp cli/names_test.cpp cli/outfit_test.cpp
  cli/parameters_test.cpp cli/progress_test.cpp cli/road_test.cpp cli/sample_test.cpp cli/wrong_graph_test.cpp
  cli/cook/atomic_test.cpp cli/cook/batch_test.cpp cli/cook/bvh_test.cpp cli/cook/cache_test.cpp
  cli/cook/clip_pack_test.cpp cli/cook/depfile_test.cpp cli/cook/report_test.cpp cli/cook/rig_maps_test.cpp
  cli/cook/same_bytes_test.cpp cli/cook/same_names_test.cpp cli/cook/schema_test.cpp cli/cook/settings_test.cpp
  cli/cook/shard_test.cpp cli/cook/split_test.cpp cli/cook/watch_test.cpp
  cli/pictures/demo_test.cpp cli/pictures/film_test.cpp cli/pictures/looks_test.cpp cli/pictures/movie_test.cpp
  cli/pictures/view_graph_test.cpp cli/pictures/view_test.cpp
  cli/support/cookings.cpp cli/support/process.cpp)
target_link_libraries(marrow_cli_tests PRIVATE marrow_reference nlohmann_json::nlohmann_json PNG::PNG)
# Drivers leak, which the address sanitizer would report; pictures are then left to the tests under gl/.
if(MARROW_GLES AND NOT MARROW_SANITIZE)
  target_compile_definitions(marrow_cli_tests PRIVATE MARROW_HAS_GLES)
  if(TARGET marrow_view)
    add_library(marrow_reset_shim MODULE cli/support/reset_shim.cpp)
    target_link_libraries(marrow_reset_shim PRIVATE ${CMAKE_DL_LIBS})
    marrow_warnings(marrow_reset_shim)
    add_library(marrow_hand_shim MODULE cli/support/hand_shim.cpp)
    target_link_libraries(marrow_hand_shim PRIVATE ${CMAKE_DL_LIBS})
    marrow_warnings(marrow_hand_shim)
    add_dependencies(marrow_cli_tests marrow_reset_shim marrow_hand_shim)
    target_compile_definitions(marrow_cli_tests PRIVATE MARROW_HAS_VIEW)
  endif()
endif()
# What `marrow view` reckons beside its window.
if(MARROW_GLES AND TARGET marrow_view)
  marrow_tools_test(marrow_view_tests view unit/view/painting_test.cpp unit/view/paint_test.cpp unit/view/rehearsal_test.cpp
    unit/view/view_test.cpp)
  target_link_libraries(marrow_view_tests PRIVATE marrow_view)
endif()
# It takes the place of malloc, as sanitizers do.
if(NOT MARROW_SANITIZE)
  add_library(marrow_fault_shim MODULE cli/support/fault_shim.cpp)
  target_link_libraries(marrow_fault_shim PRIVATE ${CMAKE_DL_LIBS})
  marrow_warnings(marrow_fault_shim)
  add_dependencies(marrow_cli_tests marrow_fault_shim)
  target_sources(marrow_cli_tests PRIVATE cli/faults_test.cpp)
  # It calls what it stands for: no compiler may know what that gives.
  add_library(marrow_last_bit_shim MODULE cli/support/last_bit_shim.cpp)
  target_link_libraries(marrow_last_bit_shim PRIVATE ${CMAKE_DL_LIBS})
  target_compile_options(marrow_last_bit_shim PRIVATE -fno-builtin)
  marrow_warnings(marrow_last_bit_shim)
  add_dependencies(marrow_cli_tests marrow_last_bit_shim)
  target_sources(marrow_cli_tests PRIVATE cli/cook/last_bit_test.cpp)
endif()
# Nothing that a cooked file's bytes come through calls functions whose last bits differ between C libraries.
set(cookers marrow_common marrow_cook marrow_jobs marrow_deform marrow_draco marrow_gltf marrow_meshopt marrow_options
  marrow_runtime marrow_terminal marrow_text marrow_unpack)
list(TRANSFORM cookers REPLACE "(.+)" "$<TARGET_FILE:\\1>")
add_test(NAME cook.own_functions COMMAND ${CMAKE_COMMAND} -DNM=${CMAKE_NM} "-DLIBRARIES=${cookers}"
  -DOTHER=$<TARGET_FILE:marrow_export> -P ${CMAKE_CURRENT_SOURCE_DIR}/cli/own_functions.cmake)
set_tests_properties(cook.own_functions PROPERTIES LABELS cook)
# Nor are products fused, which shows on other processors alone.
foreach(library common cook deform draco gltf meshopt runtime text unpack)
  get_target_property(flags marrow_${library} COMPILE_OPTIONS)
  if(NOT flags MATCHES "-ffp-contract=off")
    message(FATAL_ERROR "marrow_${library} is compiled without -ffp-contract=off: its bits differ between processors")
  endif()
endforeach()
# Under sanitizers without what cooks the same again, or times it.
if(MARROW_SANITIZE)
  set_tests_properties(cli PROPERTIES ENVIRONMENT "GTEST_FILTER=-SameBytes.*:CliCache.WhatCounts:CliCache.Counts*:CliCache.StaysBelowItsSize:Bench.Hashes*:Bench.SamplesEveryClip*:Bench.Unpacks*:ProgressTest.AnInterruptedCookLeavesTheOldFiles")
endif()


add_dependencies(marrow_cli_tests marrow)
marrow_begin_first(cli road)

marrow_fuzz(gltf 10000 golden/*.gltf marrow_gltf)
marrow_fuzz(bvh 10000 fuzz/seeds/*.bvh marrow_gltf)
marrow_fuzz(unpack 10000 fuzz/seeds/*.mrw marrow::draco marrow::meshopt)
marrow_fuzz(vertices 10000 fuzz/seeds/*.vertices marrow_gltf)
marrow_fuzz(settings 10000 fuzz/seeds/*.toml marrow_disk)
add_dependencies(marrow_hostile marrow_gltf_fuzz marrow_bvh_fuzz marrow_unpack_fuzz marrow_vertices_fuzz marrow_settings_fuzz marrow_input_tests)
set_property(TEST input APPEND PROPERTY LABELS hostile)

marrow_together(marrow_input_tests marrow_cook_tests marrow_cli_tests marrow_workflow_tests marrow_road_tests marrow_deform_tests
  marrow_bench_tests marrow_reference)

# The programs that documents show, as a game would build them.
function(marrow_example name)
  add_executable(marrow_example_${name} examples/${name}.cpp)
  target_link_libraries(marrow_example_${name} PRIVATE ${ARGN})
  marrow_warnings(marrow_example_${name})
endfunction()
marrow_example(play marrow::runtime)
marrow_example(crowd marrow::runtime)
marrow_example(hero marrow::runtime)
marrow_example(behave marrow::runtime)
marrow_example(cook_in_memory marrow::cook)
marrow_c_program(marrow_example_play_c examples/play.c)
target_link_libraries(marrow_example_play_c PRIVATE marrow::c marrow::draco)
find_package(Threads REQUIRED)
marrow_example(jobs marrow::draco marrow::meshopt Threads::Threads)
set(example_draw "")
if(MARROW_GLES AND NOT MARROW_SANITIZE)
  marrow_example(draw marrow::gles3 marrow::egl)
  target_include_directories(marrow_example_draw SYSTEM PRIVATE ${MARROW_GLES_INCLUDE})
  set(example_draw $<TARGET_FILE:marrow_example_draw>)
  find_library(MARROW_GLES_LIBRARY GLESv2 REQUIRED)
  marrow_c_program(marrow_example_draw_c examples/draw.c)
  target_link_libraries(marrow_example_draw_c PRIVATE marrow::c_gles3 ${MARROW_EGL_LIBRARY} ${MARROW_GLES_LIBRARY})
  target_include_directories(marrow_example_draw_c SYSTEM PRIVATE ${MARROW_EGL_INCLUDE} ${MARROW_GLES_INCLUDE})
  set(example_draw_c $<TARGET_FILE:marrow_example_draw_c>)
endif()
add_test(NAME examples COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DMARROW=$<TARGET_FILE:marrow>
  -DPLAY=$<TARGET_FILE:marrow_example_play> -DPLAY_C=$<TARGET_FILE:marrow_example_play_c> -DCROWD=$<TARGET_FILE:marrow_example_crowd> -DHERO=$<TARGET_FILE:marrow_example_hero>
  -DBEHAVE=$<TARGET_FILE:marrow_example_behave> -DASSETS=${PROJECT_SOURCE_DIR}/../shared/assets -DJOBS=$<TARGET_FILE:marrow_example_jobs>
  -DCOOK_IN_MEMORY=$<TARGET_FILE:marrow_example_cook_in_memory>
  -DDRAW=${example_draw} -DDRAW_C=${example_draw_c}
  -DFOLDER=${CMAKE_CURRENT_BINARY_DIR} -P ${CMAKE_CURRENT_SOURCE_DIR}/road/examples.cmake)
set_tests_properties(examples PROPERTIES LABELS cli ENVIRONMENT "MESA_GLES_VERSION_OVERRIDE=3.0")
include(examples/guides.cmake)

# The programs of docs/stages: every file of the folder, run with the sample and held to what is known of it.
file(GLOB stages CONFIGURE_DEPENDS examples/stages/*.cpp)
foreach(source ${stages})
  get_filename_component(stage ${source} NAME_WE)
  add_executable(marrow_stage_${stage} ${source})
  target_link_libraries(marrow_stage_${stage} PRIVATE marrow::draco)
  target_compile_options(marrow_stage_${stage} PRIVATE ${MARROW_TEST_OPTIMISATION})
  set_target_properties(marrow_stage_${stage} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/stages)
  marrow_warnings(marrow_stage_${stage})
endforeach()
# What checks the manual, on small pages that are made for it; what chooses the kits that run.
if(MARROW_PYTHON AND NOT MARROW_SANITIZE)
  add_test(NAME docs COMMAND ${MARROW_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/docs/checks_test.py)
  add_test(NAME kits COMMAND ${MARROW_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/docs/kits_test.py)
  set_tests_properties(docs kits PROPERTIES LABELS docs)
endif()
if(MARROW_PYTHON AND NOT MARROW_SANITIZE)  # under which cooking takes minutes
  add_test(NAME stages COMMAND ${MARROW_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/examples/stages/check.py $<TARGET_FILE:marrow>
    ${CMAKE_CURRENT_BINARY_DIR}/stages ${CMAKE_CURRENT_BINARY_DIR}/stages/work)
  set_tests_properties(stages PROPERTIES LABELS cli)
endif()

# What others make of exports: the Khronos validator, and three.js in a headless browser beside the source. Skipped, which
# ctest says aloud, where npm cannot be had.
if(NOT MARROW_SANITIZE)
  add_test(NAME export.validator COMMAND ${PROJECT_SOURCE_DIR}/tools/check/export.sh $<TARGET_FILE:marrow>)
  add_test(NAME export.three COMMAND ${PROJECT_SOURCE_DIR}/tools/check/three.sh $<TARGET_FILE:marrow>)
  set_tests_properties(export.validator export.three PROPERTIES LABELS cli SKIP_RETURN_CODE 3 TIMEOUT 1800)
  set_property(TEST export.three APPEND PROPERTY LABELS long)
endif()
