# Tests of the cooker and of the program; included where the tools are built.
set(cook_sources golden/golden_cook_test.cpp)
foreach(source unit/cook/gltf_test.cpp unit/sample_test.cpp)
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${source})
    list(APPEND cook_sources ${source})
  endif()
endforeach()
marrow_test(marrow_cook_tests cook ${cook_sources})
target_link_libraries(marrow_cook_tests PRIVATE marrow_cook)
target_compile_definitions(marrow_cook_tests PRIVATE MARROW_SOURCE_DIR="${PROJECT_SOURCE_DIR}")

# The reference evaluator, written from the glTF specification; it shares nothing with the cooker.
add_library(marrow_reference STATIC road/source.cpp road/reference.cpp)
target_include_directories(marrow_reference PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(marrow_reference PUBLIC nlohmann_json::nlohmann_json PRIVATE draco::draco)
marrow_warnings(marrow_reference)

marrow_test(marrow_road_tests road road/road_test.cpp road/reference_test.cpp road/cooked.cpp)
target_link_libraries(marrow_road_tests PRIVATE marrow_reference marrow_cook)
target_compile_definitions(marrow_road_tests PRIVATE MARROW_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
  MARROW_DEFAULT_ASSETS="${PROJECT_SOURCE_DIR}/../shared/assets")

marrow_test(marrow_cli_tests cli cli/process.cpp cli/road_test.cpp cli/bad_input_test.cpp cli/report_test.cpp)
target_link_libraries(marrow_cli_tests PRIVATE marrow_reference nlohmann_json::nlohmann_json)
target_compile_definitions(marrow_cli_tests PRIVATE MARROW_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
  MARROW_PROGRAM="$<TARGET_FILE:marrow>")
add_dependencies(marrow_cli_tests marrow)
